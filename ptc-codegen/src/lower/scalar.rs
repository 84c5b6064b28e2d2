//! Expressions as values.

use num_traits::Signed;

use super::builder::Builder;
use super::coefficient::pi_power;
use super::input_gain::over_number;
use crate::expression::{Expression, Found, Function, Node, Variable};
use crate::parameter::Parameter;
use crate::program::{Input, Op, Value};

impl Builder<'_> {
    /// The value of an expression.
    pub(super) fn scalar(&mut self, expression: &Expression) -> Value {
        self.part(expression, &mut Found::default())
    }

    /// The value of a part of an expression, with those of the parts that are found.
    pub(super) fn part(&mut self, expression: &Expression, found: &mut Found<Value>) -> Value {
        if let Some(known) = found.get(expression) {
            return *known;
        }
        let value = self.operation(expression, found);
        if expression.height() > 0 {
            found.insert(expression.clone(), value);
        }
        value
    }

    fn operation(&mut self, expression: &Expression, found: &mut Found<Value>) -> Value {
        if let Some(value) = self.cotangent(expression) {
            return value;
        }
        match expression.node() {
            Node::Number(number) => self.number(number.clone()),
            Node::Pi => self.number(pi_power(1)),
            // The start is armed anew, whatever the parameter was.
            Node::Parameter(Parameter::StartTime) => self.push(Op::Input(Input::StartTime)),
            Node::Parameter(parameter) => self.parameter(*parameter),
            Node::Variable(variable) => self.variable(*variable),
            Node::Neg(a) => {
                let a = self.part(a, found);
                self.push(Op::Neg(a))
            }
            Node::Power(a, exponent) => {
                let a = self.part(a, found);
                self.scalar_power(a, exponent, found)
            }
            Node::Call(function, a) => {
                let a = self.part(a, found);
                self.push(Op::Call(*function, a))
            }
            Node::Add(a, b)
            | Node::Sub(a, b)
            | Node::Mul(a, b)
            | Node::Div(a, b)
            | Node::Min(a, b)
            | Node::Max(a, b) => {
                let (a, b) = (self.part(a, found), self.part(b, found));
                let divisor =
                    self.constant(b).filter(|_| matches!(expression.node(), Node::Div(..)));
                if let Some(divisor) = divisor.cloned() {
                    return over_number(self, a, &divisor);
                }
                self.push(match expression.node() {
                    Node::Add(..) => Op::Add(a, b),
                    Node::Sub(..) => Op::Sub(a, b),
                    Node::Mul(..) => Op::Mul(a, b),
                    Node::Div(..) => Op::Div(a, b),
                    Node::Min(..) => Op::Min(a, b),
                    _ => Op::Max(a, b),
                })
            }
        }
    }

    /// base^exponent: multiplications for an integer exponent, a root for 1/2, else `pow`, for
    /// which the base is positive. The values of parts that are `found` are shared.
    pub(super) fn scalar_power(
        &mut self,
        base: Value,
        exponent: &Expression,
        found: &mut Found<Value>,
    ) -> Value {
        if let Some(k) = exponent.small_integer().filter(|k| k.unsigned_abs() <= 64) {
            let power = match k.unsigned_abs() {
                0 => return self.integer(1),
                k => self.power(base, k),
            };
            let one = self.integer(1);
            return if k < 0 { self.div(one, power) } else { power };
        }
        let half = exponent.number().filter(|n| *n.denom() == 2.into() && *n.numer() == 1.into());
        if half.is_some() {
            return self.push(Op::Call(Function::Sqrt, base));
        }
        if let Some(number) = exponent.number().filter(|n| n.is_negative()) {
            let power = self.number(-number);
            let (one, power) = (self.integer(1), self.push(Op::Pow(base, power)));
            return self.div(one, power);
        }
        let exponent = self.part(exponent, found);
        self.push(Op::Pow(base, exponent))
    }

    /// t - t0.
    pub(super) fn since_start(&mut self) -> Value {
        let (time, start) = (Op::Input(Input::Time), Op::Input(Input::StartTime));
        let (time, start) = (self.push(time), self.push(start));
        self.sub(time, start)
    }

    fn variable(&mut self, variable: Variable) -> Value {
        if self.followed().is_some() {
            match variable {
                Variable::StretchedTime => return self.push(Op::Input(Input::Time)),
                Variable::SinceStart => return self.since_start(),
                Variable::Elapsed => {
                    let (tau, time_to_go) = (self.parameter(Parameter::Tau), self.time_to_go());
                    return self.sub(tau, time_to_go);
                }
                Variable::Xi(j) => return self.push(Op::Input(Input::State(j))),
                _ => {}
            }
        }
        let away = self.counts_down() || self.followed().is_some();
        if let (true, Some(plant)) = (away, self.plant.clone()) {
            match variable {
                Variable::Time => return self.time_of_plant(),
                Variable::Elapsed => return self.elapsed_of_plant(),
                Variable::State(j) => return plant.states[j - 1],
                Variable::Control => {
                    return plant.control.unwrap_or_else(|| self.push(Op::Input(Input::Control)));
                }
                _ => {}
            }
        }
        match variable {
            Variable::Control => self.push(Op::Input(Input::Control)),
            Variable::Time => self.push(Op::Input(Input::Time)),
            Variable::Elapsed => self.since_start(),
            Variable::TimeToGo => self.time_to_go(),
            Variable::KappaRate => self.taylor().base_inverse,
            Variable::R(k) => self.r(k),
            Variable::SinceStart => self.stretched(),
            Variable::StretchedTime => {
                let start = self.push(Op::Input(Input::StartTime));
                let stretched = self.stretched();
                let time = self.add(start, stretched);
                self.name(time, "t_kappa", "stretched time kappa + t0")
            }
            Variable::State(j) => self.push(Op::Input(Input::State(j))),
            Variable::StateAtStart(j) => self.push(Op::Input(Input::StateAtStart(j))),
            Variable::Xi(j) => self.xi(j),
            Variable::XiAtStart(j) => self.xi_at_start(j),
        }
    }
}
