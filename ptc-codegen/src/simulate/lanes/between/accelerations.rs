//! The accelerations of the mechanical plants of all lanes.

use crate::program::lanes::{LANES, Lanes, Pack};
use crate::simulate::mechanics::Mechanics;

/// The equations of motion, solved in one lane after the other.
#[derive(Clone, Debug)]
pub(super) struct Accelerations {
    mechanics: Mechanics,
    solved: Vec<Pack>,
    /// Determinant of the inertia.
    pub(super) determinant: Pack,
    u: Vec<f64>,
}

impl Accelerations {
    pub(super) fn new(mechanics: &Mechanics) -> Self {
        let none = Pack::all(f64::NAN);
        Self {
            solved: vec![none; mechanics.accelerations().len()],
            mechanics: mechanics.clone(),
            determinant: none,
            u: Vec::new(),
        }
    }

    /// Solves them for the values of a program under some inputs.
    pub(super) fn solve(&mut self, lanes: &Lanes, u: &[Pack]) {
        let Self { mechanics, solved, determinant, u: own } = self;
        for lane in 0..LANES {
            own.clear();
            own.extend(u.iter().map(|u| u.0[lane]));
            mechanics.solve(|value| lanes.get(value).0[lane], own);
            let accelerations = solved.iter_mut().zip(mechanics.accelerations());
            accelerations.for_each(|(pack, own)| pack.0[lane] = *own);
            determinant.0[lane] = mechanics.determinant().now();
        }
    }

    /// The rates of a state, of which the last part are speeds.
    pub(super) fn rates<'a>(&'a self, state: &'a [Pack]) -> impl Iterator<Item = &'a Pack> {
        state[self.solved.len()..].iter().chain(&self.solved)
    }
}
