//! Functions of series, by the differential equations that they satisfy.

use super::{Leading, Series};
use crate::algebra::BigRational;
use crate::expression::function::Slope;
use crate::expression::{Expression, Function};
use crate::lower::builder::Builder;
use crate::lower::coefficients::Coefficient;
use crate::program::{Op, Value};

impl Builder<'_> {
    pub(super) fn function(&mut self, function: Function, a: Series) -> Series {
        if function.row().slope == Slope::ThirdReciprocalSquare {
            let (leading, terms) = self.leading(a);
            let scale = self.push(Op::Call(function, leading));
            let third = Coefficient::Exact(BigRational::new(1.into(), 3.into()));
            return Series::new(Some(scale), self.power_series(&terms, &third));
        }
        if function == Function::Ln {
            let (leading, terms) = self.leading(a);
            let offset = self.push(Op::Call(Function::Ln, leading));
            return Series { offset: Some(offset), ..self.logarithm(&terms) };
        }
        let inner = self.plain(&a);
        let at = self.coefficient(&inner[0]);
        let slope = function.row().slope;
        if let Slope::Sign | Slope::Zero = slope {
            let sign = Some(self.push(Op::Call(Function::Sign, at)));
            if slope == Slope::Sign {
                return Series::new(sign, inner);
            }
            let mut one = vec![Coefficient::integer(0); inner.len()];
            one[0] = Coefficient::integer(1);
            return Series::new(sign, one);
        }
        let value = self.push(Op::Call(function, at));
        match slope {
            Slope::Own => {
                let one = Coefficient::integer(1);
                Series::new(Some(value), self.integrated(&inner, one))
            }
            Slope::Partner(partner, sign) => self.oscillation(value, (partner, sign), &inner),
            Slope::OneAndSquare(sign) => self.slope_of_square(value, &inner, sign < 0),
            Slope::OverOneAndSquare(sign) => self.inverse_of_square(value, &inner, sign < 0),
            Slope::OverCircle(sign) => {
                let square: Vec<_> =
                    (0..inner.len()).map(|k| self.one_and_square(&inner, k, true)).collect();
                let half = Expression::from(BigRational::new(1.into(), 2.into()));
                let root = self.raised(Series::new(None, square), &half, Leading::Apart);
                let divisor = self.plain(&root);
                self.inverse(value, (&inner, sign), &divisor)
            }
            // Logarithms and roots are series by their leading coefficient.
            Slope::Sign
            | Slope::Zero
            | Slope::Reciprocal
            | Slope::HalfReciprocal
            | Slope::ThirdReciprocalSquare => {
                crate::internal::fault("a series of a function that has another form")
            }
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

    /// A function together with the one that is its derivative up to sign.
    fn oscillation(
        &mut self,
        value: Value,
        (partner, own_sign): (Function, i8),
        a: &[Coefficient],
    ) -> Series {
        let at = self.coefficient(&a[0]);
        let partner_value = self.push(Op::Call(partner, at));
        let mut own = vec![Coefficient::Value(value)];
        let mut other = vec![Coefficient::Value(partner_value)];
        let other_sign = partner.row().slope.sign();
        for k in 1..a.len() {
            let next_own = self.next_term(a, &other, k);
            let next_other = self.next_term(a, &own, k);
            own.push(self.times(&Coefficient::integer(own_sign.into()), &next_own));
            other.push(self.times(&Coefficient::integer(other_sign.into()), &next_other));
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
        let square = match self.joins {
            true => self.square_term(w, k),
            false => {
                let mut one = |_: &mut Self, _| Coefficient::integer(1);
                self.convolution(w, w, k, 0..=k, &mut one)
            }
        };
        let unit = Coefficient::integer(i64::from(k == 0));
        if minus { self.minus(&unit, &square) } else { self.plus(&unit, &square) }
    }

    /// w = atan(p/q): w' = (p' q - p q')/(p^2 + q^2).
    pub(super) fn angle(&mut self, p: &Series, q: &Series) -> Series {
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
        self.inverse(value, (a, 1), &divisor)
    }

    /// w with w' = a'/v, or -a'/v with -1.
    fn inverse(
        &mut self,
        value: Value,
        (a, sign): (&[Coefficient], i8),
        divisor: &[Coefficient],
    ) -> Series {
        let mut terms = vec![Coefficient::Value(value)];
        for (k, term) in a.iter().enumerate().skip(1) {
            let mut index = |_: &mut Self, j| Coefficient::index(j);
            let sum = self.convolution(&terms, divisor, k, 1..=k - 1, &mut index);
            let share = self.over(&sum, &Coefficient::index(k));
            let term = if sign < 0 { self.negative(term) } else { term.clone() };
            let rest = self.minus(&term, &share);
            terms.push(self.over(&rest, &divisor[0]));
        }
        Series::new(None, terms)
    }
}
