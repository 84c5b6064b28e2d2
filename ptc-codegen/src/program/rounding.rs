//! Bounds of rounding errors: the distance of a computed value from the same in exact arithmetic.
//!
//! For a value v of a program let v* be the same in exact arithmetic, and e a bound of |v - v*|. An operation inherits
//! from the errors of its operands, without its own rounding:
//!
//! - a b: |ab - a*b*| = |a (b - b*) + b* (a - a*)| <= |a| e_b + (|b| + e_b) e_a
//! - a/b: |a/b - a*/b*| = |(a - a*)/b* + (a/b) (b* - b)/b*| <= (e_a + |a/b| e_b)/(|b| - e_b)
//! - a^b: |ln(v*/v)| <= c with c = e_a |b|/|a| + |ln a| e_b at its greatest, so |v - v*| <= |v| (e^c - 1)
//! - f(a): the greatest slope of f within e_a of all a, times e_a; no more than f takes there.
//!
//! All of them hold with the sizes of the computed operands and of the exact ones, as both sides may change places.
//! The operation itself rounds to nearest: its result is off by at most u |v| + s, with the unit roundoff u and the
//! smallest subnormal number s. A function of a library is trusted to two units in the last place, 4 u |v| + 4 s.
//!
//! The bounds are computed in doubles, and each step of them is enlarged by more than it rounds.

use crate::expression::Function;
use crate::expression::enclosure::{Calls, Range};
use crate::parameter::Precision;

/// Factor that covers the roundings of one step of a bound.
pub(crate) const MORE: f64 = 1.0 + 1e-14;

/// Roundings that a function of the mathematical library is charged with.
const LIBRARY: f64 = 4.0;

/// The errors of one operation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// The largest relative error.
    pub(crate) roundoff: f64,
    /// Largest error of a result that underflows.
    pub(crate) subnormal: f64,
}

/// A bound of a value, computed or exact, and of the difference between both.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near {
    /// The least and the greatest size.
    pub(crate) least: f64,
    pub(crate) most: f64,
    pub(crate) error: f64,
}

impl Near {
    /// The least size of the other of both, or less than 0.
    fn least_of_both(self) -> f64 {
        self.least - self.error * MORE
    }

    /// The greatest size of the other of both.
    fn most_of_both(self) -> f64 {
        (self.most + self.error) * MORE
    }
}

impl Units {
    /// Returns the units of a precision.
    pub(crate) fn of(precision: Precision) -> Self {
        match precision {
            Precision::F32 => Self { roundoff: 2f64.powi(-24), subnormal: 2f64.powi(-149) },
            Precision::F64 => Self { roundoff: 2f64.powi(-53), subnormal: 2f64.powi(-1074) },
        }
    }

    /// Units of operations that round nothing.
    pub(crate) const EXACT: Self = Self { roundoff: 0.0, subnormal: 0.0 };

    /// The same where nothing underflows, so that the errors of a linear law are as large as its states.
    pub(crate) fn without_underflow(self) -> Self {
        Self { subnormal: 0.0, ..self }
    }

    /// The error of a result of size at most `size` before this operation, with what it inherits of its operands.
    pub(crate) fn rounded(self, size: f64, inherited: f64) -> f64 {
        self.times(1.0, size, inherited)
    }

    /// The same of a function.
    pub(crate) fn of_call(self, function: Function, size: f64, inherited: f64) -> f64 {
        self.times(if function.is_of_library() { LIBRARY } else { 1.0 }, size, inherited)
    }

    /// The same of a power with a non-integer exponent.
    pub(crate) fn of_power(self, size: f64, inherited: f64) -> f64 {
        self.times(LIBRARY, size, inherited)
    }

    /// The error of a^k by multiplications, each of which rounds.
    pub(crate) fn of_product(self, a: Near, k: u32) -> f64 {
        let power = (1..k).fold(a, |power, _| {
            let most = power.most * a.most * MORE;
            Near { least: 0.0, most, error: self.rounded(most, product(power, a)) }
        });
        power.error
    }

    fn times(self, count: f64, size: f64, inherited: f64) -> f64 {
        let own = self.roundoff * (size + inherited) + self.subnormal;
        let error = (inherited + count * own) * MORE;
        if error.is_nan() { f64::INFINITY } else { error }
    }
}

/// The error that a + b inherits.
pub(crate) fn sum(a: Near, b: Near) -> f64 {
    (a.error + b.error) * MORE
}

/// The error that a b inherits.
pub(crate) fn product(a: Near, b: Near) -> f64 {
    (a.most * b.error + b.most_of_both() * a.error) * MORE
}

/// The error that a/b inherits, which is at most `ratio` in size; `None` if b may be 0.
pub(crate) fn quotient(a: Near, b: Near, ratio: f64) -> Option<f64> {
    let least = b.least_of_both();
    (least > 0.0).then(|| (a.error + ratio * b.error) / least * MORE)
}

/// The error that a^b inherits, which is at most `power` in size; `None` if a may be 0.
pub(crate) fn power(a: Near, b: Near, power: f64) -> Option<f64> {
    let least = a.least_of_both();
    let logarithm = || least.ln().abs().max(a.most_of_both().ln().abs()) + 1e-15;
    let change = || (b.most_of_both() / least * a.error + logarithm() * b.error) * MORE;
    (least > 0.0).then(|| power * change().exp_m1() * MORE)
}

/// The error that f(a) inherits for a in `near`, which holds the computed a and the exact one; infinite if it is not known.
pub(crate) fn call(calls: &mut Calls, function: Function, near: Range, error: f64) -> f64 {
    if error == 0.0 {
        return 0.0;
    }
    if let Some(slope) = calls.steepest(function, near) {
        return slope * error * MORE;
    }
    let values = calls.values(function, near);
    (Range::from(values.high()) - Range::from(values.low())).high()
}
