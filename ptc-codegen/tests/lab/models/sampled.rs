//! Linear models with a clock in samples: the plant that they are, given as A, B and C, and what is
//! refused.

use std::collections::BTreeMap;

use super::support::{example, folder_with, refused_at, run_in, spec};

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

/// The drive of examples/drive.toml as a plant for examples/motor.toml, its parameters beside it.
fn model(output: &str) -> String {
    let drive = example("drive.toml");
    let (_, model) = drive.split_once("[model]").expect("a model");
    let parameters = "k = 0.03\nJ = 2e-5\nb = 1e-5\nR = 1.2\nL = 2e-3\n";
    format!("{parameters}[model]{}", model.replace("\"q\"\ndyn", &format!("\"{output}\"\ndyn")))
}

/// The motor with a model in place of its matrices; `measured` is its line, if it has one.
fn motor(measured: &str, output: &str) -> String {
    let text = example("motor.toml").replace("measured = [\"x1\"]\n", measured);
    let (above, _) = text.split_once("\n# J = ").expect("the plant");
    format!("{above}\n{}", model(output))
}

/// The same with A, B and C, or the names of the states.
fn matrices(measured: &str, c: &str) -> String {
    format!("{}{c}", example("motor.toml").replace("measured = [\"x1\"]\n", measured))
}

#[test]
fn linear_model_equals_its_matrices() {
    let observed = "observer_poles = [-4, -5, -6, -7]\nobserver_samples = 150\n";
    let bare = |text: String| {
        text.replace(observed, "")
            .replace("disturbance = \"constant\"", "")
            .replace("observer_eps", "# ")
    };
    let states = ["measured = [\"q\", \"w\", \"i\"]\n", "measured = [\"x1\", \"x2\", \"x3\"]\n"];
    for (model, plant) in [
        (motor("", "q"), matrices("measured = [\"x1\"]\n", "")),
        (motor("measured = [\"i\", \"q\"]\n", "q"), matrices("measured = [\"x3\", \"x1\"]\n", "")),
        (motor("", "2*q + w/4 - i/3"), matrices("", "C = [2, 0.25, \"-1/3\"]\n")),
        (bare(motor(states[0], "q")), bare(matrices(states[1], ""))),
        (bare(motor(states[0], "q")), bare(matrices("", ""))),
    ] {
        // A model names its states, and its numbers are computed.
        let unwritten = |text: &String| Spec { written: BTreeMap::new(), ..spec(text) };
        let [model, plant] = [&model, &plant].map(unwritten);
        assert!(model.model.is_none() && model == plant, "{model:?}\n{plant:?}");
        for language in [Language::C, Language::Rust] {
            let [model, plant] = [&model, &plant].map(|spec| {
                ptc_codegen::generate(spec, language).expect("a design that the checks accept")
            });
            assert_eq!(model, plant);
        }
    }
}

/// `simulate` and `check` give the same results for the model and the linear plant, to the last digit.
#[cfg(feature = "lab")]
#[test]
fn model_and_matrices_check_and_simulate_alike() {
    let told = |test: &str, text: &str| {
        // A check of the loop takes the square of the number of samples.
        let text = text
            .replace("[params]", "x0_max = [0.5, 1, 1]\n[params]")
            .replace("sample_time = 1e-3", "sample_time = 4e-3")
            .replace("observer_samples = 150", "observer_samples = 40");
        let folder = folder_with(&format!("models_sampled_{test}"), "motor.toml", &text);
        [
            &["simulate", "motor.toml", "--x0", "0.5,0,0"][..],
            &["check", "motor.toml", "--format", "json"],
        ]
        .map(|arguments| {
            let (code, out, err) = run_in(&folder, arguments);
            assert_eq!(code, Some(0), "{err}");
            out
        })
    };
    let model = told("model", &motor("", "q"));
    let plant = told("plant", &matrices("measured = [\"x1\"]\n", ""));
    assert!(model[0].lines().count() > 100 && model[0] == plant[0]);
    let checks = |json: &str| -> Vec<_> {
        let found: serde_json::Value = serde_json::from_str(json).expect("JSON");
        let all = found["checks"].as_array().expect("checks").iter();
        let told = |check: &serde_json::Value| {
            ["name", "verdict", "worst"].map(|key| check[key].clone()).to_vec()
        };
        all.map(told).chain([vec![found["fingerprint"].clone()]]).collect()
    };
    assert!(model[1].contains("\"loop\"") && checks(&model[1]) == checks(&plant[1]));
}

#[test]
fn invalid_matrix_models_are_refused_at_their_line() {
    let good = "mu = \"exp(a=1)\"
clock = \"samples\"
sample_time = 1e-2
poles = [-4, -5]
measured = [\"q\", \"w\"]
[params]
k = 4
[model]
states = [\"q\", \"w\"]
input = \"u\"
output = \"q\"
dynamics = { q = \"w\", w = \"u - k*q\" }
";
    spec(good);
    // Measured states leave the output without a part.
    spec(&good.replace("output = \"q\"", "output = \"sin(q)\""));
    for (from, to, line, message, help) in [
        ("u - k*q", "u - sqrt(2)*q", 12, "which is not a rational number", "leave `clock` out"),
        ("u - k*q", "u - k*q - 9.81", 12, "is -981/100 at rest, not 0", "disturbance = constant"),
        ("k = 4\n", "", 11, "w' = u - k*q has the parameter `k`, which has no number", "[params]"),
        ("k = 4", "k = [3, 4]", 12, "has the parameter `k`, which has no number", "not bounds"),
        (
            "measured = [\"q\", \"w\"]",
            "measured = [\"q\", \"v\"]",
            5,
            "`v` is no state",
            "the states are q, w",
        ),
        ("poles", "n = 3\npoles", 4, "n = 3, but the model has 2 states", "or give 2"),
        ("poles = [-4, -5]", "poles = [-4]", 4, "1 pole for order n = 2", ""),
        ("k = 4", "k = 4\nzeta = 1", 8, "nothing uses the parameter `zeta`", ""),
        ("poles", "f = 1\npoles", 4, "`f` beside a model", ""),
    ] {
        assert!(good.contains(from), "{from}");
        refused_at("models_sampled_mistakes", &good.replacen(from, to, 1), line, [message, help]);
    }
    let a = good.replace("exp(a=1)", "exp").replace("k = 4", "a = 4").replace("k*q", "a*q");
    refused_at(
        "models_sampled_a",
        &a,
        12,
        ["`a` is the rate of stretched time here", "another name"],
    );
    // Without `measured` it is the output that is measured.
    let output = good.replace("measured = [\"q\", \"w\"]\n", "observer_poles = [-4, -5]\n");
    spec(&output);
    for (to, message) in
        [("sin(q)", "`observer_poles` without an observer"), ("q + 1", "is 1 at rest")]
    {
        let text = output.replace("output = \"q\"", &format!("output = \"{to}\""));
        let line = if to == "sin(q)" { 5 } else { 11 };
        refused_at("models_sampled_output", &text, line, [message, ""]);
    }
}
