//! The check `envelope`: what the program of the law reaches within the bounds of x.

use super::known::is_known;
use super::{divisor, held};
use crate::check::envelope::{Computed, covered, outward, scan};
use crate::check::{Outcome, Verdict};
use crate::expansion::Expanded;
use crate::law::Law;
use crate::lower::{at_sample, lower};
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
        let unbounded = || lacks("`x_max` is not given".to_owned());
        return held::overflow(spec, expanded).unwrap_or_else(unbounded);
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
        *p != Parameter::StartTime
            && !p.is_limit()
            && !is_known(spec, *p)
            && !spec.bounds.contains_key(p)
    };
    if let Some(open) = spec.parameters().into_iter().find(open) {
        return lacks(format!("`{}` is left to run time without bounds", open.spelling()));
    }
    let law = Law::from(spec, expanded);
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    let (eps, tau) =
        (parameter(spec, Parameter::Eps).range.low(), parameter(spec, Parameter::Tau).range.high());
    let pieces = (PIECES * (tau / eps).log10()).clamp(1.0, 400.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    Outcome::from(&scan(&program, &|asked| input(spec, asked), eps, tau, pieces.ceil() as u32))
}

/// The same of a plant with several inputs in samples: whether they decouple its outputs. The values of the law
/// are not examined.
pub(super) fn in_samples(spec: &Spec) -> Outcome {
    let lacks = |reason: &str| Outcome::not_checked(NAME, reason);
    if spec.promises.x_max.is_empty() {
        return lacks("`x_max` is not given");
    }
    if let Some(refuted) = divisor::zero(spec) {
        return refuted;
    }
    let open = spec.parameters().into_iter().find(|p| {
        matches!(p, Parameter::Named(_)) && !is_known(spec, *p) && !spec.bounds.contains_key(p)
    });
    if let Some(open) = open {
        return lacks(&format!("`{}` is left to run time without bounds", open.spelling()));
    }
    let law = "the law in samples is not examined; ";
    let Err(open) = covered(&passes::optimise(at_sample(spec), &mut |_, _| {}), &|asked| {
        match asked {
            // Whether the inputs decouple the outputs does not depend on what is wanted of them.
            Input::Wanted(_) => Computed::new(-1.0, 1.0),
            asked => input(spec, asked),
        }
    }) else {
        return lacks(&format!("{law}within `x_max` it divides by no 0"));
    };
    Outcome {
        name: NAME,
        verdict: Verdict::Undecided,
        summary: format!("{law}within `x_max` {open}"),
        details: Vec::new(),
        fix: Some("narrow `x_max`, or bound the parameters under [params]".to_owned()),
    }
}

pub(super) fn round(spec: &Spec, value: &Fixed) -> f64 {
    value.number().map_or(f64::INFINITY, |value| number::round(value, spec.precision))
}

/// Returns the interval of a parameter; 0 if the law does not compute with it.
fn parameter(spec: &Spec, p: Parameter) -> Computed {
    match (spec.fixed.get(&p), spec.bounds.get(&p)) {
        (Some(value), _) if !p.is_limit() => Computed::point(round(spec, value)),
        (_, Some((least, greatest))) => Computed::new(round(spec, least), round(spec, greatest)),
        _ => Computed::point(0.0),
    }
}

/// Returns the interval of an input.
fn input(spec: &Spec, input: Input) -> Computed {
    let around = |bounds: &[Fixed], j: usize| {
        bounds.get(j - 1).map(|bound| Computed::new(-round(spec, bound), round(spec, bound)))
    };
    let promises = &spec.promises;
    let start_is_known =
        is_known(spec, Parameter::StartTime) || spec.bounds.contains_key(&Parameter::StartTime);
    match input {
        Input::Parameter(p) => parameter(spec, p),
        Input::Time if start_is_known => {
            let (start, tau) =
                (parameter(spec, Parameter::StartTime), parameter(spec, Parameter::Tau));
            outward(
                start.range.low(),
                (start.range.high() + tau.range.high()).next_up(),
                spec.precision,
            )
        }
        Input::StartTime => parameter(spec, Parameter::StartTime),
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
    }
}
