//! The languages, and what is known of the back end of each.

use super::declared::{Element, element};
use super::{File, c, cpp, fmu, matlab, plcopen, python, rust, st};
use crate::check::examine::Report;
use crate::code::Code;
use crate::diagnostic::Diagnostics;
use crate::program::Program;
use crate::request::Spec;

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Language {
    /// C99: a header and a source file.
    C,
    /// Rust, `no_std`: one self-contained file.
    Rust,
    /// C++17: one header.
    Cpp,
    /// MATLAB and GNU Octave: a function file for each function.
    Matlab,
    /// Python on NumPy: one typed module.
    Python,
    /// IEC 61131-3 Structured Text: a function block.
    StructuredText,
    /// The same in PLCopen XML: a project to import.
    PlcOpen,
    /// An FMU after FMI 2.0: its files by their paths in the archive, without a library.
    Fmu2,
    /// An FMU after FMI 3.0, likewise.
    Fmu3,
}

/// The back ends, in the order of [`Language`].
const TARGETS: [Target; 9] = [
    c::TARGET,
    rust::TARGET,
    cpp::TARGET,
    matlab::TARGET,
    python::TARGET,
    st::TARGET,
    plcopen::TARGET,
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

    pub(super) fn target(self) -> &'static Target {
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

    /// Describes the emitted files in a few words.
    pub fn about(self) -> &'static str {
        self.target().about
    }

    /// The version of FMI, of an FMU.
    #[doc(hidden)]
    pub fn fmi(self) -> Option<fmu::Version> {
        match self {
            Self::Fmu2 => Some(fmu::Version::Two),
            Self::Fmu3 => Some(fmu::Version::Three),
            _ => None,
        }
    }

    /// Returns the syntax of an array element, counted from 0.
    pub(super) fn element(self) -> Element {
        match self {
            Self::Matlab => |name, index| format!("{name}({})", index + 1),
            Self::StructuredText => |name, index| format!("{name}[{}]", index + 1),
            _ => element,
        }
    }

    /// Returns the opening and closing delimiters of a comment line.
    #[doc(hidden)]
    pub fn comment(self) -> (&'static str, &'static str) {
        self.target().comment
    }
}

/// A back end: what is known of it before there is a program, and its printer.
pub(super) struct Target {
    pub(super) language: Language,
    /// Name on the command line.
    pub(super) name: &'static str,
    /// Short description of the emitted files.
    pub(super) about: &'static str,
    /// Opening and closing delimiters of a comment line.
    pub(super) comment: (&'static str, &'static str),
    /// Tests whether a word that other languages leave free has a meaning in this one.
    pub(super) is_word: fn(&str) -> bool,
    /// Notes what it cannot express.
    pub(super) refuse: fn(&Spec, Option<&Program>, &mut Diagnostics),
    /// Printer of its files.
    pub(super) print: Print,
}

/// Printer of files.
pub(super) enum Print {
    /// A program is printed.
    Program(fn(&Code) -> Vec<File>),
    /// Files around the code of a controller in another language.
    Around(Language, fn(&Report, &Code) -> Vec<File>),
    /// No source: an FMU is made by [`super::emit_fmu`] alone, so that who emits sources does not link it.
    Fmu,
}

#[cfg(test)]
mod tests {
    use super::{Language, TARGETS};

    #[test]
    fn targets_follow_the_order_of_languages() {
        for (index, target) in TARGETS.iter().enumerate() {
            assert_eq!(target.language as usize, index);
            assert_eq!(Language::named(target.name), Some(target.language));
        }
    }
}
