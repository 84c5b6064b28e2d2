//! The layers, each in a file of its own.

mod compilers;
mod eva;
mod identity;
mod rules;
mod seeded;

use crate::layer::Layer;

/// Every layer, in the order in which they run: the cheap ones first.
pub const LAYERS: &[Layer] = &[compilers::LAYER, rules::LAYER, eva::LAYER, identity::LAYER];
