//! The one place where a value is compared with its bound.
//!
//! A run knows x and u to a relative accuracy, not to the last bit. A bound that is met more closely than that is neither
//! kept nor exceeded: its excess is exactly 0, which no other comparison gives.

use super::objective::Kind;

/// Relative accuracy to which a value counts as known: the error per step of an integrated run.
pub const ALLOWANCE: f64 = 1e-9;

/// Comparison of a value with its bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// The bound is kept.
    Kept,
    /// The bound is met within the allowance.
    Met,
    /// The bound is exceeded.
    Exceeded,
}

impl Comparison {
    /// Compares by an excess, as [`excess`] and [`over`] give it.
    pub fn of(excess: f64) -> Self {
        match excess {
            0.0 => Self::Met,
            excess if excess < 0.0 => Self::Kept,
            _ => Self::Exceeded,
        }
    }
}

/// Value that an objective bounds at an instant, with its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// |x|, |u| or h; of several inputs or states the largest one in parts of its bound.
    pub value: f64,
    /// Size of the terms that make the value: what its relative accuracy is of.
    pub size: f64,
    /// Its lower bound here, if it has one.
    pub low: Option<f64>,
    /// Its upper bound here, if it has one.
    pub high: Option<f64>,
}

impl Level {
    /// A norm with an upper bound.
    #[inline]
    pub(super) fn below(value: f64, high: Option<f64>) -> Self {
        Self { value, size: value.abs(), low: None, high }
    }

    /// Returns the excess over the bound: of a norm as a part of the bound, of an h in its own unit.
    #[inline]
    pub(super) fn excess(self, kind: &Kind) -> f64 {
        let exists = |bound: Option<f64>| bound.is_none_or(f64::is_finite);
        // A value or a bound that does not exist holds nothing.
        if !(self.value.is_finite() && exists(self.low) && exists(self.high)) {
            return f64::INFINITY;
        }
        let excess = match kind {
            Kind::Within { .. } => {
                let apart = |bound: f64, excess: f64| snapped(excess, self.size.max(bound.abs()));
                let below = self.low.map_or(f64::NEG_INFINITY, |low| apart(low, low - self.value));
                self.high.map_or(below, |high| below.max(apart(high, self.value - high)))
            }
            _ => self.high.map_or(f64::NEG_INFINITY, |high| over(self.value, high)),
        };
        if excess.is_nan() { f64::INFINITY } else { excess }
    }
}

/// value/bound - 1, and 0 within the allowance; a bound of 0 holds what is 0.
#[inline]
pub(super) fn over(value: f64, bound: f64) -> f64 {
    if value == 0.0 && bound >= 0.0 {
        return -1.0;
    }
    if bound > 0.0 {
        return snapped(value / bound - 1.0, 1.0);
    }
    f64::INFINITY
}

/// An excess, and 0 where it is within the allowance of a size. What consists of zeros is known exactly, and keeps a bound
/// of 0.
#[inline]
fn snapped(excess: f64, size: f64) -> f64 {
    if excess == 0.0 && size == 0.0 {
        return -f64::MIN_POSITIVE;
    }
    if excess.abs() <= ALLOWANCE * size { 0.0 } else { excess }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Expression;

    #[test]
    fn values_within_rounding_of_a_bound_count_as_met() {
        let high = Some(Expression::integer(20));
        let within = Kind::Within { h: Expression::integer(0), low: None, high };
        for (value, expected) in [
            (20.0, Comparison::Met),
            (20.0_f64.next_up(), Comparison::Met),
            (20.0_f64.next_down(), Comparison::Met),
            (20.0 * (1.0 - 2.0 * ALLOWANCE), Comparison::Kept),
            (20.0 * (1.0 + 2.0 * ALLOWANCE), Comparison::Exceeded),
            (f64::NAN, Comparison::Exceeded),
            (f64::INFINITY, Comparison::Exceeded),
        ] {
            assert_eq!(Comparison::of(over(value, 20.0)), expected, "{value}");
            let level = Level { low: None, ..Level::below(value, Some(20.0)) };
            assert_eq!(Comparison::of(level.excess(&within)), expected, "{value}");
        }
        // What cancels is known to the size of its terms.
        let level = Level { value: 1e-12, size: 40.0, low: None, high: Some(0.0) };
        assert_eq!(Comparison::of(level.excess(&within)), Comparison::Met);
        let level = Level { size: 1e-12, ..level };
        assert_eq!(Comparison::of(level.excess(&within)), Comparison::Exceeded);
    }
}
