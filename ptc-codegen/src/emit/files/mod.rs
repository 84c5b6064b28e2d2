//! The files of a controller in every language, with their heads, and the files around them: proofs, self-tests,
//! FMUs, projects, whose text is in templates.

mod acsl;
mod apart;
mod c;
mod called;
#[cfg(feature = "lab")]
pub mod campaign;
mod cpp;
mod eva;
mod example;
pub mod fmu;
mod head;
mod language;
mod legal;
mod literal;
mod matlab;
mod outline;
mod plcopen;
mod project;
mod python;
#[cfg(feature = "urdf")]
mod robot;
mod rust;
mod selftest;
mod st;
#[cfg(test)]
mod table;

pub use head::coupled;
pub use language::Language;
use language::{Print, Target};
pub use project::Project;
#[cfg(feature = "urdf")]
pub use robot::emit_robot;

use super::code::{block, gives, text};
use super::declared::declared;
use super::{declared, in_samples, in_time, tidy};
use crate::check::examine::Report;
use crate::code::Code;
use crate::controller::Controller;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::internal::fault;
use crate::parameter::Parameter;
use crate::program::{Program, digits};
use crate::request::{After, Feedback, Late, Spec, What};
use crate::selftest::SelfTest;

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// File name; in an FMU or a project the path, its folders separated by `/`.
    pub name: String,
    /// Contents.
    pub text: String,
}

/// The program of a controller, with its head and parameters in the words of `language`.
fn program(controller: &Controller<'_>, language: Language) -> Code {
    in_time(controller, head::lines(controller, language), language.element())
}

/// The same of a controller in samples.
fn program_in_samples(report: &Report, language: Language) -> Code {
    in_samples(&report.spec, &|sampled, code| {
        head::lines_in_samples(report, sampled, code, language)
    })
}

/// Notes what keeps `what`, around the controller of `spec`, from standing alone: it can call no
/// function of the user's, and needs a controller.
fn stands_alone(spec: &Spec, what: &str, found: &mut Diagnostics) {
    let mut against = |key: &str, message: String, help: &str| {
        found.push("not-alone", key, None, message, help);
    };
    let own = "emit C or Rust instead, and call the controller from your own program";
    if spec.what == What::Associated {
        let message = format!("{what} holds a controller, not the infinite-time system");
        against("what", message, "leave `what` out, or emit C or Rust");
    }
    if spec.what == What::Observer {
        let message = format!("{what} holds a controller, not an observer alone");
        against("what", message, "leave `what` out, or emit the observer in a language");
    }
    if spec.what == What::Filter {
        let message = format!("{what} holds a controller, not a filter alone");
        against("what", message, "leave `what` out, or emit the filter in a language");
    }
    if spec.feedback == Feedback::Extern {
        against("pi0", format!("{what} cannot call a user-defined pi0"), own);
    }
    if spec.after == After::Extern {
        let message = format!("{what} cannot call a user-defined law after the deadline");
        against("after", message, own);
    }
}

/// The source files of a controller in `language`.
///
/// # Errors
/// A name that is a word of the language, and each feature that it cannot express; there are none in
/// C and Rust.
pub fn emit(controller: &Controller<'_>, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepts(language.target(), controller.spec(), Some(controller.program))?;
    printed(language, controller.report, |language| program(controller, language))
}

/// The files of the FMU of a controller, by their paths in it, without a binary.
///
/// # Errors
/// As [`emit`].
pub fn emit_fmu(
    controller: &Controller<'_>,
    version: fmu::Version,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepts(version.target(), controller.spec(), Some(controller.program))?;
    Ok(fmu::files(controller.report, &program(controller, Language::C), version))
}

/// The same of a controller in samples.
///
/// # Errors
/// As [`emit`].
pub fn emit_sampled_fmu(
    report: &Report,
    version: fmu::Version,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepts(version.target(), &report.spec, None)?;
    Ok(fmu::files(report, &sampled_c(report), version))
}

/// The files of the controller whose program in a language is `program`, unless a word that is only
/// known once they are printed has two meanings in them.
fn printed(
    language: Language,
    report: &Report,
    program: impl Fn(Language) -> Code,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    let (of, files) = match language.target().print {
        Print::Program(print) => (language, print(&program(language))),
        Print::Around(of, files) => (of, files(report, &program(of))),
        Print::Fmu => fault("an FMU is no source file"),
    };
    if of == Language::StructuredText {
        st::names_itself(&report.spec, &st::file(&program(of)), &mut found);
    }
    found.finish(Some(files))
}

/// Checks that a language can express the controller of `spec`: by the names in it, and by its program, unless the
/// clock counts samples.
fn accepts(target: &Target, spec: &Spec, program: Option<&Program>) -> Result<(), Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    for (key, word) in names(spec) {
        if (target.is_word)(&word) {
            found.push(
                "reserved-name",
                key,
                None,
                format!("{word} has a meaning of its own in {}", target.name),
                format!("give it another name, for example {word}_1"),
            );
        }
    }
    (target.refuse)(spec, program, &mut found);
    if let Some(message) = program.and_then(digits::lost) {
        let help = "the fixed parameters and gains are too far from 1 together: take other units, of \
                    time for example, or leave some of them to run time";
        found.push("no-digits", "gains", None, message, help);
    }
    found.finish(Some(()))
}

/// The source files of a controller in samples in `language`.
///
/// # Errors
/// As [`emit`].
pub fn emit_sampled(report: &Report, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    accepts(language.target(), &report.spec, None)?;
    printed(language, report, |language| program_in_samples(report, language))
}

/// Notes that a language, called `name`, has no fused multiply-add.
fn refuse_fma(spec: &Spec, name: &str, found: &mut Diagnostics) {
    if spec.fma {
        let message = format!("{name} has no fused multiply-add");
        let help = "leave `fma` out, or emit c, cpp, rust, fmu2 or fmu3";
        found.push("unsupported", "fma", None, message, help);
    }
}

/// Notes a name whose class is called as one of the `others`, or as a value of its methods: T, E, K1,
/// K2, ...
fn refuse_class(spec: &Spec, others: &[&str], found: &mut Diagnostics) {
    let (name, class) = (spec.name(), spec.type_name());
    let digits = class.strip_prefix('K').filter(|digits| !digits.is_empty());
    let is_gain = digits.is_some_and(|d| d.bytes().all(|b| b.is_ascii_digit()));
    if is_gain || matches!(class.as_str(), "T" | "E") || others.contains(&class.as_str()) {
        let message = format!("the class of {name} would be {class}, which is another thing there");
        let help = format!("give it another name, for example {name}_1");
        found.push("reserved-name", "name", None, message, help);
    }
}

/// The names that the user gave, or that were made for him, each by its key.
fn names(spec: &Spec) -> Vec<(String, String)> {
    let named = spec.parameters().into_iter().filter_map(|parameter| match parameter {
        Parameter::Named(name) => Some((format!("params.{name}"), name.text().to_owned())),
        _ => None,
    });
    named.chain([("name".to_owned(), spec.name())]).collect()
}

/// The C files of the self-test of a controller.
pub fn emit_selftest(controller: &Controller<'_>, test: &SelfTest) -> Vec<File> {
    selftest::in_time(controller, test)
}

/// The C files of the self-test of a controller in samples, from its [`sampled_c`].
pub fn emit_sampled_selftest(
    spec: &Spec,
    code: &Code,
    test: &crate::selftest::samples::SelfTest,
) -> Vec<File> {
    selftest::in_samples(spec, code, test)
}

/// The program of a controller in samples as its C prints it.
pub fn sampled_c(report: &Report) -> Code {
    program_in_samples(report, Language::C)
}

/// The C files of a controller with contracts and case splits in comments, and a harness with which
/// Frama-C's plug-in Eva proves that they have no error at run time.
///
/// # Errors
/// A duration that changes in flight, which has no contracts.
pub fn emit_with_proof(controller: &Controller<'_>) -> Result<Vec<File>, Vec<Diagnostic>> {
    has_contracts(controller.spec())?;
    Ok(c::files_with_proof(controller))
}

/// The same of a controller in samples, from its [`sampled_c`].
///
/// # Errors
/// A deadline that changes in flight, which has no contracts.
pub fn emit_sampled_with_proof(spec: &Spec, code: &Code) -> Result<Vec<File>, Vec<Diagnostic>> {
    has_contracts(spec)?;
    Ok(c::sampled_files_with_proof(spec, code))
}

/// Refuses contracts of a deadline that changes in flight.
fn has_contracts(spec: &Spec) -> Result<(), Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    let late = spec.sampled().and_then(|own| own.flight.as_ref()).map(|flight| flight.late);
    if spec.in_flight || late.is_some() {
        let key = if late.is_none_or(|late| late == Late::Clip) { "in_flight" } else { "late" };
        let message = "a deadline that changes in flight has no contracts yet";
        let help = format!("leave `{key}` out, or emit C without contracts");
        found.push("unsupported", key, None, message, help);
    }
    found.finish(Some(()))
}

/// The mapping, its closed forms and the law of a controller in time, as they are in a head.
pub fn formulas(controller: &Controller<'_>) -> Vec<String> {
    let mut lines = head::mapping(controller);
    if controller.spec().what != What::Associated {
        lines.extend(head::law(controller));
    }
    lines.into_iter().skip_while(String::is_empty).collect()
}

/// The same of a controller in samples; empty for an observer alone.
pub fn sampled_formulas(report: &Report) -> Vec<String> {
    head::formulas_in_samples(report)
}

/// The plant, the law and the observer of a controller in samples, as the head of its files has them.
#[cfg(feature = "cli")]
pub(crate) fn sampled_law(spec: &Spec) -> Vec<String> {
    head::law_in_samples(spec)
}

/// The text of a template.
pub(super) fn text_of(rendered: askama::Result<String>) -> String {
    rendered.unwrap_or_else(|error| fault(format!("a template could not be filled: {error}")))
}
