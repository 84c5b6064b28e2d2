//! Systems that are smooth up to kinks and jumps: integrated piece by piece, and slid along a jump
//! to which both sides push, after Filippov.
//!
//! A kink is where its distance is 0. In a mode every kink is held on one of its sides, so that the
//! rates are smooth, and the mode ends where a distance changes its sign. On a surface the rates are Filippov's
//! convex combination of those of the two sides that keeps the distance at 0, as long as there is one.

use std::cell::RefCell;

use super::method::{Rates, State};
use super::mode::{Mode, Tangent, begin, field, margins, next};
use super::pass::{End, Pass};
use super::solver::{Begin, FIRST, First, Piece, integrate};
use super::surface::Surface;
use super::{Accuracy, Failure};

/// A system with kinks.
pub(super) trait Piecewise {
    /// Number of equations.
    fn order(&self) -> usize;

    /// Number of integrals behind these, on which no rate but their own depends.
    fn integrals(&self) -> usize {
        0
    }

    /// Number of kinks of the integrals, the last ones.
    fn kinks_of_integrals(&self) -> usize {
        0
    }

    /// The rates, with the kinks held as chosen.
    fn rates(&mut self, s: f64, state: &State, rates: &mut State);

    /// Number of kinks.
    fn kinks(&self) -> usize;

    /// The distances from the kinks.
    fn distances(&mut self, s: f64, state: &State, into: &mut Vec<f64>);

    /// Holds every kink above or below 0.
    fn choose(&mut self, above: &[bool]);

    /// Why no run goes on across a kink, or, without one, where its integration stops; `None` where
    /// one does.
    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let _ = kink;
        None
    }

    /// The form in which the state is integrated from here on, and how far at most.
    fn form(&mut self, s: f64, state: &State, slides: bool) -> (State, f64) {
        let _ = (s, slides);
        (*state, f64::INFINITY)
    }

    /// Returns true if an error below the relative accuracy of the states before it counts as nothing.
    fn floors(&self) -> bool;

    /// An error that counts as nothing where the system is stiff.
    fn nothing(&mut self, s: f64) -> f64;

    /// Is shown the state at the point of an index, and along a jump the mode with the part of the way
    /// beyond it.
    fn see(&mut self, index: usize, s: f64, state: &State, slide: Option<(&Mode, f64)>);
}

/// The progress of a run beside its state.
#[derive(Clone, Debug, Default)]
pub(super) struct Walk {
    mode: Option<Mode>,
    stiff: bool,
    step: f64,
}

/// Most events of a run.
const EVENTS: usize = 20_000;

/// Most events at one instant, for each kink.
const AT_ONCE: usize = 4;

/// Distance ahead of an event at which a barrier counts as met.
const AHEAD: f64 = 1e-6;

impl Walk {
    /// Returns true if it slides along a jump.
    pub(super) fn slides(&self) -> bool {
        self.mode.as_ref().is_some_and(|mode| mode.slide.is_some())
    }

    /// Integrates from `start` at `points[0]` to the last of the ascending points, and shows each to the
    /// system. Not generic, as the methods below it are large.
    ///
    /// # Errors
    /// With the point reached.
    pub(super) fn on(
        &mut self,
        system: &mut dyn Piecewise,
        start: State,
        points: &[f64],
        (first, accuracy): (First, Accuracy),
    ) -> Result<(), (f64, Failure)> {
        let Some(mut at) = points.first().copied() else { return Ok(()) };
        let mut state = start;
        let mut mode = self.resume(system, at, &state).map_err(|failure| (at, failure))?;
        let mut pass = Pass {
            points,
            next: 0,
            left: accuracy.steps,
            until: f64::INFINITY,
            longest: f64::INFINITY,
            stalled: false,
            slides: false,
        };
        let mut step = match first {
            First::Eighth if self.step > 0.0 => self.step,
            First::Eighth => FIRST,
            First::Fifth => points.last().map_or(1.0, |last| (last - at).max(FIRST)),
        };
        let (mut events, mut here) = (0, 0);
        loop {
            system.choose(&mode.above);
            let (mut formed, length) = system.form(at, &state, mode.slide.is_some());
            if let Some(slide) = &mode.slide {
                Surface::of(system, slide.kink, at, &formed).project(&mut formed, slide.pivot);
            }
            let (floors, kinks, states) = (system.floors(), system.kinks(), system.order());
            let order = states + system.integrals();
            (pass.until, pass.slides) = (at + length, mode.slide.is_some());
            let cell = RefCell::new(&mut *system);
            let rates = |s: f64, y: &State, rates: &mut State| {
                let system = &mut **cell.borrow_mut();
                match mode.slide {
                    None => system.rates(s, y, rates),
                    Some(_) => field(system, &mode, s, y, rates),
                }
            };
            let nothing = |s: f64| cell.borrow_mut().nothing(s);
            let monitor = |s: f64, y: &State, values: &mut Vec<f64>| {
                margins(&mut **cell.borrow_mut(), &mode, s, y, values);
            };
            let mut visit = |index: usize, s: f64, y: &State| {
                let system = &mut **cell.borrow_mut();
                let slide =
                    mode.slide.as_ref().map(|slide| Tangent::of(system, &mode, slide, s, y));
                system.choose(&mode.above);
                system.see(index, s, y, slide.map(|tangent| (&mode, tangent.part)));
            };
            let piece = Piece {
                first,
                accuracy,
                floors,
                nothing: &nothing,
                monitor: (kinks > 0).then_some(&monitor),
            };
            let begin = Begin { at, state: formed, step, stiff: self.stiff && floors };
            let rates = Rates { order, states, rates: &rates };
            let end = integrate(&rates, begin, &piece, &mut pass, &mut visit);
            let (reached, stiff) =
                end.map_err(|(at, failure)| (at, system.barrier(None).unwrap_or(failure)))?;
            let moved = reached.at - at > 1e-12 * at.abs().max(1.0);
            here = if moved { 0 } else { here + 1 };
            (at, state) = (reached.at, reached.state);
            self.stiff = stiff;
            step = reached.step.clamp(1e-12, 1e3);
            match reached.end {
                End::Done => break,
                End::Limit => {}
                End::Event(which) => {
                    events += 1;
                    if events > EVENTS || here > AT_ONCE * (kinks + 1) {
                        return Err((at, endless()));
                    }
                    if let Some(failure) = met(system, &mode, which, (at, &state)) {
                        return Err((at, failure));
                    }
                    let next = next(system, &mode, which, at, &state);
                    mode = next.map_err(|failure| (at, failure))?;
                }
            }
        }
        self.step = if first == First::Eighth { step } else { 0.0 };
        self.mode = Some(mode);
        Ok(())
    }

    /// The mode in which to go on, or to begin.
    fn resume(
        &mut self,
        system: &mut dyn Piecewise,
        at: f64,
        state: &State,
    ) -> Result<Mode, Failure> {
        let before = self.mode.take();
        if system.kinks() == 0 {
            return Ok(Mode { above: Vec::new(), slide: None });
        }
        if let Some(mode) = before {
            let mut values = Vec::new();
            margins(system, &mode, at, state, &mut values);
            // What the values of the run have moved to its other side is there; a slide is found anew.
            if let Some(slide) = &mode.slide
                && values.iter().all(|value| *value >= 0.0)
            {
                let kept = Mode { above: mode.above.clone(), slide: Some(slide.clone()) };
                return Ok(kept);
            }
        }
        begin(system, at, state)
    }
}

/// Returns the failure that ends the run at an event: a kink that no run crosses, or one just ahead, close to which
/// others are met too.
fn met(
    system: &mut dyn Piecewise,
    mode: &Mode,
    which: usize,
    (s, state): (f64, &State),
) -> Option<Failure> {
    if let Some(failure) = system.barrier(Some(which)) {
        return Some(failure);
    }
    let kinks = 0..system.kinks();
    let barriers: Vec<_> = kinks.filter(|kink| system.barrier(Some(*kink)).is_some()).collect();
    if barriers.is_empty() {
        return None;
    }
    let (mut rates, mut here, mut ahead) = (State::zeros(), Vec::new(), Vec::new());
    field(system, mode, s, state, &mut rates);
    system.distances(s, state, &mut here);
    system.distances(s + AHEAD, &(state + rates * AHEAD), &mut ahead);
    let crossed = barriers.into_iter().find(|kink| here[*kink] * ahead[*kink] < 0.0);
    crossed.and_then(|kink| system.barrier(Some(kink)))
}

fn endless() -> Failure {
    Failure::unfinished(
        "f, g or the law switches without end",
        "a motion along more than one jump at once, or one that a jump does not push to directly, is not followed; smooth the jump, for example tanh(x2/v) for sign(x2)",
    )
}
