//! Plants that are linear while their input is held, one in each lane, moved together.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::flow::Which;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::held::is_same;
use crate::simulate::method::State;
use crate::simulate::plant::Motion;
use crate::simulate::{Failure, Values};

/// A plant for each lane, with one input.
#[derive(Clone, Debug)]
pub(super) struct Plants {
    motions: Vec<Motion>,
    /// Effect of a length on each state: a row of E, F B and F c.
    rows: Vec<Row>,
    /// The length of each lane, in s; not a number where it has none.
    lengths: Pack,
    /// The states at the end of a length.
    next: Vec<Pack>,
}

/// A row of the plants of all lanes.
#[derive(Clone, Debug)]
struct Row {
    whole: Vec<Pack>,
    of_input: Pack,
    constant: Pack,
}

/// A time in which inputs are held, in s.
#[derive(Clone, Copy, Debug)]
pub(super) struct Times {
    pub(super) from: Pack,
    pub(super) to: Pack,
    /// Lanes that move in it, as 1 or 0.
    pub(super) moves: Pack,
}

impl Plants {
    pub(super) fn of(motion: &Motion) -> Self {
        let (n, none) = (motion.order(), Pack::all(0.0));
        let row = Row { whole: vec![none; n], of_input: none, constant: none };
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

    /// Moves the states of some lanes under their inputs; the lanes whose states have no value at the end.
    pub(super) fn move_on(&mut self, x: &mut [Pack], (u, times): (&Pack, &Times)) -> Which {
        let alone = self.unknown(times);
        self.after(x, u);
        let mut lost = [false; LANES];
        if let Some(alone) = alone {
            for lane in (0..LANES).filter(|lane| alone[*lane]) {
                let ends = (times.from.0[lane], times.to.0[lane]);
                lost[lane] = self.alone(lane, x, u.0[lane], ends).is_none();
            }
        }
        // A number times 0 is 0, and nothing else is.
        let mut none = Pack::all(0.0);
        for (x, next) in x.iter_mut().zip(&self.next) {
            for lane in 0..LANES {
                let moves = times.moves.0[lane] > 0.0;
                x.0[lane] = if moves { next.0[lane] } else { x.0[lane] };
                none.0[lane] += 0.0 * x.0[lane];
            }
        }
        for lane in 0..LANES {
            lost[lane] |= none.0[lane] != 0.0;
        }
        lost
    }

    /// The lanes that move and whose rows are not those of their length, once they were looked up; `None` where
    /// all are.
    fn unknown(&mut self, times: &Times) -> Option<Which> {
        let length = Pack::of(|lane| times.to.0[lane] - times.from.0[lane]);
        let mut others = Pack::all(0.0);
        for lane in 0..LANES {
            let known = is_same(self.lengths.0[lane], length.0[lane]);
            others.0[lane] = if known { 0.0 } else { times.moves.0[lane] };
        }
        if others.0.iter().sum::<f64>() == 0.0 {
            return None;
        }
        let mut alone = [false; LANES];
        for lane in (0..LANES).filter(|lane| others.0[*lane] > 0.0) {
            alone[lane] = !self.knows(lane, length.0[lane]);
        }
        Some(alone)
    }

    /// Looks up the rows of a lane; returns false if there are none.
    fn knows(&mut self, lane: usize, length: f64) -> bool {
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

    /// Computes the next state of a lane by itself.
    fn alone(&mut self, lane: usize, x: &[Pack], u: f64, times: (f64, f64)) -> Option<()> {
        let mut own = State::zeros();
        own.iter_mut().zip(x).for_each(|(own, x)| *own = x.0[lane]);
        let end = self.motions[lane].after(&own, &[u], times)?;
        self.next.iter_mut().zip(end.iter()).for_each(|(next, end)| next.0[lane] = *end);
        Some(())
    }

    /// The states at the end of the length.
    fn after(&mut self, x: &[Pack], u: &Pack) {
        for (into, Row { whole, of_input, constant }) in self.next.iter_mut().zip(&self.rows) {
            // As the sum of an iterator begins.
            let mut next = Pack::all(-0.0);
            for (whole, x) in whole.iter().zip(x) {
                for lane in 0..LANES {
                    next.0[lane] += whole.0[lane] * x.0[lane];
                }
            }
            for lane in 0..LANES {
                next.0[lane] += of_input.0[lane] * u.0[lane] + constant.0[lane];
            }
            *into = next;
        }
    }
}
