//! `ptc-codegen emit`: its files, what it prints, and what it leaves behind where it fails.

use crate::support;

use std::fs;
use std::path::Path;
use std::process::Stdio;

use support::words::{stderr, stdout};
use support::{command, folder};

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<_> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    names.sort();
    names
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

/// 1 where the design is refused, 2 where it is none, as for `check`.
#[test]
fn exit_codes_say_what_is_wrong() {
    let design = |rest: &[&str], code| {
        let common = ["--n", "3", "--mu", "exp(a=2)", "--poles=-4,-5,-6"];
        stderr(&[&["emit", "--lang", "c", "-o", "-"], &common[..], rest].concat(), code)
    };
    assert!(design(&[], 1).contains("error[growth]"));
    assert!(design(&["--tau=-1"], 2).contains("error[bad-value]"));
    // Both at once: the input is mended first.
    assert!(!design(&["--tau=-1", "--sample-time", "x"], 2).contains("growth"));
    let overflow = ["--n", "3", "--mu", "exp(a=1e-140)", "--poles=-4,-5,-6"];
    let emitted = [&["emit", "--lang", "c", "-o", "-"], &overflow[..]].concat();
    assert!(stderr(&emitted, 1).contains("error[overflow]"));
    for help in [&["--help"][..], &["emit", "--help"], &["check", "--help"], &["list", "--help"]] {
        assert!(stdout(help).contains("  3  undecided: "), "{help:?}");
    }
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
    assert!(told.contains("needs C") && told.contains("--lang c"), "{told}");
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
