//! Adaptive integration with a stop at given points: Dormand and Prince's method of order 8, and
//! Radau IIA of order 5 from where the loop is stiff.
//!
//! Where mu' decays like a power, stretched time reaches 1e9 s and more while time-to-go falls to
//! 1e-9 tau; there an explicit method would take a step for every time constant of the loop.

use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use nalgebra::SVector;

use super::{Accuracy, Failure};
use crate::spec::MAX_ORDER;

/// A state of any order, with zeros after its last component, so that no step allocates.
pub(super) type State = SVector<f64, MAX_ORDER>;

/// Steps of the explicit method at a relative accuracy of 1e-12, after which a loop counts as stiff:
/// a run that is not takes a few hundred for each time constant of ten.
const EXPLICIT: f64 = 3000.0;

/// A right-hand side of `order` equations.
pub(super) struct Rates<F: Fn(f64, &State, &mut State)> {
    pub(super) order: usize,
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
        let scale = y.amax();
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

/// Integrates from `start` at `points[0]` and calls `visit` at each of the ascending `points`. Where
/// the loop is stiff, an error below `nothing` of the point counts as nothing, as else a state that
/// decays would be followed for hundreds of time constants.
///
/// # Errors
/// The step became too small, the state no number, or the steps too many; with the point reached.
pub(super) fn integrate<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    start: State,
    points: &[f64],
    accuracy: Accuracy,
    nothing: &dyn Fn(f64) -> f64,
    visit: &mut dyn FnMut(usize, f64, &State),
) -> Result<(), (f64, Failure)> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return Ok(()) };
    visit(0, *first, &start);
    let wanted = Wanted::new(system.order, accuracy);
    let mut explicit = ExplicitRungeKutta::dop853()
        .rtol(wanted.relative)
        .atol(wanted.floors(&start).to_vec())
        .h0(FIRST)
        .max_steps(usize::MAX);
    let begun = explicit.init(system, *first, last.max(first + 1.0), &start);
    begun.map_err(|error| (*first, failure(&error)))?;
    // As many as the order of the method takes for the accuracy.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let most = (EXPLICIT * (1e-12 / accuracy.relative).powf(0.125)) as usize;
    let mut pass = Pass { points, next: 1, left: most.min(accuracy.steps) };
    let set_step = of(&explicit, |method, h| {
        method.set_h(h);
        Ok(())
    });
    let weigh = of(&explicit, |method, _| {
        for (i, floor) in wanted.floors(method.y()).into_iter().enumerate() {
            method.atol[i] = floor;
        }
        Ok(())
    });
    match pass.run(&mut explicit, system, (&set_step, &weigh), visit) {
        Ok(()) => Ok(()),
        Err((at, Some(failure))) if !finite(explicit.y()) => Err((at, failure)),
        Err(_) => {
            pass.left = accuracy.steps.saturating_sub(most);
            let begun = (explicit.t(), *explicit.y(), explicit.h());
            stiff(system, begun, pass, (accuracy, nothing), visit)
        }
    }
}

/// The rest of a run by the implicit method.
fn stiff<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    (mut at, mut state, mut h): (f64, State, f64),
    mut pass: Pass<'_>,
    (accuracy, nothing): (Accuracy, &dyn Fn(f64) -> f64),
    visit: &mut dyn FnMut(usize, f64, &State),
) -> Result<(), (f64, Failure)> {
    let mut wanted = Wanted::new(system.order, accuracy);
    loop {
        let begin = |at, state: &State, h| {
            // It scales a tolerance once for each component, one that they share several times.
            let mut method = ImplicitRungeKutta::radau5()
                .rtol(vec![wanted.relative; MAX_ORDER])
                .atol(wanted.or(nothing(at)).floors(state).to_vec())
                .h0(h)
                .h_max(LONGEST)
                .max_steps(usize::MAX);
            let begun = method.init(system, at, at + 2.0 * h, state);
            begun.map(|_| method).map_err(|error| failure(&error))
        };
        let mut method = begin(at, &state, h).map_err(|failure| (at, failure))?;
        // It keeps matrices of its step, so another step begins anew.
        let set_step = of(&method, |method, h| {
            *method = begin(method.t(), &method.y().clone(), h)?;
            Ok(())
        });
        let weigh = of(&method, |method, at| {
            let floors = wanted.or(nothing(at)).floors(method.y());
            for (i, floor) in floors.into_iter().enumerate() {
                method.atol[i] = floor * method.rtol[i] / wanted.relative;
            }
            Ok(())
        });
        match pass.run(&mut method, system, (&set_step, &weigh), visit) {
            Ok(()) => return Ok(()),
            // What the rounding of the rates does not bear is asked for less strictly.
            Err((_, Some(_))) if finite(method.y()) && wanted.relative < LOOSEST => {
                wanted.relative *= 100.0;
                (at, state, h) = (method.t(), *method.y(), FIRST);
            }
            Err((at, wrong)) => {
                let many = format!("the integration takes more than {} steps", accuracy.steps);
                let help = "see that f, g and the law are smooth where the state goes";
                return Err((at, wrong.unwrap_or_else(|| Failure::unfinished(many, help))));
            }
        }
    }
}

/// Integrates over 0..1 from `start`, where a single step often does.
///
/// # Errors
/// As [`integrate`].
pub(super) fn across<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    start: State,
    accuracy: Accuracy,
) -> Result<State, Failure> {
    let wanted = Wanted::new(system.order, accuracy);
    let mut method = ExplicitRungeKutta::dopri5()
        .rtol(wanted.relative)
        .atol(accuracy.absolute)
        .h0(1.0)
        .max_steps(usize::MAX);
    method.init(system, 0.0, 1.0, &start).map_err(|error| failure(&error))?;
    let mut pass = Pass { points: &[0.0, 1.0], next: 1, left: accuracy.steps };
    let set_step = of(&method, |method, h| {
        method.set_h(h);
        Ok(())
    });
    let weigh = of(&method, |_, _| Ok(()));
    let end = pass.run(&mut method, system, (&set_step, &weigh), &mut |_, _, _| {});
    let stiff = || {
        Failure::unfinished(
            "the plant moves too fast for its sample period",
            "give a shorter sample period",
        )
    };
    end.map_err(|(_, wrong)| wrong.unwrap_or_else(stiff))?;
    Ok(*method.y())
}

/// First step, in sigma.
const FIRST: f64 = 1e-3;

/// Longest step of the implicit method, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// Relative accuracy that is not loosened further.
const LOOSEST: f64 = 1e-7;

/// What is accurate enough for the methods.
struct Wanted {
    relative: f64,
    absolute: f64,
}

impl Wanted {
    fn new(order: usize, accuracy: Accuracy) -> Self {
        // Their error is a mean over all components, most of which may be unused.
        #[allow(clippy::cast_precision_loss)]
        let used = (order as f64 / MAX_ORDER as f64).sqrt();
        Self { relative: accuracy.relative * used, absolute: accuracy.absolute }
    }

    /// The same with a larger error that counts as nothing.
    fn or(&self, nothing: f64) -> Self {
        Self { relative: self.relative, absolute: self.absolute.max(nothing) }
    }

    /// Errors below which a component counts as accurate. Where the loop is slow against its time
    /// constants each state is much smaller than those before it, in whose rounding its rate drowns.
    fn floors(&self, state: &State) -> [f64; MAX_ORDER] {
        let mut most = 0.0_f64;
        std::array::from_fn(|i| {
            let floor = self.relative * most + self.absolute;
            most = most.max(state[i].abs());
            floor
        })
    }
}

fn finite(state: &State) -> bool {
    state.iter().all(|x| x.is_finite())
}

/// A closure on methods of the type of `_method`, which has no name.
fn of<M, F: Fn(&mut M, f64) -> Result<(), Failure>>(_method: &M, closure: F) -> F {
    closure
}

/// What changes a method: gives it another step, and tells it what is accurate enough.
type Change<'a, M> = &'a dyn Fn(&mut M, f64) -> Result<(), Failure>;

/// What is left of a run.
struct Pass<'a> {
    points: &'a [f64],
    next: usize,
    left: usize,
}

impl Pass<'_> {
    /// Steps on until the last point; no failure where only the steps are used up.
    fn run<M, F>(
        &mut self,
        method: &mut M,
        system: &Rates<F>,
        (set_step, weigh): (Change<'_, M>, Change<'_, M>),
        visit: &mut dyn FnMut(usize, f64, &State),
    ) -> Result<(), (f64, Option<Failure>)>
    where
        M: OrdinaryNumericalMethod<f64, State>,
        F: Fn(f64, &State, &mut State),
    {
        while let Some(point) = self.points.get(self.next) {
            let (at, wanted) = (method.t(), method.h());
            // What is left is a rounding of the steps that lead here.
            if point - at <= 1e-13 * point.abs().max(1.0) {
                visit(self.next, *point, method.y());
                self.next += 1;
                continue;
            }
            if self.left == 0 {
                return Err((at, None));
            }
            self.left -= 1;
            let cut = at + wanted > *point;
            let failed = |failure| (at, Some(failure));
            if cut {
                set_step(method, point - at).map_err(failed)?;
            }
            weigh(method, at).map_err(failed)?;
            method.step(system).map_err(|error| (at, Some(failure(&error))))?;
            let longer = method.h().max(wanted);
            if cut && method.t() > at && longer > method.h() {
                set_step(method, longer).map_err(failed)?;
            }
            if !finite(method.y()) {
                return Err((at, Some(Failure::range())));
            }
        }
        Ok(())
    }
}

fn failure(error: &Error<f64, State>) -> Failure {
    let help = "the state, f, g or the law may leave the range of numbers there, or jump; see what they are at this instant";
    match error {
        Error::StepSize { .. } => {
            Failure::unfinished("the step of the integration became too small", help)
        }
        _ => Failure::unfinished("the integration does not converge", help),
    }
}
