//! The emitted C in closed loop with the plant, which is integrated beside it by a fourth-order method:
//! the plant is on the reference at the deadline, and stays there.

use super::{example, in_c, spec};

/// A main function that runs the plant `rate` from `start`, in steps that shrink with the time-to-go down
/// to eps, and on to `until` in even ones. It prints the errors `of` x and t at eps and at the end, and
/// the greatest of |e_1| in between.
fn main(
    name: &str,
    (given, rate, of): (&str, &str, &str),
    start: &[f64],
    [tau, eps, until]: [f64; 3],
) -> String {
    let n = start.len();
    let advance = in_c::advance(n);
    let start: Vec<_> = start.iter().map(|x| format!("{x:e}")).collect();
    let pass = if given.is_empty() { "" } else { "r, " };
    format!(
        "static {name} control;\n\
         static int rates(double t, const double *x, double *dx)\n{{\n    double u;\n{given}\
         \x20   const int wrong = {name}_step(&control, t, x, {pass}&u) < 0;\n{rate}\n    return wrong;\n}}\n{advance}\
         static void show(double t, const double *x)\n{{\n    double e[2];\n{of}\n\
         \x20   printf(\"%.17g %.17g\\n\", e[0], e[1]);\n}}\n\
         int main(void)\n{{\n    {name}_params params = {{ 0 }};\n\
         \x20   double x[{n}] = {{ {} }};\n\
         \x20   const int steps = 100000;\n    double t = 0.0;\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (int i = 0; i < 2 * steps; i++) {{\n\
         \x20       const double shrunk = {tau:e} - {tau:e} * pow({eps:e} / {tau:e}, (i + 1.0) / steps);\n\
         \x20       const double even = {tau:e} - {eps:e} + ({until:e} - ({tau:e} - {eps:e})) * (i + 1.0 - steps) / steps;\n\
         \x20       const double next = (i < steps) ? shrunk : even;\n\
         \x20       if (advance(t, next - t, x)) {{ return 2; }}\n\
         \x20       t = next;\n\
         \x20       if (i >= steps - 1 && (i + 1) % (steps / 10) == 0) {{ show(t, x); }}\n    }}\n\
         \x20   return 0;\n}}\n",
        start.join(", ")
    )
}

/// e_1 and e_2 of the poles -4 and -5 from e_1 = `start` and e_2 = `rate`, with T in parts of tau = 1:
/// e_1 = a T^4 + b T^5.
fn left(start: f64, rate: f64, s: f64) -> [f64; 2] {
    // a + b = start, and -(4 a + 5 b) = rate.
    let b = -rate - 4.0 * start;
    let a = start - b;
    [a * s.powi(4) + b * s.powi(5), -4.0 * a * s.powi(3) - 5.0 * b * s.powi(4)]
}

fn on_the_reference(test: &str, text: &str, given: &str) {
    let text = text
        .replace("error = [1e-3, 1e-2] ", "eps = 1e-2\n# ")
        .replace("u_max = 50 ", "u_max = inf ");
    let rate = "    dx[0] = x[1]; dx[1] = u / 1.5;";
    let of = "    e[0] = x[0] - 0.1 * sin(2.0 * t + 0.3); e[1] = x[1] - 0.2 * cos(2.0 * t + 0.3);";
    let main = main("track", (given, rate, of), &[0.3, 0.0], [1.0, 1e-2, 3.0]);
    let errors = in_c::run(test, &spec(&text), &main);
    let [e1, e2] = left(0.3 - 0.1 * 0.3f64.sin(), -0.2 * 0.3f64.cos(), 1e-2);
    let first = &errors[0];
    assert!((first[0] - e1).abs() < 1e-13 && (first[1] - e2).abs() < 1e-11, "{first:?}: {e1} {e2}");
    // Held gains keep it there while the plant follows, and what the deadline left fades.
    assert!(errors[1..].iter().all(|e| e[0].abs() < 1e-10 && e[1].abs() < 1e-10), "{errors:?}");
}

#[test]
fn a_stage_meets_the_conveyor_and_stays_on_it() {
    on_the_reference("track", &example("track.toml"), "");
}

#[test]
fn a_reference_that_each_call_is_given_leads_to_the_same() {
    let text = example("track.toml")
        .replace("0.1*sin(2*t + phase)", "input")
        .replace("phase = 0.3 ", "# ");
    let given = "    const double w = 2.0 * t + 0.3;\n\
                 \x20   const double r[3] = { 0.1 * sin(w), 0.2 * cos(w), -0.4 * sin(w) };\n";
    on_the_reference("track_given", &text, given);
}

/// The output of a model follows: the angle of the motor of examples/drive.toml, with its current.
#[test]
fn the_output_of_a_model_follows() {
    let text = example("drive.toml")
        .replace("u_max = 24 ", "eps = 4e-3\nu_max = inf ")
        .replace("[params]", "[params]\nt0 = 0")
        .replace("mu = ", "reference = \"0.5*sin(3*t)\"\nmu = ");
    let rate = "    dx[0] = x[1]; dx[1] = (0.03 * x[2] - 1e-5 * x[1]) / 2e-5;\n\
        \x20   dx[2] = (u - 1.2 * x[2] - 0.03 * x[1]) / 2e-3;";
    let of = "    e[0] = x[0] - 0.5 * sin(3.0 * t); e[1] = x[1] - 1.5 * cos(3.0 * t);";
    let main = main("drive", ("", rate, of), &[1.0, 0.0, 0.0], [0.4, 4e-3, 1.0]);
    let errors = in_c::run("drive_follows", &spec(&text), &main);
    // T/tau is 0.01, and the slowest pole leaves its fourth power.
    assert!(errors[0][0].abs() < 1e-6 && errors[0][1].abs() < 1e-3, "{errors:?}");
    assert!(errors[2..].iter().all(|e| e[0].abs() < 1e-8 && e[1].abs() < 1e-6), "{errors:?}");
}
