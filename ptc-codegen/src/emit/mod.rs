//! Back ends: one staged program in, source text out.
//!
//! A printer ([`print`]) writes expressions and statements; a template places them. A template
//! holds structure and API text, never arithmetic.

mod c;
mod frame;
mod header;
mod plan;
mod print;
mod rust;
mod selftest;

use crate::check::examine::Report;
use crate::law::Law;
use crate::program::{Op, Program, Value};
use crate::selftest::SelfTest;
use crate::spec::Spec;
use plan::{Field, Plan};

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

/// The C files of the self-test of a controller.
pub fn emit_selftest(controller: &Controller<'_>, test: &SelfTest) -> Vec<File> {
    selftest::files(controller, test)
}

/// What `init`, and then `arm`, must find finite: each value in the order of its check, with the
/// name of its field.
pub fn checked_fields(program: &Program) -> [Vec<(Value, String)>; 2] {
    let fields = Plan::new(program).fields;
    let derived = |field: &&Field| is_derived(program, field);
    [false, true].map(|armed| {
        let own = fields.iter().filter(|field| field.armed == armed).filter(derived);
        own.map(|field| (field.value, field.name.clone())).collect()
    })
}

/// Whether a field is to be checked: one that is a parameter as it was given has been checked by
/// its domain, the deadline is checked anyway, and what makes up its rounding is finite with it.
fn is_derived(program: &Program, field: &Field) -> bool {
    let value = program.get(field.value);
    let of_time = |name: &str| matches!(name, "deadline" | "correction");
    !matches!(value.op, Op::Input(_))
        && !(field.armed && value.name.as_ref().is_some_and(|(n, _)| of_time(n)))
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
