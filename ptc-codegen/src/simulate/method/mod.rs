//! The methods of integration, each with states as long as the system needs: an implicit step takes the cube of it.

mod explicit;
mod implicit;

use differential_equations::error::Error;
use differential_equations::interpolate::Interpolation;
use differential_equations::linalg::Matrix;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use nalgebra::SVector;

use super::solver::{Begin, Piece};
use super::{Accuracy, Failure};
use crate::request::MAX_ORDER;
pub(super) use explicit::dormand;
pub(super) use implicit::radau;

/// A state of any order, with zeros after its last component, so that no step allocates.
pub(super) type State = SVector<f64, MAX_ORDER>;

/// An error of an integral that counts as nothing: its unit is another than that of the states, and what
/// has been accumulated does not decay. Not smaller: the relative error of an integral that begins as a power of time,
/// or that consists of rounding, does not fall with the step.
const NONE: f64 = 1e-24;

/// A right-hand side of `order` equations, of which the first are of states and the rest of integrals.
pub(super) struct Rates<'a> {
    pub(super) order: usize,
    pub(super) states: usize,
    pub(super) rates: &'a dyn Fn(f64, &State, &mut State),
}

/// A method with dense output.
pub(super) trait Method {
    fn t(&self) -> f64;

    /// Returns the start of the last step.
    fn t_prev(&self) -> f64;

    fn y(&self) -> State;

    /// The next step.
    fn h(&self) -> f64;

    fn step(&mut self) -> Result<(), Failure>;

    /// The state within the last step.
    fn within(&mut self, s: f64) -> Result<State, Failure>;

    fn set_step(&mut self, step: f64) -> Result<(), Failure>;

    /// Begins anew.
    fn restart(&mut self, at: f64, state: &State, step: f64) -> Result<(), Failure>;

    /// Says what is accurate enough for the step from here.
    fn weigh(&mut self);
}

/// A method of the library for states of `N` components.
trait Dense<const N: usize>:
    OrdinaryNumericalMethod<f64, SVector<f64, N>> + Interpolation<f64, SVector<f64, N>>
{
}

impl<const N: usize, M> Dense<N> for M where
    M: OrdinaryNumericalMethod<f64, SVector<f64, N>> + Interpolation<f64, SVector<f64, N>>
{
}

/// In what methods of the library differ.
trait Kind<const N: usize, M> {
    /// Begins the method at a point in a state, with a step.
    fn restart(
        &self,
        method: &mut M,
        system: &Short<'_, N>,
        from: (f64, SVector<f64, N>, f64),
    ) -> Result<(), Failure>;

    fn set_step(&self, method: &mut M, system: &Short<'_, N>, step: f64) -> Result<(), Failure>;

    fn weigh(&self, method: &mut M);
}

/// A method with its system.
struct Begun<'a, const N: usize, M, K> {
    system: Short<'a, N>,
    method: M,
    kind: K,
}

/// Begins a method.
fn begun<'a, const N: usize, M: Dense<N> + 'a, K: Kind<N, M> + 'a>(
    system: &'a Rates<'a>,
    method: M,
    kind: K,
    begin: Begin,
) -> Result<Box<dyn Method + 'a>, Failure> {
    let mut begun = Begun { system: Short(system), method, kind };
    begun.restart(begin.at, &begin.state, begin.step)?;
    Ok(Box::new(begun))
}

impl<const N: usize, M: Dense<N>, K: Kind<N, M>> Method for Begun<'_, N, M, K> {
    fn t(&self) -> f64 {
        self.method.t()
    }

    fn t_prev(&self) -> f64 {
        self.method.t_prev()
    }

    fn y(&self) -> State {
        wide(self.method.y())
    }

    fn h(&self) -> f64 {
        self.method.h()
    }

    fn step(&mut self) -> Result<(), Failure> {
        self.method.step(&self.system).map(drop).map_err(|error| failure(&error))
    }

    fn within(&mut self, s: f64) -> Result<State, Failure> {
        self.method.interpolate(s).map(|y| wide(&y)).map_err(|error| failure(&error))
    }

    fn set_step(&mut self, step: f64) -> Result<(), Failure> {
        self.kind.set_step(&mut self.method, &self.system, step)
    }

    fn restart(&mut self, at: f64, state: &State, step: f64) -> Result<(), Failure> {
        self.kind.restart(&mut self.method, &self.system, (at, narrow(state), step))
    }

    fn weigh(&mut self) {
        self.kind.weigh(&mut self.method);
    }
}

/// The first `N` components.
fn narrow<const N: usize>(state: &State) -> SVector<f64, N> {
    SVector::from_fn(|i, _| state[i])
}

fn wide<const N: usize>(state: &SVector<f64, N>) -> State {
    State::from_fn(|i, _| if i < N { state[i] } else { 0.0 })
}

/// A system whose order is `N` or less.
struct Short<'a, const N: usize>(&'a Rates<'a>);

impl<const N: usize> ODE<f64, SVector<f64, N>> for Short<'_, N> {
    fn diff(&self, s: f64, y: &SVector<f64, N>, rates: &mut SVector<f64, N>) {
        let mut there = State::zeros();
        (self.0.rates)(s, &wide(y), &mut there);
        *rates = narrow(&there);
    }

    /// Computes the Jacobian by differences in proportion to each component: the state decays by many powers of ten.
    fn jacobian(&self, s: f64, y: &SVector<f64, N>, jacobian: &mut Matrix<f64>) {
        let system = self.0;
        let y = wide(y);
        let (mut here, mut there) = (State::zeros(), State::zeros());
        (system.rates)(s, &y, &mut here);
        let scale = y.rows(0, system.states).amax();
        for column in 0..N {
            let mut moved = y;
            let size = y[column].abs().max(1e-3 * scale).max(1e-200) * f64::EPSILON.sqrt();
            let used = column < system.order;
            if used {
                moved[column] += size;
                (system.rates)(s, &moved, &mut there);
            }
            for row in 0..N {
                let slope = (there[row] - here[row]) / (moved[column] - y[column]);
                jacobian[(row, column)] = if used && row < system.order { slope } else { 0.0 };
            }
        }
    }
}

/// The relative accuracy that a method needs whose error is a mean over `width` components, of which `used` are used.
#[allow(clippy::cast_precision_loss)]
pub(super) fn relative_over(relative: f64, used: usize, width: usize) -> f64 {
    relative * (used as f64 / width as f64).sqrt()
}

/// Required accuracy of a method with states of `N` components.
#[derive(Clone, Copy)]
pub(super) struct Wanted<const N: usize> {
    pub(super) relative: f64,
    absolute: f64,
    floors: bool,
    states: usize,
}

impl<const N: usize> Wanted<N> {
    pub(super) fn new(system: &Rates<'_>, piece: &Piece<'_>) -> Self {
        let Accuracy { relative, absolute, .. } = piece.accuracy;
        let (floors, states) = (piece.floors, system.states);
        Self { relative: relative_over(relative, system.order, N), absolute, floors, states }
    }

    /// Returns the tolerances, where an error below `nothing` counts as nothing.
    fn tolerances(&self, nothing: f64, state: &SVector<f64, N>) -> Tolerances<N> {
        let wanted = Self { absolute: self.absolute.max(nothing), ..*self };
        (self.relative, wanted.floors(state))
    }

    /// Errors below which a component counts as accurate. Where the loop is slow against its time
    /// constants each state is much smaller than those before it, in whose rounding its rate drowns.
    fn floors(&self, state: &SVector<f64, N>) -> [f64; N] {
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

/// The relative one, and the absolute one of each component.
type Tolerances<const N: usize> = (f64, [f64; N]);

fn failure<const N: usize>(error: &Error<f64, SVector<f64, N>>) -> Failure {
    let help = "the state, f, g or the law may leave the range of numbers there, or jump; see what they are at this instant";
    match error {
        Error::StepSize { .. } => {
            Failure::unfinished("the step of the integration became too small", help)
        }
        _ => Failure::unfinished("the integration does not converge", help),
    }
}
