//! The invariants of a program: names stand before their uses, and a call that fails has changed
//! nothing.

use std::collections::BTreeSet;

use num_traits::Zero;

use super::{Access, Code, Expr, Function, Outcomes, Place, Shape, Statement, Variable};
use crate::algebra::BigRational;
use crate::program::number;

/// What the statements of one function have seen so far.
struct Seen<'a> {
    fields: BTreeSet<&'a str>,
    parameters: BTreeSet<&'a str>,
    locals: BTreeSet<String>,
    may_change: bool,
    changed: bool,
}

impl Code {
    /// Checks the invariants of the module's doc.
    ///
    /// # Errors
    /// The first one that does not hold.
    pub fn check(&self) -> Result<(), String> {
        let names = |variables: &'_ [Variable]| -> Vec<String> {
            variables.iter().map(|v| v.name.clone()).collect()
        };
        for list in [names(&self.fields), names(&self.parameters)] {
            let distinct: BTreeSet<_> = list.iter().collect();
            if distinct.len() != list.len() {
                return Err("a name is given twice".to_owned());
            }
        }
        let fields: BTreeSet<_> = self.fields.iter().map(|f| f.name.as_str()).collect();
        let parameters: BTreeSet<_> = self.parameters.iter().map(|p| p.name.as_str()).collect();
        let mut seen = Seen {
            fields: fields.clone(),
            parameters,
            locals: BTreeSet::new(),
            may_change: true,
            changed: false,
        };
        seen.block(&self.init)?;
        for function in &self.functions {
            seen_by(function, &fields)?;
        }
        Ok(())
    }
}

fn seen_by(function: &Function, fields: &BTreeSet<&str>) -> Result<(), String> {
    let mut seen = Seen {
        fields: fields.clone(),
        parameters: BTreeSet::new(),
        locals: function.arguments.iter().map(|a| a.name.clone()).collect(),
        may_change: function.access == Access::Change,
        changed: false,
    };
    let within = |error: String| format!("{}: {error}", function.name);
    seen.block(&function.body).map_err(within)?;
    for given in &function.results {
        let wanted = if let Shape::Reals(length) = given.variable.shape { length } else { 1 };
        if given.values.len() != wanted {
            return Err(within(format!("{} is not given whole", given.variable.name)));
        }
    }
    for value in function.results.iter().flat_map(|given| &given.values) {
        seen.expression(value).map_err(within)?;
    }
    if let Outcomes::First(ways, _) = &function.status {
        for (test, _) in ways {
            seen.test(test).map_err(within)?;
        }
    }
    Ok(())
}

impl Seen<'_> {
    fn block(&mut self, statements: &[Statement]) -> Result<(), String> {
        for statement in statements {
            match statement {
                Statement::Let(name, _, value) => {
                    self.expression(value)?;
                    self.define(name)?;
                }
                Statement::Variable(name, _) => self.define(name)?,
                Statement::Set(Place::Local(name), value) => {
                    self.expression(value)?;
                    if !self.locals.contains(name) {
                        return Err(format!("{name} is set before it is declared"));
                    }
                }
                Statement::Set(Place::Field(name), value) => {
                    self.expression(value)?;
                    if !self.may_change || !self.fields.contains(name.as_str()) {
                        return Err(format!("the field {name} cannot be set here"));
                    }
                    self.changed = true;
                }
                Statement::If(test, then, otherwise) => {
                    self.test(test)?;
                    let outer = self.locals.clone();
                    self.block(then)?;
                    self.locals.clone_from(&outer);
                    self.block(otherwise)?;
                    self.locals = outer;
                }
                Statement::Require(test, _) => {
                    self.test(test)?;
                    if self.changed {
                        return Err("a call can fail after it has changed a field".to_owned());
                    }
                }
                Statement::Note(_) => {}
            }
        }
        Ok(())
    }

    fn define(&mut self, name: &str) -> Result<(), String> {
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
            Expr::Local(name) | Expr::Element(name, _) => (self.locals.contains(name), name),
            Expr::Field(name) => (self.fields.contains(name.as_str()), name),
            Expr::Parameter(name) | Expr::ParameterElement(name, _) => {
                (self.parameters.contains(name.as_str()), name)
            }
            _ => return Ok(()),
        };
        if known { Ok(()) } else { Err(format!("{name} is used before it is known")) }
    }
}

impl Code {
    /// A number of the program that its precision does not hold: it is not 0 and rounds to 0, or to
    /// infinity.
    pub fn out_of_range(&self) -> Option<BigRational> {
        let mut lost = None;
        let mut look = |value: &Expr| {
            if let Expr::Number(exact) = value {
                let near = number::round(exact, self.precision);
                if !near.is_finite() || (near == 0.0 && !exact.is_zero()) {
                    lost.get_or_insert_with(|| exact.clone());
                }
            }
        };
        let bodies = self.functions.iter().map(|function| &function.body).chain([&self.init]);
        bodies.for_each(|body| visit(body, &mut look));
        let given = self.functions.iter().flat_map(|function| &function.results);
        given.flat_map(|given| &given.values).for_each(|value| value.visit(&mut look));
        lost
    }
}

/// Calls `look` on every expression of the statements.
fn visit(statements: &[Statement], look: &mut dyn FnMut(&Expr)) {
    for statement in statements {
        match statement {
            Statement::Let(_, _, value) | Statement::Set(_, value) => value.visit(look),
            Statement::Require(test, _) => test.visit(look),
            Statement::If(test, yes, no) => {
                test.visit(look);
                visit(yes, look);
                visit(no, look);
            }
            Statement::Variable(..) | Statement::Note(_) => {}
        }
    }
}
