//! The design file on the command line: what `new` writes, what `emit` and `show` read.

use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

fn stdout(folder: &Path, arguments: &[&str]) -> String {
    support::stdout(&mut support::command_in(folder, arguments))
}

fn stderr(folder: &Path, arguments: &[&str]) -> String {
    support::stderr(&mut support::command_in(folder, arguments), 2)
}

/// A folder of a test's own that holds `design.toml`.
fn folder(test: &str, design: &[u8]) -> PathBuf {
    support::folder_with(&format!("design_{test}"), "design.toml", design)
}

const ROLL: &str = "name = \"roll\"\nn = 2\nmu = \"power(m=2)\"\ngains = [20, 9]\n\
                    precision = 'f32'\n[params]\ntau = 1.0\neps = 0.1\n";

#[test]
fn a_design_is_its_flags() {
    let folder = folder("flags", ROLL.as_bytes());
    let flags = ["--name=roll", "--n=2", "--mu=power(m=2)", "--gains=20,9", "--precision=f32"];
    let flags = [&["emit", "--lang=c", "-o-", "--tau=1.0", "--eps=0.1"], &flags[..]].concat();
    let by_flags = stdout(&folder, &flags);
    assert_eq!(stdout(&folder, &["emit", "design.toml", "--lang", "c", "-o", "-"]), by_flags);
    assert!(by_flags.contains("--n 2 --mu \"power(m=2)\" --name roll --precision f32"));
    let law = stdout(&folder, &["show", "law", "design.toml"]);
    assert!(law.contains("with m = 2") && law.contains("with k2 = 9"), "{law}");
}

#[test]
fn flags_stand_for_keys_of_the_file() {
    let folder = folder("over", format!("{ROLL}[envelope\nguard = true\n").as_bytes());
    let told = stderr(&folder, &["emit", "design.toml", "--lang=c", "-o-", "--guard=full"]);
    assert!(told.contains("unclosed table") && told.contains("design.toml:9:10"), "{told}");

    fs::write(folder.join("design.toml"), format!("guard = true\n{ROLL}")).expect("a design");
    let over = ["--guard=none", "--mu", "exp", "--param", "tau=3", "--eps", "0.2", "--param=t0=-1"];
    let text =
        stdout(&folder, &[&["emit", "design.toml", "--lang=rust", "-o-"], &over[..]].concat());
    let line = "--n 2 --mu exp --name roll --precision f32 --guard none --tau=3 --t0=-1 --eps=0.2 --gains=20,9";
    let words = text.lines().take(8).collect::<String>().replace("//!", " ");
    assert_eq!(words.split_whitespace().collect::<Vec<_>>().join(" ").matches(line).count(), 1);
}

#[test]
fn an_error_in_the_file_quotes_its_line() {
    let folder = folder("quote", b"n = 2\r\nmu = \"exp(a=1, b=-2)\"\r\n");
    let told = stderr(&folder, &["emit", "design.toml", "--lang=c"]);
    let expected = r#"error[unknown-parameter]: `exp` has no parameter `b`
 --> design.toml:2:16
  |
2 | mu = "exp(a=1, b=-2)"
  |                ^ no such parameter
  |
  = help: its parameters are a

"#;
    assert_eq!(told, expected);
}

#[test]
fn all_mistakes_of_file_and_flags_are_told_at_once() {
    let folder = folder("all", b"n = 0x2\nmu = tan\nguard = true\ntau = -1\n[param]\npsi = 1\n");
    let flags = ["--gains", "1,b c", "--param", "zeta", "--param", "theta=3", "--eps=-1"];
    let told = stderr(&folder, &[&["emit", "design.toml", "--lang=c"], &flags[..]].concat());
    for part in [
        "design.toml:1:5",
        "in decimal: 2",
        "`tan` is not in quotes",
        "guard = `true` is a boolean",
        "tau = `-1`",
        "`[param]` is not a table",
        "did you mean `params`?",
        "--gains \"1,b c\"",
        "--param \"zeta\"",
        "NAME=VALUE",
        "--eps \"-1\"",
    ] {
        assert!(told.contains(part), "no {part:?} in:\n{told}");
    }
    assert_eq!(told.matches("error").count(), 8, "{told}");
    assert!(!told.contains("missing") && !told.contains("psi"), "{told}");
    // What could not be read may have used it.
    assert!(!told.contains("theta"), "{told}");
}

#[test]
fn what_is_no_design_is_told() {
    let odd: [(&[u8], &str); 6] = [
        (b"n = 2\n\xff\n", "no UTF-8 in line 2"),
        (b"", "`mu` is missing"),
        (b"\xef\xbb\xbfn = 2\r\n", "`mu` is missing"),
        (&[b'['; 1 << 16], "[toml]"),
        (&[b'\0'; 1000], "[toml]"),
        (&[b'x'; 10 << 20], "more than 1048576 bytes"),
    ];
    for (bytes, part) in odd {
        let folder = folder("odd", bytes);
        let told = stderr(&folder, &["emit", "design.toml", "--lang=c"]);
        assert!(told.contains(part), "no {part:?} in:\n{told}");
    }
    let folder = folder("none", b"");
    assert!(stderr(&folder, &["emit", "no.toml", "--lang=c"]).contains("no design file no.toml"));
    assert!(stderr(&folder, &["emit", ".", "--lang=c"]).contains("cannot read"));
    let told = stderr(&folder, &["show", "law", "no.toml"]);
    assert!(told.contains("ptc-codegen new"), "{told}");
}
