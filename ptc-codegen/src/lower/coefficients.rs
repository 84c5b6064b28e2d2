//! Coefficients of Taylor series: exact as far as generation knows them, else values.

use num_traits::{One, Zero};

use super::builder::Builder;
use crate::algebra::{BigRational, integer};
use crate::program::{Op, Value};

/// A coefficient of a series.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Coefficient {
    /// Known at generation.
    Exact(BigRational),
    /// Known later.
    Value(Value),
}

use Coefficient::Exact;

impl Coefficient {
    pub(super) fn integer(value: i64) -> Self {
        Exact(integer(value))
    }

    pub(super) fn index(value: usize) -> Self {
        Self::integer(i64::try_from(value).unwrap_or(i64::MAX))
    }

    pub(super) fn is_zero(&self) -> bool {
        matches!(self, Exact(number) if number.is_zero())
    }
}

/// Arithmetic that folds what is exact, and computes nothing for the neutral elements.
impl Builder<'_> {
    pub(super) fn coefficient(&mut self, a: &Coefficient) -> Value {
        match a {
            Exact(number) => self.number(number.clone()),
            Coefficient::Value(value) => *value,
        }
    }

    pub(super) fn plus(&mut self, a: &Coefficient, b: &Coefficient) -> Coefficient {
        match (a, b) {
            (Exact(a), Exact(b)) => Exact(a + b),
            (a, b) if b.is_zero() => a.clone(),
            (a, b) if a.is_zero() => b.clone(),
            (a, b) => match (self.negated_by(a), self.negated_by(b)) {
                (_, Some(b)) => self.minus(a, &b),
                (Some(a), None) => self.minus(b, &a),
                (None, None) => {
                    let (a, b) = (self.coefficient(a), self.coefficient(b));
                    Coefficient::Value(self.add(a, b))
                }
            },
        }
    }

    pub(super) fn negative(&mut self, a: &Coefficient) -> Coefficient {
        match a {
            Exact(a) => Exact(-a),
            Coefficient::Value(value) if self.joins => match *self.operation_of(*value) {
                Op::Neg(a) => Coefficient::Value(a),
                Op::Sub(a, b) => Coefficient::Value(self.sub(b, a)),
                _ => match self.factor(*value) {
                    Some((number, rest)) => self.times(&Exact(-number), &rest),
                    None => Coefficient::Value(self.push(Op::Neg(*value))),
                },
            },
            Coefficient::Value(a) => Coefficient::Value(self.push(Op::Neg(*a))),
        }
    }

    /// b, where a is -b, and signs move into sums.
    fn negated_by(&self, a: &Coefficient) -> Option<Coefficient> {
        match a {
            Coefficient::Value(value) if self.joins => match *self.operation_of(*value) {
                Op::Neg(b) => Some(Coefficient::Value(b)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The factor of a product that is a number, and the other one.
    fn factor(&self, value: Value) -> Option<(BigRational, Coefficient)> {
        let Op::Mul(a, b) = *self.operation_of(value) else { return None };
        let of = |number, rest| Some((self.constant(number)?.clone(), Coefficient::Value(rest)));
        of(a, b).or_else(|| of(b, a))
    }

    /// a b with one factor in place of two that are numbers, and with its sign outside.
    fn joined_product(&mut self, a: &Coefficient, b: &Coefficient) -> Option<Coefficient> {
        for (a, b) in [(a, b), (b, a)] {
            if let Some(a) = self.negated_by(a) {
                let product = self.times(&a, b);
                return Some(self.negative(&product));
            }
            if let (Exact(number), Coefficient::Value(value)) = (a, b) {
                return Some(match self.factor(*value) {
                    Some((own, rest)) => self.times(&Exact(own * number), &rest),
                    None => {
                        let number = self.number(number.clone());
                        Coefficient::Value(self.mul(number, *value))
                    }
                });
            }
        }
        None
    }

    pub(super) fn minus(&mut self, a: &Coefficient, b: &Coefficient) -> Coefficient {
        match (a, b) {
            (Exact(a), Exact(b)) => Exact(a - b),
            (a, b) if b.is_zero() => a.clone(),
            (a, b) if a.is_zero() => self.negative(b),
            (a, b) => match self.negated_by(b) {
                Some(b) => self.plus(a, &b),
                None => {
                    let (a, b) = (self.coefficient(a), self.coefficient(b));
                    Coefficient::Value(self.sub(a, b))
                }
            },
        }
    }

    pub(super) fn times(&mut self, a: &Coefficient, b: &Coefficient) -> Coefficient {
        match (a, b) {
            (Exact(a), Exact(b)) => Exact(a * b),
            (a, b) if a.is_zero() || b.is_zero() => Coefficient::integer(0),
            (Exact(one), other) | (other, Exact(one)) if one.is_one() => other.clone(),
            (Exact(one), other) | (other, Exact(one)) if (-one).is_one() => self.negative(other),
            (a, b) => {
                let joined = if self.joins { self.joined_product(a, b) } else { None };
                joined.unwrap_or_else(|| {
                    let (a, b) = (self.coefficient(a), self.coefficient(b));
                    Coefficient::Value(self.mul(a, b))
                })
            }
        }
    }

    /// a / b. What an exact zero divides is left for run time, where it is no finite number.
    pub(super) fn over(&mut self, a: &Coefficient, b: &Coefficient) -> Coefficient {
        match (a, b) {
            (Exact(a), Exact(b)) if !b.is_zero() => Exact(a / b),
            (a, b) if a.is_zero() && !b.is_zero() => Coefficient::integer(0),
            (a, Exact(b)) if !b.is_zero() => self.times(a, &Exact(b.recip())),
            (a, b) => {
                let (a, b) = (self.coefficient(a), self.coefficient(b));
                Coefficient::Value(self.div(a, b))
            }
        }
    }

    /// An optional factor that is 1 where it is absent.
    pub(super) fn scaled(&mut self, scale: Option<Value>, a: &Coefficient) -> Coefficient {
        match scale {
            None => a.clone(),
            Some(scale) => self.times(&Coefficient::Value(scale), a),
        }
    }

    /// sum over j = from..=to of weight(j) a_j b_(k-j), for the recurrences of Taylor series.
    pub(super) fn convolution(
        &mut self,
        a: &[Coefficient],
        b: &[Coefficient],
        k: usize,
        range: std::ops::RangeInclusive<usize>,
        weight: &mut dyn FnMut(&mut Self, usize) -> Coefficient,
    ) -> Coefficient {
        let mut sum = Coefficient::integer(0);
        for j in range {
            if a[j].is_zero() || b[k - j].is_zero() {
                continue;
            }
            let weight = weight(self, j);
            let left = self.times(&weight, &a[j]);
            let term = self.times(&left, &b[k - j]);
            sum = self.plus(&sum, &term);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::Family;
    use crate::program::Input;
    use crate::request::Spec;

    /// Compares results of operations on coefficients, and the operations that they took.
    #[test]
    fn neutral_elements_and_exact_numbers_need_no_operation() {
        let spec = Spec::new(1, Family::Exp);
        let mut b = Builder::new(&spec);
        let x = b.push(Op::Input(Input::State(1)));
        let [zero, one, two, minus_one] = [0, 1, 2, -1].map(Coefficient::integer);
        let known = Coefficient::Value(x);
        let minus_x = Coefficient::Value(b.push(Op::Neg(x)));

        assert_eq!(b.plus(&one, &two), Coefficient::integer(3));
        assert_eq!((b.plus(&known, &zero), b.plus(&zero, &known)), (known.clone(), known.clone()));
        assert_eq!(b.minus(&one, &two), minus_one);
        assert_eq!(
            (b.minus(&known, &zero), b.minus(&zero, &known)),
            (known.clone(), minus_x.clone())
        );
        assert_eq!(b.times(&two, &minus_one), Coefficient::integer(-2));
        assert_eq!((b.times(&known, &zero), b.times(&zero, &known)), (zero.clone(), zero.clone()));
        assert_eq!((b.times(&known, &one), b.times(&one, &known)), (known.clone(), known.clone()));
        assert_eq!(b.times(&known, &minus_one), minus_x);
        assert_eq!(b.times(&minus_one, &known), minus_x);
        assert_eq!(b.over(&one, &two), Exact(BigRational::new(1.into(), 2.into())));
        assert_eq!((b.over(&known, &one), b.over(&zero, &known)), (known.clone(), zero.clone()));

        let half = b.number(BigRational::new(1.into(), 2.into()));
        let [zero_value, one_value] = [0, 1].map(|value| b.integer(value));
        for (found, op) in [
            (b.over(&known, &two), Op::Mul(x, half)),
            (b.over(&one, &known), Op::Div(one_value, x)),
            (b.over(&known, &zero), Op::Div(x, zero_value)),
            (b.over(&one, &zero), Op::Div(one_value, zero_value)),
            (b.over(&zero, &zero), Op::Div(zero_value, zero_value)),
        ] {
            assert_eq!(found, Coefficient::Value(b.push(op.clone())), "{op:?}");
        }
    }
}
