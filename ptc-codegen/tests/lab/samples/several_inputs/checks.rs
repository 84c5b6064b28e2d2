//! Checks of plants with several inputs.

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};

use super::{FOUR, changed};
use crate::support::{example, spec};

/// A check that proves nothing does not report `sound`.
#[test]
fn unproved_checks_are_not_sound() {
    let report = |text: &str| examine(&spec(text));
    let of = |text: &str, name: &str| {
        let outcome = report(text).outcomes.into_iter().find(|outcome| outcome.name == name);
        outcome.expect("a check")
    };
    let tank = |x_max: &str, limit: &str| {
        let top = format!("sample_time = 0.05\nx_max = {x_max}\nnoise = [1e-3, 0.1, 0.1]");
        changed(&example("tank.toml"), &top, limit)
    };
    for (name, verdict, why) in [
        ("sampling", Verdict::NotNeeded, "several inputs"),
        ("deadline", Verdict::NotNeeded, "several inputs"),
        ("loop", Verdict::NotChecked, "`x0_max` is not given"),
    ] {
        let found = of(&tank("[0.9, 50, 50]", ""), name);
        assert_eq!(found.verdict, verdict, "{name}: {}", found.summary);
        assert!(found.summary.contains(why), "{name}: {}", found.summary);
    }
    let arm = |mass: &str| {
        let top = "mu = \"exp(a=1)\"\npoles = [-3, -4]\nsample_time = 0.05\nx0_max = [1, 1]\nerror = 0.1\nx_max = [3, 3, 9, 9]";
        changed(&example("two_link.toml"), top, mass)
    };
    for (text, verdict, summary) in [
        (tank("[0.9, 50, 50]", ""), Verdict::NotChecked, "within `x_max` it divides by no 0"),
        (tank("[1, 50, 50]", ""), Verdict::Refuted, "1 + h, is 0 at h = -1: the law divides by it"),
        (arm("m2 = 1.5"), Verdict::NotChecked, "within `x_max` it divides by no 0"),
        (
            changed(
                FOUR,
                "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.01\nx_max = [1, 1, 9, 1, 1, 9]",
                "tau = 1",
            ),
            Verdict::NotChecked,
            "within `x_max` it divides by no 0",
        ),
        (
            changed(
                FOUR,
                "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.01\nx_max = [4, 3, 9, 1, 1, 9]",
                "tau = 1",
            ),
            Verdict::Refuted,
            "the law divides by it",
        ),
    ] {
        let found = of(&text, "envelope");
        assert_eq!(found.verdict, verdict, "{text}: {}", found.summary);
        assert!(found.summary.contains(summary), "{}", found.summary);
    }
    let follows =
        arm("m2 = 1.5").replace("sample_time", "reference = [\"sin(t)\", \"0\"]\nsample_time");
    for text in [arm("m2 = 1.5"), follows] {
        let looped = of(&text, "loop");
        assert!(
            ![Verdict::Sound, Verdict::Refuted].contains(&looped.verdict),
            "{}",
            looped.summary
        );
    }
    let looped = of(&arm("m2 = 1.5"), "loop");
    assert_eq!(looped.verdict, Verdict::Undecided, "{}", looped.summary);
    assert!(looped.summary.contains("a shorter sample_time"), "{}", looped.summary);
    // What is left to run time may be anything, unless it has bounds.
    let open =
        tank("[0.5, 50, 50]", "").replace("e = \"(c - e)*(1 + h)\"", "e = \"(c - e)*(k + h)\"");
    for (text, verdict, summary) in [
        (open.clone(), Verdict::NotChecked, "`k` is left to run time without bounds"),
        (
            open.replace("[params]", "[params]\nk = [0.6, 2]"),
            Verdict::NotChecked,
            "divides by no 0",
        ),
        (
            open.replace("[params]", "[params]\nk = [0.4, 2]"),
            Verdict::Refuted,
            "the law divides by it",
        ),
    ] {
        let found = of(&text, "envelope");
        assert_eq!(found.verdict, verdict, "{text}: {}", found.summary);
        assert!(found.summary.contains(summary), "{}", found.summary);
    }
}

/// The check `loop` of several axes equals that of each axis alone.
#[test]
fn loop_of_several_axes_matches_each_axis() {
    let keys = "n = 2\nclock = \"samples\"\nmu = \"exp(a=1)\"\nsample_time = 0.01\neps = 0\nx0_max = [0.5, 0.5]\n";
    let params = "[params]\ntau = 1\nu_max = 50\n";
    let of = |own: &str| -> Outcome {
        let text = format!("{keys}error = [1e-6, 5e-5]\n{own}\n{params}");
        let outcomes = examine(&spec(&text)).outcomes;
        outcomes.into_iter().find(|outcome| outcome.name == "loop").expect("a check")
    };
    let each = [
        of("poles = [-4, -5]\ng = 2\nreference = \"0.3*sin(2*t)\""),
        of("poles = [-3, -6]\ng = -0.5\nreference = \"0.2*cos(t)\""),
    ];
    let chains = |references: &str| {
        of(&format!(
            "axes = 2\npoles = [[-4, -5], [-3, -6]]\ng = [2, -0.5]\nreference = {references}"
        ))
    };
    let both = chains("[\"0.3*sin(2*t)\", \"0.2*cos(t)\"]");
    assert_eq!(both.verdict, Verdict::Sound, "{}", both.summary);
    assert_eq!(both.summary, format!("axis 1: {}", each[0].summary));
    let second = format!("axis 2: sound: {}", each[1].summary);
    assert_eq!(both.details.last(), Some(&second));
    // What is left of one that is too fast may be too much.
    let fast = chains("[\"0.3*sin(2*t)\", \"0.05*cos(9*t)\"]");
    assert_eq!(fast.verdict, Verdict::Undecided, "{}", fast.summary);
    assert!(fast.summary.starts_with("axis 2: "), "{}", fast.summary);
    let given = chains("\"input\"");
    assert_eq!(given.verdict, Verdict::Undecided, "{}", given.summary);
}
