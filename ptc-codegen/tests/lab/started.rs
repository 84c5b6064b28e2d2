//! The designs that `new` writes, through all commands.

use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_codegen::design::STARTS;

use crate::support;

/// Each plant with its start, and what counts as at rest at the deadline.
const RUNS: [(&str, &str, &[f64]); 4] = [
    ("stage", "0.1,0", &[1e-5, 1e-3]),
    ("motor", "3,0,0", &[1e-4, 1e-2, 1e-2]),
    ("flexible", "0.3,0", &[1e-3, 0.1]),
    ("model", "3,0", &[1e-3, 1e-2]),
];

fn run(folder: &Path, arguments: &[&str]) -> String {
    support::stdout(&mut support::command_in(folder, arguments))
}

fn compiles(folder: &Path) {
    let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -c *.c";
    let compile = Command::new("sh").args(["-c", strict]).current_dir(folder).output();
    let compile = compile.expect("a compiler");
    assert!(compile.status.success(), "{}", String::from_utf8_lossy(&compile.stderr));
}

/// The states at the deadline.
fn at_the_deadline(csv: &str, states: usize) -> Vec<f64> {
    let last = csv.lines().last().expect("a sample");
    let numbers = last.split(',').skip(2).take(states);
    numbers.map(|text| text.parse().expect("a number")).collect()
}

#[test]
fn designs_of_all_plants_are_accepted_and_end_at_rest() {
    assert_eq!(STARTS.len(), RUNS.len());
    let folder = support::folder("plants");
    for (plant, x0, bounds) in RUNS {
        run(&folder, &["new", "--plant", plant]);
        let file = format!("{plant}.toml");
        assert!(run(&folder, &["check", &file]).contains("\naccepted"), "{plant}");
        run(&folder, &["emit", &file, "--lang", "c", "-o", plant]);
        compiles(&folder.join(plant));
        let csv = run(&folder, &["simulate", &file, "--x0", x0]);
        for (x, bound) in at_the_deadline(&csv, bounds.len()).into_iter().zip(bounds) {
            assert!(x.abs() <= *bound, "{plant}: {x} at the deadline");
        }
        assert!(run(&folder, &["verify", &file]).contains("every objective holds"), "{plant}");
        let head = fs::read_to_string(folder.join(&file)).expect("a design");
        let line =
            format!("# ptc-codegen simulate {file} --x0 {x0} -o {plant}.csv --plot {plant}.svg\n");
        assert!(head.contains(&line), "{head}");
    }
}

#[test]
fn values_of_flags_are_accepted() {
    let folder = support::folder("values");
    for (name, flags) in [
        ("limit", &["--limit", "100"][..]),
        ("both", &["--measured", "x1,x2"]),
        ("slow", &["--tau", "1.5"]),
        ("torque", &["--plant", "model", "--limit", "12", "--tau", "1.5"]),
        ("elastic", &["--plant", "flexible", "--measured", "x1,x2", "--limit", "150"]),
        ("wheel", &["--plant", "motor", "--limit", "12", "--tau", "0.25"]),
    ] {
        run(&folder, &[&["new", name], flags].concat());
        assert!(run(&folder, &["check", &format!("{name}.toml")]).contains("\naccepted"), "{name}");
    }
}
