//! The emitted arithmetic, enclosed: each value in exact arithmetic, and how far rounding takes it.
//!
//! An operation in floating point returns (a op b)(1 + d), |d| <= u, the unit roundoff, as long as
//! nothing underflows. The error of a sum is charged with u(|a| + |b|), not u|a + b|: the bound is
//! then linear in the magnitudes of the states, so that the errors found for the unit vectors bound
//! that of every state, |u_emitted - sum_j gain_j x_j| <= sum_j error_j |x_j|.

use std::collections::BTreeMap;

use super::systems::eliminated;
use crate::algebra::BigRational;
use crate::expression::Function;
use crate::expression::enclosure::{Calls, Interval, Range};
use crate::parameter::Precision;
use crate::program::{Input, Op, Program, Stage, Value, number};

/// A value of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    /// Encloses the value in exact arithmetic.
    pub(super) exact: Range,
    /// Bound of |emitted - exact|.
    pub(super) error: f64,
}

/// Units in the last place by which a function of the mathematical library may be off.
const LIBRARY: f64 = 2.0;

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

    fn size(self) -> f64 {
        self.exact.size().high()
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
    match precision {
        Precision::F32 => 2f64.powi(-24),
        Precision::F64 => 2f64.powi(-53),
    }
}

/// Values of a program, computed stage by stage.
pub(super) struct StagedValues<'a> {
    program: &'a Program,
    unit: f64,
    /// By value; `None` if it is not computed, or no enclosure is known.
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
        let unit = unit_roundoff(program.precision);
        let values = vec![None; program.values.len()];
        let (solved, calls) = (BTreeMap::new(), Calls::new()?);
        Some(Self { program, unit, values, solved, due, calls })
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
        let unit = self.unit;
        let program = self.program;
        let at = |value: Value| self.values[value.0];
        match &program.get(value).op {
            Op::Number(exact) => Some(Rounded::number(exact, program.precision)),
            Op::Input(asked) => input(*asked),
            Op::Neg(a) => at(*a).map(|a| Rounded { exact: -a.exact, ..a }),
            Op::Add(a, b) => Some(sum(at(*a)?, at(*b)?, unit)),
            Op::Sub(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                // Exact for the values at hand, which says nothing of other states.
                let exactly = program.get(value).stage < Stage::Step && is_exact(a, b);
                let unit = if exactly { 0.0 } else { unit };
                Some(sum(a, Rounded { exact: -b.exact, ..b }, unit))
            }
            Op::Mul(a, b) => Some(product(at(*a)?, at(*b)?, unit)),
            Op::Fused(a, b, c) => {
                let unrounded = product(at(*a)?, at(*b)?, 0.0);
                Some(sum(unrounded, at(*c)?, unit))
            }
            Op::Div(a, b) | Op::Quotient(a, b) => quotient(at(*a)?, at(*b)?, unit),
            Op::Power(a, k) => {
                let a = at(*a)?;
                Some((1..*k).fold(a, |power, _| product(power, a, unit)))
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
                let (function, a) = (*function, at(*a)?);
                let near = a.emitted();
                let values = [a.exact, near].map(|on| self.calls.values(function, on));
                let moved = self.calls.steepest(function, near).map(|slope| up(slope * a.error));
                Some(called(function.is_of_library(), values, moved, unit))
            }
            Op::Pow(a, b) => {
                let (a, b) = (at(*a)?, at(*b)?);
                if !a.emitted().is_positive() {
                    return None;
                }
                let near = self.calls.power(a.emitted(), b.emitted());
                // d(a^b)/da = b a^b/a, and d(a^b)/db = ln(a) a^b.
                let of_base = (b.emitted() * near / a.emitted()).size().high();
                let logarithm = self.calls.values(Function::Ln, a.emitted());
                let of_exponent = (logarithm * near).size().high();
                let moved = up(up(of_base * a.error) + up(of_exponent * b.error));
                let exact = self.calls.power(a.exact, b.exact);
                Some(called(true, [exact, near], Some(moved), unit))
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

pub(super) fn sum(a: Rounded, b: Rounded, unit: f64) -> Rounded {
    let inherited = up(a.error + b.error);
    let size = up(up(a.size() + b.size()) + inherited);
    Rounded { exact: a.exact + b.exact, error: up(inherited + up(unit * size)) }
}

/// Whether a - b is a number of the precision, by Sterbenz: b/2 <= a <= 2 b.
fn is_exact(a: Rounded, b: Rounded) -> bool {
    let two = Range::from(2.0);
    let (a, b) = (a.emitted(), b.emitted());
    let within = |a: Range, b: Range| a.is_below(&(two * b)) && b.is_below(&(two * a));
    within(a, b) || within(-a, -b)
}

pub(super) fn product(a: Rounded, b: Rounded, unit: f64) -> Rounded {
    let exact = a.exact * b.exact;
    let inherited = up(up(a.error * up(b.size() + b.error)) + up(a.size() * b.error));
    let size = up(exact.size().high() + inherited);
    Rounded { exact, error: up(inherited + up(unit * size)) }
}

pub(super) fn quotient(a: Rounded, b: Rounded, unit: f64) -> Option<Rounded> {
    let exact = a.exact / b.exact;
    let least = -((-b.emitted().size()).high());
    if least <= 0.0 || !exact.is_bounded() {
        return None;
    }
    // (a + da)/(b + db) - a/b = (da - (a/b) db)/(b + db).
    let moved = up(a.error + up(exact.size().high() * b.error));
    let inherited = up(moved / least);
    let size = up(exact.size().high() + inherited);
    Some(Rounded { exact, error: up(inherited + up(unit * size)) })
}

/// The value of a function: on the exact operand, and on all operands the code may have, with what the error of the
/// operand makes of it, if that is known. One of a library rounds more than once.
fn called(library: bool, [exact, near]: [Range; 2], moved: Option<f64>, unit: f64) -> Rounded {
    let width = (Range::from(near.high()) - Range::from(near.low())).high();
    let inherited = moved.filter(|moved| *moved < width).unwrap_or(width);
    let roundings = if library { 2.0 * LIBRARY } else { 1.0 };
    Rounded { exact, error: up(inherited + up(roundings * unit * near.size().high())) }
}
