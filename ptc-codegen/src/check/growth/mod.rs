//! Does the state vanish, and does u stay bounded, at the deadline?
//!
//! *Claim.* Let p be the characteristic polynomial of k_1..k_n and rho > 0 the decay rate of mu'. For
//! generic initial states
//! - x -> 0 iff all roots of p lie left of -(n-1) rho;
//! - u stays bounded iff, without the simple roots at -m rho for integers 0 <= m < n where these are
//!   harmless (below), none lies right of -n rho and those on that line are simple;
//! - u -> 0 iff, without the simple ones that add nothing, all lie left of -n rho.
//!
//! *Proof.* Time-to-go T falls like e^(-rho t) in stretched time t, so a mode t^q e^(lambda t) of xi_1
//! = x_1 is T^p (ln T)^q to leading order, p = -lambda/rho, and x_(i+1) is its i-th derivative in time,
//! p(p-1)...(p-i+1) T^(p-i) (ln T)^q to leading order, up to constants; u = x_n' is the one for i = n.
//! The product vanishes only for integer p = m < i. Where it does not, the derivative tends to 0 for
//! Re p > i, grows for Re p < i, and for Re p = i stays bounded without tending to 0 iff q = 0. Where
//! it does and q > 0, the next term T^(m-i) (ln T)^(q-1) grows. Where it does and q = 0, the mode is
//! simple and all depends on what follows the leading term, by [`Modes`]:
//! - `Polynomial` (exp): the mode is T^m, whose later derivatives are 0;
//! - `Analytic` (tanh): it is E^m with E = T/(2 tau - T), whose later derivatives are finite at T = 0;
//!   for m >= 1 they are not 0, as E is a series in T with positive coefficients;
//! - `Quadratic` (soft): the mode is E^m with E = w (1 + c (1 - w)), w = T/tau: a polynomial in T of
//!   degree at most 2m, whose later derivatives are finite, and 0 from the one of order 2m + 1 on;
//! - `Other` (sums of exponentials): T^m is followed by other, real powers of T. Undecided
//!   except for m = 0, where x_1 is constant for every mapping.
//!
//! In each case x_(m+1) -> a constant other than 0, so x -> 0 needs Re p > n-1 without exception. The
//! modes are independent, so for generic initial states none makes up for another. For rho = 0, T
//! falls more slowly than any exponential: every mode decides by the sign of Re lambda alone (on the
//! imaginary axis powers of 1/T grow), except that lambda = 0, if simple, still is a constant x_1.

mod report;

pub use self::report::{open, too_fast, without_rate};

use num_traits::{Signed, ToPrimitive, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::{is_bounded, is_hurwitz};
use crate::algebra::{BigInt, BigRational};
use crate::linear::{Complex, roots};

/// What the mode of a simple pole at -m rho is as a function of time-to-go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modes {
    /// T^m, as for `exp`, where rho = a.
    Polynomial,
    /// A power series in T that begins with T^m, as for `tanh`, where rho = 2a.
    Analytic,
    /// A polynomial in T of degree at most 2m that begins with T^m, as for `soft`, where rho = a.
    Quadratic,
    /// Anything else, as for `exp_sum`, where rho = min a_i.
    Other,
    /// Unknown, as T e^(rho t) is not known to tend to a constant other than 0, as it does in all
    /// families with rho > 0: T = e^(-t)/(1+t) turns a mode at -rho into T ln T. Then what a pole on
    /// a line does is open.
    Open,
}

/// What gains do at the deadline.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// Order n.
    pub n: usize,
    /// Decay rate rho of mu'.
    pub rho: f64,
    /// rho as an expression, where its value is rounded.
    pub spelling: Option<String>,
    /// What sets rho, in words.
    pub rate: &'static str,
    /// What simple poles at -m rho do.
    pub modes: Modes,
    /// Whether x -> 0.
    pub x_to_zero: bool,
    /// Whether u stays bounded; `None` if undecided.
    pub u_bounded: Option<bool>,
    /// Whether u -> 0; `None` if undecided.
    pub u_to_zero: Option<bool>,
    /// The m < n for which a pole lies at -m rho and is simple.
    pub excepted: Vec<usize>,
    /// The poles as numbers, rightmost first; empty where they are not found.
    pub poles: Vec<Complex>,
    /// The largest decay rate, to three digits from below, at which x -> 0 and u -> 0 with these
    /// gains; none if there is none.
    pub largest_rho: Option<f64>,
}

/// Decides, exactly, what gains k_1..k_n do for a mapping with decay rate `rho` >= 0 of mu'.
pub fn growth(gains: &[BigRational], rho: &BigRational, modes: Modes) -> Growth {
    let n = gains.len();
    let p = Polynomial::characteristic(gains);
    let line = |m: usize| -(rho * BigInt::from(m));
    let hurwitz_left_of = |p: &Polynomial, m| is_hurwitz(&p.shifted(&line(m)));

    let (mut rest, mut excepted) = (p.clone(), Vec::new());
    // For rho = 0 all -m rho are one pole, which counts as m = 0.
    let candidates = if rho.is_zero() || modes == Modes::Open { n.min(1) } else { n };
    for m in 0..candidates {
        let (multiplicity, without) = rest.without(&line(m));
        if multiplicity == 1 {
            excepted.push(m);
            rest = without;
        }
    }
    let rest_to_zero = hurwitz_left_of(&rest, n);
    let bounded = |p: &Polynomial| is_bounded(&p.shifted(&line(n)));
    let rest_bounded = rest_to_zero || (rho.is_positive() && bounded(&rest));
    let open = modes == Modes::Open && !rest_to_zero && {
        let (_, off_the_line) = rest.without(&line(n));
        hurwitz_left_of(&off_the_line, n) || bounded(&off_the_line)
    };
    let only_constant = excepted.iter().all(|m| *m == 0);
    let excepted_bounded = (only_constant || modes != Modes::Other).then_some(true);
    let excepted_to_zero = match modes {
        Modes::Polynomial => Some(true),
        Modes::Analytic => Some(only_constant),
        Modes::Quadratic => excepted.iter().all(|m| 2 * m < n).then_some(true),
        Modes::Other | Modes::Open => only_constant.then_some(true),
    };
    let open_or = |decided: Option<bool>| if open { None } else { decided };
    Growth {
        n,
        rho: rho.to_f64().unwrap_or(f64::NAN),
        spelling: None,
        rate: match modes {
            Modes::Polynomial | Modes::Quadratic => "a",
            Modes::Analytic => "2 a",
            Modes::Other | Modes::Open => "a least rate",
        },
        modes,
        x_to_zero: hurwitz_left_of(&p, n.saturating_sub(1)),
        u_bounded: open_or(if rest_bounded { excepted_bounded } else { Some(false) }),
        u_to_zero: open_or(if rest_to_zero { excepted_to_zero } else { Some(false) }),
        excepted,
        poles: roots(&p).unwrap_or_default(),
        largest_rho: largest_rho(gains, &p),
    }
}

/// Decides the same for a rate of which only bounds are known, such as a rounded ln 100. `None` where
/// they leave open whether x -> 0; what they leave open of u is `None` in the result.
///
/// All poles left of a line are left of every line further right, so that x and u go to 0 for all
/// rates up to one for which they do. What fails at both bounds fails between them, except for a simple
/// pole at -m rho: that one keeps u from growing, so the bounds decide u where p has no such root.
pub fn growth_between(
    gains: &[BigRational],
    [low, high]: [&BigRational; 2],
    modes: Modes,
) -> Option<Growth> {
    let (least, most) = (growth(gains, low, modes), growth(gains, high, modes));
    if most.x_to_zero && most.u_bounded == Some(true) {
        return Some(most);
    }
    if least.x_to_zero != most.x_to_zero {
        return None;
    }
    let p = Polynomial::characteristic(gains);
    let near = (1..gains.len())
        .map(BigInt::from)
        .any(|m| p.may_vanish_between(&-(high * &m), &-(low * &m)));
    let common = |a: Option<bool>, b: Option<bool>| if a == b && !near { a } else { None };
    Some(Growth {
        u_bounded: common(least.u_bounded, most.u_bounded),
        u_to_zero: common(least.u_to_zero, most.u_to_zero),
        excepted: Vec::new(),
        ..most
    })
}

/// Bisects, with exact decisions, for the largest rho with all poles left of -n rho.
fn largest_rho(gains: &[BigRational], p: &Polynomial) -> Option<f64> {
    if gains.is_empty() || !is_hurwitz(p) {
        return None;
    }
    let n = BigInt::from(gains.len());
    // The rightmost pole is not left of their mean, -k_n/n.
    let mut high = gains.last()? / (&n * &n);
    let mut low = BigRational::zero();
    while low.is_zero() || &high - &low > &low / BigInt::from(4096) {
        let middle = (&low + &high) / BigInt::from(2);
        if is_hurwitz(&p.shifted(&-(&middle * &n))) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let low = low.to_f64()?;
    let unit = 10f64.powf(low.log10().floor() - 2.0);
    Some((low / unit).floor() * unit)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::algebra::integer;
    use crate::check::deadline::{ClosedLoop, deadline};
    use crate::diagnostic::digits;
    use crate::request::{Pole, gains};

    fn exact(poles: &[i64]) -> Vec<BigRational> {
        let poles: Vec<_> = poles.iter().map(|re| Pole::real(integer(*re))).collect();
        gains(&poles).expect("real poles need no partner")
    }

    fn with(poles: &[i64], rho: BigRational, modes: Modes) -> Growth {
        growth(&exact(poles), &rho, modes)
    }

    fn verdicts(poles: &[i64], modes: Modes) -> (bool, Option<bool>, Option<bool>) {
        let growth = with(poles, integer(1), modes);
        (growth.x_to_zero, growth.u_bounded, growth.u_to_zero)
    }

    #[test]
    fn strictly_left_and_on_the_line() {
        use Modes::{Analytic, Other, Polynomial};
        for modes in [Polynomial, Analytic, Modes::Quadratic, Other] {
            assert_eq!(verdicts(&[-3, -4], modes), (true, Some(true), Some(true)));
            // The letter's own case, u = 3 - 6T: bounded, not to 0.
            assert_eq!(verdicts(&[-2, -3], modes), (true, Some(true), Some(false)));
            // Twice on the line: ln T.
            assert_eq!(verdicts(&[-2, -2], modes), (true, Some(false), Some(false)));
            assert_eq!(verdicts(&[-1, -1], modes), (false, Some(false), Some(false)));
            assert_eq!(verdicts(&[0, -3], modes), (false, Some(true), Some(true)));
            assert_eq!(verdicts(&[0, 0], modes), (false, Some(false), Some(false)));
        }
        assert_eq!(verdicts(&[-1, -3], Polynomial), (false, Some(true), Some(true)));
        assert_eq!(verdicts(&[-1, -3], Analytic), (false, Some(true), Some(false)));
        assert_eq!(verdicts(&[-1, -3], Other), (false, None, None));
        // With E a quadratic in T, E^1 adds to u for n = 2 and nothing for n = 3.
        assert_eq!(verdicts(&[-1, -3], Modes::Quadratic), (false, Some(true), None));
        assert_eq!(verdicts(&[-1, -4, -5], Modes::Quadratic), (false, Some(true), Some(true)));
        assert_eq!(verdicts(&[-1, 1], Polynomial), (false, Some(false), Some(false)));
        assert_eq!(verdicts(&[0, -1, -2], Polynomial), (false, Some(true), Some(true)));
    }

    #[test]
    fn where_t_is_no_exponential_the_line_is_open() {
        assert_eq!(verdicts(&[-3, -4], Modes::Open), (true, Some(true), Some(true)));
        for poles in [[-2, -3], [-2, -2]] {
            assert_eq!(verdicts(&poles, Modes::Open), (true, None, None));
        }
        assert_eq!(verdicts(&[-1, -3], Modes::Open), (false, Some(false), Some(false)));
        assert_eq!(verdicts(&[0, -3], Modes::Open), (false, Some(true), Some(true)));
    }

    #[test]
    fn complex_poles_on_the_line_and_between_the_lines() {
        let pole = |re: i64, im: i64| Pole { re: integer(re), im: integer(im) };
        let pair = gains(&[pole(-2, 5), pole(-2, -5)]).expect("conjugate pairs");
        let on = growth(&pair, &integer(1), Modes::Polynomial);
        assert_eq!((on.x_to_zero, on.u_bounded, on.u_to_zero), (true, Some(true), Some(false)));
        let between = growth(&pair, &BigRational::new(3.into(), 2.into()), Modes::Polynomial);
        assert_eq!((between.x_to_zero, between.u_bounded), (true, Some(false)));
    }

    #[test]
    fn without_decay_the_left_half_plane_is_enough() {
        let growth = |poles: &[i64]| {
            let growth = with(poles, integer(0), Modes::Other);
            (growth.x_to_zero, growth.u_bounded, growth.u_to_zero)
        };
        assert_eq!(growth(&[-1, -1, -1]), (true, Some(true), Some(true)));
        assert_eq!(growth(&[0, -1, -1]), (false, Some(true), Some(true)));
        assert_eq!(growth(&[0, 0, -1]), (false, Some(false), Some(false)));
        assert_eq!(growth(&[1, -1, -1]), (false, Some(false), Some(false)));
        // A pair on the axis: u grows like powers of 1/T.
        let pair = super::growth(&[integer(4), integer(0)], &integer(0), Modes::Other);
        assert_eq!((pair.x_to_zero, pair.u_bounded), (false, Some(false)));
    }

    #[test]
    fn the_largest_rate_is_told() {
        let found = |poles: &[i64]| with(poles, integer(1), Modes::Polynomial).largest_rho;
        // -n rho = -4 at rho = 4/3, from below.
        assert_eq!(found(&[-4, -5, -6]).map(digits), Some("1.33".to_owned()));
        assert_eq!(found(&[-8]).map(digits), Some("7.99".to_owned()));
        assert_eq!(found(&[1, -2]), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        /// The closed form of the state at T = 1e-12 tau is small where x -> 0 and is not where not:
        /// with integer poles it falls at least like T (ln T)^3.
        #[test]
        fn the_state_does_what_is_told(
            poles in prop::collection::vec(-7i64..2, 1..5),
            decaying in prop::bool::ANY,
        ) {
            let rho = integer(i64::from(decaying));
            let found = with(&poles, rho, Modes::Polynomial);
            let numbers: Vec<f64> = exact(&poles).iter().filter_map(ToPrimitive::to_f64).collect();
            let exp = |t: f64| (1..=4).map(|k| -f64::powi(-1.0, k) * t).collect();
            let rational = |t: f64| {
                let factorial = |k| (1..=k).map(f64::from).product::<f64>();
                (1..=4).map(|k| -f64::powi(-1.0, k) * factorial(k) * t.powi(k + 1)).collect()
            };
            let closed_loop = ClosedLoop {
                gains: &numbers,
                tau: 1.0,
                r: if decaying { &exp } else { &rational },
                stretched: if decaying { &|t: f64| -t.ln() } else { &|t: f64| (1.0 - t) / t },
            };
            let small = deadline(&closed_loop, &vec![1.0; poles.len()], 1e-3).largest_eps.is_some();
            prop_assert_eq!(small, found.x_to_zero);
        }
    }

    #[test]
    fn bounds_of_the_rate_decide_as_far_as_they_can() {
        let between = |poles: &[i64], low: i64, high: i64, modes| {
            let ends = [low, high].map(|end| BigRational::new(end.into(), 10.into()));
            let found = growth_between(&exact(poles), [&ends[0], &ends[1]], modes)?;
            Some((found.x_to_zero, found.u_bounded))
        };
        use Modes::{Other, Polynomial};
        assert_eq!(between(&[-3, -4], 9, 11, Other), Some((true, Some(true))));
        // The line of u, at -2 rho, is between -1.8 and -2.2; that of x between -0.9 and -1.1.
        assert_eq!(between(&[-2, -4], 9, 11, Other), Some((true, None)));
        assert_eq!(between(&[-1, -4], 9, 11, Other), None);
        assert_eq!(between(&[-1, -4], 6, 7, Other), Some((true, Some(false))));
        assert_eq!(between(&[-1, -5], 12, 13, Other), Some((false, Some(false))));
        // At -m rho there may be a mode that adds nothing to u.
        assert_eq!(between(&[-1, -3, -4], 9, 11, Polynomial), Some((false, None)));
        assert_eq!(between(&[-1, -3, -4], 12, 13, Polynomial), Some((false, Some(false))));
    }

    #[test]
    fn sixteen_decimal_poles() {
        let poles: Vec<_> = (1..=16)
            .map(|i| Pole::real(BigRational::new((-16_000 - 137 * i).into(), 1000.into())))
            .collect();
        let found = growth(&gains(&poles).expect("real"), &integer(1), Modes::Polynomial);
        assert!(found.x_to_zero && found.u_to_zero == Some(true));
        assert_eq!(found.largest_rho.map(digits), Some("1".to_owned()));
    }
}
