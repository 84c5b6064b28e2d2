use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::answer;

fn ask(request: &Value) -> Value {
    serde_json::from_str(&answer(&request.to_string())).expect("JSON")
}

fn example(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    fs::read_to_string(folder.join(name)).expect("an example")
}

fn examples() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = [root.join("examples"), root.join("ptc-codegen/catalogue")];
    let all = folders.iter().flat_map(|folder| fs::read_dir(folder).expect("a folder"));
    let paths = all.map(|entry| entry.expect("an entry").path());
    paths.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect()
}

#[test]
fn examples_are_emitted_and_run_or_refused_with_a_reason() {
    let mut without = Vec::new();
    for path in examples() {
        let text = fs::read_to_string(&path).expect("a design");
        let told = ask(&json!({ "design": text, "language": "c" }));
        let found = told["diagnostics"].as_array().expect("a list");
        let files = told["files"].as_array().map_or(0, Vec::len);
        assert_eq!(found.is_empty(), files == 2, "{}: {found:?}", path.display());
        assert!(told["checks"].is_array() || !found.is_empty(), "{}", path.display());
        let runs = &told["runs"];
        let first = &runs["series"][0];
        let known = first["t"].is_array() || first["problem"].is_string();
        assert!(known || !found.is_empty(), "{}: {runs}", path.display());
        if !first["t"].is_array() {
            without.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
        }
    }
    without.sort();
    // Two laws that need a sample period near rest, an observer alone, and a reference that each call gives.
    let known = ["least_settling_bound", "predefined_arctan", "prescribed_observer", "quadrotor"];
    assert_eq!(without, known, "examples without a trajectory");
}

#[test]
fn a_mistake_has_a_place_in_units_of_the_browser() {
    let design = "# größe 𝑥\nn = 2\nmu = \"expo(a=1)\"\npoles = [-4, -5]\n";
    let told = ask(&json!({ "design": design, "language": "c" }));
    let wrong = &told["diagnostics"][0];
    let units: Vec<u16> = design.encode_utf16().collect();
    let at = |end: usize| wrong["at"][end].as_u64().expect("a place") as usize;
    assert_eq!(String::from_utf16_lossy(&units[at(0)..at(1)]), "expo(a=1)", "{wrong}");
    assert_eq!((&wrong["line"], &wrong["column"]), (&json!(3), &json!(7)));
    assert_eq!(wrong["code"], "unknown-family");
    assert!(told.get("files").is_none());
}

#[test]
fn keys_have_places_by_which_they_are_edited() {
    let design = "n = 2\nmu = \"exp(a=1)\"\npoles = \"-4,-5\"\n[params]\ntau = 0.8 # s\n";
    let told = ask(&json!({ "design": design, "language": "c" }));
    let text = |key: &str, part: &str| {
        let at = |end: usize| told["keys"][key][part][end].as_u64().expect("a place") as usize;
        design[at(0)..at(1)].to_owned()
    };
    assert_eq!((text("tau", "key"), text("tau", "value")), ("tau".into(), "0.8".into()));
    assert_eq!(text("mu", "value"), "exp(a=1)");
    assert_eq!(text("poles", "value"), "-4,-5");
}

#[test]
fn a_design_is_run_and_others_are_laid_over_it() {
    let overlays = ["tan(a=1)", "no_family", "exp(a=3)"];
    let design = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-3\ntau = 1\n";
    let told =
        ask(&json!({ "design": design, "language": "c", "x0": "1, 0", "overlays": overlays }));
    let series = told["runs"]["series"].as_array().expect("runs");
    assert_eq!(series.len(), 4);
    let end = |run: &Value| run["end"]["x"][0].as_f64().expect("a number").abs();
    assert!(end(&series[0]) < 1e-6 && end(&series[1]) < 1e-3, "{} {}", series[0], series[1]);
    assert_eq!(series[0]["held"], true);
    assert!(series[2]["problem"].as_str().expect("a reason").contains("no_family"));
    assert_eq!(series[3]["refused_by"], json!(["growth"]), "poles right of -n a");
}

#[test]
fn page_and_engine_bound_the_mappings_alike() {
    let most = crate::run::OVERLAYS;
    let page = include_str!("../page/link.js");
    assert!(page.contains(&format!("const MOST = {most};")));
    let design = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\ntau = 1\n";
    let overlays: Vec<_> = (1..=most + 5).map(|a| format!("exp(a={a})")).collect();
    let told = ask(&json!({ "design": design, "language": "c", "overlays": overlays }));
    assert_eq!(told["runs"]["series"].as_array().expect("runs").len(), 1 + most);
}

#[test]
fn every_input_of_a_plant_is_run() {
    let design = example("two_link.toml");
    let told = ask(&json!({ "design": design, "language": "c", "x0": "1, -0.5, 0, 0" }));
    let runs = &told["runs"];
    assert_eq!(runs["states"], json!(["q1", "q2", "w1", "w2"]));
    assert_eq!(runs["inputs"], json!(["M1", "M2"]));
    let run = &runs["series"][0];
    assert_eq!(run["u_max"], json!([120.0, 60.0]));
    assert_eq!(run["u_min"], json!([-120.0, -60.0]));
    let count = run["t"].as_array().expect("times").len();
    for input in 0..2 {
        let u = run["u"][input].as_array().expect("an input");
        let peak = u.iter().filter_map(Value::as_f64).fold(0.0_f64, |peak, u| peak.max(u.abs()));
        assert_eq!((u.len(), run["peak"][input].as_f64()), (count, Some(peak)));
    }
    let end = run["end"]["x"].as_array().expect("a state");
    assert!(end.iter().all(|x| x.as_f64().is_some_and(|x| x.abs() < 1e-6)), "{run}");
}

#[test]
fn what_cannot_be_run_says_why() {
    let open = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n";
    let short = format!("{open}tau = 1e4\nsample_time = 1e-3\n");
    let event = format!("{open}tau = 1\n[[event]]\nat = 0.5\nkick = 1\nfor = 0.1\n");
    for (design, x0, reason) in [
        (&*short, "", "more than 200000 samples"),
        (open, "1, 2, 3", "x(0) needs 2 numbers"),
        (open, "1, inf", "x(0) needs 2 numbers"),
        (&event, "", "need the sampled loop"),
        (&example("quadrotor.toml"), "", "no reference to give"),
    ] {
        let told = ask(&json!({ "design": design, "language": "c", "x0": x0 }));
        let runs = &told["runs"];
        let problem = runs["problem"].as_str().or(runs["series"][0]["problem"].as_str());
        assert!(problem.is_some_and(|problem| problem.contains(reason)), "{reason}: {runs}");
        assert!(told["files"].is_array(), "the code does not need a run");
    }
}

#[test]
fn open_values_have_defaults_that_are_said() {
    let told = ask(&json!({ "design": "n = 2\nmu = \"exp\"\n", "language": "c" }));
    let run = &told["runs"]["series"][0];
    assert_eq!(run["assumed"], json!(["tau = 1 s", "a = 1", "k1 = 20", "k2 = 9"]));
    let end = run["end"]["x"][0].as_f64().expect("a number").abs();
    assert!(end < 1e-6, "{end}");
}

#[test]
fn runs_of_an_observer_hold_its_estimates() {
    let told = ask(&json!({ "design": example("encoder.toml"), "language": "c", "x0": "0.1, 0" }));
    let run = &told["runs"]["series"][0];
    let count = run["t"].as_array().expect("times").len();
    let curves = [&run["estimates"][1], &run["disturbance"]];
    assert!(curves.iter().all(|curve| curve.as_array().is_some_and(|all| all.len() == count)));
    let speed = |of: &str| run[of][1][count / 2].as_f64().expect("a number");
    assert!((speed("estimates") - speed("x")).abs() < 1e-3);
}

#[test]
fn runs_along_a_reference_hold_its_error() {
    let told = ask(&json!({ "design": example("track.toml"), "language": "c", "x0": "0.3, 0" }));
    let run = &told["runs"]["series"][0];
    let (x, e) = (&run["x"][0], &run["errors"][0]);
    let at = |all: &Value, index: usize| all[index].as_f64().expect("a number");
    for (index, t) in run["t"].as_array().expect("times").iter().enumerate() {
        let t = t.as_f64().expect("a number");
        let r = 0.1 * (2.0 * t + 0.3).sin();
        assert!((at(x, index) - at(e, index) - r).abs() < 1e-12, "at {t}");
    }
}

#[test]
fn trial_moves_the_run_of_each_loop() {
    let open = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\n";
    let held = format!("{open}sample_time = 1e-3\n");
    let bent = |design: &str, trial: Value| {
        let request = json!({ "design": design, "language": "c", "trial": trial });
        let told = ask(&request);
        told["runs"]["series"][0]["x"][0][150].as_f64().expect("a number")
    };
    for design in [open, &held] {
        let own = bent(design, json!({}));
        let trials = [json!({ "gain": 1.5 }), json!({ "force": 2 }), json!({ "friction": 1 })];
        for trial in trials {
            let moved = bent(design, trial.clone());
            assert!((moved - own).abs() > 1e-4, "{trial}: {moved}");
        }
    }
    let design = example("campaign.toml");
    let damped = |damping: f64| bent(&design, json!({ "symbols": { "damping": damping } }));
    assert!((damped(0.1) - damped(0.4)).abs() > 1e-9);
}

#[test]
fn deadlines_in_flight_and_events_are_followed() {
    let design = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\npoles = [-4, -5]\nlate = \"extend\"\n\n[params]\ntau = 0.5\nu_max = 20\n\n[[event]]\nat = 0.2\nkick = 8\nfor = 0.1\n";
    let told = ask(&json!({ "design": design, "language": "c", "x0": "1, 0" }));
    let run = &told["runs"]["series"][0];
    let deadlines = run["deadlines"].as_array().unwrap_or_else(|| panic!("deadlines: {told}"));
    let last = deadlines.last().and_then(Value::as_f64).expect("a deadline");
    assert!(deadlines[0] == 0.5 && last > 0.5, "{deadlines:?}");
    let end = run["end"]["x"].as_array().expect("a state");
    assert!(end.iter().all(|x| x.as_f64().is_some_and(|x| x.abs() < 1e-3)), "{run}");
}

#[test]
fn uncertain_quantities_are_in_the_middle_of_their_bounds() {
    let design = example("campaign.toml").replace("n = 3", "n = 3\ntau = 1");
    let told = ask(&json!({ "design": design, "language": "c" }));
    let assumed = told["runs"]["series"][0]["assumed"].to_string();
    assert!(assumed.contains("damping = 0.25") && assumed.contains("gust = 0"), "{assumed}");
}

#[test]
fn what_is_no_request_is_answered_too() {
    for text in ["", "{", "[]", "{\"design\": 3}"] {
        let told: Value = serde_json::from_str(&answer(text)).expect("JSON");
        let known = told["fault"].is_string() || told["diagnostics"][0]["message"].is_string();
        assert!(known, "{text}: {told}");
    }
    let large = "#".repeat(2_000_000);
    let told = ask(&json!({ "design": large, "language": "c" }));
    assert!(
        told["diagnostics"][0]["message"].as_str().is_some_and(|text| text.contains("1048576"))
    );
}

#[test]
fn every_language_has_a_tab() {
    let tabs = include_str!("../page/output.js");
    for language in ptc_codegen::emit::Language::ALL {
        let named = tabs.contains(&format!("{}: \"", language.name()));
        assert_eq!(named, language.fmi().is_none(), "{}", language.name());
    }
}
