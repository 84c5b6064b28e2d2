//! The verdicts on a campaign in words, and the worst trajectory.

mod distribution;
mod reasons;
mod text;

pub use text::End;

use super::bound::{self, Proof};
use super::search::{self, Found};
use super::trajectory::{Trajectory, trajectory};
use super::{Campaign, Comparison, Corners, Evidence, Kind, Tally, Trial, Verdict, Worst};
use crate::diagnostic::counted;
use crate::parameter::Precision;
use distribution::distribution;
use reasons::reasons;

/// All that is known in the end.
#[derive(Clone, Debug)]
pub struct Known<'a> {
    /// The draws.
    drawn: &'a Tally,
    corners: Corners,
    /// For each objective what the search found.
    found: Vec<Found>,
    /// For each objective its proof, or why there is none.
    proofs: Vec<Proof>,
}

impl<'a> Known<'a> {
    /// Runs the corners of a campaign whose draws are done, searches for what is worse and proves what
    /// can be proved. `told` of the runs as they are taken, [`Campaign::searched`] at most.
    pub fn beyond(
        campaign: &Campaign,
        trial: &Trial,
        drawn: &'a Tally,
        told: &(dyn Fn(usize) + Sync),
    ) -> Self {
        let corners = Corners::run(campaign, trial, &|| told(1));
        let proofs = bound::proved(campaign);
        let search = |objective: usize| {
            let mut starts = corners.starts(campaign, objective);
            starts.insert(0, campaign.scenario(drawn.excess[objective].index));
            let starts = (objective, &starts[..], proofs[objective].place());
            search::search(campaign, trial, starts, &|runs| told(runs))
        };
        let found = (0..campaign.objectives.len()).map(search).collect();
        Self { drawn, corners, found, proofs }
    }

    /// The worst that was found of all objectives.
    pub fn foremost(&self) -> Option<&Found> {
        self.found.iter().reduce(|a, b| if b.excess > a.excess { b } else { a })
    }
}

impl Campaign {
    /// Most runs of the corners and of the search.
    pub fn searched(&self) -> u64 {
        (self.corners().len() + self.search * self.objectives.len()) as u64
    }
}

/// The final report.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Number and kind of runs.
    pub run: String,
    /// Distribution of the draws.
    pub distribution: String,
    /// One for each objective.
    pub objectives: Vec<Judged>,
    /// Difference of the sides of Theorem 1; `None` for the loop that runs.
    pub sides: Option<Sides>,
    /// The trajectory of the objective that comes off worst.
    pub trajectory: Option<Trajectory>,
}

/// Both sides of Theorem 1.
#[derive(Clone, Debug)]
pub struct Sides {
    /// Difference of the sides, in words.
    pub told: String,
    /// True if that is too large.
    pub apart: bool,
}

/// An objective, judged.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Verdict on the objective.
    pub verdict: Verdict,
    /// The worst that was met of it, as an excess over its bound: below 0 it holds.
    pub excess: f64,
    /// The scenario in which it was met, in words with which it can be run again.
    pub worst: String,
    /// Part of the emitted program that a proof includes.
    scope: String,
    /// Basis of the verdict.
    pub details: Vec<String>,
}

/// Advice where the sides differ.
pub const APART: &str =
    "a larger `until` under [verify] keeps away from where rounding is all that is left";

/// The report of what is known of a campaign.
pub fn summary(campaign: &Campaign, trial: &mut Trial, known: &Known<'_>) -> Summary {
    let Known { drawn, corners, found, proofs } = known;
    let runs: usize = found.iter().map(|found| found.runs).sum();
    let run = format!(
        "{} of seed {}, {} and {} of the search, {}",
        counted(&drawn.scenarios, "draw"),
        campaign.seed,
        counted(&corners.scenarios.len(), "corner"),
        counted(&runs, "run"),
        extent(campaign)
    );
    let mut objectives = Vec::new();
    for (index, found) in found.iter().enumerate() {
        let tally = &corners.tally;
        let proof = &proofs[index];
        let evidence = Evidence { drawn, corners: tally, found, proof };
        let verdict = Verdict::of(campaign, index, evidence);
        let mut details = reasons((campaign, trial), (index, verdict), (known, found));
        match (verdict, proof) {
            (_, Proof::Refuted { why, .. } | Proof::Met { why }) => details.push(why.clone()),
            (Verdict::Fails | Verdict::Proved, _) | (_, Proof::Proved { .. }) => {}
            (_, Proof::NotProved { why } | Proof::NoRoom { why, .. }) => {
                details.push(format!("not proved: {why}"));
            }
        }
        let kind = &campaign.objectives[index].kind;
        let Worst { value, index: draw } = drawn.excess[index];
        details.push(format!("worst draw: scenario {draw}, {}", against(kind, value)));
        let mut most = value;
        let mut worst = campaign.text_of(&campaign.scenario(draw));
        let corner = tally.excess[index];
        let scenario = usize::try_from(corner.index).ok().and_then(|i| corners.scenarios.get(i));
        let others =
            [("corner", corner.value, scenario), ("found", found.excess, Some(&found.scenario))];
        for (name, value, scenario) in others {
            if let Some(scenario) = scenario.filter(|_| value > most) {
                let (told, at) = (campaign.text_of(scenario), against(kind, value));
                details.push(format!("worst {name}: {told}, {at}"));
                (most, worst) = (value, told);
            }
        }
        let scope = match proof {
            Proof::Proved { scope } => match campaign.around {
                Some(_) => format!("by the worst case, for every x0 and every signal, {scope}"),
                None => format!("by intervals for every x0, tau and T, {scope}"),
            },
            _ => String::new(),
        };
        objectives.push(Judged { verdict, excess: most, worst, scope, details });
    }
    let sides = campaign.has_sides().then(|| sides(campaign, trial, known));
    let trajectory = known.foremost().map(|worst| {
        let scenario = worst.scenario.clone();
        let (instants, ended) = trajectory(campaign, trial, &scenario);
        let ended = ended.map(|ended| ended.message);
        Trajectory { told: campaign.text_of(&scenario), instants, scenario, ended }
    });
    let distribution = distribution(campaign);
    Summary { run, distribution, objectives, sides, trajectory }
}

/// Describes the part of a run that is looked at.
fn extent(campaign: &Campaign) -> String {
    let Some(around) = &campaign.around else {
        let emitted = if campaign.has_sides() { "" } else { "with the emitted controller, " };
        let precision = match campaign.spec.precision {
            Precision::F32 => ", integrated in f64, called in f32",
            Precision::F64 => "",
        };
        return format!("{emitted}T/tau from 1 to {:?}{precision}", campaign.until);
    };
    let to = match campaign.until {
        _ if campaign.follows_deadline() => "the last deadline".to_owned(),
        0.0 => "the deadline".to_owned(),
        until => format!("T/tau = {until:?}"),
    };
    format!("in the loop that runs, every {:?} s from t0 to {to}", around.period)
}

/// Explanation of the sides of a loop that is linear in stretched time.
const PROPAGATED: &str = "\nwhere f is constant from instant to instant, x is the exact propagation of the law, and the second side is u of the emitted program in these states";

/// Compares the sides of Theorem 1.
fn sides(campaign: &Campaign, trial: &Trial, known: &Known<'_>) -> Sides {
    let others = known.found.iter().map(|found| found.difference);
    let others = others.fold(known.corners.tally.difference.value, f64::max);
    let Worst { index, value } = known.drawn.difference;
    let difference = others.max(value);
    let apart = difference > campaign.tolerance;
    let agree = if apart { "differ" } else { "agree" };
    let told = format!(
        "both sides of Theorem 1 {agree}: maximum difference {difference:.1e} (of the draws {value:.1e}, scenario {index}), tolerance {:?}{}",
        campaign.tolerance,
        if trial.propagates() { PROPAGATED } else { "" }
    );
    Sides { told, apart }
}

/// An excess in words.
pub fn against(kind: &Kind, excess: f64) -> String {
    match kind {
        _ if excess == f64::INFINITY => {
            "which leaves the range of numbers, or of its bound".to_owned()
        }
        _ if excess == f64::NEG_INFINITY => "unknown, as no run was finished".to_owned(),
        _ if Comparison::of(excess) == Comparison::Met => {
            "at its bound, within rounding".to_owned()
        }
        Kind::Within { .. } if excess > 0.0 => format!("outside by {excess:.6}"),
        Kind::Within { .. } => format!("inside by {:.6}", -excess),
        _ => format!("at {:.4} of the bound", 1.0 + excess),
    }
}
