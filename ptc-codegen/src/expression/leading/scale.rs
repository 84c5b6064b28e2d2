//! Scales of growth: products of powers of v, ln v and ln ln v with exponentials of such products.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use num_traits::Zero;

use super::{ordering, zero};
use crate::algebra::{BigRational, integer};
use crate::collect::map;
use crate::expression::Expression;
use crate::expression::effort::{COMPARED, spend};
use crate::expression::normal::normal;

/// v^p (ln v)^q (ln ln v)^r (ln ln ln v)^s, by its powers; the order of the powers is that of growth.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Product([BigRational; 4]);

impl Product {
    /// The variable's `depth`-fold logarithm: v itself for 0.
    pub(super) fn logarithm(depth: usize) -> Self {
        let power = |i| integer(i64::from(i == depth));
        Self([power(0), power(1), power(2), power(3)])
    }

    /// The variable.
    pub(crate) fn variable() -> Self {
        Self::logarithm(0)
    }

    fn grows(&self) -> bool {
        *self > Self([integer(0), integer(0), integer(0), integer(0)])
    }

    /// It as a scale; `None` if that has one logarithm more than a scale.
    pub(super) fn scale(&self) -> Option<Scale> {
        let mut scale = Scale::one();
        for (depth, power) in self.0.iter().enumerate().filter(|(_, power)| !power.is_zero()) {
            let logarithm = (depth < 3).then(|| Product::logarithm(depth + 1))?;
            scale.exponent.insert(logarithm, Expression::from(power.clone()));
        }
        Some(scale)
    }
}

/// e to a sum of products that grow, each with a coefficient: the coefficient of v is a rate, that
/// of ln v a power of v, that of ln ln v a power of ln v.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Scale {
    /// 1 if it grows faster than e to any of the products, -1 if it falls so.
    pub(super) fast: i32,
    pub(super) exponent: BTreeMap<Product, Expression>,
    /// Bounding product: the part that the exponent leaves open is a bounded multiple of it.
    pub(super) open: Option<Product>,
}

impl Scale {
    pub(super) fn one() -> Self {
        Self { fast: 0, exponent: BTreeMap::new(), open: None }
    }

    /// The scale of e^(coefficient product).
    pub(super) fn exponential(product: Product, coefficient: Expression) -> Self {
        Self { exponent: BTreeMap::from([(product, coefficient)]), ..Self::one() }
    }

    /// The variable.
    pub(super) fn variable() -> Self {
        Self::exponential(Product::logarithm(1), Expression::integer(1))
    }

    pub(super) fn coefficient(&self, depth: usize) -> Expression {
        self.exponent.get(&Product::logarithm(depth)).cloned().unwrap_or_else(zero)
    }

    /// The power of the variable in it.
    pub(crate) fn power(&self) -> Expression {
        self.coefficient(1)
    }

    /// The coefficient of the variable in its exponent.
    pub(crate) fn rate(&self) -> Expression {
        self.coefficient(0)
    }

    /// The product that it is; `None` if there are exponentials or other than numbers as powers.
    pub(super) fn product(&self) -> Option<Product> {
        let mut powers = [integer(0), integer(0), integer(0), integer(0)];
        let mut left = self.exponent.len();
        for (depth, power) in powers.iter_mut().enumerate().take(3) {
            if let Some(coefficient) = self.exponent.get(&Product::logarithm(depth + 1)) {
                *power = coefficient.number()?.clone();
                left -= 1;
            }
        }
        (left == 0 && self.fast == 0 && self.open.is_none()).then_some(Product(powers))
    }

    /// Returns `Greater` if it grows, `Equal` if it stays, and `Less` if it vanishes.
    pub(super) fn tends(&self) -> Option<Ordering> {
        match (self.fast.cmp(&0), self.leading()?) {
            (Ordering::Equal, Some((_, order))) => Some(order),
            (Ordering::Equal, None) => self.open.is_none().then_some(Ordering::Equal),
            (order, _) => Some(order),
        }
    }

    /// The product that decides how it grows, and whether it does; outermost `None` if it depends on
    /// the parameters.
    pub(super) fn leading(&self) -> Option<Option<(&Product, Ordering)>> {
        for (product, coefficient) in self.exponent.iter().rev() {
            match ordering(coefficient)? {
                Ordering::Equal => {}
                order => return Some(Some((product, order))),
            }
        }
        Some(None)
    }

    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        if self.fast * other.fast < 0 {
            return None;
        }
        let mut exponent = self.exponent.clone();
        for (product, coefficient) in &other.exponent {
            let own = exponent.remove(product).unwrap_or_else(zero);
            let sum = normal(&own.add(coefficient.clone()));
            if sum != zero() {
                exponent.insert(product.clone(), sum);
            }
        }
        let open = self.open.clone().max(other.open.clone());
        Some(Self { fast: (self.fast + other.fast).signum(), exponent, open }.closed())
    }

    /// Without what is no larger than what it leaves open.
    fn closed(mut self) -> Self {
        if let Some(open) = &self.open {
            self.exponent.retain(|product, _| product > open);
        }
        self
    }

    /// It times e to a bounded multiple of a product that grows.
    pub(super) fn opened(self, by: Product) -> Self {
        let open = self.open.clone().max(by.grows().then_some(by));
        Self { open, ..self }.closed()
    }

    pub(super) fn raised(&self, exponent: &Expression) -> Option<Self> {
        let turn = match ordering(exponent)? {
            Ordering::Less => -1,
            Ordering::Equal => return Some(Self::one()),
            Ordering::Greater => 1,
        };
        let scaled = |(product, coefficient): (&Product, &Expression)| {
            (product.clone(), normal(&coefficient.clone().mul(exponent.clone())))
        };
        let exponents = map(self.exponent.iter().map(scaled));
        Some(Self { fast: self.fast * turn, exponent: exponents, open: self.open.clone() })
    }

    pub(super) fn inverse(&self) -> Self {
        let negative = |c: &Expression| normal(&c.clone().neg());
        Self {
            fast: -self.fast,
            exponent: map(self.exponent.iter().map(|(p, c)| (p.clone(), negative(c)))),
            open: self.open.clone(),
        }
    }

    /// Compares the growth of the two; `None` if it depends on the parameters or is not known.
    pub(super) fn compare(&self, other: &Self) -> Option<Ordering> {
        if self.fast != other.fast {
            return Some(self.fast.cmp(&other.fast));
        }
        if self.fast != 0 {
            return None;
        }
        let open = self.open.as_ref().max(other.open.as_ref());
        let products: BTreeSet<_> = self.exponent.keys().chain(other.exponent.keys()).collect();
        for product in products.into_iter().rev().take_while(|p| open.is_none_or(|open| *p > open))
        {
            spend(COMPARED)?;
            match (self.exponent.get(product), other.exponent.get(product)) {
                (own, others) if own == others => {}
                (own, others) => {
                    let or_zero = |c: Option<&Expression>| c.cloned().unwrap_or_else(zero);
                    match ordering(&normal(&or_zero(own).sub(or_zero(others))))? {
                        Ordering::Equal => {}
                        order => return Some(order),
                    }
                }
            }
        }
        (self == other || open.is_none()).then_some(Ordering::Equal)
    }
}
