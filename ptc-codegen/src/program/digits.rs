//! Checks that `init`, and `arm_for` of a duration, make before `step` may use their results: a product of legal numbers that falls below the normal
//! range has lost digits, or is 0, and nothing after it shows that.
//!
//! Every product and quotient that they form gets the range of its magnitude from the legal values
//! of the parameters; one that may be too small is checked. An overflow shows by itself: it ends in a
//! field that is not finite, or in a quotient that is too small.

use num_traits::Zero;

use super::{Input, Op, Program, Stage, Value, number};
use crate::expression::Function;
use crate::parameter::{Parameter, Precision};
use crate::request::Spec;

/// A condition on what is computed before a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Condition {
    /// It is finite.
    Finite(Value),
    /// It is at least [`least`].
    Above(Value),
    /// It is at most minus [`least`].
    Below(Value),
    /// It is at least [`least`] in magnitude, or one of these is 0, with which it is 0 as well.
    Kept(Value, Vec<Value>),
}

impl Condition {
    /// The values it looks at, the checked one first.
    pub fn values(&self) -> Vec<Value> {
        match self {
            Self::Finite(value) | Self::Above(value) | Self::Below(value) => vec![*value],
            Self::Kept(value, factors) => [&[*value], factors.as_slice()].concat(),
        }
    }

    /// Returns true if it holds for numbers of those values.
    pub fn holds(&self, numbers: &[f64], precision: Precision) -> bool {
        let (number, factors) = (numbers[0], &numbers[1..]);
        match self {
            Self::Finite(_) => number.is_finite(),
            Self::Above(_) => number >= least(precision),
            Self::Below(_) => number <= -least(precision),
            Self::Kept(..) => number.abs() >= least(precision) || factors.contains(&0.0),
        }
    }
}

/// The least magnitude of a product: so far above the least normal number that it can be multiplied
/// by constants, and by states that are not much smaller than 1, and keeps its digits.
pub fn least(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => 1e-200,
        Precision::F32 => f64::from(1e-30_f32),
    }
}

/// Binary exponents of the least normal number, and of the greatest one.
fn normal(precision: Precision) -> (f64, f64) {
    match precision {
        Precision::F64 => (-1022.0, 1023.0),
        Precision::F32 => (-126.0, 127.0),
    }
}

/// Bounds of the size of a value. For a sum it is the size of its terms, by which its error is measured.
#[derive(Clone, Copy)]
struct Size {
    /// 1 or -1; 0 where it is not known.
    sign: i8,
    /// True if it may be 0.
    zero: bool,
    /// Binary logarithms of the least and the greatest magnitude, apart from 0.
    least: f64,
    greatest: f64,
}

impl Size {
    const UNKNOWN: Self =
        Self { sign: 0, zero: true, least: f64::NEG_INFINITY, greatest: f64::INFINITY };

    fn positive(least: f64, greatest: f64) -> Self {
        Self { sign: 1, zero: false, least: least.log2(), greatest: greatest.log2() }
    }

    fn of_number(number: f64) -> Self {
        let sign = if number < 0.0 { -1 } else { 1 };
        Self { sign, zero: number == 0.0, ..Self::positive(number.abs(), number.abs()) }
    }

    fn of_parameter(spec: &Spec, parameter: Parameter) -> Self {
        let (normal, _) = normal(spec.precision);
        let bounds = spec.bounds.get(&parameter).and_then(|(least, greatest)| {
            Some((least.rounded(spec.precision)?, greatest.rounded(spec.precision)?))
        });
        if let Some((least, greatest)) = bounds.or_else(|| spec.ends_of_kind(parameter)) {
            return if least > 0.0 {
                Self::positive(least, greatest)
            } else if greatest < 0.0 {
                Self::positive(-greatest, -least).negative()
            } else {
                Self::UNKNOWN
            };
        }
        match parameter {
            Parameter::UMax if !spec.u_min => Self::positive(normal.exp2(), f64::INFINITY),
            _ => Self::UNKNOWN,
        }
    }

    fn times(self, other: Self) -> Self {
        Self {
            sign: self.sign * other.sign,
            zero: self.zero || other.zero,
            least: self.least + other.least,
            greatest: self.greatest + other.greatest,
        }
    }

    fn inverse(self) -> Self {
        Self { zero: false, least: -self.greatest, greatest: -self.least, ..self }
    }

    fn negative(self) -> Self {
        Self { sign: -self.sign, ..self }
    }

    fn plus(self, other: Self) -> Self {
        let same = self.sign == other.sign && self.sign != 0;
        Self {
            sign: if same { self.sign } else { 0 },
            zero: !same || (self.zero && other.zero),
            least: self.least.max(other.least),
            greatest: self.greatest.max(other.greatest) + 1.0,
        }
    }

    fn either(self, other: Self) -> Self {
        Self {
            sign: if self.sign == other.sign { self.sign } else { 0 },
            zero: self.zero || other.zero,
            least: self.least.min(other.least),
            greatest: self.greatest.max(other.greatest),
        }
    }

    fn of(spec: &Spec, op: &Op, at: impl Fn(Value) -> Self) -> Self {
        match op {
            Op::Number(value) => Self::of_number(number::round(value, spec.precision)),
            Op::Input(Input::Parameter(parameter)) => Self::of_parameter(spec, *parameter),
            Op::Neg(a) => at(*a).negative(),
            Op::Add(a, b) => at(*a).plus(at(*b)),
            Op::Sub(a, b) => at(*a).plus(at(*b).negative()),
            Op::Mul(a, b) => at(*a).times(at(*b)),
            Op::Div(a, b) | Op::Quotient(a, b) => at(*a).times(at(*b).inverse()),
            Op::Power(a, k) => (1..*k).fold(at(*a), |power, _| power.times(at(*a))),
            Op::Max(a, b) | Op::Min(a, b) => at(*a).either(at(*b)),
            Op::Call(Function::Sqrt, a) => {
                let a = at(*a);
                Self { sign: 1, least: a.least / 2.0, greatest: a.greatest / 2.0, ..a }
            }
            Op::Call(Function::Exp, _) | Op::Pow(..) => {
                Self { sign: 1, zero: false, ..Self::UNKNOWN }
            }
            _ => Self::UNKNOWN,
        }
    }
}

/// Returns the checks of `init` for the program of `spec`, in the order in which it computes the checked values, and then
/// those of `arm_for`, which computes what the duration decides.
pub fn checks(spec: &Spec, program: &Program) -> [Vec<Condition>; 2] {
    let of_duration = program.of_duration();
    let all = all_checks(spec, program, &of_duration);
    let (armed, init) = all.into_iter().partition(|check| of_duration[check.values()[0].0]);
    [init, armed]
}

fn all_checks(spec: &Spec, program: &Program, of_duration: &[bool]) -> Vec<Condition> {
    let (normal, largest) = normal(spec.precision);
    let mut sizes = vec![Size::UNKNOWN; program.values.len()];
    let mut checks = Vec::new();
    let needed = program.needed(&program.outputs());
    let is_known = |value: Value| program.get(value).stage <= Stage::Init || of_duration[value.0];
    let mut used = vec![false; program.values.len()];
    for value in needed.iter().filter(|value| !is_known(**value)) {
        program.get(*value).op.operands().into_iter().for_each(|operand| used[operand.0] = true);
    }
    // `axis` reads what `tick` hands over.
    program.handed_over().for_each(|value| used[value.0] = true);
    for value in needed.into_iter().filter(|value| is_known(*value)) {
        let op = &program.get(value).op;
        let mut size = Size::of(spec, op, |of| sizes[of.0]);
        let selects = matches!(op, Op::Call(..) | Op::Pow(..) | Op::Max(..) | Op::Min(..));
        if selects && !program.get(value).looped {
            let large = |of: &Value| sizes[of.0].greatest > largest;
            checks.extend(op.operands().into_iter().filter(large).map(Condition::Finite));
        }
        let product = matches!(
            op,
            Op::Mul(..)
                | Op::Div(..)
                | Op::Quotient(..)
                | Op::Power(..)
                | Op::Pow(..)
                | Op::Call(Function::Exp, _)
        );
        // What comes from outside, and `step` uses as it is.
        let given = matches!(op, Op::Input(_) | Op::Neg(_)) && size.zero && used[value.0];
        if (product || given) && !program.get(value).looped && size.least < normal {
            let mut factors = Vec::new();
            zero_with(program, &sizes, value, &mut factors);
            checks.push(match (factors.is_empty(), size.sign) {
                (true, 1) => Condition::Above(value),
                (true, -1) => Condition::Below(value),
                (true, _) => Condition::Kept(value, vec![value]),
                (false, _) => Condition::Kept(value, factors),
            });
            size.least = least(spec.precision).log2();
        }
        sizes[value.0] = size;
    }
    checks
}

/// The values with which `value` is 0, each a sum or a number from outside.
fn zero_with(program: &Program, sizes: &[Size], value: Value, found: &mut Vec<Value>) {
    let mut inner = |of: Value| {
        if sizes[of.0].zero {
            zero_with(program, sizes, of, found);
        }
    };
    match &program.get(value).op {
        Op::Neg(a) | Op::Power(a, _) | Op::Div(a, _) | Op::Quotient(a, _) => inner(*a),
        Op::Mul(a, b) => [*a, *b].into_iter().for_each(inner),
        Op::Pow(..) | Op::Call(Function::Exp, _) => {}
        _ if found.contains(&value) => {}
        _ => found.push(value),
    }
}

/// Why a number of the program, which fixed parameters decide, is beyond the range of its precision;
/// `None` if all of them keep their digits.
pub fn lost(program: &Program) -> Option<String> {
    let precision = program.precision;
    program.values.iter().find_map(|definition| {
        let Op::Number(value) = &definition.op else { return None };
        let rounded = number::round(value, precision);
        let small = !value.is_zero() && rounded.abs() < least(precision);
        let end = match small {
            true => "below",
            false if rounded.is_finite() => return None,
            false => "beyond",
        };
        Some(format!("a coefficient of u is {end} what {} code computes with", precision.name()))
    })
}
