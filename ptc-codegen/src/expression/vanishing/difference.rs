//! Differences of a function at two arguments, by the difference of the arguments.

use num_traits::ToPrimitive;

use super::Forms;
use crate::algebra::BigRational;
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Node};

/// Exponents, and indices of roots, of which a difference is a sum of products.
const FACTORED: i64 = 6;

impl Forms {
    pub(super) fn difference_of(&mut self, e: &Expression) -> Option<Expression> {
        match e.node() {
            Node::Neg(a) => Some(self.difference(a)?.neg()),
            Node::Add(a, b) => Some(self.difference(a)?.add(self.difference(b)?)),
            Node::Sub(a, b) => Some(self.difference(a)?.sub(self.difference(b)?)),
            Node::Mul(a, b) => {
                // a b - a0 b0 = (a - a0) b + a0 (b - b0).
                let (end_a, end_b) = (self.ends.value(a)?, self.ends.value(b)?);
                if end_b.is(0) {
                    return Some(self.kept(a).mul(self.difference(b)?));
                }
                let first = self.difference(a)?.mul(self.kept(b));
                Some(first.add(end_a.mul(self.difference(b)?)))
            }
            Node::Div(a, b) => {
                // a/b - a0/b0 = (a - a0 - (a0/b0) (b - b0))/b.
                let (end_a, end) = (self.ends.value(a)?, self.ends.value(e)?);
                let rest = match end_a.is(0) {
                    true => Expression::integer(0),
                    false => end.mul(self.difference(b)?),
                };
                Some(self.difference(a)?.sub(rest).div(self.kept(b)))
            }
            Node::Power(a, b) => self.difference_of_power(a, b),
            Node::Call(function, a) => self.difference_of_call(*function, a),
            _ => None,
        }
    }

    fn difference_of_power(&mut self, a: &Expression, b: &Expression) -> Option<Expression> {
        let (end_a, end_b) = (self.ends.value(a)?, self.ends.value(b)?);
        if self.ends.moves(b) {
            let exponent = b.clone().mul(Expression::call(Function::Ln, a.clone()));
            return (!self.ends.moves(a))
                .then(|| self.difference_of_call(Function::Exp, &exponent))?;
        }
        let gap = self.difference(a)?;
        let kept = self.kept(a);
        if let Some(power) = end_b.number() {
            let (over, under) = (power.numer().to_i64()?, power.denom().to_i64()?);
            if over.abs() <= FACTORED && under <= FACTORED {
                return Some(factored(&gap, [&kept, &end_a], [over, under]));
            }
        }
        // a^p - a0^p = 2 (a a0)^(p/2) sinh(p/2 ln(a/a0)), ln(a/a0) = 2 atanh((a - a0)/(a + a0)).
        let half = end_b.clone().div(Expression::integer(2));
        let angle = Expression::call(Function::Atanh, gap.div(kept.clone().add(end_a.clone())));
        let sinh = Expression::call(Function::Sinh, end_b.mul(angle));
        let mean = kept.mul(end_a).power(half);
        Some(Expression::integer(2).mul(mean).mul(sinh))
    }

    fn difference_of_call(&mut self, function: Function, a: &Expression) -> Option<Expression> {
        use Function as F;
        let end = self.ends.value(a)?;
        let kept = self.kept(a);
        let gap = self.difference(a)?;
        let (one, two) = (Expression::integer(1), Expression::integer(2));
        let half = gap.clone().div(two.clone());
        let mean = kept.clone().add(end.clone()).div(two.clone());
        let both = |outer, inner| {
            let outer = Expression::call(outer, mean.clone());
            two.clone().mul(outer).mul(Expression::call(inner, half.clone()))
        };
        Some(match function {
            F::Exp => both(F::Exp, F::Sinh),
            F::Sin => both(F::Cos, F::Sin),
            F::Cos => both(F::Sin, F::Sin).neg(),
            F::Sinh => both(F::Cosh, F::Sinh),
            F::Cosh => both(F::Sinh, F::Sinh),
            F::Sqrt => factored(&gap, [&kept, &end], [1, 2]),
            // 2 atanh((a - a0)/(a + a0)).
            F::Ln => two.mul(Expression::call(F::Atanh, gap.div(kept.add(end)))),
            F::Tan => {
                let cosines = Expression::call(F::Cos, kept).mul(Expression::call(F::Cos, end));
                Expression::call(F::Sin, gap).div(cosines)
            }
            F::Tanh => {
                let product = Expression::call(F::Tanh, kept).mul(Expression::call(F::Tanh, end));
                Expression::call(F::Tanh, gap).mul(one.sub(product))
            }
            F::Atanh => Expression::call(F::Atanh, gap.div(one.sub(kept.mul(end)))),
            F::Cbrt => {
                let [root, root_end] = [kept, end].map(|a| Expression::call(F::Cbrt, a));
                let under = sum_of_products([&root, &root_end], 3);
                gap.div(under)
            }
            F::Abs | F::Sign | F::Atan | F::Asin | F::Acos => return None,
        })
    }
}

/// a^(k/q) - b^(k/q) by A = a^(1/q), B = b^(1/q): A^k - B^k = (a - b)/(A^(q-1) + .. + B^(q-1)) (A^(k-1) + .. + B^(k-1)).
fn factored(gap: &Expression, [a, b]: [&Expression; 2], [k, q]: [i64; 2]) -> Expression {
    let root = |a: &Expression| match q {
        1 => a.clone(),
        2 => Expression::call(Function::Sqrt, a.clone()),
        _ => a.clone().power(Expression::from(BigRational::new(1.into(), q.into()))),
    };
    let roots = [root(a), normal(&root(b))];
    let roots = [&roots[0], &roots[1]];
    let quotient = match q {
        1 => gap.clone(),
        _ => gap.clone().div(sum_of_products(roots, q)),
    };
    let whole = quotient.mul(sum_of_products(roots, k.abs()));
    match k.is_negative() {
        false => whole,
        // 1/A^k - 1/B^k = -(A^k - B^k)/(A B)^k.
        true => {
            whole.neg().div(roots[0].clone().mul(roots[1].clone()).power(Expression::integer(-k)))
        }
    }
}

/// a^(k-1) + a^(k-2) b + .. + b^(k-1).
fn sum_of_products([a, b]: [&Expression; 2], k: i64) -> Expression {
    let power = |base: &Expression, k| base.clone().power(Expression::integer(k));
    let terms = (0..k).map(|j| power(a, k - 1 - j).mul(power(b, j)));
    terms.reduce(Expression::add).unwrap_or_else(|| Expression::integer(0))
}
