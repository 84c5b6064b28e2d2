//! The command as a user meets it: what it reads, prints, writes and refuses. Without the feature `lab`.
#![cfg(feature = "cli")]

mod cost;
mod design_file;
mod emit;
mod environment;
#[cfg(all(unix, feature = "lab"))]
mod explained;
#[cfg(all(unix, feature = "lab"))]
mod files;
mod help;
mod line;
mod manual;
mod new;
#[cfg(unix)]
mod projects;
mod proof;
mod robot;
#[cfg(all(unix, feature = "lab"))]
mod robot_controller;
mod show;
#[path = "../support/mod.rs"]
mod support;
