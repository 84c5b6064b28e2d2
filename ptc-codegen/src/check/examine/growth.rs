//! The check `growth`: what the gains do at the deadline with the decay rate of the mapping.

use super::known::{Decay, Rate, decay, fixed_gains, rounded_down};
use crate::check::Outcome;
use crate::check::growth::{self, Growth, Modes, growth, growth_between};
use crate::diagnostic::digits_down;
use crate::family::Family;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Feedback, Spec};

/// The greatest rate of a mapping with which the gains of every axis pass, where the rate is left to run time: `init`
/// refuses more.
#[cfg(feature = "simulate")]
pub(crate) fn greatest(spec: &Spec) -> Option<(Parameter, Fixed)> {
    spec.run_time_parameters().find(|open| *open == Parameter::A)?;
    let of_each = spec.designs().into_iter().filter_map(|design| check_growth(&design).1);
    of_each.min_by_key(|(_, value)| value.number().cloned())
}

/// Legal values of a parameter in words, with the greatest rate.
#[cfg(feature = "simulate")]
pub(crate) fn legal(spec: &Spec, parameter: Parameter) -> String {
    let legal = spec.legal(parameter);
    match greatest(spec).filter(|(own, _)| *own == parameter) {
        Some((_, most)) => format!("{legal}, and at most {most} by the check `growth`"),
        None => legal,
    }
}

/// Checks the gains at the deadline; where the rate is left to run time, also returns the greatest rate with which they
/// pass.
pub(super) fn check_growth(spec: &Spec) -> (Outcome, Option<(Parameter, Fixed)>) {
    let lacks = |reason: &str| (Outcome::not_checked(growth::NAME, reason), None);
    if spec.feedback != Feedback::Linear {
        return lacks("the law is not a sum of gains, so its poles are not known");
    }
    let Some(gains) = fixed_gains(spec) else {
        return lacks("the gains are left to run time: their poles must lie left of -n rho");
    };
    // A pole that fails for the slowest mapping fails for every one.
    let at_rest = growth(&gains, &crate::algebra::integer(0), Modes::Other);
    let Decay { rate, modes } = decay(spec);
    let known = matches!(rate, Rate::Exact(_) | Rate::Between(..));
    if !known && !at_rest.x_to_zero {
        return (Outcome::from(&at_rest), None);
    }
    let told = |growth: Growth| {
        let rate = if spec.custom().is_some() { "a decay rate" } else { growth.rate };
        (Outcome::from(&Growth { rate, ..growth }), None)
    };
    match rate {
        Rate::Exact(rate) => told(growth(&gains, &rate, modes)),
        Rate::Between(low, high, spelling) => match growth_between(&gains, [&low, &high], modes) {
            Some(found) => told(Growth { spelling, ..found }),
            None => {
                let rho = spelling.map_or_else(
                    || "the parameters".to_owned(),
                    |spelling| format!("rho = {spelling}"),
                );
                (growth::open(&rho), None)
            }
        },
        Rate::Infinite => (growth::too_fast(spec.n), None),
        Rate::NotFound => (growth::without_rate(at_rest.largest_rho), None),
        Rate::Open => {
            let Some(limit) = at_rest.largest_rho else {
                return lacks("the rate is left to run time, and none is slow enough");
            };
            let text = digits_down(limit);
            let share = match spec.family() {
                Some(Family::Exp | Family::Soft) => Some(1.0),
                Some(Family::Tanh) => Some(0.5),
                _ => None,
            };
            let allowed = spec.promises.allow.iter().any(|name| name == growth::NAME);
            let greatest = share.and_then(|share| rounded_down(share * limit)).filter(|_| !allowed);
            let by = if greatest.is_some() { "; init refuses more" } else { "" };
            let (outcome, _) = lacks(&format!(
                "the rate is left to run time: x and u go to 0 where mu' decays at a rate of at most {text}{by}"
            ));
            (outcome, greatest.map(|greatest| (Parameter::A, greatest)))
        }
    }
}
