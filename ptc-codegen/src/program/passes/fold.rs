//! fold: computes what is known at generation, in the precision of the program.

use num_traits::{One, Signed, Zero};

use super::{append, rebuild};
use crate::expression::Function;
use crate::program::{self, Definition, Op, Program, Value, number};

/// Replaces operations on numbers by the number they give at run time, bit for bit; removes
/// multiplications and divisions by 1 and double negations, moves signs of numbers into the
/// operations, and divides by a number that is not 0 without a test, which changes no bit. Operations whose result is no finite number are left for run
/// time, where they are reported; transcendental functions are left too, since the target's
/// library may round them otherwise.
pub(super) fn run(program: Program) -> Program {
    rebuild(&program, &mut fold)
}

fn fold(new: &mut Program, definition: Definition) -> Value {
    let definition = Definition { op: simpler(new, definition.op), ..definition };
    if let Some(operand) = neutral(new, &definition.op) {
        return operand;
    }
    let op = computed(new, &definition.op).unwrap_or(definition.op);
    append(new, op, definition.name)
}

fn constant(program: &Program, value: Value) -> Option<&crate::algebra::BigRational> {
    match &program.get(value).op {
        Op::Number(number) => Some(number),
        _ => None,
    }
}

/// A product with -1 as a negation, the sum with a negative number as a difference, and a quotient by
/// a number that is not 0 as a division, which give the same bits.
fn simpler(program: &mut Program, op: Op) -> Op {
    let minus_one = |v: Value| constant(program, v).is_some_and(|n| (-n).is_one());
    let divides =
        |v: Value| constant(program, v).is_some_and(|n| number::round(n, program.precision) != 0.0);
    match op {
        Op::Quotient(a, b) if divides(b) => Op::Div(a, b),
        Op::Mul(a, b) if minus_one(a) => Op::Neg(b),
        Op::Mul(a, b) if minus_one(b) => Op::Neg(a),
        Op::Add(a, b) => match constant(program, b) {
            Some(number) if number.is_negative() => {
                let magnitude = Op::Number(-number);
                Op::Sub(a, append(program, magnitude, None))
            }
            _ => Op::Add(a, b),
        },
        op => op,
    }
}

/// The operand that `op` returns unchanged.
fn neutral(program: &Program, op: &Op) -> Option<Value> {
    let is_one = |v: Value| constant(program, v).is_some_and(One::is_one);
    match op {
        Op::Mul(a, b) | Op::Div(a, b) if is_one(*b) => Some(*a),
        Op::Mul(a, b) if is_one(*a) => Some(*b),
        Op::Neg(a) => match program.get(*a).op {
            Op::Neg(inner) => Some(inner),
            _ => None,
        },
        _ => None,
    }
}

fn computed(program: &Program, op: &Op) -> Option<Op> {
    let exact = matches!(op, Op::Call(Function::Abs | Function::Sign | Function::Sqrt, _));
    if matches!(op, Op::Number(_) | Op::Input(_) | Op::Pow(..) | Op::Law(_))
        || matches!(op, Op::Call(..)) && !exact
    {
        return None;
    }
    let numbers: Option<Vec<f64>> = op
        .operands()
        .iter()
        .map(|v| constant(program, *v).map(|n| number::round(n, program.precision)))
        .collect();
    let result = program::apply(op, &numbers.filter(|n| !n.is_empty())?, program.precision)?;
    // A zero may carry a sign that a rational cannot hold.
    number::exact(result).filter(|value| !value.is_zero()).map(Op::Number)
}
