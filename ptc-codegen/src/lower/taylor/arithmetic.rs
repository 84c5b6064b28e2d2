//! Sums, products, quotients and powers of series.

use super::{Leading, Series};
use crate::expression::{Expression, Found};
use crate::lower::builder::Builder;
use crate::lower::coefficients::Coefficient::{self, Exact};
use crate::program::{Op, Value};

impl Builder<'_> {
    pub(super) fn negated(&mut self, a: Series) -> Series {
        let terms = a.terms.iter().map(|term| self.negative(term)).collect();
        let offset = a.offset.map(|offset| self.push(Op::Neg(offset)));
        Series { offset, scale: a.scale, terms }
    }

    /// The term of order 0.
    pub(in crate::lower) fn value_at(&mut self, a: &Series) -> Coefficient {
        let own = self.scaled(a.scale, &a.terms[0]);
        match a.offset {
            None => own,
            Some(offset) => self.plus(&Coefficient::Value(offset), &own),
        }
    }

    /// All terms, without scale and offset.
    pub(super) fn plain(&mut self, a: &Series) -> Vec<Coefficient> {
        let mut terms: Vec<_> = a.terms.iter().map(|term| self.scaled(a.scale, term)).collect();
        terms[0] = self.value_at(a);
        terms
    }

    pub(super) fn added(&mut self, a: &Series, b: &Series) -> Series {
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

    pub(super) fn multiplied(&mut self, a: Series, b: Series, leading: Leading) -> Series {
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
        let terms = match leading {
            Leading::Within if a.terms == b.terms => {
                (0..a.terms.len()).map(|k| self.square_term(&a.terms, k)).collect()
            }
            _ => self.product(&a.terms, &b.terms),
        };
        Series::new(scale, terms)
    }

    /// Term k of a square, each mixed product once.
    pub(super) fn square_term(&mut self, a: &[Coefficient], k: usize) -> Coefficient {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        let mixed = match k {
            0 => Coefficient::integer(0),
            k => self.convolution(a, a, k, 0..=(k - 1) / 2, &mut one),
        };
        let twice = self.times(&Coefficient::integer(2), &mixed);
        let middle = match k.is_multiple_of(2) {
            true => self.times(&a[k / 2], &a[k / 2]),
            false => Coefficient::integer(0),
        };
        self.plus(&twice, &middle)
    }

    pub(in crate::lower) fn product(
        &mut self,
        a: &[Coefficient],
        b: &[Coefficient],
    ) -> Vec<Coefficient> {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        (0..a.len()).map(|k| self.convolution(a, b, k, 0..=k, &mut one)).collect()
    }

    /// Leading value and the terms divided by it, so that the first is 1.
    pub(in crate::lower) fn leading(&mut self, a: Series) -> (Value, Vec<Coefficient>) {
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

    pub(super) fn divided(&mut self, a: Series, b: Series, leading: Leading) -> Series {
        if leading == Leading::Within {
            let (a, b) = (self.plain(&a), self.plain(&b));
            return Series::new(None, self.quotient(&a, &b));
        }
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

    /// q with q b = a: b_0 q_k = a_k - sum_{j>=1} b_j q_(k-j).
    fn quotient(&mut self, a: &[Coefficient], b: &[Coefficient]) -> Vec<Coefficient> {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        let constant = b[1..].iter().all(Coefficient::is_zero);
        let inverse = self.over(&Coefficient::integer(1), &b[0]);
        let mut terms: Vec<Coefficient> = Vec::with_capacity(a.len());
        for (k, term) in a.iter().enumerate() {
            let rest = match k {
                0 => term.clone(),
                _ if constant => term.clone(),
                k => {
                    let sum = self.convolution(b, &terms, k, 1..=k, &mut one);
                    self.minus(term, &sum)
                }
            };
            terms.push(self.times(&rest, &inverse));
        }
        terms
    }

    /// 1/(1 + a_1 z + ...).
    fn reciprocal(&mut self, a: &[Coefficient]) -> Vec<Coefficient> {
        let mut one = |_: &mut Self, _| Coefficient::integer(1);
        let mut terms = vec![Coefficient::integer(1)];
        for k in 1..a.len() {
            let sum = self.convolution(a, &terms, k, 1..=k, &mut one);
            terms.push(self.negative(&sum));
        }
        terms
    }

    pub(super) fn raised(&mut self, a: Series, exponent: &Expression, leading: Leading) -> Series {
        if let Some(k) = exponent.small_integer().filter(|k| k.unsigned_abs() <= 64 && *k != 0) {
            let power = self.multiple(&a, k.unsigned_abs(), leading);
            return if k < 0 {
                let mut one = vec![Coefficient::integer(0); power.terms.len()];
                one[0] = Coefficient::integer(1);
                self.divided(Series::new(None, one), power, leading)
            } else {
                power
            };
        }
        let (leading, terms) = self.leading(a);
        let mut found = Found::default();
        let power = match exponent.number() {
            Some(number) => Exact(number.clone()),
            None => Coefficient::Value(self.part(exponent, &mut found)),
        };
        let scale = self.scalar_power(leading, exponent, &mut found);
        Series::new(Some(scale), self.power_series(&terms, &power))
    }

    /// a^k by squares, for which a may be 0.
    fn multiple(&mut self, a: &Series, k: u32, leading: Leading) -> Series {
        if k == 1 {
            return a.clone();
        }
        let half = self.multiple(a, k / 2, leading);
        let square = self.multiplied(half.clone(), half, leading);
        if k % 2 == 1 { self.multiplied(square, a.clone(), leading) } else { square }
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
}
