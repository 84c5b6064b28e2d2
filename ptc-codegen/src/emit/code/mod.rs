//! Printers of whole controllers: one file a language, from the statements of [`Code`].
//!
//! [`Code`]: crate::code::Code

mod block;
mod c;
mod cpp;
mod elimination;
mod expression;
mod gives;
mod legal;
mod matlab;
mod powers;
mod python;
mod rust;
mod short;
mod st;
mod text;

pub(super) use c::{
    Condition, Notes, domain, externs, files as c, start_tests, word, written, zero_tests,
};
pub(super) use cpp::file as cpp;
pub(super) use matlab::files as matlab;
pub(super) use python::file as python;
pub(super) use rust::{file as rust, items as rust_items};
pub(super) use short::short;
pub(super) use st::{Kind, Library, Scope, Unit, file as st, library as st_library};

/// Every language by name, and how it writes expressions.
#[cfg(test)]
pub(super) fn texts<'a>(
    code: &'a crate::code::Code,
    notes: &'a Notes,
) -> Vec<(&'static str, Box<dyn text::Text + 'a>)> {
    vec![
        ("C", Box::new(c::C::new(code, notes))),
        ("Rust", Box::new(rust::Rust::new(code, ""))),
        ("C++", Box::new(cpp::Cpp::new(code))),
        ("MATLAB", Box::new(matlab::Matlab::new(code, crate::code::Owner::Controller))),
        ("Python", Box::new(python::Python::new(code))),
        ("Structured Text", Box::new(st::StructuredText::new(code))),
    ]
}
