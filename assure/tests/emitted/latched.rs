//! The state that is latched in stretched coordinates, xi_1..xi_n at the start, against the
//! definition: where an entry of BB_n is 0 there, it must be 0 and no rounding of larger ones.

use crate::support;

use ptc_codegen::parameter::Parameter;
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::reference::{Call, call, evaluate, tolerance};
use ptc_codegen::request::Spec;
use support::optimised;
use support::random::Random;
use support::specs::{rounded, spec};

const FAMILIES: [&str; 8] =
    ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum", "soft"];

/// The worst error of u with pi0 = -xi_n at the start, as a part of what is allowed.
fn worst(spec: &Spec, random: &mut Random) -> f64 {
    let program = optimised(spec);
    let settle = |value: f64| rounded(value, spec.precision);
    let mut size = || settle(random.sign() * random.magnitude(1e-2, 1e2));
    let (tau, t0, a, m) = (size().abs(), 0.0, size().abs().sqrt(), 0.7);
    let parameter = |p| match p {
        Parameter::Tau => tau,
        Parameter::StartTime => t0,
        Parameter::Eps => settle(1e-6 * tau),
        Parameter::UMax => f64::INFINITY,
        Parameter::M => settle(m),
        Parameter::Start => settle(0.2),
        Parameter::Rate(i) => settle(a * i as f64),
        _ => settle(a),
    };
    let t = settle(0.75 * tau);
    let x0: Vec<f64> = (0..spec.n).map(|_| size()).collect();
    let x = vec![0.0; spec.n];
    let call = Call { parameter: &parameter, x0: &x0, t, x: &x, laws: &[], after: 0.0 };
    let expected = evaluate(spec, &call).and_then(|outcome| outcome.control).expect("a control");
    let u = Interpreter::new(&program, &call::inputs(&call, spec.states())).value(program.step);
    expected.error(u) / tolerance::of(spec)
}

#[test]
fn the_latched_state_is_that_of_the_definition() {
    let mut random = Random(3);
    for precision in ["f64", "f32"] {
        for family in FAMILIES {
            for n in ["2", "5", "7"] {
                let law = format!("-xi{n}_0");
                let keys = [("n", n), ("mu", family), ("precision", precision), ("pi0", &law)];
                let spec = spec(&[&keys[..], &[("allow", "growth")]].concat());
                let worst = (0..6).map(|_| worst(&spec, &mut random)).fold(0.0, f64::max);
                assert!(worst <= 1.0, "{family}, n = {n}, {precision}: {worst:.2} of the allowed");
            }
        }
    }
}
