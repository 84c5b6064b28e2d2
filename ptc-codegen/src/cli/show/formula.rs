//! Expressions in LaTeX.

use crate::expression::{Expression, Node, Variable};
use num_traits::Signed;

use super::super::greek::GREEK;

/// The expression.
pub(super) fn latex(e: &Expression) -> String {
    if !e.is_written() {
        return format!("\\text{{{e}}}");
    }
    match e.node() {
        Node::Number(number) if number.is_integer() => number.to_string(),
        Node::Number(number) => {
            let sign = if number.is_negative() { "-" } else { "" };
            format!("{sign}\\frac{{{}}}{{{}}}", number.numer().magnitude(), number.denom())
        }
        Node::Pi => "\\pi".to_owned(),
        Node::Parameter(parameter) => name(&parameter.spelling()),
        Node::Variable(Variable::TimeToGo) => "T".to_owned(),
        Node::Variable(variable) => name(&variable.to_string()),
        Node::Neg(a) => format!("-{}", operand(a, 3)),
        Node::Add(a, b) => format!("{} + {}", operand(a, 1), operand(b, 2)),
        Node::Sub(a, b) => format!("{} - {}", operand(a, 1), operand(b, 2)),
        Node::Mul(a, b) => format!("{} \\, {}", operand(a, 2), operand(b, 3)),
        Node::Div(a, b) => format!("\\frac{{{}}}{{{}}}", latex(a), latex(b)),
        Node::Power(a, b) => format!("{}^{{{}}}", operand(a, 5), latex(b)),
        Node::Min(a, b) => format!("\\min({}, {})", latex(a), latex(b)),
        Node::Max(a, b) => format!("\\max({}, {})", latex(a), latex(b)),
        Node::Call(function, a) => {
            let [before, after] = function.words().latex;
            format!("{before}{}{after}", latex(a))
        }
    }
}

/// Returns the precedence of the outermost operation, as it is written here.
fn binding(e: &Expression) -> u8 {
    match e.node() {
        Node::Add(..) | Node::Sub(..) => 1,
        Node::Mul(..) => 2,
        Node::Neg(_) => 3,
        Node::Number(number) if number.is_negative() => 3,
        Node::Number(number) if !number.is_integer() => 4,
        Node::Div(..) | Node::Power(..) | Node::Call(..) | Node::Min(..) | Node::Max(..) => 4,
        _ => 5,
    }
}

fn operand(e: &Expression, least: u8) -> String {
    if binding(e) < least { format!("\\left({}\\right)", latex(e)) } else { latex(e) }
}

/// A name, the Greek ones as letters.
fn name(text: &str) -> String {
    match text {
        letter if GREEK.iter().any(|(name, _)| *name == letter) => format!("\\{letter}"),
        _ if text.len() == 1 => text.to_owned(),
        _ => format!("\\mathrm{{{}}}", text.replace('_', "\\_")),
    }
}
