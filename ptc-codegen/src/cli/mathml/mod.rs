//! Formulas as MathML Core, which browsers lay out without any library.

mod element;
mod expression;
mod poly;

pub(crate) use element::{
    Math, applied, bold, display, dot, equal, fenced, fraction, inline, lines, matrix, name,
    number, operator, prime, product, relation, row, sequence, sub, sub_sup, sum, sup, transpose,
    words,
};
pub(crate) use expression::{named, of_expression, variable};
pub(crate) use poly::of_poly;
