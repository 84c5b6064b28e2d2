//! Compiles and runs the emitted code against references, other languages and the interpreter, and tests the readers
//! with arbitrary text. `cargo assure emitted` runs it.

mod atoms;
mod axes;
mod behaviour;
mod bisection;
#[path = "../../../tests/support/command.rs"]
mod command;
mod design_properties;
mod expressions;
mod format;
mod goldens;
mod hosts;
mod identities;
mod injection;
mod languages;
mod latched;
mod laws;
mod mixtures;
mod oracle;
mod reference;
mod robot;
mod samples_languages;
mod selftest;
mod spec_properties;
mod support;
mod verdicts;
