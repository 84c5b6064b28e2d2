//! Steps of expressions and tests.

use super::Writer;
use crate::code::branch::{Asked, At, at};
use crate::code::interpret::tape::{Address, Callback, Counting, Question, Slots, Step};
use crate::code::{AXIS, Cell, Expr, Index, Operator, Test, Whose};
use crate::internal::fault;
use crate::program::{Arithmetic, number};

impl<'c> Writer<'c> {
    /// The slot of an expression: that of a name or a constant, or a new one.
    pub(super) fn slot(&mut self, value: &'c Expr) -> usize {
        self.known(value).unwrap_or_else(|| {
            let to = self.fresh(1).first;
            self.expression(value, to);
            to
        })
    }

    /// The slot of a name or a constant.
    fn known(&mut self, value: &'c Expr) -> Option<usize> {
        let (slots, index) = match value {
            Expr::Number(value) => {
                return Some(self.constant(number::round(value, self.code.precision)));
            }
            Expr::Constant(own) => {
                return Some(self.constant(own.rounded(self.code.precision)));
            }
            Expr::Count(count) => return Some(self.constant(f64::from(*count))),
            Expr::Local(name) => (self.local(name), 0),
            Expr::Element(name, index) => (self.local(name), *index),
            Expr::Field(name) => (self.field(name), 0),
            Expr::FieldElement(name, index) => (self.field(name), *index),
            Expr::Parameter(name) => (self.parameter(name), 0),
            Expr::ParameterElement(name, index) => (self.parameter(name), *index),
            Expr::At(name, index) => (self.local(name), index.known()?),
            Expr::Entry(name, Cell { row, column, columns }) => {
                (self.local(name), row.known()? * columns + column)
            }
            _ => return None,
        };
        Some(slots.element(index))
    }

    pub(super) fn field(&self, name: &str) -> Slots {
        let known = self.fields.get(name);
        *known.unwrap_or_else(|| fault(format!("no field {name}")))
    }

    fn parameter(&self, name: &str) -> Slots {
        let known = self.parameters.get(name);
        *known.unwrap_or_else(|| fault(format!("no parameter {name}")))
    }

    /// Writes the value of an expression to a slot.
    pub(super) fn expression(&mut self, value: &'c Expr, to: usize) {
        if let Some(slot) = self.known(value) {
            return self.steps.push(Step::Compute(Arithmetic::Copy(slot), to));
        }
        let step = match value {
            Expr::Binary(..)
            | Expr::Neg(_)
            | Expr::Fused(_)
            | Expr::Quotient(..)
            | Expr::Pow(..)
            | Expr::Call(..) => Step::Compute(self.operation(value), to),
            Expr::Divisor(a) => Step::Divisor(self.slot(a), to),
            Expr::Real(count) => Step::Round(self.slot(count), to),
            Expr::CountSub(a, b) => Step::Count(Counting::Sub(self.slot(a), self.slot(b)), to),
            Expr::CountLeft(a, b) => self.left(value, [a, b], to),
            Expr::CountOver(a, by) => Step::Count(Counting::Over(self.slot(a), *by), to),
            Expr::CountAdd(a, b) => Step::Count(Counting::Add(self.slot(a), self.slot(b)), to),
            Expr::Tabulated(name, row, column) => {
                let address = self.cell(name, row, *column);
                Step::Load(Box::new(address), to)
            }
            Expr::At(name, index) => {
                let address = self.address(self.local(name), index);
                Step::Load(Box::new(address), to)
            }
            Expr::Entry(name, Cell { row, column, columns }) => {
                let columns = i32::try_from(*columns).unwrap_or(i32::MAX);
                let index = row.clone() * columns + Index::at(*column);
                Step::Load(Box::new(self.address(self.local(name), &index)), to)
            }
            Expr::OfAxis(name, stride, index) => {
                let stride = i32::try_from(*stride).unwrap_or(i32::MAX);
                let index = Index::of(AXIS) * stride + Index::at(*index);
                Step::Load(Box::new(self.address(self.field(name), &index)), to)
            }
            Expr::Callback(name, array, time) => {
                let (array, time) = (self.local(array), self.slot(time));
                let to = Slots { first: to, count: 1 };
                Step::Callback(Box::new(Callback { name, array, time, rate: None, to }))
            }
            Expr::Choose(test, a, b) => return self.choice(test, [a, b], to),
            other => fault(format!("{other:?} has no slot")),
        };
        self.steps.push(step);
    }

    fn operation(&mut self, value: &'c Expr) -> Arithmetic {
        match value {
            Expr::Neg(a) => Arithmetic::Neg(self.slot(a)),
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                match operator {
                    Operator::Add => Arithmetic::Add(a, b),
                    Operator::Sub => Arithmetic::Sub(a, b),
                    Operator::Mul => Arithmetic::Mul(a, b),
                    Operator::Div => Arithmetic::Div(a, b),
                }
            }
            Expr::Fused(operands) => {
                let [a, b, c] = operands.each_ref().map(|operand| self.slot(operand));
                Arithmetic::Fused(a, b, c)
            }
            Expr::Quotient(a, b) => {
                let (divisor, dividend) = (self.slot(b), self.slot(a));
                self.note_sign(value, divisor);
                Arithmetic::Quotient(dividend, divisor)
            }
            Expr::Pow(a, b) => Arithmetic::Pow(self.slot(a), self.slot(b)),
            Expr::Call(function, a) => Arithmetic::Call(*function, self.slot(a)),
            other => fault(format!("{other:?} is no operation")),
        }
    }

    /// Records the sign of a divisor.
    fn note_sign(&mut self, quotient: &Expr, divisor: usize) {
        if !self.watched {
            return;
        }
        let zero = self.constant(0.0);
        let negative = self.ask(Question::Less(divisor, zero), Some(at(quotient, Asked::Negative)));
        let behind = self.go();
        self.land(&[negative]);
        let place = at(quotient, Asked::Positive);
        self.steps.push(Step::Note(Question::Less(zero, divisor), place));
        self.land(&[behind]);
    }

    /// Writes the rest of a count.
    fn left(&mut self, value: &Expr, [a, b]: [&'c Expr; 2], to: usize) -> Step {
        let (a, b) = (self.slot(a), self.slot(b));
        if self.watched {
            self.steps.push(Step::Note(Question::Less(b, a), at(value, Asked::Left)));
        }
        Step::Count(Counting::Left(a, b), to)
    }

    fn choice(&mut self, test: &'c Test, [yes, no]: [&'c Expr; 2], to: usize) {
        if let (Test::Less(a, b), false) = (test, self.watched) {
            let lesser = (a, b) == (yes, no);
            if lesser || (a, b) == (no, yes) {
                let (a, b) = (self.slot(a), self.slot(b));
                let operation = if lesser { Arithmetic::Min(a, b) } else { Arithmetic::Max(a, b) };
                return self.steps.push(Step::Compute(operation, to));
            }
        }
        let otherwise = self.unless(test);
        self.expression(yes, to);
        let behind = self.go();
        self.land(&otherwise);
        self.expression(no, to);
        self.land(&[behind]);
    }

    /// Writes a test; the steps that go on elsewhere where it does not hold.
    pub(super) fn unless(&mut self, test: &'c Test) -> Vec<usize> {
        let question = match test {
            Test::All(tests) => return tests.iter().flat_map(|test| self.unless(test)).collect(),
            Test::Less(a, b) | Test::CountLess(a, b) => Question::Less(self.slot(a), self.slot(b)),
            Test::AtMost(a, b) => Question::AtMost(self.slot(a), self.slot(b)),
            Test::CountEqual(a, b) => Question::Equal(self.slot(a), self.slot(b)),
            Test::Finite(a) => Question::Finite(self.slot(a)),
            Test::NotNumber(a) => Question::NotNumber(self.slot(a)),
            Test::Stands(whose) => Question::AtMost(self.constant(0.0), self.status(whose)),
            Test::Fails(whose) => Question::Less(self.status(whose), self.constant(0.0)),
        };
        vec![self.ask(question, Some(at(test, Asked::Test)))]
    }

    /// A step that goes on elsewhere where the answer is no, and records it, if it decides a branch.
    pub(super) fn ask(&mut self, question: Question, place: Option<At>) -> usize {
        let place = place.filter(|_| self.watched);
        self.steps.extend(place.map(|place| Step::Note(question, place)));
        self.steps.push(Step::Unless(question, 0));
        self.steps.len() - 1
    }

    /// The slot of a status that statements have settled.
    pub(super) fn status(&mut self, whose: &Whose) -> usize {
        match whose {
            Whose::Call => self.settled,
            Whose::Input(index) => {
                let address = Box::new(self.address(self.results(1), index));
                let to = self.fresh(1).first;
                self.steps.push(Step::Load(address, to));
                to
            }
        }
    }

    /// The place of an element of a table.
    fn cell(&mut self, name: &str, row: &'c Expr, column: usize) -> Address {
        let row = self.slot(row);
        let (columns, array) = match (self.code.table(name), self.tables.get(name)) {
            (Some(table), Some(slots)) => (table.columns(), *slots),
            _ => fault(format!("no table {name}")),
        };
        let real = |index: usize| f64::from(u32::try_from(index).unwrap_or(u32::MAX));
        Address { array, constant: real(column), terms: vec![(real(columns), row)] }
    }

    /// The place of an element.
    pub(super) fn address(&self, array: Slots, index: &Index) -> Address {
        let term = |(factor, name): &(i32, String)| (f64::from(*factor), self.local(name).first);
        let terms = index.terms.iter().map(term).collect();
        Address { array, constant: f64::from(index.constant), terms }
    }
}
