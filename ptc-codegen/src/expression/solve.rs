//! The closed-form inverse of an expression in which the unknown occurs once.

use super::{Expression, Function, Node, Variable};

/// The `unknown` for which `expression` is `target`, where undoing one operation after the other
/// finds it: the unknown occurs once, and each operation around it can be undone. Where a branch
/// must be chosen, it is the one on which a mapping lies: roots and bases are positive.
pub fn solve(expression: &Expression, unknown: Variable, target: Expression) -> Option<Expression> {
    let here = |e: &Expression| e.contains(unknown);
    let undo = |inner: &Expression, target| solve(inner, unknown, target);
    match expression.node() {
        Node::Variable(variable) if *variable == unknown => Some(target),
        Node::Neg(a) => undo(a, target.neg()),
        Node::Add(a, b) if !here(b) => undo(a, target.sub(b.clone())),
        Node::Add(a, b) if !here(a) => undo(b, target.sub(a.clone())),
        Node::Sub(a, b) if !here(b) => undo(a, target.add(b.clone())),
        Node::Sub(a, b) if !here(a) => undo(b, a.clone().sub(target)),
        Node::Mul(a, b) if !here(b) => undo(a, target.div(b.clone())),
        Node::Mul(a, b) if !here(a) => undo(b, target.div(a.clone())),
        Node::Div(a, b) if !here(b) => undo(a, target.mul(b.clone())),
        Node::Div(a, b) if !here(a) => undo(b, a.clone().div(target)),
        Node::Power(a, b) if !here(b) => {
            undo(a, target.power(Expression::integer(1).div(b.clone())))
        }
        Node::Call(function, a) => undo(a, inverse(*function, target)?),
        _ => None,
    }
}

fn inverse(function: Function, target: Expression) -> Option<Expression> {
    let back = match function {
        Function::Exp => Function::Ln,
        Function::Ln => Function::Exp,
        Function::Tanh => Function::Atanh,
        Function::Atanh => Function::Tanh,
        Function::Atan => Function::Tan,
        Function::Sqrt => return Some(target.power(Expression::integer(2))),
        _ => return None,
    };
    Some(Expression::call(back, target))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Subject, family_form};
    use crate::family::FAMILIES;

    #[test]
    fn what_stands_once_is_found() {
        let mu = family_form(&FAMILIES[0], Subject::Mu).expect("a form");
        let found = solve(&mu, Variable::SinceStart, Variable::TimeToGo.into());
        assert_eq!(found.expect("an inverse").to_string(), "ln(1 - T/tau)/-a");
        let mu = family_form(&FAMILIES[1], Subject::Mu).expect("a form");
        assert_eq!(solve(&mu, Variable::SinceStart, Variable::TimeToGo.into()), None);
    }
}
