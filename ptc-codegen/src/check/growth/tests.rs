//! Designs on either side of what the deadline needs of the gains.

use num_traits::ToPrimitive;
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
