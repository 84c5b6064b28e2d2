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
