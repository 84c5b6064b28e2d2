//! FMI 2.0 and 3.0: a co-simulation FMU around the C of a controller.
//!
//! Text files are made here, by the paths in the archive; the command line compiles and packs it.

mod parts;
mod signals;
mod steering;
mod template;
mod units;
mod variables;

use askama::Template;

use super::c::{Notes, files as c, refuse_macros};
use super::example::Example;
use super::{File, Language, Print, Target, stands_alone, text_of, tidy};
use crate::check::examine::Report;
use crate::code::Code;
use crate::diagnostic::Diagnostics;
use crate::program::Program;
use crate::request::{Spec, hash};
use parts::Parts;
use signals::{Signal, Signals};
use template::Build;

/// A version of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

impl Version {
    pub(super) fn target(self) -> &'static Target {
        match self {
            Self::Two => &TARGET_2,
            Self::Three => &TARGET_3,
        }
    }

    /// The headers of the interface, which an importer has; no FMU holds them.
    pub fn headers(self) -> Vec<File> {
        let headers: [(&str, &str); 3] = match self {
            Self::Two => [
                (
                    "fmi2TypesPlatform.h",
                    include_str!("../../../../templates/fmu/fmi2TypesPlatform.h"),
                ),
                (
                    "fmi2FunctionTypes.h",
                    include_str!("../../../../templates/fmu/fmi2FunctionTypes.h"),
                ),
                ("fmi2Functions.h", include_str!("../../../../templates/fmu/fmi2Functions.h")),
            ],
            Self::Three => [
                (
                    "fmi3PlatformTypes.h",
                    include_str!("../../../../templates/fmu/fmi3PlatformTypes.h"),
                ),
                (
                    "fmi3FunctionTypes.h",
                    include_str!("../../../../templates/fmu/fmi3FunctionTypes.h"),
                ),
                ("fmi3Functions.h", include_str!("../../../../templates/fmu/fmi3Functions.h")),
            ],
        };
        let file = |(name, text): (&str, &str)| File { name: name.into(), text: text.into() };
        headers.into_iter().map(file).collect()
    }
}

/// FMI 2.0.
pub(super) const TARGET_2: Target = Target {
    language: Language::Fmu2,
    name: "fmu2",
    about: "an FMU for co-simulation after FMI 2.0",
    ..TARGET_3
};

/// FMI 3.0.
pub(super) const TARGET_3: Target = Target {
    language: Language::Fmu3,
    name: "fmu3",
    about: "one after FMI 3.0",
    comment: ("/* ", " */"),
    is_word,
    refuse,
    print: Print::Fmu,
};

fn refuse(spec: &Spec, _: Option<&Program>, found: &mut Diagnostics) {
    refuse_macros(spec, found);
    stands_alone(spec, "an FMU", found);
    let signals = Signals::of(spec);
    for parameter in spec.parameters() {
        let name = parameter.spelling();
        let of = |all: &[Signal]| all.iter().any(|signal| signal.name == name);
        let message = match (of(&signals.references), signals.all().any(|own| own.name == name)) {
            (true, _) => format!("the FMU has an input {name}, the reference"),
            (false, true) => format!("the FMU has another variable {name}"),
            (false, false) => continue,
        };
        let help = "give the parameter another name";
        found.push("not-alone", format!("params.{name}"), None, message, help);
    }
}

/// The names of outputs, and those of the types in the source of the interface.
fn is_word(word: &str) -> bool {
    matches!(word, "time" | "u" | "time_to_go" | "status" | "State" | "Instance")
}

/// The files of the FMU of a controller, by their paths in it, without a binary.
pub(super) fn files(report: &Report, code: &Code, version: Version) -> Vec<File> {
    let name = report.spec.name();
    // The token is a hash of all that the FMU says, itself left out.
    let example = Example::of(report);
    let parts = Parts::new(&report.spec, code, version, &example);
    let token = token(parts.files("").iter().map(|file| file.text.as_str()));
    let mut files = parts.files(&token);
    let at_source = |file: File| File { name: format!("sources/{}", file.name), ..file };
    files.extend(c(code, &Notes::default()).into_iter().map(at_source));
    if version == Version::Three {
        let build = Build { name: &name };
        files.push(file("sources/buildDescription.xml", build.render()));
    }
    files
}

fn file(name: &str, text: askama::Result<String>) -> File {
    File { name: name.to_owned(), text: tidy(&text_of(text)) }
}

/// A token in the form of a UUID: the hash of the texts.
fn token<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let digits = format!("{:032x}", hash(texts));
    let [a, b, c, d] = [8, 12, 16, 20];
    format!(
        "{{{}-{}-{}-{}-{}}}",
        &digits[..a],
        &digits[a..b],
        &digits[b..c],
        &digits[c..d],
        &digits[d..]
    )
}
