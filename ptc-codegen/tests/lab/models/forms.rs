//! The form in which the plant's share of u is computed: few operations, and refused where the request's
//! own would be.

use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::program::Stage;
use ptc_codegen::program::cost::{Cost, count};
use ptc_codegen::program::passes::optimise;
use ptc_codegen::request::Spec;

use super::{LEVITATION, example, in_c, spec};

/// Returns the cost of a step.
fn step(spec: &Spec) -> Cost {
    let program = optimise(lower(spec, &Law::of(spec)), &mut |_, _| {});
    count(&program, &program.controls(), Stage::Tick)
}

fn chain(plant: &str) -> Spec {
    spec(&format!(
        "n = 3\nmu = \"exp(a=1)\"\npoles = [-4, -5, -6]\n{plant}\n[params]\ntau = 1\neps = 1e-3\n"
    ))
}

#[test]
fn a_gain_that_is_a_number_costs_nothing_beside_f() {
    let plain = step(&chain(""));
    // f/g is a sum of two products, and 1/g stands in the coefficients.
    for g in ["", "g = 3", "g = \"1/0.7\""] {
        let known = step(&chain(&format!("f = \"2*(x2 - 3*x1) - x2/7\"\n{g}")));
        assert_eq!((known.mul, known.add), (plain.mul + 2, plain.add + 2), "{g}");
    }
}

#[test]
fn what_is_linear_in_a_state_is_one_product() {
    let cost = step(&spec(&example("drive.toml").replace("u_max = 24 ", "u_max = inf ")));
    // -T; 1/T; two states with their gains, two of the chain, two of f/g, three times 1/T.
    assert_eq!((cost.mul, cost.div), (9, 1), "{cost:?}");
}

/// poles -4 and -5: T^2 x1'' = -20 x1 - 8 T x1'.
#[test]
fn a_start_that_is_armed_anew_is_that_of_f_and_g() {
    let text = "name = \"again\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nf = \"t0*x1 + x2\"\ng = \"2 + t0\"\n\
        [params]\ntau = 1\nt0 = 0\neps = 1e-3\nu_max = inf\n";
    let main = "int main(void)\n{\n    again control;\n    const again_params params = { 0 };\n    double u;\n\
        \x20   const double x[2] = { 0.5, -0.25 };\n\
        \x20   if (again_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   for (double t0 = 0.0; t0 < 4.0; t0 += 1.5) {\n\
        \x20       if (again_arm(&control, t0) != PTC_OK) { return 2; }\n\
        \x20       if (again_step(&control, t0 + 0.5, x, &u) != PTC_OK) { return 3; }\n\
        \x20       printf(\"%.17g %.17g\\n\", t0, u);\n    }\n    return 0;\n}\n";
    let rows = in_c::run("armed_anew", &spec(text), main);
    assert_eq!(rows.len(), 3);
    for row in rows {
        let (t0, x1, x2, to_go) = (row[0], 0.5, -0.25, 0.5);
        let wanted = (-20.0 * x1 / (to_go * to_go) - 8.0 * x2 / to_go - t0 * x1 - x2) / (2.0 + t0);
        // Some ten roundings of terms that do not cancel.
        assert!((row[1] - wanted).abs() < 1e-13 * wanted.abs(), "{row:?}, not {wanted}");
    }
}

#[test]
fn what_vanishes_with_the_gain_is_refused() {
    // Where i = -i0 the magnet does not pull: f/g is a number there, w/g is not.
    let main = format!(
        "{LEVITATION}\nint main(void)\n{{\n    levitation control;\n    double u = 1.0;\n\
         \x20   const double x[3] = {{ 0.0, 0.0, -0.8 }};\n\
         \x20   if (levitation_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   printf(\"%d\", levitation_step(&control, 0.1, x, &u) == PTC_E_RANGE);\n\
         \x20   printf(\" %g\\n\", u);\n    return 0;\n}}\n"
    );
    let told = in_c::run("levitation_without_pull", &spec(&example("levitation.toml")), &main);
    assert_eq!(told, [[1.0, 0.0]]);
}

/// A mechanical plant with sines and cosines of sums of its angles, where M and bias are by hand below.
const ANGLES: &str = "name = \"angles\"\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n\
    [params]\ntau = 1\nt0 = 0\neps = 1e-3\nu_max = inf\n\
    [model]\nstates = [\"a\", \"b\", \"c\", \"u\", \"v\", \"w\"]\ninputs = [\"k\", \"l\", \"m\"]\n\
    inertia = [[\"3 + cos(b)\", \"0\", \"0\"], [\"0\", \"2 + cos(c)\", \"0\"], [\"0\", \"0\", \"2 + cos(b + c)\"]]\n\
    bias = [\"sin(b) + 2*sin(c) + sin(b - c)*v\", \"cos(a) + sin(a)*w\", \"cos(a + b + c) + sin(b + c)\"]\n";

/// Ten calls as they are written, of which six remain: sines and cosines of the three angles.
#[test]
fn sums_of_angles_take_no_calls_of_their_own() {
    assert_eq!(step(&spec(ANGLES)).calls, 6);
    // Two links would save none: the forces have cos(q1), cos(q2), cos(q1 + q2) and sin(q2).
    assert_eq!(step(&spec(&example("two_link.toml"))).calls, 4);
    let main = "int main(void)\n{\n    angles control;\n    const angles_params params = { 0 };\n\
        \x20   const double x[6] = { 0.5, -0.25, 1.5, 0.3, -0.7, 0.2 };\n    double u[3];\n    ptc_status axes[3];\n\
        \x20   if (angles_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   if (angles_step(&control, 0.5, x, u, axes) != PTC_OK) { return 2; }\n\
        \x20   printf(\"%.17g %.17g %.17g\\n\", u[0], u[1], u[2]);\n    return 0;\n}\n";
    let rows = in_c::run("angle_sums", &spec(ANGLES), main);
    let [a, b, c, u, v, w] = [0.5_f64, -0.25, 1.5, 0.3, -0.7, 0.2];
    // Poles at -3 and -4 of exp: T^2 q'' = -12 q - 6 T q'.
    let wanted = |q: f64, rate: f64| -12.0 * q / 0.25 - 6.0 * rate / 0.5;
    let by_hand = [
        (3.0 + b.cos()) * wanted(a, u) + b.sin() + 2.0 * c.sin() + (b - c).sin() * v,
        (2.0 + c.cos()) * wanted(b, v) + a.cos() + a.sin() * w,
        (2.0 + (b + c).cos()) * wanted(c, w) + (a + b + c).cos() + (b + c).sin(),
    ];
    for (found, wanted) in rows[0].iter().zip(by_hand) {
        assert!((found - wanted).abs() < 1e-14 * (1.0 + wanted.abs()), "{found}, not {wanted}");
    }
}
