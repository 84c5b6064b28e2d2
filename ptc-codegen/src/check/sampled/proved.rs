//! The worst case as a theorem: a bound that no allowed run exceeds.

use super::cells::Worst;
use super::judge::Loop;
use super::outcome::{clipping, closed as closed_gate};
use super::sums::Sum;
use crate::parameter::{Fixed, Parameter};
use crate::request::{PlantBounds, Spec};

/// The worst case of a loop in which u is not clipped and all that disturbs it is bounded, from a box of states
/// around a `middle`; on the way that of sums too.
///
/// # Errors
/// Returns the missing input, or why the bounds do not hold for every run.
pub(crate) fn proved(spec: &Spec, middle: &[f64], sums: &[Sum]) -> Result<Worst, String> {
    if !spec.fixed.contains_key(&Parameter::Eps) && spec.sampled().is_none() {
        return Err("`eps` is left to run time".to_owned());
    }
    if spec.reference.is_some() {
        return Err(
            "the law follows a reference, and the proof is of one that brings x to 0".to_owned()
        );
    }
    let number = |value: &Fixed| value.number().is_some_and(|value| *value != Default::default());
    if spec.promises.noise_rms.iter().any(number) {
        return Err("the random noise of `noise_rms` has no bound".to_owned());
    }
    if spec.promises.resonance.is_some() {
        let why = "the plant has a resonance, and the proof is of the plant without it";
        return Err(why.to_owned());
    }
    if let Some(PlantBounds::Unknown(why)) = &spec.promises.plant {
        return Err(why.clone());
    }
    let closed = Loop::new(spec, None)?.around(middle).with_sums(sums);
    let worst = closed.worst(true)?;
    match clipping(spec, &worst, &closed) {
        (Some(why), true) => Err(format!("u may be clipped: {why}")),
        _ => match closed_gate(spec, &worst) {
            Some(closed) => Err(closed.why),
            None => Ok(worst),
        },
    }
}
