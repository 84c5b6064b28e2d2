//! Operation counts of what is computed at each call.

use super::{Op, Program, Stage, Value};

/// Number of operations by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and negations.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Divisions.
    pub div: usize,
    /// Calls of sqrt, exp, log, pow; those in a loop are counted once a round.
    pub functions: usize,
}

/// The operations that computing `roots` takes at `from` and later stages, one round of each loop.
pub fn count(program: &Program, roots: &[Value], from: Stage) -> Cost {
    let mut cost = Cost::default();
    for value in program.needed(roots) {
        let definition = program.get(value);
        if definition.stage < from {
            continue;
        }
        match definition.op {
            Op::Add(..) | Op::Sub(..) | Op::Neg(_) => cost.add += 1,
            Op::Mul(..) => cost.mul += 1,
            Op::Power(_, k) => cost.mul += (k.ilog2() + k.count_ones() - 1) as usize,
            Op::Div(..) => cost.div += 1,
            Op::Sqrt(_) | Op::Exp(_) | Op::Ln(_) | Op::Pow(..) => cost.functions += 1,
            _ => {}
        }
    }
    cost
}
