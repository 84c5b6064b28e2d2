//! The sample period below which the loop with held gains is stable, where a design fixes its numbers.

use super::known::{lacking, to_f64};
use super::numbers::Numbers;
use crate::check::sampling::is_stable;
use crate::check::{middle, to_f64 as count};
use crate::expansion::Expanded;
use crate::parameter::Parameter;
use crate::request::Spec;

/// Ratio of neighbouring periods of the search.
const STEP: f64 = 1.02;

/// The search begins this far below the time scale of the held loop, and ends this far above it.
const BELOW: f64 = 1e-4;
const ABOVE: f64 = 1e2;

/// The first sample period, to three digits from below, at which the loop with the gains held at eps
/// is unstable: `None` if the design leaves a number open that decides it, `Some(None)` if no
/// stable period was found.
pub(crate) fn held_period(spec: &Spec, expanded: Option<&Expanded>) -> Option<Option<f64>> {
    let eps = spec.fixed.get(&Parameter::Eps).and_then(to_f64)?;
    if lacking(spec).is_some() {
        return None;
    }
    let period = first_unstable(&Numbers::new(spec, expanded).gains(eps));
    Some(period.map(|period| {
        let unit = 10f64.powf(period.log10().floor() - 2.0);
        (period / unit).floor() * unit
    }))
}

fn first_unstable(gains: &[f64]) -> Option<f64> {
    // |gain_j| has the unit s^-(n+1-j): the fastest of its roots sets the time scale.
    let n = gains.len();
    let root = |(j, gain): (usize, &f64)| gain.abs().powf(1.0 / count(n - j));
    let scale = 1.0 / gains.iter().enumerate().map(root).fold(0.0, f64::max);
    if !scale.is_finite() || scale == 0.0 {
        return None;
    }
    let stable = |period: f64| is_stable(gains, period);
    let (mut good, last) = (BELOW * scale, ABOVE * scale);
    if !stable(good) {
        return None;
    }
    while good < last && stable(good * STEP) {
        good *= STEP;
    }
    let mut bad = good * STEP;
    for _ in 0..40 {
        let between = middle(good, bad);
        if stable(between) {
            good = between;
        } else {
            bad = between;
        }
    }
    Some(good)
}

#[cfg(test)]
mod tests {
    use super::first_unstable;

    #[test]
    fn thresholds_of_known_loops() {
        // x' = -k x is stable up to h = 2/k, whatever the scale of k.
        for k in [1e-6, 1.0, 3e9] {
            let found = first_unstable(&[-k]).expect("a stable loop");
            assert!((found * k - 2.0).abs() < 1e-6, "{k}: {found}");
        }
        // x'' = -2/T^2 x - 2/T x': exp with a = 1 and poles -1, -2 is stable up to h = T.
        for t in [1e-8, 1e-3] {
            let found = first_unstable(&[-2.0 / (t * t), -2.0 / t]).expect("a stable loop");
            assert!((found / t - 1.0).abs() < 1e-6, "{t}: {found}");
        }
        assert_eq!(first_unstable(&[1.0]), None);
        assert_eq!(first_unstable(&[0.0, 0.0]), None);
    }
}
