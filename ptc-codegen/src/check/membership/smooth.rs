//! Conditions on the parts of an expression for it to be smooth.

use crate::expression::function::{Domain, Slope};
use crate::expression::{Expression, Function, Node, Variable};

/// A condition on a part of an expression, wherever the variable may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Need {
    /// The part.
    pub(super) part: Expression,
    /// True if it must be positive, false if it must only be nonzero.
    pub(super) positive: bool,
    /// Consequence of a violation.
    pub(super) why: String,
}

/// All conditions under which `expression` is smooth in `v`.
pub(super) fn needs(expression: &Expression, v: Variable) -> Vec<Need> {
    let mut found = Vec::new();
    expression.each(&mut |part| own(part, v, &mut found));
    found
}

/// Adds the conditions of the outermost operation.
fn own(expression: &Expression, v: Variable, found: &mut Vec<Need>) {
    let mut need = |part: Expression, positive: bool, why: String| {
        if part.contains(v) {
            let need = Need { part, positive, why };
            if !found.contains(&need) {
                found.push(need);
            }
        }
    };
    let one = || Expression::integer(1);
    match expression.node() {
        Node::Div(_, b) => need(b.clone(), false, format!("{b}, a divisor, may be 0")),
        Node::Power(a, b) => match b.small_integer() {
            Some(k) if k >= 0 => {}
            Some(_) => need(a.clone(), false, format!("{a}, a divisor, may be 0")),
            None => need(a.clone(), true, format!("{a}, to the power {b}, may be 0")),
        },
        Node::Min(a, b) | Node::Max(a, b) => {
            let part = a.clone().sub(b.clone());
            need(part, false, format!("{expression} has a kink where both are equal"));
        }
        Node::Call(function, a) => {
            if function.row().has_kink {
                need(a.clone(), false, format!("{expression} has a kink where {a} is 0"));
            }
            if function.row().slope == Slope::ThirdReciprocalSquare {
                need(a.clone(), false, format!("{expression} is vertical where {a} is 0"));
            }
            let name = function.name();
            match function.row().domain {
                Domain::Everywhere => {}
                Domain::NotNegative | Domain::Positive => {
                    need(a.clone(), true, format!("{a}, under {name}, may be 0"));
                }
                Domain::OffPoles => {
                    let cosine = Expression::call(Function::Cos, a.clone());
                    need(cosine, false, format!("{expression} may have a pole"));
                }
                Domain::InsideOne | Domain::WithinOne => {
                    let why = format!("{a}, under {name}, may reach 1 or -1");
                    need(one().sub(a.clone()), true, why.clone());
                    need(one().add(a.clone()), true, why);
                }
            }
        }
        _ => {}
    }
}
