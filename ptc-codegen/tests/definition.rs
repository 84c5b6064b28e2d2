//! The engine against the definition: the program of each kind of controller, interpreted, gives
//! the u of `ptc_codegen::reference`, which shares nothing with the way from a spec to a program.

mod support;

use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, number, passes};
use ptc_codegen::reference::{Call, call, evaluate, tolerance};
use ptc_codegen::request::Spec;
use support::design;

/// Each mapping, with orders that reach every branch of its closed forms.
const MAPPINGS: [(&str, &str, &[usize]); 26] = [
    ("mu", "exp", &[1, 2, 3, 7]),
    ("mu", "exp(a=2)", &[4]),
    ("mu", "rational", &[1, 2, 3, 7]),
    ("mu", "power", &[1, 2, 3, 7]),
    ("mu", "power(m=2)", &[1, 3, 4]),
    ("mu", "power(m=1/2)", &[2, 5]),
    ("mu", "tan", &[1, 2, 3, 7]),
    ("mu", "tanh", &[1, 2, 3, 7]),
    ("mu", "algebraic", &[1, 2, 3, 7]),
    ("mu", "exp_sum", &[1, 2, 3, 6]),
    ("mu", "exp_sum(rates=[1, 2, 5])", &[3, 9]),
    ("mu", "soft", &[1, 2, 3, 7]),
    ("mu", "soft(start=0.02)", &[2, 5]),
    ("mu", "tau*(1 - (exp(-a*t) + 2*exp(-3*t))/3)", &[1, 3, 5]),
    ("mu", "mean(rational(a=a), tanh(a=b))", &[2, 4]),
    ("mu", "2*tau*atan(a*t)/pi", &[3, 5]),
    ("mu", "tau*(1 - ((1 + a*t)^(-1) + (1 + t)^(-3))/2)", &[3, 5]),
    ("mu", "tau*(1 - exp(-a*t)/(1 + ln(1 + t)/8))", &[3, 5]),
    ("mu", "tau*(1 - (exp(-a*t) + 1 - 2*atan(t)/pi)/2)", &[3, 5]),
    ("kappa", "dt/(a*(tau - dt)) + (dt/tau)^3", &[1, 3, 5]),
    ("kappa", "-ln(1 - dt/tau)/a + sqrt(1 + dt) - 1", &[2, 4]),
    ("kappa", "tan(pi*dt/(2*tau))/a", &[3]),
    ("kappa", "dt/(tau - dt) + ln(1 + dt) + dt - sin(dt)/2 + cosh(dt/2) - cos(dt/2)", &[4]),
    ("kappa", "sinh(dt)*(tau - dt)^(-2) + dt*2^dt", &[4]),
    (
        "kappa",
        "tau*atanh(dt/tau)/a + tanh(dt) + atan(dt/(1 + dt)) + tan(dt/4) - (2 + dt)^(-3)",
        &[4],
    ),
    ("kappa", "(1 - dt/tau)^(-b) - 1 + dt*(1 + dt)^(1/3) + (dt + dt^2)^3", &[4]),
];

/// An input gain with every kind of power.
const DIVISOR: &str =
    "2 + x1^2 + (1 + x1^2)^(-2) + (2 + x1^2)^(3/2) + (3 + x1^2)^(1/2) + (4 + x1^2)^(-1/3)";

/// The spec of keys and values as they are written on the command line.
fn spec(keys: &[(&str, &str)]) -> Spec {
    design(&keys.iter().map(|(key, text)| format!("{key} = {text:?}\n")).collect::<String>()).0
}

fn value(parameter: Parameter) -> f64 {
    match parameter {
        Parameter::Tau => 1.75,
        Parameter::StartTime => -0.625,
        Parameter::Eps => 1e-3,
        Parameter::UMax => 1e30,
        Parameter::M => 0.75,
        Parameter::Start => 0.125,
        Parameter::Rate(i) => [0.5, 1.5, 2.25][i - 1],
        Parameter::Gain(i) => [3.0, 0.5, 1.25][i % 3],
        Parameter::Named(name) if name.text() == "b" => 2.5,
        _ => 1.375,
    }
}

/// The worst error of u over the way to the deadline and past it, as a part of what is allowed,
/// by the program as it is called in one step and by its gains.
fn worst(spec: &Spec) -> f64 {
    let program = passes::optimise(lower(spec, &Law::of(spec)), &mut |_, _| {});
    let settle = |value: f64| number::round(&exact(value), spec.precision);
    let parameter = |p| match spec.fixed.get(&p).and_then(Fixed::number) {
        Some(fixed) => number::round(fixed, spec.precision),
        None => settle(value(p)),
    };
    let state = |of: f64| -> Vec<f64> {
        (1..=spec.n).map(|j| settle((of + j as f64).sin() * 2f64.powi(j as i32 - 3))).collect()
    };
    let (tau, t0, x0) = (value(Parameter::Tau), value(Parameter::StartTime), state(0.5));
    let mut worst = 0.0_f64;
    for share in [0.0, 0.4, 0.97, 0.9997, 1.2] {
        let (t, x) = (settle(t0 + share * tau), state(share));
        let call = Call { parameter: &parameter, x0: &x0, t, x: &x, laws: &[], after: 0.0 };
        let input = call::inputs(&call, spec.states());
        let mut own = Interpreter::new(&program, &input);
        let expected = evaluate(spec, &call).and_then(|told| told.control).expect("a control");
        // What leaves the range of f32 is refused by the emitted code, and is no number here.
        if expected.scale() > 1e30 {
            continue;
        }
        let allowed = tolerance::of(spec);
        worst = worst.max(expected.error(own.value(program.step)) / allowed);
        // Those of a law with g are divided by it in `axis`.
        if !program.gains.is_empty() && spec.input_gain.is_none() {
            let u: f64 = own.values(&program.gains).iter().zip(&x).map(|(k, x)| k * x).sum();
            worst = worst.max(expected.error(u) / allowed);
        }
        if let Some(axis) = program.axis {
            let gains = own.values(&program.gains);
            let divisors = own.values(&program.divisors);
            let with_gains = |asked| match asked {
                Input::Gain(j) => gains[j - 1],
                Input::Divisor => divisors[0],
                other => input(other),
            };
            let u = Interpreter::new(&program, &with_gains).value(axis);
            worst = worst.max(expected.error(u) / allowed);
        }
    }
    worst
}

fn exact(value: f64) -> ptc_codegen::algebra::BigRational {
    ptc_codegen::algebra::BigRational::from_float(value).expect("a finite number")
}

/// Every mapping and order with the further keys that `law` gives for an order.
fn judge(law: &dyn Fn(usize) -> Vec<(&'static str, String)>) {
    for (key, mapping, orders) in MAPPINGS {
        for n in orders {
            let (order, law) = (n.to_string(), law(*n));
            let mut keys = vec![("n", order.as_str()), (key, mapping), ("allow", "growth")];
            keys.extend(law.iter().map(|(key, text)| (*key, text.as_str())));
            let part = worst(&spec(&keys));
            assert!(part <= 1.0, "{keys:?}: {part:.2} of what is allowed");
        }
    }
}

#[test]
fn gains_at_run_time() {
    judge(&|_| vec![]);
}

#[test]
fn gains_that_are_fixed() {
    let gains = |n| (1..=n).map(|i| format!("{i}.25")).collect::<Vec<_>>().join(",");
    judge(&|n| vec![("gains", gains(n))]);
}

#[test]
fn laws_of_every_kind_of_variable() {
    judge(&|n| {
        let law =
            format!("-xi1 - xi{n}*abs(xi1)/8 + min(xi{n}_0, x1_0)*dt/8 - t0*t_kappa/64 - T*xi1/8");
        let text = |text: &str| text.to_owned();
        vec![("pi0", law), ("g", text(DIVISOR)), ("precision", text("f32"))]
    });
}
