//! The time mapping by its definition: stretched time, r_k and the matrix of Bell polynomials.

use std::collections::BTreeSet;

use astro_float_num::BigFloat;

use super::long::{Arithmetic, below, is_finite};
use super::series::Series;
use crate::expression::{Expression, Function, Subject, Variable};
use crate::family::Family;
use crate::mapping::TimeMapping;
use crate::parameter::Parameter;
use crate::request::Spec;

/// Most rounds in which the root of mu is found: 64 that halve, and as many for the rest.
const ROUNDS: usize = 200;
/// Greatest binary exponent of stretched time in the search of the root.
const DOUBLINGS: i32 = 8192;

/// The mapping of a controller, as it is defined.
pub(super) struct Mapping {
    expression: Expression,
    subject: Subject,
    n: usize,
    /// Parameters on which it depends.
    pub(super) parameters: BTreeSet<Parameter>,
}

impl Mapping {
    /// Returns the mapping of `spec`, for chains up to this order.
    pub(super) fn new(spec: &Spec, order: usize) -> Self {
        let (subject, expression) = match &spec.time_mapping {
            TimeMapping::Family { family, rates } => (Subject::Mu, definition(*family, *rates)),
            TimeMapping::Custom(custom) => (custom.subject, custom.given.clone()),
        };
        let mut parameters = expression.parameters();
        parameters.insert(Parameter::Tau);
        Self { expression, subject, n: order, parameters }
    }
}

/// The mapping at one time.
pub(super) struct Point {
    /// Stretched time since the start, kappa(Dt).
    pub(super) stretched: BigFloat,
    /// kappa' = 1/r_1.
    pub(super) slope: BigFloat,
    /// r_1, ..., r_n.
    pub(super) r: Vec<BigFloat>,
    /// `bell[i][j]` = B_{i,j}(r_1, r_2, ...), 0 <= j <= i <= n.
    pub(super) bell: Vec<Vec<BigFloat>>,
}

/// mu(t) of a family, t the stretched time since the start: the definitions of the families.
fn definition(family: Family, rates: usize) -> Expression {
    let number = Expression::integer;
    let (tau, t) = (Expression::from(Parameter::Tau), Expression::from(Variable::SinceStart));
    let (a, m) = (Expression::from(Parameter::A), Expression::from(Parameter::M));
    let at = a.mul(t.clone());
    let decay = |rate: Expression| Expression::call(Function::Exp, rate.mul(t.clone()).neg());
    let share = match family {
        Family::Exp => number(1).sub(decay(Parameter::A.into())),
        Family::Rational => at.clone().div(number(1).add(at)),
        Family::Power => {
            let base = number(1).add(m.clone().mul(at));
            number(1).sub(base.power(number(-1).div(m)))
        }
        Family::Tan => number(2).div(Expression::pi()).mul(Expression::call(Function::Atan, at)),
        Family::Tanh => Expression::call(Function::Tanh, at),
        Family::Algebraic => {
            let square = at.clone().power(number(2));
            at.div(Expression::call(Function::Sqrt, number(1).add(square)))
        }
        Family::ExpSum => {
            let term = |i| number(1).sub(decay(Parameter::Rate(i).into()));
            let sum = (1..=rates).map(term).reduce(Expression::add);
            sum.unwrap_or(number(0)).div(number(i64::try_from(rates).unwrap_or(1)))
        }
        // The root w of w (2 - start - (1 - start) w) = e^{-a t}.
        Family::Soft => {
            let (start, e) = (Expression::from(Parameter::Start), decay(Parameter::A.into()));
            let slope = number(2).sub(start.clone());
            let product = number(4).mul(number(1).sub(start)).mul(e.clone());
            let root = slope.clone().power(number(2)).sub(product);
            let root = Expression::call(Function::Sqrt, root);
            number(1).sub(number(2).mul(e).div(slope.add(root)))
        }
    };
    tau.mul(share)
}

impl Arithmetic {
    /// The mapping at time-to-go `to_go`, 0 < `to_go` <= tau.
    pub(super) fn point(
        &mut self,
        mapping: &Mapping,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Point> {
        let Mapping { expression, subject, n, .. } = mapping;
        let (stretched, mu) = if *subject == Subject::Mu {
            let stretched = self.root(expression, to_go, parameter)?;
            let mu = self.around(expression, Variable::SinceStart, &stretched, *n, parameter);
            (stretched, mu)
        } else {
            let elapsed = self.sub(&self.double(parameter(Parameter::Tau)), to_go);
            let mut kappa = self.around(expression, Variable::Elapsed, &elapsed, *n, parameter);
            let stretched = std::mem::replace(&mut kappa[0], self.integer(0));
            (stretched, self.reverted(&kappa))
        };
        // r_k = mu^(k) = k! times the Taylor coefficient.
        let mut factorial = self.integer(1);
        let mut r = Vec::with_capacity(*n);
        for (k, coefficient) in (1i64..).zip(&mu[1..]) {
            factorial = self.mul(&factorial, &self.integer(k));
            r.push(self.mul(&factorial, coefficient));
        }
        let slope = self.div(&self.integer(1), &r[0]);
        Some(Point { stretched, slope, bell: self.bell(&r), r })
    }

    /// The Taylor series of a mapping around `at`, up to the power n.
    fn around(
        &mut self,
        mapping: &Expression,
        variable: Variable,
        at: &BigFloat,
        n: usize,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Series {
        let mut z = self.constant(at.clone(), n + 1);
        z[1] = self.integer(1);
        self.series(mapping, variable, &z, parameter)
    }

    /// B_{i,j} for 0 <= j <= i <= n: B_{i,j} = sum_l C(i-1, l-1) r_l B_{i-l,j-1}.
    fn bell(&self, r: &[BigFloat]) -> Vec<Vec<BigFloat>> {
        let n = r.len();
        let mut bell = vec![vec![self.integer(1)]];
        // The row C(i-1, .) of Pascal's triangle, which its integers hold exactly.
        let mut binomial = vec![1i64];
        for i in 1..=n {
            let mut row = vec![self.integer(0)];
            for j in 1..=i {
                row.push((1..=i - j + 1).fold(self.integer(0), |sum, l| {
                    let weight = self.mul(&self.integer(binomial[l - 1]), &r[l - 1]);
                    self.add(&sum, &self.mul(&weight, &bell[i - l][j - 1]))
                }));
            }
            bell.push(row);
            let inner = binomial.windows(2).map(|pair| pair[0] + pair[1]);
            binomial = std::iter::once(1).chain(inner).chain([1]).collect();
        }
        bell
    }

    /// The stretched time at which tau - mu is `to_go`: mu grows to tau, so it is bracketed by
    /// powers of 2, then found by Newton's method on ln(tau - mu), halving where that leaves the bracket.
    fn root(
        &mut self,
        mu: &Expression,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<BigFloat> {
        let tau = self.double(parameter(Parameter::Tau));
        if !below(to_go, &tau) {
            return Some(self.integer(0));
        }
        let [low, high] = self.powers(mu, to_go, &tau, parameter)?;
        let (mut low, mut high) = (self.two_to(low), self.two_to(high));
        let target = self.ln(to_go);
        let mut y = high.clone();
        let places = i32::try_from(self.bits()).ok()?;
        for _ in 0..ROUNDS {
            let left = self.left(mu, &y, &tau, parameter);
            if !is_finite(&left[0]) || !is_finite(&left[1]) {
                return None;
            }
            if left[0].cmp(to_go) == Some(0) {
                return Some(y);
            }
            let late = !below(to_go, &left[0]);
            if late {
                high = y.clone()
            } else {
                low = y.clone()
            }
            let logarithm = self.ln(&left[0]);
            let excess = self.mul(&self.sub(&logarithm, &target), &left[0]);
            let newton = self.sub(&y, &self.div(&excess, &left[1]));
            let inside = below(&low, &newton) && below(&newton, &high);
            let next =
                if inside { newton } else { self.div(&self.add(&low, &high), &self.integer(2)) };
            let moved = self.sub(&next, &y).abs();
            y = next;
            // Such a step of Newton's leaves its square, which only more digits would lessen.
            let half = self.mul(&y, &self.two_to(-places / 2));
            if inside && !below(&half, &moved) {
                return Some(y);
            }
        }
        None
    }

    /// The binary exponents of two neighbouring powers of 2 between which the root lies: first by
    /// exponents that double, then by halving.
    fn powers(
        &mut self,
        mu: &Expression,
        to_go: &BigFloat,
        tau: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<[i32; 2]> {
        let mut late = |exponent: i32| {
            let y = self.two_to(exponent);
            !below(to_go, &self.left(mu, &y, tau, parameter)[0])
        };
        let is_late = late(0);
        let (mut near, mut far, mut step) = (0, 0, 1);
        while near == far {
            far = if is_late { -step } else { step };
            if late(far) == is_late {
                near = far;
            }
            step *= 2;
            (step <= DOUBLINGS).then_some(())?;
        }
        let [mut low, mut high] = if is_late { [far, near] } else { [near, far] };
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if late(middle) { high = middle } else { low = middle }
        }
        Some([low, high])
    }

    /// tau - mu and its derivative at `y`.
    fn left(
        &mut self,
        mu: &Expression,
        y: &BigFloat,
        tau: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> [BigFloat; 2] {
        let mu = self.around(mu, Variable::SinceStart, y, 1, parameter);
        [self.sub(tau, &mu[0]), mu[1].neg()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::long::nearest;

    /// The first digits are enough: the root is found with as many as requested.
    #[test]
    fn root_is_found_at_every_requested_precision() {
        for family in crate::family::FAMILIES.iter().map(|info| info.family) {
            let mu = definition(family, 2);
            let parameter = |p: Parameter| match p {
                Parameter::Tau => 2.0,
                Parameter::Rate(2) => 1.5,
                Parameter::M => 1.25,
                Parameter::Start => 0.0625,
                _ => 0.75,
            };
            for to_go in [1.999, 1.0, 0.8, 0.02, 2e-6, 1.9999002454085257e-12] {
                let root = |bits| {
                    let mut arithmetic = Arithmetic::new(bits).expect("memory");
                    let to_go = arithmetic.double(to_go);
                    arithmetic.root(&mu, &to_go, &parameter)
                };
                let [few, many] = [192, 768].map(root);
                let (few, many) = (few.expect("a root"), many.expect("a root"));
                let exact = Arithmetic::new(768).expect("memory");
                let off = nearest(&exact.div(&exact.sub(&few, &many), &many)).abs();
                assert!(off < 2f64.powi(-140), "{family:?} {to_go}: {off}");
            }
        }
    }
}
