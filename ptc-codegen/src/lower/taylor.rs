//! Taylor arithmetic: the series of an expression from those of its parts, to the order of the
//! plant. Its cost grows with the square of the order, where repeated differentiation explodes.

use super::builder::Builder;
use super::coefficients::Coefficient;
use crate::algebra::BigRational;
use crate::expression::{Expression, Function, Variable};
use crate::program::{Op, Value};

/// offset + scale * sum_k terms\[k\] z^k. The scale keeps a common factor out of the terms, so that
/// these stay exact, and no power of it leaves the range before its quotient does.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) offset: Option<Value>,
    pub(super) scale: Option<Value>,
    pub(super) terms: Vec<Coefficient>,
}

use Coefficient::Exact;

impl Series {
    fn new(scale: Option<Value>, terms: Vec<Coefficient>) -> Self {
        Self { offset: None, scale, terms }
    }

    fn is_constant(&self) -> bool {
        self.terms[1..].iter().all(Coefficient::is_zero)
    }
}

/// The variable of the series and its own series.
pub(super) struct Point {
    pub(super) variable: Variable,
    pub(super) series: Series,
}

impl Builder<'_> {
    /// The series of `expression` around `point`.
    pub(super) fn series(&mut self, expression: &Expression, point: &Point) -> Series {
        let length = point.series.terms.len();
        if !expression.contains(point.variable) {
            let zero = Coefficient::integer(0);
            let mut terms = vec![zero; length];
            terms[0] = match expression.number() {
                Some(number) => Exact(number.clone()),
                None => Coefficient::integer(1),
            };
            let scale = expression.number().is_none().then(|| self.scalar(expression));
            return Series::new(scale, terms);
        }
        match expression {
            Expression::Variable(_)
            | Expression::Number(_)
            | Expression::Pi
            | Expression::Parameter(_) => point.series.clone(),
            Expression::Neg(a) => {
                let a = self.series(a, point);
                self.negated(a)
            }
            Expression::Add(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.added(&a, &b)
            }
            Expression::Sub(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                let b = self.negated(b);
                self.added(&a, &b)
            }
            Expression::Mul(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.multiplied(a, b)
            }
            // A cotangent, whose series is sound where that of the tangent is not.
            Expression::Div(a, b) if matches!(&**b, Expression::Call(Function::Tan, _)) => {
                let angle = b.operands().next().unwrap_or(b).clone();
                let (sin, cos) = (Function::Sin, Function::Cos);
                let above = (**a).clone().mul(Expression::call(cos, angle.clone()));
                self.series(&above.div(Expression::call(sin, angle)), point)
            }
            Expression::Div(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.divided(a, b)
            }
            Expression::Power(a, b) if !b.contains(point.variable) => {
                let a = self.series(a, point);
                self.raised(a, b)
            }
            Expression::Power(a, b) => {
                let logarithm = Expression::call(Function::Ln, (**a).clone());
                let product = (**b).clone().mul(logarithm);
                self.series(&Expression::call(Function::Exp, product), point)
            }
            Expression::Call(Function::Sqrt, a) => {
                let a = self.series(a, point);
                self.raised(a, &Expression::Number(BigRational::new(1.into(), 2.into())))
            }
            Expression::Call(function, a) => match &**a {
                // Without the pole of the quotient, where the angle is a right one.
                Expression::Div(over, under)
                    if *function == Function::Atan && under.contains(point.variable) =>
                {
                    let (over, under) = (self.series(over, point), self.series(under, point));
                    self.angle(&over, &under)
                }
                a => {
                    let a = self.series(a, point);
                    self.function(*function, a)
                }
            },
            // Away from kinks, where alone a mapping has a series.
            Expression::Min(a, b) | Expression::Max(a, b) => {
                let (sum, gap) =
                    ((**a).clone().add((**b).clone()), (**a).clone().sub((**b).clone()));
                let gap = Expression::call(Function::Abs, gap);
                let least = matches!(expression, Expression::Min(..));
                let twice = if least { sum.sub(gap) } else { sum.add(gap) };
                self.series(&twice.div(Expression::integer(2)), point)
            }
        }
    }

    fn negated(&mut self, a: Series) -> Series {
        let terms = a.terms.iter().map(|term| self.negative(term)).collect();
        let offset = a.offset.map(|offset| self.push(Op::Neg(offset)));
        Series { offset, scale: a.scale, terms }
    }

    /// The term of order 0.
    pub(super) fn value_at(&mut self, a: &Series) -> Coefficient {
        let own = self.scaled(a.scale, &a.terms[0]);
        match a.offset {
            None => own,
            Some(offset) => self.plus(&Coefficient::Value(offset), &own),
        }
    }

    /// All terms, without scale and offset.
    fn plain(&mut self, a: &Series) -> Vec<Coefficient> {
        let mut terms: Vec<_> = a.terms.iter().map(|term| self.scaled(a.scale, term)).collect();
        terms[0] = self.value_at(a);
        terms
    }

    fn added(&mut self, a: &Series, b: &Series) -> Series {
        for (constant, other) in [(b, a), (a, b)] {
            if constant.is_constant() {
                let value = self.value_at(constant);
                let value = self.coefficient(&value);
                let offset = match other.offset {
                    None => value,
                    Some(offset) => self.add(offset, value),
                };
                return Series { offset: Some(offset), ..other.clone() };
            }
        }
        if a.scale == b.scale {
            let terms = a.terms.iter().zip(&b.terms).map(|(a, b)| self.plus(a, b)).collect();
            return Series { offset: self.sum(a.offset, b.offset), scale: a.scale, terms };
        }
        let (a, b) = (self.plain(a), self.plain(b));
        Series::new(None, a.iter().zip(&b).map(|(a, b)| self.plus(a, b)).collect())
    }

    /// Without an offset: where there is one, it joins the terms.
    fn joined(&mut self, a: Series) -> Series {
        if a.offset.is_none() { a } else { Series::new(None, self.plain(&a)) }
    }

    fn scale_product(&mut self, a: Option<Value>, b: Option<Value>) -> Option<Value> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.mul(a, b)),
            (a, b) => a.or(b),
        }
    }

    fn multiplied(&mut self, a: Series, b: Series) -> Series {
        let (a, b) = if a.is_constant() { (b, a) } else { (a, b) };
        if b.is_constant() {
            let b = self.joined(b);
            let factor = self.value_at(&b);
            let offset = a.offset.map(|offset| {
                let product = self.times(&Coefficient::Value(offset), &factor);
                self.coefficient(&product)
            });
            let terms = a.terms.iter().map(|term| self.times(term, &b.terms[0])).collect();
            return Series { offset, scale: self.scale_product(a.scale, b.scale), terms };
        }
        let (a, b) = (self.joined(a), self.joined(b));
        let scale = self.scale_product(a.scale, b.scale);
        Series::new(scale, self.product(&a.terms, &b.terms))
    }

    pub(super) fn product(&mut self, a: &[Coefficient], b: &[Coefficient]) -> Vec<Coefficient> {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        (0..a.len()).map(|k| self.convolution(a, b, k, 0..=k, &mut one)).collect()
    }

    /// Leading value and the terms divided by it, so that the first is 1.
    pub(super) fn leading(&mut self, a: Series) -> (Value, Vec<Coefficient>) {
        let a = self.joined(a);
        let leading = self.value_at(&a);
        let leading = self.coefficient(&leading);
        let mut terms = Vec::with_capacity(a.terms.len());
        let inverse = match &a.terms[0] {
            Exact(_) => None,
            Coefficient::Value(first) => {
                let one = self.integer(1);
                Some(self.div(one, *first))
            }
        };
        for (k, term) in a.terms.iter().enumerate() {
            terms.push(match inverse {
                _ if k == 0 => Coefficient::integer(1),
                None => self.over(term, &a.terms[0]),
                Some(inverse) => self.times(term, &Coefficient::Value(inverse)),
            });
        }
        (leading, terms)
    }

    fn divided(&mut self, a: Series, b: Series) -> Series {
        let (leading, terms) = self.leading(b);
        let inverse = self.reciprocal(&terms);
        let a = self.joined(a);
        let terms = if a.is_constant() {
            inverse.iter().map(|term| self.times(term, &a.terms[0])).collect()
        } else {
            self.product(&a.terms, &inverse)
        };
        let scale = a.scale.unwrap_or_else(|| self.integer(1));
        Series::new(Some(self.div(scale, leading)), terms)
    }

    /// 1/(1 + a_1 z + ...).
    pub(super) fn reciprocal(&mut self, a: &[Coefficient]) -> Vec<Coefficient> {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        let mut terms = vec![Coefficient::integer(1)];
        for k in 1..a.len() {
            let sum = self.convolution(a, &terms, k, 1..=k, &mut one);
            terms.push(self.negative(&sum));
        }
        terms
    }

    fn raised(&mut self, a: Series, exponent: &Expression) -> Series {
        if let Some(k) = exponent.small_integer().filter(|k| k.unsigned_abs() <= 64 && *k != 0) {
            let power = self.multiple(&a, k.unsigned_abs());
            return if k < 0 {
                let mut one = vec![Coefficient::integer(0); power.terms.len()];
                one[0] = Coefficient::integer(1);
                self.divided(Series::new(None, one), power)
            } else {
                power
            };
        }
        let (leading, terms) = self.leading(a);
        let power = match exponent.number() {
            Some(number) => Exact(number.clone()),
            None => Coefficient::Value(self.scalar(exponent)),
        };
        let scale = self.scalar_power(leading, exponent);
        Series::new(Some(scale), self.power_series(&terms, &power))
    }

    /// a^k by squares, for which a may be 0.
    fn multiple(&mut self, a: &Series, k: u32) -> Series {
        if k == 1 {
            return a.clone();
        }
        let half = self.multiple(a, k / 2);
        let square = self.multiplied(half.clone(), half);
        if k % 2 == 1 { self.multiplied(square, a.clone()) } else { square }
    }

    /// (1 + a_1 z + ...)^p: k w_k = sum_j (p j - (k - j)) a_j w_(k-j).
    pub(super) fn power_series(&mut self, a: &[Coefficient], p: &Coefficient) -> Vec<Coefficient> {
        let mut terms = vec![Coefficient::integer(1)];
        for k in 1..a.len() {
            let sum = self.convolution(a, &terms, k, 1..=k, &mut |b, j| {
                let scaled = b.times(p, &Coefficient::index(j));
                b.minus(&scaled, &Coefficient::index(k - j))
            });
            terms.push(self.over(&sum, &Coefficient::index(k)));
        }
        terms
    }

    fn function(&mut self, function: Function, a: Series) -> Series {
        if function == Function::Ln {
            let (leading, terms) = self.leading(a);
            let offset = self.push(Op::Call(Function::Ln, leading));
            return Series { offset: Some(offset), ..self.logarithm(&terms) };
        }
        let inner = self.plain(&a);
        let at = self.coefficient(&inner[0]);
        if let Function::Abs | Function::Sign = function {
            let sign = Some(self.push(Op::Call(Function::Sign, at)));
            if function == Function::Abs {
                return Series::new(sign, inner);
            }
            let mut one = vec![Coefficient::integer(0); inner.len()];
            one[0] = Coefficient::integer(1);
            return Series::new(sign, one);
        }
        let value = self.push(Op::Call(function, at));
        match function {
            Function::Exp => {
                let one = Coefficient::integer(1);
                Series::new(Some(value), self.integrated(&inner, one))
            }
            Function::Sin | Function::Cos | Function::Sinh | Function::Cosh => {
                self.oscillation(function, value, &inner)
            }
            Function::Tan | Function::Tanh => {
                self.slope_of_square(value, &inner, function == Function::Tanh)
            }
            _ => self.inverse_of_square(value, &inner, function == Function::Atanh),
        }
    }

    /// ln(1 + a_1 z + ...): k w_k = k a_k - sum_{j<k} j w_j a_(k-j).
    fn logarithm(&mut self, a: &[Coefficient]) -> Series {
        let mut terms = vec![Coefficient::integer(0)];
        for (k, term) in a.iter().enumerate().skip(1) {
            let mut index = |_: &mut Self, j| Coefficient::index(j);
            let sum = self.convolution(&terms, a, k, 1..=k - 1, &mut index);
            let share = self.over(&sum, &Coefficient::index(k));
            terms.push(self.minus(term, &share));
        }
        Series::new(None, terms)
    }

    /// w with w' = a' w: k w_k = sum_j j a_j w_(k-j).
    fn integrated(&mut self, a: &[Coefficient], first: Coefficient) -> Vec<Coefficient> {
        let mut terms = vec![first];
        for k in 1..a.len() {
            terms.push(self.next_term(a, &terms, k));
        }
        terms
    }

    /// (1/k) sum_j j a_j w_(k-j).
    fn next_term(&mut self, a: &[Coefficient], w: &[Coefficient], k: usize) -> Coefficient {
        let mut index = |_: &mut Self, j| Coefficient::index(j);
        let sum = self.convolution(a, w, k, 1..=k, &mut index);
        self.over(&sum, &Coefficient::index(k))
    }

    /// sin, cos, sinh or cosh, together with the one that is its derivative up to sign.
    fn oscillation(&mut self, function: Function, value: Value, a: &[Coefficient]) -> Series {
        let (partner, sign) = match function {
            Function::Sin => (Function::Cos, -1),
            Function::Cos => (Function::Sin, -1),
            Function::Sinh => (Function::Cosh, 1),
            _ => (Function::Sinh, 1),
        };
        let at = self.coefficient(&a[0]);
        let partner_value = self.push(Op::Call(partner, at));
        let mut own = vec![Coefficient::Value(value)];
        let mut other = vec![Coefficient::Value(partner_value)];
        // sin' = cos and cos' = -sin: the sign stands where the cosine is derived.
        let (own_sign, other_sign) = match function {
            Function::Cos => (sign, 1),
            _ => (1, sign),
        };
        for k in 1..a.len() {
            let next_own = self.next_term(a, &other, k);
            let next_other = self.next_term(a, &own, k);
            own.push(self.times(&Coefficient::integer(own_sign), &next_own));
            other.push(self.times(&Coefficient::integer(other_sign), &next_other));
        }
        Series::new(None, own)
    }

    /// tan: w' = a' (1 + w^2); tanh: w' = a' (1 - w^2).
    fn slope_of_square(&mut self, value: Value, a: &[Coefficient], minus: bool) -> Series {
        let mut terms = vec![Coefficient::Value(value)];
        let mut slope = Vec::with_capacity(a.len());
        for k in 0..a.len() {
            if k > 0 {
                terms.push(self.next_term(a, &slope, k));
            }
            slope.push(self.one_and_square(&terms, k, minus));
        }
        Series::new(None, terms)
    }

    /// Term k of 1 + w^2 or 1 - w^2.
    fn one_and_square(&mut self, w: &[Coefficient], k: usize, minus: bool) -> Coefficient {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        let square = self.convolution(w, w, k, 0..=k, &mut one);
        let unit = Coefficient::integer(i64::from(k == 0));
        if minus { self.minus(&unit, &square) } else { self.plus(&unit, &square) }
    }

    /// w = atan(p/q): w' = (p' q - p q')/(p^2 + q^2).
    fn angle(&mut self, p: &Series, q: &Series) -> Series {
        let (p, q) = (self.plain(p), self.plain(q));
        let [over, under] = [&p[0], &q[0]].map(|first| self.coefficient(first));
        let ratio = self.div(over, under);
        let mut terms = vec![Coefficient::Value(self.push(Op::Call(Function::Atan, ratio)))];
        let (p_square, q_square) = (self.product(&p, &p), self.product(&q, &q));
        let squares = p_square.iter().zip(&q_square);
        let divisor: Vec<_> = squares.map(|(p, q)| self.plus(p, q)).collect();
        for k in 1..p.len() {
            let mut index = |_: &mut Self, j| Coefficient::index(j);
            let ahead = self.convolution(&p, &q, k, 1..=k, &mut index);
            let back = self.convolution(&q, &p, k, 1..=k, &mut index);
            let turn = self.minus(&ahead, &back);
            let sum = self.convolution(&terms, &divisor, k, 1..=k - 1, &mut index);
            let rest = self.minus(&turn, &sum);
            let share = self.over(&rest, &Coefficient::index(k));
            terms.push(self.over(&share, &divisor[0]));
        }
        Series::new(None, terms)
    }

    /// atan: w' = a'/(1 + a^2); atanh: w' = a'/(1 - a^2).
    fn inverse_of_square(&mut self, value: Value, a: &[Coefficient], minus: bool) -> Series {
        let divisor: Vec<_> = (0..a.len()).map(|k| self.one_and_square(a, k, minus)).collect();
        let mut terms = vec![Coefficient::Value(value)];
        for (k, term) in a.iter().enumerate().skip(1) {
            let mut index = |_: &mut Self, j| Coefficient::index(j);
            let sum = self.convolution(&terms, &divisor, k, 1..=k - 1, &mut index);
            let share = self.over(&sum, &Coefficient::index(k));
            let rest = self.minus(term, &share);
            terms.push(self.over(&rest, &divisor[0]));
        }
        Series::new(None, terms)
    }
}
