//! The layers, each in a file of its own.

mod command;
mod comparison;
mod compilers;
mod cpp;
mod fmu;
mod identity;
mod matlab;
mod packages;
mod projects;
mod python;
mod rules;
mod rust;
mod seeded;
mod st;

use crate::layer::Layer;

/// Every layer, in the order in which they run: the cheap ones first.
pub const LAYERS: &[Layer] = &[
    compilers::LAYER,
    rules::LAYER,
    rust::LAYER,
    cpp::LAYER,
    python::LAYER,
    matlab::LAYER,
    st::LAYER,
    identity::LAYER,
    fmu::LAYER,
    projects::LAYER,
    packages::LAYER,
];
