//! PLCopen XML: the function block of `st` as a project that programming systems import.

use askama::Template;

use super::st::{Kind, Library, Scope, Unit, library as st_library};
use super::{File, Language, Print, Target, st, text_of, tidy};
use crate::check::examine::Report;
use crate::code::Code;

pub(super) const TARGET: Target = Target {
    language: Language::PlcOpen,
    name: "plcopen",
    about: "the same as a PLCopen XML project, to import",
    comment: ("<!-- ", " -->"),
    print: Print::Around(Language::StructuredText, files),
    ..st::TARGET
};

/// The project, after version 2.01 of the schema of PLCopen's TC6.
#[derive(Template)]
#[template(path = "plcopen/project.xml", escape = "html")]
struct Project<'a> {
    name: &'a str,
    version: &'a str,
    description: &'a str,
    library: &'a Library,
}

fn files(report: &Report, code: &Code) -> Vec<File> {
    let (command, design) = (report.spec.command(), report.spec.fingerprint());
    let project = Project {
        name: &code.name,
        version: env!("CARGO_PKG_VERSION"),
        description: &format!(
            "Design {design}. Made by: ptc-codegen emit --lang {} {command}",
            TARGET.name
        ),
        library: &st_library(code),
    };
    vec![File { name: format!("{}.xml", code.name), text: tidy(&text_of(project.render())) }]
}

impl Scope {
    /// The element of its variables.
    fn element(self) -> &'static str {
        match self {
            Self::Input => "inputVars",
            Self::Output => "outputVars",
            Self::Constant | Self::Local => "localVars",
            Self::Temporary => "tempVars",
        }
    }
}

impl Library {
    /// The functions and the block.
    fn units(&self) -> impl Iterator<Item = &Unit> {
        self.functions.iter().chain([&self.block])
    }
}
