//! Dormand and Prince's methods.

use differential_equations::interpolate::Interpolation;
use differential_equations::methods::{DormandPrince, ExplicitRungeKutta, Ordinary};
use differential_equations::ode::OrdinaryNumericalMethod;
use nalgebra::SVector;

use super::{Method, Rates, Short, State, Wanted, failure, narrow, wide};
use crate::simulate::Failure;
use crate::simulate::solver::Begin;

type Dormand<const N: usize, const O: usize, const S: usize, const I: usize> =
    ExplicitRungeKutta<Ordinary, DormandPrince, f64, SVector<f64, N>, O, S, I>;

/// An explicit method.
pub(in crate::simulate) struct Explicit<
    'a,
    const N: usize,
    const O: usize,
    const S: usize,
    const I: usize,
> {
    system: Short<'a, N>,
    method: Dormand<N, O, S, I>,
    /// `None`: what is accurate enough stays as it is at the start.
    wanted: Option<Wanted<N>>,
}

/// Dormand and Prince's method of order 8.
pub(in crate::simulate) fn eighth<'a, const N: usize>(
    system: &'a Rates<'a>,
    wanted: Wanted<N>,
    begin: Begin,
) -> Result<Explicit<'a, N, 8, 12, 16>, Failure> {
    Explicit::begun(system, ExplicitRungeKutta::dop853(), (wanted, true), begin)
}

/// Dormand and Prince's method of order 5.
pub(in crate::simulate) fn fifth<'a, const N: usize>(
    system: &'a Rates<'a>,
    wanted: Wanted<N>,
    begin: Begin,
) -> Result<Explicit<'a, N, 5, 7, 7>, Failure> {
    Explicit::begun(system, ExplicitRungeKutta::dopri5(), (wanted, false), begin)
}

impl<'a, const N: usize, const O: usize, const S: usize, const I: usize> Explicit<'a, N, O, S, I> {
    fn begun(
        system: &'a Rates<'a>,
        method: Dormand<N, O, S, I>,
        (wanted, weighs): (Wanted<N>, bool),
        begin: Begin,
    ) -> Result<Self, Failure>
    where
        Dormand<N, O, S, I>:
            OrdinaryNumericalMethod<f64, SVector<f64, N>> + Interpolation<f64, SVector<f64, N>>,
    {
        let floors = wanted.floors(&narrow(&begin.state)).to_vec();
        let method = method.rtol(wanted.relative).atol(floors).h0(begin.step).max_steps(usize::MAX);
        let mut begun = Self { system: Short(system), method, wanted: weighs.then_some(wanted) };
        begun.restart(begin.at, &begin.state, begin.step)?;
        Ok(begun)
    }
}

impl<const N: usize, const O: usize, const S: usize, const I: usize> Method
    for Explicit<'_, N, O, S, I>
where
    Dormand<N, O, S, I>:
        OrdinaryNumericalMethod<f64, SVector<f64, N>> + Interpolation<f64, SVector<f64, N>>,
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

    fn set_step(&mut self, step: f64) -> Result<(), Failure> {
        self.method.set_h(step);
        Ok(())
    }

    fn restart(&mut self, at: f64, state: &State, step: f64) -> Result<(), Failure> {
        // The end only bounds the first step.
        let begun = self.method.init(&self.system, at, at + 1e9, &narrow(state));
        begun.map_err(|error| failure(&error))?;
        self.method.set_h(step);
        Ok(())
    }

    fn weigh(&mut self) {
        if let Some(wanted) = &self.wanted {
            for (i, floor) in wanted.floors(self.method.y()).into_iter().enumerate() {
                self.method.atol[i] = floor;
            }
        }
    }
}
