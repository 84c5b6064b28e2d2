//! The worst signals of a loop, and the run that they make.

// Counts become times here.
#![allow(clippy::cast_precision_loss)]

use super::chain::{Step, along};
use super::judge::Loop;
use super::worst::{Output, Sampled, earlier};
use crate::expansion::Expanded;
use crate::request::Spec;

/// A run of the loop in which one state ends as far from 0 as it may, but for rounding, what an uncertain
/// gain and jitter add, and turns of a varying f within a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// The state, from 0: the one that is farthest from what is wanted.
    pub state: usize,
    /// Times of the samples after t0, in s, the deadline last.
    pub t: Vec<f64>,
    /// `x[j]` is state j + 1 at these times.
    pub x: Vec<Vec<f64>>,
    /// The command, as the actuator rounds it.
    pub u: Vec<f64>,
}

/// The worst run of a design; `None` where its loop is not known or u would be clipped.
pub fn trajectory(spec: &Spec, expanded: Option<&Expanded>) -> Option<Trajectory> {
    let closed = Loop::new(spec, expanded).ok()?;
    // Its states are those of e, and r no signal that is chosen.
    closed.followed.is_none().then_some(())?;
    let gain = closed.gain();
    let sampled = closed.disturbed(closed.acting(&gain).ok()?, &gain);
    let count = closed.samples;
    let share = |(i, error): (usize, &f64)| {
        (i, sampled.bound(&sampled.state(i + 1), count, None).attained() / error)
    };
    let errors = closed.errors();
    let shares = errors.iter().enumerate().map(share);
    let (state, _) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let signals = sampled.signals(&sampled.state(state + 1), count);
    let (states, u) = sampled.follow(&signals);
    let limits = closed.limits();
    let is_clipped = u.iter().any(|u| u.is_nan() || *u <= limits.low || *u >= limits.high);
    let column = |j: usize| states.iter().map(|s| s[j]).collect::<Vec<_>>();
    (!is_clipped).then(|| Trajectory {
        state,
        t: (0..=count).map(|k| k as f64 * closed.period.middle()).collect(),
        x: (0..spec.n).map(column).collect(),
        u,
    })
}

/// The signals that attain a bound.
pub(super) struct Signals {
    /// State at the start.
    pub(super) x0: Vec<f64>,
    /// Error of each measured state at each sample, that of the actuator last.
    pub(super) causes: Vec<Vec<f64>>,
    /// f over each sample.
    pub(super) force: Vec<f64>,
}

impl Sampled {
    /// The signals that attain the bound of an output without a change, with f held over each sample.
    pub(super) fn signals(&self, output: &Output, at: usize) -> Signals {
        let mut row = self.row(output, at);
        let mut room = vec![0.0; self.size()];
        let (mut causes, mut force) = (vec![Vec::new(); at + 1], vec![0.0; at + 1]);
        let signed = |seen: f64, limit: f64| if seen < 0.0 { -limit } else { limit };
        let ends = |seen: &dyn Fn(usize) -> f64| {
            self.limits().enumerate().map(|(l, limit)| signed(seen(l), limit)).collect()
        };
        causes[at] = ends(&|l| output.direct * self.of_u(at).1[l].0);
        let mut walk = self.walk(false);
        for k in (0..at).rev() {
            let step = walk.at(k);
            causes[k] = ends(&|l| along(&row, &step.columns[l]));
            force[k] = self.force.as_ref().map_or(0.0, |force| force.signed(step, &row));
            earlier(&step.matrix, &mut row, &mut room);
        }
        let mut x0: Vec<_> = row.iter().zip(&self.x0).map(|(p, x0)| signed(*p, *x0)).collect();
        if let Some(own) = &self.force {
            let whole: f64 = force.iter().sum();
            // The middle of f cannot be turned, so that all else goes with it.
            let side = signed(own.middle * whole, 1.0);
            x0.iter_mut().chain(causes.iter_mut().flatten()).for_each(|w| *w *= side);
            let turned = |seen: f64| signed(whole, own.constant) + signed(seen, own.varying);
            force.iter_mut().for_each(|f| *f = own.middle + side * turned(*f));
        }
        Signals { x0, causes, force }
    }

    /// The states at each sample, with what is kept, and u.
    fn follow(&self, signals: &Signals) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut s = signals.x0.clone();
        s.resize(self.size(), 0.0);
        let (mut states, mut u) = (Vec::new(), Vec::new());
        let mut walk = self.walk(false);
        for (k, (causes, force)) in signals.causes.iter().zip(&signals.force).enumerate() {
            let Step { matrix, columns, u: own, .. } = walk.at(k);
            u.push(along(&s, &own.of_state) + along(causes, &own.of_cause));
            let row = |(i, row): (usize, &[f64])| {
                let own: f64 = row.iter().zip(&s).map(|(entry, s)| entry * s).sum();
                let of_causes: f64 = columns.iter().zip(causes).map(|(c, w)| c[i].0 * w).sum();
                let column = self.force.as_ref().and_then(|force| force.column.get(i));
                own + of_causes + column.map_or(0.0, |(column, _)| column * force)
            };
            let next = matrix.entries.chunks_exact(matrix.size).enumerate().map(row).collect();
            states.push(std::mem::replace(&mut s, next));
        }
        (states, u)
    }
}
