//! Forms without large exponentials: 2/(1 + e^u) is 2 e^-u/(1 + e^-u), of which no part leaves the
//! range of numbers as u grows, and no derivative is infinity times 0.

use std::collections::BTreeMap;

use super::effort::bounded;
use super::field::{Field, Kernel, Terms, sum};
use super::function::Parity;
use super::leading::{Limit, limit};
use super::normal::{moves, within};
use super::ratio::{Ratio, content};
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};

/// The same function of t, stretched time since the start, with denominators in which no exponential
/// grows with it. Parameters are taken as positive.
pub(crate) fn decaying(form: &Expression) -> Expression {
    let inner = |e: &Expression| match e.node() {
        Node::Call(function, a) => Some(Expression::call(*function, decaying(a))),
        Node::Power(a, b) => Some(decaying(a).power(decaying(b))),
        _ => None,
    };
    bounded(|| turned(form).unwrap_or_else(|| form.clone()).substitute(&inner))
}

/// The form with its outermost denominators turned; `None` if there is nothing to turn.
fn turned(form: &Expression) -> Option<Expression> {
    let exponential = as_exponentials(form);
    let mut field = Field::of(&exponential);
    let terms = field.terms(&exponential)?;
    let decaying: Terms =
        terms.iter().map(|term| without_growth(&mut field, term)).collect::<Option<_>>()?;
    (decaying != terms).then(|| within(field.sum_of(&decaying), form))
}

/// cosh, sinh and powers of numbers that grow, by exponentials. sinh(u) = tanh(u) cosh(u) has all
/// its digits for a small u.
fn as_exponentials(form: &Expression) -> Expression {
    form.substitute(&|e| {
        let exponential = |u| Expression::call(Function::Exp, u);
        let grows = |u: &Expression| limit(u, Variable::SinceStart);
        match e.node() {
            Node::Call(function, u) => {
                let parity = function.hyperbolic()?;
                let Some(Limit::Infinite | Limit::MinusInfinite) = grows(u) else { return None };
                let u = as_exponentials(u);
                if !u.twice() {
                    return Some(Expression::call(*function, u));
                }
                let both = exponential(u.clone()).add(exponential(u.clone().neg()));
                let cosh = both.div(Expression::integer(2));
                Some(match parity {
                    Parity::Even => cosh,
                    Parity::Odd => Expression::call(Function::Tanh, u).mul(cosh),
                })
            }
            Node::Power(base, exponent) if !base.contains(Variable::SinceStart) => {
                let product = exponent.clone().mul(Expression::call(Function::Ln, base.clone()));
                (grows(&product) == Some(Limit::Infinite)).then(|| exponential(product))
            }
            _ => None,
        }
    })
}

/// The fraction, each factor of its denominator and each base of a root divided by what grows
/// fastest in it.
fn without_growth(field: &mut Field, term: &Ratio) -> Option<Ratio> {
    let mut roots = BTreeMap::new();
    let polys = std::iter::once(&term.num).chain(term.den.iter().map(|(factor, _)| factor));
    for symbol in polys.flat_map(Poly::symbols) {
        if let Some(Kernel::Root(base, index)) = field.kernel(symbol)
            && let Some(index) = index.number()
        {
            let (base, index) = (base.clone(), index.clone());
            roots.insert(symbol, root_without_growth(field, &base, index)?);
        }
    }
    let with_roots = |poly: &Poly| poly.substitute(|symbol| roots.get(&symbol).cloned());
    let mut result = Ratio::of(with_roots(&term.num));
    for (factor, count) in &term.den {
        let factor = with_roots(factor);
        let down = fastest(field, &factor)?.pow(-1);
        result.num = result.num.shifted(&down.pow(i32::try_from(*count).ok()?));
        result.den.push((factor.shifted(&down), *count));
    }
    Some(result)
}

/// (e^u b)^p as e^(p u) b^p.
fn root_without_growth(field: &mut Field, base: &Ratio, index: BigRational) -> Option<Poly> {
    let mut base = without_growth(field, base)?;
    let up = fastest(field, &base.num)?;
    base.num = base.num.shifted(&up.pow(-1));
    let mut product = Monomial::one();
    for (symbol, times) in up.factors() {
        let Some(Kernel::Exp(unit)) = field.kernel(*symbol) else { continue };
        let part = field.symbol(Kernel::Exp(unit.scaled(&index)))?;
        product = product.times(&Monomial::power(part, *times));
    }
    let root = field.symbol(Kernel::Root(base, Expression::from(index)))?;
    Some(Poly::term(integer(1), product.times(&Monomial::power(root, 1))))
}

/// The exponential that is a bound of all terms of `poly`, with factors. Where it depends on the
/// parameters which term grows fastest, the exponent is the greatest one.
fn fastest(field: &mut Field, poly: &Poly) -> Option<Monomial> {
    let is_bounded = |product: Monomial| {
        let limit = exponent(field, &product).map(|e| limit(&e, Variable::SinceStart));
        matches!(limit, Some(Some(Limit::Finite(_) | Limit::MinusInfinite)))
    };
    let is_exponential =
        |s: Symbol| matches!(field.kernel(s), Some(Kernel::Exp(_))) && moves(field, s);
    let mut ahead: Vec<Monomial> = Vec::new();
    for (monomial, _) in poly.terms() {
        let part = monomial.restrict(is_exponential);
        if !ahead.iter().any(|other| is_bounded(part.times(&other.pow(-1)))) {
            ahead.retain(|other| !is_bounded(other.times(&part.pow(-1))));
            ahead.push(part);
        }
    }
    if let [one] = &ahead[..] {
        return Some(one.clone());
    }
    // What they have in common stands before the greatest of the rest.
    let all = ahead.iter().map(|product| Poly::term(integer(1), product.clone()));
    let (_, common) = content(&all.fold(Poly::zero(), |sum, one| sum.plus(&one)));
    let rests = ahead.iter().map(|product| exponent(field, &product.times(&common.pow(-1))));
    let rests = rests.collect::<Option<Vec<_>>>()?;
    let greatest = rests.into_iter().reduce(Expression::max)?;
    let greatest = field.symbol(Kernel::Atom(greatest))?;
    let unit = Ratio::of(Poly::term(integer(1), Monomial::power(greatest, 1)));
    Some(common.times(&Monomial::power(field.symbol(Kernel::Exp(unit))?, 1)))
}

/// The exponent of a product of exponentials.
fn exponent(field: &Field, product: &Monomial) -> Option<Expression> {
    let exponents = product.factors().iter().filter_map(|(symbol, times)| {
        let Some(Kernel::Exp(unit)) = field.kernel(*symbol) else { return None };
        Some(unit.scaled(&integer(i64::from(*times))))
    });
    // What cannot be added within the bounds of the field stands side by side.
    let terms = exponents.fold(Terms::new(), |terms, part| {
        sum(terms.clone(), vec![part.clone()]).unwrap_or_else(|| [terms, vec![part]].concat())
    });
    field.sum_of(&terms)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::normal::complement;
    use crate::expression::testing::{evaluate, mu};

    const FORMS: [(&str, &str); 11] = [
        ("tanh", "2*tau*exp(-2*a*t)/(1 + exp(-2*a*t))"),
        (
            "tau*tanh(t)*tanh(a*t)",
            "2*tau*(exp(-2*a*t) + exp(-2*t))/((1 + exp(-2*a*t))*(1 + exp(-2*t)))",
        ),
        ("tau*(1 - 1/cosh(t))", "2*tau*exp(-t)/(1 + exp(-2*t))"),
        ("2*tau*atan(sinh(t))/pi", "2*tau*atan(2*exp(-t)/(tanh(t)*(1 + exp(-2*t))))/pi"),
        ("tau*(1 - 1/(1 + exp(t) + exp(3*t/10)))", "tau*exp(-t)/(1 + exp(-t) + exp(-7*t/10))"),
        (
            "tau*(1 - 1/(1 + exp(a*t) + exp(m*t)))",
            "tau*exp(-max(a*t, m*t))/(exp(a*t - max(a*t, m*t)) + exp(m*t - max(a*t, m*t)) \
             + exp(-max(a*t, m*t)))",
        ),
        ("tau*(1 - 2/(1 + exp(t^2 - 3*t)))", "2*tau*exp(t*(3 - t))/(1 + exp(t*(3 - t)))"),
        ("tau*(1 - 2/(1 + 2^(t/a)))", "2*tau*exp(-t*ln(2)/a)/(1 + exp(-t*ln(2)/a))"),
        (
            "tau*(1 - (1 + sinh(a*t))^(-1/2))",
            "tau*exp(-a*t/2)/sqrt((tanh(a*t) + tanh(a*t)*exp(-2*a*t) + 2*exp(-a*t))/2)",
        ),
        ("exp", "tau*exp(-a*t)"),
        ("tau*cosh(t)*(1 - exp(-a*t))", "tau*(1 + cosh(t)*exp(-a*t) - cosh(t))"),
    ];

    #[test]
    fn exponentials_decay() {
        for (text, form) in FORMS {
            let given = complement(&mu(text));
            let found = decaying(&given);
            assert_eq!(found.to_string(), form, "{text}");
            for t in [0.02, 0.7, 3.0, 11.0] {
                let (got, truth) = (evaluate(&found, t), evaluate(&given, t));
                assert!((got - truth).abs() <= 1e-13 * truth.abs(), "{text}: {got} for {truth}");
            }
        }
    }

    #[test]
    fn derivatives_are_finite_far_out() {
        for (text, _) in &FORMS[..10] {
            let slope = decaying(&complement(&mu(text))).derivative(Variable::SinceStart);
            for t in [1e3, 1e6, 1e9] {
                assert!(evaluate(&slope, t).abs() < 1e-99, "{text} at {t}");
            }
        }
    }
}
