//! Plants that are linear while their input is held, one in each lane, moved together.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::flow::Which;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::held::is_same;
use crate::simulate::plant::Motion;
use crate::simulate::solver::State;
use crate::simulate::{Failure, Values};

/// A plant for each lane, with one input.
#[derive(Clone, Debug)]
pub(super) struct Plants {
    motions: Vec<Motion>,
    /// What each comes to over a length: a row of E, F B and F c for each state.
    rows: Vec<Packed>,
    /// The length of each lane, in s; not a number where it has none.
    lengths: Pack,
    /// The states at the end of a length.
    next: Vec<Pack>,
}

/// A row of the plants of all lanes.
#[derive(Clone, Debug)]
struct Packed {
    whole: Vec<Pack>,
    of_input: Pack,
    constant: Pack,
}

/// A time in which inputs are held, by lane: from, to, in s.
pub(super) type Times = [(f64, f64); LANES];

impl Plants {
    pub(super) fn of(motion: &Motion) -> Self {
        let (n, none) = (motion.order(), Pack::all(0.0));
        let row = Packed { whole: vec![none; n], of_input: none, constant: none };
        Self {
            motions: vec![motion.clone(); LANES],
            rows: vec![row; n],
            lengths: Pack::all(f64::NAN),
            next: vec![none; n],
        }
    }

    /// Begins a run in a lane.
    pub(super) fn start(
        &mut self,
        lane: usize,
        values: &Values,
        x0: &[f64],
    ) -> Result<(), Failure> {
        self.lengths.0[lane] = f64::NAN;
        self.motions[lane].init(values, x0)
    }

    /// Other values of a lane from here on.
    pub(super) fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        self.lengths.0[lane] = f64::NAN;
        self.motions[lane].give(values)
    }

    /// Moves the states of some lanes: those whose states have a value at the end.
    pub(super) fn move_on(
        &mut self,
        x: &mut [Pack],
        u: &Pack,
        times: &Times,
        lanes: Which,
    ) -> Which {
        let mut alone = [false; LANES];
        for lane in 0..LANES {
            alone[lane] = lanes[lane] && !self.knows(lane, times[lane].1 - times[lane].0);
        }
        for (next, row) in self.next.iter_mut().zip(&self.rows) {
            let Packed { whole, of_input, constant } = row;
            // As the sum of an iterator begins.
            *next = Pack::all(-0.0);
            for (whole, x) in whole.iter().zip(&*x) {
                for lane in 0..LANES {
                    next.0[lane] += whole.0[lane] * x.0[lane];
                }
            }
            for lane in 0..LANES {
                next.0[lane] += of_input.0[lane] * u.0[lane] + constant.0[lane];
            }
        }
        let mut moved = lanes;
        for lane in (0..LANES).filter(|lane| alone[*lane]) {
            moved[lane] = self.alone(lane, x, u.0[lane], times[lane]).is_some();
        }
        for (x, next) in x.iter_mut().zip(&self.next) {
            for lane in 0..LANES {
                let is_finite = next.0[lane].is_finite();
                x.0[lane] = if lanes[lane] { next.0[lane] } else { x.0[lane] };
                moved[lane] &= is_finite;
            }
        }
        moved
    }

    /// Whether the rows of a lane are those of a length, which are looked up where they are not.
    fn knows(&mut self, lane: usize, length: f64) -> bool {
        if is_same(self.lengths.0[lane], length) {
            return true;
        }
        self.lengths.0[lane] = f64::NAN;
        let Some((own, rows)) = self.motions[lane].rows(length) else { return false };
        for (row, (whole, of_inputs, constant)) in self.rows.iter_mut().zip(rows) {
            row.whole.iter_mut().zip(whole).for_each(|(pack, own)| pack.0[lane] = *own);
            row.of_input.0[lane] = of_inputs.first().copied().unwrap_or(0.0);
            row.constant.0[lane] = constant;
        }
        self.lengths.0[lane] = own;
        true
    }

    /// Where a lane comes to by itself.
    fn alone(&mut self, lane: usize, x: &[Pack], u: f64, times: (f64, f64)) -> Option<()> {
        let mut own = State::zeros();
        own.iter_mut().zip(x).for_each(|(own, x)| *own = x.0[lane]);
        let end = self.motions[lane].after(&own, &[u], times)?;
        self.next.iter_mut().zip(end.iter()).for_each(|(next, end)| next.0[lane] = *end);
        Some(())
    }
}
