//! Signs of expressions, from the signs of their parts.

use num_traits::Signed;

use super::effort::bounded;
use super::field::{Field, Kernel};
use super::function::Signs;
use super::ratio::Ratio;
use super::{Expression, Function, Node};
use crate::algebra::{Monomial, Poly, Symbol, integer};
use crate::limits::{CALLS, LIFTED};

/// Known sign of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    /// < 0.
    Negative,
    /// <= 0.
    NotPositive,
    /// 0.
    Zero,
    /// >= 0.
    NotNegative,
    /// > 0.
    Positive,
}

use Sign::{Negative, NotNegative, NotPositive, Positive, Zero};

impl Sign {
    fn neg(self) -> Self {
        match self {
            Negative => Positive,
            NotPositive => NotNegative,
            Zero => Zero,
            NotNegative => NotPositive,
            Positive => Negative,
        }
    }

    fn times(self, other: Self) -> Self {
        match (self, other) {
            (Zero, _) | (_, Zero) => Zero,
            (Positive, sign) | (sign, Positive) => sign,
            (Negative, sign) | (sign, Negative) => sign.neg(),
            (a, b) if a == b => NotNegative,
            _ => NotPositive,
        }
    }

    fn plus(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Zero, sign) | (sign, Zero) => Some(sign),
            (Positive, Positive | NotNegative) | (NotNegative, Positive) => Some(Positive),
            (Negative, Negative | NotPositive) | (NotPositive, Negative) => Some(Negative),
            (a, b) if a == b => Some(a),
            _ => None,
        }
    }
}

/// The sign of a name; `None` if it may be any.
pub(crate) type Names<'a> = &'a dyn Fn(&Expression) -> Option<Sign>;

/// The signs where every parameter is positive and nothing is known of the variables.
pub(crate) fn positive_parameters(name: &Expression) -> Option<Sign> {
    matches!(name.node(), Node::Parameter(_)).then_some(Positive)
}

/// The sign of an expression; `None` if it is not found.
pub(crate) fn sign(expression: &Expression, names: Names<'_>) -> Option<Sign> {
    bounded(|| of(expression, Context { names, depth: CALLS.size() }))
}

/// The signs of names, and how many calls within calls are looked into.
#[derive(Clone, Copy)]
struct Context<'a> {
    names: Names<'a>,
    depth: usize,
}

fn of(expression: &Expression, known: Context<'_>) -> Option<Sign> {
    let known = Context { depth: known.depth.checked_sub(1)?, ..known };
    let mut field = Field::default();
    let terms = field.terms(expression)?;
    let apart = terms.iter().try_fold(Zero, |sum, term| sum.plus(of_ratio(&field, term, known)?));
    apart.or_else(|| of_ratio(&field, &Field::combined(&terms)?, known))
}

fn of_ratio(field: &Field, ratio: &Ratio, known: Context<'_>) -> Option<Sign> {
    let mut sign = of_poly(field, &ratio.num, known)?;
    for (factor, count) in &ratio.den {
        match of_poly(field, factor, known)? {
            Positive => {}
            Negative if count % 2 == 0 => {}
            Negative => sign = sign.neg(),
            _ => return None,
        }
    }
    Some(sign)
}

fn of_poly(field: &Field, poly: &Poly, known: Context<'_>) -> Option<Sign> {
    let term = |m: &Monomial, negative: bool| {
        let product = m.factors().iter().try_fold(Positive, |product, (symbol, exponent)| {
            let mut sign = of_kernel(field, *symbol, known);
            if exponent % 2 == 0 {
                sign = match sign {
                    Some(Positive | Negative) => Some(Positive),
                    Some(Zero) => Some(Zero),
                    _ => Some(NotNegative),
                };
            }
            // The reciprocal of what may be 0 has the sign, and is not 0, where it exists.
            let sign = match (sign?, *exponent < 0) {
                (Zero, true) => return None,
                (NotNegative, true) => Positive,
                (NotPositive, true) => Negative,
                (sign, _) => sign,
            };
            Some(product.times(sign))
        })?;
        Some(if negative { product.neg() } else { product })
    };
    let direct = poly.terms().try_fold(Zero, |sum, (m, c)| sum.plus(term(m, c.is_negative())?));
    direct.or_else(|| {
        let known = Context { depth: known.depth.checked_sub(2)?, ..known };
        above_one(field, poly, known)
    })
}

/// With e^u for u >= 0 written as 1 + h, h >= 0: a polynomial whose terms then have one sign.
fn above_one(field: &Field, poly: &Poly, known: Context<'_>) -> Option<Sign> {
    let symbols = poly.symbols();
    let grows = |symbol: &&Symbol| match field.kernel(**symbol) {
        Some(Kernel::Exp(unit)) => {
            matches!(of_ratio(field, unit, known), Some(Positive | NotNegative | Zero))
        }
        _ => false,
    };
    let growing = symbols.iter().find(grows)?;
    let least = poly.terms().map(|(m, _)| m.exponent(*growing)).min()?;
    let lifted = poly.shifted(&Monomial::power(*growing, -least));
    let greatest = lifted.terms().map(|(m, _)| m.exponent(*growing)).max()?;
    if !LIFTED.admits(usize::try_from(greatest).ok()?) {
        return None;
    }
    // h may be 0: terms without it decide whether the sum can be 0.
    let above = Poly::one().plus(&Poly::symbol(*growing));
    let in_h = lifted.substitute(|s| (s == *growing).then(|| above.clone()));
    let by_power = in_h.collect(*growing);
    let mut total = Zero;
    for (power, coefficient) in by_power {
        let own = of_poly(field, &coefficient, known)?;
        total = total.plus(if power == 0 { own } else { own.times(NotNegative) })?;
    }
    Some(total)
}

fn of_kernel(field: &Field, symbol: Symbol, known: Context<'_>) -> Option<Sign> {
    match field.kernel(symbol)? {
        Kernel::Exp(_) => Some(Positive),
        Kernel::Atom(atom) => match atom.node() {
            Node::Pi => Some(Positive),
            Node::Call(function, a) => of_call(*function, a, known),
            _ => of_atom(atom, known),
        },
        Kernel::Root(base, index) => match of_ratio(field, base, known)? {
            Positive => Some(Positive),
            Zero | NotNegative if index.number().is_some() => Some(NotNegative),
            sign if *index == Expression::integer(1) => Some(sign),
            _ => None,
        },
    }
}

fn of_atom(atom: &Expression, known: Context<'_>) -> Option<Sign> {
    let (Node::Min(a, b) | Node::Max(a, b)) = atom.node() else {
        return (known.names)(atom);
    };
    let greater = match of(&a.clone().sub(b.clone()), known) {
        Some(Positive | NotNegative | Zero) => true,
        Some(_) => false,
        None => {
            let both = [of(a, known)?, of(b, known)?];
            return (both[0] == both[1]).then_some(both[0]);
        }
    };
    of(if greater == matches!(atom.node(), Node::Max(..)) { a } else { b }, known)
}

fn of_call(function: Function, a: &Expression, known: Context<'_>) -> Option<Sign> {
    // Whether the argument is between -pi/part and pi/part.
    let is_within = |part: i64| {
        let bound = Expression::pi().div(Expression::integer(part));
        of(&bound.clone().sub(a.clone()), known) == Some(Positive)
            && of(&bound.add(a.clone()), known) == Some(Positive)
    };
    match function.row().signs {
        Signs::Positive => Some(Positive),
        Signs::NeverNegative => Some(NotNegative),
        Signs::Size => match of(a, known) {
            Some(Positive | Negative) => Some(Positive),
            _ => Some(NotNegative),
        },
        Signs::Argument => of(a, known),
        Signs::ArgumentLessOne if of(a, known) != Some(Positive) => None,
        Signs::ArgumentLessOne => of(&a.clone().sub(Expression::from(integer(1))), known),
        Signs::NotNegative => of(a, known).filter(|sign| !matches!(sign, Negative | NotPositive)),
        Signs::ArgumentWithin(part) => is_within(part).then(|| of(a, known))?,
        Signs::PositiveWithin(part) => is_within(part).then_some(Positive),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::testing::{evaluate, mu, random};

    fn all_positive(name: &Expression) -> Option<Sign> {
        matches!(name.node(), Node::Parameter(_) | Node::Variable(_)).then_some(Positive)
    }

    #[test]
    fn signs_of_expressions_are_found() {
        for (text, expected) in [
            ("a/(1 + t) + exp(-t)", Some(Positive)),
            ("1.5*exp(t) - 1", Some(Positive)),
            ("a - t", None),
            ("-t^2 - ln(1 + t)", Some(Negative)),
            ("tan(pi*t/(2*(t + a))) + min(t, 2*t)", Some(Positive)),
            ("t - (t + a) + a", Some(Zero)),
        ] {
            assert_eq!(sign(&mu(text), &all_positive), expected, "{text}");
        }
    }

    #[test]
    fn sign_holds_for_every_value() {
        let mut seed = 3;
        for _ in 0..5000 {
            let e = random(&mut seed, 4);
            let Some(found) = sign(&e, &all_positive) else { continue };
            for value in [0.37, 1.9].map(|t| evaluate(&e, t)).into_iter().filter(|v| v.is_finite())
            {
                let slack = 1e-9;
                let fits = match found {
                    Positive | NotNegative => value > -slack,
                    Negative | NotPositive => value < slack,
                    Zero => value.abs() < slack,
                };
                assert!(fits, "{e}: {value}, {found:?}");
            }
        }
    }
}
