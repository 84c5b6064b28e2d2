//! Verdicts of `check` on the zero dynamics.

use super::{checked, example, support};
use support::{run_in, words};

fn design(model: &str) -> String {
    format!("mu = \"exp(a=1)\"\n[params]\ntau = 1\n{model}")
}

#[test]
fn zero_dynamics_are_judged_by_their_roots() {
    let drift = |output: &str, params: &str| {
        // x = (p, q, r): p' = u - p, q' = p - 2 q, r' = q - s r.
        format!(
            "{params}\n[model]\nstates = \"p, q, r\"\ninput = \"u\"\noutput = \"{output}\"\n\
             dynamics = {{ p = \"u - p\", q = \"p - 2*q\", r = \"q - s*r\" }}\n"
        )
    };
    for (model, verdict, told) in [
        // y = p: q and r are left, with the roots -2 and -s.
        (
            drift("p", "s = 3"),
            "sound",
            "the relative degree is 1 of 3 states; at the origin the zero dynamics have the roots -2, -3 1/s",
        ),
        (drift("p", "s = -0.5"), "unsound", "the roots 0.5, -2 1/s"),
        (drift("p", "s = 0"), "undecided", "on the imaginary axis"),
        (drift("p", ""), "undecided", "`s` is left to run time"),
        // y = q - r has the numerator s + (s - 1) over (s + 1)(s + 2)(s + s).
        (
            drift("q - r", "s = 3"),
            "sound",
            "of 3 states; at the origin the zero dynamics have the roots -2 1/s",
        ),
        (drift("q - r", "s = 0.25"), "unsound", "the roots 0.75 1/s"),
        (drift("r", "s = 3"), "sound", "none: the relative degree is 3"),
        (
            drift("p + 1", "s = 3"),
            "sound",
            "at the rest point p = -1, q = -0.5, r = -0.1667, u = -1",
        ),
        (drift("exp(p) - 1", "s = 3"), "sound", "the roots -2, -3 1/s"),
        (drift("p^2/2 + r", "s = 3"), "unsound", "is 0 at the origin: the law divides by it"),
    ] {
        let (found, summary) = checked("zeros", "models_roots", &design(&model));
        assert_eq!(found, verdict, "{model}: {summary}");
        assert!(summary.contains(told), "{model}: {summary}");
    }
}

#[test]
fn a_rest_that_needs_an_input_is_found() {
    // u holds w at 0 against c; without it the origin is no rest point of v.
    let model = |v: &str| {
        design(&format!(
            "[model]\nstates = \"w, v\"\ninput = \"u\"\noutput = \"w\"\ndynamics = {{ w = \"u - 3\", v = \"{v}\" }}\n"
        ))
    };
    let of = |v: &str| checked("zeros", "models_rest", &model(v));
    assert_eq!(of("w + u*v - 3*v - v").0, "sound");
    assert_eq!(of("w + u*v - 2*v").0, "unsound");
    let (verdict, summary) = of("1 - v");
    assert_eq!(verdict, "sound");
    assert!(summary.contains("at the rest point w = 0, v = 1, u = 3"), "{summary}");
}

#[test]
fn a_pendulum_on_a_cart_falls_with_the_roots_of_a_pendulum() {
    let (verdict, summary) = checked("zeros", "models_cart", &example("cart.toml"));
    let root = (9.81f64 / 0.5).sqrt();
    assert_eq!(verdict, "unsound");
    assert!(summary.contains(&format!("{root:.3}, -{root:.3} 1/s")), "{summary}");
}

/// The command that `check` prints, in flags, is the same design.
#[test]
fn the_command_of_a_model_reads_back() {
    for name in ["drive.toml", "cart.toml", "levitation.toml"] {
        let folder = support::folder_with("models_command", name, example(name));
        let command = |arguments: &[&str]| {
            let all = [&["check"], arguments, &["--format", "json"]].concat();
            let (_, json, stderr) = run_in(&folder, &all);
            let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
            found["command"].as_str().expect("a command").to_owned()
        };
        let from_file = command(&[name]);
        let mut flags = vec![String::new()];
        let mut quoted = false;
        for c in from_file.chars() {
            match c {
                '"' => quoted = !quoted,
                ' ' if !quoted => flags.push(String::new()),
                c => flags.last_mut().expect("a flag").push(c),
            }
        }
        let flags: Vec<_> = flags.iter().map(String::as_str).collect();
        assert_eq!(command(&flags), from_file, "{name}");
    }
    let law = words::stdout(&["show", "law", "--n", "1", "--mu", "exp"]);
    assert!(!law.contains("of the chain"), "{law}");
}
