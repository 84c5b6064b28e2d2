//! The invariants of a program: names are declared before their uses, and a call that fails has changed
//! nothing.

mod seen;

use std::collections::BTreeSet;

use num_traits::Zero;

use super::{AXIS, Access, Axes, Code, Expr, Finish, Function, Owner, Shape, Variable};
use crate::algebra::BigRational;
use crate::collect::set;
use crate::program::number;
use seen::Seen;

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
            may_change: true,
            ..Seen::default()
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
            callbacks: function.callbacks.iter().map(|callback| callback.name).collect(),
            locals: function.arguments.iter().map(|a| a.name.clone()).collect(),
            of_gains: function.owner == Owner::Gains,
            may_change: function.access == Access::Change,
            ..Seen::default()
        };
        seen.block(&function.body)?;
        let elements = |of: &Variable| of.shape.length().unwrap_or(1);
        let given = function.results.iter().map(|result| match result.shape {
            Shape::Gains => self.gains.iter().map(elements).sum(),
            _ => elements(result),
        });
        match &function.finish {
            Finish::Axes(axes) => return self.gives_axes(function, axes),
            Finish::Stands => {
                let gives: Vec<_> = function.results.iter().map(|result| result.shape).collect();
                return match gives.as_slice() {
                    [Shape::Reals(m), Shape::Statuses(of)] if m == of => seen.may_fail(),
                    _ => Err("it does not give each input and its status".to_owned()),
                };
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
            locals: rows.chain([AXIS.to_owned()]).collect(),
            of_gains: true,
            ..Seen::default()
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
