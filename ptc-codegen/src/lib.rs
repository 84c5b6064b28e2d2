//! wip
pub mod algebra;
pub mod diagnostic;
pub mod expansion;
pub mod law;
pub mod mapping;
pub mod spec;
