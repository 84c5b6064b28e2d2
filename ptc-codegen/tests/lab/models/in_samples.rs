//! Models that are not linear with a clock in samples: u from the law of the chain, the emitted C in closed loop,
//! and what needs a linear model.

use super::in_c;
use super::support::{refused_at, spec};

use ptc_codegen::code::{Instance, Status};
use ptc_codegen::request::Spec;
use ptc_codegen::samples;

/// A body on a stiff spring, whose actuator is stronger to one side; k is set at run time.
const SPRING: &str = "name = \"spring\"
mu = \"exp(a=1)\"
clock = \"samples\"
sample_time = 0.02
poles = [-3, -4]
[params]
tau = 0.8
k = [1, 9]
[model]
states = [\"q\", \"w\"]
input = \"F\"
output = \"q + q^3/6\"
dynamics = { q = \"w\", w = \"(2 + sin(q))*F - k*q^3\" }
";

/// The chain of the same order, poles and samples.
const CHAIN: &str = "n = 2
mu = \"exp(a=1)\"
clock = \"samples\"
sample_time = 0.02
poles = [-3, -4]
u_max = inf
tau = 0.8
";

/// u and the status of `step` at tick k.
fn step(spec: &Spec, parameters: &[f64], k: u32, x: &[f64]) -> (f64, Status) {
    let code = samples::controller(spec, spec.sampled().expect("samples"), Vec::new());
    let given = spec.run_time_parameters().zip(parameters.iter().copied());
    let mut instance = Instance::with_parameters(&code, given).expect("legal parameters");
    let outcome = instance.call("step", &[("k", &[f64::from(k)]), ("x", x)]);
    (outcome.results.get("u").map_or(0.0, |u| u[0]), outcome.status)
}

#[test]
fn u_is_what_the_chain_wants_less_f_over_g() {
    let (spring, chain) = (spec(SPRING), spec(CHAIN));
    let names: Vec<_> = spring.run_time_parameters().map(|p| p.spelling()).collect();
    assert_eq!(names, ["u_max", "k"]);
    let mut most = 0.0_f64;
    for case in 0..400_u32 {
        let part = |i: u32| f64::from((case * 7919 + i * 104_729) % 2001) / 1000.0 - 1.0;
        let (q, w, k, tick) = (1.4 * part(1), 3.0 * part(2), 5.0 + 4.0 * part(3), case % 44);
        // The chain by hand: x2 = (1 + q^2/2) w, and its rate.
        let slope = 1.0 + q * q / 2.0;
        let f = q * w * w - slope * k * q.powi(3);
        let g = slope * (2.0 + q.sin());
        // The law of a model plans to be at rest two samples early.
        let (wanted, _) = step(&chain, &[], tick + 2, &[q + q.powi(3) / 6.0, slope * w]);
        let (u, status) = step(&spring, &[f64::INFINITY, k], tick, &[q, w]);
        let exact = (wanted - f) / g;
        most = most.max((u - exact).abs() / ((wanted.abs() + f.abs()) / g));
        assert_eq!(status, if tick < 40 { Status::Ok } else { Status::Hold });
        // Clipped is what the plant is given, not what the law wants.
        let (clipped, status) = step(&spring, &[exact.abs() / 2.0, k], tick, &[q, w]);
        assert_eq!((clipped.abs(), status), (exact.abs() / 2.0, Status::Saturated));
    }
    // Some forty roundings of either side, of the terms before they cancel.
    assert!(most < 1e-14, "{most:e}");
}

/// The model in C, without the controller.
fn plant(h: f64) -> String {
    format!(
        "static double u;\nstatic int rates(double t, const double *x, double *dx)\n{{\n    (void)t;\n    dx[0] = x[1];\n    \
         dx[1] = (2.0 + sin(x[0])) * u - 4.0 * x[0] * x[0] * x[0];\n    return 0;\n}}\n{}\
         int main(void)\n{{\n    static const spring_params params = {{ .u_max = INFINITY, .k = 4.0 }};\n    spring c;\n    double x[2] = {{ 0.7, -0.4 }};\n    \
         uint32_t n = (uint32_t)(0.8 / {h:?} + 0.5);\n    if (spring_init(&c, &params) != PTC_OK) {{ return 1; }}\n    \
         spring_arm(&c, 4294967290U);\n    for (uint32_t k = 0; k < n; k++) {{\n        \
         if (spring_step(&c, 4294967290U + k, x, &u) != PTC_OK) {{ return 2; }}\n        \
         for (int i = 0; i < 16; i++) {{ advance(0.0, {h:?} / 16.0, x); }}\n    }}\n    \
         printf(\"%.17g %.17g\\n\", x[0] + x[0] * x[0] * x[0] / 6.0, (1.0 + x[0] * x[0] / 2.0) * x[1]);\n    return 0;\n}}\n",
        in_c::advance(2)
    )
}

/// Halved, the period leaves at most 2^-(n+2-i) of x_i, and far less of what was there at the start.
#[test]
fn the_emitted_c_ends_within_the_order_of_the_period() {
    let mut before: Option<Vec<f64>> = None;
    for h in [0.16, 0.08, 0.04] {
        let text = SPRING.replace("sample_time = 0.02", &format!("sample_time = {h:?}"));
        let name = format!("models_in_samples_{}", (h * 1000.0) as u32);
        let end = in_c::run(&name, &spec(&text), &plant(h)).remove(0);
        // Above rounding, so that the ratios below say something, and below a twentieth of the start.
        assert!(end.iter().all(|x| x.abs() > 1e-13 && x.abs() < 0.05), "{end:?}");
        if let Some(before) = before {
            for (i, (x, before)) in (1..).zip(end.iter().zip(&before)) {
                assert!(x.abs() < before.abs() * 0.5_f64.powi(4 - i), "x{i}: {before:e} {x:e}");
            }
        }
        before = Some(end);
    }
}

#[test]
fn failures_change_nothing_and_give_no_u() {
    let spring = spec(&SPRING.replace("(2 + sin(q))*F", "q*F"));
    let given = [f64::INFINITY, 4.0];
    assert_eq!(step(&spring, &given, 3, &[0.0, 0.1]), (0.0, Status::Range));
    assert_eq!(step(&spring, &given, 3, &[f64::NAN, 0.1]), (0.0, Status::Input));
    assert_eq!(step(&spring, &given, 3, &[0.5, 0.1]).1, Status::Ok);
}

#[test]
fn what_needs_a_linear_model_is_refused() {
    for (from, to, line, message) in [
        ("poles", "measured = [\"q\"]\npoles", 5, "an observer needs a linear model: "),
        ("poles", "measured = [\"w\", \"q\"]\npoles", 5, "an observer needs a linear model: "),
        ("poles", "disturbance = \"constant\"\npoles", 5, "an observer needs a linear model: "),
        (
            "poles = [-3, -4]",
            "poles = [-3, -4]\ndelay = 0.5",
            6,
            "the prediction over a delay needs a linear model",
        ),
        ("poles", "observer_poles = [-3]\npoles", 5, "without an observer"),
        ("poles", "n = 3\npoles", 5, "the relative degree of the output is 2"),
        ("poles", "reference = \"sin(t - t0)\"\npoles", 5, "`t0` in a reference in samples"),
        ("exp(a=1)", "tan(a=1)", 2, "for the mapping exp alone"),
    ] {
        let text = SPRING.replacen(from, to, 1);
        refused_at("models_in_samples_mistakes", &text, line, [message, ""]);
    }
    spec(&SPRING.replacen("poles", "measured = [\"q\", \"w\"]\ndelay = 0\npoles", 1));
}

/// Bits of sin differ by library; a polynomial has those of IEEE 754.
#[test]
fn a_self_test_takes_what_has_the_same_bits_everywhere() {
    let refused = ptc_codegen::generate_selftest(&spec(SPRING)).expect_err("sin");
    assert!(refused[0].message.contains("calls sin"), "{refused:?}");
    let cubic = spec(&SPRING.replace("sin(q)", "q^2").replace("[1, 9]", "[2, 9]"));
    assert_eq!(in_c::selftest("models_in_samples", &cubic), 0.0);
    // Another k than that of the test is found.
    let other = spec(
        &SPRING
            .replace("sin(q)", "q^2")
            .replace("k*q^3", "k*q^3*1.0001")
            .replace("[1, 9]", "[2, 9]"),
    );
    assert!(in_c::selftest_of("models_in_samples_other", &cubic, &other) > 0.0);
}
