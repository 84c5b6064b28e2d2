//! The invariants of a program: names are declared before their uses, and a call that fails has changed
//! nothing.

mod seen;

use std::collections::BTreeSet;

use num_traits::Zero;

use super::{Access, Code, Expr, Finish, Function, Owner, Shape, Variable};
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
            start.numbers().try_for_each(|number| seen.expression(number))?;
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
        if function.finish == Finish::Stands {
            let gives: Vec<_> = function.results.iter().map(|result| result.shape).collect();
            return match gives.as_slice() {
                [Shape::Reals(m), Shape::Statuses(of)] if m == of => Ok(()),
                _ => Err("it does not give each input and its status".to_owned()),
            };
        }
        seen.finish(&function.finish, given.sum(), function.owner)
    }

    /// A number of the program that its precision does not hold: it is not 0 and rounds to 0, or to
    /// infinity.
    pub fn out_of_range(&self) -> Option<BigRational> {
        let mut lost = None;
        let mut look = |exact: &BigRational| {
            let near = number::round(exact, self.precision);
            if !near.is_finite() || (near == 0.0 && !exact.is_zero()) {
                lost.get_or_insert_with(|| exact.clone());
            }
        };
        self.visit(&mut |value: &Expr| {
            if let Expr::Number(exact) = value {
                look(exact);
            }
        });
        self.tables.iter().flat_map(|table| table.rows.iter().flatten()).for_each(look);
        lost
    }
}

fn names(variables: &[Variable]) -> BTreeSet<&str> {
    set(variables.iter().map(|variable| variable.name.as_str()))
}
