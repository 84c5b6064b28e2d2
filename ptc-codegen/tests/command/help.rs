//! The help of the commands with the flags of a design.

use crate::support;

use ptc_codegen::keys::{GROUPS, KEYS};
use support::words::stdout;

/// Commands that have the flags of all keys in this build.
fn commands() -> Vec<&'static str> {
    let mut all = vec!["emit", "check"];
    if cfg!(feature = "lab") {
        all.extend(["simulate", "verify", "compare"]);
    }
    all
}

fn flag(key: &str) -> String {
    format!("--{} ", key.replace('_', "-"))
}

/// Returns the help with each flag followed by a space, whatever its value.
fn flags(arguments: &[&str]) -> String {
    stdout(arguments).replace(['[', '\n'], " ")
}

#[test]
fn rare_flags_are_in_the_help_of_all_flags() {
    for name in commands() {
        let (short, long) = (flags(&[name, "--help"]), flags(&[name, "--help-all"]));
        assert_eq!(stdout(&[name, "-h"]), stdout(&[name, "--help"]));
        for group in &GROUPS {
            let heading = format!(" {}: ", group.title);
            assert!(short.contains(&heading) && long.contains(&heading), "{name}: {heading}");
            for key in group.keys() {
                let flag = flag(key.key);
                assert!(long.contains(&flag), "{name}: {flag}");
                assert_eq!(short.contains(&flag), !group.is_rare(key), "{name}: {flag}");
            }
        }
        assert!(stdout(&[name, "--help"]).lines().count() < 140, "{name}");
        assert!(stdout(&[name, "--help-all"]).contains("Exit codes:"), "{name}");
    }
}

#[test]
fn rare_flags_stay_flags_everywhere() {
    let page = stdout(&["man", "emit"]).replace("\\-", "-");
    let script = stdout(&["completions", "bash"]);
    for key in &KEYS {
        let flag = flag(key.key);
        assert!(page.contains(flag.trim()) && script.contains(flag.trim()), "{flag}");
    }
    for flag in ["--dump", "--engine", "--cost", "--resolved", "--acsl"] {
        assert!(page.contains(flag), "{flag}");
    }
    let checked = ["check", "--n=2", "--mu=exp(a=1)", "--poles=-4,-5", "--t0=1", "--guard=none"];
    assert!(stdout(&checked).contains("accepted"));
}
