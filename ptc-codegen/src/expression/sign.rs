//! Signs of expressions, from the signs of what stands in them.

use num_traits::Signed;

use super::field::{Field, Kernel};
use super::ratio::Ratio;
use super::{Expression, Function};
use crate::algebra::{Monomial, Poly, Symbol, integer};

/// What is known of a sign.
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

/// The sign of a name; none where it may be any.
pub(crate) type Names<'a> = &'a dyn Fn(&Expression) -> Option<Sign>;

/// The signs where every parameter is positive and nothing is known of the variables.
pub(crate) fn positive_parameters(name: &Expression) -> Option<Sign> {
    matches!(name, Expression::Parameter(_)).then_some(Positive)
}

/// The sign of an expression; none where it is not found.
pub(crate) fn sign(expression: &Expression, names: Names<'_>) -> Option<Sign> {
    let mut field = Field::default();
    let terms = field.terms(expression)?;
    let apart = terms.iter().try_fold(Zero, |sum, term| sum.plus(of_ratio(&field, term, names)?));
    apart.or_else(|| of_ratio(&field, &Field::combined(&terms)?, names))
}

fn of_ratio(field: &Field, ratio: &Ratio, names: Names<'_>) -> Option<Sign> {
    let mut sign = of_poly(field, &ratio.num, names)?;
    for (factor, count) in &ratio.den {
        match of_poly(field, factor, names)? {
            Positive => {}
            Negative if count % 2 == 0 => {}
            Negative => sign = sign.neg(),
            _ => return None,
        }
    }
    Some(sign)
}

fn of_poly(field: &Field, poly: &Poly, names: Names<'_>) -> Option<Sign> {
    let term = |m: &Monomial, negative: bool| {
        let product = m.factors().iter().try_fold(Positive, |product, (symbol, exponent)| {
            let mut sign = of_kernel(field, *symbol, names);
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
    direct.or_else(|| above_one(field, poly, names))
}

/// With e^u for u >= 0 written as 1 + h, h >= 0: a polynomial whose terms then have one sign.
fn above_one(field: &Field, poly: &Poly, names: Names<'_>) -> Option<Sign> {
    let symbols = poly.symbols();
    let grows = |symbol: &&Symbol| match field.kernel(**symbol) {
        Some(Kernel::Exp(unit)) => {
            matches!(of_ratio(field, unit, names), Some(Positive | NotNegative | Zero))
        }
        _ => false,
    };
    let growing = symbols.iter().find(grows)?;
    let least = poly.terms().map(|(m, _)| m.exponent(*growing)).min()?;
    let lifted = poly.shifted(&Monomial::power(*growing, -least));
    let greatest = lifted.terms().map(|(m, _)| m.exponent(*growing)).max()?;
    if greatest > 16 {
        return None;
    }
    // h may be 0: terms without it decide whether the sum can be 0.
    let above = Poly::one().plus(&Poly::symbol(*growing));
    let in_h = lifted.substitute(|s| (s == *growing).then(|| above.clone()));
    let by_power = in_h.collect(*growing);
    let mut total = Zero;
    for (power, coefficient) in by_power {
        let own = of_poly(field, &coefficient, names)?;
        total = total.plus(if power == 0 { own } else { own.times(NotNegative) })?;
    }
    Some(total)
}

fn of_kernel(field: &Field, symbol: Symbol, names: Names<'_>) -> Option<Sign> {
    match field.kernel(symbol)? {
        Kernel::Atom(Expression::Pi) | Kernel::Exp(_) => Some(Positive),
        Kernel::Atom(Expression::Call(function, a)) => of_call(*function, a, names),
        Kernel::Atom(atom) => names(atom),
        Kernel::Root(base, index) => match of_ratio(field, base, names)? {
            Positive => Some(Positive),
            Zero | NotNegative if index.number().is_some() => Some(NotNegative),
            sign if *index == Expression::integer(1) => Some(sign),
            _ => None,
        },
    }
}

fn of_call(function: Function, a: &Expression, names: Names<'_>) -> Option<Sign> {
    match function {
        Function::Exp | Function::Cosh => Some(Positive),
        Function::Abs => match sign(a, names) {
            Some(Positive | Negative) => Some(Positive),
            _ => Some(NotNegative),
        },
        Function::Ln => sign(&a.clone().sub(Expression::Number(integer(1))), names),
        Function::Sign
        | Function::Sqrt
        | Function::Sinh
        | Function::Tanh
        | Function::Atan
        | Function::Atanh => sign(a, names),
        Function::Sin | Function::Cos | Function::Tan => None,
    }
}
