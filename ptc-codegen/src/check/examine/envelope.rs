//! The check `envelope`: what the program of the law reaches within the bounds of x.

use super::divisor;
use super::known::is_known;
use crate::check::Outcome;
use crate::check::envelope::{Computed, outward, scan};
use crate::expansion::Expanded;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, number, passes};
use crate::request::{Feedback, Spec, What};

/// Name of the check.
pub(super) const NAME: &str = "envelope";

/// Pieces of time-to-go in which the envelope is scanned: some 20 a decade.
const PIECES: f64 = 20.0;

pub(super) fn outcome(spec: &Spec, expanded: Option<&Expanded>) -> Outcome {
    let lacks = |reason: String| Outcome::not_checked(NAME, reason);
    if spec.promises.x_max.is_empty() {
        return lacks("`x_max` is not given".to_owned());
    }
    if spec.what == What::Associated {
        return lacks("the infinite-time system has no deadline".to_owned());
    }
    if spec.reference.is_some() {
        return lacks("it does not examine a reference".to_owned());
    }
    if spec.feedback == Feedback::Extern {
        return lacks("the law is user-defined, and its range is unknown".to_owned());
    }
    if let Some(refuted) = divisor::zero(spec) {
        return refuted;
    }
    let open = |p: &Parameter| {
        !matches!(p, Parameter::UMax | Parameter::StartTime)
            && !is_known(spec, *p)
            && !spec.bounds.contains_key(p)
    };
    if let Some(open) = spec.parameters().into_iter().find(open) {
        return lacks(format!("`{}` is left to run time without bounds", open.spelling()));
    }
    let law = Law::from(spec, expanded);
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    let round = |value: &Fixed| {
        value.number().map_or(f64::INFINITY, |value| number::round(value, spec.precision))
    };
    let parameter = |p: Parameter| match (spec.fixed.get(&p), spec.bounds.get(&p)) {
        (Some(value), _) if p != Parameter::UMax => Computed::point(round(value)),
        (_, Some((least, greatest))) => Computed::new(round(least), round(greatest)),
        _ => Computed::point(0.0),
    };
    let around = |bounds: &[Fixed], j: usize| {
        bounds.get(j - 1).map(|bound| Computed::new(-round(bound), round(bound)))
    };
    let promises = &spec.promises;
    let start_is_known =
        is_known(spec, Parameter::StartTime) || spec.bounds.contains_key(&Parameter::StartTime);
    let input = |input: Input| match input {
        Input::Parameter(p) => parameter(p),
        Input::Time if start_is_known => {
            let (start, tau) = (parameter(Parameter::StartTime), parameter(Parameter::Tau));
            outward(
                start.range.low(),
                (start.range.high() + tau.range.high()).next_up(),
                spec.precision,
            )
        }
        Input::StartTime => parameter(Parameter::StartTime),
        Input::State(j) => around(&promises.x_max, j).unwrap_or(Computed::ANY),
        Input::StateAtStart(j) => around(&promises.x0_max, j)
            .or_else(|| around(&promises.x_max, j))
            .unwrap_or(Computed::ANY),
        Input::Time
        | Input::Reference(_)
        | Input::ReferenceOf(..)
        | Input::Gain(_)
        | Input::Divisor
        | Input::Drift
        | Input::Control
        | Input::Wanted(_) => Computed::ANY,
    };
    let (eps, tau) =
        (parameter(Parameter::Eps).range.low(), parameter(Parameter::Tau).range.high());
    let pieces = (PIECES * (tau / eps).log10()).clamp(1.0, 400.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    Outcome::from(&scan(&program, &input, eps, tau, pieces.ceil() as u32))
}
