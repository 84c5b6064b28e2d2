//! Long numbers as numbers of a formula of the table of functions.

use astro_float_num::BigFloat;

use super::long::Arithmetic;
use crate::expression::Function;
use crate::expression::function::Algebra;

impl Algebra for Arithmetic {
    type Number = BigFloat;

    fn integer(&mut self, value: i64) -> BigFloat {
        Self::integer(self, value)
    }

    fn neg(&mut self, a: BigFloat) -> BigFloat {
        a.neg()
    }

    fn add(&mut self, a: BigFloat, b: BigFloat) -> BigFloat {
        Self::add(self, &a, &b)
    }

    fn sub(&mut self, a: BigFloat, b: BigFloat) -> BigFloat {
        Self::sub(self, &a, &b)
    }

    fn twice(&mut self, a: BigFloat) -> BigFloat {
        Self::add(self, &a, &a)
    }

    fn square(&mut self, a: BigFloat) -> BigFloat {
        Self::mul(self, &a, &a)
    }

    fn div(&mut self, a: BigFloat, b: BigFloat) -> BigFloat {
        Self::div(self, &a, &b)
    }

    fn call(&mut self, function: Function, a: &BigFloat) -> BigFloat {
        Self::call(self, function, a)
    }
}
