//! Every command resolves a design to the same controller and names it by the same fingerprint.

use crate::support;

use std::fs;
use std::path::Path;

use support::{example, folder_with, run_in};

/// Designs of each kind that leave something open, with the state of a run.
const DESIGNS: [(&str, &str, &str); 7] = [
    (
        "time",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-2\nx0_max = [1, 0.5]\n\
         [params]\ntau = 1\nt0 = 0\nu_max = 50\n[verify]\nx1 = [-0.5, 0.5]\nx2 = 0\n",
        "0.5,0",
    ),
    (
        "noise",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-2\nnoise = [1e-4, 1e-3]\nx0_max = [1, 0.5]\n\
         [params]\ntau = 1\nt0 = 0\nu_max = 50\n[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\n",
        "0.1,0",
    ),
    (
        "samples",
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -5]\nsample_time = 1e-2\nnoise = [1e-4, 1e-3]\n\
         x0_max = [1, 0.5]\n[params]\ntau = 1\nu_max = inf\n[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\n",
        "0.1,0",
    ),
    (
        "end",
        "n = 2\nmu = \"exp(a=7/5)\"\nclock = \"samples\"\npoles = [-3, -100]\nsample_time = 1e-2\n\
         x0_max = [1, 0.5]\n[params]\ntau = 2\nu_max = inf\n[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\n",
        "0.1,0",
    ),
    (
        "observer",
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -5, -6]\ndelay = 1\nmeasured = [\"x1\"]\n\
         observer_poles = [-4, -5]\nsample_time = 1e-2\nsensor_step = [1e-5, 0]\nx0_max = [1, 0.5]\n[params]\n\
         tau = 1\nu_max = inf\n[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\n",
        "0.1,0",
    ),
    (
        "axes",
        "n = 2\naxes = 2\nmu = \"exp(a=1)\"\npoles = [[-4, -5], [-6, -7]]\nsample_time = 1e-2\nx0_max = [1, 0.5]\n\
         [params]\ntau = 1\nt0 = 0\nu_max = 100\n[verify]\nx1_1 = [-0.1, 0.1]\nx2_1 = 0\nx1_2 = 0\nx2_2 = 0\n",
        "0.1,0,0,0",
    ),
    (
        "model",
        "mu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-2\nerror = 1e-2\nx0_max = [1, 0.5]\n[params]\ntau = 1\n\
         t0 = 0\nu_max = 100\nJ = 2\n[model]\nstates = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\n\
         dynamics = { q = \"w\", w = \"(M - sin(q))/J\" }\n[verify]\nq = [-0.1, 0.1]\nw = 0\n",
        "0.1,0",
    ),
];

/// Settings and objective of a campaign with few runs.
const SHORT: &str =
    "scenarios = 4\nsearch = 0\n[[objective]]\nbound = \"attractive\"\nerror = 100\n";

/// Runs a command that may refuse the design or leave it undecided.
fn output(folder: &Path, arguments: &[&str]) -> String {
    let (exit, stdout, stderr) = run_in(folder, arguments);
    assert!(matches!(exit, Some(0 | 1 | 3)), "{arguments:?}: {stdout}{stderr}");
    format!("{stdout}{stderr}")
}

/// The fingerprint and the choices of `check`.
fn checked(folder: &Path) -> (String, serde_json::Value) {
    let (_, json, stderr) = run_in(folder, &["check", "d.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
    let own = found["fingerprint"].as_str().expect("a fingerprint").to_owned();
    assert!(own.len() == 12 && own.bytes().all(|b| b.is_ascii_hexdigit()), "{own}");
    (own, found["chosen"].clone())
}

#[test]
fn every_command_prints_the_emitted_design() {
    for (name, text, x0) in DESIGNS {
        let text = format!("name = \"of_{name}\"\n{text}{SHORT}");
        let folder = folder_with(&format!("one_{name}"), "d.toml", &text);
        let (own, chosen) = checked(&folder);
        let told = format!("design {own}");
        assert!(output(&folder, &["check", "d.toml"]).contains(&own), "{name}");
        for language in ["c", "rust", "cpp", "python", "matlab"] {
            let code = output(&folder, &["emit", "d.toml", "--lang", language, "-o", "-"]);
            assert!(code.contains(&told), "{name}, {language}: {code}");
        }
        // The box of [verify] is another one than x0_max, and chooses nothing.
        let verified = output(&folder, &["verify", "d.toml", "--report", "v.html"]);
        assert!(verified.contains(&told), "{name}: {verified}");
        let x0 = format!("--x0={x0}");
        let ran =
            output(&folder, &["simulate", "d.toml", &x0, "-o", "r.csv", "--report", "s.html"]);
        assert!(ran.contains(&told), "{name}: {ran}");
        for page in ["v.html", "s.html"] {
            let page = fs::read_to_string(folder.join(page)).expect("a report");
            assert!(page.contains(&own), "{name}: the report does not name its design");
        }
        // What was chosen is what the code holds.
        let eps = chosen[0]["value"].as_str().unwrap_or_else(|| panic!("{name}: {chosen}"));
        assert_eq!(chosen[0]["key"].as_str(), Some("eps"));
        let code = output(&folder, &["emit", "d.toml", "--lang", "c", "-o", "-"]);
        assert!(code.contains(&format!("eps = {eps} [s], fixed")), "{name}: {eps}: {code}");
        assert!(verified.contains(&format!("chosen: eps = {eps}: ")), "{name}: {verified}");
    }
}

/// The resolved design of every example emits the same bytes and has the same fingerprint.
#[test]
fn resolved_designs_emit_the_same_bytes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let files =
        fs::read_dir(folder).expect("examples").map(|entry| entry.expect("an entry").file_name());
    let names = files.filter_map(|name| name.into_string().ok());
    let names: Vec<_> =
        names.filter(|name| name.ends_with(".toml") && name != "design.toml").collect();
    assert!(names.len() >= 14, "{names:?}");
    let examples =
        names.iter().map(|name| (name.clone(), example(name), vec!["--param", "tau=0.75"]));
    let own = DESIGNS.map(|(name, text, _)| {
        (name.to_owned(), format!("{text}{SHORT}"), vec!["--name", "other"])
    });
    for (name, text, flags) in examples.chain(own) {
        let folder = folder_with(&format!("resolved_{name}"), "d.toml", &text);
        for flags in [Vec::new(), flags] {
            let emit = |design: &str, out: &str, more: &[&str]| {
                run_in(&folder, &[&["emit", design, "--lang", "c", "-o", out], more].concat())
            };
            let with = [&flags[..], &["--resolved", "r.toml"]].concat();
            let (exit, told, wrong) = emit("d.toml", "a", &with);
            if exit != Some(0) {
                // A check refuses the design, or a flag does not fit it.
                let refused = exit == Some(1) || !flags.is_empty();
                assert!(refused && !folder.join("r.toml").is_file(), "{name}: {told}{wrong}");
                continue;
            }
            let (exit, told, wrong) = emit("r.toml", "b", &[]);
            assert_eq!(exit, Some(0), "{name}: {told}{wrong}");
            for file in fs::read_dir(folder.join("a")).expect("files") {
                let file = file.expect("a file").file_name();
                let [a, b] =
                    ["a", "b"].map(|at| fs::read(folder.join(at).join(&file)).expect("a file"));
                assert!(a == b, "{name}: {file:?} differs");
            }
            for made in ["a", "b", "r.toml"] {
                let made = folder.join(made);
                let _ =
                    if made.is_dir() { fs::remove_dir_all(made) } else { fs::remove_file(made) };
            }
        }
    }
}

/// `design` writes the design that it verified: `verify` judges the same one.
#[test]
fn chosen_design_is_verified_as_written() {
    let wish = DESIGNS[1].1.replace("poles = [-4, -5]\n", "").replace("x0_max = [1, 0.5]\n", "");
    let text = format!("name = \"wish\"\n{wish}{SHORT}");
    let folder = folder_with("one_wish", "wish.toml", &text);
    let (exit, told, wrong) = run_in(&folder, &["design", "wish.toml", "-o", "d.toml"]);
    assert_eq!(exit, Some(0), "{told}{wrong}");
    let (own, chosen) = checked(&folder);
    assert!(chosen.as_array().is_some_and(Vec::is_empty), "{chosen}: a value is still open");
    assert!(told.contains(&format!("design {own}")), "{told}");
    let written = fs::read_to_string(folder.join("d.toml")).expect("a design");
    assert!(written.contains(&format!("design {own}")) && written.contains("eps = "), "{written}");
    let verified = output(&folder, &["verify", "d.toml"]);
    assert!(verified.contains(&format!("design {own}")), "{verified}");
}

/// Values that follow from other keys are listed beside the chosen ones, and the code holds them.
#[test]
fn derived_values_of_a_design_are_listed() {
    let design = |eps: &str| {
        let lines = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -6]\nmeasured = [\"x1\"]\n\
                     observer_poles = [-3, -4]\nsample_time = 1e-2\nsensor_step = [1e-5, 0]\n";
        format!("name = \"follows\"\n{lines}{eps}[params]\ntau = 0.5\n")
    };
    let ends = ["poles_end = least-energy(weight=2)", "end_samples = 7", "observer_samples = 25"];
    let all = [&["eps = 0"][..], &ends].concat();
    let (gains, held) = ("[24, 10]", "0.06 after its round");
    // u changes its sign where T^(6) does in a chain of 2, 6 + 2 - 1 samples to go. Gains that are held earlier never
    // come to that. The observer's round of 25 samples is held where deadbeat takes over, above an eighth of it.
    for (eps, chosen, follows) in [
        ("", all.as_slice(), [gains, "", held]),
        ("eps = 0\n", &ends, [gains, "", held]),
        ("eps = 0.1\n", &ends[2..], [gains, "not used", held]),
        ("eps = 0.01\n", &ends, [gains, "", held]),
    ] {
        let folder = folder_with("follows", "d.toml", design(eps));
        let (_, json, stderr) = run_in(&folder, &["check", "d.toml", "--format", "json"]);
        let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
        let told: Vec<_> = found["chosen"].as_array().expect("a list").iter().collect();
        assert_eq!(told.len(), chosen.len(), "{eps}: {found}");
        for (one, wanted) in told.iter().zip(chosen) {
            let [key, value] = ["key", "value"].map(|part| one[part].as_str().expect("a word"));
            assert!(format!("{key} = {value}").starts_with(wanted), "{eps}: {one}");
        }
        let wanted = ["gains", "end_samples", "observer_eps"].into_iter().zip(follows);
        let wanted: Vec<_> = wanted.filter(|(_, value)| !value.is_empty()).collect();
        let told = found["follows"].as_array().expect("a list").iter();
        let told: Vec<_> = told
            .map(|one| ["key", "value"].map(|part| one[part].as_str().expect("a word")))
            .map(|[key, value]| (key, value))
            .collect();
        assert_eq!(told, wanted, "{eps}");
        let code = output(&folder, &["emit", "d.toml", "--lang", "c", "-o", "-"]);
        let ends = code.contains("The law of least energy to the end.");
        assert_eq!(ends, follows[1] != "not used", "{eps}: {code}");
        let page = output(&folder, &["check", "d.toml"]);
        assert!(page.contains("follows: gains = [24, 10]: those of the poles"), "{page}");
    }
}
