//! generated/ holds what the generator writes, each file of it compiled, so that a change of the
//! emitted code is seen in review. Refresh it with `UPDATE_GOLDEN=1 cargo test --test golden`.

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use ptc_codegen::emit::Language;
use ptc_codegen::family::Family;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::reference::Status;
use ptc_codegen::request::{After, Feedback, Spec};
use support::goldens::{controllers, of_axes};
use support::program::{Record, has_gains, in_c, in_rust};
use support::specs::{Values, spec};
use support::{folder, in_samples, run, rustc, write};

const REFRESH: &str = "refresh with `UPDATE_GOLDEN=1 cargo test --test golden`";

/// The languages whose files are kept: those of every controller in C and Rust, and in the others
/// those of an explicit family, an iterated one, one in single precision, one that latches its state,
/// and one that calls functions of the user's.
const LANGUAGES: [Language; 7] = [
    Language::C,
    Language::Rust,
    Language::Cpp,
    Language::Matlab,
    Language::Python,
    Language::StructuredText,
    Language::PlcOpen,
];
const FEW: [&str; 5] =
    ["ptc_exp3", "ptc_exp_sum2", "ptc_exp3_f32", "ptc_own_law1_latched", "ptc_tanh3_extern"];

fn is_kept(language: Language, spec: &Spec) -> bool {
    matches!(language, Language::C | Language::Rust) || FEW.contains(&spec.name().as_str())
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("generated")
}

/// Every golden by its path in generated/, generated once for all tests.
static WANTED: LazyLock<BTreeMap<PathBuf, String>> = LazyLock::new(wanted);

fn wanted() -> BTreeMap<PathBuf, String> {
    let mut wanted = BTreeMap::new();
    for spec in controllers().into_iter().chain(of_axes()) {
        for language in LANGUAGES.into_iter().filter(|language| is_kept(*language, &spec)) {
            let folder = language.name();
            for file in ptc_codegen::generate(&spec, language).expect("a legal spec") {
                let path = Path::new(folder).join(file.name);
                let before = wanted.insert(path, file.text);
                assert_eq!(before, None, "two controllers of one name: {}", spec.name());
            }
        }
    }
    wanted
}

/// Every file in generated/ by its path there.
fn kept() -> BTreeMap<PathBuf, String> {
    let mut kept = BTreeMap::new();
    for folder in LANGUAGES.map(Language::name) {
        let Ok(entries) = fs::read_dir(root().join(folder)) else { continue };
        for entry in entries {
            let entry = entry.expect("an entry");
            let text = fs::read_to_string(entry.path()).expect("a text");
            kept.insert(Path::new(folder).join(entry.file_name()), text);
        }
    }
    kept
}

#[test]
fn generated_is_what_the_generator_writes() {
    let wanted = &*WANTED;
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        for stale in kept().keys().filter(|path| !wanted.contains_key(*path)) {
            fs::remove_file(root().join(stale)).expect("a stale file goes");
        }
        for (path, text) in wanted {
            let path = root().join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, text).expect("a golden");
        }
    }
    let kept = kept();
    let paths = |files: &BTreeMap<PathBuf, String>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(paths(&kept), paths(wanted), "the files in generated/; {REFRESH}");
    for (path, text) in wanted {
        let line = text.lines().zip(kept[path].lines()).position(|(a, b)| a != b);
        let same = kept[path] == *text;
        assert!(same, "{} differs, first in line index {line:?}; {REFRESH}", path.display());
    }
}

/// Those of goldens in these languages, by name.
fn goldens(languages: &[&str]) -> Vec<(String, String)> {
    let own = WANTED.iter().filter(|(path, _)| languages.iter().any(|one| path.starts_with(one)));
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    own.map(|(path, text)| (name(path), text.clone())).collect()
}

#[test]
fn goldens_in_rust_are_formatted() {
    formatted(("rustfmt", ""), &goldens(&["rust"]), &["--check", "--edition", "2024"]);
}

/// In the style of .clang-format, as version 14 of the program reads it.
#[test]
fn c_and_cpp_are_formatted() {
    let plain = controllers().into_iter().filter(|spec| FEW.contains(&&*spec.name()));
    let one_law = spec(&[("n", "2"), ("axes", "2"), ("mu", "exp"), ("pi0", "extern")]);
    let selftests = plain.chain(in_samples::controllers()).chain([one_law]).flat_map(|spec| {
        let files = ptc_codegen::generate_selftest(&spec).expect("a self-test");
        files.into_iter().map(|file| (file.name, file.text))
    });
    let files: Vec<_> = goldens(&["c", "cpp"]).into_iter().chain(selftests).collect();
    let style = format!("--style=file:{}/.clang-format", env!("CARGO_MANIFEST_DIR"));
    formatted(("clang-format", "version 14."), &files, &["--dry-run", "--Werror", &style]);
}

/// A program of this version that lays out sources has nothing to change in these files.
fn formatted((program, version): (&str, &str), files: &[(String, String)], arguments: &[&str]) {
    let told = Command::new(program).arg("--version").output();
    let has = |run: &Output| String::from_utf8_lossy(&run.stdout).contains(version);
    if !told.is_ok_and(|run| run.status.success() && has(&run)) {
        return eprintln!("NOT RUN: {program} {version} cannot be had");
    }
    // Apart from the workspace, whose style is its own.
    let folder = std::env::temp_dir().join(format!("ptc_{program}_{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let files: Vec<_> = files
        .iter()
        .map(|(name, text)| {
            let file = folder.join(name);
            fs::write(&file, text).expect("a file");
            file
        })
        .collect();
    let told = Command::new(program).args(arguments).args(&files).output().expect(program);
    assert!(
        !files.is_empty() && told.status.success(),
        "{}{}",
        String::from_utf8_lossy(&told.stdout),
        String::from_utf8_lossy(&told.stderr)
    );
    fs::remove_dir_all(&folder).expect("its end");
}

/// Those of the families that call no function at all need no `std`.
#[test]
fn goldens_without_a_function_compile_without_std() {
    let folder = folder("golden_rust");
    let mut modules = "#![no_std]\n".to_owned();
    for spec in controllers().into_iter().chain(of_axes()) {
        let bare = matches!(
            spec.family(),
            Some(Family::Exp | Family::Rational | Family::Tanh | Family::Soft)
        );
        if bare && spec.feedback == Feedback::Linear {
            write(&folder, &spec, Language::Rust);
            modules += &format!("pub mod {};\n", spec.name());
        }
    }
    let crate_root = folder.join("lib.rs");
    fs::write(&crate_root, modules).expect("a file");
    let mut compiler = rustc();
    compiler.args(["--crate-type=lib", "--emit=metadata", "-o"]);
    run(compiler.arg(folder.join("lib.rmeta")).arg(&crate_root));
}

/// The statuses that a golden may give at a time, where tau is 2 s and eps 2^-7 s.
fn possible(spec: &Spec, t: f64) -> [i32; 2] {
    let unclipped = match spec.after {
        After::Zero | After::Extern if t >= 2.0 => Status::After,
        _ if t < 1.99 => Status::Ok,
        _ => Status::Hold,
    };
    [unclipped, Status::Saturated].map(Status::code)
}

/// Each compiles without a warning and runs, in C and in Rust, over its whole time to the deadline and past it: the statuses
/// are those of the time, and the two languages agree up to the last digits of a library.
#[test]
fn every_golden_runs() {
    let controllers = controllers();
    let folder = folder("golden_runs");
    let programs = in_c(&folder, &controllers).into_iter().zip(in_rust(&folder, &controllers));
    for (spec, (c, rust)) in controllers.iter().zip(programs) {
        let gains: Vec<f64> = (1..=spec.n).map(|i| 2.0 + i as f64).collect();
        let values = Values {
            tau: 2.0,
            t0: 0.0,
            eps: 0.0078125,
            u_max: 1e30,
            a: 1.0,
            m: 1.5,
            start: 0.25,
            rates: &[0.5, 1.5, 2.5][..spec.rates()],
            k: &gains,
        };
        let times: Vec<f64> = (0..=17).map(|i| f64::from(i) / 8.0).collect();
        let parameter = |parameter| match parameter {
            Parameter::Named(_) => 1.0,
            of_family => values.get(of_family),
        };
        let x: Vec<f64> = (0..spec.n).map(|j| 0.01 * (j as f64 + 1.0)).collect();
        let record = |t: &f64| Record {
            parameters: spec.run_time_parameters().map(parameter).collect(),
            x0: if spec.latches() { x.clone() } else { Vec::new() },
            t: *t,
            x: x.clone(),
        };
        let records: Vec<_> = times.iter().map(record).collect();
        for ((t, c), rust) in times.iter().zip(c.run(&records)).zip(rust.run(&records)) {
            let name = spec.name();
            assert!(c.init == 0 && possible(spec, *t).contains(&c.step.0), "{name} at {t}: {c:?}");
            assert_eq!((c.step.0, c.axis.0), (rust.step.0, rust.axis.0), "{name} at {t}");
            let mut pairs = vec![(c.step.1, rust.step.1), (c.axis.1, rust.axis.1)];
            pairs.extend(has_gains(spec).then_some((c.step.1, c.axis.1)));
            for (u, v) in pairs {
                let near = 1e-5 * u.abs().max(1e-3);
                assert!(u.is_finite() && (u - v).abs() <= near, "{name} at {t}: {u} and {v}");
            }
        }
    }
}

#[test]
fn generating_twice_gives_the_same_bytes() {
    assert_eq!(wanted(), *WANTED);
}

/// The macro expands to the items of the golden, on the types of the facade.
#[test]
fn the_macro_expands_to_the_golden() {
    for spec in controllers().into_iter().chain(of_axes()) {
        let items = ptc_codegen::macro_items(&spec).expect("a legal spec");
        let file = ptc_codegen::generate(&spec, Language::Rust).expect("a legal spec").remove(0);
        assert!(items.contains("::ptc::"), "{}", spec.name());
        let real = support::program::real(spec.precision);
        let own = items.replace(&format!("::ptc::math::{real}::"), "math::").replace("::ptc::", "");
        assert!(file.text.ends_with(&own), "{}: the file does not end in\n{own}", spec.name());
    }
}
