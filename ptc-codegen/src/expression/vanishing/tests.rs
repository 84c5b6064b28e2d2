//! Forms at the deadline: that they are the same function, and keep their digits.

use super::*;
use crate::expression::Subject;
use crate::expression::testing::{error, evaluate, kappa, mu, random};
use crate::mapping::{Custom, Form};

/// A mapping, and its form in which nothing cancels: kappa of w = T/tau, or (tau - mu)/tau of t.
type Known = (&'static str, fn(f64) -> f64);

const KAPPAS: [Known; 8] = [
    ("tau*ln(2 - exp(-t))/ln(2)", |w| -(-2.0 * (-w * 2f64.ln()).exp_m1()).ln()),
    ("tau*(exp(1 - exp(-t)) - 1)/(exp(1) - 1)", |w| -(-(w * (-1f64).exp_m1()).ln_1p()).ln()),
    ("tau*((2 - exp(-t))^1.3 - 1)/(2^1.3 - 1)", |w| {
        let root = (-w * (1.0 - 2f64.powf(-1.3))).ln_1p() / 1.3;
        -(-2.0 * root.exp_m1()).ln()
    }),
    ("tau*(1 - exp(-t))^1.5", |w| -(-((-w).ln_1p() / 1.5).exp_m1()).ln()),
    ("tau*(cbrt(2 - exp(-t)) - 1)/(cbrt(2) - 1)", |w| {
        let (c, h) = (2f64.cbrt(), w * (2f64.cbrt() - 1.0));
        -(h * (3.0 * c * c - 3.0 * c * h + h * h)).ln()
    }),
    ("tau*(atan(2 - exp(-t)) - atan(1))/(atan(2) - atan(1))", |w| {
        let x = (w * (2f64.atan() - 1f64.atan())).tan();
        -(5.0 * x / (1.0 + 2.0 * x)).ln()
    }),
    ("tau*tanh(1 - exp(-t))/tanh(1)", |w| {
        let end = 1f64.tanh();
        -(w * end / (1.0 - end * end * (1.0 - w))).atanh().ln()
    }),
    ("tau*atanh(t/(2*(1 + t)))/atanh(1/2)", |w| {
        // tanh(x - y) = (1/2 - tanh y)/(1 - tanh(y)/2), x = atanh(1/2).
        let y = (w * 0.5f64.atanh()).tanh();
        (1.0 - 2.0 * y) / (1.5 * y)
    }),
];

const COMPLEMENTS: [Known; 4] = [
    ("tau*sinh(1 - exp(-t))/sinh(1)", |t| {
        let q = (-t).exp();
        1f64.tanh().recip() * q.sinh() - 2.0 * (q / 2.0).sinh().powi(2)
    }),
    ("tau*sin(1 - exp(-t))/sin(1)", |t| {
        let q = (-t).exp();
        1f64.tan().recip() * q.sin() + 2.0 * (q / 2.0).sin().powi(2)
    }),
    ("tau*tan(t/(1 + t))/tan(1)", |t| {
        let s = (1.0 + t).recip();
        s.sin() / (1f64.sin() * (1.0 - s).cos())
    }),
    ("tau*(2^(t/(1 + t)) - 1)", |t| -2.0 * (-2f64.ln() / (1.0 + t)).exp_m1()),
];

fn form(text: &str) -> (Expression, Variable) {
    match Custom::new(Subject::Mu, mu(text)).expect(text).form {
        Form::Kappa(kappa) => (kappa.form, Variable::TimeToGo),
        Form::Complement(form) => (form, Variable::SinceStart),
    }
}

fn near(got: f64, truth: f64, place: &str) {
    assert!((got - truth).abs() <= 4e-15 * truth.abs(), "{place}: {got:e} for {truth:e}");
}

#[test]
fn forms_keep_their_digits() {
    for (text, truth) in KAPPAS {
        let (plain, v) = form(text);
        assert_eq!(v, Variable::TimeToGo, "{text}");
        // exp(-kappa) falls to 0 with T, and kappa itself shows few of its digits.
        let decays = text.contains("exp");
        let shown = |kappa: f64| if decays { (-kappa).exp() } else { kappa };
        let kept = vanishing(&plain, v);
        for w in [1e-13, 1e-6, 0.01, 0.5] {
            near(shown(evaluate(&kept, 2.0 * w)), shown(truth(w)), &format!("{text} at {w}"));
        }
        assert!(
            (shown(evaluate(&plain, 2e-13)) / shown(truth(1e-13)) - 1.0).abs() > 1e-5,
            "{text}"
        );
    }
    for (text, truth) in COMPLEMENTS {
        let (plain, v) = form(text);
        assert_eq!(v, Variable::SinceStart, "{text}");
        let kept = vanishing(&plain, v);
        for t in [1.0, 9.0, 30.0] {
            near(evaluate(&kept, t), 2.0 * truth(t), &format!("{text} at {t}"));
        }
    }
}

#[test]
fn sums_that_do_not_vanish_stay() {
    for text in ["2*tau - dt", "dt*(2*tau - dt)", "ln((2*tau - dt)/dt)", "1 + cos(dt)"] {
        let to_go = Expression::from(Variable::TimeToGo);
        let form =
            kappa(text).substitute(&|e| (*e == Variable::Elapsed.into()).then(|| to_go.clone()));
        assert_eq!(vanishing(&form, Variable::TimeToGo), form, "{text}");
    }
}

#[test]
fn forms_equal_their_expressions() {
    let mut seed = 7;
    let (mut compared, mut changed) = (0, 0);
    for _ in 0..4000 {
        let e = random(&mut seed, 4);
        let kept = vanishing(&e, Variable::SinceStart);
        changed += usize::from(kept != e);
        for t in [0.37, 1.9] {
            let Some(error) = error(&e, &kept, t) else { continue };
            assert!(error < 1e-6 || error.is_nan(), "{e} at {t}: {error} by {kept}");
            compared += 1;
        }
    }
    assert!(compared > 1000 && changed > 20, "{compared} compared, {changed} changed");
}

/// r_1/T, in which the sums are 0 of second order: by mu' at the stretched time.
#[test]
fn rates_keep_their_digits() {
    let rates: [Known; 2] = [
        ("tau*(exp(t/(1 + t)) - 1)/(exp(1) - 1)", |w| {
            let part = -(w * (-1f64).exp_m1()).ln_1p();
            (1.0 - part).exp() * part * part / 1f64.exp_m1() / w
        }),
        ("tau*asin(t/(2*(1 + t)))/asin(1/2)", |w| {
            let (a, x) = (0.5f64.asin(), w * 0.5f64.asin());
            let part = 2.0 * (x / 2.0).sin().powi(2) + 3f64.sqrt() * x.sin();
            part * part / (2.0 * a * (a - x).cos() * w)
        }),
    ];
    for (text, truth) in rates {
        let Form::Kappa(kappa) = Custom::new(Subject::Mu, mu(text)).expect(text).form else {
            panic!("{text} has no closed inverse")
        };
        let kept = vanishing(&kappa.rate, Variable::TimeToGo);
        for w in [1e-13, 1e-6, 0.01, 0.5] {
            near(evaluate(&kept, 2.0 * w), truth(w), &format!("{text} at {w}"));
        }
    }
}
