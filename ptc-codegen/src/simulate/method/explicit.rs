//! Dormand and Prince's methods.

use differential_equations::methods::{DormandPrince, ExplicitRungeKutta, Ordinary};
use differential_equations::ode::OrdinaryNumericalMethod;
use nalgebra::SVector;

use super::{Dense, Kind, Method, Rates, Short, Wanted, begun, failure, narrow};
use crate::simulate::Failure;
use crate::simulate::solver::{Begin, First};

type Dormand<const N: usize, const O: usize, const S: usize, const I: usize> =
    ExplicitRungeKutta<Ordinary, DormandPrince, f64, SVector<f64, N>, O, S, I>;

/// An explicit method.
struct Explicit<const N: usize> {
    /// `None`: what is accurate enough stays as it is at the start.
    wanted: Option<Wanted<N>>,
}

/// The method of order 8 or 5.
pub(in crate::simulate) fn dormand<'a, const N: usize>(
    first: First,
    system: &'a Rates<'a>,
    wanted: Wanted<N>,
    begin: Begin,
) -> Result<Box<dyn Method + 'a>, Failure> {
    match first {
        First::Eighth => {
            let method = with_tolerances(ExplicitRungeKutta::dop853(), wanted, begin);
            begun(system, method, Explicit { wanted: Some(wanted) }, begin)
        }
        First::Fifth => {
            let method = with_tolerances(ExplicitRungeKutta::dopri5(), wanted, begin);
            begun(system, method, Explicit { wanted: None }, begin)
        }
    }
}

fn with_tolerances<const N: usize, const O: usize, const S: usize, const I: usize>(
    method: Dormand<N, O, S, I>,
    wanted: Wanted<N>,
    begin: Begin,
) -> Dormand<N, O, S, I> {
    let floors = wanted.floors(&narrow(&begin.state)).to_vec();
    method.rtol(wanted.relative).atol(floors).h0(begin.step).max_steps(usize::MAX)
}

impl<const N: usize, const O: usize, const S: usize, const I: usize> Kind<N, Dormand<N, O, S, I>>
    for Explicit<N>
where
    Dormand<N, O, S, I>: Dense<N>,
{
    fn restart(
        &self,
        method: &mut Dormand<N, O, S, I>,
        system: &Short<'_, N>,
        (at, state, step): (f64, SVector<f64, N>, f64),
    ) -> Result<(), Failure> {
        // The end only bounds the first step.
        method.init(system, at, at + 1e9, &state).map_err(|error| failure(&error))?;
        method.set_h(step);
        Ok(())
    }

    fn set_step(
        &self,
        method: &mut Dormand<N, O, S, I>,
        _: &Short<'_, N>,
        step: f64,
    ) -> Result<(), Failure> {
        method.set_h(step);
        Ok(())
    }

    fn weigh(&self, method: &mut Dormand<N, O, S, I>) {
        if let Some(wanted) = &self.wanted {
            for (i, floor) in wanted.floors(method.y()).into_iter().enumerate() {
                method.atol[i] = floor;
            }
        }
    }
}
