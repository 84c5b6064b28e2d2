//! Back ends: one staged program in, source text out.
//!
//! A printer ([`print`]) writes expressions and statements; a template places them. A template
//! holds structure and API text, never arithmetic.

mod acsl;
mod c;
mod cpp;
mod declared;
mod eva;
mod example;
pub mod fmu;
mod formulas;
mod frame;
mod header;
mod matlab;
pub mod measured;
mod plan;
mod print;
mod project;
mod python;
mod rust;
mod selftest;
mod st;
#[cfg(test)]
mod table;

pub use project::Project;

use crate::check::examine::Report;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::internal::fault;
use crate::law::Law;
use crate::program::{Op, Program, Value, digits};
use crate::selftest::SelfTest;
use crate::spec::{After, Feedback, Parameter, Precision, Spec, What};
use declared::{Declared, declared};
use frame::Frame;
use plan::{Field, Plan};

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// C99: a header and a source file.
    C,
    /// Rust, `no_std`: one file that stands alone.
    Rust,
    /// C++17: one header.
    Cpp,
    /// MATLAB and GNU Octave: a function file for each function.
    Matlab,
    /// Python on NumPy: one typed module.
    Python,
    /// IEC 61131-3 Structured Text: a function block.
    StructuredText,
    /// An FMU after FMI 2.0: its files by their paths in the archive, without a library.
    Fmu2,
    /// An FMU after FMI 3.0, likewise.
    Fmu3,
}

/// The back ends, in the order of [`Language`].
const TARGETS: [Target; 8] = [
    c::TARGET,
    rust::TARGET,
    cpp::TARGET,
    matlab::TARGET,
    python::TARGET,
    st::TARGET,
    fmu::TARGET_2,
    fmu::TARGET_3,
];

impl Language {
    /// Every language.
    pub const ALL: [Self; TARGETS.len()] = {
        let mut all = [Self::C; TARGETS.len()];
        let mut index = 0;
        while index < TARGETS.len() {
            all[index] = TARGETS[index].language;
            index += 1;
        }
        all
    };

    fn target(self) -> &'static Target {
        // A test holds the table in the order of the enum.
        &TARGETS[self as usize]
    }

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        self.target().name
    }

    /// The language of this name on the command line.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.name() == name)
    }

    /// What is emitted, in a few words.
    pub fn about(self) -> &'static str {
        self.target().about
    }

    /// The version of FMI, of an FMU.
    pub fn fmi(self) -> Option<fmu::Version> {
        match self {
            Self::Fmu2 => Some(fmu::Version::Two),
            Self::Fmu3 => Some(fmu::Version::Three),
            _ => None,
        }
    }

    /// What opens and what closes a comment line.
    pub fn comment(self) -> (&'static str, &'static str) {
        self.target().comment
    }
}

/// A back end: what is known of it before there is a program, and its printer.
struct Target {
    language: Language,
    /// Name on the command line.
    name: &'static str,
    /// What is emitted, in a few words.
    about: &'static str,
    /// What opens and closes a comment line.
    comment: (&'static str, &'static str),
    /// Whether a word that other languages leave free means something in this one.
    is_word: fn(&str) -> bool,
    /// Notes what it cannot express.
    refuse: fn(&Controller<'_>, &mut Diagnostics),
    /// The files of a controller.
    files: fn(&Controller<'_>) -> Vec<File>,
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
    /// What a step was measured to cost, for the head of the emitted files.
    pub measured: &'a [measured::Measured],
}

impl<'a> Controller<'a> {
    /// What was asked for.
    pub fn spec(&self) -> &'a Spec {
        &self.report.spec
    }
}

/// Notes what keeps `what`, around the controller of `spec`, from standing alone: it can call no
/// function of the user's, and needs a controller.
fn stands_alone(spec: &Spec, what: &str, found: &mut Diagnostics) {
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
        let message = format!("{what} has no function of yours to call after the deadline");
        against("after", message, own);
    }
}

/// The files of a controller in `language`.
///
/// # Errors
/// A name that is a word of the language, and each feature that it cannot express; there are none in
/// C and Rust.
pub fn emit(controller: &Controller<'_>, language: Language) -> Result<Vec<File>, Vec<Diagnostic>> {
    let target = language.target();
    let mut found = Diagnostics::default();
    for (key, word) in names(controller.spec()) {
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
    (target.refuse)(controller, &mut found);
    if let Some(message) = digits::lost(controller.program) {
        let help = "the fixed parameters and gains are too far from 1 together: take other units, of \
                    time for example, or leave some of them to run time";
        found.push("no-digits", "gains", None, message, help);
    }
    found.finish(Some(()))?;
    Ok((target.files)(controller))
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
    selftest::files(controller, test)
}

/// A condition of `init` or `arm` on what they compute.
pub struct Checked {
    check: digits::Condition,
    /// The condition as it is emitted in C.
    pub condition: String,
}

impl Checked {
    /// The values it looks at.
    pub fn values(&self) -> Vec<Value> {
        self.check.values()
    }

    /// Whether it holds for numbers of those values.
    pub fn holds(&self, numbers: &[f64], precision: Precision) -> bool {
        self.check.holds(numbers, precision)
    }

    /// Whether it looks at the end of the range only where a factor is not 0.
    pub fn has_factors(&self) -> bool {
        matches!(self.check, digits::Condition::Kept(..))
    }
}

/// What `init`, and then `arm`, check of what they compute, in the order of the checks.
pub fn checked(controller: &Controller<'_>) -> [Vec<Checked>; 2] {
    let (spec, program) = (controller.spec(), controller.program);
    let frame = Frame::new(controller, c::real(spec), &c::C::new(spec));
    let plan = Plan::new(program, str::to_owned);
    let finite = |armed: bool| {
        let fields = plan.fields.iter().filter(move |field| field.armed == armed);
        fields.filter(|f| is_derived(program, f)).map(|f| digits::Condition::Finite(f.value))
    };
    let init = digits::checks(spec, program).into_iter().chain(finite(false));
    let armed = frame.latched_fields.iter().map(|field| format!("isfinite({field})"));
    let with = |check, condition| Checked { check, condition };
    [
        init.zip(frame.finite).map(|(check, text)| with(check, text)).collect(),
        finite(true).zip(armed).map(|(check, text)| with(check, text)).collect(),
    ]
}

/// Whether a field is to be checked: one that is a parameter as it was given has been checked by
/// its domain, the deadline is checked anyway, and what makes up its rounding is finite with it.
fn is_derived(program: &Program, field: &Field) -> bool {
    let value = program.get(field.value);
    let of_time = |name: &str| matches!(name, "deadline" | "correction");
    let is_time = field.armed && value.name.as_ref().is_some_and(|(n, _)| of_time(n));
    let is_given = matches!(value.op, Op::Input(_));
    !is_time && !is_given
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

/// The text of a template.
fn text_of(rendered: askama::Result<String>) -> String {
    rendered.unwrap_or_else(|error| fault(format!("a template could not be filled: {error}")))
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

#[cfg(test)]
mod tests {
    use super::{Language, TARGETS};

    #[test]
    fn targets_are_in_the_order_of_the_languages() {
        for (index, target) in TARGETS.iter().enumerate() {
            assert_eq!(target.language as usize, index);
            assert_eq!(Language::named(target.name), Some(target.language));
        }
    }
}
