//! Rust: one `no_std` file, or the items of the macro.

use super::{Language, Print, Target, code};
use crate::parameter::Precision;
use crate::request::Spec;

pub(super) const TARGET: Target = Target {
    language: Language::Rust,
    name: "rust",
    about: "one no_std file that stands alone",
    comment: ("/* ", " */"),
    is_word: |_| false,
    refuse: |_, _, _| {},
    print: Print::Program(|program| vec![code::rust(program)]),
};

/// The type of numbers.
pub(super) fn real(spec: &Spec) -> &'static str {
    match spec.precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    }
}
