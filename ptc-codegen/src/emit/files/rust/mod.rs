//! Rust: one `no_std` file, or the items of the macro.

mod module;

use super::super::code::rust::items;
use super::{File, Language, Print, Target};
use crate::code::Code;
use crate::parameter::Precision;
use crate::request::Spec;

pub(super) const TARGET: Target = Target {
    language: Language::Rust,
    name: "rust",
    about: "one no_std file that stands alone",
    comment: ("/* ", " */"),
    is_word: |_| false,
    refuse: |_, _, _| {},
    print: Print::Program(|program| vec![file(program)]),
};

/// The file, whose types are its own.
fn file(code: &Code) -> File {
    let text = module::text(&code.head, code.precision, &items(code, ""));
    File { name: format!("{}.rs", code.name), text }
}

/// The type of numbers.
pub(super) fn real(spec: &Spec) -> &'static str {
    match spec.precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    }
}
