//! Plants with several inputs and outputs: u of the emitted C against 50 digits, closed loops, and what is
//! refused.

use std::collections::BTreeMap;

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::{checked, example, in_c, spec, support};
use support::{QUADROTOR, UNICYCLE, folder_with, run_in};

/// Output of `tools/coupled.py`: a plant, t, its state and u.
const DIGITS: &str = include_str!("coupled.txt");

pub(super) const MIX: &str = "name = \"mix\"
mu = \"exp(a=1)\"
poles = [[-4, -5], [-3]]
[params]
tau = 1
eps = 1e-2
u_max = inf
[model]
states = [\"p\", \"v\", \"h\"]
inputs = [\"a\", \"b\"]
outputs = [\"p\", \"h\"]
dynamics = { p = \"v\", v = \"-v + (2 + sin(p))*a + h*b\", h = \"v*h + h*a + (2 + h^2)*b\" }
";

/// Outputs that are the states, whose rates are given: chains of order 1.
fn square(name: &str, [states, inputs]: [&str; 2], rates: &[&str]) -> String {
    format!(
        "name = \"{name}\"\nmu = \"exp(a=1)\"\npoles = [-3]\n[params]\ntau = 1\neps = 1e-2\nu_max = inf\n[model]\n\
         states = {states}\ninputs = {inputs}\noutputs = {states}\ndynamics = {rates:?}\n"
    )
}

fn three() -> String {
    let rates = ["3*a + p*b + q*c + sin(q)", "sin(r)*a + 4*b + p*c - p*r", "q*a + r*b + 5*c"];
    square("three", ["[\"p\", \"q\", \"r\"]", "[\"a\", \"b\", \"c\"]"], &rates)
}

/// With zeros where the first pivots would be.
fn four() -> String {
    let rates = [
        "sin(q)*b + 3*c + r*d",
        "2*a + p*b + d + p*r",
        "r*a + (3 + q^2)*b + s*c",
        "a - p*c + 4*d + cos(s)",
    ];
    square("four", ["[\"p\", \"q\", \"r\", \"s\"]", "[\"a\", \"b\", \"c\", \"d\"]"], &rates)
}

fn robot() -> String {
    example("two_link.toml").replace("limits = [120, 60]", "u_max = inf #")
}

/// The plants by their names.
pub(super) fn plants() -> BTreeMap<&'static str, Spec> {
    let all = [MIX, UNICYCLE, QUADROTOR].map(str::to_owned);
    let all = all.into_iter().chain([three(), four(), robot()]).map(|text| spec(&text));
    ["mix", "unicycle", "quadrotor", "three", "four", "two_link"].into_iter().zip(all).collect()
}

/// The same with references, one output follows and one does not, and what each call is given; and with a
/// law that it is given.
pub(super) fn following() -> BTreeMap<&'static str, Spec> {
    let own =
        |reference: &str| spec(&MIX.replace("mu =", &format!("reference = {reference}\nmu =")));
    let law = spec(&MIX.replace("poles = [[-4, -5], [-3]]", "pi0 = \"extern\""));
    [("known", own("[\"amp*sin(t)\", \"0\"]")), ("given", own("\"input\"")), ("law", law)].into()
}

#[test]
fn u_matches_the_definition() {
    let mut lines: BTreeMap<&str, Vec<Vec<f64>>> = BTreeMap::new();
    for line in DIGITS.lines() {
        let (name, numbers) = line.split_once(' ').expect("a name");
        let numbers = numbers.split(' ').map(|word| word.parse().expect("a number")).collect();
        lines.entry(name).or_default().push(numbers);
    }
    for (name, spec) in plants() {
        let (rows, n) = (&lines[name], spec.states());
        let m = spec.coupled.as_ref().expect("several inputs").inputs.len();
        let row = |row: &Vec<f64>| {
            let given: Vec<_> = row[..=n].iter().map(|number| format!("{number:e}")).collect();
            format!("{{ {} }}", given.join(", "))
        };
        let rows_in_c: Vec<_> = rows.iter().map(row).collect();
        let main = format!(
            "static const {name}_params params = {{ .t0 = 0.0 }};\n\
             static const double calls[][{}] = {{ {} }};\n\
             int main(void)\n{{\n    {name} control;\n\
             \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
             \x20   for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++) {{\n\
             \x20       double u[{m}];\n        ptc_status axes[{m}];\n\
             \x20       if ({name}_step(&control, calls[i][0], calls[i] + 1, u, axes) != PTC_OK) {{ return 2; }}\n\
             \x20       for (int j = 0; j < {m}; j++) {{ printf(\"%.17g \", u[j]); }}\n\
             \x20       printf(\"\\n\");\n    }}\n    return 0;\n}}\n",
            n + 1,
            rows_in_c.join(", ")
        );
        let found = in_c::run(&format!("coupled_{name}"), &spec, &main);
        assert_eq!(found.len(), rows.len());
        for (found, row) in found.iter().zip(rows) {
            let wanted = &row[n + 1..];
            let size = wanted.iter().fold(1e-3f64, |size, u| size.max(u.abs()));
            for (u, wanted) in found.iter().zip(wanted) {
                assert!((u - wanted).abs() <= 2e-12 * size, "{name} at {row:?}: {found:?}");
            }
        }
    }
}

/// The state that the plant `rate` has at the end of `[tau, eps]` under the emitted C, from `start`.
fn rest(spec: &Spec, (rate, start): (&str, &[f64]), [tau, eps]: [f64; 2]) -> Vec<f64> {
    let (name, n) = (spec.name(), start.len());
    let m = spec.coupled.as_ref().expect("several inputs").inputs.len();
    let start: Vec<_> = start.iter().map(|x| format!("{x:e}")).collect();
    let main = format!(
        "static const {name}_params params = {{ .t0 = 0.0 }};\nstatic {name} control;\n\
         static int rates(double t, const double *x, double *dx)\n{{\n    double u[{m}];\n    ptc_status axes[{m}];\n\
         \x20   const int wrong = {name}_step(&control, t, x, u, axes) != PTC_OK;\n{rate}\n    return wrong;\n}}\n{}\
         int main(void)\n{{\n    double x[{n}] = {{ {} }};\n    const int steps = 40000;\n    double t = 0.0;\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (int i = 0; i < steps; i++) {{\n\
         \x20       const double next = {tau:e} - {tau:e} * pow(1.0000001 * {eps:e} / {tau:e}, (i + 1.0) / steps);\n\
         \x20       if (advance(t, next - t, x)) {{ return 2; }}\n\
         \x20       t = next;\n    }}\n\
         \x20   for (int j = 0; j < {n}; j++) {{ printf(\"%.17g \", x[j]); }}\n    return 0;\n}}\n",
        in_c::advance(n),
        start.join(", ")
    );
    in_c::run(&format!("coupled_loop_{name}"), spec, &main).remove(0)
}

/// The robot moves by its equations solved for the accelerations, which the law never forms.
#[test]
fn robot_comes_to_rest() {
    let rate = "    { const double c = cos(x[1]), s = sin(x[1]), tip = 1.5 * 9.81 * 0.5 * cos(x[0] + x[1]);\n\
        \x20   const double m22 = 1.5 * 0.25, m12 = m22 + 1.5 * 0.3 * c, m11 = 3.5 * 0.36 + m22 + 2.0 * 1.5 * 0.3 * c;\n\
        \x20   const double f1 = u[0] + 1.5 * 0.3 * s * (2.0 * x[2] * x[3] + x[3] * x[3]) - 3.5 * 9.81 * 0.6 * cos(x[0]) - tip;\n\
        \x20   const double f2 = u[1] - 1.5 * 0.3 * s * x[2] * x[2] - tip, d = m11 * m22 - m12 * m12;\n\
        \x20   dx[0] = x[2]; dx[1] = x[3]; dx[2] = (m22 * f1 - m12 * f2) / d; dx[3] = (m11 * f2 - m12 * f1) / d; }";
    let x = rest(&spec(&robot()), (rate, &[1.0, -0.5, 0.2, 0.1]), [20.0, 1.0]);
    // Each mode is e^(-kappa) or faster, and kappa is 380 at the clamp: what is left is rounding.
    assert!(x.iter().all(|x| x.abs() < 1e-12), "{x:?}");
}

#[test]
fn outputs_of_different_orders_come_to_rest() {
    let rate = "    dx[0] = x[1]; dx[1] = -x[1] + (2.0 + sin(x[0])) * u[0] + x[2] * u[1];\n\
        \x20   dx[2] = x[1] * x[2] + x[2] * u[0] + (2.0 + x[2] * x[2]) * u[1];";
    let x = rest(&spec(MIX), (rate, &[1.0, 0.0, 0.5]), [1.0, 1e-2]);
    // With T = 0.01 the modes of the pole -m are T^m: p = 5 T^4 - 4 T^5, h = 0.5 T^3.
    let s = 1e-2 * 1.000_000_1f64;
    let (p, h) = (5.0 * s.powi(4) - 4.0 * s.powi(5), 0.5 * s.powi(3));
    assert!((x[0] - p).abs() < 1e-3 * p && (x[2] - h).abs() < 1e-3 * h, "{x:?}: p = {p}, h = {h}");
}

/// At a singular matrix every u is 0, and the call and both axes fail.
#[test]
fn singular_state_returns_zero_u() {
    let main = "static const unicycle_params params = { .t0 = 0.0 };\n\
        int main(void)\n{\n    unicycle control;\n    const double x[4] = { 1.0, 1.0, 0.0, 0.0 };\n\
        \x20   double u[2] = { 7.0, 7.0 };\n    ptc_status axes[2];\n\
        \x20   if (unicycle_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   printf(\"%d \", (int)unicycle_step(&control, 0.5, x, u, axes));\n\
        \x20   printf(\"%g %g %d %d\\n\", u[0], u[1], (int)axes[0], (int)axes[1]);\n    return 0;\n}\n";
    let found = in_c::run("coupled_singular", &spec(UNICYCLE), main);
    assert_eq!(found, [[-3.0, 0.0, 0.0, -3.0, -3.0]]);
}

#[test]
fn singular_matrix_is_found_in_the_envelope_and_at_rest() {
    let (verdict, summary) = checked("zeros", "coupled_rest", UNICYCLE);
    assert_eq!((verdict.as_str(), summary.contains("is 0 at the origin")), ("unsound", true));
    let bounded =
        UNICYCLE.replace("tau = 1\n", "tau = 1\nt0 = 0\n") + "[envelope]\nx_max = [1, 1, 1, 1]\n";
    let (verdict, summary) = checked("envelope", "coupled_envelope", &bounded);
    assert_eq!(verdict, "refuted", "{summary}");
    let inside = MIX.replace("tau = 1\n", "tau = 1\nt0 = 0\n") + "[envelope]\nx_max = [1, 1, 1]\n";
    let (verdict, summary) = checked("envelope", "coupled_inside", &inside);
    assert_eq!(verdict, "sound", "{summary}");
}

#[test]
fn mistakes_are_shown_at_their_lines() {
    let arm = "mu = \"exp(a=1)\"\npoles = [-4, -5]\n[model]\nstates = [\"p\", \"q\", \"v\", \"w\"]\n\
        inputs = [\"a\", \"b\"]\ninertia = [[\"2\", \"q\"], [\"q\", \"3\"]]\nbias = [\"v\", \"w\"]\n";
    for (text, from, to, line, message, help) in [
        (MIX, "[\"p\", \"h\"]", "[\"p\"]", 11, "`outputs` has 1 item, and 2 are needed", "give 2"),
        (
            MIX,
            "[\"p\", \"h\"]",
            "[\"p\", \"p\"]",
            11,
            "no static decoupling exists",
            "add an integrator",
        ),
        (
            MIX,
            "v*h + h*a + (2 + h^2)*b",
            "-h",
            11,
            "none of the inputs `a`, `b` reaches",
            "it moves",
        ),
        (MIX, "h*a + (2", "a*b + (2", 12, "h' is not affine in the input `a`", "f + g*input"),
        (
            MIX,
            "[\"p\", \"h\"]",
            "[\"p\", \"a\"]",
            11,
            "the output depends on the input",
            "states alone",
        ),
        (
            MIX,
            "v = \"-v + (2 + sin(p))*a + h*b\", ",
            "",
            12,
            "the state `v` has no dynamics",
            "v = ",
        ),
        (MIX, "[[-4, -5], [-3]]", "[-4, -5]", 3, "one list of poles", "of 2 and 1 numbers"),
        (MIX, "poles = [[-4, -5], [-3]]\n", "", 0, "`poles` are missing", "a list for each output"),
        (MIX, "mu =", "axes = 2\nmu =", 2, "`axes` beside `inputs`", "leave it out"),
        (MIX, "mu =", "reference = \"sin(t)\"\nmu =", 2, "1 reference for 2 outputs", "and 0 for"),
        (MIX, "mu =", "reference = [\"t\", \"abs(t)\"]\nmu =", 2, "abs(t) has a kink", "tanh"),
        (MIX, "mu =", "reference = [\"t\", \"1/t\"]\nmu =", 2, "not shown to have", "give t0"),
        (MIX, "mu =", "reference = [\"h\", \"0\"]\nmu =", 2, "`h` is a state or", "in t, dt and"),
        (MIX, "mu =", "reference = [\"a*t\", \"0\"]\nmu =", 2, "`a` is a state or an input", "dt"),
        (
            MIX,
            "mu =",
            "reference = [\"input\", \"0\"]\nmu =",
            2,
            "`input` is a key of",
            "parameter",
        ),
        (
            MIX,
            "mu =",
            "reference = \"input\"\nafter = \"zero\"\nmu =",
            3,
            "hold their gains",
            "leave `after` out",
        ),
        (arm, "\"w\"]\ninputs", "\"q\"]\ninputs", 4, "two names `q`", "a name of its own"),
        (arm, ", \"w\"]\ninputs", "]\ninputs", 4, "3 states for 2 inputs", "the rate of each"),
        (arm, "[\"q\", \"3\"]", "[\"q\", \"v\"]", 6, "depends on the rate `v`", "`bias`"),
        (
            arm,
            "[\"q\", \"3\"]",
            "[\"2\", \"q\"]",
            6,
            "is singular for all states",
            "positive definite",
        ),
        (arm, "bias = [\"v\", \"w\"]\n", "", 0, "the model has no `bias`", "give"),
    ] {
        assert!(text.contains(from), "{from}");
        let folder = folder_with("coupled_mistakes", "design.toml", text.replacen(from, to, 1));
        let (status, _, stderr) = run_in(&folder, &["check", "design.toml"]);
        assert_ne!(status, Some(0), "{from} -> {to}");
        let at = format!("design.toml:{line}:");
        let shown = stderr.contains(message) && stderr.contains(help);
        assert!(shown && (line == 0 || stderr.contains(&at)), "{from} -> {to}: {stderr}");
    }
    for (name, outputs, message) in [
        ("twice", "\"roll\", \"roll\"", "no static decoupling exists"),
        ("never", "\"roll\", \"z - z\"", "reaches"),
    ] {
        let text = QUADROTOR.replace("[\"z\", \"roll\", \"pitch\"", &format!("[\"z\", {outputs}"));
        let folder = folder_with(&format!("coupled_{name}"), "design.toml", &text);
        let (code, _, stderr) = run_in(&folder, &["check", "design.toml"]);
        assert!(code == Some(2) && stderr.contains(message), "{stderr}");
    }
}

/// Euler angles cannot be led where the pitch is a right angle; here D has a row that is 0 in two.
#[test]
fn singular_four_by_four_matrix_returns_zero_u() {
    let main = "static const four_params params = { .t0 = 0.0 };\n\
        int main(void)\n{\n    four control;\n    const double x[4] = { 0.0, 0.0, 0.0, 0.0 };\n\
        \x20   double u[4] = { 7.0, 7.0, 7.0, 7.0 };\n    ptc_status axes[4];\n\
        \x20   if (four_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   printf(\"%d \", (int)four_step(&control, 0.5, x, u, axes));\n\
        \x20   printf(\"%g %g %g %g\\n\", u[0], u[1], u[2], u[3]);\n    return 0;\n}\n";
    let singular = four().replace("3*c", "q*c").replace("poles", "allow = \"zeros\"\npoles");
    let found = in_c::run("coupled_four_singular", &spec(&singular), main);
    assert_eq!(found, [[-3.0, 0.0, 0.0, 0.0, 0.0]]);
    let (verdict, summary) = checked("zeros", "coupled_four_rest", &singular);
    assert_eq!(
        (verdict.as_str(), summary.contains("is 0 at the origin")),
        ("unsound", true),
        "{summary}"
    );
    let bounded =
        four().replace("tau = 1\n", "tau = 1\nt0 = 0\n") + "[envelope]\nx_max = [1, 1, 1, 1]\n";
    let (verdict, summary) = checked("envelope", "coupled_four_envelope", &bounded);
    assert_eq!(verdict, "sound", "{summary}");
    // The determinant is 3 - 2 q.
    let names = ["[\"p\", \"q\", \"r\", \"s\"]", "[\"a\", \"b\", \"c\", \"d\"]"];
    let crossing = square("crossing", names, &["(3 - 2*q)*a", "b + p*a", "c", "d + r*a"]);
    for (bound, wanted) in [("1.499999", "sound"), ("1.500001", "refuted")] {
        let envelope = format!("[envelope]\nx_max = [1, {bound}, 1, 1]\n");
        let text = crossing.replace("tau = 1\n", "tau = 1\nt0 = 0\n") + &envelope;
        let (verdict, summary) = checked("envelope", "coupled_four_crossing", &text);
        assert_eq!(verdict, wanted, "{summary}");
        assert!(wanted == "sound" || summary.contains("q = 1.5"), "{summary}");
    }
}

/// `show law` has the plant and, for each output, the law of a chain with its gains.
#[test]
fn show_law_prints_the_law_of_each_output() {
    let folder = folder_with("coupled_show", "mix.toml", MIX);
    let json = |words: &[&str]| -> serde_json::Value {
        let (code, text, stderr) = run_in(&folder, &[words, &["--format", "json"]].concat());
        assert_eq!(code, Some(0), "{stderr}");
        let mut sheet: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        // Each is of a design of its own.
        let own = sheet.as_object_mut().expect("an object");
        assert!(["fingerprint", "chosen", "follows"].iter().all(|key| own.remove(*key).is_some()));
        sheet
    };
    let outputs = json(&["show", "law", "mix.toml"]);
    for (output, (n, poles)) in [("2", "[-4, -5]"), ("1", "[-3]")].into_iter().enumerate() {
        let chain = format!("n = {n}\nmu = \"exp(a=1)\"\npoles = {poles}\ntau = 1\neps = 1e-2\n");
        std::fs::write(folder.join("chain.toml"), chain).expect("a file");
        assert_eq!(outputs["outputs"][output], json(&["show", "law", "chain.toml"]));
    }
    for format in ["text", "latex"] {
        let words = ["show", "law", "mix.toml", "--format", format];
        let (_, text, _) = run_in(&folder, &words);
        for part in ["p' = v", "  f_2 = v*h", "  det(D) = ", "output 2, of order n = 1"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
    let (_, text, _) = run_in(&folder, &["show", "matrix", "mix.toml"]);
    assert!(text.contains("BB_2 ="), "{text}");
    // Outputs that share their gains are shown once, and laws that are no gains are not.
    let folder = folder_with("coupled_show_arm", "arm.toml", example("two_link.toml"));
    let (_, text, _) = run_in(&folder, &["show", "law", "arm.toml"]);
    assert!(
        text.contains("u = M v + bias") && text.matches("of order n = 2").count() == 3,
        "{text}"
    );
    let folder = folder_with("coupled_show_laws", "arm.toml", example("barrier_arm.toml"));
    let (code, _, stderr) = run_in(&folder, &["show", "law", "arm.toml"]);
    assert!(code != Some(0) && stderr.contains("are not sums of gains"), "{stderr}");
}

/// The command in the head gives the design back, and every language has it.
#[test]
fn coupled_plants_are_emitted_in_every_supported_language() {
    for (name, own) in plants().into_iter().chain(following()) {
        let again = crate::command::spec_of(&own.command()).expect("a legal command");
        assert_eq!(again, own);
        // No function of Structured Text returns the laws of several outputs.
        let given = own.feedback == ptc_codegen::request::Feedback::Extern;
        let is_left_out = |language: &Language| {
            let is_plc = [Language::StructuredText, Language::PlcOpen].contains(language);
            given && (is_plc || language.fmi().is_some())
        };
        for language in Language::ALL.into_iter().filter(|language| !is_left_out(language)) {
            let files = ptc_codegen::generate(&own, language).expect(name);
            assert_eq!(ptc_codegen::generate(&again, language).expect(name), files);
        }
    }
}
