//! Statements, values and tests of one call.

use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::BTreeMap;

use super::{Called, Held, Outcome};
use crate::code::branch::{Asked, At, Taken, at};
use crate::code::{
    AXIS, Cell, Ending, Expr, Finish, Function, Operator, Place, Shape, Solve, Statement, Status,
    Test, Variable,
};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::elimination::eliminate;
use crate::program::{Op, Root, Value, apply, number, rows::of_numbers};

/// The names that one call knows.
pub(super) struct Frame<'a, 'b> {
    pub(super) precision: Precision,
    pub(super) fields: &'b mut BTreeMap<&'a str, Held>,
    pub(super) parameters: BTreeMap<&'b str, Held>,
    pub(super) locals: BTreeMap<Cow<'b, str>, Held>,
    pub(super) callbacks: &'b [Called<'b>],
    /// The branches taken so far, where they are recorded.
    pub(super) taken: Option<RefCell<Taken>>,
}

impl<'b> Frame<'_, 'b> {
    /// Runs a function whose gains, if it belongs to any, have the status `standing`.
    pub(super) fn run(
        &mut self,
        function: &'b Function,
        standing: Status,
        gains: &[Variable],
    ) -> Outcome {
        let failed = |status| Outcome { status, results: BTreeMap::new() };
        let ended = self.block(&function.body);
        if let Finish::Inputs(inputs) = &function.finish {
            return self.inputs(function, inputs, ended);
        }
        if let Some(status) = ended {
            return failed(status);
        }
        let mut finish = &function.finish;
        let (values, status) = loop {
            match finish {
                Finish::If(test, yes, no) => finish = if self.test(test) { yes } else { no },
                Finish::Give(values, Ending::Known(status)) => break (values, *status),
                Finish::Give(values, Ending::OfGains) => break (values, standing),
                Finish::Fail(status) => return failed(*status),
                Finish::Axes(_) | Finish::Inputs(_) => {
                    fault("several inputs are given together".to_owned())
                }
            }
        };
        let mut values = values.iter().map(|value| self.real(value));
        let parts = function.results.iter().flat_map(|result| match result.shape {
            Shape::Gains => gains.iter().collect(),
            _ => vec![result],
        });
        let mut results = BTreeMap::new();
        for part in parts {
            let count = part.shape.length().unwrap_or(1);
            results.insert(part.name.clone(), values.by_ref().take(count).collect());
        }
        Outcome { status, results }
    }

    /// Runs statements; the status where one of them fails.
    pub(super) fn block(&mut self, statements: &'b [Statement]) -> Option<Status> {
        for statement in statements {
            match statement {
                Statement::Let(name, shape, value) => {
                    let value = self.value(value, *shape);
                    self.locals.insert(Cow::from(name), value);
                }
                Statement::Set(Place::Local(name), value) => {
                    let value = Held::Real(self.real(value));
                    self.locals.insert(Cow::from(name), value);
                }
                Statement::Set(Place::Field(name), value) => {
                    let shape = match self.fields.get(name.as_str()) {
                        Some(Held::Count(_)) => Shape::Count,
                        _ => Shape::Real,
                    };
                    let value = self.value(value, shape);
                    if let Some(field) = self.fields.get_mut(name.as_str()) {
                        *field = value;
                    }
                }
                Statement::If(test, then, otherwise) => {
                    let block = if self.test(test) { then } else { otherwise };
                    if let Some(status) = self.block(block) {
                        return Some(status);
                    }
                }
                Statement::Require(test, status) if !self.test(test) => return Some(*status),
                Statement::Array(name, values) => {
                    let values = values.iter().map(|value| self.real(value)).collect();
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Rows { name, tail, weights, fused } => {
                    let [tail, weights]: [Vec<f64>; 2] =
                        [tail, weights].map(|list| list.iter().map(|v| self.real(v)).collect());
                    let values = of_numbers(&tail, &weights, *fused, self.precision);
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Elimination { name, matrix, right } => {
                    let [matrix, right]: [Vec<f64>; 2] =
                        [matrix, right].map(|list| list.iter().map(|v| self.real(v)).collect());
                    let values = eliminate(&matrix, &right, self.precision);
                    // The determinant stands last, and may be 0 by underflow alone.
                    let lost = values.iter().any(|value| value.is_nan());
                    let singular = values.last() == Some(&0.0) && lost;
                    self.note(at(statement, Asked::Regular), !singular);
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Call { name, callback, array, times, count } => {
                    let values = self.call(callback, array, times, *count);
                    self.locals.insert(Cow::from(name), Held::Reals(values));
                }
                Statement::Solve(solve) => {
                    if let Some(status) = self.solve(solve) {
                        return Some(status);
                    }
                }
                Statement::Require(..) | Statement::Variable(..) | Statement::Note(_) => {}
            }
        }
        None
    }

    /// What a function of several values gives: it is asked for one at a time.
    fn call(&self, callback: &str, array: &str, times: &[Expr; 2], count: usize) -> Vec<f64> {
        let called = self.callbacks.iter().find(|(known, _)| *known == callback);
        let (Some((_, called)), Some(Held::Reals(array))) = (called, self.locals.get(array)) else {
            fault(format!("no function {callback}, or no array {array}"))
        };
        let [time, rate] = times.each_ref().map(|time| self.real(time));
        let place = |index: usize| u32::try_from(index).map_or(f64::NAN, f64::from);
        let one = |index| called(&[array.as_slice(), &[rate, place(index)]].concat(), time);
        (0..count).map(|index| number::settle(one(index), self.precision)).collect()
    }

    /// The rounds of an iteration, the root of which is left in its unknown.
    fn solve(&mut self, solve: &'b Solve) -> Option<Status> {
        let [mut y, mut low, mut high, tolerance] =
            [&solve.start, &solve.low, &solve.high, &solve.tolerance].map(|value| self.real(value));
        let settle = |value, precision| number::settle(value, precision);
        for round in 0..solve.rounds {
            self.locals.insert(Cow::from(&solve.unknown), Held::Real(y));
            if let Some(status) = self.block(&solve.body) {
                return Some(status);
            }
            let [residual, next, size] =
                [&solve.residual, &solve.next, &solve.size].map(|value| self.real(value));
            if residual > 0.0 {
                low = y;
            } else {
                high = y;
            }
            y = match next >= low && next <= high {
                true => next,
                false => settle(0.5 * settle(low + high, self.precision), self.precision),
            };
            if size <= tolerance {
                break;
            }
            if round >= solve.proposals {
                y = Root::middle(low, high, self.precision);
            }
        }
        self.locals.insert(Cow::from(&solve.unknown), Held::Real(y));
        None
    }

    fn value(&self, value: &Expr, shape: Shape) -> Held {
        match shape {
            Shape::Count => Held::Count(self.count(value)),
            _ => Held::Real(self.real(value)),
        }
    }

    pub(super) fn real(&self, value: &Expr) -> f64 {
        let round = |result| number::settle(result, self.precision);
        match value {
            Expr::Number(value) => number::round(value, self.precision),
            Expr::Neg(a) => -self.real(a),
            Expr::Binary(operator, a, b) => match operator {
                Operator::Add => self.apply(Op::Add, a, b),
                Operator::Sub => self.apply(Op::Sub, a, b),
                Operator::Mul => self.apply(Op::Mul, a, b),
                Operator::Div => self.apply(Op::Div, a, b),
            },
            Expr::Fused(operands) => {
                let [a, b, c] = [Value(0), Value(1), Value(2)];
                let operands = operands.each_ref().map(|operand| self.real(operand));
                apply(&Op::Fused(a, b, c), &operands, self.precision).unwrap_or(f64::NAN)
            }
            Expr::Quotient(a, b) => {
                let divisor = self.real(b);
                self.note(at(value, Asked::Negative), divisor < 0.0);
                if !matches!(divisor.partial_cmp(&0.0), Some(std::cmp::Ordering::Less)) {
                    self.note(at(value, Asked::Positive), divisor > 0.0);
                }
                self.apply(Op::Quotient, a, b)
            }
            Expr::Pow(a, b) => self.apply(Op::Pow, a, b),
            Expr::Call(function, a) => {
                let result = apply(&Op::Call(*function, Value(0)), &[self.real(a)], self.precision);
                result.unwrap_or(f64::NAN)
            }
            Expr::Callback(name, array, time) => {
                let Some((_, called)) = self.callbacks.iter().find(|(known, _)| known == name)
                else {
                    fault(format!("no function {name}"))
                };
                match self.locals.get(array.as_str()) {
                    Some(Held::Reals(values)) => round(called(values, self.real(time))),
                    _ => fault(format!("{array} is no array")),
                }
            }
            Expr::Real(a) => round(f64::from(self.count(a))),
            Expr::Choose(test, a, b) => self.real(if self.test(test) { a } else { b }),
            Expr::Count(_) | Expr::CountSub(..) | Expr::CountLeft(..) | Expr::CountHalf(_) => {
                f64::from(self.count(value))
            }
            Expr::OfAxis(field, stride, index) => {
                let axis = self.count(&Expr::local(AXIS)) as usize;
                match self.fields.get(field.as_str()) {
                    Some(Held::Reals(values)) => {
                        values.get(stride * axis + index).copied().unwrap_or(f64::NAN)
                    }
                    _ => fault(format!("{field} is no array")),
                }
            }
            name => match self.held(name) {
                (Held::Real(value), _) => *value,
                (Held::Reals(values), index) => values.get(index).copied().unwrap_or(f64::NAN),
                (Held::Count(count), _) => f64::from(*count),
            },
        }
    }

    fn apply(&self, op: fn(Value, Value) -> Op, a: &Expr, b: &Expr) -> f64 {
        let operands = [self.real(a), self.real(b)];
        apply(&op(Value(0), Value(1)), &operands, self.precision).unwrap_or(f64::NAN)
    }

    fn count(&self, value: &Expr) -> u32 {
        match value {
            Expr::Count(count) => *count,
            Expr::CountSub(a, b) => self.count(a).wrapping_sub(self.count(b)),
            Expr::CountLeft(a, b) => {
                let (a, b) = (self.count(a), self.count(b));
                self.note(at(value, Asked::Left), b < a);
                a.saturating_sub(b)
            }
            Expr::CountHalf(a) => self.count(a) / 2,
            name => match self.held(name) {
                (Held::Count(count), _) => *count,
                _ => fault("a number is used as a count".to_owned()),
            },
        }
    }

    fn held(&self, name: &Expr) -> (&Held, usize) {
        let (found, index) = match name {
            Expr::Local(name) => (self.locals.get(name.as_str()), 0),
            Expr::Element(name, index) => (self.locals.get(name.as_str()), *index),
            Expr::Entry(name, Cell { row, column, columns }) => {
                (self.locals.get(name.as_str()), row * columns + column)
            }
            Expr::Field(name) => (self.fields.get(name.as_str()), 0),
            Expr::FieldElement(name, index) => (self.fields.get(name.as_str()), *index),
            Expr::Parameter(name) => (self.parameters.get(name.as_str()), 0),
            Expr::ParameterElement(name, index) => (self.parameters.get(name.as_str()), *index),
            _ => (None, 0),
        };
        match found {
            Some(held) => (held, index),
            None => fault(format!("{name:?} is not known")),
        }
    }

    pub(super) fn test(&self, test: &Test) -> bool {
        self.test_at(test, at(test, Asked::Test))
    }

    /// The same of a test that is known by another place in the program than its own.
    pub(super) fn test_at(&self, test: &Test, place: At) -> bool {
        let holds = match test {
            Test::Less(a, b) => self.real(a) < self.real(b),
            Test::AtMost(a, b) => self.real(a) <= self.real(b),
            Test::CountLess(a, b) => self.count(a) < self.count(b),
            Test::CountEqual(a, b) => self.count(a) == self.count(b),
            Test::Finite(a) => self.real(a).is_finite(),
            Test::NotNumber(a) => self.real(a).is_nan(),
            Test::All(tests) => return tests.iter().all(|test| self.test(test)),
        };
        self.note(place, holds);
        holds
    }

    pub(super) fn note(&self, place: At, holds: bool) {
        if let Some(taken) = &self.taken {
            taken.borrow_mut().insert(place, holds);
        }
    }
}
