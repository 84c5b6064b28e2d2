//! Modes of a system with kinks: the sides on which they are held, and the slide along a jump.

use super::Failure;
use super::method::State;
use super::surface::{Surface, tangent};
use super::switching::Piecewise;

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
    /// The component whose rates on both sides differ most in what they do to the distance.
    pub(super) pivot: usize,
    /// True if another rate jumps too.
    pub(super) several: bool,
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
pub(super) fn field(
    system: &mut dyn Piecewise,
    mode: &Mode,
    s: f64,
    state: &State,
    rates: &mut State,
) {
    match &mode.slide {
        None => system.rates(s, state, rates),
        Some(slide) => *rates = Tangent::of(system, mode, slide, s, state).rates,
    }
}

/// The motion along a jump at a point.
pub(super) struct Tangent {
    rates: State,
    /// Position between the rates of the mode and those beyond the jump: 0 to 1.
    pub(super) part: f64,
}

impl Tangent {
    pub(super) fn of(
        system: &mut dyn Piecewise,
        mode: &Mode,
        slide: &Slide,
        s: f64,
        state: &State,
    ) -> Self {
        let (pivot, order) = (slide.pivot, system.order());
        let (mut rates, mut beyond) = (State::zeros(), State::zeros());
        of_side(system, &slide.beyond, (s, state), &mut beyond);
        of_side(system, &mode.above, (s, state), &mut rates);
        system.choose(&mode.above);
        let kink = (slide.kink, pivot);
        let (along, across, distance) = tangent(system, kink, (s, state), (&rates, &beyond));
        let integrals = order..order + system.integrals();
        // What is left of the distance decays.
        if !slide.several {
            let kept = -(along + distance) / across;
            let part = (kept - rates[pivot]) / (beyond[pivot] - rates[pivot]);
            rates[pivot] = kept;
            integrals.for_each(|i| rates[i] += part * (beyond[i] - rates[i]));
            return Self { rates, part };
        }
        let (there, ..) = tangent(system, kink, (s, state), (&beyond, &rates));
        let here = along + across * rates[pivot];
        let part = (here + distance) / (here - there - across * beyond[pivot]);
        (0..integrals.end).for_each(|i| rates[i] += part * (beyond[i] - rates[i]));
        Self { rates, part }
    }
}

/// The rates on one side of a jump. u is another on the other side, so the integrals have their kinks where
/// they are on this one.
fn of_side(
    system: &mut dyn Piecewise,
    above: &[bool],
    (s, state): (f64, &State),
    rates: &mut State,
) {
    system.choose(above);
    let own = system.kinks() - system.kinks_of_integrals();
    if own < system.kinks() {
        let mut distances = Vec::with_capacity(system.kinks());
        let mut there = above.to_vec();
        // A kink within another one is found after that one.
        for _ in own..above.len() {
            distances.clear();
            system.distances(s, state, &mut distances);
            let found = distances[own..].iter().map(|distance| *distance > 0.0);
            let found = [&there[..own], &found.collect::<Vec<_>>()].concat();
            if found == there {
                break;
            }
            there = found;
            system.choose(&there);
        }
    }
    system.rates(s, state, rates);
}

/// Computes the margins, which are positive as long as a mode lasts: the distances from the kinks, and for a slide,
/// whose kinks do not count, the distance to both sides.
pub(super) fn margins(
    system: &mut dyn Piecewise,
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
pub(super) fn next(
    system: &mut dyn Piecewise,
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
        let other = Mode { above: flipped, slide: Some(Slide { beyond, ..slide.clone() }) };
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
fn meet(
    system: &mut dyn Piecewise,
    from: &[bool],
    to: Vec<bool>,
    (which, surface): (usize, &Surface),
    s: f64,
    state: &State,
) -> Result<Mode, Failure> {
    let [here, there] = [from, &to].map(|sides| {
        let mut rates = State::zeros();
        system.choose(sides);
        system.rates(s, state, &mut rates);
        rates
    });
    let away = side(from[which]);
    let continuous = (0..system.order()).all(|i| !jumps(&here, &there, i));
    let [before, after] = [&here, &there].map(|rates| away * surface.speed(rates));
    if continuous || after <= 0.0 {
        return Ok(Mode { above: to, slide: None });
    }
    if before >= 0.0 {
        return Ok(Mode { above: from.to_vec(), slide: None });
    }
    Ok(slide(system, (s, state), from.to_vec(), (to, which, surface)))
}

/// Returns true if rate `i` of two sides of a kink differs.
fn jumps(here: &State, there: &State, i: usize) -> bool {
    let within = (here[i] - there[i]).abs() <= 1e-9 * (here[i].abs() + there[i].abs());
    !within
}

/// The slide along a jump.
fn slide(
    system: &mut dyn Piecewise,
    (s, state): (f64, &State),
    above: Vec<bool>,
    (beyond, kink, surface): (Vec<bool>, usize, &Surface),
) -> Mode {
    let [here, there] = [&above, &beyond].map(|sides| {
        let mut rates = State::zeros();
        system.choose(sides);
        system.rates(s, state, &mut rates);
        rates
    });
    let order = system.order();
    let pivot = surface.pivot([&here, &there], order);
    let several = (0..order).any(|i| i != pivot && jumps(&here, &there, i));
    Mode { above, slide: Some(Slide { beyond, kink, pivot, several }) }
}

/// The mode in which a state begins.
pub(super) fn begin(system: &mut dyn Piecewise, s: f64, state: &State) -> Result<Mode, Failure> {
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
        if let Some(failure) = system.barrier(Some(which)) {
            return Err(failure);
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
                let sides = mode.above.iter().zip(&slide.beyond);
                for (kept, (_, other)) in beyond.iter_mut().zip(sides).filter(|(_, (a, b))| a != b)
                {
                    *kept = *other;
                }
                let slide = Some(Slide { beyond, ..slide.clone() });
                mode = Mode { above, slide };
            }
            continue;
        }
        let speed = |system: &mut dyn Piecewise, sides: &[bool]| {
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
            () if rising < 0.0 && falling > 0.0 => {
                slide(system, (s, state), up, (down, which, &surface))
            }
            () if rising >= 0.0 && falling >= 0.0 => Mode { above: up, slide: None },
            () if rising <= 0.0 && falling <= 0.0 => Mode { above: down, slide: None },
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
