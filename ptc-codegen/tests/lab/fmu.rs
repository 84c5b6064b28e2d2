//! FMUs as they are written: what is in the archive, that its XML is well-formed and agrees with the
//! source, refusals, and the same bytes twice. `cargo assure fmu` simulates them.

mod duration;
mod importer;
mod steering;

use crate::support;

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;
use std::process::Output;

use support::folder;
use zip::ZipArchive;

fn emit(arguments: &[&str], folder: &Path, compiler: &str) -> Output {
    let mut command = support::command(&["emit"]);
    command.args(arguments).arg("-o").arg(folder).env("CC", compiler);
    command.output().expect("the binary runs")
}

/// Writes an FMU that nothing is complained of.
fn written(arguments: &[&str], folder: &Path) {
    let output = emit(arguments, folder, "cc");
    let told = support::without_design(&String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && told.is_empty(), "{arguments:?}: {told}");
}

/// The entries of an archive.
fn entries(path: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut archive = ZipArchive::new(File::open(path).expect("there")).expect("an archive");
    let mut entries = BTreeMap::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).expect("an entry");
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).expect("readable");
        let name = entry.name().expect("UTF-8").into_owned();
        entries.insert(name, bytes);
    }
    entries
}

fn text(entries: &BTreeMap<String, Vec<u8>>, name: &str) -> String {
    let bytes = entries.get(name).unwrap_or_else(|| panic!("{name} among {:?}", entries.keys()));
    String::from_utf8(bytes.clone()).expect("UTF-8")
}

/// The elements of a document with their attributes, its tags being balanced.
fn elements(xml: &str) -> Vec<(String, BTreeMap<String, String>)> {
    let body = xml.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").expect("a prolog");
    let (mut open, mut found) = (Vec::new(), Vec::new());
    for piece in body.split('<').skip(1) {
        let (tag, rest) = piece.split_once('>').expect("a tag ends");
        assert_eq!(rest.trim(), "", "text between tags");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "tags match");
            continue;
        }
        let alone = tag.ends_with('/');
        let tag = tag.trim_end_matches('/');
        let (name, mut rest) = tag.split_once(' ').unwrap_or((tag, ""));
        let mut attributes = BTreeMap::new();
        while let Some((key, value)) = rest.trim().split_once("=\"") {
            let (value, after) = value.split_once('"').expect("a quote closes");
            for (at, _) in value.match_indices('&') {
                assert!(value[at..].starts_with("&#"), "an entity of XML: {value}");
            }
            assert_eq!(attributes.insert(key.to_owned(), value.to_owned()), None, "{key} twice");
            rest = after;
        }
        assert_eq!(rest.trim(), "", "attributes are quoted: {tag}");
        found.push((name.to_owned(), attributes));
        if !alone {
            open.push(name.to_owned());
        }
    }
    assert!(open.is_empty(), "{open:?} are open");
    found
}

const DESIGN: [&str; 5] = ["--n=2", "--mu=exp", "--name=stage", "--tau=2", "--u-max=inf"];

#[test]
fn the_archive_holds_what_the_standard_asks_for() {
    let folder = folder("fmu_archive");
    for (lang, own) in [("fmu2", None), ("fmu3", Some("sources/buildDescription.xml"))] {
        let home = folder.join(lang);
        written(&[&["--lang", lang][..], &DESIGN].concat(), &home);
        let names: Vec<_> = fs::read_dir(&home).expect("a folder").collect();
        assert_eq!(names.len(), 1, "nothing is left beside the FMU");
        let entries = entries(&home.join("stage.fmu"));
        let mut wanted = vec![
            "modelDescription.xml",
            "sources/stage.c",
            "sources/stage.h",
            "sources/stage_fmu.c",
        ];
        wanted.extend(own);
        wanted.sort_unstable();
        let texts: Vec<_> = entries.keys().filter(|name| !name.starts_with("binaries/")).collect();
        assert_eq!(texts, wanted);
        let library = entries.keys().find(|name| name.starts_with("binaries/"));
        let library = library.expect("a library").rsplit('/').next().expect("a name");
        assert!(library.starts_with("stage."), "{library}");
    }
}

/// The controller in an FMU is the very C that `--lang c` writes.
#[test]
fn the_controller_is_the_emitted_c() {
    let folder = folder("fmu_c");
    for precision in ["f64", "f32"] {
        for lang in ["c", "fmu2", "fmu3"] {
            let flags = ["--lang", lang, "--n=3", "--mu=exp_sum", "--name=stage"];
            written(
                &[&flags[..], &["--precision", precision]].concat(),
                &folder.join(precision).join(lang),
            );
        }
        let read =
            |path: &str| fs::read(folder.join(precision).join("c").join(path)).expect("there");
        for lang in ["fmu2", "fmu3"] {
            let entries = entries(&folder.join(precision).join(lang).join("stage.fmu"));
            assert_eq!(entries["sources/stage.c"], read("stage.c"));
            assert_eq!(entries["sources/stage.h"], read("stage.h"));
        }
    }
}

/// What each call is given of a reference stands behind the states, and u depends on it.
#[test]
fn a_reference_is_among_the_inputs() {
    let folder = folder("fmu_reference");
    for lang in ["fmu2", "fmu3"] {
        let home = folder.join(lang);
        written(&["--lang", lang, "--n=2", "--mu=exp", "--name=stage", "--reference=input"], &home);
        let entries = entries(&home.join("stage.fmu"));
        let all = elements(&text(&entries, "modelDescription.xml"));
        let inputs: Vec<_> = all
            .iter()
            .filter(|(_, a)| a.get("causality").is_some_and(|causality| causality == "input"))
            .map(|(_, a)| (a["name"].as_str(), a["valueReference"].as_str()))
            .collect();
        assert_eq!(inputs, [("x1", "1"), ("x2", "2"), ("r0", "3"), ("r1", "4"), ("r2", "5")]);
        assert!(all.iter().any(|(_, a)| a.get("dependencies").is_some_and(|d| d == "1 2 3 4 5")));
        let source = text(&entries, "sources/stage_fmu.c");
        assert!(
            source.contains("stage_step(&state->controller, t, state->x, state->r, &state->u)")
        );
        assert!(source.contains("set x1..x2, r0..r2, get u"), "{source}");
    }
}

/// Each axis has inputs and outputs of its own, and u of an axis depends on its inputs alone.
#[test]
fn axes_have_variables_of_their_own() {
    let folder = folder("fmu_axes");
    for lang in ["fmu2", "fmu3"] {
        let home = folder.join(lang);
        let design = ["--n=1", "--axes=2", "--mu=exp", "--name=stage", "--reference=input"];
        written(&[&["--lang", lang][..], &design].concat(), &home);
        let entries = entries(&home.join("stage.fmu"));
        let all = elements(&text(&entries, "modelDescription.xml"));
        let of = |causality: &str| -> Vec<_> {
            let own =
                all.iter().filter(|(_, a)| a.get("causality").is_some_and(|c| c == causality));
            own.map(|(_, a)| a["name"].clone()).collect()
        };
        assert_eq!(of("input"), ["x1_1", "x1_2", "r0_1", "r1_1", "r0_2", "r1_2"]);
        assert_eq!(of("output"), ["u1", "u2", "time_to_go", "status", "status1", "status2"]);
        let depends: Vec<_> =
            all.iter().filter_map(|(_, a)| a.get("dependencies").map(String::as_str)).collect();
        assert_eq!(depends, ["1 3 4", "2 5 6", "", "1 2 3 4 5 6", "1 3 4", "2 5 6"]);
        let source = text(&entries, "sources/stage_fmu.c");
        let call = "stage_step(&state->controller, t, (const double (*)[1])state->x, \
                    (const double (*)[2])state->r, state->u, state->axes)";
        assert!(source.contains(call), "{source}");
        let usage = "set x1_1..x1_2, r0_1..r1_2, get u1..u2, give them to the plant, step.";
        assert!(source.contains(usage), "{source}");
    }
}

/// A parameter with the name of an input or an output would be a second variable of that name.
#[test]
fn parameter_named_like_an_output_is_refused() {
    let folder = folder("fmu_names");
    let design = ["--lang=fmu2", "--n=2", "--axes=2", "--mu=exp", "--g=[1, u2]"];
    let output = emit(&design, &folder, "cc");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success(), "{told}");
    assert!(told.contains("the FMU has another variable u2"), "{told}");
}

#[test]
fn the_description_is_well_formed_and_agrees_with_the_source() {
    let folder = folder("fmu_xml");
    for (lang, token) in [("fmu2", "guid"), ("fmu3", "instantiationToken")] {
        for mu in ["exp", "power", "exp_sum(3)", "tau*t/(t+1/b)"] {
            let home = folder.join(lang);
            written(&["--lang", lang, "--n=2", "--mu", mu, "--name=stage", "--tau=2"], &home);
            let entries = entries(&home.join("stage.fmu"));
            let all = elements(&text(&entries, "modelDescription.xml"));
            let source = text(&entries, "sources/stage_fmu.c");
            assert!(source.contains(&format!("#define TOKEN \"{}\"", all[0].1[token])), "{mu}");
            let variables: Vec<_> =
                all.iter().filter(|(_, a)| a.contains_key("causality")).map(|(_, a)| a).collect();
            let named = |name: &str| {
                variables.iter().find(|a| a["name"] == name).unwrap_or_else(|| panic!("{name}"))
            };
            assert_eq!(named("tau")["variability"], "constant", "{mu}");
            assert_eq!(named("eps")["variability"], "tunable", "{mu}");
            assert_eq!(named("x2")["causality"], "input");
            for output in ["u", "time_to_go", "status"] {
                assert_eq!(named(output)["causality"], "output");
            }
            // In FMI 2.0 an index stands for a variable; here it is its value reference.
            let first = usize::from(lang == "fmu2");
            for (index, variable) in variables.iter().enumerate() {
                assert_eq!(variable["valueReference"], (index + first).to_string());
            }
            for (_, attributes) in &all {
                if let Some(unit) = attributes.get("unit") {
                    assert!(all.iter().any(|(e, a)| e == "Unit" && a["name"] == *unit), "{unit}");
                }
            }
        }
    }
}

#[test]
fn the_same_design_gives_the_same_bytes_and_another_a_different_token() {
    let folder = folder("fmu_bytes");
    for lang in ["fmu2", "fmu3"] {
        let flags = [&["--lang", lang][..], &DESIGN].concat();
        let [a, b, c] = ["a", "b", "c"].map(|name| folder.join(lang).join(name));
        written(&flags, &a);
        written(&flags, &b);
        let read = |home: &Path| fs::read(home.join("stage.fmu")).expect("there");
        assert!(read(&a) == read(&b), "{lang}");
        written(&[&["--lang", lang, "--eps=0.02"][..], &DESIGN].concat(), &c);
        let source = |home: &Path| {
            let text = text(&entries(&home.join("stage.fmu")), "sources/stage_fmu.c");
            text.lines().find(|l| l.starts_with("#define TOKEN")).expect("a token").to_owned()
        };
        assert_eq!(source(&a), source(&b));
        assert_ne!(source(&a), source(&c));
    }
}

/// With a clock in samples the inputs are what is measured, N is an integer, and a step is a sample.
#[test]
fn a_clock_in_samples_has_steps_of_a_sample() {
    let folder = folder("fmu_samples");
    let observer = ["--measured=x1", "--observer-poles=-4,-5,-6", "--disturbance=constant"];
    let design =
        ["--n=2", "--mu=exp(a=1)", "--clock=samples", "--name=stage", "--sample-time=0.01"];
    for lang in ["fmu2", "fmu3", "c"] {
        written(&[&["--lang", lang][..], &design, &observer].concat(), &folder.join(lang));
    }
    for lang in ["fmu2", "fmu3"] {
        let entries = entries(&folder.join(lang).join("stage.fmu"));
        let c = fs::read(folder.join("c/stage.c")).expect("there");
        assert_eq!(entries["sources/stage.c"], c);
        let all = elements(&text(&entries, "modelDescription.xml"));
        let simulation = all.iter().find(|(name, _)| name == "CoSimulation").expect("one");
        assert_eq!(simulation.1["canHandleVariableCommunicationStepSize"], "false");
        let of = |wanted: &str| -> Vec<_> {
            let is = |a: &BTreeMap<String, String>| a.get("causality").is_some_and(|c| c == wanted);
            all.iter().filter(|(_, a)| is(a)).map(|(_, a)| a["name"].as_str()).collect()
        };
        assert_eq!(of("input"), ["y1"]);
        assert_eq!(of("output"), ["u", "time_to_go", "status", "xhat1", "xhat2", "d"]);
        let experiment = all.iter().find(|(name, _)| name == "DefaultExperiment").expect("one");
        assert_eq!(experiment.1["stepSize"], "0.01");
        assert_eq!(experiment.1["stopTime"], "10");
        match lang {
            "fmu3" => assert_eq!(simulation.1["fixedInternalStepSize"], "0.01"),
            _ => assert!(all.iter().any(|(name, a)| name == "Integer"
                && a.get("start").is_some_and(|start| start == "1000"))),
        }
        // A reference that each call is given is an input, as with a clock in time.
        let follows = [&["--lang", lang][..], &design, &observer, &["--reference=input"]].concat();
        written(&follows, &folder.join(lang));
        let entries = self::entries(&folder.join(lang).join("stage.fmu"));
        let all = elements(&text(&entries, "modelDescription.xml"));
        let inputs = all.iter().filter(|(_, a)| a.get("causality").is_some_and(|c| c == "input"));
        let names: Vec<_> = inputs.map(|(_, a)| a["name"].as_str()).collect();
        assert_eq!(names, ["y1", "r0", "r1", "r2"]);
    }
}

/// An importer that compiles sources can use what is written without a compiler.
#[test]
fn status_of_a_gated_observer_names_doubted_readings() {
    let folder = folder("fmu_gated");
    let law = ["--lang=fmu2", "--name=gated", "--n=1", "--mu=exp(a=1)", "--poles=-4", "--eps=0"];
    let clock = ["--clock=samples", "--sample-time=0.01", "--tau=1", "--measured=x1"];
    let observer = ["--disturbance=constant", "--observer-poles=-4,-5", "--observer-samples=50"];
    let gate = ["--innovation-max=0.1", "--coast=3"];
    let status = |flags: &[&str]| {
        written(&[&law[..], &clock, &observer, flags].concat(), &folder);
        let entries = entries(&folder.join("gated.fmu"));
        let all = elements(&text(&entries, "modelDescription.xml"));
        let named = |a: &BTreeMap<String, String>| a.get("name").is_some_and(|n| n == "status");
        let found = all.into_iter().find(|(_, attributes)| named(attributes)).expect("a status");
        found.1["description"].clone()
    };
    assert!(!status(&[]).contains("4 a reading"));
    assert!(status(&gate).contains("4 a reading not believed"));
}

#[test]
fn without_a_compiler_there_are_sources_and_a_word_about_it() {
    let folder = folder("fmu_sources");
    let flags = [&["--lang=fmu2"][..], &DESIGN].concat();
    for (compiler, part) in
        [("/no/such/cc", "cannot run `/no/such/cc`"), ("false", "`false` fails")]
    {
        let output = emit(&flags, &folder, compiler);
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{told}");
        for part in ["warning", "stage.fmu holds sources and no library", part, "CC"] {
            assert!(told.contains(part), "{part}: {told}");
        }
        let entries = entries(&folder.join("stage.fmu"));
        assert!(entries.keys().all(|name| !name.starts_with("binaries/")), "{:?}", entries.keys());
    }
}

#[test]
fn check_compares_the_text_in_the_archive() {
    let folder = folder("fmu_check");
    let flags = [&["--lang=fmu3"][..], &DESIGN].concat();
    let check = [&flags[..], &["--check"]].concat();
    let missing = emit(&check, &folder, "cc");
    assert_eq!(missing.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("modelDescription.xml is missing"));
    // Compiled or not, the text is the same.
    assert!(emit(&flags, &folder, "/no/such/cc").status.success());
    assert_eq!(emit(&check, &folder, "cc").status.code(), Some(0));
    let other = [&check[..], &["--eps=0.02"]].concat();
    let drift = emit(&other, &folder, "cc");
    assert_eq!(drift.status.code(), Some(1));
    assert!(
        String::from_utf8_lossy(&drift.stderr).contains("stage.fmu/modelDescription.xml differs")
    );
    fs::write(folder.join("stage.fmu"), "no archive").expect("writable");
    let odd = emit(&check, &folder, "cc");
    assert_eq!(odd.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&odd.stderr).contains("cannot read"));
}

#[test]
fn what_an_fmu_cannot_hold_is_refused() {
    let folder = folder("fmu_refused");
    let extern_law = ["--n=2", "--mu=exp", "--pi0=extern"];
    let after = ["--n=2", "--mu=exp", "--after=extern"];
    let associated = ["--n=2", "--mu=exp", "--what=associated"];
    let taken = ["--n=2", "--mu=exp", "--g=status"];
    for (flags, parts) in [
        (&extern_law[..], &["pi0", "user-defined pi0", "emit C or Rust"][..]),
        (&after, &["after the deadline", "emit C or Rust"]),
        (&associated, &["infinite-time system", "leave `what` out"]),
        (&taken, &["status", "another name"]),
    ] {
        for lang in ["fmu2", "fmu3"] {
            let output = emit(&[&["--lang", lang][..], flags].concat(), &folder, "cc");
            let told = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{flags:?}: {told}");
            for part in parts {
                assert!(told.contains(part), "{flags:?} lacks {part}: {told}");
            }
        }
    }
    let printed = emit(&[&["--lang=fmu2"][..], &DESIGN].concat(), Path::new("-"), "cc");
    assert_eq!(printed.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&printed.stderr).contains("an archive"));
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0, "nothing is left behind");
}
