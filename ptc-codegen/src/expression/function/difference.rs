//! Differences of functions and powers at two arguments, formed from the difference of the arguments: they keep their
//! digits where the arguments meet.

use num_traits::{Signed, ToPrimitive};

use super::Function;
use crate::algebra::BigRational;
use crate::expression::Expression;
use crate::expression::normal::normal;

/// Largest numerator and denominator of an exponent whose difference is a sum of products.
const FACTORED: i64 = 6;

/// Two arguments a and b, and a - b.
pub(crate) struct Arguments {
    pub(crate) a: Expression,
    pub(crate) b: Expression,
    pub(crate) gap: Expression,
}

impl Function {
    /// Returns f(a) - f(b); `None` where no such form is known.
    pub(crate) fn difference(self, of: Arguments) -> Option<Expression> {
        let (one, two) = (Expression::integer(1), Expression::integer(2));
        let half = || of.gap.clone().div(two.clone());
        let mean = || of.a.clone().add(of.b.clone()).div(two.clone());
        let both = |outer, inner| {
            two.clone().mul(Expression::call(outer, mean())).mul(Expression::call(inner, half()))
        };
        let pair = |function| [&of.a, &of.b].map(|a| Expression::call(function, a.clone()));
        Some(match self {
            Self::Exp => both(Self::Exp, Self::Sinh),
            Self::Sin => both(Self::Cos, Self::Sin),
            Self::Cos => both(Self::Sin, Self::Sin).neg(),
            Self::Sinh => both(Self::Cosh, Self::Sinh),
            Self::Cosh => both(Self::Sinh, Self::Sinh),
            Self::Sqrt => by_roots(&of, 1, 2),
            Self::Ln => two.mul(half_logarithm(&of)),
            Self::Tan => {
                let [a, b] = pair(Self::Cos);
                Expression::call(Self::Sin, of.gap).div(a.mul(b))
            }
            Self::Tanh => {
                let [a, b] = pair(Self::Tanh);
                Expression::call(Self::Tanh, of.gap).mul(one.sub(a.mul(b)))
            }
            Self::Atanh => Expression::call(Self::Atanh, of.gap.div(one.sub(of.a.mul(of.b)))),
            Self::Cbrt => {
                let [a, b] = pair(Self::Cbrt);
                of.gap.div(sum_of_products([&a, &b], 3))
            }
            Self::Abs | Self::Sign | Self::Atan | Self::Asin | Self::Acos => return None,
        })
    }
}

/// Returns a^p - b^p of positive a and b.
pub(crate) fn difference_of_powers(of: &Arguments, p: &Expression) -> Expression {
    let small = p.number().and_then(|p| Some((p.numer().to_i64()?, p.denom().to_i64()?)));
    if let Some((k, q)) = small.filter(|(k, q)| k.abs() <= FACTORED && *q <= FACTORED) {
        return by_roots(of, k, q);
    }
    // 2 (a b)^(p/2) sinh(p/2 ln(a/b)).
    let two = Expression::integer(2);
    let sinh = Expression::call(Function::Sinh, p.clone().mul(half_logarithm(of)));
    let mean = of.a.clone().mul(of.b.clone()).power(p.clone().div(two.clone()));
    two.mul(mean).mul(sinh)
}

/// ln(a/b)/2 = atanh((a - b)/(a + b)).
fn half_logarithm(Arguments { a, b, gap }: &Arguments) -> Expression {
    Expression::call(Function::Atanh, gap.clone().div(a.clone().add(b.clone())))
}

/// a^(k/q) - b^(k/q) by A = a^(1/q) and B = b^(1/q): A^k - B^k is (A - B) (A^(k-1) + .. + B^(k-1)), and A - B the same
/// for a - b.
fn by_roots(Arguments { a, b, gap }: &Arguments, k: i64, q: i64) -> Expression {
    let root = |a: &Expression| match q {
        1 => a.clone(),
        2 => Expression::call(Function::Sqrt, a.clone()),
        _ => a.clone().power(Expression::from(BigRational::new(1.into(), q.into()))),
    };
    let roots = [&root(a), &normal(&root(b))];
    let quotient = match q {
        1 => gap.clone(),
        _ => gap.clone().div(sum_of_products(roots, q)),
    };
    let whole = quotient.mul(sum_of_products(roots, k.abs()));
    match k.is_negative() {
        false => whole,
        // 1/A^k - 1/B^k is -(A^k - B^k)/(A B)^k.
        true => {
            let product = roots[0].clone().mul(roots[1].clone());
            whole.neg().div(product.power(Expression::integer(-k)))
        }
    }
}

/// a^(k-1) + a^(k-2) b + .. + b^(k-1).
fn sum_of_products([a, b]: [&Expression; 2], k: i64) -> Expression {
    let power = |base: &Expression, k| base.clone().power(Expression::integer(k));
    let terms = (0..k).map(|j| power(a, k - 1 - j).mul(power(b, j)));
    terms.reduce(Expression::add).unwrap_or_else(|| Expression::integer(0))
}
