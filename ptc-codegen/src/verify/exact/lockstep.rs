//! Scenarios in lanes, from node to node at once.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::table::{Step, Table};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::lanes::{At, DirectLanes, Instants, LaneSide};
use crate::verify::observer::LaneObserver;
use crate::verify::{Other, Outcome, Setting};

/// A scenario.
pub(super) struct Job<'a> {
    /// Its place among the settings.
    pub(super) index: usize,
    pub(super) setting: &'a Setting,
    /// f in each of its pieces.
    pub(super) forces: Vec<f64>,
    /// tau/tau_0.
    pub(super) q: f64,
}

/// Position of a lane.
#[derive(Clone, Copy, Debug)]
struct Place {
    piece: usize,
    /// The next instant of the piece.
    next: usize,
    alive: bool,
    /// The largest difference of the sides in u, and the largest u.
    apart: f64,
    size: f64,
}

/// The scenarios under way.
pub(super) struct Lockstep<'a> {
    table: &'a Table,
    jobs: &'a [Job<'a>],
    places: [Place; LANES],
    /// State of the run of length tau_0.
    scaled: Vec<Pack>,
    /// q^-j, and q^n f.
    powers: Vec<Pack>,
    force: Pack,
    excess: [Vec<[f64; LANES]>; 2],
}

impl<'a> Lockstep<'a> {
    /// At most as many as there are lanes.
    pub(super) fn new(table: &'a Table, jobs: &'a [Job<'a>]) -> Self {
        let start = Place { piece: 0, next: 0, alive: false, apart: 0.0, size: 0.0 };
        let one = Pack::all(1.0);
        let (excess, none) = (Default::default(), Pack::all(0.0));
        let powers = vec![one; table.n + 1];
        Self {
            table,
            jobs,
            places: [start; LANES],
            scaled: vec![none; table.n],
            powers,
            force: none,
            excess,
        }
    }

    /// The outcomes of those that come to their end.
    pub(super) fn run(
        mut self,
        direct: &mut DirectLanes,
        observer: &mut LaneObserver,
    ) -> Vec<Option<Outcome>> {
        let settings: Vec<_> = self.jobs.iter().map(|job| job.setting).collect();
        observer.forget();
        let none = || vec![[f64::NEG_INFINITY; LANES]; observer.objectives()];
        self.excess = [none(), none()];
        let clock = self.start(direct);
        let table = self.table;
        let mut x = vec![Pack::all(0.0); table.n];
        for (place, step) in table.steps.iter().enumerate() {
            if place > 0 {
                self.advance(step);
            }
            let (jobs, last) = self.due(step.share);
            if jobs == [None; LANES] {
                continue;
            }
            for j in 0..table.n {
                x[j] = Pack::of(|lane| self.scaled[j].0[lane] * self.powers[j].0[lane]);
            }
            let u = self.control(step);
            let at = At::of((&clock[0], &clock[1]), &Pack::all(step.share));
            let (x, emitted) = direct.tell(&at, &x);
            if let Some(lost) = observer.meet(&settings, &jobs) {
                self.places[lost].alive = false;
            }
            let mut excess = |side: usize, u: &Pack| {
                let own = &mut self.excess[side];
                let u = std::slice::from_ref(u);
                let instants = Instants { jobs, last, time_to_go: &at.time_to_go, x, u };
                observer.look(&instants, &mut |lane, objective, excess| {
                    let kept: &mut f64 = &mut own[objective][lane];
                    *kept = kept.max(excess);
                });
            };
            excess(0, &u);
            excess(1, emitted);
            // A number times 0 is 0, and nothing else is.
            let mut none = Pack::of(|lane| 0.0 * u.0[lane] + 0.0 * emitted.0[lane]);
            for x in x {
                for lane in 0..LANES {
                    none.0[lane] += 0.0 * x.0[lane];
                }
            }
            for lane in (0..LANES).filter(|lane| jobs[*lane].is_some()) {
                let own = &mut self.places[lane];
                own.alive &= none.0[lane] == 0.0;
                own.apart = own.apart.max((u.0[lane] - emitted.0[lane]).abs());
                own.size = own.size.max(u.0[lane].abs()).max(emitted.0[lane].abs());
            }
        }
        (0..self.jobs.len()).map(|lane| self.outcome(lane)).collect()
    }

    /// Gives every lane its scenario; tau and t0 of each. A lane whose gains are held before its end is lost.
    fn start(&mut self, direct: &mut DirectLanes) -> [Pack; 2] {
        let mut clock = [Pack::all(1.0), Pack::all(0.0)];
        let mut end = Pack::all(1.0);
        for (lane, job) in self.jobs.iter().enumerate() {
            let Setting { values, x0, pieces, .. } = job.setting;
            clock[0].0[lane] = values.get(Parameter::Tau);
            clock[1].0[lane] = values.get(Parameter::StartTime);
            end.0[lane] = pieces.last().and_then(|(all, _)| all.last()).copied().unwrap_or(1.0);
            self.places[lane].alive = direct.start(lane, values, x0).is_ok();
            let mut power = 1.0;
            for (own, x) in self.scaled.iter_mut().zip(x0) {
                own.0[lane] = power * x;
                power *= job.q;
            }
            let mut power = 1.0;
            for own in &mut self.powers {
                own.0[lane] = power;
                power /= job.q;
            }
            self.turn(lane);
        }
        direct.settle();
        let at = |share: &Pack| At::of((&clock[0], &clock[1]), share);
        let held = direct.kinks_between(&at(&Pack::all(1.0)), &at(&end));
        for lane in 0..LANES {
            self.places[lane].alive &= !held[lane];
        }
        clock
    }

    /// Takes f of the piece of a lane.
    fn turn(&mut self, lane: usize) {
        let force = self.jobs[lane].forces.get(self.places[lane].piece).copied().unwrap_or(0.0);
        self.force.0[lane] = force / self.powers[self.table.n].0[lane];
    }

    fn advance(&mut self, step: &Step) {
        let n = self.table.n;
        let mut moved = [Pack::all(0.0); crate::request::MAX_ORDER];
        for (i, moved) in moved[..n].iter_mut().enumerate() {
            let row = &step.transition[i * n..(i + 1) * n];
            for lane in 0..LANES {
                moved.0[lane] = step.force[i] * self.force.0[lane];
            }
            for j in 0..n {
                for lane in 0..LANES {
                    moved.0[lane] += row[j] * self.scaled[j].0[lane];
                }
            }
        }
        self.scaled.copy_from_slice(&moved[..n]);
    }

    /// u of the law.
    fn control(&self, step: &Step) -> Pack {
        let mut u = Pack::all(0.0);
        for j in 0..self.table.n {
            for lane in 0..LANES {
                u.0[lane] += step.control[j] * self.scaled[j].0[lane];
            }
        }
        let power = &self.powers[self.table.n];
        Pack::of(|lane| u.0[lane] * power.0[lane])
    }

    /// The lanes of which this is an instant, and whether it is the last one.
    fn due(&mut self, share: f64) -> ([Option<usize>; LANES], [bool; LANES]) {
        let (mut jobs, mut last) = ([None; LANES], [false; LANES]);
        for (lane, job) in self.jobs.iter().enumerate() {
            let place = &mut self.places[lane];
            let pieces = &job.setting.pieces;
            let Some((shares, _)) = pieces.get(place.piece) else { continue };
            if !place.alive || shares.get(place.next) != Some(&share) {
                continue;
            }
            jobs[lane] = Some(lane);
            place.next += 1;
            if place.next == shares.len() {
                (place.piece, place.next) = (place.piece + 1, 0);
                last[lane] = place.piece == pieces.len();
                self.turn(lane);
            }
        }
        (jobs, last)
    }

    /// `None` where it has not come to its end, or left the range of numbers.
    fn outcome(&self, lane: usize) -> Option<Outcome> {
        let Place { piece, alive, apart, size, .. } = self.places[lane];
        if !alive || piece != self.jobs[lane].setting.pieces.len() {
            return None;
        }
        let [excess, direct] =
            [0, 1].map(|side| self.excess[side].iter().map(|all| all[lane]).collect());
        let difference = if apart == 0.0 { 0.0 } else { apart / size };
        Some(Outcome { excess, direct: Some(Other { excess: direct, difference }), ended: None })
    }
}
