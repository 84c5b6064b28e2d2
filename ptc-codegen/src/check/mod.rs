//! Checks of a design.

pub mod membership;
pub mod poles;
