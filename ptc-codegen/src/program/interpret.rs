//! The interpreter: the same operations in the same order and precision as the emitted code.

use super::{Input, Op, Program, Root, Value, number};
use crate::spec::Precision;

/// The values of a program for given inputs.
pub struct Interpreter<'a> {
    program: &'a Program,
    input: &'a dyn Fn(Input) -> f64,
    known: Vec<Option<f64>>,
}

impl<'a> Interpreter<'a> {
    /// An interpreter for `program`; `input` gives each input, already in the program's precision.
    pub fn new(program: &'a Program, input: &'a dyn Fn(Input) -> f64) -> Self {
        Self { program, input, known: vec![None; program.values.len()] }
    }

    /// The number that `value` takes.
    pub fn value(&mut self, value: Value) -> f64 {
        for needed in self.program.needed(&[value]) {
            if self.known[needed.0].is_none() && !self.program.get(needed).looped {
                let result = self.compute(needed);
                self.known[needed.0] = Some(result);
            }
        }
        self.at(value)
    }

    fn at(&self, value: Value) -> f64 {
        self.known[value.0].unwrap_or(f64::NAN)
    }

    fn compute(&mut self, value: Value) -> f64 {
        match &self.program.get(value).op {
            Op::Input(input) => (self.input)(*input),
            Op::Root(root) => self.root(root),
            op => {
                let operands: Vec<_> = op.operands().iter().map(|v| self.at(*v)).collect();
                apply(op, &operands, self.program.precision).unwrap_or(f64::NAN)
            }
        }
    }

    fn root(&mut self, root: &Root) -> f64 {
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
        for _ in 0..root.rounds {
            self.known[root.unknown.0] = Some(y);
            for value in &body {
                let result = self.compute(*value);
                self.known[value.0] = Some(result);
            }
            if self.at(root.residual) > 0.0 {
                low = y;
            } else {
                high = y;
            }
            let next = self.at(root.next);
            y = if next >= low && next <= high {
                next
            } else {
                settle_mul(0.5, number::settle(low + high, precision), precision)
            };
            if self.at(root.size) <= self.at(root.tolerance) {
                break;
            }
        }
        y
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
        (Op::Abs(_), [a]) => a.abs(),
        (Op::Sqrt(_), [a]) => settle(a.sqrt()),
        // A float function of the platform may differ from the rounded double one in the last bit.
        (Op::Exp(_), [a]) => function(*a, f64::exp, f32::exp, precision),
        (Op::Ln(_), [a]) => function(*a, f64::ln, f32::ln, precision),
        #[allow(clippy::cast_possible_truncation)]
        (Op::Pow(..), [a, b]) => match precision {
            Precision::F64 => a.powf(*b),
            Precision::F32 => f64::from((*a as f32).powf(*b as f32)),
        },
        _ => return None,
    })
}

#[allow(clippy::cast_possible_truncation)]
fn function(a: f64, double: fn(f64) -> f64, single: fn(f32) -> f32, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => double(a),
        Precision::F32 => f64::from(single(a as f32)),
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
