//! Determinants of matrices of expressions, and their inverses in closed form.

use super::Values;
use super::decide::{is_regular_at_a_point, is_zero};
use crate::algebra::BigRational;
use crate::expression::Expression;
use crate::expression::effort::bounded;
use crate::expression::normal::{normal, shorter};

/// Outputs that are decoupled in closed form: a determinant has as many products as its rows have orders.
pub(super) const CLOSED: usize = 3;

/// Outputs up to which their determinant is still written out to see where it is 0.
const DECIDED: usize = 6;

/// The matrix without a row and a column.
fn minor(matrix: &[Vec<Expression>], row: usize, column: usize) -> Vec<Vec<Expression>> {
    let without = |list: &Vec<Expression>| {
        let kept = list.iter().enumerate().filter(|(j, _)| *j != column);
        kept.map(|(_, e)| e.clone()).collect()
    };
    let rows = matrix.iter().enumerate().filter(|(i, _)| *i != row);
    rows.map(|(_, list)| without(list)).collect()
}

/// The determinant by its first row.
pub(super) fn determinant(matrix: &[Vec<Expression>]) -> Expression {
    let Some(first) = matrix.first() else { return Expression::integer(1) };
    let mut sum = Expression::integer(0);
    for (j, entry) in first.iter().enumerate() {
        let term = entry.clone().mul(determinant(&minor(matrix, 0, j)));
        sum = if j % 2 == 0 { sum.add(term) } else { sum.sub(term) };
    }
    sum
}

/// The determinant and the adjugate of a matrix of at most three rows. Equal parts are one node.
pub(super) fn inverse(matrix: &[Vec<Expression>]) -> (Expression, Vec<Vec<Expression>>) {
    let cofactor = |i: usize, j: usize| {
        let minor = determinant(&minor(matrix, i, j));
        if (i + j).is_multiple_of(2) { minor } else { minor.neg() }
    };
    let m = matrix.len().min(CLOSED);
    let adjugate = (0..m).map(|i| (0..m).map(|j| cofactor(j, i)).collect()).collect();
    (determinant(matrix), adjugate)
}

/// Returns true if a matrix is regular except for some states: certainly so at a point, or by its determinant where
/// that is not too long to be examined; `None` if that is not decided.
pub(super) fn is_regular(matrix: &[Vec<Expression>], values: &Values) -> Option<bool> {
    if is_regular_at_a_point(matrix, values) {
        return Some(true);
    }
    Some(!is_zero(&written_out(matrix)?, values)?)
}

/// The determinant of a matrix of any size, where it is short enough to be looked at.
pub(super) fn written_out(matrix: &[Vec<Expression>]) -> Option<Expression> {
    (matrix.len() <= DECIDED).then(|| bounded(|| shorter(determinant(matrix))))
}

/// A determinant that is a number is divided by when generating.
pub(super) fn divided(
    determinant: Expression,
    adjugate: Vec<Vec<Expression>>,
) -> (Expression, Vec<Vec<Expression>>) {
    let form = normal(&determinant);
    let Some(number) = form.number().filter(|number| **number != BigRational::default()) else {
        return (determinant, adjugate);
    };
    let over = |e: Expression| shorter(e.mul(number.recip().into()));
    let adjugate = adjugate.into_iter().map(|row| row.into_iter().map(over).collect());
    (Expression::integer(1), adjugate.collect())
}
