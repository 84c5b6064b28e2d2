//! Operations that are not smooth, and programs in which their branches are held.
//!
//! With every branch held a program is smooth, also beyond the surfaces on which it is not: what an
//! integration needs, which finds those surfaces by the distances from them.

use super::arithmetic::Arithmetic;
use super::machine::Machine;
use super::{Input, Op, Program, Stage, Value};
use crate::expression::Function;

/// An operation with a kink or a jump where its distance is 0.
#[derive(Clone, Copy, Debug)]
pub struct Kink {
    /// The operation.
    pub value: Value,
    left: Value,
    /// `None` for 0.
    right: Option<Value>,
    operation: Arithmetic,
}

impl Kink {
    /// Returns the values from which its distance is computed.
    pub fn operands(&self) -> impl Iterator<Item = Value> {
        std::iter::once(self.left).chain(self.right)
    }

    /// The operation where the distance is above 0, or below.
    fn branch(&self, above: bool) -> Arithmetic {
        match (self.operation, above) {
            (Arithmetic::Call(Function::Sign, _), true) => Arithmetic::Number(1.0),
            (Arithmetic::Call(Function::Sign, _), false) => Arithmetic::Number(-1.0),
            (Arithmetic::Call(_, a), true) => Arithmetic::Copy(a),
            (Arithmetic::Call(_, a), false) => Arithmetic::Neg(a),
            (Arithmetic::Max(a, _), true) | (Arithmetic::Min(_, a), true) => Arithmetic::Copy(a),
            (Arithmetic::Max(_, b), false) | (Arithmetic::Min(b, _), false) => Arithmetic::Copy(b),
            (operation, _) => operation,
        }
    }
}

/// Returns true for each value that changes with time in one direction, at one pace: its greatest and its least number
/// are at the ends of any interval of time.
pub fn steady(program: &Program) -> Vec<bool> {
    let mut steady: Vec<bool> = Vec::with_capacity(program.values.len());
    for definition in &program.values {
        let is_constant = |value: Value| program.get(value).stage <= Stage::Arm;
        let both = |a: Value, b: Value| steady[a.0] && steady[b.0];
        steady.push(match definition.op {
            _ if definition.stage <= Stage::Arm => true,
            Op::Input(input) => input == Input::Time,
            Op::Neg(a) => steady[a.0],
            Op::Add(a, b) | Op::Sub(a, b) => both(a, b),
            Op::Mul(a, b) => both(a, b) && (is_constant(a) || is_constant(b)),
            Op::Fused(a, b, c) => both(a, b) && steady[c.0] && (is_constant(a) || is_constant(b)),
            Op::Div(a, b) => both(a, b) && is_constant(b),
            _ => false,
        });
    }
    steady
}

impl Machine {
    /// The kinks of the outputs that time or state may cross.
    pub fn kinks(&self) -> Vec<Kink> {
        let due = [Stage::Tick, Stage::Step].into_iter().flat_map(|stage| self.due(stage));
        due.filter(|value| self.decides(**value))
            .filter_map(|value| {
                let operation = self.arithmetic(*value)?;
                let (left, right) = match operation {
                    Arithmetic::Call(Function::Sign | Function::Abs, a) => (a, None),
                    Arithmetic::Min(a, b) | Arithmetic::Max(a, b) => (a, Some(b)),
                    _ => return None,
                };
                let (left, right) = (Value(left), right.map(Value));
                Some(Kink { value: Value(*value), left, right, operation })
            })
            .collect()
    }

    /// Distance from a kink, signed, at the values at present.
    pub fn distance(&self, kink: &Kink) -> f64 {
        self.get(kink.left) - kink.right.map_or(0.0, |right| self.get(right))
    }

    /// Holds the branch of a kink from here on.
    pub fn hold(&mut self, kink: &Kink, above: bool) {
        self.replace(kink.value.0, kink.branch(above));
    }
}
