//! Operation counts of what is computed at each call, and what they cost.

use crate::expression::Function;

use super::{Op, Program, Stage, Value, elimination, rows};

/// Number of operations by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions, negations and comparisons.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Products and sums that are one operation.
    pub fused: usize,
    /// Divisions.
    pub div: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Calls of functions; those in a loop are counted once a round.
    pub calls: usize,
}

/// Cycles of one operation, as its latency in a dependent chain.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    add: usize,
    mul: usize,
    fused: usize,
    div: usize,
    sqrt: usize,
    calls: usize,
}

/// The cost model: double precision on x86-64, with the latencies of Skylake and some 60
/// instructions for a call of a library function.
pub static X86_64: Weights = Weights { add: 4, mul: 4, fused: 4, div: 14, sqrt: 18, calls: 60 };

/// Instructions: one for each operation, and some 60 for a call of a library function.
pub static INSTRUCTIONS: Weights = Weights { add: 1, mul: 1, fused: 1, div: 1, sqrt: 1, calls: 60 };

impl Cost {
    /// Cycles in the model, or instructions.
    pub fn cycles(&self, weights: &Weights) -> usize {
        self.add * weights.add
            + self.mul * weights.mul
            + self.fused * weights.fused
            + self.div * weights.div
            + self.sqrt * weights.sqrt
            + self.calls * weights.calls
    }
}

/// The operations of one step of so many axes: those of `tick` once, and those of `axis` for each.
pub fn of_axes(program: &Program, axes: usize) -> Cost {
    let handed: Vec<_> = program.handed_over().copied().collect();
    let tick = count(program, &handed, Stage::Tick);
    let axis = count(program, program.axis.as_slice(), Stage::Step);
    Cost {
        add: tick.add + axes * axis.add,
        mul: tick.mul + axes * axis.mul,
        fused: tick.fused + axes * axis.fused,
        div: tick.div + axes * axis.div,
        sqrt: tick.sqrt + axes * axis.sqrt,
        calls: tick.calls + axes * axis.calls,
    }
}

/// The operations that computing `roots` takes at `from` and later stages, one round of each loop.
pub fn count(program: &Program, roots: &[Value], from: Stage) -> Cost {
    let mut cost = Cost::default();
    for value in program.needed(roots) {
        let definition = program.get(value);
        if definition.stage < from {
            continue;
        }
        match &definition.op {
            Op::Add(..)
            | Op::Sub(..)
            | Op::Neg(_)
            | Op::Max(..)
            | Op::Min(..)
            | Op::Call(Function::Abs | Function::Sign, _) => {
                cost.add += 1;
            }
            Op::Mul(..) => cost.mul += 1,
            Op::Fused(..) => cost.fused += 1,
            Op::Power(_, k) => cost.mul += (k.ilog2() + k.count_ones() - 1) as usize,
            Op::Div(..) | Op::Quotient(..) => cost.div += 1,
            Op::Call(Function::Sqrt, _) => cost.sqrt += 1,
            Op::Call(..) | Op::Law(_) | Op::Pow(..) => cost.calls += 1,
            Op::Rows { tail, weights, fused } => {
                let (tail, weights) = (vec![(); tail.len()], vec![(); weights.len()]);
                let (mut sums, mut products) = (0, 0);
                rows::rows(&tail, &weights, |(), ()| sums += 1, |(), (), ()| products += 1);
                match fused {
                    true => cost.fused += products,
                    false => (cost.mul, cost.add) = (cost.mul + products, cost.add + products),
                }
                cost.add += sums;
            }
            Op::Elimination { right, .. } => {
                let (add, mul, div) = elimination::cost(right.len());
                (cost.add, cost.mul, cost.div) = (cost.add + add, cost.mul + mul, cost.div + div);
            }
            Op::Number(_) | Op::Input(_) | Op::Unknown | Op::Root(_) | Op::Element(..) => {}
        }
    }
    cost
}
