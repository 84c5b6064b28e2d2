//! Output of the commands for a reference: checks, heads of files, runs.

use serde_json::Value;

use super::support::{folder, run_in};
use super::{example, spec};

/// The outcomes of the checks of a design with this reference.
fn checks(reference: &str) -> Value {
    let folder = folder("references_checks");
    let design = ["check", "--n", "2", "--mu", "exp(a=1)", "--poles=-4,-5", "--tau", "1"];
    let promises = ["--eps", "0.02", "--sample-time", "1e-3", "--error", "0.1", "--x0-max", "1,1"];
    let further = ["--x-max", "2,2", "--format", "json", "--reference", reference];
    let (_, json, stderr) = run_in(&folder, &[&design[..], &promises, &further].concat());
    serde_json::from_str(&json).expect(&stderr)
}

fn outcome<'a>(found: &'a Value, name: &str) -> &'a Value {
    let all = found["checks"].as_array().expect("checks");
    all.iter().find(|check| check["name"] == name).expect("an outcome")
}

#[test]
fn verdicts_speak_of_the_tracking_error() {
    for reference in ["sin(t)", "input"] {
        let found = checks(reference);
        let verdict = |name| outcome(&found, name)["verdict"].as_str().expect("text");
        let summary = |name| outcome(&found, name)["summary"].as_str().expect("text");
        assert_eq!(verdict("membership"), "sound");
        for name in ["growth", "deadline"] {
            assert_eq!(verdict(name), "sound");
            let details = outcome(&found, name)["details"].to_string();
            assert!(details.contains("x is the tracking error, x_i - r^(i-1)"), "{details}");
        }
        assert!(outcome(&found, "deadline")["details"].to_string().contains("x0_max bounds it"));
        assert_eq!(verdict("sampling"), "undecided");
        assert!(summary("sampling").contains("r is known at the samples alone"));
        assert_eq!(verdict("loop"), "not checked");
        assert!(summary("loop").contains("follows a reference"));
        assert_eq!(verdict("envelope"), "not checked");
    }
    // A constant does not move between the samples.
    assert_eq!(outcome(&checks("0.5"), "sampling")["verdict"], "sound");
    assert_eq!(outcome(&checks("target"), "sampling")["verdict"], "sound");
}

#[test]
fn the_command_gives_the_design_back() {
    let given = example("track.toml").replace("0.1*sin(2*t + phase)", "input");
    for text in [example("track.toml"), given.replace("phase = 0.3 ", "# ")] {
        let own = spec(
            &text
                .replace("error = [1e-3, 1e-2] ", "# ")
                .replace("tau = 1 ", "tau = 1\neps = 0.04 "),
        );
        let command = own.command();
        assert!(command.contains("--reference"), "{command}");
        let files = ptc_codegen::generate(&own, ptc_codegen::emit::Language::C).expect("a design");
        let head = files.iter().map(|file| file.text.as_str()).collect::<String>();
        assert!(head.contains("e_i = x_i - r^(i-1)") && head.contains(&command), "{head}");
    }
}

/// A batch of states and a batch of references each have a length of their own.
#[test]
fn python_takes_both_arrays() {
    let text = "name = \"batch\"\nn = 2\nmu = \"exp\"\nreference = \"input\"\n";
    let files = ptc_codegen::generate(&spec(text), ptc_codegen::emit::Language::Python);
    let module = &files.expect("a design")[0].text;
    for part in [
        "if states.ndim == 0 or states.shape[-1] != 2:",
        "if states.ndim == 0 or states.shape[-1] != 3:",
        "x1, x2 = _states(x, \"x\")",
        "r0, r1, r2 = _reference(r, \"r\")",
        "e1 = x1 - r0",
    ] {
        assert!(module.contains(part), "{part}: {module}");
    }
}

/// Both runs show the plant's own state, and say how far it is from the reference in the end.
#[test]
fn a_run_shows_the_plant_and_tells_the_error() {
    let folder = folder("references_run");
    let design = ["simulate", "--n", "2", "--mu", "exp(a=1)", "--poles=-4,-5", "--tau", "1"];
    let start = ["--x0", "1,0", "--reference", "0.1*sin(2*t)"];
    let last = |further: &[&str]| {
        let (code, csv, stderr) = run_in(&folder, &[&design[..], &start, further].concat());
        assert_eq!(code, Some(0), "{stderr}");
        let row = csv.lines().last().expect("a row");
        let row: Vec<f64> = row.split(',').map_while(|cell| cell.parse().ok()).collect();
        (row, stderr)
    };
    // In infinite time: e1 = a T^4 + b T^5 from e1 = 1 and e2 = -0.2.
    let (row, told) = last(&["--at", "0,0.5"]);
    let (b, t) = (0.2 - 4.0, 0.5f64);
    let e1 = (1.0 - b) * t.powi(4) + b * t.powi(5);
    assert!((row[2] - (0.1 * 1.0f64.sin() + e1)).abs() < 1e-11, "{row:?}");
    assert!(told.contains("tracking error at t = 0.5 s: e1 = "), "{told}");
    // The emitted program, sampled: on the reference, up to what the hold between samples leaves.
    let (row, told) = last(&["--eps", "1e-2", "--sample-time", "1e-3", "--until", "2"]);
    assert!((row[2] - 0.1 * 4.0f64.sin()).abs() < 1e-7, "{row:?}");
    assert!((row[3] - 0.2 * 4.0f64.cos()).abs() < 1e-6, "{row:?}");
    assert!(told.contains("tracking error at t = 2 s: e1 = -"), "{told}");
}
