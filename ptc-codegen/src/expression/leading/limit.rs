//! The limit of an expression.

use std::cmp::Ordering;

use super::series::Series;
use super::{Scale, inverted, ordering, search, zero};
use crate::expression::normal::normal;
use crate::expression::{Expression, Node, Variable};

/// The limit of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    /// It grows without bound.
    Infinite,
    /// It falls without bound.
    MinusInfinite,
    /// An expression in parameters.
    Finite(Expression),
}

impl Series {
    fn limit(&self) -> Option<Limit> {
        let tends = |scale: &Scale| scale.tends();
        let Some(first) = self.terms.first() else {
            let vanishes = self.rest.iter().all(|r| tends(r).is_some_and(Ordering::is_lt));
            return vanishes.then(|| Limit::Finite(zero()));
        };
        Some(match tends(&first.scale)? {
            Ordering::Less => Limit::Finite(zero()),
            Ordering::Equal => Limit::Finite(first.coefficient.clone()),
            Ordering::Greater if self.sign()? > 0 => Limit::Infinite,
            Ordering::Greater => Limit::MinusInfinite,
        })
    }
}

/// The limit of an expression as `v` grows without bound.
pub(crate) fn limit(expression: &Expression, v: Variable) -> Option<Limit> {
    if let Some(limit) = search(expression, v, &|series| series.limit()) {
        return Some(limit);
    }
    // Terms that cannot be compared before the parameters are known still have limits.
    use Limit::{Finite, Infinite, MinusInfinite};
    match expression.node() {
        Node::Neg(a) => Some(negative(limit(a, v)?)),
        Node::Add(a, b) | Node::Sub(a, b) => {
            let first = limit(a, v)?;
            let second = limit(b, v)?;
            let second = match expression.node() {
                Node::Sub(..) => negative(second),
                _ => second,
            };
            match (first, second) {
                (Finite(a), Finite(b)) => Some(Finite(normal(&a.add(b)))),
                (Infinite, Finite(_) | Infinite) | (Finite(_), Infinite) => Some(Infinite),
                (MinusInfinite, Finite(_) | MinusInfinite) | (Finite(_), MinusInfinite) => {
                    Some(MinusInfinite)
                }
                _ => None,
            }
        }
        Node::Mul(a, b) => match (limit(a, v)?, limit(b, v)?) {
            (Finite(a), Finite(b)) => Some(Finite(normal(&a.mul(b)))),
            (Finite(factor), grown) | (grown, Finite(factor)) => match ordering(&factor)? {
                Ordering::Greater => Some(grown),
                Ordering::Less => Some(negative(grown)),
                Ordering::Equal => None,
            },
            _ => None,
        },
        Node::Div(a, b) if !b.contains(v) => {
            limit(&a.clone().mul(Expression::integer(1).div(b.clone())), v)
        }
        _ => None,
    }
}

fn negative(limit: Limit) -> Limit {
    match limit {
        Limit::Infinite => Limit::MinusInfinite,
        Limit::MinusInfinite => Limit::Infinite,
        Limit::Finite(value) => Limit::Finite(normal(&value.neg())),
    }
}

/// The limit of an expression as `to_go` falls to 0.
pub(crate) fn limit_at_zero(expression: &Expression, to_go: Variable) -> Option<Limit> {
    let turned = inverted(expression, to_go);
    limit(&normal(&turned), to_go).or_else(|| limit(&turned, to_go))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::testing::mu;

    fn of(text: &str) -> String {
        match limit(&mu(text), Variable::SinceStart) {
            Some(Limit::Finite(value)) => value.to_string(),
            Some(Limit::Infinite) => "inf".to_owned(),
            Some(Limit::MinusInfinite) => "-inf".to_owned(),
            None => "?".to_owned(),
        }
    }

    #[test]
    fn limits() {
        for (text, value) in [
            ("exp", "tau"),
            ("tan", "tau"),
            ("tau*(1 - exp(a*t))", "-inf"),
            ("2*tau*(1 - exp(-a*t))", "2*tau"),
            ("tau*t/(1 + t^2)", "0"),
            ("t*exp(-t) + ln(t)/sqrt(t)", "0"),
            ("(1 + t)^a - t", "?"),
            ("tau*(1 - exp(-t)*cos(5*t))", "tau"),
            ("sin(t)", "?"),
            ("tau*(1 - exp(-t^2))", "tau"),
            ("min(t, 3*tau) + max(2, 1/t)", "2 + 3*tau"),
            ("t^2/(3*t^2 + ln(t))", "1/3"),
            ("exp(t^2/(1 + t))*exp(-t)", "exp(-1)"),
            ("exp(t^2/(1 + t) - t)", "exp(-1)"),
            ("exp(-a*t) + exp(-b*t)", "0"),
            ("(sin(t) - cos(t))", "?"),
            ("tan(pi/2 + 1/t)", "-inf"),
            ("tanh(-t) + sinh(t)/exp(t)", "-1/2"),
        ] {
            assert_eq!(of(text), value, "{text}");
        }
    }
}
