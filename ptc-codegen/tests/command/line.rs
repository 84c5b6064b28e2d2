//! The command line as a user meets it: mistakes, help and the list of families.

use crate::support;

use support::command;
use support::words::{json, stderr, stdout};

#[test]
fn an_error_quotes_the_value_and_underlines_what_is_wrong() {
    let told = stderr(&["emit", "--lang", "c", "--n", "3", "--mu", "exp(a=1, b=-2)"], 2);
    let expected = r#"error[unknown-parameter]: `exp` has no parameter `b`
  |
  | --mu "exp(a=1, b=-2)"
  |                ^ no such parameter
  |
  = help: its parameters are a

"#;
    let lines = |text: &str| text.lines().map(|l| l.trim().to_owned()).collect::<Vec<_>>();
    assert_eq!(lines(&told), lines(expected), "{told}");
}

#[test]
fn every_kind_of_mistake_has_its_message() {
    let emit = ["emit", "--lang", "c", "-o", "-"];
    let good = ["--n=3", "--mu=exp"];
    for (bad, parts) in [
        (&["--n=3", "--mu=exponential"][..], &["[unknown-family]", "`exp`?", "exp_sum"][..]),
        (&["--n=3", "--mu=3"], &["[bad-expression]", "does not depend on `t`"]),
        (&["--n=3", "--mu=exp", "--param=theta=3"], &["nothing uses the parameter `theta`"]),
        (&["--n=3"], &["[missing-key]: `mu`", "--mu \"exp(a=1)\""]),
        (&["--mu=exp"], &["[missing-key]: `n`", "1..=16", "--n 3"]),
        (&["--n=17", "--mu=exp"], &["[bad-value]", "--n \"17\"", "^^", "1..=16"]),
        (&["--n=2.5", "--mu=exp"], &["[bad-value]", "--n \"2.5\""]),
        (&["--n=three", "--mu=exp"], &["[bad-value]", "--n \"three\""]),
        (&["--n=", "--mu=exp"], &["[syntax]", "the end", "--n \"\""]),
        (&["--n=3", "--mu=exp(a=0)"], &["[bad-value]", "`0`", "> 0"]),
        (&["--n=3", "--mu=exp(a=inf)"], &["[bad-value]", "`inf`"]),
        (&["--n=3", "--mu=exp(a=1"], &["[syntax]", "`)`"]),
        (&["--n=3", "--mu=exp(a=1,a=2)"], &["given twice"]),
        (&["--n=3", "--mu=exp(1)"], &["no name", "exp(a=1)"]),
        (&["--n=3", "--mu=exp_sum(rates=[1])"], &["exp_sum(2)"]),
        (&["--n=3", "--mu=exp_sum(rates=[1,-1])"], &["[bad-value]", "-1"]),
        (&["--n=3", "--mu=exp", "--tau", "-2"], &["[bad-value]", "--tau \"-2\"", "> 0"]),
        (&["--n=3", "--mu=exp", "--u-max", "0"], &["--u-max \"0\"", "infinity allowed"]),
        (&["--n=3", "--mu=exp", "--t0", "inf"], &["--t0 \"inf\"", "finite"]),
        (&["--n=3", "--mu=exp", "--tau=1", "--eps=1"], &["eps = 1", "below tau"]),
        (&["--n=3", "--mu=exp", "--gains=1,2"], &["2 gains for order n = 3", "k_1..k_3"]),
        (&["--n=3", "--mu=exp", "--gains", "-1,2,x"], &["--gains \"-1,2,x\"", "`x`"]),
        (&["--n=0", "--mu=expp", "--gains", "1,x"], &["[unknown-family]", "--n \"0\"", "`x`"]),
        (&["--n=3", "--mu=exp", "--name=exp"], &["`exp` cannot name"]),
        (&["--n=3", "--mu=exp", "--name=status"], &["`status` cannot name"]),
        (&["--n=3", "--mu=exp", "--name=if"], &["`if` cannot name", "identifier"]),
        (&["--n=3", "--mu=exp", "--name=a b"], &["one identifier", "write a_b"]),
        (&["--n=3", "--mu=exp", "--precision=f16"], &["`f16`", "f64, f32"]),
        (&["--n=3", "--mu=exp", "--guard=half"], &["`half`", "full, result, none"]),
        (&["--n=3", "--mu=exp", "--fma=on"], &["fma = `on`", "true, false"]),
        (&["--n=3", "--mu=exp", "--fma", "--acsl"], &["[unsupported]", "leave `fma` out"]),
        (&["--n=3", "--mu=exp", "--latency=1"], &["latency = `1`", "true, false"]),
        (&["--n=3", "--mu=exp", "--latency", "--clock=samples"], &["leave `latency` out"]),
        (&["--n=3", "--mu=exp", "--precision=f32", "--tau=1e39"], &["1e39", "f32"]),
        (&["--n=3", "--mu=exp", "--lang=c"], &["--lang"]),
        (&["--n=3", "--mu=exp", "--check"], &["--check", "--out"]),
        (&["--n=3", "--mu=exp", "--colour"], &["--colour"]),
    ] {
        let told = stderr(&[&emit, bad].concat(), 2);
        for part in parts {
            assert!(told.contains(part), "{bad:?} lacks {part:?}:\n{told}");
        }
    }
    assert!(stderr(&[&["emit", "--lang=cobol"], &good[..]].concat(), 2).contains("rust"));
    assert!(stderr(&["shout"], 2).contains("shout"));
}

#[test]
fn all_mistakes_are_told_at_once_in_the_order_of_the_help() {
    let told = stderr(
        &["emit", "--lang=c", "--tau=x(", "--mu=zebra", "--u-max=-1", "--n=0", "--name=9"],
        2,
    );
    let at: Vec<_> =
        ["--n \"0\"", "--mu \"zebra\"", "--name \"9\"", "--tau \"x(\"", "--u-max \"-1\""]
            .iter()
            .map(|part| told.find(part).unwrap_or_else(|| panic!("{part}: {told}")))
            .collect();
    assert!(at.is_sorted(), "{told}");
    assert!(!told.contains("missing"), "{told}");
}

#[test]
fn odd_input_is_refused_without_a_panic() {
    let long = "x".repeat(100_000);
    let nested = "(".repeat(10_000);
    let digits = "9".repeat(100_000);
    let odd = [
        "",
        " ",
        ",",
        ",,",
        "=",
        "()",
        "exp()",
        "exp(,)",
        "exp(=1)",
        "[",
        "]",
        "[]",
        "[[[[[[1]]]]]]",
        "é",
        "exp(a=é)",
        "指数",
        "e\u{301}xp",
        "👩\u{200d}🚀",
        "\n",
        "exp\n(a\n=",
        "\t\"",
        "'",
        "\\",
        "\u{7f}",
        "\u{1b}[31mred",
        "\u{202e}pxe",
        "-",
        "--",
        "--n",
        "+",
        ".",
        "1e",
        "1e999999999999",
        "-1e-400",
        "nan",
        "NaN",
        "-inf",
        "0x10",
        "1_000",
        &long,
        &nested,
        &digits,
    ];
    for text in odd {
        for key in ["n", "mu", "name", "precision", "guard", "gains", "tau", "t0", "eps", "u-max"] {
            let flag = format!("--{key}={text}");
            let mut arguments = vec!["emit", "--lang=c", "-o", "-", &flag];
            arguments.extend((key != "n").then_some("--n=2"));
            arguments.extend((key != "mu").then_some("--mu=exp"));
            let output = command(&arguments).output().expect("the binary runs");
            let told = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 2)), "{key} {text:.40?}: {told:.400}");
            assert!(!told.contains("panicked"), "{key} {text:.40?}: {told:.400}");
            assert!(!told.contains('\u{1b}'), "{key}: a control character reaches the terminal");
            assert!(told.len() < 4000, "{key}: {} bytes of {told:.400}", told.len());
        }
        let output =
            command(&["show", "r", &format!("--n={text}")]).output().expect("the binary runs");
        assert_eq!(output.status.code(), Some(2), "{text:.40?}");
    }
}

#[test]
fn list_tells_every_family_with_its_parameters() {
    let text = stdout(&["list"]);
    let listed = json(&["list", "--format", "json"]);
    let families = listed["families"].as_array().expect("a list");
    assert_eq!(families.len(), 8);
    for family in families {
        let name = family["name"].as_str().expect("a name");
        assert!(text.contains(&format!("\n{name}\n")), "{name}: {text}");
        assert!(text.contains(family["mu"].as_str().expect("a formula")));
        assert!(!family["parameters"].as_array().expect("a list").is_empty(), "{name}");
    }
    assert_eq!(
        families[2]["parameters"][1],
        serde_json::json!({
            "key": "m",
            "unit": "1",
            "domain": "finite, > 0",
            "meaning": "exponent of the power mapping",
        })
    );
    assert_eq!(families[6]["parameters"][0]["key"], "rates");
    let common = listed["parameters"].as_array().expect("a list");
    let keys: Vec<_> = common.iter().filter_map(|p| p["key"].as_str()).collect();
    assert_eq!(keys, ["tau", "t0", "eps", "u_max", "k"]);
}

#[test]
fn help_has_examples_and_the_legal_values() {
    let told = stdout(&["emit", "--help"]);
    for part in ["Examples:", "--u-max", "inf omits the clipping", "1..=16", "exp_sum"] {
        assert!(told.contains(part), "{part}: {told}");
    }
    assert!(stdout(&["show", "--help"]).contains("\"coefficient\""));
    assert!(stdout(&["--version"]).contains(env!("CARGO_PKG_VERSION")));
    stderr(&[], 2);
}

#[test]
fn the_engine_by_its_name_is_the_default() {
    let show = ["show", "law", "--n", "4", "--mu", "tan"];
    assert_eq!(stdout(&[&show[..], &["--engine", "ptc"]].concat()), stdout(&show));
    let emit = ["emit", "--lang", "c", "--n", "3", "--kappa", "dt/(tau - dt)", "-o", "-"];
    assert_eq!(stdout(&[&emit[..], &["--engine=ptc"]].concat()), stdout(&emit));
}

#[test]
fn an_engine_that_is_not_installed_tells_how_to_build_it() {
    for start in [
        &["show", "tables", "--n=3"][..],
        &["show", "r", "--n=3", "--mu=exp"],
        &["check", "--n=2", "--mu=exp"],
        &["emit", "--lang=c", "--n=2", "--mu=exp", "-o", "-"],
    ] {
        let mut run = command(start);
        run.args(["--engine", "symbolica"]).env("PTC_ENGINE_PROGRAM", "/nowhere/engine");
        let output = run.output().expect("the command runs");
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{told}");
        assert!(told.contains("`ptc-engine-symbolica`, which is not installed"), "{told}");
        assert!(told.contains("cargo install --path engines/symbolica"), "{told}");
        assert!(told.contains("docs/engines.md"), "{told}");
    }
}

/// Languages without fused operations refuse them; FMUs hold C, which has them.
#[test]
fn languages_without_fused_operations_refuse_them() {
    let design = ["--n=2", "--mu=exp", "--fma", "-o", "-"];
    for (lang, name) in [("python", "NumPy"), ("matlab", "MATLAB"), ("st", "Structured Text")] {
        let told = stderr(&[&["emit", "--lang", lang], &design[..]].concat(), 2);
        assert!(told.contains(&format!("{name} has no fused multiply-add")), "{told}");
        assert!(told.contains("leave `fma` out, or emit c, cpp, rust, fmu2 or fmu3"), "{told}");
    }
    for (lang, word) in [("c", "fma("), ("cpp", "std::fma("), ("rust", "math::mul_add(")] {
        let code = stdout(&[&["emit", "--lang", lang], &design[..]].concat());
        assert!(code.contains(word), "{code}");
    }
}
