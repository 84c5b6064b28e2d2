//! How far what a program computes may be from what it stands for.
//!
//! For each value v of the program let v* be the same in exact arithmetic. The bounds of the envelope
//! hold every computed v, and |v - v*| <= e follows operation by operation. An operation on computed
//! operands rounds to nearest: its result v is off by at most u |v| + s, with the unit roundoff u and
//! the smallest subnormal number s (standard model with underflow; + and - are exact where they are
//! subnormal). A function of a library is trusted to two units in the last place, 4 u |v| + 4 s. To
//! this comes what the errors of the operands make of it:
//!
//! - a b: |ab - a*b*| = |a (b - b*) + b* (a - a*)| <= |a| e_b + (|b| + e_b) e_a
//! - a/b: |a/b - a*/b*| = |(a - a*)/b* + (a/b) (b* - b)/b*| <= (e_a + |a/b| e_b)/(|b| - e_b)
//! - f(a): the greatest slope of f within e_a of all a, times e_a
//! - a^k by multiplications: each factor of a^m has at most m - 1 roundings.
//!
//! The bound itself is computed in doubles, and each step of it enlarged by more than it rounds.

use std::collections::BTreeMap;

use num_traits::{Signed, ToPrimitive};

use crate::check::envelope::Computed;
use crate::check::envelope::bounds::Bounds;
use crate::expression::Function;
use crate::expression::enclosure::{Calls, Range};
use crate::parameter::Precision;
use crate::program::{Op, Program, Value, number, rows};

/// What covers the roundings of one step of a bound.
const MORE: f64 = 1.0 + 1e-14;

/// A computed value and its error.
#[derive(Clone, Copy)]
struct Rounded {
    /// What holds the computed value.
    value: Computed,
    error: f64,
}

impl Rounded {
    fn size(self) -> f64 {
        self.value.range.size().high()
    }

    /// The least |v*|, or less than 0.
    fn least(self) -> f64 {
        self.value.range.size().low() - self.error * MORE
    }

    /// The greatest |v*|.
    fn most(self) -> f64 {
        (self.size() + self.error) * MORE
    }
}

/// The units of a precision.
#[derive(Clone, Copy)]
struct Units {
    roundoff: f64,
    subnormal: f64,
}

/// A bound of |v - v*| for a value computed within `bounds` by operations that round; none where an
/// iteration or a function of the user's is in it. `to_go` is the greatest time-to-go.
pub(super) fn error(
    program: &Program,
    bounds: &Bounds<'_>,
    held: &[Value],
    to_go: f64,
    root: Value,
    calls: &mut Calls,
) -> Option<f64> {
    let units = match program.precision {
        Precision::F32 => Units { roundoff: 2f64.powi(-24), subnormal: 2f64.powi(-149) },
        Precision::F64 => Units { roundoff: 2f64.powi(-53), subnormal: 2f64.powi(-1074) },
    };
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
                    Rounded { value, error: units.of(op, of, value) }
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
                let roundings = if function.is_of_library() { 4.0 } else { 1.0 };
                let own = units.roundoff * own.range.size().high() + units.subnormal;
                (moved(calls, *function, of(a)?) + roundings * own) * MORE
            }
            op => {
                let operands = op.operands().iter().map(of).collect::<Option<Vec<_>>>()?;
                units.of(op, &operands, own)
            }
        };
        known[value.0] = Some(Rounded { value: own, error });
    }
    known[root.0].map(|root| root.error).filter(|error| error.is_finite())
}

impl Units {
    /// The error of an operation with a computed result from `own`.
    fn of(self, op: &Op, operands: &[Rounded], own: Computed) -> f64 {
        let size = own.range.size().high();
        let rounding = self.roundoff * size + self.subnormal;
        let error = match (op, operands) {
            (Op::Neg(_), [a]) => a.error,
            (Op::Add(..) | Op::Sub(..), [a, b]) => a.error + b.error + self.roundoff * size,
            (Op::Mul(..), [a, b]) => a.size() * b.error + b.most() * a.error + rounding,
            (Op::Fused(..), [a, b, c]) => {
                a.size() * b.error + b.most() * a.error + c.error + rounding
            }
            (Op::Div(..) | Op::Quotient(..), [a, b]) if b.least() > 0.0 => {
                let quotient = size * (1.0 + 2.0 * self.roundoff) + self.subnormal;
                (a.error + quotient * b.error) / (b.least() * (2.0 - MORE)) + rounding
            }
            (Op::Power(_, k), [a]) => {
                let (most, count) = (a.most(), f64::from(*k));
                let k = i32::try_from(*k).unwrap_or(i32::MAX);
                let whole = most.powi(k) * (1.0 + 1e-12);
                let moved = count * most.powi(k - 1) * a.error;
                let relative = count * self.roundoff * (1.0 + count * self.roundoff);
                let lost = count * self.subnormal * most.max(1.0).powi(k);
                (moved + relative * whole + lost) * (1.0 + 1e-12)
            }
            (Op::Max(..) | Op::Min(..), [a, b]) => a.error.max(b.error),
            (Op::Pow(..), [a, b]) if a.least() > 0.0 => {
                let logarithm = a.least().ln().abs().max(a.most().ln().abs()) + 1e-15;
                let change = b.most() / a.least() * a.error + logarithm * b.error;
                // With |ln(v*/v)| <= change, as both slopes are at most that within the errors.
                size * (1.0 + 8.0 * self.roundoff) * change.exp_m1() * (1.0 + 1e-12)
                    + 4.0 * rounding
            }
            _ => f64::INFINITY,
        };
        if error.is_nan() { f64::INFINITY } else { error * MORE }
    }
}

/// The error of a function's value due to that of its argument.
fn moved(calls: &mut Calls, function: Function, a: Rounded) -> f64 {
    if a.error == 0.0 {
        return 0.0;
    }
    let [low, high] = a.value.range.ends();
    let on = Range::new(low - a.error * MORE, high + a.error * MORE);
    calls.steepest(function, on).map_or(f64::INFINITY, |slope| slope * a.error * MORE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::Family;
    use crate::law::Law;
    use crate::lower::lower;
    use crate::parameter::Parameter;
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
    fn what_single_precision_loses_is_within_the_bound() {
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
