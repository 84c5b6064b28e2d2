//! The local values of statements, for languages that declare them first.

use std::collections::BTreeMap;

use crate::code::{Shape, Statement};
use crate::internal::fault;

/// The local values of statements, each of one shape; those of subroutines are their own.
pub(in crate::emit) fn declared(statements: &[Statement], locals: &mut BTreeMap<String, Shape>) {
    for statement in statements {
        match statement {
            Statement::Let(name, shape, _)
            | Statement::Variable(name, shape)
            | Statement::Begin(name, shape, _) => declare(name, *shape, locals),
            Statement::Array(name, values) => declare(name, Shape::Reals(values.len()), locals),
            Statement::Apply { name, subroutine, .. } => {
                declare(name, Shape::Reals(subroutine.given()[0].length), locals);
            }
            Statement::Call { name, count, .. } => declare(name, Shape::Reals(*count), locals),
            Statement::For(each) => {
                declare(&each.index, Shape::Count, locals);
                declared(&each.body, locals);
            }
            Statement::If(_, yes, no) => {
                declared(yes, locals);
                declared(no, locals);
            }
            Statement::Leave
            | Statement::Note(_)
            | Statement::Require(..)
            | Statement::Root(..)
            | Statement::Set(..)
            | Statement::Settle(..)
            | Statement::View { .. } => {}
        }
    }
}

fn declare(name: &str, shape: Shape, locals: &mut BTreeMap<String, Shape>) {
    let known = *locals.entry(name.to_owned()).or_insert(shape);
    if known != shape {
        fault(format!("{name} is of two shapes"));
    }
}
