//! Mappings of the user's that mix a slow approach to the deadline with a quick one, against the
//! definition in long arithmetic: near the deadline the quick part has left the range of numbers.

use crate::support;

use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::reference::{Call, call, evaluate, tolerance};
use ptc_codegen::request::Spec;
use support::in_pairs;
use support::optimised;
use support::specs::{rounded, spec};

/// Quick parts, each mixed with a part that decays like 1/t.
const QUICK: [&str; 12] = [
    "tau*tanh(b*t)",
    "tau*(tanh(b*t) + tanh(2*b*t))/2",
    "tau*tanh(b*t)*tanh(3*t)",
    "tau*(1 - 1/(b + (1 - b)*cosh(3*t) + sinh(t)))",
    "tau*sinh(b*t)/sqrt(1 + sinh(b*t)^2)",
    "2*tau*atan(sinh(b*t))/pi",
    "tau*(exp(b*t) - 1)/(exp(b*t) + 1)",
    "tau*(1 - 3/(1 + exp(b*t) + exp(2*t)))",
    "tau*(1 - 2/(cosh(b*t) + cosh(a*t)))",
    "tau*(2^t - 1)/(2^t + 1)",
    "tau*(1 - 2/(1 + exp(b*t + t^2/50)))",
    "tau*(1 - (1 + sinh(b*t))^(-1/2))",
];

const SLOW: &str = "tau*a*t/(1 + a*t)";
/// From this T/tau on the quick parts are below e^-1000, and long arithmetic has no exponential for
/// them: the definition is that of the slow part alone.
const SLOW_ALONE: f64 = 5e-5;

fn value(parameter: Parameter, tau: f64, t0: f64) -> f64 {
    match parameter {
        Parameter::Tau => tau,
        Parameter::StartTime => t0,
        Parameter::Eps => 1e-13,
        Parameter::UMax => f64::INFINITY,
        Parameter::Gain(i) => [7.082164375602948, 2.5, 0.75, 3.25, 1.5, 4.0][i - 1],
        Parameter::Named(name) if name.text() == "a" => 0.9668830203391356,
        Parameter::Named(name) if name.text() == "b" => 0.1890509347698185,
        other => panic!("{other:?}"),
    }
}

fn read(mu: &str, n: &str, precision: &str) -> Spec {
    spec(&[("n", n), ("mu", mu), ("precision", precision), ("allow", "growth")])
}

/// The worst error of u, as a part of what is allowed, and the T/tau at which it is, for times of
/// which each goes with the spec that defines u there.
fn worst(spec: &Spec, tau: f64, t0: f64, calls: &[(f64, &Spec)]) -> (f64, f64) {
    let settle = |value: f64| rounded(value, spec.precision);
    let (tau, t0) = (settle(tau), settle(t0));
    let parameter = |p| settle(value(p, tau, t0));
    let program = optimised(spec);
    let x = [-0.6161580515342653, 1.5, -0.25, 2.0, 0.125, -1.0].map(settle);
    let x = &x[..spec.n];
    let mut worst = (0.0, 1.0);
    for (t, definition) in calls {
        let t = settle(*t);
        let call = Call { parameter: &parameter, x0: x, t, x, laws: &[], after: 0.0 };
        let found = evaluate(definition, &call);
        let found = found.unwrap_or_else(|| panic!("no digits at {t}: {}", definition.command()));
        let control = found.control.expect("a law");
        let u = Interpreter::new(&program, &call::inputs(&call, spec.states())).value(program.step);
        let error = control.error(u) / tolerance::of(spec);
        if error > worst.0 || !u.is_finite() {
            worst = (if u.is_finite() { error } else { f64::NAN }, (tau - (t - t0)) / tau);
        }
        if !u.is_finite() {
            break;
        }
    }
    worst
}

/// Prints the worst error of each, as a part of what is allowed.
#[test]
fn a_quick_part_does_not_spoil_a_slow_one() {
    let kinds = [("1", "f64"), ("3", "f64"), ("3", "f32")];
    let each = |quick| kinds.map(|(n, precision)| (quick, n, precision));
    let cases: Vec<_> = QUICK.into_iter().flat_map(each).collect();
    let told = in_pairs(&cases, |(quick, n, precision)| {
        let spec = read(&format!("({SLOW} + {quick})/2"), n, precision);
        let alone = read(&format!("({SLOW} + tau)/2"), n, precision);
        // The powers of 10, to some thousand units of the last place of t.
        let last = if spec.precision == Precision::F64 { 12 } else { 4 };
        let call = |k: i32| {
            let share = 10f64.powi(-k);
            (2.0 - 2.0 * share, if share < SLOW_ALONE { &alone } else { &spec })
        };
        worst(&spec, 2.0, 0.0, &(1..=last).map(call).collect::<Vec<_>>())
    });
    let mut wrong = Vec::new();
    for ((quick, n, precision), (error, share)) in cases.iter().zip(told) {
        let line = format!("{quick:50} n = {n} {precision}: {error:.2} at T/tau = {share:.0e}");
        println!("{line}");
        if error.is_nan() || error > 1.0 {
            wrong.push(line);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A tangent, whose complement has a pole at the start, beside what is as slow as it is.
#[test]
fn a_tangent_is_mixed() {
    let mu = format!("({SLOW} + 2*tau*atan(3*t)/pi)/2");
    let latching = [("n", "2"), ("mu", &mu), ("pi0", "xi2_0/8 - 2*xi1 - 3*xi2")];
    for spec in
        [read(&mu, "1", "f64"), read(&mu, "3", "f64"), read(&mu, "6", "f64"), spec(&latching)]
    {
        let calls: Vec<_> = (0..=12).map(|k| (2.0 - 2.0 * 10f64.powi(-k), &spec)).collect();
        let (error, share) = worst(&spec, 2.0, 0.0, &calls);
        let n = spec.n;
        assert!(error <= 1.0, "n = {n}: {error} of what is allowed at T/tau = {share:e}");
    }
}

/// A controller and a call where no root was found, from T/tau = 1.4e-4 on.
#[test]
fn four_families_are_mixed() {
    let mu = "((tau*a*t/(1 + a*t) + tau*(1 - exp(-a*t)))*(1/2) \
              + (tau*tanh(b*t) + tau*tanh(179/500*t))*(1/2))*(1/2)";
    let spec = read(mu, "1", "f64");
    let (error, _) = worst(&spec, 0.4208117085076758, 10000.0, &[(10000.420753827631, &spec)]);
    assert!(error <= 1.0, "{error} of what is allowed");
}

/// Mappings whose differential ring closes, beside the families themselves.
const CLOSING: [&str; 8] = [
    "tau*(exp(a*t) - 1)/(exp(a*t) + 1)",
    "tau - tau/sqrt(1 + a*t)",
    "tau*(1 - ((1 + a*t)^2)^(-1/3))",
    "tau*(1 - exp(-a*t)*(1 + b*t))",
    "tau*(1 - exp(-a*t)/2 - exp(-2*a*t)/2)",
    "tau*(1 - (1 + a*t)^(-b)*exp(-a*t))",
    "tau*(1 - sqrt(exp(-a*t))/3 - 2*exp(-a*t)/3)",
    "tau*(1 - 2/(1 + exp(2*a*t)))",
];

#[test]
fn a_ring_keeps_the_digits() {
    let kinds = [("1", "f64"), ("3", "f64"), ("6", "f64"), ("3", "f32")];
    let each = |mu| kinds.map(|(n, precision)| (mu, n, precision));
    let cases: Vec<_> = CLOSING.into_iter().flat_map(each).collect();
    let told = in_pairs(&cases, |(mu, n, precision)| {
        let spec = read(mu, n, precision);
        let last = if spec.precision == Precision::F64 { 12 } else { 4 };
        let call = |k: i32| (2.0 - 2.0 * 10f64.powf(f64::from(-k) / 2.0), &spec);
        worst(&spec, 2.0, 0.0, &(0..=2 * last).map(call).collect::<Vec<_>>())
    });
    let mut wrong = Vec::new();
    for ((mu, n, precision), (error, share)) in cases.iter().zip(told) {
        let line = format!("{mu:50} n = {n} {precision}: {error:.2e} at T/tau = {share:.0e}");
        println!("{line}");
        if error.is_nan() || error > 1.0 {
            wrong.push(line);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
