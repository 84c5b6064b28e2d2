//! The search in samples: along one coordinate after the other, as long as one of them leads on.

use std::ops::ControlFlow;

use super::candidate::Candidate;
use super::choice::{Choice, Key};
use super::coordinate::{Coordinate, LEAST_ENERGY, law, observer_poles};
use super::golden_section;
use super::numbers::Numbers;
use super::search::{End, Search};
use super::wish::{SAMPLES, Wish};

/// Most times that each coordinate is taken in turn.
const PASSES: usize = 4;

/// A line of the search.
enum Line<'a> {
    /// Values in turn.
    Values(Coordinate),
    /// The speed of poles, by golden section.
    Speed(&'a Candidate),
}

/// Chooses the keys of a loop in samples: those of a law of least energy first, then with the poles of each candidate.
pub(super) fn keys(search: &mut Search<'_>, candidates: &[Candidate]) -> ControlFlow<End> {
    let wish = search.wish;
    let Some(numbers) = wish.numbers() else { return ControlFlow::Continue(()) };
    let lines = |named| Coordinate::all(wish, &numbers, named).into_iter().map(Line::Values);
    let start = start(wish, &numbers, candidates);
    let mut best = start.clone();
    if wish.leaves_law() {
        best = best.word(Key::Poles, law(0));
        search.value(&best)?;
        // The reader may refuse such a law for the plant.
        if search.starts_with(&best) {
            best = descend(search, &numbers, &lines(true).collect::<Vec<_>>(), best)?;
        }
    }
    let mut with_speed = |from: Choice, candidate: &Candidate| {
        let all: Vec<_> = [Line::Speed(candidate)].into_iter().chain(lines(false)).collect();
        let first = from.without(&LEAST_ENERGY).and(candidate.at(candidate.first));
        descend(search, &numbers, &all, first)
    };
    for candidate in candidates {
        best = with_speed(best, candidate)?;
    }
    // Good values of the other keys for one law may lead nowhere for another.
    for candidate in candidates {
        with_speed(start.clone(), candidate)?;
    }
    ControlFlow::Continue(())
}

/// Takes the best choice of each line in turn, until none leads on.
fn descend(
    search: &mut Search<'_>,
    numbers: &Numbers,
    lines: &[Line<'_>],
    first: Choice,
) -> ControlFlow<End, Choice> {
    let mut best = first;
    for pass in 0..PASSES {
        let before = best.clone();
        for line in lines {
            best = along(search, (numbers, pass > 0), line, best)?;
        }
        if best == before {
            break;
        }
    }
    ControlFlow::Continue(best)
}

/// The best choice of a line through another one; where it is to be `finer`, with values next to that one.
fn along(
    search: &mut Search<'_>,
    (numbers, finer): (&Numbers, bool),
    line: &Line<'_>,
    from: Choice,
) -> ControlFlow<End, Choice> {
    // Counterexamples may have raised it.
    search.value(&from)?;
    let mut best = from.clone();
    let wish = search.wish;
    let mut take = |choice: Choice, limit: &dyn Fn(f64) -> f64| {
        let least = search.merit(&best);
        let value = search.value_below(&choice, limit(least))?;
        if search.merit(&choice) < least {
            best = choice;
        }
        ControlFlow::Continue(value)
    };
    match line {
        Line::Values(coordinate) => {
            let beside = if finer { coordinate.finer(wish, numbers, &from) } else { Vec::new() };
            for choice in coordinate.values(wish, numbers, &from).into_iter().chain(beside) {
                // One that meets every objective may be proved where the best one is not.
                take(choice, &|least| least.max(0.0))?;
            }
        }
        // The search compares all values.
        Line::Speed(candidate) => {
            golden_section::least(candidate.range, candidate.first, &mut |speed| {
                take(from.clone().and(candidate.at(speed)), &|_| f64::INFINITY)
            })?;
        }
    }
    ControlFlow::Continue(best)
}

/// The choice of what has to be given beside the law, to begin with.
fn start(wish: &Wish<'_>, numbers: &Numbers, candidates: &[Candidate]) -> Choice {
    let mut choice = Choice::default();
    if wish.order_in_samples().is_some() {
        choice = choice.word(Key::Clock, SAMPLES);
    }
    if wish.leaves_mapping()
        && let Some(candidate) = candidates.first()
    {
        choice = choice.and(candidate.at(candidate.first)).without(&[Key::Poles]);
    }
    if wish.lacks(Key::ObserverPoles) {
        choice = choice.with(Key::ObserverPoles, observer_poles(wish, numbers, 1));
    }
    if wish.lacks(Key::DisturbanceWalk)
        && let Some(walk) = numbers.walks().into_iter().next()
    {
        choice = choice.with(Key::DisturbanceWalk, walk);
    }
    // The checks would compare each eps where it is open, for each choice again.
    match numbers.holds().into_iter().next() {
        Some(eps) if numbers.is_bounded && wish.leaves(Key::Eps) => choice.with(Key::Eps, eps),
        _ => choice,
    }
}
