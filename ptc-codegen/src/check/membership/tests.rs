use super::*;
use crate::algebra::integer;
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::testing::{evaluate, kappa, mu, random};
use crate::expression::{Subject, Variable};

/// Values and bounds in tenths.
type Tenths<'a> = &'a [(&'a str, i64, i64)];

fn of(subject: Subject, text: &str, numbers: Tenths<'_>) -> Membership {
    let given = if subject == Subject::Mu { mu(text) } else { kappa(text) };
    let custom = Custom::new(subject, given).expect(text);
    prove(&custom, 3, &|parameter| {
        let named = numbers.iter().find(|(name, ..)| *name == parameter.spelling());
        named.map(|(_, low, high)| (integer(*low) / integer(10), integer(*high) / integer(10)))
    })
}

fn proved(subject: Subject, text: &str, numbers: Tenths<'_>) {
    let found = of(subject, text, numbers);
    for (condition, verdict) in found.conditions() {
        assert_eq!(*verdict, Verdict::Proved, "{text}: {condition}: {verdict}");
    }
}

/// The worst verdict in words.
fn worst(subject: Subject, text: &str, numbers: Tenths<'_>) -> String {
    of(subject, text, numbers).worst().1.to_string()
}

#[test]
fn families_are_members_for_all_parameters() {
    for name in ["exp", "rational", "power", "tan", "tanh", "algebraic"] {
        for subject in [Subject::Mu, Subject::Kappa] {
            proved(subject, name, &[]);
            proved(subject, name, &[("tau", 20, 20), ("a", 5, 15), ("m", 20, 20)]);
            proved(subject, name, &[("tau", 20, 50), ("a", 7, 7), ("m", 3, 20)]);
        }
    }
}

#[test]
fn what_is_made_of_families_is_a_member() {
    for text in [
        "mean(exp(a=a), exp(a=b))",
        "mean(exp(a=1), rational(a=2))",
        "mean(algebraic(a=1), tanh(a=b), tan(a=3))",
        "tau*(1 - 1.5*exp(-t) + 0.5*exp(-2*t))",
        "tau*(1 - exp(-a*t - t^2))",
        "exp(a=1)/2 + power(a=b, m=3)/2",
        "tau*sinh(a*t)/cosh(a*t)",
        "tau*(1 - 2^(-t/a))",
        "tau*ln(1 + t)/(1 + ln(1 + t))",
    ] {
        proved(Subject::Mu, text, &[]);
    }
    for text in [
        "-ln(1 - dt/tau) + dt",
        "dt/(tau - dt) + (dt/(tau - dt))^3",
        "ln((tau + 9*dt)/(tau - dt))",
        "tan(pi*dt/(2*tau))/a",
        "atanh(dt/tau)/a",
        "(tau/(tau - dt))^2 - 1",
        "exp + rational + tan",
        "dt/tau/sqrt(1 - (dt/tau)^2)",
        "2*dt/(tau - dt) + sin(2*pi*dt/tau)/7",
        "(tau/(tau - dt))^a + (tau/(tau - dt))^b - 2",
    ] {
        proved(Subject::Kappa, text, &[]);
    }
}

#[test]
fn numbers_prove_what_signs_do_not() {
    let text = "tau*(1 - b*exp(-t) + (b - 1)*exp(-2*t))";
    proved(Subject::Mu, text, &[("b", 12, 18)]);
    assert!(
        worst(Subject::Mu, text, &[("b", 10, 50)]).starts_with("refuted at t = 0, tau = 1, b = 3")
    );
    assert!(worst(Subject::Mu, text, &[]).contains("fix them or give bounds"));
    proved(Subject::Mu, "tau*(1 - exp(-t)*(10 + 3*cos(t))/13)", &[]);
    proved(Subject::Mu, "tau*(1 - exp(-t)*(1 + t/2 + sin(t)/5))", &[]);
    proved(Subject::Kappa, "tau/(tau - dt) - 1 + sin(9*dt/tau)/10", &[]);
    proved(Subject::Kappa, "ln((2 + 9*dt)/(2 - dt))", &[("tau", 20, 20)]);
    // Its derivative is less than 0 near t = 1.5 by a part in a thousand only.
    let text = "tau*(1 - exp(-t)*(1 + t - 0.5*t^2 + 0.25*t^3))";
    assert!(
        worst(Subject::Mu, text, &[]).starts_with("refuted"),
        "{}",
        worst(Subject::Mu, text, &[])
    );
}

#[test]
fn what_is_no_member_is_refuted() {
    for (text, verdict) in [
        ("tau*(1 - exp(a*t))", "refuted at all times: mu does not grow"),
        ("tau*(1 - exp(-a*t))^2", "refuted at t = 0: mu' is 0"),
        ("2*tau*(1 - exp(-a*t))", "refuted at t = inf: mu tends to 2*tau in place of tau"),
        ("tau*(1 - exp(-t)*cos(5*t))", "refuted at t = 0.75, tau = 1: mu' is not positive"),
        ("tau*t/(1 + t^2)", "refuted at t = 1, tau = 1: mu' is not positive"),
        ("min(tau, t)", "refuted at t = 1.25, tau = 1: mu' is not positive"),
        (
            "b*(1 - exp(-t))",
            "refuted at t = inf, tau = 1, b = 1.125: mu tends to b in place of tau",
        ),
        ("tau*(1 - exp(-t)) + ln(t - 1)", "refuted at t = 0, tau = 1: mu has no value"),
    ] {
        assert_eq!(worst(Subject::Mu, text, &[]), verdict, "{text}");
    }
    for (text, verdict) in [
        ("dt/tau", "refuted at dt = tau: kappa tends to 1 in place of infinity"),
        ("-ln(1 - dt/tau)/a + 1", "refuted at dt = 0: kappa(0) = 1, which is not 0"),
        (
            "tan(pi*dt/tau)",
            "refuted at dt = 0.515625*tau, tau = 1: kappa is less than at dt = 0.484375*tau",
        ),
        ("ln(dt/(tau - dt))", "refuted at dt = 0, tau = 1: kappa(0) = ln(0), which is not 0"),
        ("dt/(2*tau - dt)", "refuted at dt = tau: kappa tends to 1 in place of infinity"),
    ] {
        assert_eq!(worst(Subject::Kappa, text, &[]), verdict, "{text}");
    }
}

#[test]
fn what_has_its_value_by_continuity_only_is_not_refuted() {
    for text in ["tau*(1 - exp(-abs(t)))", "sqrt(tau^2*t^2/(1 + t^2))"] {
        let found = worst(Subject::Mu, text, &[]);
        assert!(found.starts_with("undecided"), "{text}: {found}");
    }
}

#[test]
fn a_parameter_that_may_be_negative_is_no_rate() {
    let numbers: Tenths<'_> = &[("a", -10, 10)];
    for text in ["tau*(1 - exp(-a*t))", "tau*tanh(a*t)", "tau*a*t/sqrt(1 + (a*t)^2)"] {
        assert_ne!(worst(Subject::Mu, text, numbers), "proved", "{text}");
    }
    let refuted = worst(Subject::Mu, "tau*tanh(a*t)", &[("a", -10, -5)]);
    assert!(refuted.starts_with("refuted"), "{refuted}");
}

#[test]
fn every_value_is_in_its_enclosure() {
    let mut seed = 5;
    let mut found = 0;
    let exact = |value: f64| BigRational::from_float(value).expect("a finite number");
    for _ in 0..300 {
        let e = random(&mut seed, 4);
        let mut names = Names::new();
        names.insert(Parameter::Tau.into(), Interval::integer(2));
        names.insert(mu("a"), Interval::exact(&exact(0.75)));
        names
            .insert(Variable::SinceStart.into(), Interval::between(&exact(1.2), Some(&exact(2.3))));
        let Some(value) = Evaluator::new().value(&e, &names) else { continue };
        for at in [1.2, 1.6, 2.3] {
            let truth = evaluate(&e, at);
            let moved = (evaluate(&e, at * (1.0 + 1e-12)) - truth).abs();
            if !(truth.abs() < 1e9 && moved <= 1e-9 * truth.abs()) {
                continue;
            }
            let slack = 1e-9 * (1.0 + truth.abs());
            let room = Interval::between(&exact(-truth - slack), Some(&exact(slack - truth)));
            assert!(value.interval.plus(&room).has_zero(), "{e} at {at}: {truth}");
            found += 1;
        }
    }
    assert!(found > 100, "{found}");
}
