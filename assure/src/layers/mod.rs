//! The layers, each in a file of its own.

mod attack;
mod bits;
mod book;
mod campaign;
mod command;
mod comparison;
mod compilers;
pub mod cost;
mod cpp;
mod eva;
mod explorer;
mod fmu;
mod fuzz;
mod identity;
mod matlab;
mod miri;
mod mixed;
mod module;
mod names;
mod notebooks;
mod packages;
mod projects;
mod python;
mod report;
mod robots;
mod rules;
mod rust;
mod samples;
mod seams;
mod seeded;
mod selftest;
mod st;
mod suites;
mod supply;
mod verdicts;

use crate::layer::Layer;

/// Every layer, in the order in which they run: the cheap ones first.
pub const LAYERS: &[Layer] = &[
    supply::LAYER,
    compilers::LAYER,
    rules::LAYER,
    eva::LAYER,
    selftest::LAYER,
    samples::LAYER,
    cost::LAYER,
    rust::LAYER,
    miri::LAYER,
    names::LAYER,
    bits::LAYER,
    identity::LAYER,
    fuzz::LAYER,
    mixed::LAYER,
    cpp::LAYER,
    python::LAYER,
    matlab::LAYER,
    st::LAYER,
    fmu::LAYER,
    projects::LAYER,
    packages::LAYER,
    module::LAYER,
    notebooks::LAYER,
    campaign::LAYER,
    attack::LAYER,
    report::LAYER,
    book::LAYER,
    explorer::LAYER,
    seams::LAYER,
    verdicts::LAYER,
    robots::LAYER,
    suites::EMITTED,
    suites::LOOPS,
    suites::COMMAND,
    suites::SESSIONS,
];
