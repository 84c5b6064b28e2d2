//! Consequences of a resolved design: the gains of its poles, and where gains are held.

use num_traits::Zero;

use super::Choice;
use crate::algebra::BigRational;
use crate::diagnostic::counted;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Observer, Spec, What};
use crate::samples;
use crate::syntax::constant;

/// Values that no key of the design gives and no check chooses: other keys determine them.
pub fn follows(spec: &Spec) -> Vec<Choice> {
    let mut all: Vec<_> = gains(spec).into_iter().collect();
    if spec.what == What::Observer {
        return all;
    }
    all.extend(deadbeat(spec));
    all.extend(observer(spec));
    all
}

/// A number of a fixed parameter; `None` where it is left to run time.
fn number(spec: &Spec, parameter: Parameter) -> Option<&BigRational> {
    spec.fixed.get(&parameter).and_then(Fixed::number)
}

/// The gains of the poles, of each output where there are several.
fn gains(spec: &Spec) -> Option<Choice> {
    let designs = spec.designs();
    let row = |design: &Spec| {
        let gain = |i| number(design, Parameter::Gain(i)).map(constant::text);
        let all = (1..=design.loop_order()).map(gain).collect::<Option<Vec<_>>>()?;
        (!design.poles.is_empty()).then(|| format!("[{}]", all.join(", ")))
    };
    let rows = designs.iter().map(row).collect::<Option<Vec<_>>>()?;
    let value = match rows.as_slice() {
        [one] => one.clone(),
        several => format!("[{}]", several.join(", ")),
    };
    Some(Choice { key: "gains", value, reason: "those of the poles".to_owned() })
}

/// Returns the effective `deadbeat`, where the design has no single value of it.
fn deadbeat(spec: &Spec) -> Option<Choice> {
    spec.sampled()?;
    let eps = number(spec, Parameter::Eps)?;
    let choice = |value: String, reason: &str| {
        Some(Choice { key: Parameter::Deadbeat.key(), value, reason: reason.to_owned() })
    };
    if !eps.is_zero() {
        let end = samples::end_of_law(spec.designs().iter().map(Spec::loop_order).max()?);
        let reason = "the gains are held from eps on";
        return match eps / number(spec, Parameter::SampleTime)? > end {
            true => choice("not used".to_owned(), reason),
            false => {
                let reason =
                    format!("{reason}, and below so few samples to go the law does not exist");
                choice(constant::text(&end), &reason)
            }
        };
    }
    if spec.axes.is_none() || spec.fixed.contains_key(&Parameter::Deadbeat) {
        return None;
    }
    let lengths = spec.designs().iter().map(samples::deadbeat).collect::<Option<Vec<_>>>()?;
    let lengths: Vec<_> = lengths.iter().map(ToString::to_string).collect();
    choice(format!("[{}]", lengths.join(", ")), "samples to go, of each output, from its poles")
}

/// Returns the samples to go from which the gains of an observer without its own eps stay.
fn observer(spec: &Spec) -> Option<Choice> {
    let observer: &Observer = spec.sampled()?.observer.as_ref()?;
    if observer.eps.is_some() || !observer.after.is_empty() {
        return None;
    }
    let key = "observer_eps";
    if !samples::is_noisy(spec) {
        let reason = "the measurement is exact, and the observer ends in deadbeat";
        return Some(Choice { key, value: "not used".to_owned(), reason: reason.to_owned() });
    }
    let held = samples::observer_held(observer, observer.samples?);
    let count = counted(&constant::text(&held), "sample");
    let reason = format!(
        "with an inexact measurement the observer's gains of {count} to go stay, once its round of {} is over",
        counted(&observer.samples?, "sample")
    );
    let value = match number(spec, Parameter::SampleTime) {
        Some(h) => constant::text(&(held * h)),
        None => count,
    };
    Some(Choice { key, value: format!("{value} after its round"), reason })
}
