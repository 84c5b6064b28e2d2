//! Assignment of the next run, or the next piece, to idle lanes.

use super::super::flow::{Steps, Which, share_at};
use super::super::{LaneSide, See};
use super::due::Place;
use super::{Batch, Clocked, Due};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};

impl<'a, S: LaneSide, M: Steps> Batch<'a, S, M> {
    /// Gives lanes that are idle their next job, or their next piece; whether any has one.
    pub(super) fn load(&mut self, see: See<'_>) -> bool {
        loop {
            let mut fresh = [false; LANES];
            let mut started: [Option<Option<Vec<f64>>>; LANES] = Default::default();
            for lane in 0..LANES {
                match self.places[lane] {
                    Some(place) if place.next == self.piece(&place).0.len() => {
                        fresh[lane] = self.turn(lane, place);
                    }
                    Some(_) => continue,
                    None => {}
                }
                if self.places[lane].is_none() {
                    started[lane] = self.start(lane);
                    fresh[lane] = started[lane].is_some();
                }
            }
            if !fresh.contains(&true) {
                return self.places.iter().any(Option::is_some);
            }
            self.begin(&fresh, &started);
            // A piece may end where it begins.
            self.look(&fresh, see);
        }
    }

    /// The next piece of the job of a lane; else the job is done.
    fn turn(&mut self, lane: usize, place: Place) -> bool {
        let pieces = self.jobs[place.job].pieces;
        self.places[lane] = None;
        let Some((_, values)) = pieces.get(place.piece + 1) else {
            self.done[place.job] = true;
            return false;
        };
        if self.side.give(lane, values).is_err() {
            return false;
        }
        self.places[lane] = Some(Place { piece: place.piece + 1, next: 0, ..place });
        true
    }

    /// Begins the next run that can be begun, with the state from which it goes on.
    fn start(&mut self, lane: usize) -> Option<Option<Vec<f64>>> {
        for Due { place, at, step, y } in self.due.by_ref() {
            let job = &self.jobs[place.job];
            let legal = job.pieces.iter().all(|(shares, _)| !shares.is_empty());
            let start = |side: &mut S| {
                side.start(lane, job.values, job.x0)?;
                match place.piece {
                    0 => Ok(()),
                    piece => side.give(lane, &job.pieces[piece].1),
                }
            };
            if legal && start(self.side).is_ok() {
                self.clock.tau.0[lane] = job.values.get(Parameter::Tau);
                self.clock.t0.0[lane] = job.values.get(Parameter::StartTime);
                let flow = self.method.flow();
                flow.at.0[lane] = at;
                flow.step.0[lane] = step;
                self.places[lane] = Some(place);
                return Some(y);
            }
        }
        None
    }

    /// Begins in lanes with new values, some of which are at a start; those with a kink on their way are
    /// left.
    fn begin(&mut self, fresh: &Which, started: &[Option<Option<Vec<f64>>>; LANES]) {
        self.side.settle();
        let mut x0 = self.method.flow().y.clone();
        let mut last = Pack::all(1.0);
        for lane in (0..LANES).filter(|lane| fresh[*lane]) {
            let Some(place) = self.places[lane] else { continue };
            let job = &self.jobs[place.job];
            for (x0, x) in x0.iter_mut().zip(job.x0) {
                x0.0[lane] = *x;
            }
            last.0[lane] = self.piece(&place).0.last().copied().unwrap_or(1.0);
            self.end.0[lane] = -last.0[lane].ln();
        }
        let Self { side, clock, method, .. } = self;
        let flow = method.flow();
        let from = clock.at(&share_at(&flow.at));
        let at_start: Which = std::array::from_fn(|lane| matches!(started[lane], Some(None)));
        if at_start.contains(&true) {
            for (y, begun) in flow.y.iter_mut().zip(&side.begin(&from, &x0)) {
                y.take(begun, &at_start);
            }
        }
        for (lane, started) in started.iter().enumerate() {
            if let Some(Some(state)) = started {
                flow.y.iter_mut().zip(state).for_each(|(y, own)| y.0[lane] = *own);
            }
        }
        let kinks = side.kinks_between(&from, &clock.at(&last));
        for lane in 0..LANES {
            if fresh[lane] && kinks[lane] {
                self.places[lane] = None;
            }
        }
        method.begin(fresh, &mut Clocked { side: *side, clock });
    }
}
