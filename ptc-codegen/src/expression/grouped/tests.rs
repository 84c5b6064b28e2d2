//! Grouped forms: that they are the same function, what is affine, and where a quotient is kept.

use super::*;
use crate::expression::testing::{error, mu, random};

fn written(text: &str) -> (String, bool) {
    let form = grouped(&mu(text)).expect(text);
    (form.form.to_string(), form.affine)
}

#[test]
fn coefficients_stand_together() {
    for (text, form, affine) in [
        ("(3*t - 2*tau*t)/4 + a*t", "(3 + 4*a - 2*tau)/4*t", true),
        ("2*(a*t - tau*sin(t))/(a + 1)", "2*a/(1 + a)*t - 2*tau/(1 + a)*sin(t)", true),
        ("5*(sin(t) - t)/a", "5/a*(sin(t) - t)", true),
        ("tau - t", "tau - t", true),
        ("(1 + t)^2 - 1", "(2 + t)*t", false),
        ("a*t^2 + tau*t^3", "(tau*t + a)*t^2", false),
        ("(t + t^2)/(t + t^3)", "(1 + t)/(1 + t^2)", false),
    ] {
        assert_eq!(written(text), (form.to_owned(), affine), "{text}");
    }
}

#[test]
fn a_grouped_form_is_the_same_function() {
    let mut seed = 5;
    let mut compared = 0;
    for _ in 0..4000 {
        let (over, under) = (random(&mut seed, 3), random(&mut seed, 2));
        let whole = over.clone().div(under.clone());
        let of_quotient = quotient(&over, &under).map(|form| (&whole, form));
        let of_over = grouped(&over).map(|form| (&over, form));
        for (plain, form) in of_over.into_iter().chain(of_quotient) {
            for t in [0.37, 1.9] {
                let Some(error) = error(plain, &form.form, t) else { continue };
                assert!(error < 1e-6, "{plain} at {t}: {error} by {}", form.form);
                compared += 1;
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

#[test]
fn a_quotient_has_no_poles_but_those_that_stand_in_it() {
    for (over, under, kept) in [
        ("t*(1 + t)", "a*(1 + t)", true),
        ("t*(1 + t)", "2 + t", false),
        ("t", "t^2", false),
        ("t^2", "t*a", true),
        ("t/(1 + t)", "a/(1 + t)", true),
        ("t/(1 + t)", "a", true),
        ("1/t", "a/t^2", true),
        ("sin(t)", "cos(t)", false),
    ] {
        let found = quotient(&mu(over), &mu(under)).is_some();
        assert_eq!(found, kept, "({over})/({under})");
    }
}
