//! Wishes that are refused, each with one clear message and no file.

use std::fs;

use super::{DRIVEN, folder};
use crate::support::run_in as run;

#[test]
fn bad_input_gets_one_clear_message_and_no_file() {
    let with = |from: &str, to: &str| DRIVEN.replacen(from, to, 1);
    for (wish, arguments, parts) in [
        (with("n = 1\n", ""), &[][..], &["`n` is missing"][..]),
        (with("n = 1\n", "n = 40\n"), &[], &["n = `40`", "n = 40", "1..=16"]),
        (with("n = 1\n", "n = 1\nmu = \"expo\"\n"), &[], &["wish.toml:2:7", "did you mean `exp`"]),
        (with("n = 1\n", "n = 1\nmu = \"exp\"\n"), &[], &["a without a value"]),
        (with("n = 1\n", "n = 1\npoles = [-1, -2]\n"), &[], &["2 poles for order n = 1"]),
        (with("n = 1\n", "n = 1\npi0 = \"extern\"\n"), &[], &["function of your program"]),
        (
            with("[plant]\nf = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"constant\"\n", ""),
            &[],
            &["no plant", "[plant]"],
        ),
        (with("tau = 1\n", ""), &[], &["tau has no value"]),
        (with("bound = \"attractive\"\nerror = 0.02\n", ""), &[], &["[[objective]]"]),
        (with("x1 = 0\n", ""), &[], &["no interval of x1"]),
        (with("x1 = 0", "x1 = ["), &[], &["wish.toml:"]),
        (
            with("bound = \"attractive\"\nerror = 0.02", "bound = \"within\"\nh = \"x1\"\nlow = 1"),
            &[],
            &["objective 1", "fails at t0 already"],
        ),
        (DRIVEN.to_owned(), &["--tries=0"], &["--tries", "0"]),
        (DRIVEN.to_owned(), &["--out=."], &["--out . is a folder", "`-` for the standard output"]),
    ] {
        let folder = folder("wrong", &wish);
        let (code, told, wrong) = run(&folder, &[&["design", "wish.toml"][..], arguments].concat());
        assert_eq!((code, told.as_str()), (Some(2), ""), "{wish}{arguments:?}: {wrong}");
        for part in parts {
            assert!(wrong.contains(part), "{wish}{arguments:?}: no {part:?} in\n{wrong}");
        }
        assert!(!wrong.contains("panicked"), "{wrong}");
        assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1, "{wish}");
    }
    let empty = folder("absent", "");
    let (code, _, wrong) = run(&empty, &["design", "none.toml"]);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("there is no design file none.toml"), "{wrong}");
    fs::write(empty.join("near.toml"), "").expect("writable");
    let (_, _, wrong) = run(&empty, &["design", "near"]);
    assert!(wrong.contains("did you mean `near.toml`?"), "{wrong}");
}

/// An interval of a value that `design` chooses is refused.
#[test]
fn intervals_of_what_is_chosen_are_refused() {
    for (key, help, given) in [
        ("k1 = [4, 5]", "`design` chooses the gains", "mu = \"exp(a=1)\"\n"),
        ("a = [1, 2]", "or give a `mu` without a in the design", "poles = [-3]\n"),
    ] {
        let wish = format!(
            "name = \"slide\"\nn = 1\n{given}[params]\ntau = 1\n[plant]\nf = 0\n[verify]\nx1 = 1\n{key}\n\
             [[objective]]\nbound = \"attractive\"\nerror = 1\n"
        );
        let folder = folder("intervals", &wish);
        let (code, told, wrong) = run(&folder, &["design", "wish.toml", "-o", "roll.toml"]);
        assert_eq!(code, Some(2), "{told}");
        assert!(wrong.contains("is to be chosen") && wrong.contains(help), "{wrong}");
        assert!(wrong.contains(&format!("| {key}")), "the line: {wrong}");
    }
}
