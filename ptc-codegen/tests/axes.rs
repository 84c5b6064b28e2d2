//! Designs of several axes: what is refused, where and with which way out, and what the checks say.

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::examine;
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;

fn read_keys(keys: &[(&str, &str)]) -> Result<Spec, Vec<Diagnostic>> {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    read(&keys.iter().map(entry).collect::<Vec<_>>())
}

/// Two axes of order 2 with `keys` beside them.
fn two(keys: &[(&str, &str)]) -> Result<Spec, Vec<Diagnostic>> {
    let base = [("n", "2"), ("mu", "exp(a=1)"), ("axes", "2")];
    let own = base.iter().filter(|(key, _)| !keys.iter().any(|(other, _)| other == key));
    read_keys(&own.chain(keys).copied().collect::<Vec<_>>())
}

#[test]
fn what_axes_cannot_have_is_refused_at_its_key() {
    /// Keys, and parts of the message and of its help.
    type Case<'a> = (&'a [(&'a str, &'a str)], &'a str, &'a str);
    let cases: [Case<'_>; 17] = [
        (&[("n", "[2, 3]")], "n", "axes share one order"),
        (&[("axes", "0")], "axes", "an integer 1..=16"),
        (&[("axes", "17")], "axes", "an integer 1..=16"),
        (&[("gains", "[[6, 5], [6, 5, 1]]")], "gains", "k_1..k_2"),
        (&[("gains", "[[6, 5], [6, 5], [6, 5]]")], "gains", "one for each of the 2 axes"),
        (&[("poles", "[[-3, -4]]")], "poles", "one for each of the 2 axes"),
        (&[("limits", "5")], "limits", "one for each of the 2 axes"),
        (&[("limits", "5, inf")], "limits", "u_max = inf on all axes"),
        (&[("limits", "5, 6"), ("u_max", "7")], "u_max", "`limits` for each axis"),
        (&[("g", "[1, x1]")], "g", "divide the u of each axis"),
        (&[("g", "[1, 0]")], "g", "not 0"),
        (&[("f", "-x1")], "f", "cancel f outside"),
        (&[("pi0", "-xi1^3 - xi2")], "pi0", "give gains or poles"),
        (&[("reference", "sin(t)")], "reference", "`reference` = input"),
        (&[("after", "zero")], "after", "u = 0 outside"),
        (&[("clock", "samples"), ("delay", "1")], "delay", "call all with the same k"),
        (&[("noise", "[[1e-3, 1e-3], [1, 1]]"), ("sample_time", "1e-3")], "noise", "one unit"),
    ];
    for (keys, at, help) in cases {
        let found = two(keys).expect_err("a mistake");
        let told = found.iter().any(|d| d.key.starts_with(at) && d.help.contains(help));
        assert!(told, "{keys:?}: {found:#?}");
    }
    for keys in [[("gains", "[[6, 5], [6, 5]]")], [("limits", "5, 6")], [("g", "[1, 2]")]] {
        let all = [&[("n", "2"), ("mu", "exp(a=1)")][..], &keys[..]].concat();
        let found = read_keys(&all).expect_err("a mistake");
        assert!(found.iter().any(|d| d.help.contains("axes = 2")), "{keys:?}: {found:#?}");
    }
}

/// The command of a spec gives it back.
#[test]
fn the_command_is_read_again() {
    let spec = two(&[
        ("poles", "[[-3, -4], [-5+2i, -5-2i]]"),
        ("limits", "5, 6"),
        ("g", "[1/m, 2]"),
        ("reference", "input"),
    ])
    .expect("a legal design");
    let wanted = "--n 2 --axes 2 --mu \"exp(a=1)\" --limits=5,6 --poles=\"[[-3,-4],[-5+2i,-5-2i]]\" --g=\"[1/m, 2]\" --reference input";
    assert_eq!(spec.command(), wanted);
    let further = [("limits", "5, 6"), ("g", "[1/m, 2]"), ("reference", "input")];
    let law = two(&[&[("pi0", "extern")][..], &further].concat()).expect("a legal design");
    let wanted = "--n 2 --axes 2 --mu \"exp(a=1)\" --limits=5,6 --pi0 extern --g=\"[1/m, 2]\" --reference input";
    assert_eq!(law.command(), wanted);
    // What such a law is given is one plant of chains.
    assert_eq!(law.state_names(), ["x1_1", "x2_1", "x1_2", "x2_2"]);
}

/// Each axis is judged by its own values, and the one that fails is named.
#[test]
fn every_axis_is_checked() {
    let shared = examine(&two(&[("poles", "-3, -4")]).expect("a legal design"));
    let one = examine(
        &read_keys(&[("n", "2"), ("mu", "exp(a=1)"), ("poles", "-3, -4")]).expect("a design"),
    );
    assert_eq!(shared.outcomes, one.outcomes);
    let slow = examine(&two(&[("poles", "[[-3, -4], [-1, -4]]")]).expect("a legal design"));
    let growth = slow.outcomes.iter().find(|o| o.name == "growth").expect("the check");
    assert_eq!(growth.verdict, Verdict::Unsound);
    assert!(growth.summary.starts_with("axis 2: "), "{}", growth.summary);
    assert!(growth.details.iter().any(|d| d.starts_with("axis 1: sound")), "{growth:?}");
}

/// An open eps is the largest that an axis requires.
#[test]
fn eps_suits_every_axis() {
    let common = [("tau", "1"), ("sample_time", "1e-3")];
    let eps = |keys: &[(&str, &str)]| {
        let report = examine(&read_keys(&[&common[..], keys].concat()).expect("a legal design"));
        let eps = report.spec.fixed[&Parameter::Eps].number().expect("a number").clone();
        (eps, report.refusals().count())
    };
    let one = |poles| eps(&[("n", "2"), ("mu", "exp(a=1)"), ("poles", poles)]);
    let ((slow, _), (fast, _)) = (one("-3, -4"), one("-30, -40"));
    assert!(slow < fast);
    let both = [("n", "2"), ("mu", "exp(a=1)"), ("axes", "2")];
    let found = eps(&[&both[..], &[("poles", "[[-3, -4], [-30, -40]]")]].concat());
    assert_eq!(found, (fast, 0));
}

#[test]
fn what_knows_one_chain_says_so() {
    let spec = two(&[("poles", "-3, -4")]).expect("a legal design");
    let found = ptc_codegen::generate_with_proof(&spec).expect_err("no axes");
    assert_eq!(found[0].key, "axes", "{found:?}");
}

/// The law of one axis is given its own state in stretched time.
#[test]
fn a_law_of_one_axis_is_that_of_a_chain() {
    let one = two(&[("axes", "1"), ("pi0", "extern")]).expect("a design");
    let text = |language| {
        let files = ptc_codegen::generate(&one, language).expect("files");
        files.into_iter().map(|file| file.text).collect::<String>()
    };
    let (rust, c) = (text(Language::Rust), text(Language::C));
    assert!(rust.contains("pi0: impl FnOnce(&[f64; 2], f64) -> f64"), "{rust}");
    assert!(c.contains("a user-defined function of xi and t_kappa\n"), "{c}");
}
