//! The emitted arithmetic, enclosed: each value in exact arithmetic, and how far rounding takes it.
//!
//! Errors follow by [`rounding`], as long as nothing underflows. The error of a sum is charged with u(|a| + |b|), not u|a + b|: the bound is
//! then linear in the magnitudes of the states, so that the errors found for the unit vectors bound
//! that of every state, |u_emitted - sum_j gain_j x_j| <= sum_j error_j |x_j|.

use std::collections::BTreeMap;

use super::systems::eliminated;
use crate::algebra::BigRational;
use crate::expression::enclosure::{Calls, Interval, Range};
use crate::parameter::Precision;
use crate::program::rounding::{self, Near, Units};
use crate::program::{Input, Op, Program, Stage, Value, number};

/// A value of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    /// Encloses the value in exact arithmetic.
    pub(super) exact: Range,
    /// Bound of |emitted - exact|.
    pub(super) error: f64,
}

impl Rounded {
    /// A number that the emitted code has exactly.
    pub(super) fn of(exact: Range) -> Self {
        Self { exact, error: 0.0 }
    }

    /// An exact number as the emitted code has it.
    pub(super) fn number(exact: &BigRational, precision: Precision) -> Self {
        let near = number::round(exact, precision);
        if number::is_exact(near, exact) {
            return Self::of(Range::from(near));
        }
        let range = Range::from(&Interval::exact(exact));
        Self { exact: range, error: up(unit_roundoff(precision) * range.size().high()) }
    }

    /// Its sizes as rounding sees them: those of the exact value.
    fn near(self) -> Near {
        let size = self.exact.size();
        Near { least: size.low(), most: size.high(), error: self.error }
    }

    /// Encloses the emitted value too.
    pub(super) fn emitted(self) -> Range {
        self.exact + Range::from(self.error).both_signs()
    }
}

/// More than some thousand sums and products in doubles lose of a bound.
pub(super) const ROUNDED: f64 = 1.0 + 1e-12;

/// Rounds a bound up, after an operation that may have rounded it down.
fn up(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.next_up() }
}

/// The largest relative error of one operation in `precision`.
pub(super) fn unit_roundoff(precision: Precision) -> f64 {
    Units::of(precision).roundoff
}

/// The errors of one operation of a law in samples, where nothing underflows.
pub(super) fn units(precision: Precision) -> Units {
    Units::of(precision).without_underflow()
}

/// Values of a program, computed stage by stage.
pub(super) struct StagedValues<'a> {
    program: &'a Program,
    units: Units,
    /// Enclosure of each value; `None` if it is not computed, or no enclosure is known.
    values: Vec<Option<Rounded>>,
    /// The solutions of systems, where they are enclosed.
    solved: BTreeMap<Value, Vec<Rounded>>,
    due: [Vec<Value>; 5],
    calls: Calls,
}

impl<'a> StagedValues<'a> {
    /// For the values of `program` that `outputs` need; `None` if memory for constants is lacking.
    pub(super) fn new(program: &'a Program, outputs: &[Value]) -> Option<Self> {
        let mut due: [Vec<Value>; 5] = Default::default();
        for value in program.needed(outputs) {
            due[program.get(value).stage as usize].push(value);
        }
        let units = units(program.precision);
        let values = vec![None; program.values.len()];
        let (solved, calls) = (BTreeMap::new(), Calls::new()?);
        Some(Self { program, units, values, solved, due, calls })
    }

    /// Computes the values of a stage; those of earlier stages are known.
    pub(super) fn run(&mut self, stage: Stage, input: &dyn Fn(Input) -> Option<Rounded>) {
        for value in std::mem::take(&mut self.due[stage as usize]) {
            self.values[value.0] = self.compute(value, input);
            self.due[stage as usize].push(value);
        }
    }

    /// A value that was computed.
    pub(super) fn get(&self, value: Value) -> Option<Rounded> {
        self.values[value.0].filter(|found| found.exact.is_bounded() && found.error.is_finite())
    }

    fn compute(
        &mut self,
        value: Value,
        input: &dyn Fn(Input) -> Option<Rounded>,
    ) -> Option<Rounded> {
        let units = self.units;
        let program = self.program;
        let at = |value: Value| self.values[value.0];
        match &program.get(value).op {
            Op::Number(exact) => Some(Rounded::number(exact, program.precision)),
            Op::Input(asked) => input(*asked),
            Op::Neg(a) => at(*a).map(|a| Rounded { exact: -a.exact, ..a }),
            Op::Add(a, b) => Some(sum(at(*a)?, at(*b)?, units)),
            Op::Sub(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                // Exact for the values at hand, which says nothing of other states.
                let exactly = program.get(value).stage < Stage::Step && is_exact(a, b);
                let units = if exactly { Units::EXACT } else { units };
                Some(sum(a, Rounded { exact: -b.exact, ..b }, units))
            }
            Op::Mul(a, b) => Some(product(at(*a)?, at(*b)?, units)),
            Op::Fused(a, b, c) => {
                let unrounded = product(at(*a)?, at(*b)?, Units::EXACT);
                Some(sum(unrounded, at(*c)?, units))
            }
            Op::Div(a, b) | Op::Quotient(a, b) => quotient(at(*a)?, at(*b)?, units),
            Op::Power(a, k) => {
                let a = at(*a)?;
                let exact = (1..*k).fold(a.exact, |power, _| power * a.exact);
                Some(Rounded { exact, error: units.of_product(a.near(), *k) })
            }
            Op::Max(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                Some(Rounded { exact: a.exact.most(&b.exact), error: a.error.max(b.error) })
            }
            Op::Min(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                Some(Rounded { exact: a.exact.least(&b.exact), error: a.error.max(b.error) })
            }
            Op::Call(function, a) => {
                let a = at(*a)?;
                let [exact, near] =
                    [a.exact, a.emitted()].map(|on| self.calls.values(*function, on));
                let inherited = rounding::call(&mut self.calls, *function, a.emitted(), a.error);
                let error = units.of_call(*function, near.size().high(), inherited);
                Some(Rounded { exact, error })
            }
            Op::Pow(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                if !a.emitted().is_positive() {
                    return None;
                }
                let exact = self.calls.power(a.exact, b.exact);
                let size = exact.size().high();
                let inherited = rounding::power(a.near(), b.near(), size)?;
                Some(Rounded { exact, error: units.of_power(size, inherited) })
            }
            Op::Elimination { matrix, right } => {
                self.solved.remove(&value);
                let all = |values: &[Value]| values.iter().map(|value| at(*value)).collect();
                let (matrix, right): (Option<Vec<_>>, Option<Vec<_>>) = (all(matrix), all(right));
                let solved = eliminated(&matrix?, &right?, program.precision)?;
                self.solved.insert(value, solved);
                None
            }
            Op::Element(array, index) => self.solved.get(array)?.get(*index).copied(),
            Op::Law(_) | Op::Rows { .. } | Op::Unknown | Op::Root(_) => None,
        }
    }
}

pub(super) fn sum(a: Rounded, b: Rounded, units: Units) -> Rounded {
    let size = up(a.near().most + b.near().most);
    let error = units.rounded(size, rounding::sum(a.near(), b.near()));
    Rounded { exact: a.exact + b.exact, error }
}

/// Returns true if a - b is a number of the precision, by Sterbenz: b/2 <= a <= 2 b.
fn is_exact(a: Rounded, b: Rounded) -> bool {
    let two = Range::from(2.0);
    let (a, b) = (a.emitted(), b.emitted());
    let within = |a: Range, b: Range| a.is_below(&(two * b)) && b.is_below(&(two * a));
    within(a, b) || within(-a, -b)
}

pub(super) fn product(a: Rounded, b: Rounded, units: Units) -> Rounded {
    let exact = a.exact * b.exact;
    let error = units.rounded(exact.size().high(), rounding::product(a.near(), b.near()));
    Rounded { exact, error }
}

pub(super) fn quotient(a: Rounded, b: Rounded, units: Units) -> Option<Rounded> {
    let exact = a.exact / b.exact;
    let size = exact.size().high();
    let inherited = rounding::quotient(a.near(), b.near(), size)?;
    exact.is_bounded().then(|| Rounded { exact, error: units.rounded(size, inherited) })
}
