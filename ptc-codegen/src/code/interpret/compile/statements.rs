//! Steps of statements.

use std::collections::BTreeMap;

use super::Writer;
use crate::code::branch::{Asked, at};
use crate::code::interpret::tape::{Callback, Counting, Question, Slots, Step};
use crate::code::{Expr, For, Index, Place, Standing, Statement, Subroutine, Whose};

impl<'c> Writer<'c> {
    pub(super) fn block(&mut self, statements: &'c [Statement]) {
        statements.iter().for_each(|statement| self.statement(statement));
    }

    fn statement(&mut self, statement: &'c Statement) {
        match statement {
            Statement::Let(name, _, value) | Statement::Begin(name, _, value) => {
                let to = self.define(name, 1).first;
                self.expression(value, to);
            }
            Statement::Variable(name, shape) => {
                self.define(name, shape.length().unwrap_or(1));
            }
            Statement::Set(place, value) => self.set(place, value),
            Statement::Settle(whose, standing) => self.settle(whose, standing),
            Statement::If(test, yes, no) => {
                let otherwise = self.unless(test);
                self.block(yes);
                let behind = self.go();
                self.land(&otherwise);
                self.block(no);
                self.land(&[behind]);
            }
            Statement::For(each) => self.each(each),
            Statement::Leave => {
                let step = self.go();
                self.leaving.push(step);
            }
            Statement::Require(test, status) => {
                let failing = self.unless(test);
                self.failing.extend(failing.into_iter().map(|step| (step, *status)));
            }
            Statement::Array(name, values) => {
                let array = self.list(values);
                self.locals.insert(name, array);
            }
            Statement::View { name, array, .. } => {
                let Slots { first: from, count } = self.local(array);
                let to = self.define(name, count).first;
                self.steps.push(Step::Copy { from, to, count });
            }
            Statement::Apply { name, subroutine, body, given } => {
                let array = self.applied((*subroutine, body), given);
                if let (Subroutine::Elimination(_), true) = (subroutine, self.watched) {
                    self.steps.push(Step::Regular(at(statement, Asked::Regular)));
                }
                self.locals.insert(name, array);
            }
            Statement::Call { name, callback, array, times, count } => {
                let array = self.local(array);
                let [time, rate] = times.each_ref().map(|time| self.slot(time));
                let to = self.define(name, *count);
                let call = Callback { name: callback, array, time, rate: Some(rate), to };
                self.steps.push(Step::Callback(Box::new(call)));
            }
            Statement::Root(..) | Statement::Note(_) => {}
        }
    }

    fn set(&mut self, place: &'c Place, value: &'c Expr) {
        let (array, index) = match place {
            Place::Local(name) => return self.expression(value, self.local(name).first),
            Place::Field(name) => return self.expression(value, self.field(name).first),
            Place::Element(name, index) => (self.local(name), index),
            Place::Input(index) => (self.results(0), index),
        };
        if let Some(index) = index.known() {
            return self.expression(value, array.element(index));
        }
        let from = self.slot(value);
        self.store(from, array, index);
    }

    fn settle(&mut self, whose: &Whose, standing: &Standing) {
        let from = match standing {
            Standing::Known(status) => self.constant(f64::from(status.number())),
            Standing::Of(other) => self.status(other),
        };
        match whose {
            Whose::Call => self.copy(from, self.settled),
            Whose::Input(index) => self.store(from, self.results(1), index),
        }
    }

    fn store(&mut self, from: usize, array: Slots, index: &Index) {
        let address = Box::new(self.address(array, index));
        self.steps.push(Step::Store(from, address));
    }

    fn each(&mut self, each: &'c For) {
        let nothing = Slots { first: 0, count: 0 };
        let [from, to] = [&each.from, &each.to].map(|end| self.address(nothing, end));
        let index = self.define(&each.index, 1).first;
        let [last, step] = [self.fresh(1).first, self.constant(f64::from(each.step))];
        let (first, end, step) = match each.down {
            false => (from, to, step),
            true => (to, from, self.constant(-1.0)),
        };
        self.steps.push(Step::Place(Box::new(first), index));
        self.steps.push(Step::Place(Box::new(end), last));
        let onward = || Step::Count(Counting::Add(index, step), index);
        if each.down {
            self.steps.push(onward());
        }
        let again = self.steps.len();
        let goes_on = match each.down {
            false => Question::Less(index, last),
            true => Question::AtMost(last, index),
        };
        let ends = self.ask(goes_on, None);
        let outer = std::mem::replace(&mut self.leaving, vec![ends]);
        self.block(&each.body);
        self.steps.push(onward());
        self.steps.push(Step::Go(again));
        let leaving = std::mem::replace(&mut self.leaving, outer);
        self.land(&leaving);
    }

    /// The array that a subroutine gives, which knows no other names than its own.
    fn applied(
        &mut self,
        (subroutine, body): (Subroutine, &'c [Statement]),
        given: &'c [Vec<Expr>; 2],
    ) -> Slots {
        let arrays = given.each_ref().map(|values| self.list(values));
        let own: BTreeMap<_, _> =
            subroutine.given().into_iter().map(|own| own.name).zip(arrays).collect();
        let outer = std::mem::replace(&mut self.locals, own);
        self.block(body);
        self.locals = outer;
        arrays[0]
    }

    /// A new array of values.
    fn list(&mut self, values: &'c [Expr]) -> Slots {
        let array = self.fresh(values.len());
        for (to, value) in array.range().zip(values) {
            self.expression(value, to);
        }
        array
    }
}
