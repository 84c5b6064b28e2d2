//! Truncated Taylor series with long coefficients, and expressions as such series.

use astro_float_num::BigFloat;

use super::long::{Arithmetic, is_finite, raised};
use crate::expression::function::Slope;
use crate::expression::{Expression, Function, Node, Variable};
use crate::parameter::Parameter;

/// Coefficients of 1, z, z^2, ... up to a common order.
pub(super) type Series = Vec<BigFloat>;

/// Arithmetic of series, each of as many coefficients as its operands.
impl Arithmetic {
    /// A constant.
    pub(super) fn constant(&self, value: BigFloat, length: usize) -> Series {
        let mut series = vec![self.integer(0); length];
        series[0] = value;
        series
    }

    fn each(&self, a: &Series, b: &Series, f: impl Fn(&BigFloat, &BigFloat) -> BigFloat) -> Series {
        a.iter().zip(b).map(|(a, b)| f(a, b)).collect()
    }

    /// sum_{j = from..=k} weight(j) a_j b_{k-j}.
    fn convolved(
        &self,
        a: &Series,
        b: &Series,
        k: usize,
        from: usize,
        weight: impl Fn(usize) -> BigFloat,
    ) -> BigFloat {
        (from..=k).fold(self.integer(0), |sum, j| {
            self.add(&sum, &self.mul(&weight(j), &self.mul(&a[j], &b[k - j])))
        })
    }

    /// a b.
    pub(super) fn product(&self, a: &Series, b: &Series) -> Series {
        (0..a.len()).map(|k| self.convolved(a, b, k, 0, |_| self.integer(1))).collect()
    }

    /// a / b, from b q = a.
    fn quotient(&self, a: &Series, b: &Series) -> Series {
        let mut q: Series = Vec::with_capacity(a.len());
        for k in 0..a.len() {
            let known =
                (1..=k).fold(a[k].clone(), |rest, j| self.sub(&rest, &self.mul(&b[j], &q[k - j])));
            q.push(self.div(&known, &b[0]));
        }
        q
    }

    /// The series f with f' = a' g and f_0 = `first`, where g may depend on the part of f that is
    /// known: `g` gives its coefficient k - 1 when f_0..f_{k-1} are there.
    fn integrated(
        &self,
        a: &Series,
        first: BigFloat,
        mut g: impl FnMut(&Series, usize) -> BigFloat,
    ) -> Series {
        let mut f = vec![first];
        let mut slope = Vec::new();
        for k in 1..a.len() {
            slope.push(g(&f, k - 1));
            let sum = (1..=k).fold(self.integer(0), |sum, j| {
                let weight = self.mul(&self.small(j), &a[j]);
                self.add(&sum, &self.mul(&weight, &slope[k - j]))
            });
            f.push(self.div(&sum, &self.small(k)));
        }
        f
    }

    fn small(&self, value: usize) -> BigFloat {
        self.integer(i64::try_from(value).unwrap_or(i64::MAX))
    }

    /// f with f' = s a' g and g' = r a' f, from the values of f and g at a_0 and the signs s and r.
    fn oscillation(&self, a: &Series, first: [BigFloat; 2], signs: [i8; 2]) -> Series {
        let [mut f, mut g] = first.map(|value| vec![value]);
        for k in 1..a.len() {
            let sum = |other: &Series, sign: i8| {
                let sum = (1..=k).fold(self.integer(0), |sum, j| {
                    let weight = self.mul(&self.small(j), &a[j]);
                    self.add(&sum, &self.mul(&weight, &other[k - j]))
                });
                self.div(&self.mul(&self.integer(sign.into()), &sum), &self.small(k))
            };
            let (f_k, g_k) = (sum(&g, signs[0]), sum(&f, signs[1]));
            f.push(f_k);
            g.push(g_k);
        }
        f
    }

    fn whole_power(&self, a: &Series, k: i32) -> Series {
        let one = self.constant(self.integer(1), a.len());
        let power = raised(one.clone(), a, k.unsigned_abs(), |a, b| self.product(a, b));
        if k < 0 { self.quotient(&one, &power) } else { power }
    }

    /// a^b for a constant b and positive a_0, from a (a^b)' = b a' a^b.
    fn constant_power(&mut self, a: &Series, b: &BigFloat) -> Series {
        let first = self.power(&a[0], b);
        self.power_from(a, first, b)
    }

    /// a^b from its value at a_0, which is not 0.
    fn power_from(&self, a: &Series, first: BigFloat, b: &BigFloat) -> Series {
        let mut f = vec![first];
        for k in 1..a.len() {
            let sum = (1..=k).fold(self.integer(0), |sum, j| {
                let weight = self.sub(&self.mul(b, &self.small(j)), &self.small(k - j));
                self.add(&sum, &self.mul(&weight, &self.mul(&a[j], &f[k - j])))
            });
            f.push(self.div(&sum, &self.mul(&self.small(k), &a[0])));
        }
        f
    }

    fn exponential(&mut self, a: &Series) -> Series {
        let first = self.exp(&a[0]);
        self.integrated(a, first, |f, k| f[k].clone())
    }

    fn logarithm(&mut self, a: &Series) -> Series {
        let one = self.constant(self.integer(1), a.len());
        let (first, slope) = (self.ln(&a[0]), self.quotient(&one, a));
        self.integrated(a, first, |_, k| slope[k].clone())
    }

    /// 1/(1 + sign a^2).
    fn over_square(&self, a: &Series, sign: i64) -> Series {
        let one = self.constant(self.integer(1), a.len());
        let square = self.product(a, a);
        let sign = self.integer(sign);
        let below = self.each(&one, &square, |one, s| self.add(one, &self.mul(&sign, s)));
        self.quotient(&one, &below)
    }

    fn function(&mut self, function: Function, a: &Series) -> Series {
        let first = self.call(function, &a[0]);
        match function.row().slope {
            Slope::Zero => self.constant(first, a.len()),
            Slope::Sign => {
                let sign = self.call(Function::Sign, &a[0]);
                a.iter().map(|a| self.mul(&sign, a)).collect()
            }
            Slope::HalfReciprocal => {
                let half = self.double(0.5);
                self.constant_power(a, &half)
            }
            Slope::Own => self.exponential(a),
            Slope::Reciprocal => self.logarithm(a),
            Slope::Partner(partner, sign) => {
                let other = self.call(partner, &a[0]);
                self.oscillation(a, [first, other], [sign, partner.row().slope.sign()])
            }
            // f' = a' (1 +- f^2): no exponential that leaves the range.
            Slope::OneAndSquare(sign) => {
                let (zero, one) = (self.integer(0), self.integer(1));
                let sign = self.integer(sign.into());
                self.integrated(a, first, |f, k| {
                    let square = self.convolved(f, f, k, 0, |_| one.clone());
                    self.add(if k == 0 { &one } else { &zero }, &self.mul(&sign, &square))
                })
            }
            Slope::ThirdReciprocalSquare => {
                let third = self.div(&self.integer(1), &self.integer(3));
                self.power_from(a, first, &third)
            }
            Slope::OverCircle(sign) => {
                let under = self.over_square(a, -1);
                let half = self.double(0.5);
                let root = self.constant_power(&under, &half);
                let sign = self.integer(sign.into());
                self.integrated(a, first, |_, k| self.mul(&sign, &root[k]))
            }
            Slope::OverOneAndSquare(sign) => {
                let slope = self.over_square(a, sign.into());
                self.integrated(a, first, |_, k| slope[k].clone())
            }
        }
    }

    /// The series of an expression of one variable, whose own series is `at`.
    pub(super) fn series(
        &mut self,
        expression: &Expression,
        variable: Variable,
        at: &Series,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Series {
        let length = at.len();
        let mut inner = |e: &Expression| self.series(e, variable, at, parameter);
        match expression.node() {
            Node::Number(number) => self.constant(self.exact(number), length),
            Node::Pi => {
                let pi = self.pi();
                self.constant(pi, length)
            }
            Node::Parameter(p) => self.constant(self.double(parameter(*p)), length),
            Node::Variable(v) if *v == variable => at.clone(),
            // No mapping has another variable; none is better than a wrong one.
            Node::Variable(_) => self.constant(astro_float_num::NAN, length),
            Node::Neg(a) => inner(a).iter().map(BigFloat::neg).collect(),
            Node::Add(a, b) => {
                let (a, b) = (inner(a), inner(b));
                self.each(&a, &b, |a, b| self.add(a, b))
            }
            Node::Sub(a, b) => {
                let (a, b) = (inner(a), inner(b));
                self.each(&a, &b, |a, b| self.sub(a, b))
            }
            Node::Mul(a, b) => {
                let (a, b) = (inner(a), inner(b));
                self.product(&a, &b)
            }
            Node::Div(a, b) => {
                let (a, b) = (inner(a), inner(b));
                self.quotient(&a, &b)
            }
            Node::Min(a, b) | Node::Max(a, b) => {
                let (a, b) = (inner(a), inner(b));
                let first_is_less = super::long::below(&a[0], &b[0]);
                let least = matches!(expression.node(), Node::Min(..));
                if first_is_less == least { a } else { b }
            }
            Node::Power(a, b) => {
                let base = inner(a);
                if let Some(k) = b.small_integer() {
                    return self.whole_power(&base, k);
                }
                let exponent = inner(b);
                if exponent[1..].iter().all(BigFloat::is_zero) && is_finite(&exponent[0]) {
                    return self.constant_power(&base, &exponent[0]);
                }
                let logarithm = self.logarithm(&base);
                let product = self.product(&exponent, &logarithm);
                self.exponential(&product)
            }
            Node::Call(function, a) => {
                let a = inner(a);
                self.function(*function, &a)
            }
        }
    }

    /// The series g with g(f(z)) = z, for f_0 = 0: its coefficient k from those before it.
    pub(super) fn reverted(&self, f: &Series) -> Series {
        let length = f.len();
        let mut powers = vec![self.constant(self.integer(1), length)];
        while powers.len() < length {
            powers.push(self.product(&powers[powers.len() - 1], f));
        }
        let mut g = vec![self.integer(0)];
        for (k, power) in powers.iter().enumerate().skip(1) {
            let wanted = self.integer(i64::from(k == 1));
            let rest =
                (1..k).fold(wanted, |rest, j| self.sub(&rest, &self.mul(&g[j], &powers[j][k])));
            g.push(self.div(&rest, &power[k]));
        }
        g
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::testing;
    use crate::reference::long::nearest;

    /// Value and derivatives of every function at one point, against symbolic derivatives in doubles.
    #[test]
    fn series_are_those_of_the_derivatives() {
        let mut arithmetic = Arithmetic::new(256).expect("memory");
        for text in [
            "exp(a*t)*t/(1 + t)",
            "ln(1 + t)^2*sqrt(t + a)",
            "sin(t)*cos(t) + tan(a*t)",
            "atan(t)/(1 + t) - sinh(t)*cosh(t)",
            "tanh(t) + atanh(t/2)*t",
            "asin(t/2)*acos(t) - cbrt(1 + t)*cbrt(t - 1)",
            "(1 + a*t)^(-1/m) + (1 + t)^t + t^3 - 2^t",
        ] {
            let expression = testing::mu(text);
            let at = 0.625;
            let variable = [at, 1.0, 0.0, 0.0, 0.0].map(|c| arithmetic.double(c)).to_vec();
            let value = |p: Parameter| match p.spelling().as_str() {
                "tau" => 2.0,
                "m" => 0.5,
                _ => 0.75,
            };
            let series = arithmetic.series(&expression, Variable::SinceStart, &variable, &value);
            let (mut derivative, mut factorial) = (expression, 1.0);
            for (k, coefficient) in series.iter().enumerate() {
                let wanted = testing::evaluate(&derivative, at) / factorial;
                let got = nearest(coefficient);
                assert!(
                    (got - wanted).abs() < 1e-12 * (1.0 + wanted.abs()),
                    "{text} {k}: {got} {wanted}"
                );
                derivative = derivative.derivative(Variable::SinceStart);
                factorial *= k as f64 + 1.0;
            }
        }
    }

    #[test]
    fn great_powers_take_no_longer_than_their_digits() {
        let mut arithmetic = Arithmetic::new(256).expect("memory");
        let base = [1.0 + 1e-8, 0.5, -0.25].map(|c| arithmetic.double(c)).to_vec();
        for exponent in [1, 2, 3, 7, 100_000_000, -100_000_000] {
            let constant = arithmetic.integer(i64::from(exponent));
            let wanted = arithmetic.constant_power(&base, &constant);
            let got = arithmetic.whole_power(&base, exponent);
            for (got, wanted) in got.iter().zip(&wanted) {
                let (got, wanted) = (nearest(got), nearest(wanted));
                assert!((got - wanted).abs() <= 1e-14 * wanted.abs(), "{exponent}: {got} {wanted}");
            }
        }
    }

    #[test]
    fn a_reverted_series_undoes_the_first() {
        let arithmetic = Arithmetic::new(256).expect("memory");
        // z + z^2 + z^3 + ... = z/(1 - z) is undone by z/(1 + z).
        let f: Series = [0, 1, 1, 1, 1, 1].map(|c| arithmetic.integer(c)).to_vec();
        let g: Vec<_> = arithmetic.reverted(&f).iter().map(nearest).collect();
        assert_eq!(g, [0.0, 1.0, -1.0, 1.0, -1.0, 1.0]);
    }
}
