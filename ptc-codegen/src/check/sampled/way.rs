//! Bounds on the way to the deadline and after it, between the samples too.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::between::Between;
use super::reach::Reach;
use super::span::{Span, hulls, sizes};
use super::trust::Trust;
use super::worst::{Output, Sampled};

/// Operations that the way to the deadline may take: seconds.
const OPERATIONS: f64 = 2e9;

/// Operations that bounds after the deadline may always take.
const AFTER: f64 = 2e6;

/// Relative difference up to which bounds count as the same.
const CLOSE: f64 = 1e-3;

/// Bounds that hold from t0 to the deadline.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Bound of each |x_i|.
    pub x: Vec<f64>,
    /// Interval of each x_i.
    pub within: Vec<Span>,
    /// True if they hold between the samples too.
    pub between: bool,
    /// Bound of |u|, the command until the deadline.
    pub u: f64,
    /// Interval of the command until the deadline.
    pub commands: Span,
    /// Interval of the input that acts, as the actuator resolves it, including the sample at the deadline.
    pub acts: Span,
    /// Interval of each requested sum; empty where they are not bounded as sums.
    pub sums: Vec<Span>,
    /// Lower bound of the worst |u|.
    pub u_attained: f64,
    /// The greatest standard deviation of u by random noise.
    pub u_rms: f64,
}

/// Bounds that hold from the deadline on.
#[derive(Clone, Debug, PartialEq)]
pub struct Afterwards {
    /// Bound of each |x_i|.
    pub x: Vec<f64>,
    /// True if they hold between the samples too.
    pub between: bool,
    /// Bound of |u|.
    pub u: f64,
    /// Bound of the size of the input that acts, as the actuator resolves it.
    pub acts: f64,
}

impl Way {
    /// The greater of two bounds.
    pub(super) fn most(self, other: &Self) -> Self {
        Self {
            x: larger(self.x, &other.x),
            within: hulls(&self.within, &other.within),
            between: self.between && other.between,
            u: self.u.max(other.u),
            commands: self.commands.hull(other.commands),
            acts: self.acts.hull(other.acts),
            sums: hulls(&self.sums, &other.sums),
            u_attained: self.u_attained.max(other.u_attained),
            u_rms: self.u_rms.max(other.u_rms),
        }
    }
}

impl Way {
    /// Combines two bounds of the same loop into the tighter one; at the samples alone the second one refers to their
    /// actual times.
    pub(super) fn least(self, other: Self) -> Self {
        let u = self.u.min(other.u);
        let u_attained = self.u_attained.max(other.u_attained);
        let acts = self.acts.common(other.acts);
        let commands = self.commands.common(other.commands);
        if !(self.between && other.between) {
            return Self { u, commands, acts, u_attained, ..other };
        }
        let both = self.within.iter().zip(&other.within);
        let within: Vec<_> = both.map(|(a, b)| a.common(*b)).collect();
        Self { x: sizes(&within), within, u, commands, acts, u_attained, ..other }
    }

    /// Returns true if u is never clipped to its limits.
    pub(super) fn is_within(&self, limits: Span) -> bool {
        match limits.low == -limits.high {
            true => self.u < limits.high,
            false => limits.low < self.commands.low && self.commands.high < limits.high,
        }
    }
}

impl Afterwards {
    /// Combines two bounds of the same loop into the tighter one; at the samples alone the second one refers to their
    /// actual times.
    pub(super) fn least(self, other: Self) -> Self {
        let (u, acts) = (self.u.min(other.u), self.acts.min(other.acts));
        if !(self.between && other.between) {
            return Self { u, acts, ..other };
        }
        let x = self.x.iter().zip(&other.x).map(|(a, b)| a.min(*b)).collect();
        Self { x, u, acts, ..other }
    }

    /// The greater of two bounds.
    pub(super) fn most(self, other: &Self) -> Self {
        Self {
            x: larger(self.x, &other.x),
            between: self.between && other.between,
            u: self.u.max(other.u),
            acts: self.acts.max(other.acts),
        }
    }
}

/// The larger number of each pair.
pub(super) fn larger(a: Vec<f64>, b: &[f64]) -> Vec<f64> {
    a.into_iter().zip(b).map(|(a, b)| a.max(*b)).collect()
}

impl Sampled {
    /// The bounds on the way, over all samples up to `last`, and between them where the time allows.
    pub(super) fn way(&self, last: usize, reach: Option<&Reach>) -> Option<Way> {
        let n = self.chain.moved;
        let fits = |outputs: usize| self.of_outputs(outputs, 0.5 * (last * last) as f64);
        self.is_short(last).then_some(())?;
        let between = self.between.as_ref().filter(|between| fits(n + 1 + between.outputs()));
        let all = |between: &Between| n + 1 + between.outputs() + self.outputs_of_sums();
        let sums = between.is_some_and(|between| self.knows_sums() && fits(all(between)));
        let fading = match reach {
            Some(_) => None,
            None => Some(self.fading(None, last)?),
        };
        let trust = reach.map(Trust::Reach).or(fading.as_ref().map(Trust::Fading));
        let start = self.middle.iter().zip(&self.x0);
        let start = start.map(|(middle, x0)| Span { low: *middle, high: *middle }.wider(*x0));
        let mut way = Way {
            x: Vec::new(),
            within: start.take(n).collect(),
            between: between.is_some(),
            u: 0.0,
            commands: Span { low: f64::INFINITY, high: f64::NEG_INFINITY },
            acts: Span::default(),
            sums: Vec::new(),
            u_attained: 0.0,
            u_rms: 0.0,
        };
        let control = self.control();
        let mut before: Option<Vec<Span>> = None;
        for k in 0..=last {
            let bound = self.bound(&control, k, trust);
            // A command that is late acts after the deadline.
            if k < last || self.acting().is_none() {
                way.acts = way.acts.hull(bound.span());
            }
            if k < last {
                let mut bound = bound;
                // The command, before the actuator rounds it.
                bound.actuator -= self.actuator;
                // What rho takes may be of the other sign.
                let rate = self.moved.as_ref().map_or(0.0, |moved| moved.input);
                way.u = way.u.max(bound.total() + rate);
                way.commands = way.commands.hull(bound.span().wider(rate));
                way.u_attained = way.u_attained.max(bound.at_least() - rate);
                way.u_rms = way.u_rms.max(bound.rms);
            }
            let here = |i: usize| match reach {
                Some(reach) => reach.spans[k][i].wider(self.of_early_switch(i, k, reach)),
                None => self.bound(&self.state(i + 1), k, trust).span(),
            };
            let here: Vec<_> = (0..n).map(here).collect();
            way.within = hulls(&way.within, &here);
            if sums {
                let own = self.sums(k, k < last, &here, trust);
                way.sums = if k == 0 { own } else { hulls(&way.sums, &own) };
            }
            if let Some((between, before)) = between.zip(before) {
                let ends = [before.as_slice(), &here];
                way.within = hulls(&way.within, &self.until_next(between, k - 1, ends, trust));
            }
            before = Some(here);
        }
        way.x = sizes(&way.within);
        let finite = way.u.is_finite() && way.x.iter().all(|x| x.is_finite());
        finite.then_some(way)
    }

    /// Returns true if the time allows for bounds of the plant and of u at each sample.
    pub(super) fn is_short(&self, last: usize) -> bool {
        self.of_outputs(self.chain.moved + 1, 0.5 * (last * last) as f64)
    }

    /// Returns true if the time allows for so many outputs at samples that have `samples` before them in all.
    fn of_outputs(&self, outputs: usize, samples: f64) -> bool {
        let size = self.size();
        samples * (outputs * (size * size + 4 * size)) as f64 <= OPERATIONS
    }

    /// Bounds from sample `from` on, where the loop no longer changes; `None` where none are found.
    ///
    /// With s_{k+J} = M^J s_k + what J samples add, bounds that hold at J samples in a row, and by this
    /// equation at the next one, hold at all later ones.
    pub(super) fn afterwards(&self, from: usize, reach: &Reach) -> Option<Afterwards> {
        let mut reach = reach.clone();
        let mut found = None;
        let mut length = 16;
        let most = (4.0 * self.operations(from)).clamp(AFTER, OPERATIONS);
        while self.operations(from + length) <= most {
            self.extend(&mut reach, from + length)?;
            if let Some((rest, later)) = self.rest(&reach, from, length) {
                let near = (0..self.size()).all(|i| {
                    let seen = reach.states[from..].iter().map(|states| states[i]);
                    rest.x0[i] <= (1.0 + CLOSE) * seen.fold(0.0, f64::max)
                });
                found = Some((rest, later, length));
                if near {
                    break;
                }
            }
            length *= 2;
        }
        let (rest, later, length) = found?;
        let fits = |between: &&Between| {
            self.of_outputs(between.outputs(), (length * (from + length)) as f64)
        };
        let between = self.between.as_ref().filter(fits);
        let control = self.control();
        let x = rest.x0[..self.chain.moved].to_vec();
        let mut after = Afterwards { x, between: between.is_some(), u: 0.0, acts: 0.0 };
        let mut see = |part: &Self, reach: &Reach, k: usize| {
            let trust = Some(Trust::Reach(reach));
            let acts = part.bound(&control, k, trust).total();
            after.u = after.u.max(acts - part.actuator);
            after.acts = after.acts.max(acts);
            let next = reach.states.get(k + 1).unwrap_or(&rest.x0);
            let ends = [&reach.states[k], next]
                .map(|sizes| sizes.iter().map(|size| Span::of_size(*size)).collect::<Vec<_>>());
            let ends = ends.each_ref().map(Vec::as_slice);
            let seen = between.map(|between| part.until_next(between, k, ends, trust));
            if let Some(seen) = seen {
                after.x = larger(std::mem::take(&mut after.x), &sizes(&seen));
            }
        };
        (from..from + length).for_each(|k| see(self, &reach, k));
        see(&rest, &later, length);
        let finite = after.u.is_finite() && after.x.iter().all(|x| x.is_finite());
        finite.then_some(after)
    }

    /// The loop as it stays, from states within bounds that it does not leave: at least those of `seen`
    /// from sample `from` on. After `length` samples it is within them again.
    fn rest(&self, seen: &Reach, from: usize, length: usize) -> Option<(Self, Reach)> {
        let most = |bounds: &[f64]| bounds.iter().skip(from).copied().fold(0.0, f64::max);
        let column =
            |rows: &[Vec<f64>], i: usize| most(&rows.iter().map(|row| row[i]).collect::<Vec<_>>());
        let x0 = (0..self.size()).map(|i| column(&seen.states, i)).collect();
        let mut rest = self.last(x0);
        let (mut acting, mut change) = (most(&seen.acting), most(&seen.change));
        let (count, step) = (length + 1, rest.step(0));
        for _ in 0..ROUNDS {
            let reach = Reach {
                states: vec![rest.x0.clone(); count],
                spans: Vec::new(),
                acting: vec![acting; count],
                change: vec![change; count],
                drift: vec![rest.drift(&rest.x0, acting); count],
                moves: vec![rest.moves(&rest.x0, acting, false); count],
                inexact: rest.inexact(&step, &rest.x0, acting).repeat(count),
                ..Reach::default()
            };
            let total =
                |output: &Output| rest.bound(output, length, Some(Trust::Reach(&reach))).total();
            let mut fits = true;
            let mut widen = |bound: f64, next: f64| {
                fits &= next <= bound;
                if next <= bound { bound } else { next * (1.0 + WIDER) }
            };
            let states: Vec<_> = (1..=rest.size()).map(|i| total(&rest.state(i))).collect();
            let wider = states.iter().zip(&rest.x0).map(|(next, x)| widen(*x, *next)).collect();
            let next = rest.inputs(&reach, length);
            (acting, change) = (widen(acting, next.0), widen(change, next.1));
            if fits {
                return Some((rest, reach));
            }
            rest.x0 = wider;
        }
        None
    }
}

/// Rounds in which bounds are widened until the loop does not leave them.
const ROUNDS: u32 = 12;

/// Relative excess over the required value.
const WIDER: f64 = 1e-4;
