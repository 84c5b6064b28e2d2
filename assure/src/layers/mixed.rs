//! Random designs of all keys together: what one feature leaves to another compiles in every language, and gives the
//! same bits.

mod agree;
mod calls;
mod draw;
mod programs;
mod words;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use self::agree::differs;
use self::calls::Calls;
use self::draw::{Keys, keys};
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::cpp::STRICT_CPP;
use crate::harness::random::Random;
use crate::harness::runtime;
use crate::harness::selftest::main_program;
use crate::harness::specs::{accepted, calls_a_library, spec};
use crate::harness::{STRICT, empty, in_pairs, rustc, written};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{CLANG, GCC, GXX, PYTHON, RUSTC};

pub(super) const LAYER: Layer = Layer {
    name: "mixed",
    claim: "Random designs of all keys together compile in C, C++ and Rust without a warning, are read by Python, give \
            the bits of the interpreter in each of them, and pass their self-test.",
    tools: &[GCC, GXX, CLANG, RUSTC, PYTHON],
    run,
};

/// Designs that are drawn, of which about half are refused.
const DESIGNS: usize = 280;

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("mixed");
    let python = runtime::python(&context.shared("python"), &["numpy>=1.26"])?;
    let mut random = Random(context.seed);
    let drawn: Vec<_> = (0..DESIGNS).map(|i| keys(&mut random, &format!("mixed{i}"))).collect();
    let drawn = context.in_turn(drawn);
    let told = in_pairs(&drawn, |keys| examined((&folder, &python), context.seed, keys));
    let mut finding = Finding::default();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for (keys, told) in drawn.iter().zip(told) {
        let Some(told) = told? else { continue };
        for (language, fault) in told {
            *counts.entry(language).or_default() += 1;
            let keys: Vec<_> = keys.iter().map(|(key, value)| format!("{key}={value}")).collect();
            finding
                .failures
                .extend(fault.map(|fault| format!("{language}: {}\n{fault}", keys.join("; "))));
        }
    }
    let accepted = counts.get(C).copied().unwrap_or_default();
    finding.summary = format!(
        "{} designs, {accepted} of them accepted, {} faults",
        drawn.len(),
        finding.failures.len()
    );
    finding.failures.truncate(8);
    finding.tables.push(Table {
        title: "Designs that a language expresses".to_owned(),
        head: vec!["examined", "designs"],
        rows: counts.iter().map(|(name, n)| vec![(*name).to_owned(), n.to_string()]).collect(),
    });
    seeded(&folder, &python, &mut finding)?;
    Ok(finding)
}

const C: &str = "C, by gcc and clang";
const CPP: &str = "C++, by g++ and clang++";
const RUST: &str = "Rust, by rustc";
const READ_BY_PYTHON: &str = "Python, by its compiler";
const SELFTEST: &str = "self-test, run";

/// Examinations, by name, with the fault that was found.
type Told = Vec<(&'static str, Option<String>)>;

/// `None` where the design is refused.
fn examined((folder, python): (&Path, &Path), seed: u64, keys: &Keys) -> Result<Option<Told>> {
    let Some((spec, accepted)) = accepted(keys) else { return Ok(None) };
    let home = |language: Language| folder.join(spec.name()).join(language.name());
    let mut told = Vec::new();
    let calls = Calls::of(&spec, seed);
    let wanted = calls.as_ref().map(Calls::interpreted);
    for (name, run, language) in LANGUAGES {
        let Ok(files) = accepted.sources(language, &[]) else { continue };
        let home = empty(&home(language));
        told.push((name, compiled(language, &written(&home, files))?));
        // NumPy has functions of its own.
        let is_same = language != Language::Python || !calls_a_library(&spec);
        if let (true, Some(calls), Some(wanted)) = (is_same, &calls, &wanted) {
            told.push((run, differs(&home, (&spec, calls), (language, python), wanted)?));
        }
    }
    if let Ok(files) = accepted.selftest() {
        let home = home(Language::C);
        written(&home, files);
        told.push((SELFTEST, tested(&home, &spec)?));
    }
    Ok(Some(told))
}

const LANGUAGES: [(&str, &str, Language); 4] = [
    (C, "C, bits of calls", Language::C),
    (CPP, "C++, bits of calls", Language::Cpp),
    (RUST, "Rust, bits of calls", Language::Rust),
    (READ_BY_PYTHON, "Python, bits of calls", Language::Python),
];

/// Returns the messages of the compilers of a language on its files, if any fails.
fn compiled(language: Language, files: &[PathBuf]) -> Result<Option<String>> {
    let with = |program: &str, flags: &[&str], end: &str| {
        let mut command = Command::new(program);
        command.args(flags).arg("-fsyntax-only");
        command.args((end == "hpp").then_some("-xc++"));
        command.args(files.iter().filter(|file| file.extension().is_some_and(|e| e == end)));
        command
    };
    let mut commands: Vec<Command> = match language {
        Language::C => ["gcc", "clang"].map(|program| with(program, &STRICT, "c")).into(),
        Language::Cpp => ["g++", "clang++"].map(|program| with(program, &STRICT_CPP, "hpp")).into(),
        Language::Rust => {
            let mut command = rustc();
            command.args(["--crate-type=lib", "--emit=metadata", "-o"]);
            command.arg(files[0].with_extension("rmeta")).args(files);
            vec![command]
        }
        _ => {
            let mut command = Command::new("python3");
            command.args(["-W", "error", "-m", "py_compile"]).args(files);
            vec![command]
        }
    };
    for command in &mut commands {
        if let Some(fault) = fault(command)? {
            return Ok(Some(fault));
        }
    }
    Ok(None)
}

/// Returns the message of the self-test of a controller in `home`, if it fails.
fn tested(home: &Path, spec: &Spec) -> Result<Option<String>> {
    let (name, program) = (spec.name(), home.join("selftest"));
    let sources = [format!("{name}.c"), format!("{name}_selftest.c")];
    let mut compile = Command::new("gcc");
    compile.args(STRICT).arg("-o").arg(&program).args(sources.map(|file| home.join(file)));
    compile.arg(main_program(home, spec)?).arg("-lm");
    match fault(&mut compile)? {
        Some(fault) => Ok(Some(fault)),
        None => fault(&mut Command::new(program)),
    }
}

/// Returns the messages of a command that fails.
fn fault(command: &mut Command) -> Result<Option<String>> {
    let output = command.output()?;
    let text = String::from_utf8_lossy(&output.stderr);
    Ok((!output.status.success()).then(|| format!("{command:?}: {}\n{text}", output.status)))
}

/// A defect in each language, which its compilers must see.
const DEFECTS: [(Language, Defect); 4] = [
    (Language::C, ("const double past = ", "const float past = ", "C: a time narrowed to float")),
    (
        Language::Cpp,
        ("    Control<double> step(", "    Control<float> step(", "C++: u narrowed to float"),
    ),
    (Language::Rust, ("let past = ", "let past: f32 = ", "Rust: a time narrowed to f32")),
    (Language::Python, ("    def step(", "    def step((", "Python: a bracket that is not closed")),
];

/// A defect in each language, which its calls must show.
const WRONG: [(Language, Defect); 3] = [
    (Language::C, ("inv_r1 = 1.0 / (", "inv_r1 = 1.0000001 / (", "C: a gain off by 1e-7")),
    (Language::Cpp, ("inv_r1 = 1.0 / (", "inv_r1 = 1.0000001 / (", "C++: a gain off by 1e-7")),
    (Language::Rust, ("inv_r1 = 1.0 / (", "inv_r1 = 1.0000001 / (", "Rust: a gain off by 1e-7")),
];

fn seeded(folder: &Path, python: &Path, finding: &mut Finding) -> Result<()> {
    let example = spec(&[("n", "2"), ("mu", "exp_sum(2)"), ("name", "seeded")]);
    for (language, defect) in DEFECTS {
        let files = with_defect(&folder.join("seeded"), &example, language, defect)?;
        let caught = compiled(language, &files)?;
        finding.seed(defect.2, caught.and_then(|text| text.lines().nth(1).map(str::to_owned)));
    }
    let calls = Calls::of(&example, 1).expect("a step");
    let wanted = calls.interpreted();
    for (language, defect) in WRONG {
        let home = folder.join("wrong").join(language.name());
        with_defect(&home, &example, language, defect)?;
        let caught = differs(&home, (&example, &calls), (language, python), &wanted)?;
        finding.seed(defect.2, caught.filter(|text| text.starts_with("call ")));
    }
    Ok(())
}
