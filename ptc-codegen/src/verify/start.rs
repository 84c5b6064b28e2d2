//! Impossible objectives, which no control changes: an objective that fails at t0, or from an x0 of its box with any
//! law.

use super::{Campaign, Kind, Scenario, Trial};
use crate::simulate::Failure;

/// An objective that is impossible at a point of the box.
#[derive(Clone, Debug)]
pub struct Impossible {
    /// Place of the objective.
    pub objective: usize,
    /// Scenario in which it is impossible.
    pub scenario: Scenario,
    /// True if it fails at t0 already; else it fails from x0 = 0, where |x0| allows nothing.
    pub at_start: bool,
}

/// Draws that are looked at, beside the corners.
const DRAWS: u64 = 1024;

/// Smallest move within a box, as a part of it.
const SMALLEST: f64 = 1.0 / 1024.0;

/// Refuses a campaign that no run can decide.
///
/// # Errors
/// A gain that has another sign than the law takes it to have, an objective that no control can keep, or
/// a parameter without a value.
pub fn possible(campaign: &Campaign, trial: &mut Trial) -> Result<(), Failure> {
    if let Some(scenario) = reversed(campaign)? {
        return Err(Failure::input(
            format!(
                "the gain of the plant is 0 or has another sign than g, at {}",
                campaign.text_of(&scenario)
            ),
            "Theorem 1 requires |b| < |g| of a gain that is not known: narrow its bounds under [plant]",
        ));
    }
    let Some(Impossible { objective, scenario, at_start }) = impossible(campaign, trial)? else {
        return Ok(());
    };
    let at = campaign.text_of(&scenario);
    let x = campaign.objectives[objective].letter;
    let which = format!("objective {}, {}", objective + 1, campaign.objectives[objective]);
    Err(match at_start {
        true => Failure::input(
            format!("{which}, fails at t0 already, at {at}"),
            "whatever the control does: widen the bound at dt = 0, or narrow the box of initial states under [verify]",
        ),
        false => Failure::input(
            format!("{which}, is impossible at {at}: |{x}0| is 0, and {x} does not stay there"),
            format!(
                "whatever the control does: keep {x}0 = 0 out of the box under [verify], or bound |{x}| by `within` and `attractive`"
            ),
        ),
    })
}

/// The scenarios that are looked at: corners, and draws.
fn looked_at(campaign: &Campaign) -> impl Iterator<Item = Scenario> {
    let draws = 0..campaign.scenarios.min(DRAWS);
    campaign.corners().into_iter().chain(draws.map(|index| campaign.scenario(index)))
}

/// An objective that is impossible, whatever the control does, if there is one.
///
/// # Errors
/// A parameter without a value.
pub fn impossible(campaign: &Campaign, trial: &mut Trial) -> Result<Option<Impossible>, Failure> {
    let mut worst = vec![None; campaign.objectives.len()];
    for scenario in looked_at(campaign) {
        let excess = trial.at_start(&campaign.setting(&scenario))?;
        for (worst, excess) in worst.iter_mut().zip(excess) {
            if worst.as_ref().is_none_or(|(_, most)| excess > *most) {
                *worst = Some((scenario.clone(), excess));
            }
        }
    }
    for (objective, worst) in worst.into_iter().enumerate() {
        let Some((scenario, excess)) = worst else { continue };
        if !campaign.objectives[objective].is_of_state(campaign.spec.states()) {
            continue;
        }
        let (scenario, excess) = climbed(campaign, trial, objective, (scenario, excess))?;
        if excess > 0.0 {
            return Ok(Some(Impossible { objective, scenario, at_start: true }));
        }
    }
    from_rest(campaign, trial)
}

/// Returns a scenario in which the gain of the plant is 0 or has another sign than the controller's g, if there is one:
/// no law of Theorem 1 does that. The states of a model are moved as it says.
///
/// # Errors
/// A parameter without a value.
pub fn reversed(campaign: &Campaign) -> Result<Option<Scenario>, Failure> {
    if campaign.spec.has_model() {
        return Ok(None);
    }
    let of_gain = Campaign { objectives: vec![campaign.gain()], ..campaign.clone() };
    let mut trial = Trial::new(&of_gain)?;
    for scenario in looked_at(campaign) {
        let excess = trial.at_start(&campaign.setting(&scenario))?;
        if excess.iter().any(|excess| *excess >= 0.0) {
            return Ok(Some(scenario));
        }
    }
    Ok(None)
}

/// The worst point at t0 near another, by a compass search.
fn climbed(
    campaign: &Campaign,
    trial: &mut Trial,
    objective: usize,
    (mut scenario, mut excess): (Scenario, f64),
) -> Result<(Scenario, f64), Failure> {
    let mut size = 0.5;
    while size >= SMALLEST && excess <= 0.0 {
        let mut best = None;
        for moved in campaign.moved(&scenario, size) {
            let value = trial.at_start(&campaign.setting(&moved))?[objective];
            if value > best.as_ref().map_or(excess, |(_, most)| *most) {
                best = Some((moved, value));
            }
        }
        match best {
            Some(better) => (scenario, excess) = better,
            None => size /= 2.0,
        }
    }
    Ok((scenario, excess))
}

/// A bound by |x0| where x0 = 0 is in the box, and x does not stay there.
fn from_rest(campaign: &Campaign, trial: &mut Trial) -> Result<Option<Impossible>, Failure> {
    let of_start = |kind: &Kind| matches!(kind, Kind::State { .. });
    let bounded = campaign.objectives.iter().position(|objective| of_start(&objective.kind));
    let Some(objective) = bounded else { return Ok(None) };
    let n = campaign.x0.len();
    let at_rest = |scenario: &Scenario| scenario.point[1..=n].iter().all(|x| *x == 0.0);
    for scenario in campaign.corners().into_iter().filter(at_rest) {
        let mut moved = false;
        // How the run ends is for the verdict: a start away from 0 may do better.
        let _ = trial.instants(&campaign.setting(&scenario), &mut |instant| {
            moved |= instant.excess[objective] == f64::INFINITY;
        });
        if moved {
            return Ok(Some(Impossible { objective, scenario, at_start: false }));
        }
    }
    Ok(None)
}
