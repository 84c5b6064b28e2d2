//! One point of what is uncertain: a pure function of the seed and an index.

use std::f64::consts::TAU;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::{Campaign, Interval};
use crate::expression::{Expression, Function, Variable};
use crate::plant::Plant;
use crate::simulate::Values;
use crate::spec::{Name, Parameter};

/// How a disturbance varies within its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// One value throughout.
    Constant,
    /// A sine from bound to bound, of 1/2 to 50 periods a tau.
    Sine,
    /// From bound to bound, up to 16 times.
    Square,
    /// Another value in each of 16 pieces of the run.
    Random,
    /// One of the bounds in each of 16 pieces: the corners of what is bounded, which the search goes
    /// on from.
    Worst,
}

impl Signal {
    /// All signals.
    pub const ALL: [Self; 5] =
        [Self::Constant, Self::Sine, Self::Square, Self::Random, Self::Worst];

    /// The word of the design file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Sine => "sine",
            Self::Square => "square",
            Self::Random => "random",
            Self::Worst => "worst",
        }
    }
}

/// Pieces of a random or a worst signal.
const PIECES: usize = 16;

/// Coordinates of a signal: which one, its levels, its frequency and its phase.
const OF_SIGNAL: usize = 3 + PIECES;

/// One scenario in a box of unit length: tau, x0, the constants, and for each disturbance its signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario(pub(super) Vec<f64>);

/// One scenario in the plant's own units.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Parameters and symbols, with those of the first piece.
    pub values: Values,
    /// State at t0.
    pub x0: Vec<f64>,
    /// T/tau of the instants that are looked at, with what holds from the one before on.
    pub pieces: Vec<(Vec<f64>, Values)>,
}

impl Campaign {
    /// The scenario of an index.
    pub fn scenario(&self, index: u64) -> Scenario {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(index);
        let mut even = || {
            #[allow(clippy::cast_precision_loss)]
            let bits = (random.next_u64() >> 11) as f64;
            bits / 2f64.powi(53)
        };
        let mut all: Vec<_> = (0..self.coordinates()).map(|_| even()).collect();
        // The worst of a box is often one of its corners, which chance alone does not meet.
        if index.is_multiple_of(4) {
            all[..self.of_box()].iter_mut().for_each(|c| *c = c.round());
        }
        Scenario(all)
    }

    /// Coordinates of tau, x0 and the constants.
    fn of_box(&self) -> usize {
        1 + self.x0.len() + self.intervals.len()
    }

    fn coordinates(&self) -> usize {
        self.of_box() + OF_SIGNAL * self.disturbances.len()
    }

    /// Coordinates that a search may move, each with whether it has two values only.
    pub(super) fn movable(&self, scenario: &Scenario) -> Vec<(usize, bool)> {
        let mut movable: Vec<_> = (0..self.of_box()).map(|i| (i, false)).collect();
        for (d, (_, _, signals)) in self.disturbances.iter().enumerate() {
            let at = self.of_box() + OF_SIGNAL * d;
            match signal(signals, scenario.0[at]) {
                Signal::Constant => movable.push((at + 1, false)),
                Signal::Sine | Signal::Square => {
                    movable.extend([(at + 1 + PIECES, false), (at + 2 + PIECES, false)]);
                }
                Signal::Random => movable.extend((0..PIECES).map(|i| (at + 1 + i, false))),
                Signal::Worst => movable.extend((0..PIECES).map(|i| (at + 1 + i, true))),
            }
        }
        movable
    }

    /// The same with every disturbance that may be the worst one as such, of the same sign.
    pub(super) fn at_worst(&self, scenario: &Scenario) -> Scenario {
        let mut worst = scenario.clone();
        for (d, (_, _, signals)) in self.disturbances.iter().enumerate() {
            let Some(place) = signals.iter().position(|s| *s == Signal::Worst) else { continue };
            let at = self.of_box() + OF_SIGNAL * d;
            let own = &scenario.0[at..at + OF_SIGNAL];
            let kind = signal(signals, own[0]);
            for piece in 0..PIECES {
                let (from, to) = (self.share(piece), self.share(piece + 1));
                let level = level(kind, own, middle(from, to), piece);
                worst.0[at + 1 + piece] = if level >= 0.5 { 1.0 } else { 0.0 };
            }
            #[allow(clippy::cast_precision_loss)]
            let chosen = (place as f64 + 0.5) / signals.len() as f64;
            worst.0[at] = chosen;
        }
        worst
    }

    /// The signal of each disturbance.
    pub fn signals(&self, scenario: &Scenario) -> Vec<(Parameter, Signal)> {
        let own = scenario.0[self.of_box()..].chunks(OF_SIGNAL);
        let one = |((symbol, _, legal), own): (&(Parameter, _, Vec<Signal>), &[f64])| {
            (*symbol, signal(legal, own[0]))
        };
        self.disturbances.iter().zip(own).map(one).collect()
    }

    /// T/tau where a piece begins: 8 even in time, then 8 even in its logarithm.
    fn share(&self, piece: usize) -> f64 {
        let half = PIECES / 2;
        #[allow(clippy::cast_precision_loss)]
        let part = |piece: usize| piece as f64 / half as f64;
        // Runs may end before the last eighth.
        let last = (1.0 / half as f64).max(self.until.sqrt());
        if piece <= half {
            1.0 - (1.0 - last) * part(piece)
        } else {
            last * (self.until / last).powf(part(piece - half))
        }
    }

    /// T/tau of the instants at which objectives are looked at.
    fn grid(&self) -> Vec<f64> {
        let last = 0.1f64.max(self.until.sqrt());
        let even = (0..40).map(|i| 1.0 - (1.0 - last) * f64::from(i) / 40.0);
        let late = (0..40).map(|i| last * (self.until / last).powf(f64::from(i) / 39.0));
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
    fn looked_at(&self, scenario: &Scenario, parts: u32) -> Setting {
        let mut next = scenario.0.iter().copied();
        let mut draw = |interval: Interval| between(interval, next.next().unwrap_or(0.5));
        let mut values = Values::of(&self.spec, &self.plant);
        values.set(Parameter::Tau, draw(self.tau));
        let x0 = self.x0.iter().map(|x0| draw(*x0)).collect();
        for (symbol, interval) in &self.intervals {
            values.set(*symbol, draw(*interval));
        }
        if !values.get(Parameter::Eps).is_finite() {
            // The side that is emitted code must not hold its gains before the run ends.
            values.set(Parameter::Eps, 0.5 * self.until * values.get(Parameter::Tau));
        }
        let signals: Vec<_> = scenario.0[self.of_box()..].chunks(OF_SIGNAL).collect();
        let mut breaks = vec![self.until];
        for ((_, _, legal), own) in self.disturbances.iter().zip(&signals) {
            match signal(legal, own[0]) {
                Signal::Constant | Signal::Sine => {}
                Signal::Square => breaks.extend(jumps(own)),
                Signal::Random | Signal::Worst => {
                    breaks.extend((1..PIECES).map(|piece| self.share(piece)));
                }
            }
        }
        breaks.retain(|share| (self.until..1.0).contains(share));
        breaks.sort_by(|a, b| b.total_cmp(a));
        breaks.dedup();
        let mut grid = self.grid();
        grid.extend(&breaks);
        grid.sort_by(|a, b| b.total_cmp(a));
        grid.dedup();
        let within: Vec<_> = grid.windows(2).flat_map(|step| divided(step, parts)).collect();
        grid.extend(within);
        grid.sort_by(|a, b| b.total_cmp(a));
        let (mut from, mut pieces) = (1.0, Vec::with_capacity(breaks.len()));
        for to in breaks {
            let mut values = values.clone();
            let at = middle(from, to);
            let piece = (1..PIECES).filter(|piece| self.share(*piece) >= at).count();
            for (d, ((_, interval, legal), own)) in
                self.disturbances.iter().zip(&signals).enumerate()
            {
                let kind = signal(legal, own[0]);
                let [bias, size, rate, phase] = wave(d);
                if kind == Signal::Sine {
                    let (low, high) = *interval;
                    let periods = 0.5 * 100f64.powf(own[1 + PIECES]);
                    values.set(bias, 0.5 * (low + high));
                    values.set(size, 0.5 * (high - low));
                    values.set(rate, TAU * periods / values.get(Parameter::Tau));
                    values.set(phase, TAU * own[2 + PIECES]);
                } else {
                    values.set(bias, between(*interval, level(kind, own, at, piece)));
                    [size, rate, phase].into_iter().for_each(|symbol| values.set(symbol, 0.0));
                }
            }
            let instants =
                grid.iter().copied().filter(|share| (*share < from || from == 1.0) && *share >= to);
            pieces.push((instants.collect(), values));
            from = to;
        }
        let values = pieces.first().map_or(values, |(_, values)| values.clone());
        Setting { values, x0, pieces }
    }

    /// The plant with a wave of run-time symbols in place of each disturbance.
    pub(super) fn disturbed(&self) -> Plant {
        let wave = |e: &Expression| {
            let (d, (_, _, signals)) = self
                .disturbances
                .iter()
                .enumerate()
                .find(|(_, (symbol, ..))| *e == Expression::Parameter(*symbol))?;
            let [bias, size, rate, phase] = wave(d).map(Expression::from);
            if !signals.contains(&Signal::Sine) {
                return Some(bias);
            }
            let angle = rate.mul(Variable::Elapsed.into()).add(phase);
            Some(bias.add(size.mul(Expression::call(Function::Sin, angle))))
        };
        let mut plant = self.plant.clone();
        plant.f = plant.f.substitute(&wave);
        plant.g = plant.g.map(|g| g.substitute(&wave));
        plant
    }
}

/// The symbols of a disturbance: bias + size sin(rate dt + phase).
fn wave(d: usize) -> [Parameter; 4] {
    ["bias", "size", "rate", "phase"].map(|part| {
        let name = Name::new(&format!("ptc_disturbance{d}_{part}"));
        name.map_or(Parameter::StartTime, Parameter::Named)
    })
}

/// What divides a step of the grid evenly.
fn divided(step: &[f64], parts: u32) -> impl Iterator<Item = f64> + use<> {
    let (from, to) = (step[0], step[1]);
    (1..parts).map(move |part| from + (to - from) * (f64::from(part) / f64::from(parts)))
}

fn between((low, high): Interval, part: f64) -> f64 {
    // Both ends are met exactly.
    low * (1.0 - part) + high * part
}

fn middle(from: f64, to: f64) -> f64 {
    (from * to).sqrt()
}

fn signal(legal: &[Signal], part: f64) -> Signal {
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let place = (part * legal.len() as f64) as usize;
    legal.get(place).or(legal.last()).copied().unwrap_or(Signal::Constant)
}

/// Where in its bounds a signal is in a piece around T/tau = `share`.
fn level(kind: Signal, own: &[f64], share: f64, piece: usize) -> f64 {
    let corner = |c: f64| if c >= 0.5 { 1.0 } else { 0.0 };
    match kind {
        Signal::Constant => own[1],
        Signal::Sine => {
            let periods = 0.5 * 100f64.powf(own[1 + PIECES]);
            0.5 + 0.5 * (TAU * (periods * (1.0 - share) + own[2 + PIECES])).sin()
        }
        Signal::Square => {
            let turns = (half_periods(own) * (1.0 - share) + 2.0 * own[2 + PIECES]).floor();
            if turns % 2.0 == 0.0 { 1.0 } else { 0.0 }
        }
        Signal::Random => own[1 + piece],
        Signal::Worst => corner(own[1 + piece]),
    }
}

/// Half periods of a square in tau, from 1 to 16.
fn half_periods(own: &[f64]) -> f64 {
    1.0 + (15.0 * own[1 + PIECES]).round()
}

/// T/tau where a square jumps.
fn jumps(own: &[f64]) -> impl Iterator<Item = f64> {
    let (count, phase) = (half_periods(own), 2.0 * own[2 + PIECES]);
    (0..=18).map(move |k| 1.0 - (f64::from(k) - phase) / count)
}
