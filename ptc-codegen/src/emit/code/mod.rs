//! Printers of whole controllers: one file a language, from the statements of [`Code`].

mod c;
mod rust;
mod text;

pub(super) use c::files as c;
pub(super) use rust::{file as rust, items as rust_items};
