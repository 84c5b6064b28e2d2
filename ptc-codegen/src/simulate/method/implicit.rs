//! Radau's method, for a loop that is stiff.

use differential_equations::methods::ImplicitRungeKutta;
use nalgebra::SVector;

use super::{Dense, Kind, Method, Rates, Short, Tolerances, Wanted, begun, failure, narrow};
use crate::simulate::Failure;
use crate::simulate::solver::Begin;

/// Longest step of the implicit method, in sigma: time-to-go falls by a factor of e.
const LONGEST: f64 = 1.0;

/// An implicit method, whose type has no name.
struct Implicit<'a, const N: usize, M> {
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
) -> Result<Box<dyn Method + 'a>, Failure> {
    // It scales a tolerance once for each component, one that they share several times.
    let new: fn(Tolerances<N>, f64) -> _ = |(relative, floors), step| {
        let method = ImplicitRungeKutta::radau5().rtol(vec![relative; N]).atol(floors.to_vec());
        method.h0(step).h_max(LONGEST).max_steps(usize::MAX)
    };
    let method = new(wanted.tolerances(nothing(begin.at), &narrow(&begin.state)), begin.step);
    let kind = Implicit {
        wanted,
        nothing,
        new,
        set: |method, (relative, floors)| {
            for (i, floor) in floors.into_iter().enumerate() {
                method.atol[i] = floor * method.rtol[i] / relative;
            }
        },
    };
    begun(system, method, kind, begin)
}

impl<const N: usize, M: Dense<N>> Kind<N, M> for Implicit<'_, N, M> {
    fn restart(
        &self,
        method: &mut M,
        system: &Short<'_, N>,
        (at, state, step): (f64, SVector<f64, N>, f64),
    ) -> Result<(), Failure> {
        *method = (self.new)(self.wanted.tolerances((self.nothing)(at), &state), step);
        let begun = method.init(system, at, at + 2.0 * step, &state);
        begun.map(drop).map_err(|error| failure(&error))
    }

    /// It keeps matrices of its step, so another step begins anew.
    fn set_step(&self, method: &mut M, system: &Short<'_, N>, step: f64) -> Result<(), Failure> {
        let here = (method.t(), *method.y(), step);
        self.restart(method, system, here)
    }

    fn weigh(&self, method: &mut M) {
        let nothing = (self.nothing)(method.t());
        let tolerances = self.wanted.tolerances(nothing, method.y());
        (self.set)(method, tolerances);
    }
}
