//! `new`: the files that it writes, and what it refuses.

use crate::support;

use std::fs;
use std::path::Path;

use ptc_codegen::design::STARTS;

fn stdout(folder: &Path, arguments: &[&str]) -> String {
    support::stdout(&mut support::command_in(folder, arguments))
}

fn stderr(folder: &Path, arguments: &[&str]) -> String {
    support::stderr(&mut support::command_in(folder, arguments), 2)
}

#[test]
fn new_writes_a_design_that_can_be_emitted() {
    let folder = support::folder("emitted");
    for (arguments, file, emitted) in [
        (&["new", "--all"][..], "design.toml", "ptc_exp3.rs"),
        (&["new", "roll", "--all"], "roll.toml", "roll.rs"),
        (&["new", "sub/yaw.toml", "--plant", "model"], "sub/yaw.toml", "yaw.rs"),
        (&["new", "--plant", "model"], "model.toml", "model.rs"),
        (&["new", "if", "-o", "made", "--plant", "model"], "made/if.toml", "model.rs"),
    ] {
        assert_eq!(stdout(&folder, arguments).matches("wrote").count(), 1);
        stdout(&folder, &["emit", file, "--lang=rust", "-oout"]);
        assert!(folder.join("out").join(emitted).exists(), "{arguments:?}");
        fs::remove_dir_all(folder.join("out")).expect("what was emitted");
    }
    let told = stdout(&folder, &["new", "while", "--plant", "motor", "-o", "made"]);
    assert!(told.contains("`while` is not a legal name: the controller is motor"), "{told}");
    let printed = stdout(&folder, &["new", "--all", "-"]);
    assert_eq!(stdout(&folder, &["new", "--all", "--out", "-"]), printed);
    assert_eq!(fs::read_to_string(folder.join("design.toml")).expect("a file"), printed);
    let left: Vec<_> = fs::read_dir(&folder).expect("a folder").collect();
    assert_eq!(left.len(), 5, "{left:?}");
}

#[test]
fn new_keeps_an_existing_file() {
    let folder = support::folder_with("kept", "roll.toml", "mine");
    for flags in [&[][..], &["--all"], &["--plant", "motor"], &["--from", "power_scaling"]] {
        let told = stderr(&folder, &[&["new", "roll"], flags].concat());
        assert!(told.contains("roll.toml is there already"), "{told}");
    }
    assert_eq!(fs::read(folder.join("roll.toml")).expect("a file"), b"mine");
    assert!(stderr(&folder, &["new", ".."]).contains("names no file"));
}

#[test]
fn new_without_a_plant_writes_a_stage_and_names_the_others() {
    let folder = support::folder("default");
    let told = stdout(&folder, &["new", "belt"]);
    assert!(told.contains("next: ptc-codegen check ./belt.toml"), "{told}");
    assert!(told.contains("--plant motor, flexible, model") && told.contains("--all"), "{told}");
    let text = fs::read_to_string(folder.join("belt.toml")).expect("a file");
    assert_eq!(text, stdout(&folder, &["new", "belt", "--plant", "stage", "--out", "-"]));
    assert!(!stdout(&folder, &["new", "axis", "--plant", "stage"]).contains("motor"));
}

/// Every line is short enough for a terminal, and what a value is counted in stands beside it.
#[test]
fn design_files_are_short_and_name_units() {
    for start in &STARTS {
        let text = start.design("axis", &[("name", "axis")]);
        assert!(text.lines().count() < 36, "{text}");
        assert!(text.contains("\nname = \"axis\" "), "{text}");
        assert!(text.lines().nth(1).is_some_and(|line| line.contains("axis.toml --x0")), "{text}");
        for line in text.lines().filter(|line| !line.starts_with("# ") && line.contains(" = ")) {
            assert!(line.len() <= 120, "{line}");
            assert!(line.contains("  # ") || line.starts_with("dynamics"), "{line}");
        }
    }
}

#[test]
fn values_of_flags_are_in_the_file() {
    let folder = support::folder("values");
    let flags = ["--measured", "x1,x2", "--limit", "100", "--tau", "1"];
    let text = stdout(&folder, &[&["new", "-"], &flags[..]].concat());
    for line in
        ["measured = [\"x1\", \"x2\"] ", "u_max = 100 ", "tau = 1 ", "observer_poles = [-4, -5] "]
    {
        assert!(text.contains(&format!("\n{line}")), "{line}: {text}");
    }
    // Half of the samples is the default of the observer.
    let settles = |tau| {
        let text = stdout(&folder, &["new", "-", "--plant", "motor", "--tau", tau]);
        text.contains("\nobserver_samples = 150 ")
    };
    assert!(settles("0.3") && !settles("0.2"));
    assert_eq!(stdout(&folder, &["new", "-", "--u-max=1/2"]).matches("\"1/2\"").count(), 1);
}

#[test]
fn wrong_values_are_refused_at_their_flags() {
    let folder = support::folder("wrong");
    for (flags, parts) in [
        (&["--limit=-5"][..], &["--limit \"-5\"", "is > 0"][..]),
        (&["--limit", "100N"], &["--limit \"100N\"", "without a unit: 100"]),
        (&["--measured", "y"], &["--measured \"y\"", "expected x1, x2"]),
        (&["--measured", "x2"], &["--measured \"x2\"", "from x1 on without a gap"]),
        (&["--measured", "x1,x2,x3"], &["unknown state `x3`", "expected x1, x2"]),
        (&["--tau", "0.8005"], &["--tau \"0.8005\"", "0.8 and 0.801"]),
        (
            &["--plant", "model", "--measured", "angle"],
            &["--measured \"angle\"", "leave `measured` out"],
        ),
        (&["--plant", "boat"], &["stage, motor, flexible, model"]),
        (&["--all", "--limit", "5"], &["'--all' cannot be used with '--limit"]),
        (&["--all", "--plant", "motor"], &["cannot be used with"]),
    ] {
        let told = stderr(&folder, &[&["new", "belt"], flags].concat());
        for part in parts {
            assert!(told.contains(part), "no {part:?} in:\n{told}");
        }
        assert!(told.matches("error").count() == 1, "{told}");
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
}
