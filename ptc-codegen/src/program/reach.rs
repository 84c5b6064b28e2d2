//! Inputs that show in a value: where NaN or infinity of the input leaves the value not finite, a test of the value is
//! a test of the input.

use super::{Input, Op, Program, Stage, Value};
use crate::expression::Function;

impl Program {
    /// Returns true if `value` is not finite whenever `input` is not: sums, products, numerators and both sides of a
    /// choice pass NaN and infinity on; denominators and library functions may not.
    pub fn shows(&self, input: Input, value: Value) -> bool {
        let mut shows = vec![false; value.0 + 1];
        for index in 0..=value.0 {
            let of = |v: &Value| shows[v.0];
            shows[index] = match &self.values[index].op {
                Op::Input(own) => *own == input,
                Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) => of(a) || of(b),
                Op::Fused(a, b, c) => of(a) || of(b) || of(c),
                Op::Neg(a)
                | Op::Div(a, _)
                | Op::Quotient(a, _)
                | Op::Power(a, _)
                | Op::Call(Function::Abs, a) => of(a),
                Op::Max(a, b) | Op::Min(a, b) => of(a) && of(b),
                _ => false,
            };
        }
        shows[value.0]
    }

    /// Returns true if the path from `source` to `value` contains a library function, a user-defined law or a loop.
    pub fn leaves_arithmetic(&self, source: Value, value: Value) -> bool {
        let depends = self.dependents(source, &[], value);
        let is_call = |op: &Op| match op {
            Op::Call(function, _) => !matches!(function, Function::Abs | Function::Sign),
            Op::Pow(..) | Op::Law(_) | Op::Rows { .. } | Op::Elimination { .. } | Op::Root(_) => {
                true
            }
            _ => false,
        };
        let needed = self.needed(&[value]).into_iter();
        let mut dependent = needed.filter(|v| depends[v.0] && *v != source);
        dependent.any(|v| is_call(&self.get(v).op))
    }

    /// Returns true if `value` depends on `source` otherwise than through the values `through`.
    pub fn depends(&self, source: Value, through: &[Value], value: Value) -> bool {
        self.dependents(source, through, value)[value.0]
    }

    /// Returns, for each value up to `value`, true if it depends on `source`; the values `through` are taken not to.
    fn dependents(&self, source: Value, through: &[Value], value: Value) -> Vec<bool> {
        let mut depends = vec![false; value.0.max(source.0) + 1];
        for index in source.0..depends.len() {
            let own = Value(index);
            let operands = self.values[index].op.operands();
            let any = operands.iter().any(|v| depends[v.0]);
            depends[index] = own == source || (any && !through.contains(&own));
        }
        depends
    }

    /// Returns true if `value` is time less values that are known before it.
    pub fn is_shifted_time(&self, value: Value) -> bool {
        match self.get(value).op {
            Op::Input(Input::Time) => true,
            Op::Sub(a, b) => self.get(b).stage < Stage::Tick && self.is_shifted_time(a),
            _ => false,
        }
    }

    /// The value of an input, where the program has it.
    pub fn input(&self, input: Input) -> Option<Value> {
        let position = self.values.iter().position(|of| of.op == Op::Input(input));
        position.map(Value)
    }
}
