//! Verification that a closed loop keeps its objectives h(x, u, t) in H(t) for all that is uncertain.
//!
//! A [`Campaign`] is what a design asks for: boxes of initial states and tau, the set F of what may
//! move the plant, and objectives. A [`Scenario`] is one point of it: a draw is a pure function of
//! the seed and an index, so that shards and threads decide nothing; corners are joint extremes of all
//! that is uncertain. A [`Trial`] runs one on both sides of Theorem 1, or, where the design has a
//! sample period, in the loop that runs; a [`Tally`] holds what is kept
//! of many, by reductions in which no order counts, and [`Drawn`] what a report shows of the draws besides; [`search`] goes on from the worst ones, with the
//! signals that `kernel` makes of a run. A [`Verdict`] is all that is known of an objective, and
//! [`record`] keeps one row per draw.

mod allowance;
mod batch;
pub mod bound;
mod columns;
mod compiled;
mod corner;
mod course;
mod envelope;
mod exact;
mod kernel;
mod linear;
pub mod objective;
mod observer;
mod outcome;
mod read;
pub mod record;
mod replay;
mod run;
mod samples;
mod scenario;
pub mod search;
mod settings;
mod start;
mod summary;
mod survey;
mod tally;
mod threads;
mod track;
mod trajectory;
mod trial;
mod verdict;

pub use crate::keys::verify::{DISTURBANCE, INITIAL_STATE, KEYS, OBJECTIVE_KEYS, PARAMETER};
pub use allowance::{ALLOWANCE, Comparison, Level};
pub use compiled::Agreement;
pub use corner::Corners;
pub use course::{Course, Signal};
pub use envelope::Envelope;
pub use objective::{Kind, Objective};
pub use outcome::{Judgement, Other, Outcome, Status};
pub use read::{read, read_scenarios, read_with_plant};
pub use run::{Done, chunks, sample, shard};
pub use scenario::{Scenario, Setting};
pub use start::{Impossible, impossible, possible, reversed};
pub use summary::{APART, End, Judged, Known, Sides, Summary, against, summary};
pub use survey::{Drawn, Driver, Spread};
pub use tally::{Tally, Worst};
pub use threads::threaded;
pub use trajectory::{Trajectory, columns, csv, shown};
pub use trial::{Instant, Trial};
pub use verdict::{Doubt, Evidence, Verdict, confidence};

use crate::check::resolved::Resolved;
use crate::expression::{Expression, Variable};
use crate::parameter::{Fixed, Parameter};
use crate::plant::Plant;
use crate::request::Spec;
use crate::simulate::{Events, Loop};

/// An interval, least and greatest value.
pub type Interval = (f64, f64);

/// The name of the true input gain, in parts of the known one.
const GAIN: &str = "gain";

/// T/tau at which the pieces of signals end in the loop that runs, whose deadline is T = 0.
const SPAN: f64 = 1e-3;

/// Subject and settings of a verification.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// The design whose controller is verified.
    pub design: Resolved,
    /// Its controller as it runs: what the campaign gives at `init` is fixed or left to run time in it.
    pub spec: Spec,
    /// The plant, whose bounded symbols are uncertain.
    pub plant: Plant,
    /// Number of draws.
    pub scenarios: u64,
    /// Seed of all of them.
    pub seed: u64,
    /// Runs that the search may take for each objective.
    pub search: usize,
    /// Sampling, sensors and actuator of the sampled loop; `None` if the law itself is verified.
    pub around: Option<Loop>,
    /// T/tau at which a run ends; in the loop that runs it may be beyond the deadline, at T <= 0.
    pub until: f64,
    /// Most by which the two sides of Theorem 1 may differ, as a part of the largest value of a run.
    pub tolerance: f64,
    /// tau in s.
    pub tau: Interval,
    /// x_1..x_n at t0.
    pub x0: Vec<Interval>,
    /// Symbols of the plant, and parameters of the controller, that are constant but not known.
    pub intervals: Vec<(Parameter, Interval)>,
    /// Symbols of the plant that vary within their bounds, and how they may.
    pub disturbances: Vec<(Parameter, Interval, Vec<Signal>)>,
    /// Events of every run, whose uncertain numbers are drawn.
    pub events: Events,
    /// Integrands accumulated along a run, from 0 at t0: each a function of the plant, of time and of the integrals
    /// before it, which are variables behind those of the plant.
    pub integrals: Vec<Expression>,
    /// Objectives that have to hold.
    pub objectives: Vec<Objective>,
}

/// Version of the engine, on which the rows of a campaign depend: the version of the package, and behind it a number
/// that is raised by every change that alters the bits of a run.
pub const ENGINE: &str = concat!(env!("CARGO_PKG_VERSION"), "+9");

impl Campaign {
    /// All that decides the rows, as text: two campaigns with the same text have the same rows from the same [`ENGINE`].
    pub fn text(&self) -> String {
        let mut lines = vec![self.spec.command()];
        lines.extend(self.plant.lines(&self.spec));
        let fixed =
            |(symbol, value): (&Parameter, &Fixed)| format!("{} = {value}", symbol.spelling());
        lines.extend(self.plant.fixed.iter().map(fixed));
        let within = |name: &str, (low, high): Interval| format!("{name} = [{low:?}, {high:?}]");
        for (symbol, interval) in &self.intervals {
            lines.push(within(&symbol.spelling(), *interval));
        }
        for (symbol, interval, signals) in &self.disturbances {
            let signals: Vec<_> = signals.iter().map(|signal| signal.name()).collect();
            lines.push(format!(
                "{}, {}",
                within(&symbol.spelling(), *interval),
                signals.join(", ")
            ));
        }
        lines.push(within("tau", self.tau));
        lines.extend(self.spec.state_names().iter().zip(&self.x0).map(|(x, x0)| within(x, *x0)));
        let Self { scenarios, seed, until, tolerance, search, .. } = self;
        lines.push(format!("scenarios = {scenarios}, seed = {seed}, until = {until:?}"));
        lines.extend(self.around.iter().map(|around| format!("{around:?}")));
        if !self.events.is_empty() {
            lines.push(format!("{:?}", self.events));
        }
        lines.push(format!("tolerance = {tolerance:?}, search = {search}"));
        lines.extend(self.objectives.iter().map(ToString::to_string));
        lines.join("\n")
    }

    /// Returns the interval of the true input gain of the loop that runs, where it is not known.
    pub(super) fn gains(&self) -> Option<Interval> {
        let [least, most] = self.around.as_ref()?.gain;
        (least < most).then_some((least, most))
    }

    /// A parameter of the controller that is drawn, if one is; those of a model are of the plant too.
    pub(super) fn drawn(&self) -> Option<Parameter> {
        let of_controller = self.spec.parameters();
        let mut symbols = self.intervals.iter().map(|(symbol, _)| *symbol);
        symbols.find(|symbol| of_controller.contains(symbol))
    }

    /// Returns true if both sides of Theorem 1 are run: the law of a chain, at every instant.
    pub fn has_sides(&self) -> bool {
        self.around.is_none() && !self.spec.has_model()
    }

    /// Returns true if a run ends at the deadline in force, which may change: by an event, or by the controller.
    pub(super) fn follows_deadline(&self) -> bool {
        self.until == 0.0 && (!self.events.is_empty() || self.spec.changes_deadline())
    }

    /// Returns the length of the longest planned run, in parts of tau.
    pub(crate) fn length(&self) -> f64 {
        let (true, Some(around)) = (self.follows_deadline(), &self.around) else {
            return 1.0 - self.until;
        };
        let around = Loop { events: self.events.latest(), ..around.clone() };
        let (low, high) = self.tau;
        [low, high].map(|tau| around.planned(tau) / tau).into_iter().fold(1.0, f64::max)
    }

    /// T/tau at which the pieces of signals end, > 0.
    pub(super) fn span(&self) -> f64 {
        if self.around.is_some() { SPAN } else { self.until }
    }

    /// The same of the law in time, before there is an eps with which it runs.
    #[must_use]
    pub fn of_law(&self) -> Self {
        match self.spec.sampled() {
            Some(_) => self.clone(),
            None => {
                let events = Events::default();
                Self { around: None, until: self.span(), events, ..self.clone() }
            }
        }
    }

    /// Returns the objective that a gain that is not known must keep, |b| < |g|: the plant's own gain, with the effect
    /// of u through f, has the sign of the controller's g. A model says how u moves each of its states.
    pub fn gain(&self) -> Objective {
        let Plant { f, g, .. } = self.disturbed();
        let control = Expression::from(Variable::Control);
        let with = |u: i64| f.substitute(&|e| (*e == control).then(|| Expression::integer(u)));
        let own = self.spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let true_gain = with(1).sub(with(0)).add(g.unwrap_or(own.clone()));
        let low = Some(Expression::integer(0));
        Kind::Within { h: true_gain.div(own), low, high: None }.into()
    }
}
