//! Expressions of this program on their way to the engine and back, in its [words](super::words).

use std::fmt::Write;

use crate::algebra::{BigRational, Poly, Symbol};
use crate::expression::{Expression, Function, Node};
use num_traits::Signed;

use super::words::Target;

/// A polynomial, its symbols by their places.
pub(super) fn of_poly(poly: &Poly, place: &dyn Fn(&Symbol) -> usize) -> String {
    let mut text = String::new();
    for (monomial, coefficient) in poly.terms() {
        let _ = write!(text, "{coefficient} ");
        for (symbol, exponent) in monomial.factors() {
            let _ = write!(text, "v{} {exponent} ^ ", place(symbol));
        }
        let _ = write!(text, "*{} ", monomial.factors().len() + 1);
    }
    let _ = write!(text, "+{}", poly.terms().len());
    text
}

/// Polynomials in the symbols of a list.
pub(super) struct Polynomials<'a>(pub(super) &'a [Symbol]);

impl Target for Polynomials<'_> {
    type Value = Poly;

    fn number(&self, text: &str) -> Option<Poly> {
        text.parse().ok().map(Poly::constant)
    }

    fn symbol(&self, place: usize) -> Option<Poly> {
        self.0.get(place).copied().map(Poly::symbol)
    }

    fn sum(&self, terms: Vec<Poly>) -> Option<Poly> {
        Some(terms.iter().fold(Poly::zero(), Poly::plus))
    }

    fn product(&self, factors: Vec<Poly>) -> Option<Poly> {
        Some(factors.iter().fold(Poly::one(), |product, factor| product.times(factor)))
    }

    fn power(&self, base: Poly, exponent: Poly) -> Option<Poly> {
        let exponent = match exponent.single_term() {
            Some((monomial, value)) if monomial.factors().is_empty() && value.is_integer() => {
                i32::try_from(value.numer()).ok()?
            }
            _ => return None,
        };
        let base = if exponent < 0 { base.inverse()? } else { base };
        Some(base.pow(exponent.unsigned_abs()))
    }

    fn call(&self, _: &str, _: Poly) -> Option<Poly> {
        None
    }
}

/// An expression. What has a kink is a name: a mapping has none but in its parameters.
pub(super) fn of_expression(expression: &Expression, names: &mut Names) -> String {
    let mut two =
        |a, b, end: &str| format!("{} {} {end}", of_expression(a, names), of_expression(b, names));
    match expression.node() {
        Node::Number(number) => number.to_string(),
        Node::Neg(a) => format!("-1 {} *2", of_expression(a, names)),
        Node::Add(a, b) => two(a, b, "+2"),
        Node::Sub(a, b) => two(a, b, "-1 *2 +2"),
        Node::Mul(a, b) => two(a, b, "*2"),
        Node::Div(a, b) => two(a, b, "-1 ^ *2"),
        Node::Power(a, b) => two(a, b, "^"),
        Node::Pi
        | Node::Parameter(_)
        | Node::Variable(_)
        | Node::Min(..)
        | Node::Max(..)
        | Node::Call(Function::Abs | Function::Sign, _) => {
            format!("v{}", names.place(expression))
        }
        Node::Call(Function::Sqrt, a) => format!("{} 1/2 ^", of_expression(a, names)),
        Node::Call(function, a) => format!("{} {}", of_expression(a, names), function.name()),
    }
}

/// The names of an expression, by their places.
pub(super) struct Names(Vec<Expression>);

impl Names {
    /// A list that begins with the variable that is differentiated by.
    pub(super) fn new(variable: Expression) -> Self {
        Self(vec![variable])
    }

    fn place(&mut self, name: &Expression) -> usize {
        if let Some(place) = self.0.iter().position(|other| other == name) {
            return place;
        }
        self.0.push(name.clone());
        self.0.len() - 1
    }
}

impl Target for Names {
    type Value = Expression;

    fn number(&self, text: &str) -> Option<Expression> {
        text.parse().ok().map(|number: BigRational| number.into())
    }

    fn symbol(&self, place: usize) -> Option<Expression> {
        self.0.get(place).cloned()
    }

    /// A long sum in halves, so that it is not a high one.
    fn sum(&self, mut terms: Vec<Expression>) -> Option<Expression> {
        const LONG: usize = 32;
        if terms.len() <= LONG {
            return Some(terms.into_iter().reduce(plus).unwrap_or(Expression::integer(0)));
        }
        let rest = terms.split_off(terms.len() / 2);
        Some(plus(self.sum(terms)?, self.sum(rest)?))
    }

    /// One fraction, with its sign before it.
    fn product(&self, factors: Vec<Expression>) -> Option<Expression> {
        let one = || Expression::integer(1);
        let (mut over, mut under, mut negative) = (one(), one(), false);
        for factor in factors {
            let factor = match factor.number().filter(|number| number.is_negative()) {
                Some(number) => {
                    negative = !negative;
                    Expression::from(-number)
                }
                None => factor,
            };
            match factor.node() {
                Node::Div(a, b) if *a == one() => under = under.mul(b.clone()),
                _ => over = over.mul(factor),
            }
        }
        let fraction = if under == one() { over } else { over.div(under) };
        Some(if negative { fraction.neg() } else { fraction })
    }

    /// A root where the exponent is a half, a quotient where it is negative.
    fn power(&self, base: Expression, exponent: Expression) -> Option<Expression> {
        let Some(number) = exponent.number().cloned() else { return Some(base.power(exponent)) };
        if number.is_negative() {
            let inverse = self.power(base, Expression::from(-number))?;
            return Some(Expression::integer(1).div(inverse));
        }
        if *number.denom() != 2.into() {
            return Some(base.power(exponent));
        }
        let root = Expression::call(Function::Sqrt, base.clone());
        let whole = Expression::from(number.floor());
        Some(if whole == Expression::integer(0) { root } else { base.power(whole).mul(root) })
    }

    fn call(&self, name: &str, operand: Expression) -> Option<Expression> {
        let named = |name| Function::ALL.iter().find(|(n, _)| *n == name).map(|(_, f)| *f);
        if let Some(function) = named(name) {
            return Some(Expression::call(function, operand));
        }
        let inverse = [("sec", "cos"), ("csc", "sin"), ("cot", "tan")];
        let hyperbolic = [("sech", "cosh"), ("csch", "sinh"), ("coth", "tanh")];
        let (_, of) = inverse.iter().chain(&hyperbolic).find(|(n, _)| *n == name)?;
        Some(Expression::integer(1).div(Expression::call(named(of)?, operand)))
    }
}

/// a + b, with a sign before both or between them.
fn plus(a: Expression, b: Expression) -> Expression {
    match (a.node(), b.node()) {
        (Node::Neg(a), Node::Neg(b)) => a.clone().add(b.clone()).neg(),
        (Node::Neg(a), _) => b.sub(a.clone()),
        _ => a.add(b),
    }
}

#[cfg(test)]
mod tests {
    use super::super::words::read;
    use super::*;
    use crate::algebra::{Kind, text};
    use crate::expression::Variable;

    fn expression(text: &str) -> Option<String> {
        let names = Names(vec![Variable::TimeToGo.into(), Expression::pi()]);
        read(text, &names).map(|expression| expression.to_string())
    }

    #[test]
    fn a_polynomial_comes_back_as_it_was() {
        let symbols = [Symbol::plain(Kind::A), Symbol::plain(Kind::TimeToGo)];
        let place = |symbol: &Symbol| symbols.binary_search(symbol).expect("a symbol");
        let target = Polynomials(&symbols);
        for given in ["3/2 v0 v1 -3 ^ *3 -5 +2", "0", "v1", "v0 v1 +2 3 ^"] {
            let poly = read(given, &target).expect("a polynomial");
            assert_eq!(read(&of_poly(&poly, &place), &target), Some(poly), "{given}");
        }
        let cube = read("v0 1 +2 3 ^", &target).expect("a polynomial");
        assert_eq!(text(&cube), "1 + 3*a + 3*a^2 + a^3");
    }

    #[test]
    fn an_expression_is_written_as_a_person_would() {
        for (given, wanted) in [
            ("-2 v0 -3 ^ v1 *3", "-(2*pi/T^3)"),
            ("v0 3/2 ^", "T*sqrt(T)"),
            ("v0 -1/2 ^", "1/sqrt(T)"),
            ("v0 sech 2 ^", "(1/cosh(T))^2"),
            ("v0 -1 v1 *2 1 +3", "T - pi + 1"),
            ("-1 v0 *2 v1 +2", "pi - T"),
        ] {
            assert_eq!(expression(given).as_deref(), Some(wanted), "{given}");
        }
    }

    #[test]
    fn what_is_no_expression_is_none() {
        for text in ["", "v2", "1 2", "+1", "v0 ^", "v0 zeta", "1 *-1", "1 *99999999999999999999"] {
            assert_eq!(expression(text), None, "{text}");
        }
        let target = Polynomials(&[]);
        for text in ["1 1 +2 -1 ^", "2 1/2 ^", "1 exp", "v0"] {
            let value = read(text, &target);
            assert_eq!(value.is_some(), text == "1 1 +2 -1 ^", "{text}");
        }
    }

    #[test]
    fn an_expression_is_sent_with_its_names_by_place() {
        let mut names = Names::new(Variable::TimeToGo.into());
        let kink = Expression::call(Function::Abs, Expression::pi());
        let ratio = Expression::from(Variable::TimeToGo).div(kink.clone());
        assert_eq!(of_expression(&ratio, &mut names), "v0 v1 -1 ^ *2");
        assert_eq!(names.symbol(1), Some(kink));
    }
}
