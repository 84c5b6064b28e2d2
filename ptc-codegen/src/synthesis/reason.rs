//! Why a value is chosen, in a line.

use super::candidate;
use super::choice::{Choice, Key, Value};

/// Returns why the value of a key is chosen.
pub(super) fn reason(key: Key, value: &Value) -> &'static str {
    let word = match value {
        Value::Word(word) => Some(word.as_str()),
        Value::Number(_) | Value::Poles(_) => None,
    };
    match (key, word) {
        (Key::Clock, _) => {
            "exact at the samples, so that the loop ends at rest whatever its period is"
        }
        (Key::Mu, word) => candidate::reason(word.unwrap_or_default()),
        (Key::Poles, Some(name)) if name.contains("weight") => {
            "the least energy of a u that ends softly"
        }
        (Key::Poles, Some(_)) => "the law of least energy",
        (Key::Poles, None) => {
            "left of -n rho, so that x and u go to 0 at the deadline; real and distinct, as a proof needs them"
        }
        (Key::PolesEnd, _) => "a stiffer law towards the end, which leaves less of a late force",
        (Key::EndSamples, _) => "samples to go from which on the stiffer law acts",
        (Key::DelayLaw, _) => "the inputs under way are states, so that u is smoother",
        (Key::Eps, _) if matches!(value, Value::Number(text) if text == "0") => {
            "the gains run to the deadline; a hold would leave a greater error"
        }
        (Key::Eps, _) => {
            "the gains are held from there on, as the sample period, the wanted error or the noise requires"
        }
        (Key::Observer, _) => "the gains of a Kalman filter from the first sample on",
        (Key::DisturbanceWalk, _) => {
            "drift of the force in a second that the Kalman filter assumes"
        }
        (Key::ObserverPoles, _) => "all estimates approach their states before the round ends",
        (Key::ObserverSamples, _) => "samples after which the estimates are exact",
        (Key::ObserverEps, _) => "limits what the noise of the sensor does to the estimates",
        (Key::AfterObserver, Some(_)) => {
            "the gains of a Kalman filter once the estimates are exact"
        }
        (Key::AfterObserver, None) => {
            "poles in 1/s once the estimates are exact: they follow a force that changes"
        }
    }
}

impl Choice {
    /// A line for each chosen value, with its reason.
    pub fn lines(&self) -> Vec<String> {
        let line = |(key, value): (Key, &Value)| {
            format!("chosen: {} = {value}: {}", key.name(), reason(key, value))
        };
        self.values().map(line).collect()
    }
}
