//! Verdicts of `check` on divisors of the law that may be 0 within the envelope.

use super::{checked, folder_with, run_in};

/// A chain of order 2 with the gain `g`, for |x1| up to `x1`.
fn chain(g: &str, x1: &str) -> String {
    format!(
        "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\ng = \"{g}\"\n\
         [params]\ntau = 1\neps = 0.01\nt0 = 0\n{k}[envelope]\nx_max = [{x1}, 5]\n",
        k = if g.contains('k') { "k = [1, 2]\n" } else { "" },
    )
}

#[test]
fn a_gain_that_changes_its_sign_is_refuted_and_one_just_short_of_it_is_not() {
    for (g, x1, verdict, told) in [
        ("0.5 + cos(x1)", "2.095", "refuted", "1/2 + cos(x1), is 0 near x1 = -2.094"),
        ("0.5 + cos(x1)", "2.094", "sound", ""),
        // Over a turn 3 cos sin lies between -1.5 and 1.5, its interval between -3 and 3.
        ("1.51 + 3*cos(x1)*sin(x1)", "3.2", "sound", ""),
        ("1.49 + 3*cos(x1)*sin(x1)", "3.2", "refuted", "is 0 near x1 ="),
        ("3 + x1 + x2 - t", "1", "refuted", "is 0 at t = 0.5, x1 = 0, x2 = -2.5"),
        ("7.1 + x1 + x2 - t", "1", "sound", ""),
        ("k - 1.5 + 0*x1", "1", "refuted", "is 0 at k = 1.5"),
        ("k - 0.5 + x1", "0.4", "sound", ""),
        ("x1^2", "1", "refuted", "x1^2, is 0 at x1 = 0: the law divides by it"),
        // What is met by no double, has a pole or jumps is left open.
        ("(x1 - 0.1)^2", "1", "undecided", "may leave the range"),
        ("exp(1/(x1 - 0.3))", "1", "undecided", "may leave the range"),
        // A quotient is multiplied by what divides it: where g is infinite u is 0.
        ("1/(x1 - 0.3)", "1", "sound", ""),
        ("sign(x1 - 0.3)*(2 + x1)", "1", "undecided", "may leave the range"),
    ] {
        let found = checked("envelope", "divisors", &chain(g, x1));
        assert_eq!(found.0, verdict, "{g} within {x1}: {}", found.1);
        assert!(found.1.contains(told), "{g} within {x1}: {}", found.1);
    }
}

#[test]
fn models_and_decoupling_matrices_are_refuted_at_states_by_their_names() {
    let pendulum = |angle: &str| {
        format!(
            "mu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 1\neps = 0.01\nt0 = 0\n\
             [model]\nstates = [\"q\", \"w\"]\ninput = \"u\"\noutput = \"q\"\n\
             dynamics = {{ q = \"w\", w = \"sin(q) + u*cos(q)\" }}\n\
             [envelope]\nx_max = [{angle}, 3]\n"
        )
    };
    let (verdict, summary) = checked("envelope", "pendulum", &pendulum("1.6"));
    assert_eq!(verdict, "refuted", "{summary}");
    assert!(summary.starts_with("the gain of u, cos(q), is 0 near q = -1.571"), "{summary}");
    assert_eq!(checked("envelope", "pendulum_narrow", &pendulum("1.5")).0, "sound");
    let two = |bound: &str| {
        format!(
            "mu = \"exp(a=1)\"\npoles = [[-4], [-5]]\n[params]\ntau = 1\neps = 0.01\nt0 = 0\n\
             [model]\nstates = [\"a\", \"b\"]\ninputs = [\"p\", \"s\"]\noutputs = [\"a\", \"b\"]\n\
             dynamics = {{ a = \"p + 2*s*sin(b)\", b = \"s - a*p\" }}\n\
             [envelope]\nx_max = [{bound}, 3]\n"
        )
    };
    let (verdict, summary) = checked("envelope", "coupled", &two("0.51"));
    assert_eq!(verdict, "refuted", "{summary}");
    assert!(summary.contains("determinant of the decoupling matrix"), "{summary}");
    assert!(summary.contains("a = ") && summary.contains("b = "), "{summary}");
    assert_eq!(checked("envelope", "coupled_narrow", &two("0.49")).0, "sound");
}

/// Six outputs, each of which all inputs move: a matrix whose determinant is a number times the factor `f`.
fn six(f: &str, precision: &str) -> String {
    let names = ["p", "q", "r", "s", "v", "w"];
    let gain = |i: usize, j: usize| match (i, j) {
        _ if i == j => "3".to_owned(),
        _ if i + j == 5 => "-1".to_owned(),
        _ => "0.5".to_owned(),
    };
    // The last row is that of the sum of the others, and the factor.
    let rate = |i: usize| -> String {
        let entry = |j: usize| match i {
            5 => {
                let sum: Vec<_> = (0..5).map(|i| gain(i, j)).collect();
                sum.join(" + ") + &if j == 5 { format!(" + {f}") } else { String::new() }
            }
            _ => gain(i, j),
        };
        let terms: Vec<_> = (0..6).map(|j| format!("({})*u{}", entry(j), j + 1)).collect();
        format!("{} = \"{}\"", names[i], terms.join(" + "))
    };
    let rates: Vec<_> = (0..6).map(rate).collect();
    format!(
        "mu = \"exp(a=1)\"\npoles = [-3]\nprecision = \"{precision}\"\n[params]\ntau = 1\neps = 0.01\nt0 = 0\n\
         [model]\nstates = {names:?}\ninputs = [\"u1\", \"u2\", \"u3\", \"u4\", \"u5\", \"u6\"]\n\
         outputs = {names:?}\ndynamics = {{ {} }}\n[envelope]\nx_max = [2, 2, 2, 2, 2, 2]\n",
        rates.join(", ")
    )
}

#[test]
fn matrices_that_are_eliminated_are_regular_just_off_a_zero() {
    for (f, precision, verdict, told) in [
        ("(2.000001 - q)*(2.5 + sin(s))", "f64", "sound", "every value stays"),
        ("(1.999999 - q)*(2.5 + sin(s))", "f64", "refuted", "is 0 "),
        ("(0.001 + (1 - sin(q)))", "f64", "sound", "every value stays"),
        ("(0.01 + q^2)", "f64", "sound", "every value stays"),
        ("(0.1 + (1 - sin(q)))", "f32", "sound", "every value stays"),
        // Roundings alone may make it singular.
        ("(2.0000001 - q)", "f32", "undecided", "inputs"),
        // By no double.
        ("(q - 0.1)^2", "f64", "undecided", "inputs"),
    ] {
        let found = checked("envelope", "six", &six(f, precision));
        assert_eq!(found.0, verdict, "{f}: {}", found.1);
        assert!(found.1.contains(told), "{f}: {}", found.1);
    }
    let folder = folder_with("six_undecided", "d.toml", six("(q - 0.1)^2", "f64"));
    let (_, stdout, stderr) = run_in(&folder, &["check", "d.toml"]);
    assert!(
        stdout.contains("the decoupling matrix is not shown to be regular for x2 in [0.1"),
        "{stdout} {stderr}"
    );
}

/// A chain of order 2 with the gain `g`, whose output follows `reference` where there is one.
fn at_rest(g: &str, reference: &str) -> String {
    let follows = match reference {
        "" => String::new(),
        r => format!("reference = \"{r}\"\n"),
    };
    format!(
        "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\ng = \"{g}\"\n{follows}\
         [params]\ntau = 1\neps = 0.01\nt0 = 0\n"
    )
}

/// The same chain as a model.
fn model_at_rest(g: &str) -> String {
    format!(
        "mu = \"exp(a=1)\"\ngains = [12, 7]\n[params]\ntau = 1\neps = 0.01\nt0 = 0\n\
         [model]\nstates = [\"q\", \"w\"]\ninput = \"u\"\noutput = \"q\"\n\
         dynamics = [\"w\", \"u*({})\"]\n",
        g.replace("x1", "q")
    )
}

#[test]
fn a_gain_that_is_zero_at_rest_is_never_accepted() {
    for (g, of_chain, of_model) in [
        ("x1", "unsound", "unsound"),
        ("abs(x1)", "unsound", "undecided"),
        ("exp(x1) - 1", "unsound", "unsound"),
        ("max(x1, 0)", "undecided", "undecided"),
        // It is 0 there, and no normal form says so.
        ("sqrt(2 + x1)*sqrt(3) - sqrt(6)", "undecided", "undecided"),
        ("exp(-1/x1^2)", "undecided", "undecided"),
        ("2 + cos(x1)", "sound", "sound"),
        ("1e-9 + abs(x1)", "sound", "sound"),
    ] {
        let chain = checked("growth", "at_rest", &at_rest(g, ""));
        assert_eq!(chain.0, of_chain, "{g}: {}", chain.1);
        let model = checked("zeros", "model_at_rest", &model_at_rest(g));
        assert_eq!(model.0, of_model, "{g}: {}", model.1);
    }
    for (g, reference, verdict) in [
        ("x1", "1", "sound"),
        ("x1", "sin(t)", "unsound"),
        ("x1", "2 - t", "sound"),
        ("x1 - 1", "1", "unsound"),
        ("x2", "2 - t", "sound"),
        ("x2", "sin(3*t)", "unsound"),
        ("x1", "input", "sound"),
    ] {
        let found = checked("growth", "followed", &at_rest(g, reference));
        assert_eq!(found.0, verdict, "{g} along {reference}: {}", found.1);
    }
}

#[test]
fn nested_powers_are_lowered_once_and_quoted_in_part() {
    let nested = |first: &str, next: &dyn Fn(String) -> String, last: &str| {
        let values: Vec<_> =
            (2..=40).map(|i| format!("s{i} = \"{}\"", next(format!("s{}", i - 1)))).collect();
        format!(
            "mu = \"exp(a=1)\"\ngains = [12, 7]\n[params]\ntau = 1\neps = 0.01\nt0 = 0\n\
             [model]\nstates = [\"q\", \"w\"]\ninput = \"u\"\noutput = \"q\"\n\
             let = {{ s1 = \"{first}\", {} }}\ndynamics = [\"w\", \"{last}\"]\n",
            values.join(", ")
        )
    };
    // Each power reads the one before twice: without sharing that is 2^39 operations.
    let powers = nested("1 + q^2", &|s| format!("{s}^{s}"), "u + s40");
    assert_eq!(checked("growth", "nested_powers", &powers).0, "sound");
    let open = nested("q", &|s| format!("exp({s})"), "u*(2 + s40)");
    let folder = folder_with("nested_open", "d.toml", open);
    let (_, _, stderr) = run_in(&folder, &["check", "d.toml"]);
    let message = stderr.lines().next().unwrap_or_default();
    assert!(message.contains("the relative degree is not decided"), "{stderr}");
    assert!(message.len() < 320, "{message}");
}
