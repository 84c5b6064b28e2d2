//! fuse: writes a product and the sum that needs it as one operation with one rounding.

use super::{append, rebuild, uses};
use crate::program::{Definition, Fusion, Op, Program, Stage, Value};

/// Fuses, if the program sets `fma`, the sums and differences of a tick and a step with a product of the same stage
/// that nothing else uses, and those in loops. Beside `balance` it is the one pass that changes roundings: there is one
/// less in each.
pub(super) fn run(program: Program) -> Program {
    if !program.fma {
        return program;
    }
    let uses = uses(&program);
    let mut index = 0;
    rebuild(&program, &mut |new, definition| {
        let old = &program.values[index];
        index += 1;
        let free = |v: Value| {
            let product = program.get(v);
            let alike = product.stage == old.stage && product.looped == old.looped;
            matches!(product.op, Op::Mul(..)) && uses[v.0] == 1 && alike
        };
        let op = match (&old.op, &definition.op) {
            _ if old.stage < Stage::Tick => None,
            (_, Op::Rows { tail, weights, .. }) => {
                Some(Op::Rows { tail: tail.clone(), weights: weights.clone(), fused: true })
            }
            (Op::Add(one, other), Op::Add(a, b)) => {
                match Fusion::of_sum([free(*one), free(*other)]) {
                    Some(Fusion::First) => fused(new, *a, *b),
                    Some(Fusion::Second) => fused(new, *b, *a),
                    None => None,
                }
            }
            (Op::Sub(one, other), Op::Sub(a, b)) => {
                let products = [*one, *other].map(|v| matches!(program.get(v).op, Op::Mul(..)));
                match Fusion::of_difference(products, [free(*one), free(*other)]) {
                    Some(Fusion::First) => minus(new, old.stage, *a, *b),
                    Some(Fusion::Second) => less(new, old.stage, *a, *b),
                    None => None,
                }
            }
            _ => None,
        };
        let Definition { op: plain, name, .. } = definition;
        append(new, op.unwrap_or(plain), name)
    })
}

/// The factors of a product.
fn factors(program: &Program, product: Value) -> Option<(Value, Value)> {
    match program.get(product).op {
        Op::Mul(x, y) => Some((x, y)),
        _ => None,
    }
}

/// product + c.
fn fused(new: &Program, product: Value, c: Value) -> Option<Op> {
    factors(new, product).map(|(x, y)| Op::Fused(x, y, c))
}

/// c - product, by the negative of the factor that costs no field.
fn less(new: &mut Program, stage: Stage, c: Value, product: Value) -> Option<Op> {
    let (x, y) = factors(new, product)?;
    match negative(new, stage, x) {
        Some(x) => Some(Op::Fused(x, y, c)),
        None => negative(new, stage, y).map(|y| Op::Fused(x, y, c)),
    }
}

/// product - c.
fn minus(new: &mut Program, stage: Stage, product: Value, c: Value) -> Option<Op> {
    let (x, y) = factors(new, product)?;
    negative(new, stage, c).map(|c| Op::Fused(x, y, c))
}

/// -a, which is exact, where it is computed in `stage` or is a number; the negative of an earlier value
/// would be a field more.
fn negative(new: &mut Program, stage: Stage, a: Value) -> Option<Value> {
    match new.get(a).op.clone() {
        Op::Number(number) => Some(append(new, Op::Number(-number), None)),
        Op::Neg(inner) => Some(inner),
        _ if new.get(a).stage == stage => Some(append(new, Op::Neg(a), None)),
        _ => None,
    }
}
