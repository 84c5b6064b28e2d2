//! Forward derivatives of values by the states, of which parts that are 0 are dropped.

use super::builder::Builder;
use super::coefficients::Coefficient;
use crate::expression::Function;
use crate::expression::function::Algebra;
use crate::program::{Input, Op, Value};

impl Builder<'_> {
    /// The derivatives of values along `field`, the rate of each state; `None` if one has a kink, or is no closed
    /// form.
    pub(super) fn tangents(
        &mut self,
        values: &[Coefficient],
        field: &[Coefficient],
    ) -> Option<Vec<Coefficient>> {
        let value = |a: &Coefficient| match a {
            Coefficient::Exact(_) => None,
            Coefficient::Value(value) => Some(*value),
        };
        let roots: Vec<_> = values.iter().filter_map(value).collect();
        let needed = self.needed(&roots);
        let mut known = vec![Coefficient::integer(0); needed.last().map_or(0, |last| last.0 + 1)];
        for value in needed {
            known[value.0] = self.tangent(value, field, &known)?;
        }
        let of = |a: &Coefficient| value(a).map(|value| known[value.0].clone());
        Some(values.iter().map(|a| of(a).unwrap_or(Coefficient::integer(0))).collect())
    }

    /// The derivative of one value from those of its operands.
    fn tangent(
        &mut self,
        value: Value,
        field: &[Coefficient],
        known: &[Coefficient],
    ) -> Option<Coefficient> {
        let of = |v: Value| Coefficient::Value(v);
        let op = self.operation_of(value).clone();
        if op.operands().iter().all(|operand| known[operand.0].is_zero()) {
            return Some(match op {
                Op::Input(Input::State(j)) => field[j - 1].clone(),
                _ => Coefficient::integer(0),
            });
        }
        Some(match op {
            Op::Neg(a) => self.negative(&known[a.0]),
            Op::Add(a, b) => self.plus(&known[a.0], &known[b.0]),
            Op::Sub(a, b) => self.minus(&known[a.0], &known[b.0]),
            Op::Mul(a, b) => {
                let (left, right) = (self.exact(a), self.exact(b));
                let (left, right) =
                    (self.times(&known[a.0], &right), self.times(&left, &known[b.0]));
                self.plus(&left, &right)
            }
            Op::Div(a, b) => {
                // (a' - (a/b) b')/b.
                let lost = self.times(&of(value), &known[b.0]);
                let over = self.minus(&known[a.0], &lost);
                self.over(&over, &of(b))
            }
            Op::Power(a, k) => {
                let less = self.power(a, k - 1);
                let slope = self.times(&Coefficient::index(k as usize), &of(less));
                self.times(&slope, &known[a.0])
            }
            Op::Pow(a, b) if known[b.0].is_zero() => {
                let share = self.over(&known[a.0], &of(a));
                let slope = self.times(&self.exact(b), &of(value));
                self.times(&slope, &share)
            }
            Op::Call(function, a) if !function.row().has_kink => {
                let slope = function.slope(&mut Values(self), &a);
                self.times(&of(slope), &known[a.0])
            }
            _ => return None,
        })
    }

    /// A value as a coefficient, exact where it is a number.
    pub(super) fn exact(&self, value: Value) -> Coefficient {
        self.constant(value).cloned().map_or(Coefficient::Value(value), Coefficient::Exact)
    }
}

/// Values of a program, as a kind of number.
struct Values<'a, 'b>(&'a mut Builder<'b>);

impl Algebra for Values<'_, '_> {
    type Number = Value;

    fn integer(&mut self, value: i64) -> Value {
        self.0.integer(value)
    }

    fn neg(&mut self, a: Value) -> Value {
        self.0.push(Op::Neg(a))
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        self.0.add(a, b)
    }

    fn sub(&mut self, a: Value, b: Value) -> Value {
        self.0.sub(a, b)
    }

    fn twice(&mut self, a: Value) -> Value {
        let two = self.0.integer(2);
        self.0.mul(two, a)
    }

    fn square(&mut self, a: Value) -> Value {
        self.0.mul(a, a)
    }

    fn div(&mut self, a: Value, b: Value) -> Value {
        self.0.div(a, b)
    }

    fn call(&mut self, function: Function, a: &Value) -> Value {
        self.0.push(Op::Call(function, *a))
    }
}
