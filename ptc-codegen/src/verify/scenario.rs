//! One point of what is uncertain: a draw, a pure function of the seed and an index, or any other.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::course::{Course, between};
use super::settings::Settings;
use super::{Campaign, GAIN, Interval, Signal};
use crate::expression::{Expression, Function, Variable};
use crate::parameter::{Name, Parameter};
use crate::plant::Plant;
use crate::simulate::{Loop, Piece, Values};

/// Seeds of what is drawn at each sample are below this, so that a double holds one.
pub(super) const SEEDS: u64 = 1 << 53;

/// One scenario, in the plant's own units.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// tau, x_1..x_n at t0, the constants that are not known, and the numbers of events.
    pub point: Vec<f64>,
    /// Course of each disturbance.
    pub courses: Vec<Course>,
    /// Seed of what is drawn at each sample; 0 where nothing is.
    pub seed: u64,
    /// T/tau of an instant that is looked at beside those of every run.
    pub at: Option<f64>,
}

/// One scenario as it is run.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Parameters and symbols, with those of the first piece.
    pub values: Values,
    /// State at t0.
    pub x0: Vec<f64>,
    /// T/tau of the instants that are looked at, with what holds from the one before on.
    pub pieces: Vec<Piece>,
    /// Sampling, sensors and actuator of the sampled loop.
    pub around: Option<Loop>,
}

impl Campaign {
    /// The draw of an index: independent of all others, even in the boxes, each signal of a disturbance
    /// as likely as the others.
    pub fn scenario(&self, index: u64) -> Scenario {
        self.drawn_from(self.random(), index)
    }

    /// Returns the random generator with which all draws begin.
    pub(super) fn random(&self) -> ChaCha8Rng {
        ChaCha8Rng::seed_from_u64(self.seed)
    }

    /// The draw of an index from what all begin with.
    pub(super) fn drawn_from(&self, mut random: ChaCha8Rng, index: u64) -> Scenario {
        random.set_stream(index);
        let mut bits = || random.next_u64() >> 11;
        #[allow(clippy::cast_precision_loss)]
        let mut even = || bits() as f64 / 2f64.powi(53);
        let point = self.sides().map(|interval| between(interval, even())).collect();
        let drawn = |(_, bounds, legal): &(_, Interval, Vec<Signal>)| {
            Course::drawn((legal, *bounds), self.span(), &mut even)
        };
        let courses = self.disturbances.iter().map(drawn).collect();
        // Drawn last, so that sensors change nothing of the rest.
        let seed = if self.is_drawn() { bits() } else { 0 };
        Scenario { point, courses, seed, at: None }
    }

    /// Returns true if anything is drawn at each sample of a run.
    pub(super) fn is_drawn(&self) -> bool {
        self.around.as_ref().is_some_and(Loop::is_drawn)
    }

    /// The intervals of tau, x_1..x_n at t0, the constants and the numbers of events.
    pub(super) fn sides(&self) -> impl Iterator<Item = Interval> {
        let constants = self.intervals.iter().map(|(_, interval)| *interval);
        let box_of_x0 = self.x0.iter().copied();
        let of_events = self.events.uncertain().map(|own| (own.low, own.high));
        let constants = constants.chain(self.gains()).chain(of_events);
        std::iter::once(self.tau).chain(box_of_x0).chain(constants)
    }

    /// The names of these.
    pub(super) fn names(&self) -> impl Iterator<Item = String> {
        let constants = self.intervals.iter().map(|(symbol, _)| symbol.spelling());
        let states = self.spec.state_names();
        let gain = self.gains().map(|_| GAIN.to_owned());
        let of_events = self.events.uncertain().map(|own| own.name.clone());
        let constants = constants.chain(gain).chain(of_events);
        std::iter::once("tau".to_owned()).chain(states).chain(constants)
    }

    /// Returns the name and interval of each quantity that is constant in a run and not known.
    pub fn uncertain(&self) -> impl Iterator<Item = (String, Interval)> {
        self.names().zip(self.sides())
    }

    /// The size of the wave of each disturbance, 0 of all signals but a sine.
    pub(super) fn waves(&self) -> impl Iterator<Item = Parameter> {
        (0..self.disturbances.len()).map(|d| wave(d)[1])
    }

    /// T/tau of the instants at which objectives are looked at.
    pub(super) fn grid(&self) -> Vec<f64> {
        let until = self.span();
        let last = 0.1f64.max(until.sqrt());
        let even = (0..40).map(|i| 1.0 - (1.0 - last) * f64::from(i) / 40.0);
        let late = (0..40).map(|i| last * (until / last).powf(f64::from(i) / 39.0));
        even.chain(late).collect()
    }

    /// A scenario in the plant's units.
    pub fn setting(&self, scenario: &Scenario) -> Setting {
        self.looked_at(scenario, 1)
    }

    /// The same, looked at often enough that a peak between two instants is near one of them.
    pub fn closely(&self, scenario: &Scenario) -> Setting {
        self.looked_at(scenario, 16)
    }

    /// A scenario with each step of the grid divided.
    pub(super) fn looked_at(&self, scenario: &Scenario, parts: u32) -> Setting {
        Settings::of(self, parts).setting(scenario)
    }

    /// The plant with a wave of run-time symbols in place of each disturbance.
    pub fn disturbed(&self) -> Plant {
        let wave = |e: &Expression| {
            let (d, (_, _, signals)) = self
                .disturbances
                .iter()
                .enumerate()
                .find(|(_, (symbol, ..))| *e == Expression::from(*symbol))?;
            let [bias, size, rate, phase] = wave(d).map(Expression::from);
            if !signals.contains(&Signal::Sine) {
                return Some(bias);
            }
            let angle = rate.mul(Variable::Elapsed.into()).add(phase);
            Some(bias.add(size.mul(Expression::call(Function::Sin, angle))))
        };
        self.plant.substitute(&wave)
    }
}

/// The symbols of a disturbance: bias + size sin(rate dt + phase).
pub(super) fn wave(d: usize) -> [Parameter; 4] {
    ["bias", "size", "rate", "phase"].map(|part| {
        let name = Name::new(&format!("ptc_disturbance{d}_{part}"));
        name.map_or(Parameter::StartTime, Parameter::Named)
    })
}
