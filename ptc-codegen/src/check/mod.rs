//! Checks of a design.

pub mod poles;
