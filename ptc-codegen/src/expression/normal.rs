//! Normal forms, in which constants have cancelled exactly: what vanishes at the deadline keeps
//! its digits there.

use super::effort::bounded;
use super::field::{Field, Kernel, Terms, sum};
use super::function::{Parity, Slope, in_logarithms};
use super::leading::{Limit, limit};
use super::ratio::{Ratio, exact_quotient};
use super::sign::{Sign, positive_parameters, sign};
use super::solve::contains;
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};
use crate::limits::{ALWAYS, GROWTH, PARTS, SIZE};
use crate::parameter::Parameter;

/// The complement tau - mu(t). Parameters are taken as positive, and t >= 0.
pub(crate) fn complement(mu: &Expression) -> Expression {
    bounded(|| complement_of(mu))
}

fn complement_of(mu: &Expression) -> Expression {
    let plain = Expression::from(Parameter::Tau).sub(mu.clone());
    let limited = Expression::from(Parameter::Tau).sub(at_limit(mu));
    let mut field = Field::of(&limited);
    let form = field
        .terms(&limited)
        .and_then(|terms| split(&mut field, terms))
        .and_then(|terms| field.shortest(&terms));
    within(form, &plain)
}

/// The shorter one of an expression and its normal form, which is not sought of what is very long.
pub(crate) fn shorter(expression: Expression) -> Expression {
    if !SIZE.admits(expression.size()) {
        return expression;
    }
    let form = normal(&expression);
    if form.size() <= expression.size() { form } else { expression }
}

/// The normal form: equal to the expression wherever that exists.
pub(crate) fn normal(expression: &Expression) -> Expression {
    if expression.number().is_some() {
        return expression.clone();
    }
    let form = bounded(|| {
        let rewritten = logarithmic(expression);
        let mut field = Field::of(&rewritten);
        field.terms(&rewritten).and_then(|terms| field.shortest(&terms))
    });
    within(form, expression)
}

pub(super) fn within(form: Option<Expression>, plain: &Expression) -> Expression {
    let most = plain.size().saturating_mul(GROWTH.size()).saturating_add(ALWAYS.size());
    form.filter(|form| form.size() <= most).unwrap_or_else(|| plain.clone())
}

/// An expression as c ln b: b, of those that `is_base` admits, and c in its normal form.
pub(crate) fn as_logarithm(
    expression: &Expression,
    is_base: &dyn Fn(&Expression) -> bool,
) -> Option<(Expression, Expression)> {
    let (logarithm, base) = expression.first(&mut |e| match e.node() {
        Node::Call(Function::Ln, base) if is_base(base) => Some((e.clone(), base.clone())),
        _ => None,
    })?;
    Some((base, normal(&expression.clone().div(logarithm))))
}

/// Inverse hyperbolic functions by logarithms, in which 1 - s is formed before it is rounded.
fn logarithmic(expression: &Expression) -> Expression {
    expression.substitute(&|e| match e.node() {
        Node::Call(function, s) => {
            in_logarithms(*function, s)?;
            let s = logarithmic(s);
            if s.twice() {
                in_logarithms(*function, &s)
            } else {
                Some(Expression::call(*function, s))
            }
        }
        _ => None,
    })
}

/// The signs for positive parameters and t >= 0.
fn from_the_start(name: &Expression) -> Option<Sign> {
    positive_parameters(name)
        .or_else(|| (*name == Variable::SinceStart.into()).then_some(Sign::NotNegative))
}

/// Functions that tend to a constant as t grows: that constant, less what vanishes.
fn at_limit(expression: &Expression) -> Expression {
    let t = Variable::SinceStart;
    let cosh = |e: &Expression| match e.node() {
        Node::Call(function, _) => function.hyperbolic() == Some(Parity::Even),
        _ => false,
    };
    let has_cosh = expression.any(&cosh);
    expression.substitute(&|e| {
        let Node::Call(function, u) = e.node() else { return None };
        match function {
            Function::Tanh | Function::Atan => {}
            // sinh(u) = cosh(u) tanh(u): their quotient then has its limit.
            _ => {
                let Slope::Partner(cosh, 1) = function.row().slope else { return None };
                if !has_cosh || cosh.hyperbolic() != Some(Parity::Even) {
                    return None;
                }
                let tanh = at_limit(&Expression::call(Function::Tanh, u.clone()));
                return Some(Expression::call(cosh, u.clone()).mul(tanh));
            }
        }
        let (falls, u) = match limit(u, t)? {
            Limit::Infinite => (false, at_limit(u)),
            Limit::MinusInfinite => (true, at_limit(u).neg()),
            Limit::Finite(_) => return None,
        };
        if !u.twice() {
            return Some(Expression::call(*function, if falls { u.neg() } else { u }));
        }
        let (one, two) = (Expression::integer(1), Expression::integer(2));
        let value = if *function == Function::Tanh {
            let grown = Expression::call(Function::Exp, two.clone().mul(u));
            one.clone().sub(two.div(one.add(grown)))
        } else {
            // pi/2 - atan(u) = atan(1/u) for u > 0, and 2 atan(1/(u + sqrt(1 + u^2))) for all u.
            let vanishing = |of: Expression| Expression::call(Function::Atan, one.clone().div(of));
            let root = one.clone().add(u.clone().power(two.clone()));
            let root = Expression::call(Function::Sqrt, root);
            let rest = match sign(&u, &from_the_start) {
                Some(Sign::Positive | Sign::NotNegative) => vanishing(u),
                _ => two.clone().mul(vanishing(u.add(root))),
            };
            Expression::pi().div(two).sub(rest)
        };
        Some(if falls { value.neg() } else { value })
    })
}

/// Fractions split into their limits and what vanishes, so that the limits cancel.
fn split(field: &mut Field, terms: Terms) -> Option<Terms> {
    let mut result = Vec::new();
    for term in terms {
        for part in without_roots(field, term)? {
            result = sum(result, proper(field, &part)?)?;
        }
    }
    Some(result)
}

/// Returns true if a symbol depends on time.
pub(super) fn moves(field: &Field, symbol: Symbol) -> bool {
    contains(field, symbol, Variable::SinceStart)
}

/// The symbol of a polynomial that decides how fast it grows: an exponential, else time.
fn fastest(field: &Field, poly: &Poly) -> Option<Symbol> {
    let symbols = poly.symbols();
    let exponential =
        |s: &&Symbol| matches!(field.kernel(**s), Some(Kernel::Exp(_))) && moves(field, **s);
    let time = |s: &&Symbol| {
        let t = Expression::from(Variable::SinceStart);
        matches!(field.kernel(**s), Some(Kernel::Atom(atom)) if *atom == t)
    };
    symbols.iter().find(exponential).or_else(|| symbols.iter().find(time)).copied()
}

/// A fraction as a polynomial and a proper fraction in the symbol that grows fastest.
fn proper(field: &Field, term: &Ratio) -> Option<Terms> {
    let whole = vec![term.clone()];
    let denominator = term.denominator()?;
    let Some(x) = fastest(field, &denominator) else { return Some(whole) };
    let collected = denominator.collect(x);
    let (top, lead) = collected.iter().next_back()?;
    let (mut rest, mut polynomial) = (term.num.clone(), Poly::zero());
    for _ in 0..PARTS.most {
        let by_exponent = rest.collect(x);
        let Some((exponent, coefficient)) = by_exponent.iter().next_back() else { break };
        if exponent < top {
            break;
        }
        let quotient = exact_quotient(coefficient, lead)
            .map(|q| q.shifted(&Monomial::power(x, exponent - top)))
            // What is divided by time would have a pole at the start that the whole has not.
            .filter(|q| {
                q.terms().all(|(m, _)| m.factors().iter().all(|(s, e)| *e > 0 || !moves(field, *s)))
            });
        let Some(quotient) = quotient else { break };
        rest = rest.plus(&super::ratio::times(&quotient, &denominator)?.scaled(&integer(-1)));
        polynomial = polynomial.plus(&quotient);
    }
    if polynomial.is_zero() {
        return Some(whole);
    }
    let mut left = Ratio::of(rest);
    for (factor, count) in &term.den {
        left = left.over(factor, *count)?;
    }
    sum(vec![Ratio::of(polynomial)], vec![left])
}

/// u/S with S = sqrt(c + u^2) is 1 - c/(S (S + u)): in each term with u/S for a growing u.
fn without_roots(field: &mut Field, term: Ratio) -> Option<Terms> {
    let half = Expression::from(BigRational::new(1.into(), 2.into()));
    let mut result = Vec::new();
    for (monomial, c) in term.num.terms() {
        let own = Ratio { num: Poly::term(c.clone(), monomial.clone()), den: term.den.clone() };
        let found = monomial.factors().iter().find_map(|(symbol, exponent)| {
            let Some(Kernel::Root(base, index)) = field.kernel(*symbol) else { return None };
            let fits = *exponent == -1 && *index == half && base.den.is_empty();
            let x = fits.then(|| fastest(field, &base.num)).flatten()?;
            let by_exponent = base.num.collect(x);
            let (top, lead) = by_exponent.iter().next_back()?;
            let (lead, number) = lead.single_term()?;
            let degree = top / 2;
            let even = top % 2 == 0 && degree > 0 && lead.factors().iter().all(|(_, e)| e % 2 == 0);
            let there = monomial.exponent(x) >= degree;
            (even && there)
                .then(|| (*symbol, base.clone(), x, degree, lead.clone(), number.clone()))
        });
        let Some((symbol, base, x, degree, lead, number)) = found else {
            result = sum(result, vec![own])?;
            continue;
        };
        let halved = lead.factors().iter().map(|(s, e)| (*s, e / 2)).collect();
        let scale = Ratio::of(Poly::term(integer(1), Monomial::from_sorted(halved)));
        let scale = scale.times(&field.root(Ratio::number(number.clone()), 1, 2)?)?;
        let u = scale.times(&Ratio::of(Poly::term(integer(1), Monomial::power(x, degree))))?;
        let square = Poly::term(number, lead.times(&Monomial::power(x, 2 * degree)));
        let c = base.num.plus(&square.scaled(&integer(-1)));
        let root = Ratio::of(Poly::symbol(symbol));
        // own = outer * u/S.
        let outer = own.times(&root)?.times(&u.pow(-1)?)?;
        let under = root.times(&root.plus(&u)?)?;
        let vanishing = outer.times(&Ratio::of(c))?.times(&under.pow(-1)?)?;
        result = sum(sum(result, vec![outer])?, vec![vanishing.neg()])?;
    }
    Some(result)
}

#[cfg(test)]
mod tests;
