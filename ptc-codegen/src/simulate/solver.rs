//! Adaptive integration of a smooth system with a stop at given points and at events: Dormand and
//! Prince's methods of order 8 and 5, and Radau IIA of order 5 where the loop is stiff.
//!
//! If mu' decays like a power, stretched time reaches 1e9 s and more while time-to-go falls to
//! 1e-9 tau; there an explicit method would take a step for every time constant of the loop.
// A piece that ends early hands over its state, once.
#![allow(clippy::result_large_err)]

use super::method::{Method, Rates, State, Wanted, dormand, radau};
use super::mode::no_value;
use super::pass::{End, Monitor, Pass, Reached, Stopped, Visit};
use super::{Accuracy, Failure};
use crate::request::MAX_ORDER;

/// Steps of the explicit method at a relative accuracy of 1e-12, after which a loop counts as stiff:
/// a run that is not takes a few hundred for each time constant of ten.
const EXPLICIT: f64 = 3000.0;

/// Relative accuracy that is not loosened further.
const LOOSEST: f64 = 1e-7;

/// The method that is tried first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum First {
    /// For long runs at high accuracy.
    Eighth,
    /// For a short way that a single step often covers.
    Fifth,
}

/// Settings for the integration of a smooth piece of a run.
pub(super) struct Piece<'a> {
    pub(super) first: First,
    pub(super) accuracy: Accuracy,
    /// True if an error below the relative accuracy of the states before it counts as nothing.
    pub(super) floors: bool,
    /// Error that counts as nothing where the loop is stiff, as else a state that decays would be followed for hundreds
    /// of time constants.
    pub(super) nothing: &'a dyn Fn(f64) -> f64,
    pub(super) monitor: Option<Monitor<'a>>,
}

/// Start of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begin {
    pub(super) at: f64,
    pub(super) state: State,
    /// First step.
    pub(super) step: f64,
    /// True if it was stiff before.
    pub(super) stiff: bool,
}

/// Integrates until the last point, the end of the piece or an event.
///
/// # Errors
/// The step became too small, the state no number, or the steps too many; with the point reached.
pub(super) fn integrate(
    system: &Rates<'_>,
    begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    visit: Visit<'_>,
) -> Result<(Reached, bool), (f64, Failure)> {
    match width(system.order) {
        4 => by_turns::<4>(system, begin, piece, pass, visit),
        8 => by_turns::<8>(system, begin, piece, pass, visit),
        _ => by_turns::<MAX_ORDER>(system, begin, piece, pass, visit),
    }
}

/// Returns the number of components with which so many equations are integrated.
pub(super) fn width(order: usize) -> usize {
    [4, 8].into_iter().find(|width| order <= *width).unwrap_or(MAX_ORDER)
}

/// The same for systems of `N` equations or less.
fn by_turns<const N: usize>(
    system: &Rates<'_>,
    mut begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    visit: Visit<'_>,
) -> Result<(Reached, bool), (f64, Failure)> {
    let mut last = None;
    // Each goes on where the other does not.
    for _ in 0..2 {
        if !begin.stiff {
            match explicit::<N>(system, begin, piece, pass, last.is_none(), visit) {
                Ok(reached) => return Ok((reached, false)),
                Err((reached, wrong)) => {
                    if !finite(&reached.state) {
                        return Err((reached.at, Failure::range()));
                    }
                    begin = Begin {
                        at: reached.at,
                        state: reached.state,
                        step: reached.step,
                        stiff: true,
                    };
                    last = wrong.or(last);
                }
            }
            if pass.left == 0 || pass.stalled {
                break;
            }
        }
        match implicit::<N>(system, begin, piece, pass, visit) {
            Ok(reached) => return Ok((reached, true)),
            Err((reached, wrong)) => {
                if !finite(&reached.state) {
                    return Err((reached.at, Failure::range()));
                }
                begin = Begin { at: reached.at, state: reached.state, step: FIRST, stiff: false };
                last = wrong.or(last);
            }
        }
        if pass.left == 0 || pass.stalled {
            break;
        }
    }
    Err((begin.at, undecided(system, begin, pass, last, piece.accuracy)))
}

/// Why it does not go on.
fn undecided(
    system: &Rates<'_>,
    begin: Begin,
    pass: &Pass<'_>,
    last: Option<Failure>,
    accuracy: Accuracy,
) -> Failure {
    let mut rates = State::zeros();
    (system.rates)(begin.at, &begin.state, &mut rates);
    if !finite(&rates) {
        return no_value();
    }
    if pass.stalled {
        return Failure::unfinished(
            "the steps of the integration stay too small to reach the end of the run",
            "the loop moves ever faster there: narrow the box of initial states, or see that f, g and the law are smooth where the state goes",
        );
    }
    if pass.left == 0 || last.is_none() {
        return Failure::unfinished(
            format!("the integration takes more than {} steps", accuracy.steps),
            "see that f, g and the law are smooth where the state goes",
        );
    }
    last.unwrap_or_else(Failure::range)
}

/// Integrates by the explicit method; without a failure where only its steps are used up.
fn explicit<const N: usize>(
    system: &Rates<'_>,
    begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    limited: bool,
    visit: Visit<'_>,
) -> Result<Reached, Stopped> {
    let wanted = Wanted::<N>::new(system, piece);
    // As many as the order of the method takes for the accuracy.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let most = (EXPLICIT * (1e-12 / piece.accuracy.relative).powf(0.125)) as usize;
    let most = if limited { most.min(pass.left) } else { pass.left };
    let rest = pass.left - most;
    pass.left = most;
    let end = begun(begin, |from| dormand(piece.first, system, wanted, from))
        .and_then(|mut method| pass.run(&mut *method, piece.monitor, visit));
    pass.left += rest;
    end
}

/// A method that begins there.
fn begun<'a>(
    begin: Begin,
    method: impl FnOnce(Begin) -> Result<Box<dyn Method + 'a>, Failure>,
) -> Result<Box<dyn Method + 'a>, Stopped> {
    let Begin { at, state, step, .. } = begin;
    let here = Reached { at, state, step, end: End::Done };
    method(begin).map_err(|failure| (here, Some(failure)))
}

/// Integrates by the implicit method.
fn implicit<const N: usize>(
    system: &Rates<'_>,
    mut begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    visit: Visit<'_>,
) -> Result<Reached, Stopped> {
    let mut wanted = Wanted::<N>::new(system, piece);
    loop {
        let mut method = begun(begin, |from| radau(system, wanted, piece.nothing, from))?;
        match pass.run(&mut *method, piece.monitor, visit) {
            // If the rates round too coarsely for the tolerance, the tolerance is relaxed.
            Err((reached, Some(_))) if finite(&reached.state) && wanted.relative < LOOSEST => {
                wanted.relative *= 100.0;
                begin = Begin { at: reached.at, state: reached.state, step: FIRST, ..begin };
            }
            end => return end,
        }
    }
}

/// First step, in sigma.
pub(super) const FIRST: f64 = 1e-3;

pub(super) fn finite(state: &State) -> bool {
    state.iter().all(|x| x.is_finite())
}
