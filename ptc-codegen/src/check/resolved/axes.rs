//! The eps of several axes: the largest that one of them requires.

use num_traits::ToPrimitive;

use super::Resolved;
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Feedback, Spec};

pub(super) fn resolve(spec: &Spec, expanded: Option<&Expanded>) -> Resolved {
    let mut resolved = Resolved::open(spec);
    if !spec.leaves_eps() {
        return resolved;
    }
    let each = alone(spec).into_iter().map(|design| {
        let forms = expanded.filter(|_| design.n == spec.n);
        Resolved::expanded(&design, forms)
    });
    let chosen = each.filter_map(|mut own| {
        let eps = own.spec.fixed.remove(&Parameter::Eps)?;
        let choice = own.choices.into_iter().find(|choice| choice.key == Parameter::Eps.key())?;
        Some((eps, choice.reason))
    });
    let size = |eps: &Fixed| eps.number().and_then(ToPrimitive::to_f64).unwrap_or(0.0);
    let several = spec.designs().len() > 1;
    if let Some((eps, reason)) = chosen.max_by(|a, b| size(&a.0).total_cmp(&size(&b.0))) {
        let of = if several { "the largest that one of the chains needs: " } else { "" };
        resolved.choose_eps((eps, format!("{of}{reason}")));
    }
    resolved
}

/// The designs of the axes as each is judged by itself: of one output alone a law of all outputs means nothing.
pub(in crate::check) fn alone(spec: &Spec) -> Vec<Spec> {
    let of_all = spec.axes.as_ref().is_some_and(|axes| !axes.laws.is_empty());
    let one = |design: Spec| match of_all {
        true => Spec { feedback: Feedback::Extern, ..design },
        false => design,
    };
    spec.designs().into_iter().map(one).collect()
}
