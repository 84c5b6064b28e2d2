//! The verdicts on a campaign in words, and the worst trajectory.

use super::bound::{self, Proof};
use super::search::{self, Found};
use super::trajectory::{Trajectory, table, trajectory};
use super::{
    Campaign, Corners, Doubt, Evidence, Kind, Scenario, Signal, Tally, Trial, Verdict, Worst,
    confidence,
};
use crate::diagnostic::counted;
use crate::parameter::Precision;
use crate::simulate;

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
        let search = |objective: usize| {
            let mut starts = corners.starts(campaign, objective);
            starts.insert(0, campaign.scenario(drawn.excess[objective].index));
            search::search(campaign, trial, (objective, &starts), &|runs| told(runs))
        };
        let found = (0..campaign.objectives.len()).map(search).collect();
        Self { drawn, corners, found, proofs: bound::proved(campaign) }
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
    /// How much was run.
    pub run: String,
    /// What the draws are drawn from.
    pub distribution: String,
    /// One for each objective.
    pub objectives: Vec<Judged>,
    /// How far the sides of Theorem 1 are apart; `None` for the loop that runs.
    pub sides: Option<Sides>,
    /// The trajectory of the objective that comes off worst.
    pub trajectory: Option<Trajectory>,
}

/// Both sides of Theorem 1.
#[derive(Clone, Debug)]
pub struct Sides {
    /// How far they are apart, in words.
    pub told: String,
    /// Whether that is too far.
    pub apart: bool,
}

/// An objective, judged.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What is said of it.
    pub verdict: Verdict,
    /// The worst that was met of it, as an excess over its bound: below 0 it holds.
    pub excess: f64,
    /// The scenario in which it was met, in words with which it can be run again.
    pub worst: String,
    /// What of the emitted program a proof includes.
    scope: String,
    /// What it was judged by.
    pub details: Vec<String>,
}

/// What a verification comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every objective holds.
    Holds,
    /// An objective fails.
    Fails,
    /// None fails, and not every one is known to hold.
    Undecided,
}

/// What is to be done where the sides differ.
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
        if let (Verdict::Sampled { .. } | Verdict::Undecided(_), Proof::NotProved { why }) =
            (verdict, proof)
        {
            details.push(format!("not proved: {why}"));
        }
        if let Proof::Refuted { why, .. } = proof {
            details.push(why.clone());
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
            Proof::Refuted { .. } | Proof::NotProved { .. } => String::new(),
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

/// What of a run is looked at.
fn extent(campaign: &Campaign) -> String {
    let Some(around) = &campaign.around else {
        let emitted = if campaign.has_sides() { "" } else { "with the emitted controller, " };
        let precision = match campaign.spec.precision {
            Precision::F32 => ", in f64, not in f32",
            Precision::F64 => "",
        };
        return format!("{emitted}T/tau from 1 to {:?}{precision}", campaign.until);
    };
    let to = match campaign.until {
        0.0 => "the deadline".to_owned(),
        until => format!("T/tau = {until:?}"),
    };
    format!("in the loop that runs, every {:?} s from t0 to {to}", around.period)
}

/// What the sides are of a loop that is linear in stretched time.
const PROPAGATED: &str = "\nwhere f is constant from instant to instant, x is the exact propagation of the law, and the second side is u of the emitted program in these states";

/// How far the sides of Theorem 1 are apart.
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

/// Why a verdict is what it is.
fn reasons(
    (campaign, trial): (&Campaign, &mut Trial),
    (objective, verdict): (usize, Verdict),
    (known, found): (&Known<'_>, &Found),
) -> Vec<String> {
    let (draws, corners) = (known.drawn, &known.corners.tally);
    let of = |count: &dyn Fn(&Tally) -> u64| {
        format!(
            "{} of {} and {} of {}",
            count(draws),
            counted(&draws.scenarios, "draw"),
            count(corners),
            counted(&corners.scenarios, "corner")
        )
    };
    let failed = || format!("{} fail it", of(&|tally| tally.failed[objective]));
    match verdict {
        Verdict::Proved => Vec::new(),
        Verdict::Sampled { draws } => vec![match confidence(draws) {
            Some((most, beta)) => format!(
                "{} without a failure: the probability of failure under the stated distribution is at most ln(1/{beta})/{draws} = {most:.2e} with confidence {}",
                counted(&draws, "independent draw"),
                1.0 - beta
            ),
            None => format!("{} without a failure: too few to bound its probability", counted(&draws, "independent draw")),
        }],
        Verdict::Fails => vec![failed()],
        Verdict::Undecided(Doubt::Contradiction) => vec![
            failed(),
            "the intervals prove it: one of the two is wrong, which is a fault of this program; please report it".to_owned(),
        ],
        Verdict::Undecided(Doubt::Apart) => {
            vec!["the two sides of Theorem 1 differ by more than `tolerance`".to_owned()]
        }
        Verdict::Undecided(Doubt::Open) => {
            vec!["the bound is met within rounding: it holds on one side of Theorem 1, and fails on the other".to_owned()]
        }
        Verdict::Undecided(Doubt::Unfinished) => {
            let (scenario, ended) = match (draws.first_unfinished, corners.first_unfinished) {
                (Some(index), _) => (format!("scenario {index}"), rerun(campaign, trial, &campaign.scenario(index))),
                (None, Some(place)) => {
                    let place = usize::try_from(place).unwrap_or(usize::MAX);
                    let scenario = known.corners.scenarios.get(place).cloned();
                    let scenario = scenario.unwrap_or_else(|| campaign.scenario(0));
                    (campaign.text_of(&scenario), rerun(campaign, trial, &scenario))
                }
                (None, None) => match &found.unfinished {
                    Some((scenario, ended)) => (campaign.text_of(scenario), Some(ended.clone())),
                    None => (String::new(), None),
                },
            };
            let mut details = vec![format!("{} could not be finished", of(&|tally| tally.unfinished))];
            details.extend(ended.map(|ended| format!("{scenario}: {}; {}", ended.message, ended.help)));
            details
        }
    }
}

/// Why a scenario ends early.
fn rerun(campaign: &Campaign, trial: &mut Trial, scenario: &Scenario) -> Option<simulate::Failure> {
    trial.run(&campaign.setting(scenario)).ended
}

/// Whose state the initial one is, where there are two.
const FOLLOWS: &str = "of the plant, and not of its tracking error e";

/// What the draws are drawn from.
fn distribution(campaign: &Campaign) -> String {
    let drawn = campaign.uncertain().filter(|(_, (low, high))| low < high);
    let names: Vec<_> = drawn.map(|(name, _)| name).collect();
    let mut parts = Vec::new();
    if !names.is_empty() {
        let boxes = if names.len() == 1 { "its interval" } else { "their intervals" };
        parts.push(format!("{} uniform in {boxes}", listed(&names)));
    }
    for (symbol, _, signals) in &campaign.disturbances {
        let words: Vec<_> =
            signals.iter().map(|signal: &Signal| signal.name().to_owned()).collect();
        let likely = match words.len() {
            1 => words[0].clone(),
            _ => format!("one of {}, each as likely", listed(&words)),
        };
        parts.push(format!("{} {likely}", symbol.spelling()));
    }
    if let Some(around) = campaign.around.as_ref().filter(|around| around.is_drawn()) {
        let sensors =
            [(&around.noise, "noise even within its bounds"), (&around.noise_rms, "normal noise")];
        let given = sensors.into_iter().filter(|(sizes, _)| sizes.iter().any(|size| *size > 0.0));
        parts.extend(given.map(|(_, told)| format!("{told} at each sample")));
        if around.jitter > 0.0 {
            parts.push("samples early or late, evenly within jitter".to_owned());
        }
    }
    if parts.is_empty() {
        parts.push("nothing is drawn".to_owned());
    }
    if campaign.spec.reference.is_some() {
        parts.push(format!("{} at t0 {FOLLOWS}", listed(&campaign.spec.state_names())));
    }
    parts.join("; ")
}

fn listed(words: &[String]) -> String {
    match words {
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
        [] => String::new(),
    }
}

impl Judged {
    /// The verdict in words.
    pub fn verdict(&self) -> String {
        match self.verdict {
            Verdict::Proved => {
                format!("holds, proved {}", self.scope)
            }
            Verdict::Sampled { .. } => "holds, by sampling".to_owned(),
            Verdict::Undecided(_) => "undecided".to_owned(),
            Verdict::Fails => "fails".to_owned(),
        }
    }
}

impl Summary {
    /// What it comes to: an objective that fails decides it.
    pub fn end(&self) -> End {
        let any = |wanted: &dyn Fn(Verdict) -> bool| {
            self.objectives.iter().any(|judged| wanted(judged.verdict))
        };
        match () {
            () if any(&|verdict| verdict == Verdict::Fails) => End::Fails,
            () if self.sides.as_ref().is_some_and(|sides| sides.apart)
                || any(&|verdict| !verdict.holds()) =>
            {
                End::Undecided
            }
            () => End::Holds,
        }
    }

    /// As it is printed.
    pub fn text(&self, campaign: &Campaign) -> String {
        let mut text = format!("{}: {}\n", campaign.spec.name(), self.run);
        text.push_str(&format!("draws: {}\n\n", self.distribution));
        let judged = campaign.objectives.iter().zip(&self.objectives);
        for (number, (objective, judged)) in (1..).zip(judged) {
            text.push_str(&format!("objective {number}, {objective}: {}\n", judged.verdict()));
            judged.details.iter().for_each(|detail| text.push_str(&format!("  {detail}\n")));
        }
        if let Some(Sides { told, apart }) = &self.sides {
            text.push_str(&format!("\n{told}\n"));
            if *apart {
                text.push_str(&format!("  {APART}\n"));
            }
        }
        if let Some(Trajectory { told, instants, ended, .. }) = &self.trajectory {
            text.push_str(&format!(
                "\nworst trajectory, {told}\n{}",
                table(&campaign.spec, instants)
            ));
            text.extend(ended.iter().map(|ended| format!("  it ends early: {ended}\n")));
        }
        text.push_str(match self.end() {
            End::Holds => "\nevery objective holds\n",
            End::Fails => "\nnot verified\n",
            End::Undecided => "\nundecided\n",
        });
        text
    }
}

/// An excess in words.
pub fn against(kind: &Kind, excess: f64) -> String {
    match kind {
        _ if excess == f64::INFINITY => {
            "which leaves the range of numbers, or of its bound".to_owned()
        }
        Kind::Within { .. } if excess > 0.0 => format!("outside by {excess:.6}"),
        Kind::Within { .. } => format!("inside by {:.6}", -excess),
        _ => format!("at {:.4} of the bound", 1.0 + excess),
    }
}
