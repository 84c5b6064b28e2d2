//! The trajectory of a scenario, as a table and as CSV.

use super::{Campaign, Instant, Scenario, Trial};
use crate::request::Spec;
use crate::simulate;

/// A run, and the words of its scenario.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// The scenario.
    pub scenario: Scenario,
    /// The words of the scenario, with which it can be run again.
    pub told: String,
    /// Its instants.
    pub instants: Vec<Instant>,
    /// Why it is not whole, if it is not.
    pub ended: Option<String>,
}

/// Rows of the worst trajectory that are shown.
const SHOWN: usize = 8;

pub(super) fn trajectory(
    campaign: &Campaign,
    trial: &mut Trial,
    scenario: &Scenario,
) -> (Vec<Instant>, Option<simulate::Failure>) {
    let mut instants = Vec::new();
    let ended = trial.instants(&campaign.closely(scenario), &mut |instant| instants.push(instant));
    // How far it came is what is to be seen.
    (instants, ended.err())
}

/// A few instants, one of them the worst.
pub fn shown(instants: &[Instant]) -> Vec<(&Instant, bool)> {
    let excess =
        |instant: &Instant| instant.excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let worst = (0..instants.len())
        .reduce(|a, b| if excess(&instants[b]) > excess(&instants[a]) { b } else { a });
    let last = instants.len().saturating_sub(1);
    let even = |i: usize| (0..SHOWN).any(|row| row * last / (SHOWN - 1) == i);
    let all = instants.iter().enumerate().map(|(i, instant)| (i, instant, worst == Some(i)));
    let shown = all.filter(|(i, _, worst)| *worst || even(*i));
    shown.map(|(_, instant, worst)| (instant, worst)).collect()
}

pub(super) fn table(spec: &Spec, instants: &[Instant]) -> String {
    let mut text = format!("  {:>11}", "t");
    columns(spec).for_each(|head| text.push_str(&format!(" {head:>12}")));
    text.push('\n');
    for (instant, worst) in shown(instants) {
        text.push_str(&format!("  {:>11.6}", instant.t));
        instant.numbers().for_each(|number| text.push_str(&format!(" {number:>12.4e}")));
        text.push_str(if worst { "  <- worst\n" } else { "\n" });
    }
    text
}

/// Returns the names of [`Instant::numbers`]: states, inputs and tracking errors.
pub fn columns(spec: &Spec) -> impl Iterator<Item = String> {
    spec.state_names().into_iter().chain(spec.input_names()).chain(errors(spec))
}

/// The names of the tracking errors, where there is a reference.
fn errors(spec: &Spec) -> impl Iterator<Item = String> {
    let count = spec.errors().len();
    spec.names_of_chains().into_iter().take(count).map(|name| format!("e{name}"))
}

/// A trajectory as CSV, and why it is not whole, if it is not.
pub fn csv(
    campaign: &Campaign,
    trial: &mut Trial,
    scenario: &Scenario,
) -> (String, Option<simulate::Failure>) {
    let columns: String = columns(&campaign.spec).map(|name| format!(",{name}")).collect();
    let excess: String = (1..=campaign.objectives.len()).map(|i| format!(",excess{i}")).collect();
    let integrals: String =
        (1..=campaign.integrals.len()).map(|k| format!(",integral{k}")).collect();
    let mut text = format!("t,time_to_go{columns}{integrals}{excess}\n");
    let (instants, ended) = trajectory(campaign, trial, scenario);
    for instant in instants {
        text.push_str(&format!("{:?},{:?}", instant.t, instant.time_to_go));
        let numbers = instant.numbers().chain(&instant.integrals).chain(&instant.excess);
        numbers.for_each(|number| text.push_str(&format!(",{number:?}")));
        text.push('\n');
    }
    (text, ended)
}
