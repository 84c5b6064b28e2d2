//! Normal forms: that they are short, keep their digits, and are the same function.

use super::*;
use crate::expression::testing::{error, evaluate, kappa, mu, random};
use crate::expression::{Subject, family_form};
use crate::family::FAMILIES;
use crate::mapping::{Custom, Form};

#[test]
fn complements_are_short() {
    for (text, form) in [
        ("exp", "tau*exp(-a*t)"),
        ("rational", "tau/(1 + a*t)"),
        ("power", "tau*(1 + a*m*t)^(-1/m)"),
        ("tan", "2*tau*atan(1/(a*t))/pi"),
        ("tanh", "2*tau/(1 + exp(2*a*t))"),
        ("algebraic", "tau/(sqrt(1 + a^2*t^2)*(a*t + sqrt(1 + a^2*t^2)))"),
        ("mean(exp(a=a), exp(a=b))", "tau*(exp(-a*t) + exp(-b*t))/2"),
        ("mean(rational(a=1), tanh(a=2))", "tau/(2*(1 + t)) + tau/(1 + exp(4*t))"),
        ("tau*(1 - 1.5*exp(-t) + 0.5*exp(-2*t))", "tau*(3 - exp(-t))*exp(-t)/2"),
        ("tau*(1 - 1/cosh(t))", "tau/cosh(t)"),
        ("tau*sinh(a*t)/cosh(a*t)", "2*tau/(1 + exp(2*a*t))"),
        ("tau*(1 - 2^(-t/a))", "tau*2^(-t/a)"),
        ("tau*(1 - 2^(0/a))", "tau"),
        ("tau*(t + min(t, 1))", "tau*(1 - t - min(t, 1))"),
    ] {
        let got = complement(&mu(text)).to_string();
        assert_eq!(got, form, "{text}");
    }
}

#[test]
fn kappas_are_short_in_time_to_go() {
    for (text, form) in [
        ("-ln(1 - dt/tau)/a", "-ln(T/tau)/a"),
        ("dt/(a*(tau - dt))", "(tau - T)/(a*T)"),
        ("((1 - dt/tau)^(-m) - 1)/(a*m)", "((T/tau)^(-m) - 1)/(a*m)"),
        ("tan(pi*dt/(2*tau))/a", "cos(pi*T/(2*tau))/(a*sin(pi*T/(2*tau)))"),
        ("atanh(dt/tau)/a", "ln((2*tau - T)/T)/(2*a)"),
        ("dt/tau/sqrt(1 - (dt/tau)^2)", "(tau - T)/sqrt(T*(2*tau - T))"),
        ("ln((tau + 9*dt)/(tau - dt))", "ln((10*tau - 9*T)/T)"),
        ("sin(pi*dt/(2*tau))/cos(pi*dt/(2*tau))", "cos(pi*T/(2*tau))/sin(pi*T/(2*tau))"),
    ] {
        let got = Custom::new(Subject::Kappa, kappa(text)).expect(text);
        let got = kappa_of(&got);
        assert_eq!(got.to_string(), form, "{text}");
    }
}

fn kappa_of(custom: &Custom) -> Expression {
    match &custom.form {
        Form::Kappa(kappa) => kappa.form.clone(),
        Form::Complement(form) => panic!("{form} has no closed inverse"),
    }
}

fn near(got: f64, truth: f64, what: &str) {
    let error = (got - truth).abs();
    assert!(error <= 1e-14 * truth.abs(), "{what}: {got:e} for {truth:e}");
}

/// At tau = 2, a = 3/4, m = 1/2.
fn truth(name: &str, a: f64, t: f64) -> f64 {
    let y = a * t;
    match name {
        "exp" => 2.0 * (-y).exp(),
        "rational" => 2.0 / (1.0 + y),
        "power" => 2.0 * (1.0 + y / 2.0).powi(-2),
        "tanh" => 4.0 / (1.0 + (2.0 * y).exp()),
        _ => 2.0 / ((1.0 + y * y).sqrt() * (y + (1.0 + y * y).sqrt())),
    }
}

#[test]
fn complements_keep_their_digits() {
    for name in ["exp", "rational", "power", "tanh", "algebraic"] {
        let one = complement(&mu(name));
        let two = complement(&mu(&format!("mean({name}(a=1/2), {name}(a=2))")));
        let scaled = complement(&mu(&format!("{name}(a=a/3)*(1 + 2/4)*2/3")));
        for t in [0.0, 1e-3, 0.4, 1.0, 20.0, 37.0, 300.0, 1e3, 4e9] {
            near(evaluate(&one, t), truth(name, 0.75, t), name);
            near(evaluate(&two, t), (truth(name, 0.5, t) + truth(name, 2.0, t)) / 2.0, name);
            near(evaluate(&scaled, t), truth(name, 0.25, t), name);
        }
    }
    let tan = complement(&mu("tan"));
    for (y, truth) in [(0.0, 2.0), (1.0, 1.0), (3f64.sqrt(), 2.0 / 3.0)] {
        near(evaluate(&tan, y / 0.75), truth, "tan");
    }
    near(evaluate(&tan, 1e12), 4.0 / (std::f64::consts::PI * 0.75e12), "tan");
}

#[test]
fn kappas_keep_their_digits() {
    for info in FAMILIES.iter().filter(|info| !info.kappa_in_time_to_go.is_empty()) {
        let given = family_form(info, Subject::Kappa).expect("a form");
        let form = kappa_of(&Custom::new(Subject::Kappa, given.clone()).expect(info.name));
        let twice = given.clone().add(given.clone());
        let twice = kappa_of(&Custom::new(Subject::Kappa, twice).expect(info.name));
        let (a, tau, pi) = (0.75, 2.0, std::f64::consts::PI);
        for to_go in [2e-12f64, 1e-6, 0.1, 1.0] {
            let v = to_go * (2.0 * tau - to_go);
            let truth = match info.name {
                "exp" => -(to_go / tau).ln() / a,
                "rational" => (tau - to_go) / to_go / a,
                "power" => ((tau / to_go).sqrt() - 1.0) / (a * 0.5),
                "tan" => 1.0 / (a * (pi * to_go / (2.0 * tau)).tan()),
                "tanh" => ((2.0 * tau - to_go) / to_go).ln() / (2.0 * a),
                // start = 3/4.
                "soft" => -(to_go / tau * (1.0 + 0.25 * (1.0 - to_go / tau))).ln() / a,
                _ => (tau - to_go) / (a * v.sqrt()),
            };
            near(evaluate(&form, to_go), truth, info.name);
            near(evaluate(&twice, to_go), 2.0 * truth, info.name);
        }
    }
}

#[test]
fn what_stands_once_is_inverted() {
    for (name, inverse) in [
        ("exp", "-ln(T/tau)/a"),
        ("rational", "(tau - T)/(a*T)"),
        ("power", "((T/tau)^(-m) - 1)/(a*m)"),
        ("tan", "cos(pi*T/(2*tau))/(a*sin(pi*T/(2*tau)))"),
        ("tanh", "ln((2*tau - T)/T)/(2*a)"),
    ] {
        let custom = Custom::new(Subject::Mu, mu(name)).expect(name);
        assert_eq!(kappa_of(&custom).to_string(), inverse);
    }
}

#[test]
fn what_grows_too_large_stays_as_it_is() {
    let product = (1..9).map(|k| format!("(sqrt({k} + t) + {k})")).collect::<Vec<_>>();
    let given = mu(&format!("tau*(1 - exp(-t)*{})", product.join("*")));
    assert_eq!(complement(&given), Expression::from(Parameter::Tau).sub(given));
}

#[test]
fn powers_cancel_whether_they_are_multiplied_out_or_not() {
    for (text, form) in [
        ("(1 + t)^3/((a + t)*(1 + t)^2)", "(1 + t)/(a + t)"),
        ("(1 + t + a*t^2)^300/(1 + t + a*t^2)^299", "1 + a*t^2 + t"),
        ("t*(1 + t + a*t^2)^299/(1 + t + a*t^2)^300", "t*(1 + a*t^2 + t)^(-1)"),
    ] {
        assert_eq!(normal(&mu(text)).to_string(), form, "{text}");
    }
}

#[test]
fn the_normal_form_is_the_same_function() {
    let mut seed = 1;
    let (mut compared, mut lost) = (0, 0);
    for _ in 0..5000 {
        let e = random(&mut seed, 4);
        let rest = complement(&e);
        let forms = [normal(&e), Expression::from(Parameter::Tau).sub(rest)];
        for t in [0.37, 1.9] {
            for form in &forms {
                let Some(error) = error(&e, form, t) else { continue };
                assert!(error < 1e-6 || error.is_nan(), "{e} at {t}: {error} by {form}");
                compared += 1;
                // Of what divides by ln(0) no form has to be finite.
                lost += usize::from(error.is_nan());
            }
        }
    }
    assert!(compared > 1000 && lost * 100 < compared, "{lost} of {compared}");
}

#[test]
fn what_passes_zero_is_complemented_too() {
    let form = complement(&mu("tau*(atan(t - 3) + atan(3))/(pi/2 + atan(3))"));
    let scale = 2.0 / (std::f64::consts::FRAC_PI_2 + 3f64.atan());
    for t in [0.0, 1.0, 3.0, 5.0] {
        let truth = scale * (std::f64::consts::FRAC_PI_2 - (t - 3.0f64).atan());
        assert!((evaluate(&form, t) - truth).abs() < 1e-14, "at {t}");
    }
    near(evaluate(&form, 3.0 + 1e12), scale * 1e-12, "far out");
}
