//! The guard that a sample period requires.
//!
//! With gains frozen at time-to-go T and a zero-order hold of period h the chain of integrators goes
//! x(t + h) = M(h, T) x(t), M = exp(A h) + B(h) gain(T)^T, which is stable iff the spectral radius of
//! M is below 1. By the bilinear map sigma = (z + 1)/(z - 1) that is a Hurwitz test, which is exact.
//!
//! From time-to-go eps on the gains are frozen at T = eps for good, and there the test is exact; for
//! T > eps they move slowly compared with the loop as long as h is well below T, and it is a guide.

use num_traits::float::FloatCore;
use num_traits::{One, Zero};

use super::{Outcome, Verdict, middle};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::is_hurwitz;
use crate::algebra::{BigInt, BigRational};
use crate::diagnostic::{digits, digits_up};

/// The guard to take is this many times the least one: at the least one the loop with held gains
/// neither decays nor grows, and twice as far the period may be late by as much as itself.
pub const MARGIN: f64 = 2.0;

/// Ratio of neighbouring points of the scans: thresholds closer together than this are not told
/// apart.
const STEP: f64 = 1.01;

/// The scan ends at this share of the smaller one of h and tau: gains that are stable there are so
/// small that any eps will do.
const FLOOR: f64 = 1e-3;

/// Guard that a sample period requires.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Sample period h in s.
    pub period: f64,
    /// Settling time tau in s.
    pub tau: f64,
    /// The least eps such that the sampled loop is stable for every T in [eps, tau]; `None` if it
    /// is not stable even at tau.
    pub least_eps: Option<f64>,
    /// [`MARGIN`] times as much; `None` if that is not below tau.
    pub default_eps: Option<f64>,
    /// True if the gains at T = tau are stable without sampling. Where they are not, frozen gains say nothing: a loop
    /// may converge that passes such gains only once.
    pub continuous: bool,
}

/// Scans T from tau down, on a logarithmic grid, to where gains frozen at T are unstable at `period`.
/// `gains` gives the n feedback gains of u = sum gain_j x_j at time-to-go T.
pub fn sampling(gains: &dyn Fn(f64) -> Vec<f64>, period: f64, tau: f64) -> Sampling {
    let stable = |time_to_go: f64| is_stable(&gains(time_to_go), period);
    let floor = FLOOR * period.min(tau);
    let least_eps = stable(tau).then(|| {
        let mut high = tau;
        while high > floor && stable(high / STEP) {
            high /= STEP;
        }
        if high <= floor { high } else { bisect(high, high / STEP, stable) }
    });
    let default_eps = least_eps.map(|eps| MARGIN * eps).filter(|eps| *eps < tau);
    let continuous = is_stable_unsampled(&gains(tau));
    Sampling { period, tau, least_eps, default_eps, continuous }
}

/// The first sample period at which the loop with `gains` held at time-to-go `eps` is not stable,
/// searched between 1e-3 and 1e3 eps; `None` if it is unstable at the lower end already.
pub fn longest_period(gains: &[f64], eps: f64) -> Option<f64> {
    let stable = |period: f64| is_stable(gains, period);
    let (mut low, last) = (1e-3 * eps, 1e3 * eps);
    if !stable(low) {
        return None;
    }
    while low < last && stable(low * STEP) {
        low *= STEP;
    }
    Some(if low >= last { low } else { bisect(low, low * STEP, stable) })
}

/// Returns true if the loop with `gains` and a zero-order hold of `period` > 0 is stable: exact for these doubles.
/// Gains that are not finite are not stable.
///
/// x_j follows u through m = n+1-j integrators: x_j = (h/2)^m/m! p_m(sigma) u with p_0 = 1 and
/// p_(m+1) = (sigma - 1)(p_m + (sigma + 1) p_m'), since m integrators give k^m - (k-1)^m at sample k
/// and a factor k is -z d/dz = (sigma^2 - 1)/2 d/dsigma. With u = sum gain_j x_j the loop is
/// stable iff all n roots of 1 - sum gain_j (h/2)^m/m! p_m have Re sigma < 0.
pub fn is_stable(gains: &[f64], period: f64) -> bool {
    let n = gains.len();
    // Times n!, and in powers of 2: fractions of long numbers would take most of the time.
    let mut weights = vec![(-factorial(n), 0)];
    for (m, gain) in (1..=n).zip(gains.iter().rev()) {
        let (Some((gain, own)), Some((period, each))) = (binary(*gain), binary(period / 2.0))
        else {
            return false;
        };
        let whole = gain * num_traits::pow(period, m) * (factorial(n) / factorial(m));
        weights.push((whole, own + each * m as i64));
    }
    let lowest = weights.iter().map(|(_, exponent)| *exponent).min().unwrap_or(0);
    // p_m, from the constant on.
    let mut response = vec![BigInt::one()];
    let mut closed = vec![BigInt::zero(); n + 1];
    for (weight, exponent) in weights {
        let weight = weight << (exponent - lowest);
        closed.iter_mut().zip(&response).for_each(|(sum, own)| *sum += &weight * own);
        response = integrated(&response);
    }
    let closed = Polynomial::new(closed.into_iter().map(BigRational::from).collect());
    // A root at infinity is z = 1.
    closed.degree() == Some(n) && is_hurwitz(&closed)
}

/// A finite number as a whole one times a power of 2.
fn binary(number: f64) -> Option<(BigInt, i64)> {
    let (mantissa, exponent, sign) = number.integer_decode();
    number.is_finite().then(|| (BigInt::from(mantissa) * sign, exponent.into()))
}

fn factorial(n: usize) -> BigInt {
    (1..=n).map(BigInt::from).product()
}

/// p_(m+1) for p_m.
fn integrated(p: &[BigInt]) -> Vec<BigInt> {
    let at = |k: usize| p.get(k).cloned().unwrap_or_default();
    // p + (sigma + 1) p'.
    let inner = |k: usize| at(k) * (k + 1) + at(k + 1) * (k + 1);
    let outer = |k: usize| k.checked_sub(1).map(inner).unwrap_or_default() - inner(k);
    (0..=p.len()).map(outer).collect()
}

/// Returns true if the loop with `gains` is stable without sampling.
fn is_stable_unsampled(gains: &[f64]) -> bool {
    let negative = |gain: &f64| BigRational::from_float(-gain);
    let gains: Option<Vec<_>> = gains.iter().map(negative).collect();
    gains.is_some_and(|gains| is_hurwitz(&Polynomial::characteristic(&gains)))
}

/// The last point from `good` towards `bad` at which `stable` holds, by bisection.
fn bisect(mut good: f64, mut bad: f64, stable: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..50 {
        let between = middle(good, bad);
        if stable(between) {
            good = between;
        } else {
            bad = between;
        }
    }
    good
}

impl Sampling {
    /// The outcome for a guard `eps` that the design has chosen, if it has.
    pub fn outcome(&self, eps: Option<f64>) -> Outcome {
        let (period, tau) = (digits(self.period), digits(self.tau));
        let (verdict, summary, fix) = match (self.least_eps, eps) {
            (None, _) if !self.continuous => (
                Verdict::Undecided,
                format!("gains frozen at T = tau = {tau} s are unstable without sampling too"),
                Some("gains that hold the loop alone at T = tau can be judged".to_owned()),
            ),
            (None, _) => (
                Verdict::Unsound,
                format!("a period of {period} s is unstable at T = tau = {tau} s already"),
                Some("sample faster, take a larger tau or smaller gains".to_owned()),
            ),
            (Some(least), Some(eps)) if eps < least => (
                Verdict::Unsound,
                format!(
                    "held gains are unstable: a period of {period} s needs eps >= {} s, not {} s",
                    digits_up(least),
                    digits(eps)
                ),
                Some(self.advice(least)),
            ),
            (Some(least), Some(eps)) => (
                Verdict::Sound,
                format!(
                    "eps = {} s is {} times the minimum for a period of {period} s",
                    digits(eps),
                    digits(eps / least)
                ),
                // A default is rounded to three digits.
                (eps < 0.99 * MARGIN * least).then(|| self.advice(least)),
            ),
            (Some(least), None) => (
                Verdict::Sound,
                format!("a period of {period} s is stable for eps >= {} s", digits_up(least)),
                None,
            ),
        };
        let details = self
            .least_eps
            .map(|least| format!("the threshold of h/T is {}", digits(self.period / least)));
        Outcome { name: "sampling", verdict, summary, details: details.into_iter().collect(), fix }
    }

    fn advice(&self, least: f64) -> String {
        match self.default_eps {
            Some(eps) => format!("take eps = {} s", digits(eps)),
            None => {
                format!("sample faster: eps = {} s leaves nothing of tau", digits(MARGIN * least))
            }
        }
    }
}

impl From<&Sampling> for Outcome {
    fn from(sampling: &Sampling) -> Self {
        sampling.outcome(None)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Feedback gains -c_j/T^(n+1-j), the form of exp with a = 1.
    fn held(c: &[f64]) -> impl Fn(f64) -> Vec<f64> {
        let n = i32::try_from(c.len()).expect("few");
        move |t| c.iter().zip((1..=n).rev()).map(|(c, k)| -c / t.powi(k)).collect()
    }

    /// The coefficients of exp with a = 1: c_j = sum_i k_(i+1) (-1)^(i-j) S2(i, j), k_(n+1) = 1.
    const CASES: [(&[f64], f64); 4] = [
        (&[1.0], 2.0),
        (&[2.0, 3.0 - 1.0], 1.0),
        (&[20.0, 9.0 - 1.0], 0.25),
        (&[6.0, 11.0 - 6.0 + 1.0, 6.0 - 3.0], 0.732),
    ];

    #[test]
    fn exp_thresholds_match_reference_values() {
        for (c, threshold) in CASES {
            let found = sampling(&held(c), 1e-3, 1.0).least_eps.expect("stable at tau");
            // Half a unit of the last digit of the reference value.
            assert!((1e-3 / found - threshold).abs() < 5e-4, "{c:?}: {}", 1e-3 / found);
            let longest = longest_period(&held(c)(0.01), 0.01).expect("stable");
            assert!((longest / 0.01 - threshold).abs() < 5e-4, "{c:?}: {longest}");
        }
    }

    #[test]
    fn period_too_long_for_tau_has_no_eps() {
        let found = sampling(&held(&[20.0, 8.0]), 0.3, 1.0);
        assert_eq!((found.least_eps, found.continuous), (None, true));
        assert_eq!(Outcome::from(&found).verdict, Verdict::Unsound);
        let found = sampling(&held(&[-1.0]), 0.3, 1.0);
        assert_eq!((found.least_eps, found.continuous), (None, false));
        assert_eq!(Outcome::from(&found).verdict, Verdict::Undecided);
        // An eps exists, but twice as much is not below tau.
        let found = sampling(&held(&[1.0]), 1.5, 1.0);
        assert!(found.least_eps.is_some() && found.default_eps.is_none());
    }

    #[test]
    fn outcome_states_the_minimum_eps_and_a_fix() {
        let found = sampling(&held(&[1.0]), 1e-3, 1.0);
        let told = found.outcome(Some(4e-4));
        assert_eq!(
            told.summary,
            "held gains are unstable: a period of 0.001 s needs eps >= 5.001e-4 s, not 4e-4 s"
        );
        assert_eq!(told.fix.as_deref(), Some("take eps = 0.001 s"));
        let told = found.outcome(Some(2e-3));
        assert_eq!((told.verdict, told.fix), (Verdict::Sound, None));
        assert_eq!(told.summary, "eps = 0.002 s is 4 times the minimum for a period of 0.001 s");
        let told = Outcome::from(&found);
        assert_eq!(told.summary, "a period of 0.001 s is stable for eps >= 5.001e-4 s");
        assert_eq!(told.details, ["the threshold of h/T is 2"]);
    }

    #[test]
    fn stability_limit_is_exact() {
        assert!(!is_stable(&[-2.0], 1.0) && is_stable(&[-2.0f64.next_down()], 1.0));
        assert!(!is_stable(&[0.0], 1.0) && is_stable(&[-f64::MIN_POSITIVE], 1.0));
        assert!(!is_stable(&[f64::NAN, -1.0], 1.0) && !is_stable(&[-1.0], f64::INFINITY));
        // A period so short that M is 1 in doubles: all poles at -1, and two to the right.
        let binomial = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0];
        assert!(is_stable(&binomial.map(|c: f64| -c), f64::exp2(-200.0)));
        assert!(!is_stable(&[-1.0, -6.0, -15.0, -20.0, 15.0, -6.0], f64::exp2(-200.0)));
    }

    proptest! {
        /// Jury's conditions for z^2 - (2 - b - a/2) z + 1 - b + a/2, a = -gain_1 h^2, b = -gain_2 h,
        /// on sixteenths, so that many are met with equality.
        #[test]
        fn two_integrators_satisfy_the_jury_conditions(a in -8i32..80, b in -8i32..40) {
            let (a, b) = (f64::from(a) / 16.0, f64::from(b) / 16.0);
            for h in [1.0, 0.125, 2f64.powi(-100)] {
                let jury = a > 0.0 && 2.0 * b > a && b < 2.0;
                prop_assert_eq!(is_stable(&[-a / h / h, -b / h], h), jury);
            }
        }

        /// M is 1 to twelve digits, and the sampled loop still is as stable as the continuous one.
        #[test]
        fn short_periods_keep_their_digits(poles in prop::collection::vec(0.2..9.0f64, 1..8)) {
            let mut c = vec![1.0];
            for pole in poles {
                let lower = c.iter().map(|c| c * pole).chain([0.0]);
                let upper = std::iter::once(0.0).chain(c.iter().copied());
                c = lower.zip(upper).map(|(a, b)| a + b).collect();
            }
            c.pop();
            prop_assert!(is_stable(&held(&c)(1e-3), 1e-15));
            c[0] = -c[0];
            prop_assert!(!is_stable(&held(&c)(1e-3), 1e-15));
        }
    }
}
