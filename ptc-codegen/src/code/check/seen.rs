//! Scope of statements: the names they may use, and the effects they may have.

use std::collections::BTreeSet;

use crate::code::{
    AXIS, Cell, Ending, Expr, Finish, For, Index, Owner, Place, Standing, Statement, Test, Whose,
};
use crate::collect::set;

/// Names and effects of the statements of one function so far.
#[derive(Default)]
pub(super) struct Seen<'a> {
    pub(super) fields: BTreeSet<&'a str>,
    pub(super) parameters: BTreeSet<&'a str>,
    pub(super) callbacks: BTreeSet<&'static str>,
    pub(super) locals: BTreeSet<String>,
    /// True if the fields are those of the gains, which a language may name without their owner.
    pub(super) of_gains: bool,
    pub(super) may_change: bool,
    pub(super) changed: bool,
    /// True if the call may have a status by which it fails.
    pub(super) failed: bool,
    /// In how many loops it is.
    pub(super) loops: usize,
}

impl Seen<'_> {
    pub(super) fn block(&mut self, statements: &[Statement]) -> Result<(), String> {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), String> {
        match statement {
            Statement::Let(name, _, value) | Statement::Begin(name, _, value) => {
                self.expression(value)?;
                self.define(name)
            }
            Statement::Variable(name, _) => self.define(name),
            Statement::View { name, array, first } => {
                self.is_declared(array)?;
                if *first { self.define(name) } else { self.is_declared(name) }
            }
            Statement::Set(Place::Local(name), value) => {
                self.expression(value)?;
                self.is_declared(name)
            }
            Statement::Set(Place::Element(name, index), value) => {
                self.expression(value)?;
                self.index(index)?;
                self.is_declared(name)
            }
            Statement::Set(Place::Input(index), value) => {
                self.expression(value)?;
                self.index(index)
            }
            Statement::Settle(whose, standing) => {
                self.status(whose)?;
                let fails = match standing {
                    Standing::Of(other) => {
                        self.status(other)?;
                        true
                    }
                    Standing::Known(status) => status.number() < 0,
                };
                if !fails || *whose != Whose::Call {
                    return Ok(());
                }
                self.failed = true;
                self.may_fail()
            }
            Statement::Root(name, tolerance) => {
                self.expression(tolerance)?;
                self.is_declared(name)
            }
            Statement::For(each) => self.each(each),
            Statement::Set(Place::Field(name), value) => {
                self.expression(value)?;
                if !self.may_change || !self.fields.contains(name.as_str()) {
                    return Err(format!("the field {name} cannot be set here"));
                }
                self.changed = true;
                match self.failed {
                    true => Err(format!("the field {name} is set in a call that may have failed")),
                    false => Ok(()),
                }
            }
            Statement::If(test, then, otherwise) => {
                self.test(test)?;
                let outer = self.locals.clone();
                let before = [self.changed, self.failed];
                self.block(then)?;
                self.locals.clone_from(&outer);
                let then = [self.changed, self.failed];
                [self.changed, self.failed] = before;
                self.block(otherwise)?;
                self.changed |= then[0];
                self.failed |= then[1];
                self.locals = outer;
                Ok(())
            }
            Statement::Require(test, _) => {
                self.test(test)?;
                match self.loops {
                    0 => self.may_fail(),
                    _ => Err("a call fails within a loop".to_owned()),
                }
            }
            Statement::Array(name, values) => {
                values.iter().try_for_each(|value| self.expression(value))?;
                self.define(name)
            }
            Statement::Apply { name, subroutine, body, given } => {
                given.iter().flatten().try_for_each(|value| self.expression(value))?;
                let lengths = subroutine.given().map(|own| own.length);
                if given.each_ref().map(Vec::len) != lengths || lengths.contains(&0) {
                    return Err(format!("{name} has no arrays of the right length"));
                }
                // It knows its two arrays alone.
                let own = subroutine.given().map(|own| own.name.to_owned());
                Seen { locals: set(own), ..Seen::default() }.block(body)?;
                self.define(name)
            }
            Statement::Call { name, callback, array, times, .. } => {
                times.iter().try_for_each(|value| self.expression(value))?;
                if !self.callbacks.contains(callback) || !self.locals.contains(array) {
                    return Err(format!("{callback} is called before it is known"));
                }
                self.define(name)
            }
            Statement::Leave => match self.loops {
                0 => Err("a loop is left outside of any".to_owned()),
                _ => Ok(()),
            },
            Statement::Note(_) => Ok(()),
        }
    }

    fn each(&mut self, each: &For) -> Result<(), String> {
        self.index(&each.from)?;
        self.index(&each.to)?;
        if each.step == 0 || (each.down && each.step != 1) {
            return Err(format!("the loop over {} does not end", each.index));
        }
        let outer = self.locals.clone();
        self.define(&each.index)?;
        self.loops += 1;
        self.block(&each.body)?;
        self.loops -= 1;
        self.locals = outer;
        Ok(())
    }

    fn index(&self, index: &Index) -> Result<(), String> {
        index.terms.iter().try_for_each(|(_, name)| self.is_declared(name))
    }

    fn status(&self, of: &Whose) -> Result<(), String> {
        match of {
            Whose::Input(index) => self.index(index),
            Whose::Call => Ok(()),
        }
    }

    fn is_declared(&self, name: &str) -> Result<(), String> {
        match self.locals.contains(name) {
            true => Ok(()),
            false => Err(format!("{name} is used before it is declared")),
        }
    }

    pub(super) fn finish(
        &self,
        finish: &Finish,
        elements: usize,
        owner: Owner,
    ) -> Result<(), String> {
        match finish {
            Finish::If(test, yes, no) => {
                self.test(test)?;
                self.finish(yes, elements, owner)?;
                self.finish(no, elements, owner)
            }
            Finish::Give(values, ending) => {
                if values.len() != elements {
                    return Err("a result is not given whole".to_owned());
                }
                if *ending == Ending::OfGains && owner == Owner::Controller {
                    return Err("the controller has no status".to_owned());
                }
                values.iter().try_for_each(|value| self.expression(value))
            }
            Finish::Fail(_) => self.may_fail(),
            Finish::Stands => Err("several inputs are the whole of a function".to_owned()),
        }
    }

    pub(super) fn may_fail(&self) -> Result<(), String> {
        match self.changed {
            true => Err("a call can fail after it has changed a field".to_owned()),
            false => Ok(()),
        }
    }

    pub(super) fn define(&mut self, name: &str) -> Result<(), String> {
        if self.of_gains && self.fields.contains(name) {
            return Err(format!("{name} is a field of the gains and a local"));
        }
        match self.locals.insert(name.to_owned()) {
            true => Ok(()),
            false => Err(format!("{name} is declared twice")),
        }
    }

    pub(super) fn test(&self, test: &Test) -> Result<(), String> {
        let mut found = Ok(());
        test.visit(&mut |e| found = std::mem::replace(&mut found, Ok(())).and(self.known(e)));
        found
    }

    pub(super) fn expression(&self, value: &Expr) -> Result<(), String> {
        let mut found = Ok(());
        value.visit(&mut |e| found = std::mem::replace(&mut found, Ok(())).and(self.known(e)));
        found
    }

    fn known(&self, value: &Expr) -> Result<(), String> {
        let (known, name) = match value {
            Expr::Local(name) | Expr::Element(name, _) => (self.locals.contains(name), name),
            Expr::At(name, index) | Expr::Entry(name, Cell { row: index, .. }) => {
                self.index(index)?;
                (self.locals.contains(name), name)
            }
            Expr::Field(name) | Expr::FieldElement(name, _) => {
                (self.fields.contains(name.as_str()), name)
            }
            Expr::OfAxis(name, ..) => {
                (self.fields.contains(name.as_str()) && self.locals.contains(AXIS), name)
            }
            Expr::Parameter(name) | Expr::ParameterElement(name, _) => {
                (self.parameters.contains(name.as_str()), name)
            }
            Expr::Callback(callback, array, _) => {
                let known = self.callbacks.contains(callback) && self.locals.contains(array);
                (known, array)
            }
            _ => return Ok(()),
        };
        if known { Ok(()) } else { Err(format!("{name} is used before it is known")) }
    }
}
