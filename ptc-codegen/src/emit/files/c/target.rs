//! C99: a header and a source file.

use super::super::{Controller, File, Language, Print, Target, acsl, eva, program};
use super::Notes;
use crate::code::Code;
use crate::parameter::Precision;
use crate::request::Spec;

pub(in crate::emit) const TARGET: Target = Target {
    language: Language::C,
    name: "c",
    about: "a header and a source file, C99",
    comment: ("/* ", " */"),
    is_word: |_| false,
    refuse: |spec, _, found| super::refuse_macros(spec, found),
    print: Print::Program(|program| super::files(program, &Notes::default())),
};

/// The header and the source with contracts and case splits in comments, and the harness of the proof.
pub(in crate::emit) fn files_with_proof(controller: &Controller<'_>) -> Vec<File> {
    let program = program(controller, Language::C);
    let mut files = super::files(&program, &acsl::notes(controller, &program));
    files.push(eva::harness(controller, &program));
    files
}

/// The same of a controller in samples.
pub(in crate::emit) fn sampled_files_with_proof(spec: &Spec, program: &Code) -> Vec<File> {
    let mut files = super::files(program, &acsl::in_samples(program));
    files.push(eva::in_samples(spec, program));
    files
}

/// The type of numbers.
pub(in crate::emit) fn real(precision: Precision) -> &'static str {
    match precision {
        Precision::F32 => "float",
        Precision::F64 => "double",
    }
}
