//! `compare`: figures of the rivals by an independent simulation, the order of its output, and designs that it refuses.

use serde_json::Value;

use crate::support::{folder_with, run_in};

/// The README's stage.
const STAGE: &str = include_str!("../../../examples/encoder.toml");

/// The same with an unknown mass and force, a box of starts and an objective.
fn uncertain() -> String {
    format!(
        "{STAGE}\n[plant]\nf = \"push/mass\"\ng = \"1/mass\"\nmass = [1.2, 1.8]\npush = [-0.3, 0.3]\n\
         [verify]\nx1 = [-0.1, 0.1]\nx2 = 0\nscenarios = 12\nsearch = 0\n\
         [[objective]]\nbound = \"attractive\"\nerror = 1e-3\n"
    )
}

fn told(test: &str, design: &str, flags: &[&str]) -> (Option<i32>, String, String) {
    let folder = folder_with(&format!("compare_{test}"), "stage.toml", design);
    run_in(&folder, &[&["compare", "stage.toml"], flags].concat())
}

fn printed(test: &str, design: &str, flags: &[&str]) -> String {
    let (code, printed, errors) = told(test, design, flags);
    assert_eq!(code, Some(0), "{errors}");
    printed
}

fn json(test: &str, design: &str, flags: &[&str]) -> Value {
    let printed = printed(test, design, &[flags, &["--format", "json"]].concat());
    serde_json::from_str(&printed).expect("JSON")
}

fn row<'a>(found: &'a Value, name: &str) -> &'a Value {
    let all = found["controllers"].as_array().expect("controllers");
    all.iter().find(|row| row["name"] == name).unwrap_or_else(|| panic!("no {name}: {found}"))
}

/// The figures of `tools/compare.py`, which has its own profiles and gains: to 1 %, and errors to an eighth of a step of
/// the encoder. A reading half-way between two steps may be rounded to either of them.
#[test]
fn rivals_agree_with_an_independent_simulation() {
    let found = json("rivals", STAGE, &["--x0", "0.1,0", "--bandwidth", "80"]);
    let pushed = format!("{STAGE}\n[plant]\nf = \"0.3/1.5\"\n");
    let pushed = json("pushed", &pushed, &["--x0", "0.1,0", "--bandwidth", "80"]);
    for (found, expected) in [(&found, &EXPECTED[..4]), (&pushed, &EXPECTED[4..])] {
        for (name, figures) in expected {
            let row = row(found, name);
            let [error, peak, energy, ripple, settling] = figures;
            let near = |key: &str, wanted: f64, tolerance: f64| {
                let own = row[key].as_f64().expect("a number");
                assert!((own - wanted).abs() <= tolerance, "{name} {key}: {own} against {wanted}");
            };
            near("peak", *peak, 0.01 * peak);
            near("energy", *energy, 0.01 * energy);
            near("ripple", *ripple, 0.01 * ripple + 0.005);
            near("settling", *settling, 0.0011);
            let own = row["error"][0].as_f64().expect("a number");
            assert!((own - error).abs() <= 1.25e-7, "{name}: {own} against {error}");
        }
    }
}

/// `python3 tools/compare.py`: error of x1, peak, energy, ripple and settling time, without and with a force of 0.3 N.
const EXPECTED: [(&str, [f64; 5]); 8] = [
    ("polynomial + PID", [6.5608e-8, 1.5502, 0.76146, 5.4505e-3, 0.716]),
    ("polynomial + observer", [3.5281e-8, 1.4007, 0.75649, 9.6732e-2, 0.716]),
    ("jerk-limited + observer", [1.4170e-7, 1.3619, 0.68257, 0.12639, 0.729]),
    ("finite-horizon LQR", [9.7228e-10, 1.5348, 0.52946, 0.10951, 0.753]),
    ("polynomial + PID", [5.0104e-8, 1.8310, 0.83425, 0.45408, 0.716]),
    ("polynomial + observer", [2.8752e-8, 1.6889, 0.82966, 9.6732e-2, 0.716]),
    ("jerk-limited + observer", [1.2326e-7, 1.6573, 0.75594, 0.12639, 0.729]),
    ("finite-horizon LQR", [5.5102e-7, 1.6285, 0.60266, 0.11677, 0.754]),
];

/// The bandwidths that `tools/compare.py` finds by frequency responses: the margin limits them with an encoder of 1 um,
/// and the noise of u with one of 20 um.
#[test]
fn bandwidths_are_the_largest_with_margin_and_noise() {
    let coarse = STAGE.replace("sensor_step = [1e-6, 0]", "sensor_step = [20e-6, 0]");
    for (test, design, pid, observed) in
        [("margin", STAGE, 67.52, 86.86), ("noise", coarse.as_str(), 20.85, 51.66)]
    {
        let found = json(test, design, &["--x0", "0.1,0"]);
        for (name, bandwidth) in [("polynomial + PID", pid), ("finite-horizon LQR", observed)] {
            let own = row(&found, name)["bandwidth"].as_f64().expect("a number");
            assert!((own - bandwidth).abs() < 0.002 * bandwidth, "{test}, {name}: {own}");
        }
    }
}

/// The bang-bang time from rest at 0.1 m with 6 N and 1.5 kg is 2 sqrt(0.1/4) s, and u acts 1 ms late.
#[test]
fn soonest_deadline_is_that_of_the_bang_bang_input() {
    let found = json("soonest", STAGE, &["--x0", "0.1,0"]);
    let time = found["soonest"].as_f64().expect("a number");
    assert!((time - (2.0 * 0.025f64.sqrt() + 1e-3)).abs() < 1e-9, "{time}");
    let unlimited = STAGE.replace("u_max = 6", "u_max = inf");
    let printed = printed("unlimited", &unlimited, &["--x0", "0.1,0"]);
    assert!(
        printed.contains("soonest deadline of any controller: u has no limits: give `u_max`"),
        "{printed}"
    );
}

/// The jerk-limited time of a triple integrator from rest is (32 x/j)^(1/3), that of Ruckig without other limits.
#[test]
fn soonest_deadline_of_order_3_is_that_of_three_arcs() {
    let design = "n = 3\nname = \"jerk\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\n\
                  poles = [-4, -5, -6]\n[params]\ntau = 1\neps = 0.02\nu_max = 100\n";
    let found = json("order3", design, &["--x0", "0.5,0,0"]);
    let time = found["soonest"].as_f64().expect("a number");
    assert!((time - (32.0 * 0.5 / 100.0f64).cbrt()).abs() < 1e-9, "{time}");
    let omitted = found["omitted"].as_array().expect("omitted");
    assert_eq!(omitted.len(), 1, "{found}");
    assert_eq!(omitted[0]["name"], "polynomial + PID");
    assert!(row(&found, "jerk-limited + observer")["error"][0].as_f64().expect("a number") < 1e-4);
}

/// The design comes first, what it is behind in above the table, and nothing depends on the number of threads.
#[test]
fn output_begins_with_what_the_design_is_behind_in() {
    let design = uncertain();
    let first = printed("twice", &design, &[]);
    let behind = first.find("The design is behind in").expect("a heading");
    let table = first.find("\ncontroller ").expect("a table");
    assert!(behind < table && first[table..].contains("\nthe design "), "{first}");
    assert!(first.starts_with("stage: worst of 12 corners and 12 draws (seed 0)\n"), "{first}");
    let folder = folder_with("compare_threads", "stage.toml", &design);
    let mut alone = crate::support::command(&["compare", "stage.toml"]);
    alone.current_dir(&folder).env("RAYON_NUM_THREADS", "1");
    let (code, again, errors) = crate::support::told(&mut alone);
    assert_eq!((code, again), (Some(0), first), "{errors}");
}

/// Each row is at least as bad as the design's run of a single start of the same box.
#[test]
fn figures_are_the_worst_of_all_scenarios() {
    let all = json("box", &uncertain(), &[]);
    let one = json(
        "start",
        &uncertain(),
        &["--x0", "0.1,0", "--plant", "mass=1.8", "--plant", "push=0.3"],
    );
    for name in ["the design", "polynomial + PID", "finite-horizon LQR"] {
        for key in ["peak", "energy", "settling"] {
            let [worst, own] =
                [&all, &one].map(|found| row(found, name)[key].as_f64().expect("a number"));
            assert!(worst >= own && own > 0.0, "{name} {key}: {worst} {own}");
        }
    }
}

#[test]
fn pictures_have_a_line_for_each_controller() {
    let folder = folder_with("compare_plot", "stage.toml", STAGE);
    let words = ["compare", "stage.toml", "--x0", "0.1,0", "--plot", "run.svg"];
    let (code, _, errors) = run_in(&folder, &words);
    assert_eq!(code, Some(0), "{errors}");
    let svg = std::fs::read_to_string(folder.join("run.svg")).expect("a picture");
    for name in ["the design", "polynomial + PID", "jerk-limited + observer", "finite-horizon LQR"]
    {
        assert!(svg.contains(name), "{name}");
    }
}

/// Refusals name the supported plants; other mistakes say what to give.
#[test]
fn refusals_say_what_is_supported() {
    let example = |name: &str| {
        let path = format!("{}/../examples/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).expect("an example")
    };
    let supported = "a plant that is a chain of order 2 or 3";
    let reference = format!("reference = \"0.1*sin(2*t)\"\n{STAGE}");
    for (name, design, message) in [
        ("model", example("cart"), "the plant of the design is a model"),
        ("axes", example("gantry"), "the design has several axes or outputs"),
        ("time", example("table"), "the clock of the design is time"),
        ("reference", reference, "the design follows a reference"),
        (
            "order",
            STAGE
                .replace("n = 2 ", "n = 1 ")
                .replace("[1e-6, 0]", "1e-6")
                .replace("-4, -5, -6]", "-4, -5]"),
            "chain of order 1",
        ),
        ("fraction", STAGE.replace("delay = 1 ", "delay = 0.5 "), "not a whole number of samples"),
    ] {
        let (code, printed, errors) = told(name, &design, &["--x0", "0.1,0"]);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{name}: {errors}");
        assert!(errors.contains(message) && errors.contains(supported), "{name}: {errors}");
        assert_eq!(errors.matches("error").count(), 1, "{name}: {errors}");
    }
    for (flags, message) in [
        (&[][..], "the design has no state to start from"),
        (&["--x0", "0.1"], "--x0 0.1: 1 values"),
        (&["--x0", "0.1,a"], "--x0"),
        (&["--x0", "0.1,0", "--bandwidth", "-3"], "--bandwidth -3 is not a number > 0"),
        (&["--x0", "0.1,0", "--scenarios", "200000"], "the limit is 100000"),
        (&["--x0", "0.1,0", "--plot", "run.bmp"], "unsupported image type"),
    ] {
        let (code, printed, errors) = told("mistakes", STAGE, flags);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{flags:?}: {errors}");
        assert!(errors.contains(message), "{flags:?}: {errors}");
    }
}
