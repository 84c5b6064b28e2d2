//! The flags of `emit`.

use std::path::PathBuf;

use crate::emit::{Language, Project};
use crate::program::passes::PASSES;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::cli::flags::{Design, EngineFlag, SpecFlags};

pub(crate) const EXAMPLES: &str = "\
Every parameter is set at run time unless it is fixed here; a fixed one is folded into the code.

Examples:
  ptc-codegen emit --lang c --n 3 --mu exp -o out
      everything set at run time; writes out/ptc_exp3.h and out/ptc_exp3.c
  ptc-codegen emit --lang rust --n 2 --mu \"power(m=2)\" --gains 6,5 --tau 2 --name roll -o src
      m, the gains and tau are fixed; writes src/roll.rs
  ptc-codegen emit --lang c --n 2 --mu \"exp_sum(rates=[0.5,1.5])\" --u-max inf -o -
      fixed rates, no clipping; prints header and source
  ptc-codegen emit --lang python --n 3 --mu exp -o out
      one module on NumPy, for simulation; writes out/ptc_exp3.py
  ptc-codegen emit roll.toml --lang c --param tau=2 -o out
      the design in roll.toml, with another tau
  ptc-codegen emit --project cortex-m --n 2 --mu exp --name stage
      the folder stage: firmware for a Cortex-M4F, with the controller in a closed loop
  ptc-codegen emit --lang c --n 3 --mu exp -o out --check
      writes nothing; exit code 1 if the files in out are not what would be written";

/// What is asked of a generation.
#[derive(Debug, Args)]
pub(crate) struct Emit {
    #[command(flatten)]
    pub(crate) design: Design,
    #[arg(
        long,
        value_parser = languages(),
        value_name = "LANGUAGE",
        required_unless_present = "project",
        help = languages_told()
    )]
    pub(crate) lang: Option<Language>,
    #[arg(
        long,
        value_parser = projects(),
        value_name = "PROJECT",
        conflicts_with = "lang",
        help = projects_told()
    )]
    pub(crate) project: Option<Project>,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    #[command(flatten)]
    pub(crate) engine: EngineFlag,
    /// Folder to write to, made if it is missing; `-` prints to the standard output [default: .;
    /// for a project, which takes a new or an empty one, the controller's name]
    #[arg(short, long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// With --lang c: add ACSL contracts to the header, and write NAME_eva.c, with which Frama-C
    /// proves that the code has no run-time error
    #[arg(long, hide_short_help = true)]
    pub(crate) acsl: bool,
    /// Write nothing; exit with 1 if the files in DIR are not what would be written
    #[arg(long)]
    pub(crate) check: bool,
    /// Also write NAME_selftest.c and .h, which test the controller on its target (C only)
    #[arg(long, conflicts_with = "dump")]
    pub(crate) selftest: bool,
    /// State the cost of one step in the head of the files, from a table of `cargo assure cost`
    #[arg(long, value_name = "FILE", hide_short_help = true, conflicts_with_all = ["dump", "acsl"])]
    pub(crate) cost: Option<PathBuf>,
    /// Also write the resolved design: the design file with what flags give and what the checks chose, which
    /// emits the same files
    #[arg(
        long,
        value_name = "FILE",
        hide_short_help = true,
        conflicts_with_all = ["dump", "check", "engine"]
    )]
    pub(crate) resolved: Option<PathBuf>,
    /// Print the program after PASS instead of any source (lower: before the first)
    #[arg(long, value_name = "PASS", hide_short_help = true, value_parser = pass_names())]
    pub(crate) dump: Option<String>,
}

/// The passes by name, and the program as it is before them.
fn pass_names() -> Vec<&'static str> {
    std::iter::once("lower").chain(PASSES.iter().map(|pass| pass.name)).collect()
}

/// Other names of languages.
const ALSO: [(Language, &[&str]); 5] = [
    (Language::Cpp, &["c++", "cxx"]),
    (Language::Rust, &["rs"]),
    (Language::Python, &["py", "numpy"]),
    (Language::Matlab, &["m", "octave"]),
    (Language::StructuredText, &["scl", "iec61131"]),
];

/// The languages by name, as the library lists them, and by other names that are common.
fn languages() -> impl TypedValueParser<Value = Language> {
    let also = |language: Language| ALSO.iter().find(|(own, _)| *own == language);
    let names = Language::ALL.map(|language| {
        let aliases = also(language).map_or(&[][..], |(_, names)| *names);
        PossibleValue::new(language.name()).aliases(aliases.iter().copied())
    });
    PossibleValuesParser::new(names).try_map(|name| {
        let other = ALSO.iter().find(|(_, names)| names.contains(&name.as_str()));
        Language::named(&name).or(other.map(|(language, _)| *language)).ok_or("no language")
    })
}

fn languages_told() -> String {
    let told = Language::ALL.map(|language| format!("{} is {}", language.name(), language.about()));
    format!("Language of the source: {}", told.join("; "))
}

/// The kinds of projects by name.
fn projects() -> impl TypedValueParser<Value = Project> {
    let names = Project::ALL.map(|project| PossibleValue::new(project.name()));
    PossibleValuesParser::new(names).try_map(|name| Project::named(&name).ok_or("no project"))
}

fn projects_told() -> String {
    let told = Project::ALL.map(|project| format!("{} is {}", project.name(), project.about()));
    format!("A ready-to-build project, in place of a language: {}", told.join("; "))
}
