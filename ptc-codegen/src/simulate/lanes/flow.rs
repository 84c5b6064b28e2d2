//! Common parts of the methods in lanes: the position of each lane, and the length of its next step.

use crate::program::lanes::{LANES, Pack};

/// Lanes that something is true of.
pub(super) type Which = [bool; LANES];

/// The difference by which a slope is formed, as a part of the state.
pub(super) const MOVED: f64 = 1e-6;

/// T/tau at a sigma, and by what T falls on a way in sigma.
pub(super) fn share_at(sigma: &Pack) -> Pack {
    sigma.map(|sigma| -sigma).exp()
}

/// Relation of T at a call to T at the calls before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tick {
    /// It is another one.
    New,
    /// It is another one, to which calls come back by this number.
    Kept(usize),
    /// It is that of the call before.
    Again,
    /// It is that kept under this number.
    Of(usize),
}

/// System to integrate: a chain by sigma, of which T/tau and the states of the lanes are given.
pub(super) trait Chain {
    /// Returns the pace of the chain, dy_i = pace y_(i+1), and the rate of its last component.
    fn last(&mut self, share: &Pack, state: &[Pack], tick: Tick) -> [Pack; 2];

    /// Returns true if the pace is the same all over a step, by the part of the step by which T falls.
    fn is_even(&self) -> bool;

    /// Returns how much later than requested, in sigma, the last component is computed, as times are rounded.
    fn late(&self, share: &Pack) -> Pack;
}

/// Position of each lane.
#[derive(Clone, Debug)]
pub(super) struct Flow {
    /// sigma.
    pub(super) at: Pack,
    /// The step with which it would go on.
    pub(super) step: Pack,
    pub(super) y: Vec<Pack>,
}

/// A method that steps in every lane: the numbers of a lane do not depend on the others.
pub(super) trait Steps {
    fn flow(&mut self) -> &mut Flow;

    /// Returns the number of steps that a rest of a run is worth: where it takes more, it is left to another method.
    fn worth(&self, left: f64) -> f64 {
        let _ = left;
        f64::INFINITY
    }

    /// Begins anew in some lanes, where they are.
    fn begin(&mut self, lanes: &Which, chain: &mut dyn Chain);

    /// A step in each of the `active` lanes, at most to its `end`; those whose step is accurate enough
    /// are to [`accept`](Self::accept) it.
    fn step(&mut self, active: &Which, end: &Pack, chain: &mut dyn Chain) -> Which;

    /// Takes the step of the lanes that `moved`: afterwards [`within`](Self::within) gives their states
    /// in it.
    fn accept(&mut self, moved: &Which, chain: &mut dyn Chain);

    /// The state of each lane at a sigma in its last step.
    fn within(&mut self, at: &Pack, into: &mut [Pack]);
}

impl Flow {
    pub(super) fn new(order: usize) -> Self {
        let zero = Pack::all(0.0);
        Self { at: zero, step: zero, y: vec![zero; order] }
    }

    /// The length of the next step of each lane, at most to its `end`, and whether that cuts it.
    pub(super) fn lengths(&self, active: &Which, end: &Pack) -> (Pack, Which) {
        let left = Pack::of(|lane| end.0[lane] - self.at.0[lane]);
        let cut: Which = std::array::from_fn(|lane| self.step.0[lane] >= left.0[lane]);
        let length = Pack::of(|lane| match (active[lane], cut[lane]) {
            (false, _) => 0.0,
            (true, true) => left.0[lane],
            (true, false) => self.step.0[lane],
        });
        (length, cut)
    }

    /// Moves a lane on by an accepted step of a length, and sets the next step, by the factor that its error allows.
    pub(super) fn go_on(
        &mut self,
        lane: usize,
        (moved, cut): (bool, bool),
        (length, factor): (f64, f64),
        end: f64,
    ) {
        let next = length * if moved { factor } else { factor.min(1.0) };
        // What was cut says only that the next step may be as long.
        if !(moved && cut && next < self.step.0[lane]) {
            self.step.0[lane] = next;
        }
        if moved {
            self.at.0[lane] = if cut { end } else { self.at.0[lane] + length };
        }
    }
}
