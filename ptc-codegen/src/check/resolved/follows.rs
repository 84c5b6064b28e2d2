//! Consequences of a resolved design: the gains of its poles, and where gains are held.

use num_traits::{ToPrimitive, Zero};

use super::Choice;
use crate::algebra::{BigRational, integer};
use crate::diagnostic::{counted, digits};
use crate::model::Arm;
use crate::parameter::{Fixed, Parameter};
use crate::request::{DelayLaw, Lasting, Observer, Spec, Stationary};
use crate::samples::{self, Ending, Terminal, held_samples};
use crate::syntax::constant;

/// The key of the samples to go from which on another law takes over.
const END: &str = "end_samples";

/// Values that no key of the design gives and no check chooses: other keys determine them.
pub fn follows(spec: &Spec) -> Vec<Choice> {
    let mut all: Vec<_> = gains(spec).into_iter().collect();
    if !spec.has_law() {
        return all;
    }
    all.extend(efforts(spec));
    all.extend(spec.arm().into_iter().flat_map(friction));
    all.extend(delay_law(spec));
    all.extend(end(spec));
    all.extend(observer(spec));
    all
}

/// A number of a fixed parameter; `None` where it is left to run time.
fn number(spec: &Spec, parameter: Parameter) -> Option<&BigRational> {
    spec.fixed.get(&parameter).and_then(Fixed::number)
}

/// The limits of the joints of a robot that are those of its file.
fn efforts(spec: &Spec) -> Option<Choice> {
    let efforts = spec.arm()?.efforts()?;
    let limits = spec.axes.as_ref()?.limits.iter().map(Fixed::number);
    if !limits.eq(efforts.iter().map(Some)) {
        return None;
    }
    let all: Vec<_> = efforts.iter().map(constant::text).collect();
    let (value, reason) = (format!("[{}]", all.join(", ")), "the efforts of the URDF".to_owned());
    Some(Choice { key: "limits", value, reason })
}

/// Damping and friction of the joints of a robot that are those of its file.
fn friction(arm: &Arm) -> impl Iterator<Item = Choice> {
    let reason = "<dynamics> of the URDF";
    let of_file = arm.source.of_file(&arm.robot);
    of_file.map(|(part, value)| Choice { key: part.key(), value, reason: reason.to_owned() })
}

/// The law of a delay, which the number of poles decides.
fn delay_law(spec: &Spec) -> Option<Choice> {
    let sampled = spec.sampled().filter(|own| own.leaves_delay_law && own.delay.inputs() > 0)?;
    let reason = match sampled.delay_law {
        DelayLaw::Predict => {
            let what = if spec.schedule().is_some() { "gains" } else { "poles" };
            format!("the {what} are those of the plant; its state is predicted over the delay")
        }
        DelayLaw::Extend => {
            "the loop has a pole, or a gain, for each sample of delay too".to_owned()
        }
    };
    let value = sampled.delay_law.name().to_owned();
    Some(Choice { key: "delay_law", value, reason })
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

/// Returns the end of the law, where no single key of the design gives it.
fn end(spec: &Spec) -> Option<Choice> {
    spec.sampled()?;
    let left = held_samples(spec)?;
    let choice =
        |key, value: String, reason: &str| Some(Choice { key, value, reason: reason.to_owned() });
    let designs = spec.designs();
    let endings = designs.iter().map(Ending::of).collect::<Option<Vec<_>>>()?;
    let held = "the gains are held from eps on";
    match endings.first()?.terminal {
        Terminal::Deadbeat(_) if !left.is_zero() => {
            let end = samples::end_of_law(designs.iter().map(Spec::loop_order).max()?);
            let key = Parameter::Deadbeat.key();
            if left > end {
                return choice(key, "not used".to_owned(), held);
            }
            let reason = format!("{held}, and below so few samples to go the law does not exist");
            choice(key, constant::text(&end), &reason)
        }
        Terminal::LeastEnergy(end) if designs.len() == 1 => {
            let is_reached = left <= integer(end.samples.into());
            if is_reached { None } else { choice(END, "not used".to_owned(), held) }
        }
        _ if designs.len() > 1 && spec.sampled()?.end.is_none() => ends_of_outputs(&endings),
        _ => None,
    }
}

/// Returns the samples to go at which the law of each output becomes one of least energy, 0 where it is one.
fn ends_of_outputs(endings: &[Ending]) -> Option<Choice> {
    let samples = endings.iter().map(|ending| match ending.terminal {
        Terminal::Itself => Some(0),
        Terminal::LeastEnergy(end) => Some(end.samples),
        Terminal::Deadbeat(_) => None,
    });
    let samples = samples.collect::<Option<Vec<_>>>()?;
    if samples.iter().all(|samples| *samples == 0) {
        return None;
    }
    let all: Vec<_> = samples.iter().map(ToString::to_string).collect();
    let reason = "samples to go of each output below which its law changes its sign; one of least energy takes its place".to_owned();
    Some(Choice { key: END, value: format!("[{}]", all.join(", ")), reason })
}

/// The gains of a stationary observer.
fn stationary(own: &Stationary) -> Choice {
    let shown = |gain: &BigRational| digits(gain.to_f64().unwrap_or(f64::NAN));
    let row = |row: &Vec<BigRational>| row.iter().map(shown).collect::<Vec<_>>().join(", ");
    let rows: Vec<_> = own.gains.iter().map(row).collect();
    let reason =
        "those of the stationary Kalman filter for the noise and disturbance_walk".to_owned();
    Choice { key: "observer_gains", value: format!("[{}]", rows.join("; ")), reason }
}

/// Returns the samples to go from which the gains of an observer without its own eps stay.
fn observer(spec: &Spec) -> Option<Choice> {
    let observer: &Observer = spec.sampled()?.observer.as_ref()?;
    let round = match (&observer.lasting, &observer.round) {
        (Lasting::Stationary(own), _) => return Some(stationary(own)),
        (Lasting::Held, Some(round)) if round.eps.is_none() => round,
        _ => return None,
    };
    let key = "observer_eps";
    if !samples::is_noisy(spec) {
        let reason = "the measurement is exact, and the observer ends in deadbeat";
        return Some(Choice { key, value: "not used".to_owned(), reason: reason.to_owned() });
    }
    let held = samples::observer_held(round, round.samples?);
    let count = counted(&constant::text(&held), "sample");
    let reason = format!(
        "with an inexact measurement the observer's gains of {count} to go stay, once its round of {} is over",
        counted(&round.samples?, "sample")
    );
    let value = match number(spec, Parameter::SampleTime) {
        Some(h) => constant::text(&(held * h)),
        None => count,
    };
    Some(Choice { key, value: format!("{value} after its round"), reason })
}
