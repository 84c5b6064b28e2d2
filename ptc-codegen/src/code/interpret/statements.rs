//! Statements of one call.

use std::borrow::Cow;

use super::Held;
use super::frame::Frame;
use crate::code::branch::{Asked, at};
use crate::code::{Expr, For, Place, Shape, Standing, Statement, Status, Subroutine, Whose};
use crate::collect::map;
use crate::internal::fault;
use crate::program::number;

/// Why statements end before the last one.
enum Ended {
    /// They have left the loop that they are in.
    Loop,
    /// The call fails.
    Call(Status),
}

impl<'b> Frame<'_, 'b> {
    /// Runs statements; the status where one of them fails.
    pub(super) fn fails(&mut self, statements: &'b [Statement]) -> Option<Status> {
        match self.block(statements)? {
            Ended::Call(status) => Some(status),
            Ended::Loop => fault("a loop is left outside of any"),
        }
    }

    fn block(&mut self, statements: &'b [Statement]) -> Option<Ended> {
        statements.iter().find_map(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &'b Statement) -> Option<Ended> {
        match statement {
            Statement::Let(name, shape, value) | Statement::Begin(name, shape, value) => {
                self.define(name, self.value(value, *shape));
            }
            Statement::Set(Place::Local(name), value) => {
                let shape = match self.locals.get(name.as_str()) {
                    Some(Held::Count(_)) => Shape::Count,
                    _ => Shape::Real,
                };
                self.define(name, self.value(value, shape));
            }
            Statement::Set(Place::Element(name, index), value) => {
                let (place, value) = (self.place(index), self.real(value));
                match self.locals.get_mut(name.as_str()) {
                    Some(Held::Reals(values)) => values[place] = value,
                    _ => fault(format!("{name} is no array")),
                }
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
            Statement::Set(Place::Input(index), value) => {
                let (place, value) = (self.place(index), self.real(value));
                self.settled.u.insert(place, value);
            }
            Statement::Settle(whose, standing) => {
                let status = match standing {
                    Standing::Known(status) => *status,
                    Standing::Of(other) => self.status(other),
                };
                match whose {
                    Whose::Call => self.settled.call = Some(status),
                    Whose::Input(index) => {
                        let place = self.place(index);
                        self.settled.each.insert(place, status);
                    }
                }
            }
            Statement::If(test, then, otherwise) => {
                let block = if self.test(test) { then } else { otherwise };
                return self.block(block);
            }
            Statement::For(each) => return self.each(each),
            Statement::Leave => return Some(Ended::Loop),
            Statement::Require(test, status) if !self.test(test) => {
                return Some(Ended::Call(*status));
            }
            Statement::Variable(name, Shape::Reals(length)) => {
                self.define(name, Held::Reals(vec![f64::NAN; *length]));
            }
            // Its shape decides how what it is set to is read.
            Statement::Variable(name, Shape::Count) => self.define(name, Held::Count(0)),
            Statement::Array(name, values) => self.define(name, Held::Reals(self.list(values))),
            Statement::View { name, array, .. } => match self.locals.get(array.as_str()).cloned() {
                Some(values) => self.define(name, values),
                None => fault(format!("{array} is not known")),
            },
            Statement::Apply { name, subroutine, body, given } => {
                let values = self.applied((*subroutine, body), given);
                if let Subroutine::Elimination(_) = subroutine {
                    let singular = self.divided_by_zero.take();
                    self.note(at(statement, Asked::Regular), !singular);
                }
                self.define(name, values);
            }
            Statement::Call { name, callback, array, times, count } => {
                let values = self.call(callback, array, times, *count);
                self.define(name, Held::Reals(values));
            }
            Statement::Require(..)
            | Statement::Root(..)
            | Statement::Variable(..)
            | Statement::Note(_) => {}
        }
        None
    }

    fn each(&mut self, each: &'b For) -> Option<Ended> {
        let count = |place: usize| u32::try_from(place).unwrap_or(u32::MAX);
        let (from, to) = (self.place(&each.from), self.place(&each.to));
        let step = usize::try_from(each.step).unwrap_or(usize::MAX);
        let mut indices: Vec<_> = (from..to).step_by(step).map(count).collect();
        if each.down {
            indices.reverse();
        }
        for index in indices {
            self.define(&each.index, Held::Count(index));
            match self.block(&each.body) {
                None => {}
                Some(Ended::Loop) => break,
                failed => return failed,
            }
        }
        None
    }

    /// The array that a subroutine gives, which knows no other names than its own.
    fn applied(
        &mut self,
        (subroutine, body): (Subroutine, &'b [Statement]),
        given: &[Vec<Expr>; 2],
    ) -> Held {
        let [gives, _] = subroutine.given();
        let arrays = subroutine.given().into_iter().zip(given);
        let own = arrays.map(|(own, values)| (Cow::from(own.name), Held::Reals(self.list(values))));
        let own = map(own);
        let outer = std::mem::replace(&mut self.locals, own);
        self.block(body);
        let mut inner = std::mem::replace(&mut self.locals, outer);
        inner.remove(gives.name).unwrap_or_else(|| fault("a subroutine without its array"))
    }

    /// Returns the results of a function of several values, requested one at a time.
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

    fn list(&self, values: &[Expr]) -> Vec<f64> {
        values.iter().map(|value| self.real(value)).collect()
    }

    fn define(&mut self, name: &'b str, value: Held) {
        self.locals.insert(Cow::from(name), value);
    }
}
