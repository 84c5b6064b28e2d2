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
//! Where the plant and the law are linear its first solution is the exact one.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use std::sync::Arc;

use super::flow::{Chain, Flow, Steps, Tick, Which};
use super::nodes::{NODES, Nodes};
use super::system::{System, integrated};
use crate::program::lanes::{LANES, Pack};
use crate::simulate::Accuracy;

/// A step is what its error allows times this, and changes by factors between these.
const SAFETY: f64 = 0.9;
const FACTORS: [f64; 2] = [0.2, 4.0];

/// The part of the state at the begin of a step that counts for its size, beside that at the end.
const START: f64 = 0.1;

/// Longest step, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// The difference by which a slope is formed, as a part of the state.
const MOVED: f64 = 1e-6;

/// A component of no size is moved as if it were this part of the largest one.
const SMALL: f64 = 1e-3;

/// What is left of the equations counts as nothing below this part of the error of a step.
const SOLVED: f64 = 0.05;

/// Corrections after which the equations count as not solved.
const ROUNDS: usize = 8;

/// Where the error of a step that is tried again, shorter, has not fallen to this part, it is the rounding of
/// the rates: from there on a step may have that many times it, to the accuracy that is not loosened further.
const FALLEN: f64 = 0.5;
const LOOSER: f64 = 10.0;
const LOOSEST: f64 = 1e-7;

/// The method, under way in every lane.
#[derive(Clone, Debug)]
pub(super) struct Collocation {
    nodes: Arc<Nodes>,
    accuracy: Accuracy,
    flow: Flow,
    /// The last step: where it begins, T/tau there, its length and by what part T falls on it.
    from: Pack,
    share: Pack,
    length: Pack,
    fall: Pack,
    /// The error that a step may have, and that of the step that was refused before; 0 for none.
    allowed: Pack,
    refused: Pack,
    /// The state at its begin, and the states at its nodes, by components.
    first: Vec<Pack>,
    x: Vec<[Pack; NODES]>,
    /// Rates of the last component at the nodes.
    k: [Pack; NODES],
    /// At each node: how fast the chain goes, and the slopes of the last rate by the components.
    pace: [Pack; NODES],
    slopes: Vec<[Pack; NODES]>,
    /// By which part of the step each last rate is computed later.
    late: [Pack; NODES],
    system: System,
}

const NONE: [Pack; NODES] = [Pack::all(0.0); NODES];

impl Collocation {
    pub(super) fn new(order: usize, accuracy: Accuracy) -> Self {
        Self {
            nodes: Arc::new(Nodes::new(order)),
            accuracy,
            flow: Flow::new(order),
            from: Pack::all(0.0),
            share: Pack::all(1.0),
            length: Pack::all(0.0),
            fall: Pack::all(0.0),
            allowed: Pack::all(1.0),
            refused: Pack::all(0.0),
            first: vec![Pack::all(0.0); order],
            x: vec![NONE; order],
            k: NONE,
            pace: NONE,
            slopes: vec![NONE; order],
            late: NONE,
            system: System::new(),
        }
    }

    /// T/tau at a node.
    fn share(&self, node: usize) -> Pack {
        let place = self.nodes.places[node];
        Pack::of(|lane| self.share.0[lane] * (1.0 - place * self.fall.0[lane]))
    }

    /// sigma by the part of the step at a node.
    fn factor(&self, node: usize) -> Pack {
        let place = self.nodes.places[node];
        self.fall.map(|fall| fall / (1.0 - place * fall))
    }

    /// Of the pace and the last rate at a node, by sigma, those by the part of the step.
    fn on_step(&self, node: usize, rates: [Pack; 2]) -> [Pack; 2] {
        let factor = self.factor(node);
        rates.map(|rate| Pack::of(|lane| factor.0[lane] * rate.0[lane]))
    }

    /// The state where the last rate of a node is computed, which is that of the node but for the rounding of time.
    /// Near the deadline the law amplifies that by far more than the accuracy of a step.
    fn computed(&self, node: usize, state: &mut [Pack]) {
        let late = &self.late[node];
        for (i, state) in state.iter_mut().enumerate() {
            let pace = &self.pace[node];
            let rate = match self.x.get(i + 1) {
                Some(x) => Pack::of(|lane| pace.0[lane] * x[node].0[lane]),
                None => self.k[node],
            };
            let x = &self.x[i][node];
            *state = Pack::of(|lane| x.0[lane] + late.0[lane] * rate.0[lane]);
        }
    }

    /// The states that follow from the last rates.
    fn follow(&mut self) {
        let mut rate = self.k;
        for (x, first) in self.x.iter_mut().zip(&self.first).rev() {
            *x = integrated(&rate, &self.nodes.integrals);
            for node in 0..NODES {
                for lane in 0..LANES {
                    x[node].0[lane] += first.0[lane];
                    rate[node].0[lane] = self.pace[node].0[lane] * x[node].0[lane];
                }
            }
        }
    }

    /// The equations, linear around the state at the begin of the step, and their first solution.
    fn begin_step(&mut self, chain: &mut dyn Chain) {
        let mut state = self.first.clone();
        let mut right = NONE;
        for node in 0..NODES {
            let share = self.share(node);
            let base;
            [self.pace[node], base] =
                self.on_step(node, chain.last(&share, &state, Tick::Kept(node)));
            for i in 0..state.len() {
                let own = state[i];
                let size = Pack::of(|lane| {
                    let most = state.iter().fold(0.0_f64, |most, y| most.max(y.0[lane].abs()));
                    MOVED * own.0[lane].abs().max(SMALL * most).max(f64::MIN_POSITIVE / MOVED)
                });
                state[i] = Pack::of(|lane| own.0[lane] + size.0[lane]);
                let [_, there] = self.on_step(node, chain.last(&share, &state, Tick::Again));
                self.slopes[i][node] = Pack::of(|lane| {
                    (there.0[lane] - base.0[lane]) / (state[i].0[lane] - own.0[lane])
                });
                state[i] = own;
            }
            right[node] = base;
            let factor = self.factor(node);
            let late = chain.late(&share);
            self.late[node] = Pack::of(|lane| late.0[lane] / factor.0[lane]);
        }
        self.k = NONE;
        self.follow();
        for ((off, slopes), first) in self.x.iter().zip(&self.slopes).zip(&self.first) {
            for node in 0..NODES {
                for lane in 0..LANES {
                    let off = off[node].0[lane] - first.0[lane];
                    right[node].0[lane] += slopes[node].0[lane] * off;
                }
            }
        }
        self.system.form(&self.nodes, (&self.pace, chain.is_even()), &self.slopes);
        self.system.solve(&mut right);
        self.k = right;
        self.follow();
    }

    /// A lane keeps its numbers from where its equations are solved; the lanes in which they are.
    fn solve(&mut self, active: &Which, chain: &mut dyn Chain) -> Which {
        let mut left = *active;
        let mut state = self.first.clone();
        // Of the first solution, from the state at the begin of the step.
        let mut before = self.change(|i, _| &self.first[i]);
        for _ in 0..ROUNDS {
            let mut right = NONE;
            for node in 0..NODES {
                self.computed(node, &mut state);
                let tick = Tick::Of(node);
                let [_, rate] = self.on_step(node, chain.last(&self.share(node), &state, tick));
                right[node] = Pack::of(|lane| rate.0[lane] - self.k[node].0[lane]);
            }
            self.system.solve(&mut right);
            for node in 0..NODES {
                for lane in (0..LANES).filter(|lane| left[*lane]) {
                    self.k[node].0[lane] += right[node].0[lane];
                }
            }
            let old = self.x.clone();
            self.follow();
            let change = self.change(|i, node| &old[i][node]);
            for lane in 0..LANES {
                let (change, before) = (change.0[lane], before.0[lane]);
                // Each round leaves the same part of what was left.
                let next = if change < before { change * (change / before) } else { change };
                let solved = change.min(next) <= SOLVED * self.allowed.0[lane];
                left[lane] &= !solved;
            }
            before = change;
            if left == [false; LANES] {
                break;
            }
        }
        std::array::from_fn(|lane| active[lane] && !left[lane])
    }

    /// How far the states are from others, as a part of what an error counts; infinite for what is no number.
    fn change<'a>(&'a self, other: impl Fn(usize, usize) -> &'a Pack) -> Pack {
        let mut most = Pack::all(0.0);
        for (i, (x, weight)) in self.x.iter().zip(self.weights()).enumerate() {
            for node in 0..NODES {
                let other = other(i, node);
                for lane in 0..LANES {
                    let part = (x[node].0[lane] - other.0[lane]).abs() * weight.0[lane];
                    let part = if part.is_nan() { f64::INFINITY } else { part };
                    most.0[lane] = most.0[lane].max(part);
                }
            }
        }
        most
    }

    /// Of each component what an error counts.
    fn weights(&self) -> Vec<Pack> {
        let Accuracy { relative, absolute, .. } = self.accuracy;
        let mut most = Pack::all(0.0);
        let both = self.first.iter().zip(&self.x);
        both.map(|(first, x)| {
            Pack::of(|lane| {
                let size = (START * first.0[lane].abs()).max(x[NODES - 1].0[lane].abs());
                // A state counts as accurate within the accuracy of those before it.
                most.0[lane] = f64::max(most.0[lane], size);
                1.0 / (relative * most.0[lane] + absolute)
            })
        })
        .collect()
    }

    /// What the highest terms of the polynomials make of the states: accurate enough is 1.
    fn error(&self) -> Pack {
        let mut error = Pack::all(0.0);
        for (i, weight) in self.weights().iter().enumerate() {
            let mut tail = [Pack::all(0.0); 2];
            for node in 0..NODES {
                let rate = match self.x.get(i + 1) {
                    Some(x) => Pack::of(|lane| self.pace[node].0[lane] * x[node].0[lane]),
                    None => self.k[node],
                };
                for (tail, row) in tail.iter_mut().zip(&self.nodes.tail) {
                    for lane in 0..LANES {
                        tail.0[lane] += row[node] * rate.0[lane];
                    }
                }
            }
            for lane in 0..LANES {
                // Of the one before, which is larger, a tenth, should the last one vanish by chance.
                let term = tail[0].0[lane].abs().max(0.1 * tail[1].0[lane].abs());
                // The integral of P_j over a part of a step is 1/(2 j + 1) of it at most.
                #[allow(clippy::cast_precision_loss)]
                let part = term / (2 * NODES - 1) as f64 * weight.0[lane];
                error.0[lane] = if part <= error.0[lane] { error.0[lane] } else { part };
            }
        }
        error
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
        let cut;
        self.share = self.from.map(|from| (-from).exp());
        (self.length, cut) = self.flow.lengths(active, end);
        self.fall = self.length.map(|length| -(-length).exp_m1());
        self.first.copy_from_slice(&self.flow.y);
        self.begin_step(chain);
        let solved = self.solve(active, chain);
        let error = self.error();
        let loosest = (LOOSEST / self.accuracy.relative).max(1.0);
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
                    let more = more.min(loosest / self.allowed.0[lane]);
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
            let length = self.length.0[lane];
            let factor = factor.min(LONGEST / length);
            self.flow.go_on(lane, (moved, cut[lane]), (length, factor), end.0[lane]);
            moved
        })
    }

    fn accept(&mut self, moved: &Which, _: &mut dyn Chain) {
        for (y, x) in self.flow.y.iter_mut().zip(&self.x) {
            y.take(&x[NODES - 1], moved);
        }
    }

    /// By the barycentric formula.
    fn within(&mut self, at: &Pack, into: &mut [Pack]) {
        let (mut below, weights) = (Pack::all(0.0), &self.nodes.weights);
        into.fill(Pack::all(0.0));
        let part = Pack::of(|lane| -(self.from.0[lane] - at.0[lane]).exp_m1() / self.fall.0[lane]);
        for (l, weight) in weights.iter().enumerate() {
            let node = l.checked_sub(1);
            let place = node.map_or(0.0, |node| self.nodes.places[node]);
            // At a node the quotient would be infinite; next to it the value is that of the node.
            let factor = Pack::of(|lane| {
                let apart = part.0[lane] - place;
                weight
                    / if apart.abs() < f64::EPSILON { f64::EPSILON * f64::EPSILON } else { apart }
            });
            for lane in 0..LANES {
                below.0[lane] += factor.0[lane];
            }
            for (i, into) in into.iter_mut().enumerate() {
                let value = node.map_or(&self.first[i], |node| &self.x[i][node]);
                for lane in 0..LANES {
                    into.0[lane] += factor.0[lane] * value.0[lane];
                }
            }
        }
        for into in into {
            for lane in 0..LANES {
                into.0[lane] /= below.0[lane];
            }
        }
    }
}
