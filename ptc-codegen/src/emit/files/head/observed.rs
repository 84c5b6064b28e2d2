//! Description of a stand-alone observer in the head of a file.

use super::{Language, samples};
use crate::internal::fault;
use crate::request::{Observer, Sampled, Spec};

/// The sample from which on the estimates of an observer alone are exact.
fn end(observer: &Observer) -> u32 {
    observer.samples().unwrap_or_else(|| fault("an observer alone without an end"))
}

/// Describes the goal of the estimates, and how it is reached.
pub(super) fn purpose(sampled: &Sampled, observer: &Observer) -> [String; 2] {
    let end = end(observer);
    let held = observer.round.as_ref().and_then(|round| round.eps.as_ref());
    let exact = match held {
        None => "exact up to rounding",
        Some(_) => "as near as the hold at observer_eps leaves them",
    };
    let values = if sampled.disturbance.is_some() { "the state and of d" } else { "the state" };
    let goal = format!(
        "Goal: the estimates of {values} are {exact} from sample {end} after the start on, from any state and at any sample period, as long as the measurement is exact, u is what was applied and nothing else acts on the plant."
    );
    let predicted = match &sampled.linear {
        Some(_) => {
            "Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1."
        }
        None => {
            "Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain sampled, Phi and Gamma: the estimates of tick k hold y up to tick k."
        }
    };
    let gains = "The gains follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end deadbeat takes over.";
    [goal, format!("{predicted} {gains}")]
}

pub(super) fn behaviour(
    spec: &Spec,
    given: &Sampled,
    observer: &Observer,
    language: Language,
) -> Vec<String> {
    let end = end(observer);
    let then = samples::then(observer);
    let delay = &given.delay;
    let acts = match delay.inputs() {
        0 => "it acted from tick k - 1 to tick k".to_owned(),
        _ if !delay.is_whole() => format!(
            "it acts from {delay} samples after tick k - 1 on for one sample, and the observer keeps those under way"
        ),
        1 => "it acts from tick k to tick k + 1, and the observer keeps it until then".to_owned(),
        d => format!(
            "it acts from tick k + {} to tick k + {d}, and the observer keeps those under way",
            d - 1
        ),
    };
    let mut lines = vec![
        String::new(),
        format!("k counts samples and may wrap; arm again within 2^32 - {end} samples."),
        format!("u is the input of tick k - 1 as it was applied, after clipping: {acts}."),
        format!("From sample {end} on the status is HOLD; {then}."),
    ];
    lines.extend(samples::gate(observer));
    let given = match observer.gate.coasts() {
        false => "what is measured and u are finite",
        true => "what is measured passes this gate, u is finite",
    };
    lines.push(samples::guard(spec, language, [given, "measurements and inputs"]));
    lines
}
