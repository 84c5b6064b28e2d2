//! Printers of whole controllers: one file a language, from the statements of [`Code`].
//!
//! [`Code`]: crate::code::Code

#[cfg(feature = "files")]
mod apart;
mod block;
#[cfg(feature = "files")]
mod c;
#[cfg(feature = "files")]
mod called;
#[cfg(feature = "files")]
mod cpp;
#[cfg(feature = "files")]
mod elimination;
mod expression;
mod gives;
#[cfg(feature = "files")]
mod legal;
#[cfg(feature = "files")]
pub(super) mod literal;
#[cfg(feature = "files")]
mod matlab;
#[cfg(feature = "files")]
mod powers;
#[cfg(feature = "files")]
mod python;
mod rust;
mod short;
#[cfg(feature = "files")]
mod st;
mod text;

#[cfg(feature = "files")]
pub(super) use apart::apart;
#[cfg(feature = "files")]
pub(super) use c::{
    Condition, Notes, domain, externs, files as c, start_tests, word, written, zero_tests,
};
#[cfg(feature = "files")]
pub(super) use cpp::file as cpp;
#[cfg(feature = "files")]
pub(super) use matlab::files as matlab;
#[cfg(feature = "files")]
pub(super) use python::file as python;
#[cfg(feature = "files")]
pub(super) use rust::file as rust;
pub(super) use rust::items as rust_items;
pub(super) use short::short;
#[cfg(feature = "files")]
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
