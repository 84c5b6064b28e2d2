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

/// Integrates from `start` at `points[0]` and calls `visit` at each of the ascending `points`.
///
/// # Errors
/// The step became too small, the state no number, or the steps too many; with the point reached.
pub(super) fn integrate<F: Fn(f64, &State, &mut State)>(
    system: &Rates<F>,
    start: State,
    points: &[f64],
    accuracy: Accuracy,
    visit: &mut dyn FnMut(usize, f64, &State),
) -> Result<(), (f64, Failure)> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return Ok(()) };
    // The error is a mean over all components, most of which may be unused.
    #[allow(clippy::cast_precision_loss)]
    let relative = accuracy.relative * (system.order as f64 / MAX_ORDER as f64).sqrt();
    // As many as the order of the method takes for the accuracy.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let most = (EXPLICIT * (1e-12 / accuracy.relative).powf(0.125)) as usize;
    visit(0, *first, &start);
    if points.len() == 1 {
        return Ok(());
    }
    let mut explicit = ExplicitRungeKutta::dop853()
        .rtol(relative)
        .atol(accuracy.absolute)
        .h0(1e-3)
        .max_steps(usize::MAX);
    let begun = explicit.init(system, *first, last.max(first + 1.0), &start);
    begun.map_err(|error| (*first, failure(&error)))?;
    let mut pass = Pass { points, next: 1, left: most.min(accuracy.steps) };
    let cut = |method: &mut _, h| {
        OrdinaryNumericalMethod::<f64, State>::set_h(method, h);
        Ok(())
    };
    match pass.run(&mut explicit, system, &cut, visit) {
        Ok(()) => return Ok(()),
        Err((at, Some(failure))) if !explicit.y().iter().all(|x| x.is_finite()) => {
            return Err((at, failure));
        }
        Err(_) => {}
    }
    pass.left = accuracy.steps.saturating_sub(most);
    let restarted = |at, state: &State, h| {
        // It scales the tolerances once for each component, one that they share several times.
        let mut implicit = ImplicitRungeKutta::radau5()
            .rtol(vec![relative; MAX_ORDER])
            .atol(vec![accuracy.absolute; MAX_ORDER])
            .h0(h)
            .max_steps(usize::MAX);
        let begun = implicit.init(system, at, last.max(at + 2.0 * h), state);
        begun.map(|_| implicit).map_err(|error| failure(&error))
    };
    let (at, state, h) = (explicit.t(), *explicit.y(), explicit.h());
    let mut implicit = restarted(at, &state, h).map_err(|failure| (at, failure))?;
    let many = || {
        Failure::new(
            format!("the integration takes more than {} steps", accuracy.steps),
            "see that f, g and the law are smooth where the state goes",
        )
    };
    // It keeps matrices of its step, so another step begins anew.
    let cut = &|method: &mut _, h| {
        let (at, state) = here(method);
        *method = restarted(at, &state, h)?;
        Ok(())
    };
    let end = pass.run(&mut implicit, system, cut, visit);
    end.map_err(|(at, wrong)| (at, wrong.unwrap_or_else(many)))
}

fn here(method: &impl OrdinaryNumericalMethod<f64, State>) -> (f64, State) {
    (method.t(), *method.y())
}

/// What gives a method another step.
type SetStep<'a, M> = &'a dyn Fn(&mut M, f64) -> Result<(), Failure>;

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
        set_step: SetStep<'_, M>,
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
            method.step(system).map_err(|error| (at, Some(failure(&error))))?;
            let longer = method.h().max(wanted);
            if cut && method.t() > at && longer > method.h() {
                set_step(method, longer).map_err(failed)?;
            }
            if !method.y().iter().all(|x| x.is_finite()) {
                return Err((at, Some(too_large())));
            }
        }
        Ok(())
    }
}

fn too_large() -> Failure {
    Failure::new("the state leaves the range of numbers", "the loop is unstable with these values")
}

fn failure(error: &Error<f64, State>) -> Failure {
    let help = "the state, f, g or the law may leave the range of numbers there, or jump; see what they are at this instant";
    match error {
        Error::StepSize { .. } => {
            Failure::new("the step of the integration became too small", help)
        }
        _ => Failure::new("the integration does not converge", help),
    }
}
