//! Many runs by one method: every lane takes the next one as soon as its own is done.

mod due;
mod load;

pub(super) use due::Due;

use super::flow::{Chain, Flow, Steps, Tick, Which, share_at};
use super::{Clock, Instants, Job, LaneSide, See};
use crate::program::lanes::{LANES, Pack};
use crate::simulate::Values;
use due::Place;

/// Places in a step at which u is held against its bound, and the part of the bound below which it then is
/// within it between them too: a step is far shorter than the time in which u rises by so much and falls
/// again.
const PLACES: u8 = 4;
const WITHIN: f64 = 0.95;

/// A side at the times of its lanes.
struct Clocked<'a, S> {
    side: &'a mut S,
    clock: &'a Clock,
}

impl<S: LaneSide> Chain for Clocked<'_, S> {
    fn last(&mut self, share: &Pack, state: &[Pack], tick: Tick) -> [Pack; 2] {
        self.side.last(&self.clock.at(share), state, tick)
    }

    fn is_even(&self) -> bool {
        self.side.is_in_time()
    }

    fn late(&self, share: &Pack) -> Pack {
        match self.side.is_in_time() {
            true => self.clock.late(share),
            false => Pack::all(0.0),
        }
    }
}

/// The runs under way.
pub(super) struct Batch<'a, S, M> {
    side: &'a mut S,
    jobs: &'a [Job<'a>],
    due: std::vec::IntoIter<Due>,
    done: &'a mut [bool],
    places: [Option<Place>; LANES],
    clock: Clock,
    method: M,
    /// sigma of the end of the piece of each lane.
    end: Pack,
    seen: Vec<Pack>,
    /// Runs for which the method takes too many steps.
    left: Vec<Due>,
}

impl<'a, S: LaneSide, M: Steps> Batch<'a, S, M> {
    pub(super) fn of(
        side: &'a mut S,
        jobs: &'a [Job<'a>],
        due: Vec<Due>,
        done: &'a mut [bool],
        method: M,
    ) -> Self {
        Self {
            seen: vec![Pack::all(0.0); side.order()],
            side,
            jobs,
            due: due.into_iter(),
            done,
            places: [None; LANES],
            clock: Clock { tau: Pack::all(1.0), t0: Pack::all(0.0) },
            method,
            end: Pack::all(0.0),
            left: Vec::new(),
        }
    }

    /// Runs all jobs and returns those that are left.
    pub(super) fn run(mut self, see: See<'_>) -> Vec<Due> {
        while self.load(see) {
            self.step(see);
        }
        self.left
    }

    fn piece(&self, place: &Place) -> &'a (Vec<f64>, Values) {
        &self.jobs[place.job].pieces[place.piece]
    }

    fn step(&mut self, see: See<'_>) {
        let active: Which = self.places.map(|place| place.is_some());
        let Self { side, clock, method, end, .. } = self;
        let from = method.flow().at;
        let mut chain = Clocked { side: *side, clock };
        let moved = method.step(&active, end, &mut chain);
        if moved.contains(&true) {
            method.accept(&moved, &mut chain);
        }
        let mut stays = [true; LANES];
        for lane in (0..LANES).filter(|lane| active[*lane]) {
            let Flow { at, step, y } = self.method.flow();
            let (at, step) = (at.0[lane], step.0[lane]);
            let finite = y.iter().all(|y| y.0[lane].is_finite());
            if let Some(place) = self.places[lane].as_mut().filter(|_| finite) {
                place.steps += 1;
                place.refused += usize::from(!moved[lane]);
                stays[lane] = place.goes_on((at, step), self.method.worth(place.left(at)));
            } else {
                self.places[lane] = None;
            }
        }
        self.drop_clipped(&moved, &from);
        self.look(&moved, see);
        for lane in (0..LANES).filter(|lane| !stays[*lane]) {
            self.leave(lane);
        }
    }

    /// Gives up the runs whose u has come near its bound in the last step.
    fn drop_clipped(&mut self, moved: &Which, from: &Pack) {
        let Some(bound) = self.side.bound() else { return };
        let to = self.method.flow().at;
        for place in 0..=PLACES {
            let part = f64::from(place) / f64::from(PLACES);
            let at = Pack::of(|lane| from.0[lane] + part * (to.0[lane] - from.0[lane]));
            self.method.within(&at, &mut self.seen);
            let at = self.clock.at(&share_at(&at));
            let (_, u) = self.side.tell(&at, &self.seen);
            for lane in (0..LANES).filter(|lane| moved[*lane]) {
                let is_free = u.0[lane].abs() <= WITHIN * bound.0[lane];
                self.places[lane].take_if(|_| !is_free);
            }
        }
    }

    /// Leaves a run where it is, if it has not come to the end of its piece.
    fn leave(&mut self, lane: usize) {
        let Some(place) = self.places[lane] else { return };
        if place.next < self.piece(&place).0.len() {
            let Flow { at, step, y } = self.method.flow();
            let y = Some(y.iter().map(|y| y.0[lane]).collect());
            let place = Place { steps: 0, refused: 0, ..place };
            self.left.push(Due { place, at: at.0[lane], step: step.0[lane], y });
            self.places[lane] = None;
        }
    }

    /// Hands over the instants that some lanes have come to.
    fn look(&mut self, lanes: &Which, see: See<'_>) {
        loop {
            let mut jobs = [None; LANES];
            let mut last = [false; LANES];
            let mut ends = [false; LANES];
            let mut share = Pack::all(1.0);
            let here = self.method.flow().at;
            let mut at = here;
            for lane in (0..LANES).filter(|lane| lanes[*lane]) {
                let Some(place) = self.places[lane] else { continue };
                let shares = &self.piece(&place).0;
                let Some(next) = shares.get(place.next) else { continue };
                let (own, here) = (-next.ln(), here.0[lane]);
                if own - here > SAME * here.max(1.0) {
                    continue;
                }
                jobs[lane] = Some(place.job);
                share.0[lane] = *next;
                ends[lane] = here - own <= SAME * here.max(1.0);
                at.0[lane] = own.min(here);
                let is_end = place.next + 1 == shares.len();
                last[lane] = is_end && place.piece + 1 == self.jobs[place.job].pieces.len();
                self.places[lane] = Some(Place { next: place.next + 1, ..place });
            }
            if jobs.iter().all(Option::is_none) {
                return;
            }
            self.method.within(&at, &mut self.seen);
            for (seen, y) in self.seen.iter_mut().zip(&self.method.flow().y) {
                seen.take(y, &ends);
            }
            let at = self.clock.at(&share);
            let (x, u) = self.side.tell(&at, &self.seen);
            let u = std::slice::from_ref(u);
            see(&Instants { jobs, last, time_to_go: &at.time_to_go, x, u });
        }
    }
}

/// Within this, as a part of them, two places are the same.
const SAME: f64 = 1e-13;
