//! Bounds on the way to the deadline and after it, between the samples too.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::reach::Reach;
use super::trust::Trust;
use super::worst::{Output, Sampled};

/// Operations that the way to the deadline may take: seconds.
const OPERATIONS: f64 = 2e9;

/// Operations that bounds after the deadline may always take.
const AFTER: f64 = 2e6;

/// By how much bounds may be apart that count as the same.
const CLOSE: f64 = 1e-3;

/// Bounds that hold from t0 to the deadline, of a chain between the samples too.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Of each |x_i|.
    pub x: Vec<f64>,
    /// Of |u|.
    pub u: f64,
    /// What |u| reaches at least.
    pub u_attained: f64,
    /// The greatest standard deviation of u by random noise.
    pub u_rms: f64,
}

/// Bounds that hold from the deadline on, of a chain between the samples too.
#[derive(Clone, Debug, PartialEq)]
pub struct Afterwards {
    /// Of each |x_i|.
    pub x: Vec<f64>,
    /// Of |u|.
    pub u: f64,
}

impl Way {
    /// The greater of two bounds.
    pub(super) fn most(self, other: &Self) -> Self {
        Self {
            x: larger(self.x, &other.x),
            u: self.u.max(other.u),
            u_attained: self.u_attained.max(other.u_attained),
            u_rms: self.u_rms.max(other.u_rms),
        }
    }
}

impl Afterwards {
    /// The greater of two bounds.
    pub(super) fn most(self, other: &Self) -> Self {
        Self { x: larger(self.x, &other.x), u: self.u.max(other.u) }
    }
}

/// The larger number of each pair.
pub(super) fn larger(a: Vec<f64>, b: &[f64]) -> Vec<f64> {
    a.into_iter().zip(b).map(|(a, b)| a.max(*b)).collect()
}

impl Sampled {
    /// The bounds on the way, over all samples up to `last` and the polynomials between them.
    pub(super) fn way(&self, last: usize, reach: Option<&Reach>) -> Option<Way> {
        let (n, size) = (self.chain.moved, self.size());
        let outputs = n + 1 + n * (n - 1) / 2;
        let count = last as f64;
        if 0.5 * count * count * (outputs * (size * size + 4 * size)) as f64 > OPERATIONS {
            return None;
        }
        let fading = match reach {
            Some(_) => None,
            None => Some(self.fading(None, last)?),
        };
        let trust = reach.map(Trust::Reach).or(fading.as_ref().map(Trust::Fading));
        let mut way = Way { x: self.x0[..n].to_vec(), u: 0.0, u_attained: 0.0, u_rms: 0.0 };
        let control = self.control();
        for k in 0..=last {
            if k < last {
                let mut bound = self.bound(&control, k, trust);
                // The command, before the actuator rounds it.
                bound.actuator -= self.actuator;
                way.u = way.u.max(bound.total());
                way.u_attained = way.u_attained.max(bound.attained());
                way.u_rms = way.u_rms.max(bound.rms);
            }
            for i in 0..n {
                let here = match reach {
                    Some(reach) => reach.states[k][i] + self.of_early_switch(i, k, reach),
                    None => self.bound(&self.state(i + 1), k, trust).total(),
                };
                let most = if k < last { here.max(self.until_next(i, k, trust)) } else { here };
                way.x[i] = way.x[i].max(most);
            }
        }
        let finite = way.u.is_finite() && way.x.iter().all(|x| x.is_finite());
        finite.then_some(way)
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
        let control = self.control();
        let mut after = Afterwards { x: rest.x0[..self.chain.moved].to_vec(), u: 0.0 };
        let mut see = |part: &Self, reach: &Reach, k: usize| {
            let trust = Some(Trust::Reach(reach));
            after.u = after.u.max(part.bound(&control, k, trust).total() - part.actuator);
            for (i, x) in after.x.iter_mut().enumerate() {
                *x = x.max(part.until_next(i, k, trust));
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
        let count = length + 1;
        for _ in 0..ROUNDS {
            let reach = Reach {
                states: vec![rest.x0.clone(); count],
                acting: vec![acting; count],
                change: vec![change; count],
                drift: vec![rest.drift(&rest.x0, acting); count],
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

    /// Bound of |x_{i+1}| between sample `k` and the next, of a chain.
    fn until_next(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        if self.chain.outputs.is_some() {
            return 0.0;
        }
        let points = self.between(i).into_iter();
        let most = points.map(|(point, is_last)| {
            let more = if is_last { self.of_whole(i, k, trust) } else { 0.0 };
            self.bound(&point, k, trust).total() + more
        });
        most.fold(0.0, f64::max) + self.of_switches(i, k, trust)
    }

    /// The control points of x_{i+1} between two samples in Bernstein's form, of which it is a convex
    /// combination, and whether it is the last one: the inner ones, as the others are its values at the
    /// samples. What acts in the sample beside u grows no faster than the last term of the form: it counts
    /// with the last point. Samples that are not in time make a difference at once.
    fn between(&self, i: usize) -> Vec<(Output, bool)> {
        let (n, size) = (self.chain.n, self.size());
        let degree = n - i;
        let choose = |n: usize, k: usize| {
            (0..k).fold(1.0, |product, j| product * (n - j) as f64 / (j + 1) as f64)
        };
        let point = |r: usize| {
            let mut output = Output { row: vec![0.0; size], direct: 0.0, change: false };
            for l in 0..=r {
                let weight = choose(r, l) / choose(degree, l) * self.chain.shares[l];
                if i + l < n {
                    output.row[i + l] += weight;
                } else {
                    match self.acting {
                        None => output.direct += weight * self.chain.gain,
                        Some(kept) => output.row[kept] += weight * self.chain.gain,
                    }
                }
            }
            (output, r == degree)
        };
        let first = usize::from(self.jitter == 0.0);
        let last = degree + usize::from(self.force.is_some() || self.is_relative());
        (first..last).map(point).collect()
    }
}

/// Rounds in which bounds are widened until the loop does not leave them.
const ROUNDS: u32 = 12;

/// By how much more than needed, as a part of it.
const WIDER: f64 = 1e-4;
