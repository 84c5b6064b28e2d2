//! Back ends: one staged program in, source text out.
//!
//! A printer ([`print`]) writes expressions and statements; a template places them. A template
//! holds structure and API text, never arithmetic.

mod c;
mod domain;
mod example;
pub mod fmu;
mod frame;
mod header;
mod plan;
mod print;
mod rust;

use crate::check::examine::Report;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::law::Law;
use crate::program::Program;
use crate::spec::{After, Feedback, Spec, What};

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// C99: a header and a source file.
    C,
    /// Rust, `no_std`: one file that stands alone.
    Rust,
    /// An FMU after FMI 2.0: its files by their paths in the archive, without a binary.
    Fmu2,
    /// An FMU after FMI 3.0, likewise.
    Fmu3,
}

impl Language {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::C => "c",
            Self::Rust => "rust",
            Self::Fmu2 => "fmu2",
            Self::Fmu3 => "fmu3",
        }
    }

    /// The version of FMI, of an FMU.
    pub fn fmi(self) -> Option<fmu::Version> {
        match self {
            Self::Fmu2 => Some(fmu::Version::Two),
            Self::Fmu3 => Some(fmu::Version::Three),
            Self::C | Self::Rust => None,
        }
    }
}

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// File name; in an FMU or a project the path, its folders separated by `/`.
    pub name: String,
    /// Contents.
    pub text: String,
}

/// Everything that a back end is given.
#[derive(Clone, Copy, Debug)]
pub struct Controller<'a> {
    /// What was asked for, and what the checks say of it.
    pub report: &'a Report,
    /// The law, for the documentation in the emitted code.
    pub law: &'a Law,
    /// The optimised program.
    pub program: &'a Program,
}

impl<'a> Controller<'a> {
    /// What was asked for.
    pub fn spec(&self) -> &'a Spec {
        &self.report.spec
    }
}

/// Whether `what`, around the controller, stands alone: it can call no function of the user's, and
/// needs a controller.
///
/// # Errors
/// What of the spec stands against it.
pub fn stands_alone(spec: &Spec, what: &str) -> Result<(), Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    let mut against = |key: &str, message: String, help: &str| {
        found.push("not-alone", key, None, message, help);
    };
    let own = "emit C or Rust instead, and call the controller from a program of yours";
    if spec.what == What::Associated {
        let message = format!("{what} holds a controller, not the infinite-time system");
        against("what", message, "leave `what` out, or emit C or Rust");
    }
    if spec.feedback == Feedback::Extern {
        against("pi0", format!("{what} has no function of yours to call for pi0"), own);
    }
    if spec.after == After::Extern {
        against(
            "after",
            format!("{what} has no function of yours to call after the deadline"),
            own,
        );
    }
    found.finish(Some(()))
}

/// Whether a spec can be emitted in `language`.
///
/// # Errors
/// What of the spec stands against it.
pub fn can_be(spec: &Spec, language: Language) -> Result<(), Vec<Diagnostic>> {
    match language {
        Language::C | Language::Rust => Ok(()),
        Language::Fmu2 | Language::Fmu3 => fmu::can_be(spec),
    }
}

/// The files of a controller in `language`.
pub fn emit(controller: &Controller<'_>, language: Language) -> Vec<File> {
    match language {
        Language::C => c::files(controller),
        Language::Rust => vec![rust::file(controller)],
        Language::Fmu2 => fmu::files(controller, fmu::Version::Two),
        Language::Fmu3 => fmu::files(controller, fmu::Version::Three),
    }
}

/// The items of the Rust file on the types of the facade crate `ptc`.
pub fn emit_items(controller: &Controller<'_>) -> String {
    rust::items(controller)
}

/// A parameter as an emitted struct declares it.
struct Declared {
    name: &'static str,
    /// Length of an array; none for a scalar.
    length: Option<usize>,
    meaning: &'static str,
    unit: &'static str,
    domain: &'static str,
}

/// The run-time parameters in the order of the emitted struct, arrays taken together.
fn declared(spec: &Spec) -> Vec<Declared> {
    let mut declared: Vec<Declared> = Vec::new();
    for parameter in spec.run_time_parameters() {
        let key = parameter.key();
        let length = parameter.index().map(|index| index + 1);
        match declared.last_mut() {
            Some(last) if last.name == key => last.length = length,
            _ => declared.push(Declared {
                name: key,
                length,
                meaning: parameter.meaning(),
                unit: parameter.unit(),
                domain: spec.domain(parameter).text(),
            }),
        }
    }
    declared
}

/// Template text without trailing spaces and with one newline at its end.
fn tidy(text: &str) -> String {
    let mut lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    while lines.last().is_some_and(|line| line.is_empty()) {
        lines.pop();
    }
    lines.dedup_by(|a, b| a.is_empty() && b.is_empty());
    let mut text = lines.join("\n");
    text.push('\n');
    text
}
