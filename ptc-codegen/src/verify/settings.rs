//! Scenarios as they are run, in the plant's units: what those of a campaign share is computed once.

use std::f64::consts::TAU;

use rand_chacha::ChaCha8Rng;

use super::scenario::wave;
use super::{Campaign, Course, Scenario, Setting};
use crate::parameter::Parameter;
use crate::simulate::{Loop, Piece, SAME, Values};

/// Instants of a run in samples that is looked at closely, about.
const INSTANTS: f64 = 65536.0;

/// The settings of a campaign.
#[derive(Clone, Debug)]
pub(super) struct Settings<'a> {
    campaign: &'a Campaign,
    /// Random generator with which all draws begin.
    random: ChaCha8Rng,
    /// Parts into which each step of the grid is divided.
    parts: u32,
    /// Values that the campaign fixes; the rest is set at its place for each scenario.
    values: Values,
    places: Places,
    /// T/tau of the instants at which objectives are looked at.
    grid: Vec<f64>,
    /// Instants of a run in which nothing jumps.
    whole: Vec<f64>,
}

/// Places of the values of a scenario.
#[derive(Clone, Debug)]
struct Places {
    tau: usize,
    intervals: Vec<usize>,
    /// eps, where nothing gives it.
    eps: Option<usize>,
    /// The wave of each disturbance.
    waves: Vec<[usize; 4]>,
}

impl<'a> Settings<'a> {
    pub(super) fn of(campaign: &'a Campaign, parts: u32) -> Self {
        let mut values = Values::of(&campaign.spec, &campaign.plant);
        let symbols = campaign.intervals.iter().map(|(symbol, _)| *symbol);
        let given = values.get(Parameter::Eps).is_finite()
            || symbols.clone().any(|symbol| symbol == Parameter::Eps);
        // The side that is emitted code must not hold its gains before the run ends.
        let eps = (!given && campaign.around.is_none()).then_some(Parameter::Eps);
        let waves = (0..campaign.disturbances.len()).map(wave);
        // Names move places, so that all are there before the first place is asked for.
        let all = symbols.clone().chain(eps).chain([Parameter::Tau]).chain(waves.clone().flatten());
        all.for_each(|symbol| _ = values.named(symbol));
        let mut place = |symbol: Parameter| values.named(symbol);
        let places = Places {
            tau: place(Parameter::Tau),
            intervals: symbols.map(&mut place).collect(),
            eps: eps.map(&mut place),
            waves: waves.map(|wave| wave.map(&mut place)).collect(),
        };
        let grid = campaign.grid();
        let random = campaign.random();
        let mut own = Self { campaign, random, parts, values, places, grid, whole: Vec::new() };
        let until = campaign.span();
        own.whole = own.divided(&[until]);
        own.whole.retain(|share| *share >= until);
        own
    }

    /// The draw of an index.
    pub(super) fn scenario(&self, index: u64) -> Scenario {
        self.campaign.drawn_from(self.random.clone(), index)
    }

    /// A scenario in the plant's units.
    pub(super) fn setting(&self, scenario: &Scenario) -> Setting {
        let Self { campaign, places, .. } = self;
        let (tau, rest) = scenario.point.split_first().unwrap_or((&f64::NAN, &[]));
        let (x0, constants) = rest.split_at(campaign.x0.len());
        let mut values = self.values.clone();
        values.put(places.tau, *tau);
        for (place, value) in places.intervals.iter().zip(constants) {
            values.put(*place, *value);
        }
        if let Some(place) = places.eps {
            values.put(place, 0.5 * campaign.until * tau);
        }
        let pieces = self.pieces(scenario, &values, *tau);
        let values = pieces.first().map_or(values, |(_, values)| values.clone());
        let around = self.around(scenario.seed, *tau, &constants[campaign.intervals.len()..]);
        Setting { values, x0: x0.to_vec(), pieces, around }
    }

    /// The sampled loop of a run, with the true gain, where it is not known, and the numbers of the events.
    fn around(&self, seed: u64, tau: f64, drawn: &[f64]) -> Option<Loop> {
        let Self { campaign, .. } = self;
        let around = campaign.around.as_ref()?;
        let (gain, drawn) = match (campaign.gains(), drawn.split_first()) {
            (Some(_), Some((gain, rest))) => ([*gain; 2], rest),
            _ => (around.gain, drawn),
        };
        let until = end(campaign.until, tau, around.period);
        let own = Loop {
            gain,
            seed,
            until: (!campaign.follows_deadline()).then_some(until),
            events: campaign.events.with(drawn),
            ..around.clone()
        };
        let length = own.until.unwrap_or_else(|| own.planned(tau));
        let parts = self.parts.min(parts_of(length / around.period));
        Some(Loop { parts, ..own })
    }

    /// T/tau of the instants of each piece between jumps, with the values that hold in it.
    fn pieces(&self, scenario: &Scenario, values: &Values, tau: f64) -> Vec<Piece> {
        let until = self.campaign.span();
        let jumps = scenario.courses.iter().flat_map(|course| course.jumps(until));
        let mut breaks: Vec<_> = jumps.chain([until]).collect();
        breaks.retain(|share| (until..1.0).contains(share));
        breaks.sort_by(|a, b| b.total_cmp(a));
        breaks.dedup();
        if breaks == [until] && scenario.at.is_none() {
            return vec![(self.whole.clone(), self.within(scenario, values, tau, (1.0, until)))];
        }
        let grid = self.divided(&[&breaks[..], scenario.at.as_slice()].concat());
        let (mut from, mut pieces) = (1.0, Vec::with_capacity(breaks.len()));
        for to in breaks {
            let instants =
                grid.iter().copied().filter(|share| (*share < from || from == 1.0) && *share >= to);
            pieces.push((instants.collect(), self.within(scenario, values, tau, (from, to))));
            from = to;
        }
        pieces
    }

    /// The values that hold between two T/tau.
    fn within(
        &self,
        scenario: &Scenario,
        values: &Values,
        tau: f64,
        (from, to): (f64, f64),
    ) -> Values {
        let mut values = values.clone();
        let courses = self.campaign.disturbances.iter().zip(&scenario.courses);
        for (places, ((_, bounds, _), course)) in self.places.waves.iter().zip(courses) {
            let numbers = match course {
                Course::Sine(periods, turns) => {
                    let (low, high) = *bounds;
                    let (bias, size) = (0.5 * (low + high), 0.5 * (high - low));
                    [bias, size, TAU * periods / tau, TAU * turns]
                }
                course => {
                    let at = (from * to).sqrt();
                    [course.value(*bounds, self.campaign.span(), at), 0.0, 0.0, 0.0]
                }
            };
            places.iter().zip(numbers).for_each(|(place, number)| values.put(*place, number));
        }
        values
    }

    /// The grid with these instants, each of its steps divided, from the largest T/tau on.
    fn divided(&self, breaks: &[f64]) -> Vec<f64> {
        let mut grid = [self.grid.as_slice(), breaks].concat();
        grid.sort_by(|a, b| b.total_cmp(a));
        grid.dedup();
        if self.parts > 1 {
            let within: Vec<_> =
                grid.windows(2).flat_map(|step| divided(step, self.parts)).collect();
            grid.extend(within);
            grid.sort_by(|a, b| b.total_cmp(a));
        }
        grid
    }
}

/// When a run of the loop ends after t0: at the deadline, or at the first sample from T/tau = `until` on. What is bounded
/// at the samples says nothing of an instant between two.
fn end(until: f64, tau: f64, period: f64) -> f64 {
    match until {
        0.0 => tau,
        until => (tau * (1.0 - until) / period * (1.0 - SAME)).ceil() * period,
    }
}

/// Parts of a sample that are looked at, of a run of so many samples.
fn parts_of(samples: f64) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let parts = (INSTANTS / samples) as u32;
    parts.max(1)
}

/// Returns the instants that divide a step of the grid evenly.
fn divided(step: &[f64], parts: u32) -> impl Iterator<Item = f64> + use<> {
    let (from, to) = (step[0], step[1]);
    (1..parts).map(move |part| from + (to - from) * (f64::from(part) / f64::from(parts)))
}
