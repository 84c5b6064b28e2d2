//! The layers, each in a file of its own.

mod compilers;
mod fuzz;
mod identity;
mod rules;
mod seeded;
mod selftest;

use crate::layer::Layer;

/// Every layer, in the order in which they run: the cheap ones first.
pub const LAYERS: &[Layer] =
    &[compilers::LAYER, rules::LAYER, identity::LAYER, selftest::LAYER, fuzz::LAYER];
