//! The grammar of the command line. Flags of a spec are plain text here: what their values mean,
//! and what is wrong with them, the library says; their help comes from its table of keys.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, FromArgMatches, Parser, Subcommand, ValueEnum};
use ptc_codegen::emit::{Language, Project};
use ptc_codegen::keys::{KEYS, KeyInfo};
use ptc_codegen::program::passes::PASSES;

use super::engine::Engine;
use super::report::{quoted, with_exit_codes};
use super::source::{Source, flag};

/// Generates prescribed-time controllers: closed forms for an order and a time mapping, as source
/// code in C, Rust, C++, MATLAB, Python or Structured Text.
#[derive(Debug, Parser)]
#[command(name = "ptc-codegen", version, arg_required_else_help = true, after_help = with_exit_codes(EXAMPLES))]
pub(crate) struct CommandLine {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  ptc-codegen list                                    the families of time mappings
  ptc-codegen emit --lang c --n 3 --mu exp -o out     out/ptc_exp3.h and out/ptc_exp3.c
  ptc-codegen new roll                                roll.toml, a design file to begin with
  ptc-codegen check roll.toml                         does the design keep its promise?
  ptc-codegen emit roll.toml --lang c -o out          out/roll.h and out/roll.c
  ptc-codegen simulate roll.toml --x0 0.1,0           its closed loop, as CSV
  ptc-codegen verify roll.toml                        its objectives, over scenarios
  ptc-codegen design wish.toml -o roll.toml           chooses mapping and poles for them
  ptc-codegen show matrix --n 4 --mu tanh             the matrix BB_4 and the row b_4";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Generate the source of a controller
    #[command(
        after_help = with_exit_codes(EMIT_EXAMPLES),
        override_usage = "ptc-codegen emit --lang <LANGUAGE> --n <N> --mu <MU> [OPTIONS]\n       \
                          ptc-codegen emit <DESIGN> --lang <LANGUAGE> [OPTIONS]\n       \
                          ptc-codegen emit <DESIGN> --project <PROJECT> [-o <DIR>] [OPTIONS]"
    )]
    Emit(Emit),
    /// Check a design: its mapping, its gains at the deadline, sampling, final error and overflow
    #[command(
        after_help = with_exit_codes(CHECK_EXAMPLES),
        override_usage = "ptc-codegen check <DESIGN> [OPTIONS]\n       \
                          ptc-codegen check --n <N> --mu <MU> [OPTIONS]"
    )]
    Check(Check),
    /// Print the expansions behind a controller
    #[command(
        after_help = with_exit_codes(SHOW_EXAMPLES),
        override_usage = "ptc-codegen show <SUBJECT> --n <N> [--mu <MU>] [--format <FORMAT>]\n       \
                          ptc-codegen show <SUBJECT> <DESIGN> [--format <FORMAT>]"
    )]
    Show(Show),
    /// Run the closed loop of a design with its plant
    #[cfg(feature = "simulation")]
    #[command(
        after_help = with_exit_codes(super::simulate::EXAMPLES),
        override_usage = "ptc-codegen simulate <DESIGN> --x0 <X1,...,XN> [OPTIONS]\n       \
                          ptc-codegen simulate --n <N> --mu <MU> --plant <NAME=VALUE> --x0 <X1,...,XN> [OPTIONS]"
    )]
    Simulate(super::simulate::Simulate),
    /// Verify the closed loop against its objectives, for all that is uncertain
    #[cfg(feature = "campaign")]
    #[command(
        after_help = with_exit_codes(super::verify::EXAMPLES),
        override_usage = "ptc-codegen verify <DESIGN> [OPTIONS]\n       \
                          ptc-codegen verify <DESIGN> --shard <I/N> --out <FILE> [OPTIONS]\n       \
                          ptc-codegen verify <DESIGN> --merge <FILES>... [OPTIONS]"
    )]
    Verify(super::verify::Verify),
    /// Choose the mapping and the poles of a design so that its objectives hold
    #[cfg(feature = "campaign")]
    #[command(
        after_help = with_exit_codes(super::design::EXAMPLES),
        override_usage = "ptc-codegen design <DESIGN> [-o <FILE>] [--tries <COUNT>]"
    )]
    Design(super::design::Request),
    /// Write a design file to begin with, which tells every key
    #[command(after_help = with_exit_codes(NEW_EXAMPLES))]
    New(New),
    /// Print the families of time mappings and their parameters
    #[command(after_help = with_exit_codes(LIST_EXAMPLES))]
    List(List),
    /// Answers one request of the engine `symbolica`, in a process of its own
    #[cfg(feature = "symbolica")]
    #[command(name = super::engine::symbolica::WORKER, hide = true)]
    SymbolicaWorker,
}

const EMIT_EXAMPLES: &str = "\
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
      what the file roll.toml says, but for tau
  ptc-codegen emit --project cortex-m --n 2 --mu exp --name stage
      the folder stage: firmware for a Cortex-M4F, with the controller in a closed loop
  ptc-codegen emit --lang c --n 3 --mu exp -o out --check
      writes nothing; exit code 1 if the files in out are not what would be written";

const LIST_EXAMPLES: &str = "\
Examples:
  ptc-codegen list
  ptc-codegen list --format json";

const CHECK_EXAMPLES: &str = "\
What lacks a value is not checked, and the report says which value. A check that is undecided and not
allowed with --allow does not refuse the design; the exit code is 3.

JSON: {\"name\":\"...\",\"command\":\"...\",\"accepted\":true,\"undecided\":[],\"checks\":[{\"name\":\"growth\",
\"verdict\":\"sound\",\"summary\":\"...\",\"details\":[...],\"fix\":null},...]}; a verdict is sound, unsound,
refuted, undecided or not checked.

Examples:
  ptc-codegen check roll.toml
  ptc-codegen check roll.toml --sample-time 1e-3 --format json
  ptc-codegen check --n 2 --mu \"exp(a=1)\" --poles=-4,-5";

#[derive(Debug, Args)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) design: Design,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    #[command(flatten)]
    pub(crate) engine: EngineFlag,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: ListFormat,
}

/// The engine of a command that needs closed forms.
#[derive(Debug, Args)]
pub(crate) struct EngineFlag {
    /// What expands the closed forms; see docs/engines.md
    #[arg(long, value_enum, value_name = "ENGINE", default_value = "ptc")]
    pub(crate) engine: Engine,
}

/// The design file of a command that can have one.
#[derive(Debug, Args)]
pub(crate) struct Design {
    /// Design file, TOML; a flag stands for the file's key of the same name
    #[arg(value_name = "DESIGN")]
    pub(crate) design: Option<PathBuf>,
}

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
    /// With --lang c: put ACSL contracts into the header, and write NAME_eva.c, which proves with
    /// Frama-C that the code has no error at run time
    #[arg(long)]
    pub(crate) acsl: bool,
    /// Write nothing; exit with 1 if the files in DIR are not what would be written
    #[arg(long)]
    pub(crate) check: bool,
    /// Also write NAME_selftest.c and .h, which test the controller on its target (C only)
    #[arg(long, conflicts_with = "dump")]
    pub(crate) selftest: bool,
    /// Tell in the head of the files what one step costs, from a table of `cargo assure cost`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["dump", "acsl"])]
    pub(crate) cost: Option<PathBuf>,
    /// Print the program after PASS instead of any source (lower: before the first)
    #[arg(long, value_name = "PASS", value_parser = pass_names())]
    pub(crate) dump: Option<String>,
}

/// The passes by name, and the program as it is before them.
fn pass_names() -> Vec<&'static str> {
    std::iter::once("lower").chain(PASSES.iter().map(|pass| pass.name)).collect()
}

/// The languages by name, as the library lists them.
fn languages() -> impl TypedValueParser<Value = Language> {
    let names = Language::ALL.map(|language| PossibleValue::new(language.name()));
    PossibleValuesParser::new(names).try_map(|name| Language::named(&name).ok_or("no language"))
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
    format!("A project that builds as it is, in place of a language: {}", told.join("; "))
}

/// The flag of parameters by name.
const PARAM: &str = "param";

/// The flags of a spec, one for each key of the library's table, and `--param`.
#[derive(Debug)]
pub(crate) struct SpecFlags(pub(crate) Source);

impl FromArgMatches for SpecFlags {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut flags = Self(Source::default());
        flags.update_from_arg_matches(matches)?;
        Ok(flags)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        for info in &KEYS {
            if let Some(text) = matches.get_one::<String>(info.key) {
                self.0.give(info.key, text);
            }
        }
        for text in matches.get_many::<String>(PARAM).into_iter().flatten() {
            self.0.give_parameter(text);
        }
        Ok(())
    }
}

impl Args for SpecFlags {
    fn augment_args(command: clap::Command) -> clap::Command {
        let keys = KEYS.iter().map(|info| {
            Arg::new(info.key)
                .long(flag(info.key).trim_start_matches('-').to_owned())
                .value_name(info.key.to_uppercase())
                .allow_hyphen_values(true)
                .help(help(info.key))
        });
        command.args(keys).arg(
            Arg::new(PARAM)
                .long(PARAM)
                .value_name("NAME=VALUE")
                .action(ArgAction::Append)
                .help("A parameter by its name, as under [params] in a design file; repeatable"),
        )
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

/// The help of a key's flag.
fn help(key: &str) -> String {
    KeyInfo::find(key)
        .map(|info| {
            let (first, rest) = info.meaning.split_at(1);
            let (legal, example) = (info.legal, quoted(info.example));
            format!("{}{rest} [legal: {legal}] [example: {example}]", first.to_uppercase())
        })
        .unwrap_or_default()
}

const SHOW_EXAMPLES: &str = "\
Without --mu the mapping s = kappa is abstract and its derivatives s', s'', s^(3), ... stay symbols
(n up to 30; law up to 16). With --mu the forms are those of a family (n up to 16).

JSON: each form is a list of terms, {\"coefficient\":\"-3/2\",\"exponents\":{\"T\":2}}, its coefficient
exact. Exponents are keyed by the order of the derivative of s, by k for r_k in the abstract
B_{i,j}, and by the symbol's text for all others. The subjects give
  r       {\"r\":[{\"k\":1,\"terms\":[...]},...]}
  R       {\"R\":[{\"k\":0,\"m\":0,\"terms\":[...]},...]}
  bell    {\"B\":[{\"i\":0,\"j\":0,\"terms\":[...]},...]}
  matrix  {\"BB\":[{\"i\":1,\"j\":1,\"terms\":[...]},...],\"b\":[{\"j\":1,\"terms\":[...]},...]}
  law     {\"law\":\"...\",\"K\":[{\"i\":1,\"terms\":[...]},...],\"row\":[{\"j\":1,\"terms\":[...]},...]};
          for exp_sum {\"law\":\"...\",\"r\":[{\"k\":1,\"terms\":[...]},...]}
  tables  {\"A1\":[{\"k\":0,\"m\":0,\"terms\":[...]},...],\"A2\":[{\"k\":1,\"terms\":[...]},...]}

LaTeX is a fragment for a document that uses the package amsmath.

Examples:
  ptc-codegen show r --n 4
  ptc-codegen show bell --n 3 --mu \"exp(a=1)\"
  ptc-codegen show law roll.toml
  ptc-codegen show tables --n 5 --format latex
  ptc-codegen show r --n 8 --format json";

#[derive(Debug, Args)]
pub(crate) struct Show {
    /// What to print
    #[arg(value_enum)]
    pub(crate) subject: Subject,
    #[command(flatten)]
    pub(crate) design: Design,
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        help = "Order of the chain of integrators"
    )]
    pub(crate) n: Option<String>,
    #[arg(long, value_name = "MU", allow_hyphen_values = true, help = help("mu"))]
    pub(crate) mu: Option<String>,
    #[command(flatten)]
    pub(crate) engine: EngineFlag,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: Format,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Subject {
    /// r_1..r_n, the derivatives of mu at the stretched time
    #[value(name = "r")]
    SmallR,
    /// R_{k,m} for 0 <= m <= k < n, in the derivatives of the abstract mapping
    #[value(name = "R")]
    BigR,
    /// The partial Bell polynomials B_{i,j} for 0 <= j <= i <= n
    Bell,
    /// The matrix BB_n and the row b_n
    Matrix,
    /// The linear law
    Law,
    /// R_{k,m} and r_k as two tables, for the abstract mapping
    Tables,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Format {
    Text,
    Latex,
    Json,
}

const NEW_EXAMPLES: &str = "\
The file is a design as it is written: every key is told in a comment, with what is legal.

Examples:
  ptc-codegen new           design.toml
  ptc-codegen new roll      roll.toml, of a controller called roll
  ptc-codegen new -         to the standard output";

#[derive(Debug, Args)]
pub(crate) struct New {
    /// Name of the controller, and of the file before `.toml`; `-` prints to the standard output
    #[arg(value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Folder to write to, made if it is missing; `-` prints to the standard output
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    pub(crate) out: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct List {
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: ListFormat,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum ListFormat {
    Text,
    Json,
}
