//! Rounding error of the values that a program computes.
//!
//! The bounds of the envelope hold every computed value, and its rounding error follows operation by operation, by
//! [`rounding`].

use std::collections::BTreeMap;

use num_traits::{Signed, ToPrimitive};

use crate::check::envelope::Computed;
use crate::check::envelope::bounds::Bounds;
use crate::expression::enclosure::{Calls, Range};
use crate::program::rounding::{self, MORE, Near, Units};
use crate::program::{Op, Program, Value, number, rows};

/// A computed value and its error.
#[derive(Clone, Copy)]
struct Rounded {
    /// Enclosure of the computed value.
    value: Computed,
    error: f64,
}

impl Rounded {
    /// Its sizes as rounding sees them: those of the computed value.
    fn near(self) -> Near {
        let size = self.value.range.size();
        Near { least: size.low(), most: size.high(), error: self.error }
    }

    /// Returns the enclosure of the computed value and the exact one.
    fn both(self) -> Range {
        self.value.range + Range::from(self.error).both_signs()
    }
}

/// A bound of |v - v*| for a value computed within `bounds` by operations that round; `None` where an
/// iteration or a function of the user's is in it. `to_go` is the greatest time-to-go.
pub(super) fn error(
    program: &Program,
    bounds: &Bounds<'_>,
    held: &[Value],
    to_go: f64,
    root: Value,
    calls: &mut Calls,
) -> Option<f64> {
    let units = Units::of(program.precision);
    let mut known: Vec<Option<Rounded>> = vec![None; program.values.len()];
    let mut arrays: BTreeMap<Value, Vec<Rounded>> = BTreeMap::new();
    let elapsed = program.limits.elapsed.map(|(elapsed, _)| elapsed);
    for value in bounds.needed(&[root]) {
        let op = &program.get(value).op;
        let of = |v: &Value| known[v.0];
        let own = bounds.get(value);
        let error = match op {
            // T = (hi - t) + lo: hi - t is exact where t is within a factor of 2 of hi, and else |lo|
            // is at most 2 u of it. Either way two roundings of about T are left.
            _ if held.contains(&value) => 3.0 * units.roundoff * to_go,
            // t - t0, or tau - eps in its place: one rounding.
            _ if elapsed == Some(value) => 2.0 * units.roundoff * own.range.high(),
            Op::Rows { tail, weights, fused } => {
                let all = |values: &[Value]| values.iter().map(of).collect::<Option<Vec<_>>>();
                let precision = program.precision;
                let on = |op: &Op, of: &[Rounded]| {
                    let values: Vec<_> = of.iter().map(|rounded| rounded.value).collect();
                    let value = crate::check::envelope::apply(op, &values, precision);
                    Rounded { value, error: error_of(units, op, of, value) }
                };
                let (tail, weights) = (all(tail)?, all(weights)?);
                arrays.insert(value, rows::by_operations(&tail, &weights, *fused, on));
                0.0
            }
            Op::Element(array, index) => arrays.get(array)?.get(*index)?.error,
            Op::Number(exact) => {
                let rounded = number::exact(number::round(exact, program.precision))?;
                (rounded - exact).abs().to_f64()? * MORE
            }
            Op::Input(_) => 0.0,
            Op::Law(_) | Op::Elimination { .. } | Op::Unknown | Op::Root(_) => return None,
            Op::Call(function, a) => {
                let a = of(a)?;
                let inherited = rounding::call(calls, *function, a.both(), a.error);
                units.of_call(*function, own.range.size().high(), inherited)
            }
            op => {
                let operands = op.operands().iter().map(of).collect::<Option<Vec<_>>>()?;
                error_of(units, op, &operands, own)
            }
        };
        known[value.0] = Some(Rounded { value: own, error });
    }
    known[root.0].map(|root| root.error).filter(|error| error.is_finite())
}

/// The error of an operation with a computed result from `own`; infinite where it is not known.
fn error_of(units: Units, op: &Op, operands: &[Rounded], own: Computed) -> f64 {
    let size = own.range.size().high();
    let near: Vec<_> = operands.iter().map(|operand| operand.near()).collect();
    // Size that the result may have before it is rounded.
    let unrounded = size * (1.0 + 8.0 * units.roundoff) + units.subnormal;
    let error = match (op, &near[..]) {
        (Op::Neg(_), [a]) => Some(a.error),
        // A sum is exact where it is subnormal.
        (Op::Add(..) | Op::Sub(..), [a, b]) => {
            Some(units.without_underflow().rounded(size, rounding::sum(*a, *b)))
        }
        (Op::Mul(..), [a, b]) => Some(units.rounded(size, rounding::product(*a, *b))),
        (Op::Fused(..), [a, b, c]) => {
            Some(units.rounded(size, rounding::product(*a, *b) + c.error))
        }
        (Op::Div(..) | Op::Quotient(..), [a, b]) => {
            rounding::quotient(*a, *b, unrounded).map(|inherited| units.rounded(size, inherited))
        }
        (Op::Power(_, k), [a]) => Some(units.of_product(*a, *k)),
        (Op::Max(..) | Op::Min(..), [a, b]) => Some(a.error.max(b.error)),
        (Op::Pow(..), [a, b]) => {
            rounding::power(*a, *b, unrounded).map(|inherited| units.of_power(size, inherited))
        }
        _ => None,
    };
    error.unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::Family;
    use crate::law::Law;
    use crate::lower::lower;
    use crate::parameter::{Parameter, Precision};
    use crate::program::interpret::Interpreter;
    use crate::program::{Input, passes};
    use crate::request::Spec;

    fn program(n: usize, (family, fma): (Family, bool), precision: Precision) -> Program {
        let spec = Spec { precision, fma, ..Spec::new(n, family) };
        passes::optimise(lower(&spec, &Law::of(&spec)), &mut |_, _| {})
    }

    /// An input: numbers that single precision holds, with 1 for tau and a, 1/2 for m.
    fn input(input: Input, t: f64, sign: f64) -> f64 {
        let number = |k: usize| f64::from(u8::try_from(k).expect("small"));
        match input {
            Input::Parameter(Parameter::Eps) => 2f64.powi(-10),
            Input::Parameter(Parameter::M) => 0.5,
            Input::Parameter(Parameter::Start) => 0.125,
            Input::Parameter(Parameter::Gain(i)) => 3.0 + number(i) * f64::from(0.7f32),
            Input::Parameter(_) => 1.0,
            Input::Time => t,
            Input::State(j) => sign.powi(i32::try_from(j).expect("small")) * f64::from(0.3f32),
            _ => 0.0,
        }
    }

    #[test]
    fn single_precision_error_stays_within_the_bound() {
        let mut calls = Calls::new().expect("memory");
        let families = [
            Family::Exp,
            Family::Rational,
            Family::Power,
            Family::Tan,
            Family::Tanh,
            Family::Algebraic,
            Family::Soft,
        ];
        for family in families.into_iter().flat_map(|family| [(family, false), (family, true)]) {
            for n in [1, 2, 4, 6] {
                let [single, double] =
                    [Precision::F32, Precision::F64].map(|p| program(n, family, p));
                let (mut greatest, mut bound) = (0.0_f64, 0.0_f64);
                for (t, sign) in [(0.0, 1.0), (0.3, -1.0), (0.7, 1.0), (0.96, -1.0)] {
                    let t = f64::from(t as f32);
                    let point = |asked: Input| match asked {
                        Input::Time => Computed::ANY,
                        asked => Computed::point(input(asked, t, sign)),
                    };
                    let early = Bounds::new(&single, &point);
                    let mut bounds = early.at((1.0 - t) * (1.0 - 1e-6), (1.0 - t) * (1.0 + 1e-6));
                    assert_eq!(bounds.first_excess(&[single.step]), None, "{family:?} {n}");
                    let of_step =
                        error(&single, &bounds, bounds.held(), 1.0 - t, single.step, &mut calls);
                    let of_step = of_step.expect("no iteration");
                    let at = |asked: Input| input(asked, t, sign);
                    let [u, truth] =
                        [&single, &double].map(|p| Interpreter::new(p, &at).value(p.step));
                    let lost = (u - truth).abs();
                    assert!(lost <= of_step, "{family:?} {n} at {t}: {lost:e} > {of_step:e}");
                    (greatest, bound) = (greatest.max(lost), bound.max(of_step));
                }
                // Close enough to be of use, far enough to be no accident.
                assert!(bound < 4e3 * greatest.max(1e-7), "{family:?} {n}: {greatest:e} {bound:e}");
            }
        }
    }
}
