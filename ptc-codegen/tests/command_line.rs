//! The command line as a user meets it: exit codes, the two output streams, files.
#![cfg(feature = "cli")]

mod support;

use std::fs;
use std::path::Path;
use std::process::Stdio;

use serde_json::{Value, json};
use support::{command, folder};

fn stdout(arguments: &[&str]) -> String {
    support::stdout(&mut command(arguments))
}

fn stderr(arguments: &[&str], code: i32) -> String {
    support::stderr(&mut command(arguments), code)
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&stdout(arguments)).expect("JSON")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<_> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    names.sort();
    names
}

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
        (&["--n=3", "--mu=exp", "--name=a b"], &["[syntax]", "`b`"]),
        (&["--n=3", "--mu=exp", "--precision=f16"], &["`f16`", "f64, f32"]),
        (&["--n=3", "--mu=exp", "--guard=half"], &["`half`", "full, result, none"]),
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
fn the_json_of_r_has_its_documented_shape() {
    let expected = json!({"r": [
        {"k": 1, "terms": [{"coefficient": "1", "exponents": {"1": -1}}]},
        {"k": 2, "terms": [{"coefficient": "-1", "exponents": {"1": -3, "2": 1}}]},
        {"k": 3, "terms": [
            {"coefficient": "3", "exponents": {"1": -5, "2": 2}},
            {"coefficient": "-1", "exponents": {"1": -4, "3": 1}},
        ]},
    ]});
    assert_eq!(json(&["show", "r", "--n", "3", "--format", "json"]), expected);
    let eight = json(&["show", "r", "--n", "8", "--format", "json"]);
    assert_eq!(eight["r"].as_array().map(Vec::len), Some(8));
    // One term for each partition of 7.
    assert_eq!(eight["r"][7]["terms"].as_array().map(Vec::len), Some(15));
    let thirty = json(&["show", "r", "--n", "30", "--format", "json"]);
    assert_eq!(thirty["r"][29]["terms"].as_array().map(Vec::len), Some(4565));
}

#[test]
fn the_json_of_the_other_subjects_is_alike() {
    let big = json(&["show", "R", "--n=3", "--format=json"]);
    let square = json!({"k": 2, "m": 2, "terms": [{"coefficient": "3", "exponents": {"2": 2}}]});
    assert_eq!(big["R"][5], square);
    let tables = json(&["show", "tables", "--n=3", "--format=json"]);
    assert_eq!((&tables["A1"][5], tables["A2"].as_array().map(Vec::len)), (&square, Some(3)));

    let bell = json(&["show", "bell", "--n=3", "--format=json"]);
    let entry =
        json!({"i": 3, "j": 2, "terms": [{"coefficient": "3", "exponents": {"1": 1, "2": 1}}]});
    assert_eq!(bell["B"][8], entry);

    let matrix = json(&["show", "matrix", "--n=2", "--mu=exp", "--format=json"]);
    let r1 = json!([{"coefficient": "1", "exponents": {"a": 1, "T": 1}}]);
    assert_eq!(matrix["BB"][3], json!({"i": 2, "j": 2, "terms": r1}));
    assert_eq!(matrix["b"][0], json!({"j": 1, "terms": []}));
    assert_eq!(matrix["BB"].as_array().map(Vec::len), Some(4));

    let law = json(&["show", "law", "--n=2", "--mu=exp", "--format=json"]);
    assert_eq!(law["row"][0]["terms"], json!([{"coefficient": "-1", "exponents": {"K1": 1}}]));
    assert_eq!(
        law["K"][0]["terms"],
        json!([{"coefficient": "1", "exponents": {"a": -2, "k1": 1}}])
    );
    let sum = json(&["show", "law", "--n=2", "--mu=exp_sum", "--format=json"]);
    assert!(sum["law"].is_string() && sum["r"].is_array(), "{sum}");
}

#[test]
fn text_is_readable_and_holds_the_corrected_entries() {
    let r = stdout(&["show", "r", "--n", "3"]);
    assert!(r.ends_with("r3 = 3*s'^-5*s''^2 - s'^-4*s^(3)\n"), "{r}");
    assert!(stdout(&["show", "R", "--n", "3"]).contains("R_{2,2} = 3*s''^2\n"));
    let tables = stdout(&["show", "tables", "--n", "5"]);
    assert!(tables.contains("k = 2  0      s^(3)  3*s''^2\n"), "{tables}");
    assert!(tables.contains("r3 = 3*s'^-5*s''^2 - s'^-4*s^(3)\n"), "{tables}");
    let matrix = stdout(&["show", "matrix", "--n", "3", "--mu", "exp(a=1)"]);
    assert!(matrix.contains("  [ 1  0   0   ]\n  [ 0  T   0   ]\n  [ 0  -T  T^2 ]\n"), "{matrix}");
    assert!(matrix.contains("with a = 1"), "{matrix}");
    assert!(stdout(&["show", "bell", "--n=3"]).contains("B_{3,2} = 3*r1*r2\n"));
    let law = stdout(&["show", "law", "--n=2", "--mu=exp"]);
    assert!(law.contains("gain_j = inv_T^(3-j) * row_j") && law.contains("row2 = 1 - K2"), "{law}");
    // A fixed parameter is folded in, exactly.
    let half = stdout(&["show", "law", "--n=2", "--mu=exp(a=0.5)"]);
    assert!(half.contains("K1 = 4*k1\n"), "{half}");
    let power = stdout(&["show", "r", "--n=2", "--mu=power(m=2)"]);
    assert!(power.contains("r2 = -3*a^2*T*P^2\n"), "{power}");
}

#[test]
fn latex_is_balanced() {
    let families = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum(3)"];
    let flags = families.iter().map(|f| format!("--mu={f}")).collect::<Vec<_>>();
    for n in ["--n=1", "--n=4", "--n=11"] {
        for subject in ["r", "R", "bell", "matrix", "law", "tables"] {
            balanced(&stdout(&["show", subject, n, "--format=latex"]));
            for flag in flags.iter().filter(|_| !matches!(subject, "R" | "tables")) {
                balanced(&stdout(&["show", subject, n, flag, "--format=latex"]));
            }
        }
    }
    let tables = stdout(&["show", "tables", "--n=4", "--format=latex"]);
    assert!(tables.contains(r"3 \left(s''\right)^{2}"), "{tables}");
}

/// Braces, environments and `\left` match, and no superscript follows another.
fn balanced(latex: &str) {
    let count = |what: &str| latex.matches(what).count();
    assert_eq!(count("{"), count("}"), "{latex}");
    assert_eq!(count(r"\left"), count(r"\right"), "{latex}");
    assert_eq!(count(r"\begin{"), count(r"\end{"), "{latex}");
    assert_eq!(count("$") % 2, 0, "{latex}");
    assert!(!latex.contains("'^"), "{latex}");
    for (start, _) in latex.match_indices("^{") {
        let mut depth = 0;
        let closes = |c: char| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            c == '}' && depth == 0
        };
        let end = start + latex[start..].find(closes).expect("braces match") + 1;
        assert!(!latex[end..].starts_with(['^', '\'']), "{}", &latex[start..]);
    }
}

#[test]
fn show_says_where_it_stops() {
    for (arguments, part) in [
        (&["r", "--n=31"][..], "1..=30"),
        (&["law", "--n=17"], "1..=16"),
        (&["r", "--n=17", "--mu=exp"], "1..=16"),
        (&["r", "--n=0"], "--n \"0\""),
        (&["r"], "1..=30"),
        (&["R", "--n=3", "--mu=exp"], "abstract"),
        (&["tables", "--n=3", "--mu=exp"], "abstract"),
        (&["r", "--n=3", "--mu=expp"], "did you mean `exp`"),
        (&["q", "--n=3"], "tables"),
        (&["r", "--n=3", "--format=xml"], "latex"),
    ] {
        let told = stderr(&[&["show"], arguments].concat(), 2);
        assert!(told.contains(part), "{arguments:?}: {told}");
    }
    for subject in ["r", "R", "bell", "tables"] {
        assert!(!stdout(&["show", subject, "--n=30"]).is_empty());
    }
}

#[test]
fn list_tells_every_family_with_its_parameters() {
    let text = stdout(&["list"]);
    let listed = json(&["list", "--format", "json"]);
    let families = listed["families"].as_array().expect("a list");
    assert_eq!(families.len(), 7);
    for family in families {
        let name = family["name"].as_str().expect("a name");
        assert!(text.contains(&format!("\n{name}\n")), "{name}: {text}");
        assert!(text.contains(family["mu"].as_str().expect("a formula")));
        assert!(!family["parameters"].as_array().expect("a list").is_empty(), "{name}");
    }
    assert_eq!(
        families[2]["parameters"][1],
        json!({
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
    for part in ["Examples:", "--u-max", "inf leaves the clipping out", "1..=16", "exp_sum"] {
        assert!(told.contains(part), "{part}: {told}");
    }
    assert!(stdout(&["show", "--help"]).contains("\"coefficient\""));
    assert!(stdout(&["--version"]).contains(env!("CARGO_PKG_VERSION")));
    stderr(&[], 2);
}

#[test]
fn emit_writes_its_files_and_nothing_else() {
    let folder = folder("emit_writes");
    let deep = folder.join("made/when/missing");
    let out = deep.to_str().expect("UTF-8");
    let told = stdout(&["emit", "--lang", "c", "--n", "3", "--mu", "exp", "-o", out]);
    assert_eq!(names(&deep), ["ptc_exp3.c", "ptc_exp3.h"]);
    assert_eq!(told.matches("wrote ").count(), 2, "{told}");
    let again = stdout(&["emit", "--lang", "c", "--n", "3", "--mu", "exp", "-o", out]);
    assert_eq!(again.matches("unchanged ").count(), 2, "{again}");
    stdout(&["emit", "--lang", "rust", "--n", "3", "--mu", "exp", "-o", out]);
    assert_eq!(names(&deep), ["ptc_exp3.c", "ptc_exp3.h", "ptc_exp3.rs"]);

    let current = command(&["emit", "--lang=rust", "--n=3", "--mu=exp", "--name=roll"])
        .current_dir(&folder)
        .output()
        .expect("the binary runs");
    assert!(current.status.success());
    assert_eq!(names(&folder), ["made", "roll.rs"]);
}

#[test]
fn standard_output_gets_the_bytes_of_the_files() {
    let folder = folder("emit_prints");
    let out = folder.to_str().expect("UTF-8");
    for lang in ["c", "rust"] {
        stdout(&["emit", "--lang", lang, "--n", "3", "--mu", "exp", "-o", out]);
    }
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("written");
    let c = stdout(&["emit", "--lang", "c", "--n", "3", "--mu", "exp", "-o", "-"]);
    let (header, source) = (read("ptc_exp3.h"), read("ptc_exp3.c"));
    assert_eq!(
        c,
        format!("/* ---- ptc_exp3.h ---- */\n{header}/* ---- ptc_exp3.c ---- */\n{source}")
    );
    assert!(!header.is_empty() && !source.is_empty());
    let rust = stdout(&["emit", "--lang", "rust", "--n", "3", "--mu", "exp", "-o", "-"]);
    assert_eq!(rust, read("ptc_exp3.rs"));
}

#[test]
fn check_tells_drift_and_writes_nothing() {
    let folder = folder("emit_checks");
    let out = folder.to_str().expect("UTF-8");
    let emit = ["emit", "--lang", "c", "--n", "3", "--mu", "exp", "-o", out];
    let check = [&emit[..], &["--check"]].concat();

    let missing = stderr(&check, 1);
    assert!(missing.contains("ptc_exp3.h is missing") && missing.contains("ptc_exp3.c is missing"));
    assert_eq!(names(&folder), [""; 0]);

    stdout(&emit);
    assert_eq!(stdout(&check).matches("up to date").count(), 2);

    let path = folder.join("ptc_exp3.c");
    let good = fs::read_to_string(&path).expect("written");
    let second = good.find('\n').expect("two lines") + 1;
    let mut changed = good.clone().into_bytes();
    changed[second] ^= 1;
    for bytes in [changed, good.replace('\n', "\r\n").into_bytes(), good.trim_end().into()] {
        fs::write(&path, &bytes).expect("writable");
        let told = stderr(&check, 1);
        assert!(told.contains("ptc_exp3.c differs from line "), "{told}");
        assert!(!told.contains("ptc_exp3.h differs"), "{told}");
        assert_eq!(fs::read(&path).expect("there"), bytes, "--check must not write");
    }
    fs::write(&path, [0xff, 0xfe, b'\n']).expect("writable");
    assert!(stderr(&check, 1).contains("differs from line 1 on"));
    stdout(&emit);
    stdout(&check);
}

#[test]
fn a_place_that_cannot_be_written_leaves_nothing_behind() {
    let folder = folder("emit_fails");
    let file = folder.join("file");
    fs::write(&file, "").expect("writable");
    let below = file.join("below");
    for place in [&file, &below] {
        let place = place.to_str().expect("UTF-8");
        let told = stderr(&["emit", "--lang=c", "--n=3", "--mu=exp", "-o", place], 2);
        assert!(told.contains(place) && told.contains("help"), "{told}");
    }
    // The second file cannot be written, so the first is not either.
    let out = folder.join("out");
    fs::create_dir_all(out.join("ptc_exp3.c")).expect("a folder in the way");
    let place = out.to_str().expect("UTF-8");
    let told = stderr(&["emit", "--lang=c", "--n=3", "--mu=exp", "-o", place], 2);
    assert!(told.contains("ptc_exp3.c"), "{told}");
    assert_eq!(names(&out), ["ptc_exp3.c"]);
    let told = stderr(&["emit", "--lang=c", "--n=3", "--mu=exp", "--check", "-o", place], 2);
    assert!(told.contains("cannot read"), "{told}");
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    for arguments in [&["show", "r", "--n=30"][..], &["list"], &["--help"]] {
        let mut child = command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary runs");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && told.is_empty(), "{arguments:?}: {told}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_told() {
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
    let output = command(&["list"]).stdout(full).output().expect("the binary runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot write"));
}

#[test]
fn dump_shows_the_program_after_a_pass() {
    let args = |pass| ["emit", "--lang", "c", "--n", "2", "--mu", "power(m=3)", "--dump", pass];
    let (lowered, chained) = (stdout(&args("lower")), stdout(&args("chains")));
    assert!(lowered.contains(" power v") && !chained.contains(" power v"), "{lowered}{chained}");
    assert!(stderr(&args("chain"), 2).contains("chains"), "a near miss is suggested");
}

#[test]
fn a_self_test_stands_beside_its_controller() {
    let folder = folder("selftest");
    let out = folder.to_str().expect("UTF-8");
    let emit = ["emit", "--lang=c", "--n=2", "--mu=exp", "--name=roll", "--selftest", "-o", out];
    let told = stdout(&emit);
    let files = ["roll.c", "roll.h", "roll_selftest.c", "roll_selftest.h"];
    assert_eq!(names(&folder), files);
    assert!(files.iter().all(|file| told.contains(file)), "{told}");
    let again = [&emit[..], &["--check"]].concat();
    assert_eq!(stdout(&again).matches("up to date").count(), 4);
    // The controller is the same with and without.
    let alone = stdout(&["emit", "--lang=c", "--n=2", "--mu=exp", "--name=roll", "-o", "-"]);
    let source = fs::read_to_string(folder.join("roll.c")).expect("there");
    assert!(alone.ends_with(&source));
}

#[test]
fn what_has_no_self_test_is_told_before_anything_is_written() {
    let folder = folder("no_selftest");
    let out = folder.to_str().expect("UTF-8");
    let design = ["--n=1", "--mu=exp", "--selftest", "-o", out];
    let told = stderr(&[&["emit", "--lang=rust"][..], &design].concat(), 2);
    assert!(told.contains("goes with C") && told.contains("--lang c"), "{told}");
    let told = stderr(&[&["emit", "--lang=c", "--what=associated"][..], &design].concat(), 2);
    assert!(told.contains("the associated system has no self-test"), "{told}");
    assert!(names(&folder).is_empty());
}

#[test]
fn a_system_whose_mapping_has_no_mu_in_closed_form_is_told() {
    let system = ["emit", "--lang=c", "--n=2", "--what=associated", "-o", "-"];
    let told = stderr(&[&system[..], &["--kappa=tau*dt/(tau - dt) + ln(1 + dt)"]].concat(), 2);
    assert!(
        told.contains("no closed form of mu") && told.contains("give the mapping as mu"),
        "{told}"
    );
    assert!(stdout(&[&system[..], &["--kappa=-ln(1 - dt/tau)"]].concat()).contains("mu'"));
}

#[test]
fn the_engine_by_its_name_is_the_default() {
    let show = ["show", "law", "--n", "4", "--mu", "tan"];
    assert_eq!(stdout(&[&show[..], &["--engine", "ptc"]].concat()), stdout(&show));
    let emit = ["emit", "--lang", "c", "--n", "3", "--kappa", "dt/(tau - dt)", "-o", "-"];
    assert_eq!(stdout(&[&emit[..], &["--engine=ptc"]].concat()), stdout(&emit));
}

#[cfg(not(feature = "symbolica"))]
#[test]
fn an_engine_that_is_not_built_in_tells_how_to_build_it() {
    for start in [
        &["show", "tables", "--n=3"][..],
        &["show", "r", "--n=3", "--mu=exp"],
        &["check", "--n=2", "--mu=exp"],
        &["emit", "--lang=c", "--n=2", "--mu=exp", "-o", "-"],
    ] {
        let told = stderr(&[start, &["--engine", "symbolica"]].concat(), 2);
        assert!(told.contains("built without the engine `symbolica`"), "{told}");
        assert!(told.contains("--features symbolica"), "{told}");
        assert!(told.contains("docs/engines.md"), "{told}");
    }
}
