//! Shared printing code of all languages: statements, expressions and lines, from the [`Code`] of a controller; and the
//! items of Rust, which the macro expands to.
//!
//! [`Code`]: crate::code::Code

pub(super) mod block;
pub(super) mod expression;
pub(super) mod gives;
pub(super) mod rust;
mod short;
pub(super) mod text;

pub(super) use short::short;
