//! Values and tests of one call.

use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use super::{Called, Held, Outcome};
use crate::code::branch::{Asked, At, Taken, at};
use crate::code::{
    AXIS, Cell as Entry, Ending, Expr, Finish, Function, Index, Operator, Shape, Status, Test,
    Variable, Whose,
};
use crate::collect::map;
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::{Op, Value, apply, number};

/// The names that one call knows.
pub(super) struct Frame<'a, 'b> {
    pub(super) precision: Precision,
    pub(super) fields: &'b mut BTreeMap<&'a str, Held>,
    pub(super) parameters: BTreeMap<&'b str, Held>,
    pub(super) locals: BTreeMap<Cow<'b, str>, Held>,
    pub(super) callbacks: &'b [Called<'b>],
    /// Results of the statements for each input so far: its u and its status, and the status of the call.
    pub(super) settled: Settled,
    /// True if a divisor of a subroutine was 0.
    pub(super) divided_by_zero: Cell<bool>,
    /// The branches taken so far, where they are recorded.
    pub(super) taken: Option<RefCell<Taken>>,
}

/// Results of the statements for several inputs.
#[derive(Default)]
pub(super) struct Settled {
    pub(super) u: BTreeMap<usize, f64>,
    pub(super) each: BTreeMap<usize, Status>,
    pub(super) call: Option<Status>,
}

impl<'b> Frame<'_, 'b> {
    /// Returns the results of the statements for several inputs; without u if the call has `ended`.
    fn stands(&mut self, function: &Function, ended: Option<Status>) -> Outcome {
        let settled = std::mem::take(&mut self.settled);
        let count = function.results.first().and_then(|result| result.shape.length());
        let status = ended.or(settled.call).unwrap_or_else(|| fault("a call without a status"));
        let number = |status: Status| f64::from(status.number());
        let each = |index| match ended {
            Some(status) => (0.0, number(status)),
            None => (settled.u[&index], number(settled.each[&index])),
        };
        let (u, each): (Vec<_>, Vec<_>) = (0..count.unwrap_or_default()).map(each).unzip();
        let names = function.results.iter().map(|result| result.name.clone());
        Outcome { status, results: map(names.zip([u, each])) }
    }

    /// Runs a function whose gains, if it belongs to any, have the status `standing`.
    pub(super) fn run(
        &mut self,
        function: &'b Function,
        standing: Status,
        gains: &[Variable],
    ) -> Outcome {
        let failed = |status| Outcome { status, results: BTreeMap::new() };
        let ended = self.fails(&function.body);
        if function.finish == Finish::Stands {
            return self.stands(function, ended);
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
                Finish::Stands => fault("several inputs are given together"),
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

    pub(super) fn value(&self, value: &Expr, shape: Shape) -> Held {
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
            Expr::Divisor(a) => {
                let divisor = self.real(a);
                self.divided_by_zero.set(self.divided_by_zero.get() || divisor == 0.0);
                if divisor == 0.0 { f64::NAN } else { divisor }
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
            Expr::At(name, index) => match self.locals.get(name.as_str()) {
                Some(Held::Reals(values)) => values[self.place(index)],
                _ => fault(format!("{name} is no array")),
            },
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

    /// The number of a place, by the indices of the loops that run.
    pub(super) fn place(&self, index: &Index) -> usize {
        let found = index.place(|name| self.count(&Expr::local(name)));
        found.unwrap_or_else(|| fault(format!("{index:?} is no place")))
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
            Expr::Entry(name, Entry { row, column, columns }) => {
                (self.locals.get(name.as_str()), self.place(row) * columns + column)
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
        let holds = match test {
            Test::Less(a, b) => self.real(a) < self.real(b),
            Test::AtMost(a, b) => self.real(a) <= self.real(b),
            Test::CountLess(a, b) => self.count(a) < self.count(b),
            Test::CountEqual(a, b) => self.count(a) == self.count(b),
            Test::Finite(a) => self.real(a).is_finite(),
            Test::NotNumber(a) => self.real(a).is_nan(),
            Test::Stands(whose) => self.status(whose).number() >= 0,
            Test::Fails(whose) => self.status(whose).number() < 0,
            Test::All(tests) => return tests.iter().all(|test| self.test(test)),
        };
        self.note(at(test, Asked::Test), holds);
        holds
    }

    /// A status that statements have settled.
    pub(super) fn status(&self, of: &Whose) -> Status {
        let found = match of {
            Whose::Call => self.settled.call,
            Whose::Input(index) => self.settled.each.get(&self.place(index)).copied(),
        };
        found.unwrap_or_else(|| fault(format!("{of:?} has no status yet")))
    }

    pub(super) fn note(&self, place: At, holds: bool) {
        if let Some(taken) = &self.taken {
            taken.borrow_mut().insert(place, holds);
        }
    }
}
