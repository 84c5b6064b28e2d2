//! Requests of an observer alone: what it is called, what its head says, and what is refused.

use std::fs;
use std::process::Command;

use ptc_codegen::emit::{Language, Project};
use ptc_codegen::request::Spec;

use super::support::{folder_with, run_in};
use super::{legal, read};

/// An observer of a stage.
const STAGE: [(&str, &str); 6] = [
    ("what", "\"observer\""),
    ("n", "2"),
    ("sample_time", "1e-3"),
    ("measured", "\"x1\""),
    ("observer_poles", "[-4, -5]"),
    ("observer_samples", "50"),
];

/// The design of the README.
const ENCODER: &str = include_str!("../../../../examples/encoder.toml");

/// Keys in place of those of the stage, and parts of the message.
type Mistake = (&'static [(&'static str, &'static str)], &'static [&'static str]);

fn with(changes: &[(&str, &str)]) -> String {
    let kept = STAGE.iter().filter(|(key, _)| changes.iter().all(|(own, _)| own != key));
    let given = kept.chain(changes).filter(|(_, value)| !value.is_empty());
    given.map(|(key, value)| format!("{key} = {value}\n")).collect()
}

#[test]
fn mistakes_are_named() {
    let cases: [Mistake; 20] = [
        (&[("observer_poles", "")], &["`observer_poles` is missing", "give 2 poles"]),
        (&[("observer_poles", "[-4]")], &["1 pole for 2 values that are estimated"]),
        (&[("observer_samples", "")], &["`observer_samples` is missing", "integer 2..=2147483648"]),
        (&[("observer_samples", "1")], &["observer_samples = `1`", "integer 2..=2147483648"]),
        (&[("observer_samples", "2.5")], &["observer_samples = `2.5`"]),
        (
            &[("observer_samples", ""), ("tau", "0.4"), ("poles", "[-4, -5]")],
            &["that of the controller takes 200"],
        ),
        (&[("measured", "")], &["every state is measured", "disturbance = constant"]),
        (&[("measured", "[\"x1\", \"x2\"]")], &["measured: every state is measured"]),
        (&[("measured", "\"x2\"")], &["name the measured states from x1 on"]),
        (&[("tau", "0.4")], &["`tau` is of a law", "leave it out", "`observer_samples`"]),
        (&[("eps", "0.01")], &["`eps` is of a law", "`observer_eps` holds the gains"]),
        (&[("u_max", "3")], &["`u_max` is of a law", "as it was applied"]),
        (&[("after", "\"zero\"")], &["`after` is of a law", "`after_observer`"]),
        (&[("deadbeat", "9")], &["`deadbeat` is of a law"]),
        (&[("error", "0.1"), ("x0_max", "[1, 1]")], &["`error` is of a law"]),
        (&[("poles", "[-4]")], &["1 pole for order n = 2"]),
        (&[("delay", "17")], &["delay is a number from 0 to 16"]),
        (&[("pi0", "\"-xi1^3\"")], &["needs a linear law"]),
        (
            &[("what", "\"observe\"")],
            &["did you mean `observer`? legal: controller, associated, observer"],
        ),
        (&[("what", "\"associated\"")], &["the infinite-time system has no samples"]),
    ];
    for (changes, wanted) in cases {
        let found = read(&with(changes)).expect_err(wanted[0]);
        for part in wanted {
            assert!(found.contains(part), "{changes:?} lacks {part}: {found}");
        }
    }
    // One mistake each, beside the key of a clock in samples.
    let text = "what = \"observer\"\nn = 2\nmu = \"exp\"\n";
    let found = ptc_codegen::request::read(&super::support::entries(text)).expect_err("no clock");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].key == "what" && found[0].message.contains("needs a clock in samples"));
    assert!(found[0].help.contains("observer_samples"), "{found:?}");
    let found = read(
        "what = \"observer\"\nsample_time = 0.01\nobserver_poles = [-4, -5]\nobserver_samples = 9\n[plant]\nA = [[0, 1], [0, -1]]\nB = [0, 1]\nC = [0, 1]\n",
    );
    assert!(found.expect_err("no sensor of x1").contains("not observable"));
}

/// Only a law has to reach every mode.
#[test]
fn a_mode_that_no_input_reaches_is_observed() {
    let plant = "sample_time = 0.01\nobserver_poles = [-4, -5, -6]\nobserver_samples = 9\n[plant]\n\
                 A = [[0, 1, 1], [0, 0, 0], [0, 0, -3]]\nB = [0, 1, 0]\nC = [1, 0, 0]\n";
    let found = read(plant).expect_err("a controller");
    assert!(found.contains("not controllable"), "{found}");
    legal(&format!("what = \"observer\"\n{plant}"));
}

#[test]
fn the_design_of_a_controller_is_that_of_its_observer() {
    let folder = folder_with("observer_encoder", "encoder.toml", ENCODER);
    let emit = ["emit", "encoder.toml", "--what", "observer", "--lang", "c", "-o", "out"];
    let (code, out, told) = run_in(&folder, &emit);
    assert_eq!((code, told.as_str()), (Some(0), ""));
    assert_eq!(out, "wrote out/stage_observer.h\nwrote out/stage_observer.c\n");
    let header = fs::read_to_string(folder.join("out/stage_observer.h")).expect("a header");
    let words = header.split_whitespace().filter(|word| *word != "*").collect::<Vec<_>>().join(" ");
    for part in [
        "Prescribed-time observer stage_observer: order n = 2, clock in samples.",
        "Plant: x1' = x2, x2' = g (u + d), d constant and unknown",
        "it acts from tick k to tick k + 1",
        "From sample 200 on the status is HOLD",
        "Observer: set by init",
        "ptc_status stage_observer_arm(stage_observer *self, uint32_t k);",
        "ptc_status stage_observer_update(stage_observer *self, uint32_t k, const double y[1], double u);",
        "ptc_status stage_observer_estimate(const stage_observer *self, double xhat[2]);",
        "ptc_status stage_observer_disturbance(const stage_observer *self, double *d);",
    ] {
        assert!(words.contains(part), "{part} is missing:\n{header}");
    }
    for part in ["ontroller", "--poles", "--tau", "--u-max", "--eps"] {
        assert!(!words.contains(part), "{part} is there:\n{header}");
    }
    // The command in the head gives the same files.
    let command = header.lines().find_map(|line| line.strip_prefix(" *   ptc-codegen "));
    let command =
        format!("'{}' {} -o again", env!("CARGO_BIN_EXE_ptc-codegen"), command.expect("a command"));
    let again = Command::new("sh").args(["-c", &command]).current_dir(&folder).status();
    assert!(again.is_ok_and(|status| status.success()), "{command}");
    for file in ["stage_observer.h", "stage_observer.c"] {
        let [one, other] =
            ["out", "again"].map(|out| fs::read(folder.join(out).join(file)).expect(file));
        assert_eq!(one, other, "{file}");
    }
}

#[test]
fn what_needs_a_law_is_refused() {
    let spec: Spec = legal(&with(&[]));
    for language in [Language::Fmu2, Language::Fmu3] {
        let found = ptc_codegen::generate(&spec, language).expect_err("an FMU");
        assert!(found[0].message.contains("an FMU holds a controller, not an observer alone"));
        assert_eq!((found.len(), found[0].key.as_str()), (1, "what"));
    }
    let found = ptc_codegen::project(&spec, Project::Cmake).expect_err("a project");
    assert!(found[0].message.contains("a project holds a controller, not an observer alone"));
    let folder =
        folder_with("observer_refused", "encoder.toml", format!("what = \"observer\"\n{ENCODER}"));
    for (arguments, wanted) in [
        (
            &["simulate", "encoder.toml", "--x0", "1,0"][..],
            "simulate needs a law, and an observer alone has none",
        ),
        (&["show", "law", "encoder.toml"], "show law needs a law, and an observer alone has none"),
        (&["verify", "encoder.toml"], "a campaign needs a law, and an observer alone has none"),
    ] {
        let (code, out, told) = run_in(&folder, arguments);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{arguments:?}: {told}");
        assert!(told.contains(wanted), "{arguments:?}: {told}");
    }
    let (code, out, told) = run_in(&folder, &["check", "encoder.toml"]);
    assert_eq!((code, told.as_str()), (Some(0), ""));
    assert!(out.contains("growth      not checked: an observer alone has no law"), "{out}");
}
