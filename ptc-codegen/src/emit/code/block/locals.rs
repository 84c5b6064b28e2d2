//! The local values of statements, for languages that declare them first.

use std::collections::BTreeMap;

use crate::code::{Shape, Solve, Statement};
use crate::internal::fault;

/// The local values of statements, each of one shape.
pub(in crate::emit) fn declared(statements: &[Statement], locals: &mut BTreeMap<String, Shape>) {
    for statement in statements {
        match statement {
            Statement::Let(name, shape, _) | Statement::Variable(name, shape) => {
                declare(name, *shape, locals);
            }
            Statement::Array(name, values) => declare(name, Shape::Reals(values.len()), locals),
            Statement::Rows { name, weights, .. } => {
                declare(name, Shape::Reals(weights.len()), locals);
            }
            Statement::Elimination { name, right, .. } => {
                declare(name, Shape::Reals(right.len()), locals);
            }
            Statement::Call { name, count, .. } => declare(name, Shape::Reals(*count), locals),
            Statement::Solve(solve) => {
                declare(&solve.unknown, Shape::Real, locals);
                for local in Solve::LOCALS {
                    declare(&format!("{}_{local}", solve.unknown), Shape::Real, locals);
                }
                declared(&solve.body, locals);
            }
            Statement::If(_, yes, no) => {
                declared(yes, locals);
                declared(no, locals);
            }
            _ => {}
        }
    }
}

fn declare(name: &str, shape: Shape, locals: &mut BTreeMap<String, Shape>) {
    let known = *locals.entry(name.to_owned()).or_insert(shape);
    if known != shape {
        fault(format!("{name} is of two shapes"));
    }
}
