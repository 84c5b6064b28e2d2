//! The least value of a function that falls and then rises, on the scale of its logarithm.

use std::ops::ControlFlow;

/// The part of a bracket that is kept.
const SHARE: f64 = 0.618_033_988_749_894_8;

/// Ratio of the ends of a bracket that is not divided any more.
const RESOLUTION: f64 = 1.04;

/// Asks for the value at `first`, and then closes in on the least one between `low` and `high`, until
/// `value` breaks off. No function that falls and then rises has its least value in what is left out.
pub(super) fn least<B>(
    (low, high): (f64, f64),
    first: f64,
    value: &mut dyn FnMut(f64) -> ControlFlow<B, f64>,
) -> ControlFlow<B> {
    let _ = value(first.clamp(low, high))?;
    if low == high {
        return ControlFlow::Continue(());
    }
    let (mut low, mut high) = (low.ln(), high.ln());
    let lower = |low: f64, high: f64| high - SHARE * (high - low);
    let upper = |low: f64, high: f64| low + SHARE * (high - low);
    let (mut left, mut right) = (lower(low, high), upper(low, high));
    let (mut at_left, mut at_right) = (value(left.exp())?, value(right.exp())?);
    while high - low > RESOLUTION.ln() {
        // Where neither run is finite the poles are too fast: stiff, or beyond the range of numbers.
        if at_left <= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = lower(low, high);
            at_left = value(left.exp())?;
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = upper(low, high);
            at_right = value(right.exp())?;
        }
    }
    ControlFlow::Continue(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the points at which the function was evaluated.
    fn asked(least_at: f64) -> Vec<f64> {
        let mut asked = Vec::new();
        let ended = least::<()>((2.0, 64.0), 3.0, &mut |x| {
            asked.push(x);
            // Beyond 50 there is no value.
            let value = (x / least_at).ln().abs();
            ControlFlow::Continue(if x > 50.0 { f64::INFINITY } else { value })
        });
        assert!(ended.is_continue());
        asked
    }

    #[test]
    fn minimum_is_found_within_the_resolution() {
        for least_at in [2.0, 2.1, 5.0, 17.0, 49.0] {
            let asked = asked(least_at);
            let near = asked.iter().map(|x| (x / least_at).ln().abs()).fold(f64::MAX, f64::min);
            assert!(near <= RESOLUTION.ln(), "{least_at}: {asked:?}");
            assert!(asked[0] == 3.0 && asked.len() <= 14, "{asked:?}");
            assert!(asked.iter().all(|x| (2.0..=64.0).contains(x)), "{asked:?}");
        }
    }

    #[test]
    fn search_stops_when_the_caller_breaks() {
        let mut count = 0;
        let ended = least((1.0, 8.0), 9.0, &mut |x| {
            count += 1;
            if count == 3 { ControlFlow::Break(x) } else { ControlFlow::Continue(x) }
        });
        assert!(matches!(ended, ControlFlow::Break(x) if (1.0..=8.0).contains(&x)));
        assert_eq!(count, 3);
    }

    #[test]
    fn single_point_interval_is_evaluated_once() {
        let mut count = 0;
        let ended = least::<()>((1.0, 1.0), 5.0, &mut |x| {
            count += 1;
            ControlFlow::Continue(x)
        });
        assert_eq!((ended, count), (ControlFlow::Continue(()), 1));
    }
}
