//! chains: writes integer powers as multiplications.

use super::{append, rebuild};
use crate::program::{Op, Program, Value};

/// a^k by its binary digits, squares first: the chain that the interpreter uses for a power, so
/// no bit changes. Equal squares of several powers are shared by the pass `share`.
pub(super) fn run(program: Program) -> Program {
    rebuild(&program, &mut |new, definition| match definition.op {
        Op::Power(base, exponent) => chain(new, base, exponent, definition.name),
        op => append(new, op, definition.name),
    })
}

fn chain(new: &mut Program, base: Value, exponent: u32, name: Option<(String, String)>) -> Value {
    let (mut square, mut left) = (base, exponent);
    let mut product: Option<Value> = None;
    loop {
        if left & 1 == 1 {
            product = Some(match product {
                None => square,
                Some(p) => append(new, Op::Mul(p, square), None),
            });
        }
        left >>= 1;
        if left == 0 {
            let value = product.unwrap_or(base);
            if name.is_some() && new.values[value.0].name.is_none() {
                new.values[value.0].name = name;
            }
            return value;
        }
        square = append(new, Op::Mul(square, square), None);
    }
}
