//! Steps of a scale that covers all doubles, each a constant part of its value.

/// Bits below a step: 2^7 steps an octave, each 0.8 % of its value.
pub(super) const FINE: u32 = 45;

/// 2^3 steps an octave, for counts of many quantities at once.
pub(super) const COARSE: u32 = 49;

/// The step in which a value is.
pub(super) fn step(value: f64, bits: u32) -> i64 {
    ordered(value) >> bits
}

/// The greatest value of a step; that of infinities is infinite.
pub(super) fn top(step: i64, bits: u32) -> f64 {
    let last = (step.saturating_add(1) << bits).saturating_sub(1);
    let value = f64::from_bits(flipped(last).cast_unsigned());
    match value.is_nan() {
        true if last > 0 => f64::INFINITY,
        true => f64::NEG_INFINITY,
        false => value,
    }
}

/// An integer that is ordered as the doubles are.
fn ordered(value: f64) -> i64 {
    flipped(value.to_bits().cast_signed())
}

/// Negative doubles have their bits in the other order. It is its own inverse.
fn flipped(bits: i64) -> i64 {
    bits ^ ((bits >> 63) & i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_ends_within_one_percent_above_its_values() {
        let mut last = i64::MIN;
        for value in [f64::NEG_INFINITY, -1e300, -2.5, -1.0, -1e-300, 0.0, 3e-310, 0.7, 1.0, 1e300]
        {
            let (at, top) = (step(value, FINE), top(step(value, FINE), FINE));
            assert!(at >= last && top >= value, "{value}");
            assert!(!value.is_normal() || top - value <= 0.01 * value.abs(), "{value}: {top}");
            assert!(step(top, FINE) == at || top.is_infinite());
            last = at;
        }
        assert_eq!(top(step(f64::INFINITY, FINE), FINE), f64::INFINITY);
    }
}
