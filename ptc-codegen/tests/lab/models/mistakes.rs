//! Models that are refused: each at its line, with what to change.

use super::support::{folder_with, refused_at, run_in};

const DRIVE: &str = "mu = \"exp(a=1)\"
poles = [-4, -5, -6]
[model]
states = [\"q\", \"w\", \"i\"]
input = \"V\"
output = \"q\"
dynamics = { q = \"w\", w = \"(k*i - b*w)/J\", i = \"(V - R*i - k*w)/L\" }
";

#[test]
fn mistakes_are_shown_at_their_lines() {
    for (from, to, line, message, help) in [
        ("w = \"(k*i - b*w)/J\", ", "", 7, "the state `w` has no dynamics", "w = \"...\""),
        ("i = \"(V", "ii = \"(V", 7, "`ii` is no state of the model", "the states are q, w, i"),
        ("q = \"w\"", "q = \"w\", q = \"i\"", 7, "the state `q` has two rates", "leave one"),
        (
            "k*i - b*w",
            "k*i - b*t",
            7,
            "`t` is not known where model is computed",
            "a parameter needs another name",
        ),
        ("k*i - b*w", "k*i - b*foo(w)", 7, "unknown function `foo`", "the functions are"),
        (
            "V - R*i",
            "V^2 - R*i",
            7,
            "i' is not affine in the input `V`: its slope is 2*V/L",
            "a curved actuator",
        ),
        ("V - R*i", "abs(V) - R*i", 7, "i' is not affine", "affine"),
        (
            "V - R*i",
            "-R*i",
            6,
            "the input `V` does not reach the output",
            "take an output that it moves",
        ),
        (
            "output = \"q\"",
            "output = \"V\"",
            6,
            "the output depends on the input",
            "function of the states",
        ),
        ("output = \"q\"", "output = \"abs(q)\"", 6, "abs(q) has a kink", "tanh(w/small)"),
        ("k*i - b*w", "k*i - b*sign(w)", 6, "has a kink", "tanh(w/small)"),
        ("\"i\"]", "\"q\"]", 4, "the model has two names `q`", "a name of its own"),
        ("\"i\"]", "\"sin\"]", 4, "cannot name a part of a model", "no function"),
        ("input = \"V\"", "input = \"int\"", 5, "cannot name a part of a model", "C or Rust"),
        ("input = \"V\"\n", "", 0, "the model has no `input`", "give a name"),
        (
            "mu = ",
            "n = 2\nmu = ",
            1,
            "n = 2, but the relative degree of the output is 3",
            "leave n out, or give 3",
        ),
        ("mu = ", "g = \"2\"\nmu = ", 1, "`g` beside a model", "leave it out"),
        ("mu = ", "f = \"2\"\nmu = ", 1, "`f` beside a model", "leave it out"),
        ("poles = [-4, -5, -6]", "pi0 = \"-xi1*x1_0\"", 2, "beside a model pi0 is", "at the start"),
        (
            "k*i - b*w",
            "a*i - b*w",
            7,
            "`a` is the rate of stretched time here",
            "choose another name",
        ),
        (
            "[model]",
            "[params]\nzeta = 1\n[model]",
            4,
            "nothing uses the parameter `zeta`",
            "R, b, k",
        ),
        ("dynamics = {", "dynamics = [\"w\"]\n#", 7, "1 rate for 3 states", "in their order"),
        (
            "[model]",
            "[envelope]\nx_max = [1, 2]\n[model]",
            4,
            "2 bounds for 3 states of the model",
            "one bound for each",
        ),
    ] {
        assert!(DRIVE.contains(from), "{from}");
        refused_at("models_mistakes", &DRIVE.replacen(from, to, 1), line, [message, help]);
    }
}

#[test]
fn what_is_not_decided_is_shown() {
    // The bracket is 0 for all q, which no normal form knows.
    let text =
        DRIVE.replace("output = \"q\"", "output = \"w + i*(atan(exp(q)) + atan(exp(-q)) - pi/2)\"");
    let folder = folder_with("models_open", "drive.toml", &text);
    let (code, _, stderr) = run_in(&folder, &["emit", "--lang", "c", "drive.toml"]);
    assert_eq!(code, Some(2), "{stderr}");
    assert!(stderr.contains("the relative degree is not decided: is "), "{stderr}");
}

#[test]
fn commands_that_know_chains_alone_say_so() {
    let folder = folder_with("models_chains", "drive.toml", DRIVE);
    let (_, _, stderr) =
        run_in(&folder, &["emit", "--lang", "c", "drive.toml", "--project", "cmake"]);
    assert!(!stderr.is_empty(), "a project has a plant of its own");
}

/// The loop and the period are judged for a chain, and say no more than that.
#[test]
fn no_check_of_the_chain_is_sound_for_a_model() {
    let design = DRIVE.replace("[model]", "sample_time = 1e-4\nerror = 0.1\n[params]\ntau = 0.4\n[envelope]\nx0_max = [1, 1, 1]\n[model]");
    let design = design
        .replace("[envelope]\nx0_max = [1, 1, 1]\n", "")
        .replace("error = 0.1", "error = 0.1\nx0_max = [1, 1, 1]");
    let folder = folder_with("models_checks", "drive.toml", &design);
    let (_, json, stderr) = run_in(&folder, &["check", "drive.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
    for name in ["sampling", "loop"] {
        let all = found["checks"].as_array().expect("checks");
        let own = all.iter().find(|check| check["name"] == name).expect("an outcome");
        assert!(
            ["undecided", "not checked"].contains(&own["verdict"].as_str().expect("text")),
            "{own}"
        );
        assert!(own["summary"].as_str().expect("text").contains("the"), "{own}");
    }
}
