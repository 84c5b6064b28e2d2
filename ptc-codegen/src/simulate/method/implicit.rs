//! Radau's method, for a loop that is stiff.

use differential_equations::interpolate::Interpolation;
use differential_equations::methods::ImplicitRungeKutta;
use differential_equations::ode::OrdinaryNumericalMethod;
use nalgebra::SVector;

use super::{Method, Rates, Short, State, Tolerances, Wanted, failure, narrow, wide};
use crate::simulate::Failure;
use crate::simulate::solver::Begin;

/// Longest step of the implicit method, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// An implicit method, whose type has no name.
struct Implicit<'a, const N: usize, M> {
    system: Short<'a, N>,
    method: M,
    wanted: Wanted<N>,
    nothing: &'a dyn Fn(f64) -> f64,
    new: fn(Tolerances<N>, f64) -> M,
    set: fn(&mut M, Tolerances<N>),
}

/// Radau IIA of order 5.
pub(in crate::simulate) fn radau<'a, const N: usize>(
    system: &'a Rates<'a>,
    wanted: Wanted<N>,
    nothing: &'a dyn Fn(f64) -> f64,
    begin: Begin,
) -> Result<impl Method + 'a, Failure> {
    // It scales a tolerance once for each component, one that they share several times.
    let new: fn(Tolerances<N>, f64) -> _ = |(relative, floors), step| {
        let method = ImplicitRungeKutta::radau5().rtol(vec![relative; N]).atol(floors.to_vec());
        method.h0(step).h_max(LONGEST).max_steps(usize::MAX)
    };
    let Begin { at, state, step, .. } = begin;
    let mut method = new(wanted.tolerances(nothing(at), &narrow(&state)), step);
    let set = of(&mut method, |method, (relative, floors)| {
        for (i, floor) in floors.into_iter().enumerate() {
            method.atol[i] = floor * method.rtol[i] / relative;
        }
    });
    let mut begun = Implicit { system: Short(system), method, wanted, nothing, new, set };
    begun.restart(at, &state, step)?;
    Ok(begun)
}

/// A function on methods of the type of `_method`.
fn of<const N: usize, M>(
    _method: &mut M,
    set: fn(&mut M, Tolerances<N>),
) -> fn(&mut M, Tolerances<N>) {
    set
}

impl<const N: usize, M> Method for Implicit<'_, N, M>
where
    M: OrdinaryNumericalMethod<f64, SVector<f64, N>> + Interpolation<f64, SVector<f64, N>>,
{
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

    /// It keeps matrices of its step, so another step begins anew.
    fn set_step(&mut self, step: f64) -> Result<(), Failure> {
        let (at, state) = (self.t(), self.y());
        self.restart(at, &state, step)
    }

    fn restart(&mut self, at: f64, state: &State, step: f64) -> Result<(), Failure> {
        let state = narrow(state);
        self.method = (self.new)(self.wanted.tolerances((self.nothing)(at), &state), step);
        let begun = self.method.init(&self.system, at, at + 2.0 * step, &state);
        begun.map(drop).map_err(|error| failure(&error))
    }

    fn weigh(&mut self) {
        let nothing = (self.nothing)(self.t());
        let tolerances = self.wanted.tolerances(nothing, self.method.y());
        (self.set)(&mut self.method, tolerances);
    }
}
