//! Systems that are smooth up to kinks and jumps: integrated piece by piece, and slid along a jump
//! to which both sides push, after Filippov.
//!
//! A kink is where its distance is 0. In a mode every kink is held on one of its sides, so that the
//! rates are smooth, and the mode ends where a distance changes its sign. Only the last rate has
//! kinks, as in every chain of integrators: on a surface it is what keeps the distance at 0, which is
//! Filippov's convex combination as long as it lies between the last rates of the two sides.

use std::cell::RefCell;

use super::pass::{End, Pass};
use super::solver::{Begin, FIRST, First, Piece, Rates, State, integrate};
use super::surface::{Surface, tangent};
use super::{Accuracy, Failure};

/// A system with kinks.
pub(super) trait Piecewise {
    /// Number of equations.
    fn order(&self) -> usize;

    /// The rates, with the kinks held as chosen.
    fn rates(&mut self, s: f64, state: &State, rates: &mut State);

    /// Number of kinks.
    fn kinks(&self) -> usize;

    /// The distances from the kinks.
    fn distances(&mut self, s: f64, state: &State, into: &mut Vec<f64>);

    /// Holds every kink above or below 0.
    fn choose(&mut self, above: &[bool]);

    /// The form in which the state is integrated from here on, and how far at most.
    fn form(&mut self, s: f64, state: &State, slides: bool) -> (State, f64) {
        let _ = (s, slides);
        (*state, f64::INFINITY)
    }

    /// Whether an error below the relative accuracy of the states before it counts as nothing.
    fn floors(&self) -> bool;

    /// An error that counts as nothing where the system is stiff.
    fn nothing(&mut self, s: f64) -> f64;
}

/// Sides on which the kinks are held.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mode {
    pub(super) above: Vec<bool>,
    pub(super) slide: Option<Slide>,
}

/// Motion along a jump.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Slide {
    /// The sides of all kinks beyond the jump.
    pub(super) beyond: Vec<bool>,
    /// A kink of the jump.
    pub(super) kink: usize,
}

/// Where a run stands beside its state.
#[derive(Clone, Debug, Default)]
pub(super) struct Walk {
    mode: Option<Mode>,
    stiff: bool,
    step: f64,
}

/// What sees a point: the system, the index of the point, where it is, the state, and the part of
/// the way beyond a jump along which it slides.
pub(super) type See<'a, S> = &'a mut dyn FnMut(&mut S, usize, f64, &State, Option<(&Mode, f64)>);

/// Most events of a run.
const EVENTS: usize = 20_000;

/// Most events at one instant, for each kink.
const AT_ONCE: usize = 4;

impl Walk {
    /// Integrates from `start` at `points[0]` to the last of the ascending points, and sees each.
    ///
    /// # Errors
    /// With the point reached.
    pub(super) fn on<S: Piecewise>(
        &mut self,
        system: &mut S,
        start: State,
        points: &[f64],
        (first, accuracy): (First, Accuracy),
        see: See<'_, S>,
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
                let last = system.order() - 1;
                Surface::of(system, slide.kink, at, &formed).project(&mut formed, last);
            }
            let (floors, kinks, order) = (system.floors(), system.kinks(), system.order());
            pass.until = at + length;
            let cell = RefCell::new((&mut *system, &mut *see));
            let rates = |s: f64, y: &State, rates: &mut State| {
                field(&mut *cell.borrow_mut().0, &mode, s, y, rates);
            };
            let nothing = |s: f64| cell.borrow_mut().0.nothing(s);
            let monitor = |s: f64, y: &State, values: &mut Vec<f64>| {
                margins(&mut *cell.borrow_mut().0, &mode, s, y, values);
            };
            let mut visit = |index: usize, s: f64, y: &State| {
                let (system, see) = &mut *cell.borrow_mut();
                let slide =
                    mode.slide.as_ref().map(|slide| Tangent::of(*system, &mode, slide, s, y));
                system.choose(&mode.above);
                see(system, index, s, y, slide.map(|tangent| (&mode, tangent.part)));
            };
            let piece = Piece {
                first,
                accuracy,
                floors,
                nothing: &nothing,
                monitor: (kinks > 0).then_some(&monitor),
            };
            let begin = Begin { at, state: formed, step, stiff: self.stiff && floors };
            let rates = Rates { order, rates };
            let (reached, stiff) = integrate(&rates, begin, &piece, &mut pass, &mut visit)?;
            drop(rates);
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
    fn resume<S: Piecewise>(
        &mut self,
        system: &mut S,
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

fn endless() -> Failure {
    Failure::unfinished(
        "f, g or the law switches without end",
        "a motion along more than one jump at once, or one that a jump does not push to directly, is not followed; smooth the jump, for example tanh(x2/v) for sign(x2)",
    )
}

/// A function that is not defined where the state is.
pub(super) fn no_value() -> Failure {
    Failure::unfinished(
        "f, g or the law has no finite value",
        "see what they are at this instant, for example a quotient with 0 below, or the square root of a negative number",
    )
}

fn several() -> Failure {
    Failure::unfinished(
        "the state slides along two jumps of f, g or the law at once",
        "one jump at a time is followed; smooth one of them, for example tanh(x2/v) for sign(x2)",
    )
}

/// The rates of a mode.
fn field<S: Piecewise>(system: &mut S, mode: &Mode, s: f64, state: &State, rates: &mut State) {
    match &mode.slide {
        None => system.rates(s, state, rates),
        Some(slide) => *rates = Tangent::of(system, mode, slide, s, state).rates,
    }
}

/// The motion along a jump at a point.
struct Tangent {
    rates: State,
    /// How far it is from the last rate of the mode to that beyond the jump: 0 to 1.
    part: f64,
}

impl Tangent {
    fn of<S: Piecewise>(system: &mut S, mode: &Mode, slide: &Slide, s: f64, state: &State) -> Self {
        let last = system.order() - 1;
        let (mut rates, mut beyond) = (State::zeros(), State::zeros());
        system.choose(&slide.beyond);
        system.rates(s, state, &mut beyond);
        system.choose(&mode.above);
        system.rates(s, state, &mut rates);
        let (along, across, distance) = tangent(system, slide.kink, (s, state), (&rates, &beyond));
        // What is left of the distance decays.
        let kept = -(along + distance) / across;
        let part = (kept - rates[last]) / (beyond[last] - rates[last]);
        rates[last] = kept;
        Self { rates, part }
    }
}

/// What is positive as long as a mode lasts: the distances from the kinks, and of a slide, whose kinks
/// do not count, how far it is to both sides.
fn margins<S: Piecewise>(
    system: &mut S,
    mode: &Mode,
    s: f64,
    state: &State,
    values: &mut Vec<f64>,
) {
    let signed = |values: &mut Vec<f64>| {
        for (value, above) in values.iter_mut().zip(&mode.above) {
            *value *= if *above { 1.0 } else { -1.0 };
        }
    };
    values.clear();
    system.choose(&mode.above);
    system.distances(s, state, values);
    signed(values);
    if let Some(slide) = &mode.slide {
        let part = Tangent::of(system, mode, slide, s, state).part;
        let mut beyond = Vec::new();
        system.choose(&slide.beyond);
        system.distances(s, state, &mut beyond);
        signed(&mut beyond);
        system.choose(&mode.above);
        for (kink, value) in values.iter_mut().enumerate() {
            let of_jump = mode.above[kink] != slide.beyond[kink];
            *value = if of_jump { 1.0 } else { *value + part * (beyond[kink] - *value) };
        }
        values.extend([part, 1.0 - part]);
    }
}

/// The mode after an event.
fn next<S: Piecewise>(
    system: &mut S,
    mode: &Mode,
    which: usize,
    s: f64,
    state: &State,
) -> Result<Mode, Failure> {
    let kinks = mode.above.len();
    if let (Some(slide), true) = (&mode.slide, which >= kinks) {
        let above = if which == kinks { &mode.above } else { &slide.beyond };
        return Ok(Mode { above: above.clone(), slide: None });
    }
    let flip = |sides: &[bool], surface: &Surface| {
        let sides = sides.iter().zip(&surface.members);
        sides.map(|(above, member)| above ^ member).collect::<Vec<_>>()
    };
    system.choose(&mode.above);
    let surface = Surface::of(system, which, s, state);
    let flipped = flip(&mode.above, &surface);
    if let Some(slide) = &mode.slide {
        let mut beyond = flip(&slide.beyond, &surface);
        // The jump itself keeps its two sides.
        for kink in 0..kinks {
            if mode.above[kink] != slide.beyond[kink] {
                beyond[kink] = !flipped[kink];
            }
        }
        let other = Mode { above: flipped, slide: Some(Slide { beyond, kink: slide.kink }) };
        let mut rates = State::zeros();
        field(system, &other, s, state, &mut rates);
        if surface.speed(&rates) * side(mode.above[which]) > surface.noise(&rates) {
            return Err(several());
        }
        return Ok(other);
    }
    meet(system, &mode.above, flipped, (which, &surface), s, state)
}

/// Crosses a surface from the sides `from` to the sides `to`, or slides along it.
fn meet<S: Piecewise>(
    system: &mut S,
    from: &[bool],
    to: Vec<bool>,
    (which, surface): (usize, &Surface),
    s: f64,
    state: &State,
) -> Result<Mode, Failure> {
    let last = system.order() - 1;
    let (mut here, mut there) = (State::zeros(), State::zeros());
    system.choose(from);
    system.rates(s, state, &mut here);
    system.choose(&to);
    system.rates(s, state, &mut there);
    let away = side(from[which]);
    let continuous =
        (here[last] - there[last]).abs() <= 1e-9 * (here[last].abs() + there[last].abs());
    let [before, after] = [&here, &there].map(|rates| away * surface.speed(rates));
    if continuous || after <= 0.0 {
        return Ok(Mode { above: to, slide: None });
    }
    if before >= 0.0 {
        return Ok(Mode { above: from.to_vec(), slide: None });
    }
    Ok(Mode { above: from.to_vec(), slide: Some(Slide { beyond: to, kink: which }) })
}

/// The mode in which a state begins.
fn begin<S: Piecewise>(system: &mut S, s: f64, state: &State) -> Result<Mode, Failure> {
    let kinks = system.kinks();
    let mut above = vec![true; kinks];
    let mut distances = Vec::new();
    // A distance may depend on the sides of other kinks.
    for _ in 0..=kinks {
        system.choose(&above);
        distances.clear();
        system.distances(s, state, &mut distances);
        let found: Vec<_> = distances.iter().map(|distance| *distance >= 0.0).collect();
        if found == above {
            break;
        }
        above = found;
    }
    let mut mode = Mode { above, slide: None };
    let mut settled = vec![false; kinks];
    for which in 0..kinks {
        if settled[which] || distances[which] != 0.0 {
            continue;
        }
        system.choose(&mode.above);
        let surface = Surface::of(system, which, s, state);
        settled.iter_mut().zip(&surface.members).for_each(|(settled, member)| *settled |= member);
        // Kinks of one surface that face opposite ways are on opposite sides of it.
        let sides = |on: bool| -> Vec<bool> {
            let kinks = mode.above.iter().zip(&surface.members).zip(&surface.along);
            kinks
                .map(|((above, member), along)| if *member { *along == on } else { *above })
                .collect()
        };
        let (up, down) = (sides(true), sides(false));
        if let Some(slide) = &mode.slide {
            let mut rates = State::zeros();
            field(system, &mode, s, state, &mut rates);
            let speed = surface.speed(&rates);
            if speed != 0.0 {
                let above = if speed > 0.0 { up } else { down };
                let mut beyond = above.clone();
                for kink in 0..kinks {
                    if mode.above[kink] != slide.beyond[kink] {
                        beyond[kink] = slide.beyond[kink];
                    }
                }
                let slide = Some(Slide { beyond, kink: slide.kink });
                mode = Mode { above, slide };
            }
            continue;
        }
        let speed = |system: &mut S, sides: &[bool]| {
            let mut rates = State::zeros();
            system.choose(sides);
            system.rates(s, state, &mut rates);
            surface.speed(&rates)
        };
        let (rising, falling) = (speed(system, &up), speed(system, &down));
        if rising.is_nan() || falling.is_nan() {
            return Err(no_value());
        }
        mode = match () {
            () if rising >= 0.0 && falling >= 0.0 => Mode { above: up, slide: None },
            () if rising <= 0.0 && falling <= 0.0 => Mode { above: down, slide: None },
            () if rising < 0.0 => {
                Mode { above: up, slide: Some(Slide { beyond: down, kink: which }) }
            }
            () => {
                return Err(Failure::unfinished(
                    "two motions begin at a jump of f, g or the law, which pushes away on both sides",
                    "begin the run beside it",
                ));
            }
        };
    }
    Ok(mode)
}

fn side(above: bool) -> f64 {
    if above { 1.0 } else { -1.0 }
}
