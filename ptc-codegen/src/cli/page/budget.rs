//! Where the bounds of the sampled loop come from, as bars.

use ptc_codegen::check::examine::Report;
use ptc_codegen::check::sampled::{causes, curve};
use ptc_codegen::parameter::{Fixed, Parameter};

use super::curve::Chart;
use super::number::digits;
use super::svg::Svg;

/// Colours of causes, which the page defines.
const COLOURS: usize = 8;

/// The bound of a state at the deadline.
pub(super) struct Bar {
    pub(super) state: String,
    pub(super) bound: String,
    /// What the design wants, and where it is on the bar in percent.
    pub(super) error: Option<(String, String)>,
    pub(super) parts: Vec<Part>,
}

/// What one cause adds.
pub(super) struct Part {
    pub(super) cause: String,
    pub(super) value: String,
    /// Of the length of the bar.
    pub(super) percent: String,
    /// The class that gives it its colour.
    pub(super) colour: String,
}

/// The final error in parts of what is wanted, or of the largest state, and the peak of u over eps.
pub(super) fn charts(report: &Report) -> Vec<Svg> {
    let spec = &report.spec;
    if report.worst.is_none() {
        return Vec::new();
    }
    let choices = curve(spec, report.expanded.as_ref());
    let number = |value: &Fixed| value.number().and_then(num_traits::ToPrimitive::to_f64);
    let errors: Vec<_> = spec.promises.error.iter().filter_map(number).collect();
    let wanted = |i: usize| errors.get(if errors.len() == 1 { 0 } else { i }).copied();
    let share = |x: &[f64]| {
        x.iter().enumerate().map(|(i, x)| x / wanted(i).unwrap_or(1.0)).fold(0.0, f64::max)
    };
    let given = !errors.is_empty();
    let chosen = spec.fixed.get(&Parameter::Eps).and_then(number);
    let error = Chart {
        title: if given { "worst |x|/error" } else { "worst |x|" },
        points: choices.iter().map(|choice| (choice.eps, share(&choice.x))).collect(),
        chosen,
        limit: given.then_some(1.0),
    };
    let control = Chart {
        title: "peak |u|",
        points: choices.iter().map(|choice| (choice.eps, choice.u)).collect(),
        chosen,
        limit: spec.fixed.get(&Parameter::UMax).and_then(number),
    };
    [error, control].iter().filter_map(Chart::svg).collect()
}

/// One bar for each state, as long as the greater of its bound and of what is wanted; none where the
/// loop was not bounded.
pub(super) fn bars(report: &Report) -> Vec<Bar> {
    let Some(worst) = &report.worst else { return Vec::new() };
    let errors = &report.spec.promises.error;
    // The same cause has the same colour in each bar.
    let mut names: Vec<String> = Vec::new();
    let bars = worst.states.iter().enumerate().map(|(i, bound)| {
        let error = errors.get(if errors.len() == 1 { 0 } else { i });
        let wanted = error.and_then(Fixed::number).and_then(num_traits::ToPrimitive::to_f64);
        let length = bound.total().max(wanted.unwrap_or(0.0));
        let percent = |part: f64| format!("{:.3}", 100.0 * part / length);
        let part = |(cause, part): (String, f64)| {
            let place = names.iter().position(|name| *name == cause).unwrap_or_else(|| {
                names.push(cause.clone());
                names.len() - 1
            });
            let colour = format!("cause{}", place % COLOURS);
            Part { value: digits(part), percent: percent(part), colour, cause }
        };
        Bar {
            state: format!("|x{}|", i + 1),
            bound: digits(bound.total()),
            error: wanted.map(|wanted| (digits(wanted), percent(wanted))),
            parts: causes(&report.spec, bound).into_iter().map(part).collect(),
        }
    });
    bars.filter(|bar| bar.parts.iter().all(|part| part.percent.parse().is_ok_and(f64::is_finite)))
        .collect()
}
