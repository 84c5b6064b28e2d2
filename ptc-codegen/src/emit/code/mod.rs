//! Printers of whole controllers: one file a language, from the statements of [`Code`].
//!
//! [`Code`]: crate::code::Code

mod block;
mod c;
mod cpp;
mod matlab;
mod python;
mod rust;
mod short;
mod st;
mod text;

pub(super) use c::files as c;
pub(super) use cpp::file as cpp;
pub(super) use matlab::files as matlab;
pub(super) use python::file as python;
pub(super) use rust::{file as rust, items as rust_items};
pub(super) use short::short;
pub(super) use st::file as st;
