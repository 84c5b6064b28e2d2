//! The invariants of a program: names are declared before their uses, and a call that fails has changed
//! nothing.

use std::collections::BTreeSet;

use num_traits::Zero;

use super::{
    AXIS, Access, Axes, Code, Ending, Expr, Finish, Function, Owner, Place, Shape, Solve,
    Statement, Variable,
};
use crate::algebra::BigRational;
use crate::collect::set;
use crate::program::number;

/// What the statements of one function have seen so far.
struct Seen<'a> {
    fields: BTreeSet<&'a str>,
    parameters: BTreeSet<&'a str>,
    callbacks: BTreeSet<&'static str>,
    locals: BTreeSet<String>,
    /// Whether the fields are those of the gains, which a language may name without their owner.
    of_gains: bool,
    may_change: bool,
    changed: bool,
}

impl Code {
    /// Checks the invariants of the module's doc.
    ///
    /// # Errors
    /// The first one that does not hold.
    pub fn check(&self) -> Result<(), String> {
        for list in [&self.fields, &self.parameters, &self.gains] {
            if names(list).len() != list.len() {
                return Err("a name is given twice".to_owned());
            }
        }
        let mut seen = Seen {
            fields: names(&self.fields),
            parameters: names(&self.parameters),
            callbacks: BTreeSet::new(),
            locals: BTreeSet::new(),
            of_gains: false,
            may_change: true,
            changed: false,
        };
        seen.block(&self.init)?;
        if let Some(start) = &self.start {
            seen.expression(&start.time)?;
        }
        self.functions.iter().try_for_each(|function| {
            let seen = self.seen_by(function);
            seen.map_err(|error| format!("{}: {error}", function.name))
        })
    }

    fn seen_by(&self, function: &Function) -> Result<(), String> {
        let fields = match function.owner {
            Owner::Controller => &self.fields,
            Owner::Gains => &self.gains,
        };
        let mut seen = Seen {
            fields: names(fields),
            parameters: BTreeSet::new(),
            callbacks: function.callbacks.iter().map(|callback| callback.name).collect(),
            locals: function.arguments.iter().map(|a| a.name.clone()).collect(),
            of_gains: function.owner == Owner::Gains,
            may_change: function.access == Access::Change,
            changed: false,
        };
        seen.block(&function.body)?;
        let elements = |of: &Variable| of.shape.length().unwrap_or(1);
        let given = function.results.iter().map(|result| match result.shape {
            Shape::Gains => self.gains.iter().map(elements).sum(),
            _ => elements(result),
        });
        match &function.finish {
            Finish::Axes(axes) => return self.gives_axes(function, axes),
            Finish::Inputs(inputs) => {
                let m = inputs.values.len();
                let gives: Vec<_> = function.results.iter().map(|result| result.shape).collect();
                let fits = gives == [Shape::Reals(m), Shape::Statuses(m)]
                    && inputs.limits.len() == m
                    && inputs.values.iter().all(|value| matches!(value, Expr::Local(_)));
                if !fits {
                    return Err("it does not give each input and its status".to_owned());
                }
            }
            _ => {}
        }
        seen.finish(&function.finish, given.sum(), function.owner)
    }

    /// Whether a function gives what `tick` and `axis` give for each of so many axes.
    fn gives_axes(&self, function: &Function, axes: &Axes) -> Result<(), String> {
        let count = axes.count;
        let (Some(tick), Some(axis)) = (self.function("tick"), self.function("axis")) else {
            return Err("there is no tick or no axis".to_owned());
        };
        let own = axis.arguments.iter().filter(|argument| argument.shape != Shape::Count);
        let lists = own.map(|argument| match argument.shape {
            Shape::Reals(length) => Ok((argument.name.as_str(), Shape::Lists(count, length))),
            _ => Err(format!("{} is no array", argument.name)),
        });
        let time = tick.arguments.iter().map(|a| Ok((a.name.as_str(), a.shape)));
        let wanted: Vec<_> = time.chain(lists).collect::<Result<_, _>>()?;
        let shapes = |list: &[Variable]| list.iter().map(|v| v.shape).collect::<Vec<_>>();
        let given: Vec<_> = function.arguments.iter().map(|a| (a.name.as_str(), a.shape)).collect();
        let gives = [Shape::Reals(count), Shape::Statuses(count)];
        let plain = function.body.is_empty()
            && function.callbacks.is_empty()
            && (function.owner, function.access) == (Owner::Controller, Access::Read)
            && (axis.owner, axis.access) == (Owner::Gains, Access::Read)
            && shapes(&axis.results) == [Shape::Real]
            && shapes(&tick.results) == [Shape::Gains];
        if !plain || given != wanted || shapes(&function.results) != gives {
            return Err("it is not tick and axis for each".to_owned());
        }
        let rows = axis.arguments.iter().map(|argument| argument.name.clone());
        let mut seen = Seen {
            fields: names(&self.gains),
            parameters: BTreeSet::new(),
            callbacks: BTreeSet::new(),
            locals: rows.chain([AXIS.to_owned()]).collect(),
            of_gains: true,
            may_change: false,
            changed: false,
        };
        // The tests read v, and none of the values computed before it.
        let outer = seen.locals.clone();
        seen.block(&axes.body)?;
        seen.expression(&axes.value)?;
        seen.locals = outer;
        seen.define("v")?;
        if let Some(bound) = &axes.bound {
            seen.expression(bound)?;
            seen.define("bound")?;
        }
        seen.test(&axes.legal)?;
        seen.finish(&axes.otherwise, 1, Owner::Gains)
    }

    /// A number of the program that its precision does not hold: it is not 0 and rounds to 0, or to
    /// infinity.
    pub fn out_of_range(&self) -> Option<BigRational> {
        let mut lost = None;
        self.visit(&mut |value: &Expr| {
            if let Expr::Number(exact) = value {
                let near = number::round(exact, self.precision);
                if !near.is_finite() || (near == 0.0 && !exact.is_zero()) {
                    lost.get_or_insert_with(|| exact.clone());
                }
            }
        });
        lost
    }
}

fn names(variables: &[Variable]) -> BTreeSet<&str> {
    set(variables.iter().map(|variable| variable.name.as_str()))
}

impl Seen<'_> {
    fn block(&mut self, statements: &[Statement]) -> Result<(), String> {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), String> {
        match statement {
            Statement::Let(name, _, value) => {
                self.expression(value)?;
                self.define(name)
            }
            Statement::Variable(name, _) => self.define(name),
            Statement::Set(Place::Local(name), value) => {
                self.expression(value)?;
                match self.locals.contains(name) {
                    true => Ok(()),
                    false => Err(format!("{name} is set before it is declared")),
                }
            }
            Statement::Set(Place::Field(name), value) => {
                self.expression(value)?;
                if !self.may_change || !self.fields.contains(name.as_str()) {
                    return Err(format!("the field {name} cannot be set here"));
                }
                self.changed = true;
                Ok(())
            }
            Statement::If(test, then, otherwise) => {
                self.test(test)?;
                let outer = self.locals.clone();
                self.block(then)?;
                self.locals.clone_from(&outer);
                self.block(otherwise)?;
                self.locals = outer;
                Ok(())
            }
            Statement::Require(test, _) => {
                self.test(test)?;
                self.may_fail()
            }
            Statement::Array(name, values) => {
                values.iter().try_for_each(|value| self.expression(value))?;
                self.define(name)
            }
            Statement::Rows { name, tail, weights, .. } => {
                tail.iter().chain(weights).try_for_each(|value| self.expression(value))?;
                if tail.len() + 1 != weights.len() || tail.len() < 2 {
                    return Err(format!("{name} has no rows to form"));
                }
                self.define(name)
            }
            Statement::Elimination { name, matrix, right } => {
                matrix.iter().chain(right).try_for_each(|value| self.expression(value))?;
                if right.is_empty() || matrix.len() != right.len() * right.len() {
                    return Err(format!("{name} has no square matrix"));
                }
                self.define(name)
            }
            Statement::Call { name, callback, array, times, .. } => {
                times.iter().try_for_each(|value| self.expression(value))?;
                if !self.callbacks.contains(callback) || !self.locals.contains(array) {
                    return Err(format!("{callback} is called before it is known"));
                }
                self.define(name)
            }
            Statement::Solve(solve) => self.solve(solve),
            Statement::Note(_) => Ok(()),
        }
    }

    fn solve(&mut self, solve: &Solve) -> Result<(), String> {
        for value in [&solve.start, &solve.low, &solve.high, &solve.tolerance] {
            self.expression(value)?;
        }
        self.define(&solve.unknown)?;
        for local in Solve::LOCALS {
            self.define(&format!("{}_{local}", solve.unknown))?;
        }
        let outer = self.locals.clone();
        self.block(&solve.body)?;
        for value in [&solve.residual, &solve.next, &solve.size] {
            self.expression(value)?;
        }
        self.locals = outer;
        Ok(())
    }

    fn finish(&self, finish: &Finish, elements: usize, owner: Owner) -> Result<(), String> {
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
            Finish::Inputs(_) => {
                let mut found = Ok(());
                finish.visit(&mut |e| {
                    found = std::mem::replace(&mut found, Ok(())).and(self.known(e))
                });
                found.and(self.may_fail())
            }
            Finish::Axes(_) => Err("axes are the whole of a function".to_owned()),
        }
    }

    fn may_fail(&self) -> Result<(), String> {
        match self.changed {
            true => Err("a call can fail after it has changed a field".to_owned()),
            false => Ok(()),
        }
    }

    fn define(&mut self, name: &str) -> Result<(), String> {
        if self.of_gains && self.fields.contains(name) {
            return Err(format!("{name} is a field of the gains and a local"));
        }
        match self.locals.insert(name.to_owned()) {
            true => Ok(()),
            false => Err(format!("{name} is declared twice")),
        }
    }

    fn test(&self, test: &super::Test) -> Result<(), String> {
        let mut found = Ok(());
        test.visit(&mut |e| found = std::mem::replace(&mut found, Ok(())).and(self.known(e)));
        found
    }

    fn expression(&self, value: &Expr) -> Result<(), String> {
        let mut found = Ok(());
        value.visit(&mut |e| found = std::mem::replace(&mut found, Ok(())).and(self.known(e)));
        found
    }

    fn known(&self, value: &Expr) -> Result<(), String> {
        let (known, name) = match value {
            Expr::Local(name) | Expr::Element(name, _) | Expr::Entry(name, _) => {
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
