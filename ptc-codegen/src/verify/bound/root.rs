//! The time at which what falls from tau to 0 has a value, for mappings that are given by mu.

use crate::algebra::BigRational;
use crate::expression::enclosure::Interval;

/// A time on a known side of the root, and about how far the logarithm of the value is off there.
#[derive(Clone, Copy)]
struct End {
    at: f64,
    off: f64,
}

/// An interval with the root of `value` = `target`, of a value that falls.
///
/// It decays about like an exponential, so that the chord of its logarithm comes close; what that gives is
/// looked at on either side, by as much as it moved.
pub(super) fn root(
    mut value: impl FnMut(&Interval) -> Option<Interval>,
    target: &Interval,
) -> Option<Interval> {
    let number = |value: f64| BigRational::from_float(value).map(|value| Interval::exact(&value));
    let goal = target.about()[0].ln();
    // 1 certainly before the root, -1 certainly behind it, 0 where that is not known.
    let mut side = |at: f64| {
        let value = value(&number(at)?)?;
        let excess = value.minus(target);
        let side = i8::from(excess.is_positive()) - i8::from(excess.is_negative());
        Some((side, End { at, off: value.about()[0].ln() - goal }))
    };
    let (_, mut low) = side(0.0)?;
    let (mut of_high, mut high) = side(1.0)?;
    while of_high >= 0 {
        low = high;
        (of_high, high) = side(2.0 * low.at)?;
        (high.at < 1e15).then_some(())?;
    }
    let mut last = f64::INFINITY;
    for _ in 0..64 {
        let before = high.at - low.at;
        let middle = 0.5 * low.at + 0.5 * high.at;
        let chord = low.at + before * low.off / (low.off - high.off);
        let at = if chord > low.at && chord < high.at { chord } else { middle };
        let away = (0.01 * (at - last).abs().min(before)).max(2.0 * f64::EPSILON * at);
        last = at;
        for t in [at - away, at + away, middle] {
            // The middle is asked where the others left much.
            let is_needed = t != middle || high.at - low.at > 0.5 * before;
            if t > low.at && t < high.at && is_needed {
                match side(t)? {
                    (1, end) => low = end,
                    (-1, end) => high = end,
                    _ => {}
                }
            }
        }
        let width = high.at - low.at;
        if width >= before || width <= 8.0 * f64::EPSILON * high.at {
            break;
        }
    }
    Some(number(low.at)?.hull(&number(high.at)?))
}
