//! share: keeps one of several equal values.

use std::collections::HashMap;

use super::{append, rebuild};
use crate::program::{Op, Program, Value};

/// Two values with the same operation on the same operands are the same bits. The operands of a
/// product or a sum are put in order first, which changes no bit either. Looked up, never
/// iterated: the order of the map decides nothing.
pub(super) fn run(program: Program) -> Program {
    let mut known: HashMap<Op, Value> = HashMap::new();
    rebuild(&program, &mut |new, definition| {
        if definition.op == Op::Unknown {
            return append(new, definition.op, definition.name);
        }
        let key = ordered(definition.op.clone());
        if let Some(value) = known.get(&key) {
            if new.values[value.0].name.is_none() {
                new.values[value.0].name = definition.name;
            }
            return *value;
        }
        let value = append(new, definition.op, definition.name);
        known.insert(key, value);
        value
    })
}

fn ordered(op: Op) -> Op {
    match op {
        Op::Mul(a, b) if b < a => Op::Mul(b, a),
        Op::Add(a, b) if b < a => Op::Add(b, a),
        op => op,
    }
}
