//! Laws that see all outputs: what they are read as, what becomes of them in C, and what is refused.

use ptc_codegen::emit::Language;
use ptc_codegen::request::{Feedback, Spec};

use super::{checked, example, folder_with, in_c, run_in, spec};

const PLANT: &str = "name = \"pair\"
mu = \"exp(a=1)\"
pi0 = [\"-6*xi1_1 - 5*xi2_1\", \"-3*xi1_2\"]
[params]
tau = 1
eps = 1e-2
u_max = inf
[model]
states = [\"p\", \"v\", \"h\"]
inputs = [\"a\", \"b\"]
outputs = [\"p\", \"h\"]
dynamics = { p = \"v\", v = \"a\", h = \"b - h\" }
";

const LAWS: &str = "[\"-6*xi1_1 - 5*xi2_1\", \"-3*xi1_2\"]";

fn with(laws: &str) -> String {
    assert!(PLANT.contains(LAWS));
    PLANT.replace(LAWS, laws)
}

/// Sums of gains are the gains that they are, so that all that is known of these is known of them.
#[test]
fn sums_of_gains_are_gains() {
    let own = spec(PLANT);
    let gains = spec(&PLANT.replace(&format!("pi0 = {LAWS}"), "gains = [[6, 5], [3]]"));
    assert_eq!((&own.feedback, own.command()), (&Feedback::Linear, gains.command()));
    let code = |spec| ptc_codegen::generate(spec, Language::C).expect("accepted");
    assert_eq!(code(&own), code(&gains));
    // An output that takes part in the law of another one is no longer a sum of its own gains.
    let crossed = spec(&with("[\"-6*xi1_1 - 5*xi2_1 + xi1_2\", \"-3*xi1_2\"]"));
    assert!(matches!(crossed.feedback, Feedback::Expression(_)));
    let (verdict, summary) =
        checked("growth", "laws_growth", &with("[\"-6*xi1_1 - 5*xi2_1 + xi1_2\", \"-3*xi1_2\"]"));
    assert_eq!(verdict, "not checked");
    assert!(summary.contains("the law is not a sum of gains"), "{summary}");
}

/// Each check says what it knows of such a law, and none stops at it.
#[test]
fn checks_say_what_they_know() {
    let text = with("[\"-6*xi1_1 - 5*xi2_1 + xi1_2\", \"-3*xi1_2*(1 + xi2_1^2)\"]")
        .replace("tau = 1\n", "tau = 1\nt0 = 0\n")
        .replace("mu =", "sample_time = 1e-3\nmu =")
        + "[envelope]\nx_max = [1, 1, 1]\n";
    for (check, wanted) in [
        ("membership", "sound"),
        ("growth", "not checked"),
        ("sampling", "not checked"),
        ("deadline", "not checked"),
        ("loop", "not checked"),
        ("envelope", "sound"),
        ("zeros", "sound"),
    ] {
        let (verdict, summary) = checked(check, "laws_checks", &text);
        assert_eq!(verdict, wanted, "{check}: {summary}");
    }
    // With eps left to the checks there is none: it follows from gains.
    let open = text.replace("eps = 1e-2\n", "");
    let (verdict, _) = checked("sampling", "laws_open", &open);
    assert_ne!(verdict, "sound");
}

/// Values of two laws by hand, from t, the time-to-go and kappa + t0.
type ByHand<'a> = &'a dyn Fn(f64, f64, f64) -> [f64; 2];

/// The state of the pair: p, v, h.
const AT: [f64; 3] = [0.5, -0.75, 0.3];

/// Compares a and b of laws by hand: kappa = -ln T and kappa' = 1/T at tau = 1, so that the chain of p has the
/// coordinates p and T v in stretched time, and kappa'^2 b^T x = v/T; h' = b - h.
fn is_pair(test: &str, laws: &str, pi0: ByHand<'_>) {
    let main = "static const pair_params params = { .t0 = 0.25 };\n\
        int main(void)\n{\n    pair control;\n    double u[2];\n    ptc_status axes[2];\n\
        \x20   const double x[3] = { 0.5, -0.75, 0.3 };\n\
        \x20   if (pair_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   for (double t = 0.25; t < 1.5; t += 0.1875) {\n\
        \x20       if (pair_step(&control, t, x, u, axes) < 0) { return 2; }\n\
        \x20       printf(\"%.17g %.17g %.17g\\n\", t, u[0], u[1]);\n    }\n    return 0;\n}\n";
    let rows = in_c::run(test, &spec(&with(laws)), main);
    assert_eq!(rows.len(), 7);
    let [_, v, h] = AT;
    for row in rows {
        let t = row[0];
        // Held at eps = 0.01.
        let to_go = (1.25 - t).max(0.01);
        let pi0 = pi0(t, to_go, 0.25 - to_go.ln());
        let wanted = [(pi0[0] / to_go + v) / to_go, pi0[1] / to_go + h];
        for (found, wanted) in row[1..].iter().zip(wanted) {
            // Some ten roundings of terms that are no larger than 40 times u.
            assert!(
                (found - wanted).abs() <= 1e-13 * (1.0 + wanted.abs()),
                "{found}, not {wanted}"
            );
        }
    }
}

#[test]
fn u_is_that_of_the_formula() {
    let laws = "[\"-6*xi1_1 - 5*xi2_1 + sin(xi1_2)*T + p*v\", \"-3*xi1_2 + kappa_rate*xi2_1*x2_1 - t_kappa*dt\"]";
    let [p, v, h] = AT;
    is_pair("laws_formula", laws, &|t, to_go, kappa| {
        let first = -6.0 * p - 5.0 * to_go * v + h.sin() * to_go + p * v;
        [first, -3.0 * h + v * v - kappa * (t - 0.25)]
    });
}

/// r_k = -(-1)^k T, up to the higher order of the two in either law.
#[test]
fn laws_of_several_outputs_know_the_derivatives_of_the_mapping() {
    let laws = "[\"-6*xi1_1 - 5*xi2_1*r_1/T + h*r_1\", \"-3*xi1_2 + r_2*v + kappa_rate*r_1*p\"]";
    let [p, v, h] = AT;
    is_pair("laws_several_rates", laws, &|_, to_go, _| {
        [-6.0 * p - 5.0 * to_go * v + h * to_go, -3.0 * h - to_go * v + p]
    });
    let own = spec(&with(laws));
    assert_eq!(crate::command::spec_of(&own.command()).expect("a legal command"), own);
    // A state of that name comes first.
    let state = with("[\"-6*xi1_1 - 5*xi2_1 + r_1*v\", \"-3*xi1_2\"]")
        .replace("\"h\"", "\"r_1\"")
        .replace("h = \"b - h\"", "r_1 = \"b - r_1\"");
    let plain = with("[\"-6*xi1_1 - 5*xi2_1 + h*v\", \"-3*xi1_2\"]");
    let laws = |text: &str| spec(text).laws().cloned().collect::<Vec<_>>();
    assert_eq!(laws(&state), laws(&plain));
}

/// A pendulum with one input, whose law knows its states by their names.
const PENDULUM: &str = "name = \"pendulum\"
mu = \"exp(a=1)\"
pi0 = \"-6*xi1 - 5*xi2 - stiff*sin(q)*T + q*w*kappa_rate\"
[params]
tau = 1
eps = 1e-2
u_max = inf
stiff = 0.5
[model]
states = [\"q\", \"w\"]
input = \"M\"
output = \"q\"
dynamics = { q = \"w\", w = \"2*M - sin(q)\" }
";

/// Compares M of a law by hand, of q, w and T: w' = pi0/T^2 + w/T, and M = (w' + sin q)/2.
fn is_pendulum(test: &str, spec: &Spec, pi0: impl Fn(f64, f64, f64) -> f64) {
    let main = "static const pendulum_params params = { .t0 = 0.25 };\n\
        int main(void)\n{\n    pendulum control;\n    double u;\n\
        \x20   const double x[2] = { 0.5, -0.75 };\n\
        \x20   if (pendulum_init(&control, &params) != PTC_OK) { return 1; }\n\
        \x20   for (double t = 0.25; t < 1.5; t += 0.1875) {\n\
        \x20       if (pendulum_step(&control, t, x, &u) < 0) { return 2; }\n\
        \x20       printf(\"%.17g %.17g\\n\", t, u);\n    }\n    return 0;\n}\n";
    let rows = in_c::run(test, spec, main);
    assert_eq!(rows.len(), 7);
    let (q, w) = (0.5_f64, -0.75_f64);
    for row in rows {
        // Held at eps = 0.01.
        let to_go = (1.25 - row[0]).max(0.01);
        let wanted = ((pi0(q, w, to_go) / to_go + w) / to_go + q.sin()) / 2.0;
        // Some ten roundings of terms that are no larger than 40 times u.
        assert!((row[1] - wanted).abs() <= 1e-13 * (1.0 + wanted.abs()), "{row:?}: {wanted}");
    }
}

#[test]
fn a_law_of_one_input_knows_the_states() {
    let own = spec(PENDULUM);
    let names: Vec<_> = own.run_time_parameters().map(|p| p.spelling()).collect();
    assert_eq!(names, ["t0"]);
    is_pendulum("laws_pendulum", &own, |q, w, to_go| {
        -6.0 * q - 5.0 * to_go * w - 0.5 * q.sin() * to_go + q * w / to_go
    });
    let again = crate::command::spec_of(&own.command()).expect("a legal command");
    assert_eq!(again, own);
    let head = ptc_codegen::generate(&own, Language::C).expect("accepted")[0].text.clone();
    assert!(head.contains("pi0 = -6*xi1 - 5*xi2 - stiff*sin(q)*T + q*w*kappa_rate"), "{head}");
    for (from, to, message, help) in [
        ("- stiff*", "- M*", "`M` is an input of the plant", "a parameter needs another name"),
        ("mu =", "what = \"associated\"\nmu =", "does not know the states", "leave `what` out"),
        ("sin(q)*T", "x1_0*T", "the states and t", "states at the start"),
    ] {
        let folder = folder_with("laws_pendulum_mistakes", "d.toml", PENDULUM.replace(from, to));
        let (status, _, stderr) = run_in(&folder, &["check", "d.toml"]);
        assert_ne!(status, Some(0), "{from}");
        assert!(stderr.contains(message) && stderr.contains(help), "{from}: {stderr}");
    }
}

/// Compares with the law by hand: mu = 1 - e^-t at tau = 1, so that r_k = -(-1)^k T.
#[test]
fn a_law_knows_the_derivatives_of_the_mapping() {
    let own = spec(&PENDULUM.replace(
        "stiff*sin(q)*T + q*w*kappa_rate",
        "stiff*sin(q)*r_1 + r_2*w^2 + q*w*kappa_rate*r_1",
    ));
    is_pendulum("laws_rates", &own, |q, w, to_go| {
        -6.0 * q - 5.0 * to_go * w - 0.5 * q.sin() * to_go - to_go * w * w + q * w
    });
    assert_eq!(crate::command::spec_of(&own.command()).expect("a legal command"), own);
    for (from, to, message, help) in [
        ("*T +", "*r_3 +", "`r_3` does not exist for order n = 2", "the indices are 1..=2"),
        ("2*M", "2*M*r_1", "`r_1` is a derivative of mu in pi0, and a parameter", "another name"),
    ] {
        let text = PENDULUM.replace("*kappa_rate", "*r_1").replace(from, to);
        let folder = folder_with("laws_rates_mistakes", "d.toml", text);
        let (status, _, stderr) = run_in(&folder, &["check", "d.toml"]);
        assert_ne!(status, Some(0), "{from}");
        assert!(stderr.contains(message) && stderr.contains(help), "{from}: {stderr}");
    }
}

/// Every mapping: families from kappa and from mu, and mappings of the user's, against long arithmetic.
#[test]
fn the_derivatives_of_every_mapping_are_those_of_the_definition() {
    for mu in [
        "exp(a=2)",
        "rational(a=1/2)",
        "power(a=1, m=2)",
        "tan(a=1)",
        "tanh(a=1)",
        "algebraic(a=2)",
        "exp_sum(rates=[1, 3])",
        "soft(a=1, start=0.1)",
        "tau*tanh(sinh(t))",
        "tau*(1 - 1/(1 + t + t^2))",
    ] {
        let chain =
            "n = 4\npi0 = \"-r_1*xi1 - xi2*r_2^2 - r_3*xi3 + sin(r_4)*xi4 - r_1/(1 + r_2^2)\"\n";
        // Orders 1 and 3: the law of the first output knows all derivatives of the second.
        let pair = "pi0 = [\"-r_1*xi1_1 - r_3*r_2*xi2_2\", \"-r_3*xi1_2 - xi2_2/(1 + r_2^2) - r_1*xi3_2\"]\n";
        let plant = "[model]\nstates = [\"h\", \"p\", \"v\", \"w\"]\ninputs = [\"a\", \"b\"]\noutputs = [\"h\", \"p\"]\n\
                     dynamics = { h = \"a - h\", p = \"v\", v = \"w\", w = \"b + h*v\" }\n";
        for (kind, law, plant) in [("chain", chain, ""), ("pair", pair, plant)] {
            let text = format!(
                "name = \"all\"\n{law}mu = \"{mu}\"\n[params]\ntau = 2\neps = 1e-3\n{plant}"
            );
            let family = mu.split('(').next().unwrap_or_default().replace('*', "_");
            let name = format!("laws_rates_of_{kind}_{family}");
            assert_eq!(in_c::selftest(&name, &spec(&text)), 0.0, "{kind} {mu}");
        }
    }
}

/// The command in the head gives the design back, in the names of the plant.
#[test]
fn the_command_is_in_the_names_of_the_plant() {
    let arm = example("barrier_arm.toml");
    let mixed = with("[\"-6*xi1_1 - 5*xi2_1 + T*p\", \"-3*xi1_2 - xi2_1^3*kappa_rate\"]");
    for (text, part) in [
        (arm.as_str(), "inverse_inertia_1_1*("),
        (arm.as_str(), "k*xi1_2/(1 - (xi1_2/b2)^2)"),
        (mixed.as_str(), "xi2_1^3*kappa_rate"),
    ] {
        let own = spec(text);
        let command = own.command();
        assert!(command.contains(part), "{command}");
        let again = crate::command::spec_of(&command).expect("a legal command");
        assert_eq!(again, own);
        let head = ptc_codegen::generate(&own, Language::C).expect("accepted")[0].text.clone();
        assert!(head.contains("pi0 of v_2 = "), "{head}");
    }
}

#[test]
fn mistakes_are_shown_at_their_lines() {
    for (laws, message, help) in [
        ("\"-xi1_1\"", "1 expression of pi0 for 2 outputs", "one for each output"),
        (
            "[\"-xi1\", \"-xi1_2\"]",
            "`xi1` does not exist where there are several",
            "xi1_2 is xi_1 of",
        ),
        ("[\"-xi3_1\", \"-xi1_2\"]", "`xi3_1` is no part of the plant", "p, v, h, xi1_1, x1_1"),
        ("[\"-xi1_1\", \"-xi1_3\"]", "`xi1_3` is no part of the plant", "xi1_2"),
        ("[\"-xi1_1_0\", \"-xi1_2\"]", "`xi1_1_0` is no part of the plant", "xi1_2"),
        (
            "[\"-xi1_1*inverse_inertia_1_2\", \"-xi1_2\"]",
            "`inverse_inertia_1_2` is no part",
            "xi1_2",
        ),
        ("[\"-x1_0\", \"-xi1_2\"]", "`x1_0` does not exist where", "states at t0 are not known"),
        ("[\"-u\", \"-xi1_2\"]", "`u` is not known where pi0", "parameter"),
        (
            "[\"-r_3*xi1_1\", \"-xi1_2\"]",
            "`r_3` does not exist for outputs of order 2, 1",
            "the indices are 1..=2",
        ),
        ("[\"-xi1_1 + b\", \"-xi1_2\"]", "`b` is an input of the plant", "needs another name"),
        ("[\"-xi1_1\", \"-xi1_2/0\"]", "division by zero", "divisor"),
        ("[\"extern\", \"-xi1_2\"]", "extern", "parameter"),
    ] {
        let folder = folder_with("laws_mistakes", "design.toml", with(laws));
        let (status, _, stderr) = run_in(&folder, &["check", "design.toml"]);
        assert_ne!(status, Some(0), "{laws}");
        let shown = stderr.contains(message) && stderr.contains(help);
        assert!(shown && stderr.contains("design.toml:3:"), "{laws}: {stderr}");
    }
    // A parameter of the plant and a derivative in one law.
    let both = with("[\"-r_1*xi1_1\", \"-xi1_2\"]").replace("\"b - h\"", "\"b - r_1*h\"");
    let folder = folder_with("laws_conflict", "design.toml", both);
    let (status, _, stderr) = run_in(&folder, &["check", "design.toml"]);
    assert_ne!(status, Some(0));
    assert!(stderr.contains("`r_1` is a derivative of mu in pi0, and a parameter"), "{stderr}");
    // What it is of cannot be read: one mistake, not two.
    let lost = PLANT.replace(", h = \"b - h\"", "");
    let folder = folder_with("laws_lost", "design.toml", lost);
    let (_, _, stderr) = run_in(&folder, &["check", "design.toml"]);
    assert_eq!(stderr.matches("error[").count(), 1, "{stderr}");
}
