//! Adaptive integration of a smooth system with a stop at given points and at events: Dormand and
//! Prince's methods of order 8 and 5, and Radau IIA of order 5 where the loop is stiff.
//!
//! Where mu' decays like a power, stretched time reaches 1e9 s and more while time-to-go falls to
//! 1e-9 tau; there an explicit method would take a step for every time constant of the loop.
// A piece that ends early hands over its state, once.
#![allow(clippy::result_large_err)]

use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use nalgebra::SVector;

use super::mode::no_value;
use super::pass::{Change, End, Method, Monitor, Pass, Reached, Visit, of};
use super::{Accuracy, Failure};
use crate::request::MAX_ORDER;

/// A state of any order, with zeros after its last component, so that no step allocates.
pub(super) type State = SVector<f64, MAX_ORDER>;

/// Steps of the explicit method at a relative accuracy of 1e-12, after which a loop counts as stiff:
/// a run that is not takes a few hundred for each time constant of ten.
const EXPLICIT: f64 = 3000.0;

/// Longest step of the implicit method, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// Relative accuracy that is not loosened further.
const LOOSEST: f64 = 1e-7;

/// A right-hand side of `order` equations, of which the first are of states and the rest of integrals.
pub(super) struct Rates<F: Fn(f64, &State, &mut State)> {
    pub(super) order: usize,
    pub(super) states: usize,
    pub(super) rates: F,
}

impl<F: Fn(f64, &State, &mut State)> ODE<f64, State> for Rates<F> {
    fn diff(&self, s: f64, y: &State, rates: &mut State) {
        (self.rates)(s, y, rates);
    }

    /// By differences in proportion to each component: the state decays by many powers of ten.
    fn jacobian(&self, s: f64, y: &State, jacobian: &mut Matrix<f64>) {
        let (mut here, mut there) = (State::zeros(), State::zeros());
        (self.rates)(s, y, &mut here);
        let scale = y.rows(0, self.states).amax();
        for column in 0..MAX_ORDER {
            let mut moved = *y;
            let size = y[column].abs().max(1e-3 * scale).max(1e-200) * f64::EPSILON.sqrt();
            let used = column < self.order;
            if used {
                moved[column] += size;
                (self.rates)(s, &moved, &mut there);
            }
            for row in 0..MAX_ORDER {
                let slope = (there[row] - here[row]) / (moved[column] - y[column]);
                jacobian[(row, column)] = if used && row < self.order { slope } else { 0.0 };
            }
        }
    }
}

/// The method that is tried first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum First {
    /// For long runs at high accuracy.
    Eighth,
    /// For a short way that a single step often covers.
    Fifth,
}

/// How a smooth piece of a run is integrated.
pub(super) struct Piece<'a> {
    pub(super) first: First,
    pub(super) accuracy: Accuracy,
    /// Whether an error below the relative accuracy of the states before it counts as nothing.
    pub(super) floors: bool,
    /// Where the loop is stiff, an error below this counts as nothing, as else a state that decays
    /// would be followed for hundreds of time constants.
    pub(super) nothing: &'a dyn Fn(f64) -> f64,
    pub(super) monitor: Option<Monitor<'a>>,
}

/// Where a piece begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begin {
    pub(super) at: f64,
    pub(super) state: State,
    /// First step.
    pub(super) step: f64,
    /// Whether it was stiff before.
    pub(super) stiff: bool,
}

/// Integrates until the last point, the end of the piece or an event.
///
/// # Errors
/// The step became too small, the state no number, or the steps too many; with the point reached.
pub(super) fn integrate<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    mut begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    visit: Visit<'_>,
) -> Result<(Reached, bool), (f64, Failure)> {
    let mut last = None;
    // Each goes on where the other does not.
    for _ in 0..2 {
        if !begin.stiff {
            match explicit(system, begin, piece, pass, last.is_none(), visit) {
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
            if pass.left == 0 {
                break;
            }
        }
        match implicit(system, begin, piece, pass, visit) {
            Ok(reached) => return Ok((reached, true)),
            Err((reached, wrong)) => {
                if !finite(&reached.state) {
                    return Err((reached.at, Failure::range()));
                }
                begin = Begin { at: reached.at, state: reached.state, step: FIRST, stiff: false };
                last = wrong.or(last);
            }
        }
        if pass.left == 0 {
            break;
        }
    }
    Err((begin.at, undecided(system, begin, pass, last, piece.accuracy)))
}

/// Why it does not go on.
fn undecided<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
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
    if pass.left == 0 || last.is_none() {
        return Failure::unfinished(
            format!("the integration takes more than {} steps", accuracy.steps),
            "see that f, g and the law are smooth where the state goes",
        );
    }
    last.unwrap_or_else(Failure::range)
}

/// By the explicit method; without a failure where only its steps are used up.
fn explicit<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    limited: bool,
    visit: Visit<'_>,
) -> Result<Reached, (Reached, Option<Failure>)> {
    let wanted = Wanted::new(system, piece);
    // As many as the order of the method takes for the accuracy.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let most = (EXPLICIT * (1e-12 / piece.accuracy.relative).powf(0.125)) as usize;
    let most = if limited { most.min(pass.left) } else { pass.left };
    let rest = pass.left - most;
    pass.left = most;
    let atol = wanted.floors(&begin.state).to_vec();
    let end = match piece.first {
        First::Eighth => {
            let method = ExplicitRungeKutta::dop853().rtol(wanted.relative).atol(atol);
            let mut method = method.h0(begin.step).max_steps(usize::MAX);
            let weigh = of(&method, |method, _| {
                for (i, floor) in wanted.floors(method.y()).into_iter().enumerate() {
                    method.atol[i] = floor;
                }
                Ok(())
            });
            explicit_pass(system, begin, &mut method, &weigh, (pass, piece), visit)
        }
        First::Fifth => {
            let method = ExplicitRungeKutta::dopri5().rtol(wanted.relative).atol(atol);
            let mut method = method.h0(begin.step).max_steps(usize::MAX);
            let weigh = of(&method, |_, _| Ok(()));
            explicit_pass(system, begin, &mut method, &weigh, (pass, piece), visit)
        }
    };
    pass.left += rest;
    end
}

fn explicit_pass<M: Method, F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    begin: Begin,
    method: &mut M,
    weigh: &dyn Fn(&mut M, f64) -> Result<(), Failure>,
    (pass, piece): (&mut Pass<'_>, &Piece<'_>),
    visit: Visit<'_>,
) -> Result<Reached, (Reached, Option<Failure>)> {
    let restart = of_restart(method, |method, at, state: &State, step| {
        // The end only bounds the first step.
        method.init(system, at, at + 1e9, state).map_err(|error| failure(&error))?;
        method.set_h(step);
        Ok(())
    });
    let set_step = of(method, |method, step| {
        method.set_h(step);
        Ok(())
    });
    let change = Change { set_step: &set_step, restart: &restart, weigh };
    pass.begin(method, begin.at, &begin.state, begin.step, &change)?;
    pass.run(method, system, &change, piece.monitor, visit)
}

/// By the implicit method.
fn implicit<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    begin: Begin,
    piece: &Piece<'_>,
    pass: &mut Pass<'_>,
    visit: Visit<'_>,
) -> Result<Reached, (Reached, Option<Failure>)> {
    let mut wanted = Wanted::new(system, piece);
    let Begin { mut at, mut state, mut step, .. } = begin;
    loop {
        let new = |at, state: &State, step| {
            // It scales a tolerance once for each component, one that they share several times.
            let mut method = ImplicitRungeKutta::radau5()
                .rtol(vec![wanted.relative; MAX_ORDER])
                .atol(wanted.or((piece.nothing)(at)).floors(state).to_vec())
                .h0(step)
                .h_max(LONGEST)
                .max_steps(usize::MAX);
            let begun = method.init(system, at, at + 2.0 * step, state);
            begun.map(|_| method).map_err(|error| failure(&error))
        };
        let here = Reached { at, state, step, end: End::Done };
        let mut method = new(at, &state, step).map_err(|failure| (here, Some(failure)))?;
        // It keeps matrices of its step, so another step begins anew.
        let restart = of_restart(&method, |method, at, state: &State, step| {
            *method = new(at, state, step)?;
            Ok(())
        });
        let set_step = of(&method, |method, step| {
            *method = new(method.t(), &method.y().clone(), step)?;
            Ok(())
        });
        let weigh = of(&method, |method, at| {
            let floors = wanted.or((piece.nothing)(at)).floors(method.y());
            for (i, floor) in floors.into_iter().enumerate() {
                method.atol[i] = floor * method.rtol[i] / wanted.relative;
            }
            Ok(())
        });
        let change = Change { set_step: &set_step, restart: &restart, weigh: &weigh };
        match pass.run(&mut method, system, &change, piece.monitor, visit) {
            Ok(reached) => return Ok(reached),
            // If the rates round too coarsely for the tolerance, the tolerance is relaxed.
            Err((reached, Some(_))) if finite(&reached.state) && wanted.relative < LOOSEST => {
                wanted.relative *= 100.0;
                (at, state, step) = (reached.at, reached.state, FIRST);
            }
            Err(wrong) => return Err(wrong),
        }
    }
}

/// First step, in sigma.
pub(super) const FIRST: f64 = 1e-3;

/// What is accurate enough for the methods.
struct Wanted {
    relative: f64,
    absolute: f64,
    floors: bool,
    states: usize,
}

/// An error of an integral that counts as nothing: its unit is another than that of the states, and what
/// has been accumulated does not decay.
const NONE: f64 = 1e-280;

impl Wanted {
    fn new<F: Fn(f64, &State, &mut State)>(system: &Rates<F>, piece: &Piece<'_>) -> Self {
        // Their error is a mean over all components, most of which may be unused.
        #[allow(clippy::cast_precision_loss)]
        let used = (system.order as f64 / MAX_ORDER as f64).sqrt();
        let Accuracy { relative, absolute, .. } = piece.accuracy;
        let (floors, states) = (piece.floors, system.states);
        Self { relative: relative * used, absolute, floors, states }
    }

    /// The same with a larger error that counts as nothing.
    fn or(&self, nothing: f64) -> Self {
        Self { absolute: self.absolute.max(nothing), ..*self }
    }

    /// Errors below which a component counts as accurate. Where the loop is slow against its time
    /// constants each state is much smaller than those before it, in whose rounding its rate drowns.
    fn floors(&self, state: &State) -> [f64; MAX_ORDER] {
        let mut most = 0.0_f64;
        std::array::from_fn(|i| {
            if i >= self.states {
                return NONE;
            }
            let floor = self.relative * most + self.absolute;
            if self.floors {
                most = most.max(state[i].abs());
            }
            floor
        })
    }
}

pub(super) fn finite(state: &State) -> bool {
    state.iter().all(|x| x.is_finite())
}

/// A closure that begins a method of the type of `_method` anew.
fn of_restart<M, F>(_method: &M, closure: F) -> F
where
    F: Fn(&mut M, f64, &State, f64) -> Result<(), Failure>,
{
    closure
}

pub(super) fn failure(error: &Error<f64, State>) -> Failure {
    let help = "the state, f, g or the law may leave the range of numbers there, or jump; see what they are at this instant";
    match error {
        Error::StepSize { .. } => {
            Failure::unfinished("the step of the integration became too small", help)
        }
        _ => Failure::unfinished("the integration does not converge", help),
    }
}
