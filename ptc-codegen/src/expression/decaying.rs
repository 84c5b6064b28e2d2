//! Forms without large exponentials: 2/(1 + e^u) is 2 e^-u/(1 + e^-u), of which no part leaves the
//! range of numbers as u grows, and no derivative is infinity times 0.

use super::field::{Field, Kernel, sum};
use super::leading::{Limit, limit};
use super::normal::{moves, within};
use super::ratio::Ratio;
use super::{Expression, Function, Variable};
use crate::algebra::{Monomial, Poly, Symbol, integer};

/// The same function of t, stretched time since the start, with denominators in which no exponential
/// grows with it. Parameters are taken as positive.
pub(crate) fn decaying(form: &Expression) -> Expression {
    let inner = |e: &Expression| match e {
        Expression::Call(function, a) => Some(Expression::call(*function, decaying(a))),
        Expression::Power(a, b) => Some(decaying(a).power(decaying(b))),
        _ => None,
    };
    turned(form).unwrap_or_else(|| form.clone()).substitute(&inner)
}

/// The form with its outermost denominators turned; none where there is nothing to turn.
fn turned(form: &Expression) -> Option<Expression> {
    let exponential = as_exponentials(form);
    let mut field = Field::of(&exponential);
    let terms = field.terms(&exponential)?;
    let decaying: Vec<_> =
        terms.iter().map(|term| without_growth(&field, term)).collect::<Option<_>>()?;
    let found = (decaying != terms).then(|| field.sum_of(&decaying));
    found.map(|found| within(Some(found), form))
}

/// cosh, sinh and powers of numbers that grow, by exponentials. sinh(u) = tanh(u) cosh(u) has all
/// its digits for a small u.
fn as_exponentials(form: &Expression) -> Expression {
    form.substitute(&|e| {
        let exponential = |u| Expression::call(Function::Exp, u);
        let grows = |u: &Expression| limit(u, Variable::SinceStart);
        match e {
            Expression::Call(function @ (Function::Cosh | Function::Sinh), u) => {
                let Some(Limit::Infinite | Limit::MinusInfinite) = grows(u) else { return None };
                let u = as_exponentials(u);
                let both = exponential(u.clone()).add(exponential(u.clone().neg()));
                let cosh = both.div(Expression::integer(2));
                let is_cosh = *function == Function::Cosh;
                Some(if is_cosh { cosh } else { Expression::call(Function::Tanh, u).mul(cosh) })
            }
            Expression::Power(base, exponent) if !base.contains(Variable::SinceStart) => {
                let product =
                    exponent.as_ref().clone().mul(Expression::call(Function::Ln, (**base).clone()));
                (grows(&product) == Some(Limit::Infinite)).then(|| exponential(product))
            }
            _ => None,
        }
    })
}

/// The fraction, each factor of its denominator divided by its part that grows fastest.
fn without_growth(field: &Field, term: &Ratio) -> Option<Ratio> {
    let mut result = Ratio::of(term.num.clone());
    for (factor, count) in &term.den {
        let down = fastest(field, factor).pow(-1);
        result.num = result.num.shifted(&down.pow(i32::try_from(*count).ok()?));
        result.den.push((factor.shifted(&down), *count));
    }
    Some(result)
}

/// The product of exponentials that all terms of `poly` have as a bound. Where it depends on the
/// parameters which term grows fastest, it is that of all that grow.
fn fastest(field: &Field, poly: &Poly) -> Monomial {
    let is_exponential =
        |s: Symbol| matches!(field.kernel(s), Some(Kernel::Exp(_))) && moves(field, s);
    let parts: Vec<_> = poly.terms().map(|(m, _)| m.restrict(is_exponential)).collect();
    let bounds = |part: &&Monomial| {
        parts.iter().all(|other| {
            let rest = tends(field, &other.times(&part.pow(-1)));
            matches!(rest, Some(Limit::Finite(_) | Limit::MinusInfinite))
        })
    };
    if let Some(found) = parts.iter().find(bounds) {
        return found.clone();
    }
    let greatest = |s: Symbol| poly.terms().map(|(m, _)| m.exponent(s)).max().unwrap_or(0);
    let growing = poly.symbols().into_iter().filter(|s| is_exponential(*s)).filter(|s| {
        tends(field, &Monomial::power(*s, 1)) == Some(Limit::Infinite)
    });
    growing.fold(Monomial::one(), |all, s| all.times(&Monomial::power(s, greatest(s))))
}

/// The limit of the exponent of a product of exponentials.
fn tends(field: &Field, product: &Monomial) -> Option<Limit> {
    let exponents = product.factors().iter().filter_map(|(symbol, times)| {
        let Some(Kernel::Exp(unit)) = field.kernel(*symbol) else { return None };
        Some(vec![unit.scaled(&integer(i64::from(*times)))])
    });
    let exponent = exponents.map(Some).reduce(|a, b| sum(a?, b?)).flatten().unwrap_or_default();
    limit(&field.sum_of(&exponent), Variable::SinceStart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::normal::complement;
    use crate::expression::testing::{evaluate, mu};

    #[test]
    fn exponentials_decay() {
        for (text, form) in [
            ("tanh", "2*tau*exp(-2*a*t)/(1 + exp(-2*a*t))"),
            ("tau*tanh(t)*tanh(a*t)", ""),
            ("tau*(1 - 1/cosh(t))", ""),
            ("2*tau*atan(sinh(t))/pi", ""),
            ("tau*(1 - 1/(1 + exp(t) + exp(3*t/10)))", ""),
            ("tau*(1 - 1/(1 + exp(a*t) + exp(b*t)))", ""),
            ("tau*(1 - 2/(1 + exp(t^2 - 3*t)))", ""),
            ("tau*(1 - 2/(1 + 2^(t/a)))", ""),
            ("exp", "tau*exp(-a*t)"),
        ] {
            let form_found = decaying(&complement(&mu(text))).to_string();
            assert_eq!(form_found, form, "{text}");
        }
    }
}
