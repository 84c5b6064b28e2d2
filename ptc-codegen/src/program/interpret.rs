//! The interpreter: the same operations in the same order and precision as the emitted code.

use std::collections::{BTreeMap, BTreeSet};

use super::{Input, Op, Program, Root, Value, number, rows};
use crate::expression::Function;
use crate::spec::Precision;

/// The user's own law of xi_1..xi_n and stretched time.
pub type UserLaw<'a> = &'a dyn Fn(&[f64]) -> f64;

/// A way that a value took where its operation has several: see [`Interpreter::decisions`].
pub type Decision = (Value, &'static str);

/// The values of a program for given inputs.
pub struct Interpreter<'a> {
    program: &'a Program,
    input: &'a dyn Fn(Input) -> f64,
    law: Option<UserLaw<'a>>,
    known: Vec<Option<f64>>,
    arrays: BTreeMap<Value, Vec<f64>>,
    decisions: BTreeSet<Decision>,
}

impl<'a> Interpreter<'a> {
    /// An interpreter for `program`; `input` gives each input, already in the program's precision.
    pub fn new(program: &'a Program, input: &'a dyn Fn(Input) -> f64) -> Self {
        Self {
            program,
            input,
            law: None,
            known: vec![None; program.values.len()],
            arrays: BTreeMap::new(),
            decisions: BTreeSet::new(),
        }
    }

    /// The ways that the emitted code took so far where it has a branch: which operand is the
    /// lesser or the greater one, which sign a number has, and how an iteration went.
    pub fn decisions(&self) -> &BTreeSet<Decision> {
        &self.decisions
    }

    /// The same with the user's own law, of xi_1..xi_n and stretched time; without one it is NaN.
    #[must_use]
    pub fn with_law(self, law: UserLaw<'a>) -> Self {
        Self { law: Some(law), ..self }
    }

    /// The number that `value` takes.
    pub fn value(&mut self, value: Value) -> f64 {
        self.values(&[value])[0]
    }

    /// The numbers that several values take, each operation done once.
    pub fn values(&mut self, values: &[Value]) -> Vec<f64> {
        for needed in self.program.needed(values) {
            if self.known[needed.0].is_none() && !self.program.get(needed).looped {
                let result = self.compute(needed);
                self.known[needed.0] = Some(result);
            }
        }
        values.iter().map(|value| self.at(*value)).collect()
    }

    fn at(&self, value: Value) -> f64 {
        self.known[value.0].unwrap_or(f64::NAN)
    }

    fn compute(&mut self, value: Value) -> f64 {
        match &self.program.get(value).op {
            Op::Input(input) => (self.input)(*input),
            Op::Root(root) => self.root(value, root),
            Op::Law(arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|v| self.at(*v)).collect();
                self.law.map_or(f64::NAN, |law| law(&arguments))
            }
            Op::Rows { tail, weights } => {
                let [tail, weights] =
                    [tail, weights].map(|v| v.iter().map(|v| self.at(*v)).collect::<Vec<_>>());
                let precision = self.program.precision;
                let add = |a, b| number::settle(a + b, precision);
                let mul = |a, b| settle_mul(a, b, precision);
                self.arrays.insert(value, rows::rows(&tail, &weights, add, mul));
                // An array is no number.
                f64::NAN
            }
            Op::Element(array, index) => self.arrays[array][*index],
            op => {
                let operands: Vec<_> = op.operands().iter().map(|v| self.at(*v)).collect();
                self.decisions.extend(way(op, &operands).map(|way| (value, way)));
                apply(op, &operands, self.program.precision).unwrap_or(f64::NAN)
            }
        }
    }

    fn root(&mut self, value: Value, root: &Root) -> f64 {
        let precision = self.program.precision;
        let targets = [root.residual, root.next, root.size];
        let body: Vec<_> = self
            .program
            .needed(&targets)
            .into_iter()
            .filter(|v| self.program.get(*v).looped && *v != root.unknown)
            .collect();
        let (mut low, mut high, mut y) =
            (self.at(root.low), self.at(root.high), self.at(root.start));
        let mut ended = "exhausted";
        for _ in 0..root.rounds {
            self.known[root.unknown.0] = Some(y);
            for value in &body {
                let result = self.compute(*value);
                self.known[value.0] = Some(result);
            }
            let right = self.at(root.residual) > 0.0;
            if right {
                low = y;
            } else {
                high = y;
            }
            let next = self.at(root.next);
            let proposal = match () {
                () if next >= low && next <= high => "inside",
                () if next >= low => "beyond",
                () => "before",
            };
            self.decisions
                .extend([(value, if right { "right" } else { "left" }), (value, proposal)]);
            y = if next >= low && next <= high {
                next
            } else {
                settle_mul(0.5, number::settle(low + high, precision), precision)
            };
            if self.at(root.size) <= self.at(root.tolerance) {
                ended = "ended";
                break;
            }
        }
        self.decisions.insert((value, ended));
        y
    }
}

/// The way of an operation that is emitted with a branch.
fn way(op: &Op, operands: &[f64]) -> Option<&'static str> {
    match (op, operands) {
        (Op::Min(..) | Op::Max(..), [a, b]) => Some(if a < b { "less" } else { "not less" }),
        (Op::Call(Function::Sign, _), [a]) | (Op::Quotient(..), [_, a]) => Some(match () {
            () if *a > 0.0 => "positive",
            () if *a < 0.0 => "negative",
            () => "zero",
        }),
        _ => None,
    }
}

fn settle_mul(a: f64, b: f64, precision: Precision) -> f64 {
    number::settle(a * b, precision)
}

/// The result of an operation on numbers; `None` for operations that need more than numbers.
pub fn apply(op: &Op, operands: &[f64], precision: Precision) -> Option<f64> {
    let settle = |result| number::settle(result, precision);
    Some(match (op, operands) {
        (Op::Number(value), _) => number::round(value, precision),
        (Op::Neg(_), [a]) => -a,
        (Op::Add(..), [a, b]) => settle(a + b),
        (Op::Sub(..), [a, b]) => settle(a - b),
        (Op::Mul(..), [a, b]) => settle(a * b),
        (Op::Div(..), [a, b]) => settle(a / b),
        (Op::Quotient(..), [a, b]) => {
            if *b != 0.0 && !b.is_nan() {
                settle(a / b)
            } else {
                f64::NAN
            }
        }
        (Op::Power(_, k), [a]) => power(*a, *k, precision),
        (Op::Max(..), [a, b]) => {
            if a < b {
                *b
            } else {
                *a
            }
        }
        (Op::Min(..), [a, b]) => {
            if a < b {
                *a
            } else {
                *b
            }
        }
        (Op::Call(function, _), [a]) => call(*function, *a, precision),
        #[allow(clippy::cast_possible_truncation)]
        (Op::Pow(..), [a, b]) => match precision {
            Precision::F64 => a.powf(*b),
            Precision::F32 => f64::from((*a as f32).powf(*b as f32)),
        },
        _ => return None,
    })
}

/// A function of one number.
type Real<R> = fn(R) -> R;

/// A function of the platform; a float one may differ from the rounded double one in the last bit.
#[allow(clippy::cast_possible_truncation)]
fn call(function: Function, a: f64, precision: Precision) -> f64 {
    let (double, single): (Real<f64>, Real<f32>) = match function {
        Function::Abs => (f64::abs, f32::abs),
        Function::Sign => (|a| sign(a, 0.0, 1.0), |a| sign(a, 0.0, 1.0)),
        Function::Sqrt => (f64::sqrt, f32::sqrt),
        Function::Exp => (f64::exp, f32::exp),
        Function::Ln => (f64::ln, f32::ln),
        Function::Sin => (f64::sin, f32::sin),
        Function::Cos => (f64::cos, f32::cos),
        Function::Tan => (f64::tan, f32::tan),
        Function::Atan => (f64::atan, f32::atan),
        Function::Sinh => (f64::sinh, f32::sinh),
        Function::Cosh => (f64::cosh, f32::cosh),
        Function::Tanh => (f64::tanh, f32::tanh),
        Function::Atanh => (f64::atanh, f32::atanh),
    };
    match precision {
        Precision::F64 => double(a),
        Precision::F32 => f64::from(single(a as f32)),
    }
}

/// 1, -1, or a itself where it is a zero or no number.
fn sign<R: PartialOrd + std::ops::Neg<Output = R> + Copy>(a: R, zero: R, one: R) -> R {
    if a > zero {
        one
    } else if a < zero {
        -one
    } else {
        a
    }
}

/// a^k by the chain that [`passes::chains`](super::passes) writes out.
fn power(a: f64, k: u32, precision: Precision) -> f64 {
    let mut square = a;
    let mut product = None;
    let mut left = k;
    loop {
        if left & 1 == 1 {
            product = Some(product.map_or(square, |p| settle_mul(p, square, precision)));
        }
        left >>= 1;
        if left == 0 {
            return product.unwrap_or(1.0);
        }
        square = settle_mul(square, square, precision);
    }
}
