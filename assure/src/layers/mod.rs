//! The layers, each in a file of its own.

mod compilers;
mod identity;
mod miri;
mod rules;
mod rust;
mod seeded;
mod supply;

use crate::layer::Layer;

/// Every layer, in the order in which they run: the cheap ones first.
pub const LAYERS: &[Layer] =
    &[supply::LAYER, compilers::LAYER, rules::LAYER, rust::LAYER, miri::LAYER, identity::LAYER];
