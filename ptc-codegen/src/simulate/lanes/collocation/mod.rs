//! Collocation at Radau's nodes in every lane, for loops that are stiff: where mu' decays like a power,
//! stretched time grows like 1/T, and the loop has left only what the disturbance makes of it.
//!
//! There xi goes like mu'^n f: slowly in sigma, while the time constants of the law are 1/(T kappa') of it.
//! An explicit method has to follow these. Steps that scale them out do not help either: what is left
//! grows like e^(q sigma) beside them, and asks for just as many.
//!
//! A polynomial of time is asked to satisfy the equations at all nodes of a step at once: what decays like a
//! power of time-to-go is close to one, however far time-to-go falls on the step. In a chain, with rates and
//! pace by the part of the step, dy_i = pace y_(i+1), its states follow from the rates K of the last component
//! at the nodes, y_n = y_n(0) + A K and y_i = y_i(0) + A pace y_(i+1), so that a system of NODES equations is
//! what is solved, whatever n is.
//! If the plant and the law are linear its first solution is the exact one.

mod equations;
mod nodes;
mod system;

use super::flow::{Chain, Flow, Steps, Which, share_at};
use crate::program::lanes::{Pack, vectorized};
use crate::simulate::Accuracy;
use equations::Equations;

/// A step is what its error allows times this, and changes by factors between these.
const SAFETY: f64 = 0.9;
const FACTORS: [f64; 2] = [0.2, 4.0];

/// Longest step, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// Ratio of the errors of a step that is tried again, shorter: at more than this the error is rounding of the rates.
/// From there on a step may have that many times it, to the accuracy that is not loosened further or to what rounding
/// leaves of any accuracy.
const FALLEN: f64 = 0.5;
const LOOSER: f64 = 10.0;
const LOOSEST: f64 = 1e-7;

/// Effect of rounding on the highest terms of a polynomial, as a multiple of that on the states: rates at the nodes
/// follow from these by differences.
const ROUNDED: f64 = 1000.0;

/// The method, under way in every lane.
#[derive(Clone, Debug)]
pub(super) struct Collocation {
    flow: Flow,
    equations: Equations,
    /// Start of the last step, and the part by which T falls on it.
    from: Pack,
    fall: Pack,
    /// The error that a step may have, and that of the step that was refused before; 0 for none.
    allowed: Pack,
    refused: Pack,
    /// The error to which that is not loosened further.
    loosest: f64,
}

impl Collocation {
    pub(super) fn new(order: usize, accuracy: Accuracy) -> Self {
        Self {
            flow: Flow::new(order),
            equations: Equations::new(order, accuracy),
            from: Pack::all(0.0),
            fall: Pack::all(0.0),
            allowed: Pack::all(1.0),
            refused: Pack::all(0.0),
            loosest: (LOOSEST / accuracy.relative).max(1.0),
        }
    }
}

impl Steps for Collocation {
    fn flow(&mut self) -> &mut Flow {
        &mut self.flow
    }

    fn begin(&mut self, lanes: &Which, _: &mut dyn Chain) {
        self.allowed.take(&Pack::all(1.0), lanes);
        self.refused.take(&Pack::all(0.0), lanes);
    }

    fn step(&mut self, active: &Which, end: &Pack, chain: &mut dyn Chain) -> Which {
        self.from = self.flow.at;
        let share = share_at(&self.from);
        let (length, cut) = self.flow.lengths(active, end);
        self.fall = length.map(|length| -(-length).exp_m1());
        self.equations.first.copy_from_slice(&self.flow.y);
        self.equations.form((&share, &self.fall), chain);
        let solved = self.equations.solve(active, &self.allowed, chain);
        let error = vectorized!(self.equations.error());
        let rounding = vectorized!(self.equations.rounding());
        std::array::from_fn(|lane| {
            if !active[lane] {
                return false;
            }
            let mut error = error.0[lane] / self.allowed.0[lane];
            let before = std::mem::replace(&mut self.refused.0[lane], 0.0);
            let is_solved = solved[lane];
            if !(is_solved && error <= 1.0) {
                if before > 0.0 && error > FALLEN * before {
                    let more = if is_solved { LOOSER * error } else { LOOSER };
                    let loosest = self.loosest.max(ROUNDED * rounding.0[lane]);
                    let more = more.min((loosest / self.allowed.0[lane]).max(1.0));
                    self.allowed.0[lane] *= more;
                    error /= more;
                } else {
                    self.refused.0[lane] = error;
                }
            }
            let moved = is_solved && error <= 1.0;
            // By the eighth root, or the sixteenth and the 64th: on the safe side of the twelfth.
            let root = error.sqrt().sqrt().sqrt();
            let half = root.sqrt();
            let wanted = SAFETY / if moved { half * half.sqrt().sqrt() } else { root };
            let [least, most] = FACTORS;
            let is_known = is_solved && !wanted.is_nan();
            let factor = if is_known { wanted.clamp(least, most) } else { least };
            let length = length.0[lane];
            let factor = factor.min(LONGEST / length);
            self.flow.go_on(lane, (moved, cut[lane]), (length, factor), end.0[lane]);
            moved
        })
    }

    fn accept(&mut self, moved: &Which, _: &mut dyn Chain) {
        for (y, x) in self.flow.y.iter_mut().zip(self.equations.end()) {
            y.take(x, moved);
        }
    }

    fn within(&mut self, at: &Pack, into: &mut [Pack]) {
        let part = Pack::of(|lane| -(self.from.0[lane] - at.0[lane]).exp_m1() / self.fall.0[lane]);
        vectorized!(self.equations.within(&part, into));
    }
}
