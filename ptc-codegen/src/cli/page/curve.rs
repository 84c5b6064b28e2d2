//! Effect of eps on the loop, as curves.

use crate::check::examine::Report;
use crate::check::sampled::curve;
use crate::parameter::{Fixed, Parameter};
use crate::plot::Curve;
use crate::request::one_or_each;
use num_traits::ToPrimitive;

use super::svg::Svg;
use crate::cli::report::Failure;

/// The final error in parts of what is wanted, or of the largest state, and the peak of u over eps;
/// none where the loop was not bounded.
pub(super) fn charts(report: &Report) -> Result<Vec<Svg>, Failure> {
    let spec = &report.spec;
    let choices = match report.worst {
        Some(_) => curve(spec, report.expanded.as_ref()),
        None => Vec::new(),
    };
    if choices.len() < 2 {
        return Ok(Vec::new());
    }
    let number = |p| spec.fixed.get(&p).and_then(Fixed::number).and_then(ToPrimitive::to_f64);
    let errors = &spec.promises.error;
    let share = |x: &[f64]| {
        let shares = x.iter().enumerate().map(|(i, x)| x / one_or_each(errors, i).unwrap_or(1.0));
        shares.fold(0.0, f64::max)
    };
    let over_eps = |title: &str, points, limit| {
        let (title, across) = (title.to_owned(), "eps in s".to_owned());
        let curve = Curve { title, across, points, chosen: number(Parameter::Eps), limit };
        curve.svg().try_into()
    };
    let given = !errors.is_empty();
    let title = if given { "worst |x|/error at the deadline" } else { "worst |x| at the deadline" };
    let finals = choices.iter().map(|choice| (choice.eps, share(&choice.x))).collect();
    let peaks = choices.iter().map(|choice| (choice.eps, choice.u)).collect();
    Ok(vec![
        over_eps(title, finals, given.then_some(1.0))?,
        over_eps("worst |u|", peaks, spec.radius(0).and_then(|limit| limit.to_f64()))?,
    ])
}
