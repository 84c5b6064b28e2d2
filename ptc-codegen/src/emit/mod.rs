//! Back ends: one staged program in, source text out.
//!
//! A printer ([`print`]) writes expressions and statements; a template places them. A template
//! holds structure and API text, never arithmetic.

mod acsl;
mod c;
mod eva;
mod frame;
mod header;
mod plan;
mod print;
mod rust;

use crate::check::examine::Report;
use crate::law::Law;
use crate::program::Program;
use crate::spec::Spec;

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// C99: a header and a source file.
    C,
    /// Rust, `no_std`: one file that stands alone.
    Rust,
}

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// File name, without a folder.
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

/// The files of a controller in `language`.
pub fn emit(controller: &Controller<'_>, language: Language) -> Vec<File> {
    match language {
        Language::C => c::files(controller),
        Language::Rust => vec![rust::file(controller)],
    }
}

/// The C files of a controller with contracts and case splits in comments, and a harness with which
/// Frama-C's plug-in Eva proves that they have no error at run time.
pub fn emit_with_proof(controller: &Controller<'_>) -> Vec<File> {
    c::files_with_proof(controller)
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
