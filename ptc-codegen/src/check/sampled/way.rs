//! Bounds on the way to the deadline and after it, between the samples too.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::reach::Reach;
use super::trust::Trust;
use super::worst::{Output, Sampled};

/// Operations that the way to the deadline may take: seconds.
const OPERATIONS: f64 = 2e9;

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
pub struct Held {
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

impl Held {
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
        let (n, size) = (self.chain.n, self.size());
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
        let mut way = Way { x: self.x0.clone(), u: 0.0, u_attained: 0.0, u_rms: 0.0 };
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
                    Some(reach) => reach.states[k][i],
                    None => self.bound(&self.state(i + 1), k, trust).total(),
                };
                let most = if k < last { here.max(self.after(i, k, trust)) } else { here };
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
    pub(super) fn held(&self, from: usize, reach: &Reach) -> Option<Held> {
        let mut reach = reach.clone();
        let mut found = None;
        let mut length = 16;
        while self.operations(from + length) <= OPERATIONS {
            self.extend(&mut reach, from + length)?;
            let seen: Vec<_> = (0..self.size())
                .map(|i| reach.states[from..].iter().map(|states| states[i]).fold(0.0, f64::max))
                .collect();
            let acting = reach.acting.iter().skip(from).copied().fold(0.0, f64::max);
            if let Some((rest, later)) = self.rest(seen.clone(), acting, length) {
                let near = rest.x0.iter().zip(&seen).all(|(x, seen)| *x <= (1.0 + CLOSE) * seen);
                found = Some((rest, later, length));
                if near {
                    break;
                }
            }
            length *= 2;
        }
        let (rest, later, length) = found?;
        let sides = [(self, &reach, from, from + length), (&rest, &later, length, length)];
        let control = self.control();
        let mut held = Held { x: rest.x0[..self.chain.n].to_vec(), u: 0.0 };
        for (part, reach, first, last) in sides {
            let trust = Some(Trust::Reach(reach));
            for k in first..=last {
                let u = part.bound(&control, k, trust).total() - part.actuator;
                held.u = held.u.max(u);
                for i in 0..self.chain.n {
                    held.x[i] = held.x[i].max(part.after(i, k, trust));
                }
            }
        }
        Some(held)
    }

    /// The loop as it stays, from states within bounds that it does not leave: at least `most`, and
    /// `acting` of the input. After `length` samples it is within them again.
    fn rest(&self, most: Vec<f64>, acting: f64, length: usize) -> Option<(Self, Reach)> {
        let mut rest = self.last(most);
        let mut reach = Reach {
            states: vec![rest.x0.clone(); length + 1],
            acting: vec![acting; length + 1],
        };
        let acts = self.acts();
        for _ in 0..ROUNDS {
            let trust = Some(Trust::Reach(&reach));
            let total = |output: &Output| rest.bound(output, length, trust).total();
            let states: Vec<_> = (1..=rest.size()).map(|i| total(&rest.state(i))).collect();
            let acting = match rest.gain_error > 0.0 {
                true => total(&acts) + rest.actuator,
                false => 0.0,
            };
            let within = states.iter().zip(&rest.x0).all(|(next, x)| next <= x);
            if within && acting <= reach.acting[0] {
                return Some((rest, reach));
            }
            let wider = |next: &f64, x: &f64| if next <= x { *x } else { next * (1.0 + 1e-4) };
            rest.x0 = states.iter().zip(&rest.x0).map(|(next, x)| wider(next, x)).collect();
            let acting = wider(&acting, &reach.acting[0]);
            reach = Reach {
                states: vec![rest.x0.clone(); length + 1],
                acting: vec![acting; length + 1],
            };
        }
        None
    }

    /// Bound of |x_{i+1}| between sample `k` and the next, of a chain.
    fn after(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        if self.chain.outputs.is_some() {
            return 0.0;
        }
        // f and an error of the gain add at most what they do in a whole sample.
        let (value, error) = self.force.as_ref().map_or((0.0, 0.0), |force| force.column[i]);
        let of_force = self.force.as_ref().map_or(0.0, |force| force.most() * (value + error));
        let (value, error) = self.chain.input[i];
        let of_gain = (value.abs() + error) * self.of_gain(trust, k);
        let points = self.between(i);
        let most = points.iter().map(|point| self.bound(point, k, trust).total());
        most.fold(0.0, f64::max) + of_force + of_gain
    }

    /// The control points of x_{i+1} between two samples in Bernstein's form, of which it is a convex
    /// combination: the inner ones, as the others are its values at the samples. Where something else
    /// acts in the sample, which these values hold, both of them too.
    fn between(&self, i: usize) -> Vec<Output> {
        let (n, size) = (self.chain.n, self.size());
        let degree = n - i;
        let choose = |n: usize, k: usize| {
            (0..k).fold(1.0, |product, j| product * (n - j) as f64 / (j + 1) as f64)
        };
        let point = |r: usize| {
            let mut output = Output { row: vec![0.0; size], direct: 0.0 };
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
            output
        };
        let moved = self.force.is_some() || self.gain_error > 0.0;
        let all = if moved { 0..degree + 1 } else { 1..degree };
        all.map(point).collect()
    }
}

/// Rounds in which bounds are widened until the loop does not leave them.
const ROUNDS: u32 = 12;
