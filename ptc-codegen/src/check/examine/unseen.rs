//! Gaps of a report, for its last line, and inputs that look like a slip of units.

use num_traits::ToPrimitive;

use super::Report;
use crate::algebra::BigRational;
use crate::check::{Outcome, Verdict, sampled, zeros};
use crate::diagnostic::digits;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Samples from which on a report asks whether tau is in seconds.
const MANY_SAMPLES: i64 = 100_000;

/// Samples of delay below which it asks whether that is in samples.
const SHORT_DELAY: f64 = 0.01;

/// The subject of each check, for a reader who does not know its name.
const SUBJECTS: [(&str, &str); 7] = [
    ("membership", "the class of the mapping"),
    ("growth", "x and u at the deadline"),
    ("sampling", "the sample period"),
    ("deadline", "the error at eps"),
    (sampled::NAME, "the sampled loop"),
    ("envelope", "overflow"),
    (zeros::NAME, "zero dynamics"),
];

impl Report {
    /// Lists the subjects that no check has examined, because a value is missing or the check does not support the
    /// design.
    pub fn unseen(&self) -> Vec<String> {
        let left_out = |outcome: &&Outcome| outcome.verdict == Verdict::NotChecked;
        let subject = |outcome: &Outcome| {
            let found = SUBJECTS.iter().find(|(name, _)| *name == outcome.name);
            found.map_or_else(
                || outcome.name.to_owned(),
                |(name, subject)| format!("{subject} ({name})"),
            )
        };
        let mut all: Vec<_> = self.outcomes.iter().filter(left_out).map(subject).collect();
        let of_loop = self.outcomes.iter().find(|outcome| outcome.name == sampled::NAME);
        if of_loop.is_some_and(Outcome::is_checked) {
            let promises = &self.spec.promises;
            let keeps = self.spec.keep().is_some();
            if !keeps && promises.noise.is_empty() && promises.sensor_step.is_empty() {
                all.push("noise".to_owned());
            }
            if self.spec.has_open_limit() && self.spec.axes.is_none() {
                all.push("a limit of u".to_owned());
            }
        }
        all
    }
}

/// Times that are legal and look as if they were meant in another unit.
pub(super) fn slips(spec: &Spec) -> Vec<String> {
    let number = |value: Option<&Fixed>| value.and_then(Fixed::number).cloned();
    let h = number(spec.promises.sample_time.as_ref());
    let about = |value: &BigRational| digits(value.to_f64().unwrap_or(f64::NAN));
    let mut all = Vec::new();
    if let Some((tau, h)) = number(spec.fixed.get(&Parameter::Tau)).zip(h.as_ref()) {
        let count = &tau / h;
        if count >= BigRational::from_integer(MANY_SAMPLES.into()) {
            let (tau, h, count) = (about(&tau), about(h), about(&count));
            all.push(format!("tau = {tau} s is {count} samples of {h} s: is tau in s?"));
        }
    }
    let delay = spec.promises.delay.as_ref().map(|delay| delay.samples());
    if let Some(delay) = delay.filter(|delay| *delay > 0.0 && *delay < SHORT_DELAY) {
        let time = h.and_then(|h| h.to_f64()).map(|h| format!(", {} s", digits(delay * h)));
        let time = time.unwrap_or_default();
        all.push(format!("delay = {}{time}: delay is in samples, not in s", digits(delay)));
    }
    all
}
