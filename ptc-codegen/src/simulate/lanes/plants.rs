//! The plants of all lanes, moved together where they are linear while their inputs are held.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::between::Motions;
use super::flow::Which;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::between::{Held, Moved};
use crate::simulate::held::is_same;
use crate::simulate::method::State;
use crate::simulate::switching::Walk;
use crate::simulate::{Failure, Process, Values};

/// A plant for each lane.
#[derive(Clone, Debug)]
pub(super) struct Plants {
    processes: Vec<Process>,
    walks: Vec<Walk>,
    /// The same plants at once, where they are integrated.
    motions: Option<Motions>,
    /// Effects of both parts of a sample, before and after the next input takes over.
    effects: [Effect; 2],
    /// The states at the end of a length.
    next: Vec<Pack>,
}

/// Effect of a length of time on the states of each lane.
#[derive(Clone, Debug)]
struct Effect {
    /// For each state a row of E, F B and F c.
    rows: Vec<Row>,
    /// The length of each lane, in s; not a number where it has none.
    lengths: Pack,
}

/// A row of the plants of all lanes.
#[derive(Clone, Debug)]
struct Row {
    whole: Vec<Pack>,
    of_inputs: Vec<Pack>,
    constant: Pack,
}

/// A part of a sample in which inputs are held, in s.
#[derive(Clone, Copy, Debug)]
pub(super) struct Times {
    /// The first or the second part.
    pub(super) part: usize,
    pub(super) from: Pack,
    pub(super) to: Pack,
    /// Lanes that move in it, as 1 or 0.
    pub(super) moves: Pack,
}

impl Plants {
    pub(super) fn of(process: &Process, inputs: usize) -> Self {
        let (n, none) = (process.states(), Pack::all(0.0));
        let row = Row { whole: vec![none; n], of_inputs: vec![none; inputs], constant: none };
        let effect = Effect { rows: vec![row; n], lengths: Pack::all(f64::NAN) };
        Self {
            processes: vec![process.clone(); LANES],
            walks: vec![Walk::default(); LANES],
            motions: match &process.moved {
                Moved::Rates(motion) => Motions::of(motion),
                Moved::Linear(_) => None,
            },
            effects: [effect.clone(), effect],
            next: vec![none; n],
        }
    }

    /// Begins a run in a lane, and returns the state that the controller is given.
    pub(super) fn start(
        &mut self,
        lane: usize,
        values: &Values,
        x0: &[f64],
    ) -> Result<Vec<f64>, Failure> {
        self.forget(lane);
        self.walks[lane] = Walk::default();
        let given = self.processes[lane].start(values, x0)?;
        if let Some(motions) = &mut self.motions {
            motions.start(lane, values, x0)?;
        }
        Ok(given)
    }

    /// Other values of a lane from here on.
    pub(super) fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        self.forget(lane);
        self.processes[lane].give(values)?;
        self.motions.as_mut().map_or(Ok(()), |motions| motions.give(lane, values))
    }

    fn forget(&mut self, lane: usize) {
        self.effects.iter_mut().for_each(|effect| effect.lengths.0[lane] = f64::NAN);
    }

    /// What sensors without errors give in some lanes.
    pub(super) fn measured(&mut self, t: &Pack, x: &[Pack], runs: &Which, into: &mut Vec<Pack>) {
        into.clear();
        if self.processes[0].gives_state() {
            into.extend_from_slice(x);
            return;
        }
        for lane in (0..LANES).filter(|lane| runs[*lane]) {
            let seen = self.processes[lane].sensed(t.0[lane], own(x, lane).as_slice());
            into.resize(seen.len(), Pack::all(0.0));
            into.iter_mut().zip(seen).for_each(|(pack, own)| pack.0[lane] = own);
        }
    }

    /// Moves the states of some lanes under their inputs; the lanes whose states have no value at the end.
    pub(super) fn move_on(&mut self, x: &mut [Pack], u: &[Pack], times: &Times) -> Which {
        let alone = self.unknown(times);
        self.after(x, u, times.part);
        let mut lost = [false; LANES];
        if let Some(mut alone) = alone {
            self.step(x, u, times, &mut alone);
            for lane in (0..LANES).filter(|lane| alone[*lane]) {
                let ends = (times.from.0[lane], times.to.0[lane]);
                lost[lane] = self.alone(lane, x, u, ends).is_none();
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
        let lengths = &self.effects[times.part].lengths;
        let mut others = Pack::all(0.0);
        for lane in 0..LANES {
            let known = is_same(lengths.0[lane], length.0[lane]);
            others.0[lane] = if known { 0.0 } else { times.moves.0[lane] };
        }
        if others.0.iter().sum::<f64>() == 0.0 {
            return None;
        }
        let mut alone = [false; LANES];
        for lane in (0..LANES).filter(|lane| others.0[*lane] > 0.0) {
            alone[lane] = !self.knows(lane, times.part, length.0[lane]);
        }
        Some(alone)
    }

    /// Looks up the rows of a lane; returns false if there are none.
    fn knows(&mut self, lane: usize, part: usize, length: f64) -> bool {
        let Effect { rows, lengths } = &mut self.effects[part];
        lengths.0[lane] = f64::NAN;
        let Some((own, all)) = self.processes[lane].rows(length) else { return false };
        for (row, (whole, of_inputs, constant)) in rows.iter_mut().zip(all) {
            row.whole.iter_mut().zip(whole).for_each(|(pack, own)| pack.0[lane] = *own);
            row.of_inputs.iter_mut().zip(of_inputs).for_each(|(pack, own)| pack.0[lane] = *own);
            row.constant.0[lane] = constant;
        }
        lengths.0[lane] = own;
        true
    }

    /// Computes the next states of the lanes that one step moves, and takes these from those that move alone.
    fn step(&mut self, x: &[Pack], u: &[Pack], times: &Times, alone: &mut Which) {
        let Some(motions) = &mut self.motions else { return };
        let steps = std::array::from_fn(|lane| alone[lane] && !self.walks[lane].slides());
        let moved = motions.after(x, u, times, &steps, &mut self.next);
        for lane in 0..LANES {
            alone[lane] &= !moved[lane];
        }
    }

    /// Computes the next state of a lane by itself.
    fn alone(&mut self, lane: usize, x: &[Pack], u: &[Pack], times: (f64, f64)) -> Option<()> {
        let acts: Vec<_> = u.iter().map(|u| u.0[lane]).collect();
        // Only integrals ask for time-to-go and for u as it is given, and none are in lanes.
        let held = Held { u: &acts, acts: &acts };
        let (process, walk) = (&mut self.processes[lane], &mut self.walks[lane]);
        let end = process.between(walk, own(x, lane), held, (times, f64::NAN)).ok()?;
        self.next.iter_mut().zip(end.iter()).for_each(|(next, end)| next.0[lane] = *end);
        Some(())
    }

    /// The states at the end of the length.
    fn after(&mut self, x: &[Pack], u: &[Pack], part: usize) {
        let rows = &self.effects[part].rows;
        for (into, Row { whole, of_inputs, constant }) in self.next.iter_mut().zip(rows) {
            let [mut next, mut acting] = [(whole, x), (of_inputs, u)].map(|(row, v)| dot(row, v));
            for lane in 0..LANES {
                acting.0[lane] += constant.0[lane];
                next.0[lane] += acting.0[lane];
            }
            *into = next;
        }
    }
}

/// The state of a lane.
fn own(x: &[Pack], lane: usize) -> State {
    let mut own = State::zeros();
    own.iter_mut().zip(x).for_each(|(own, x)| *own = x.0[lane]);
    own
}

#[inline]
fn dot(row: &[Pack], v: &[Pack]) -> Pack {
    // As the sum of an iterator begins.
    let mut sum = Pack::all(-0.0);
    for (row, v) in row.iter().zip(v) {
        for lane in 0..LANES {
            sum.0[lane] += row.0[lane] * v.0[lane];
        }
    }
    sum
}
