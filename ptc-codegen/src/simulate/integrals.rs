//! Integrals over time since t0, of functions of the state, the inputs and time: states of a run on which no
//! rate of the plant depends.
//!
//! Over sigma = -ln(T/tau) time passes at the rate T, so that the integral of h over time has the rate T h:
//! close to the deadline T falls by what a law of Theorem 1 makes of u, and no digit of T is lost.

use super::{Along, Cause, Failure, Values};
use crate::expression::Expression;
use crate::lower;
use crate::parameter::Precision;
use crate::program::kink::Kink;
use crate::program::{Value, passes};
use crate::request::Spec;

/// The integrands of a run, compiled. Each may depend on the integrals before it, `State(j)` behind the
/// variables of the plant.
#[derive(Clone, Debug)]
pub(super) struct Integrals {
    along: Along,
    integrands: Vec<Value>,
    /// Kinks of the integrands: no step leads across, as one that begins with nothing accumulated is not accurate to a
    /// part of what it adds.
    kinks: Vec<Kink>,
    /// True if one had no value where the plant has one.
    lost: bool,
}

impl Integrals {
    /// `None` where there are none.
    pub(super) fn new(spec: &Spec, integrands: &[Expression]) -> Option<Self> {
        if integrands.is_empty() {
            return None;
        }
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let program = lower::observed(&spec, &integrands.iter().collect::<Vec<_>>());
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.variables());
        let kinks = along.machine.kinks();
        Some(Self { along, integrands: program.watched, kinks, lost: false })
    }

    pub(super) fn count(&self) -> usize {
        self.integrands.len()
    }

    /// Before a run from `x0`.
    pub(super) fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.along.give(values)?;
        self.along.start(x0);
        self.along.settle();
        self.lost = false;
        Ok(())
    }

    /// The rates of the integrals `so_far`, times `scale`, where `time_to_go` is left and the plant in `x`
    /// is moved by `u`.
    pub(super) fn rates(
        &mut self,
        (time_to_go, scale): (f64, f64),
        (x, u): (&[f64], &[f64]),
        so_far: &[f64],
        rates: &mut [f64],
    ) {
        self.at(time_to_go, (x, u), so_far);
        let known = x.iter().chain(u).chain(so_far).all(|value| value.is_finite());
        for (rate, value) in rates.iter_mut().zip(&self.integrands) {
            *rate = scale * self.along.machine.get(*value);
            self.lost |= known && !rate.is_finite();
        }
    }

    fn at(&mut self, time_to_go: f64, (x, u): (&[f64], &[f64]), so_far: &[f64]) {
        self.along.accumulated(so_far);
        self.along.at(time_to_go, x, u);
    }

    /// Number of kinks of the integrands.
    pub(super) fn kinks(&self) -> usize {
        self.kinks.len()
    }

    /// The distances from these.
    pub(super) fn distances(
        &mut self,
        time_to_go: f64,
        acting: (&[f64], &[f64]),
        so_far: &[f64],
        into: &mut Vec<f64>,
    ) {
        self.at(time_to_go, acting, so_far);
        into.extend(self.kinks.iter().map(|kink| self.along.machine.distance(kink)));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.along.machine.hold(kink, *above);
        }
    }

    /// Why a run ends, where it is an integrand that stops it.
    pub(super) fn failure(&self, failure: Failure) -> Failure {
        if !self.lost || failure.cause != Cause::Unfinished {
            return failure;
        }
        Failure::unfinished(
            "what an objective integrates has no finite value close by",
            "see what it is at this instant, for example a quotient with 0 below, or the square root of a negative number",
        )
    }
}
