//! The library: what it reads, and what the programs compute that it makes of it.

#[path = "../../../tests/support/command.rs"]
mod command;
mod design;
mod digits;
mod examine;
mod expanded;
mod heads;
#[cfg(feature = "cli")]
mod models;
mod plcopen;
#[cfg(feature = "cli")]
mod references;
mod samples;
mod samples_linear;
#[cfg(all(unix, feature = "cli"))]
mod samples_observer;
mod spelling;
#[path = "../support/mod.rs"]
mod support;
