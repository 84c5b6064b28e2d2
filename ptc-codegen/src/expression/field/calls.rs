//! Calls of functions as kernels, whose arguments have lost signs and quarter turns.

use num_traits::ToPrimitive;

use super::super::compact::{is_negative, negative};
use super::super::function::Parity;
use super::super::ratio::Ratio;
use super::super::{Expression, Function};
use super::{Field, Kernel, Terms, sum};
use crate::algebra::{BigRational, Monomial, Poly, integer};

impl Field {
    pub(super) fn call(&mut self, function: Function, argument: &Expression) -> Option<Ratio> {
        use Function as F;
        let terms = self.terms(argument)?;
        let argument = self.shortest(&terms)?;
        let (function, sign, argument, inverted) = match function {
            F::Sin | F::Cos | F::Tan => self.quarter_turned(function, argument, &terms)?,
            _ => (function, 1, argument, false),
        };
        let (sign, argument) = match function.row().parity.filter(|_| is_negative(&argument)) {
            Some(Parity::Odd) => (-sign, negative(argument)),
            Some(Parity::Even) => (sign, negative(argument)),
            None => (sign, argument),
        };
        let value = self.atom(Expression::call(function, argument))?.scaled(&integer(sign));
        if inverted { value.pow(-1) } else { Some(value) }
    }

    /// Reduces a function of an angle that contains pi/2 or pi: returns the function, its sign, the rest of the angle,
    /// and true for the reciprocal. A value that vanishes with the rest then has all its digits.
    fn quarter_turned(
        &mut self,
        function: Function,
        argument: Expression,
        terms: &Terms,
    ) -> Option<(Function, i64, Expression, bool)> {
        use Function as F;
        let pi = self.symbol(Kernel::Atom(Expression::pi()))?;
        let half = BigRational::new(1.into(), 2.into());
        let monomial = Monomial::power(pi, 1);
        let turn = Self::combined(terms)
            .filter(|r| r.den.is_empty())
            .and_then(|r| r.num.terms().find(|(m, _)| **m == monomial).map(|(_, c)| c / &half));
        let quarters = turn.filter(BigRational::is_integer).and_then(|q| q.to_i64());
        let Some(quarters) = quarters.filter(|q| *q != 0) else {
            return Some((function, 1, argument, false));
        };
        let constant = Ratio::of(Poly::term(-half * integer(quarters), monomial));
        let rest = sum(terms.clone(), vec![constant])?;
        let rest = self.shortest(&rest)?;
        Some(match (function, quarters.rem_euclid(4)) {
            (F::Tan, 0 | 2) => (F::Tan, 1, rest, false),
            (F::Tan, _) => (F::Tan, -1, rest, true),
            (f, 0) => (f, 1, rest, false),
            (f, 2) => (f, -1, rest, false),
            (F::Sin, 1) => (F::Cos, 1, rest, false),
            (F::Sin, _) => (F::Cos, -1, rest, false),
            (_, 1) => (F::Sin, -1, rest, false),
            _ => (F::Sin, 1, rest, false),
        })
    }
}
