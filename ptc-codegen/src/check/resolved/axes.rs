//! The eps of several axes: the largest that one of them requires and the loops of the others allow.

use num_traits::ToPrimitive;

use super::{Resolved, grade};
use crate::check::examine::lacking;
use crate::check::sampled;
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
    let mut chosen: Vec<_> = chosen.collect();
    chosen.sort_by(|a, b| size(&b.0).total_cmp(&size(&a.0)));
    chosen.dedup_by(|a, b| a.0.number() == b.0.number());
    let best = best(spec, &chosen, expanded);
    let of = match best {
        _ if spec.designs().len() == 1 => "",
        0 => "the largest that one of the chains needs: ",
        _ => {
            "of one of the chains; a larger one of another chain leaves more than `error` allows: "
        }
    };
    if let Some((eps, reason)) = chosen.into_iter().nth(best) {
        resolved.choose_eps((eps, format!("{of}{reason}")));
    }
    resolved
}

/// Returns the first eps with which the loops of all axes are judged best, where bounds of the error judge them.
fn best(spec: &Spec, chosen: &[(Fixed, String)], expanded: Option<&Expanded>) -> usize {
    let mut best = (u8::MAX, 0);
    if spec.promises.error.is_empty() || chosen.len() < 2 {
        return 0;
    }
    for (at, (eps, _)) in chosen.iter().enumerate() {
        let mut tried = spec.clone();
        tried.choose_eps(eps.clone());
        let each = alone(&tried).into_iter().map(|design| {
            let forms = expanded.filter(|_| design.n == spec.n);
            let looped = lacking(&design).is_none().then(|| sampled::outcome(&design, forms));
            looped.map_or(0, |looped| grade(&design, &looped))
        });
        best = best.min((each.max().unwrap_or(0), at));
        if best.0 == 0 {
            break;
        }
    }
    best.1
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
