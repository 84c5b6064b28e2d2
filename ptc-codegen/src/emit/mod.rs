//! Back ends: the program of a controller in, source text out.
//!
//! The printers in `code` write whole controllers. The macro takes the items that the one for Rust prints; all else
//! is a file, and behind the feature `files`, so that who uses the macro alone does not compile it.

mod code;
mod declared;
#[cfg(feature = "files")]
mod files;

use declared::Element;
#[cfg(feature = "files")]
pub use files::*;

use crate::code::Code;
use crate::controller::{self, Controller};
use crate::internal::fault;
use crate::request::{Sampled, Spec};
use crate::samples;

/// Path of the facade crate, whose types the macro uses.
const FACADE: &str = "::ptc::";

/// The items of the Rust file of a controller on the types of the facade crate `ptc`.
pub fn emit_items(controller: &Controller<'_>) -> String {
    let head = vec![design(controller.spec())];
    code::rust::items(&in_time(controller, head, declared::element), FACADE)
}

/// The same of a controller in samples.
pub fn emit_sampled_items(spec: &Spec) -> String {
    code::rust::items(&in_samples(spec, &|_, _| vec![design(spec)]), FACADE)
}

/// The head of the items of the macro: which design they are of.
fn design(spec: &Spec) -> String {
    format!("Design {}.", spec.fingerprint())
}

/// The program of a controller as it is printed, with the head of its file.
fn in_time(controller: &Controller<'_>, head: Vec<String>, element: Element) -> Code {
    let parameters = declared::declared(controller.spec(), element);
    code::short(controller::code::code(controller, head, parameters))
}

/// The same of a controller in samples.
fn in_samples(spec: &Spec, head: &dyn Fn(&Sampled, &Code) -> Vec<String>) -> Code {
    let Some(sampled) = spec.sampled() else { fault("a controller without samples") };
    let mut code = code::short(samples::controller(spec, sampled, Vec::new()));
    code.head = head(sampled, &code);
    match code.check() {
        Ok(()) => code,
        Err(error) => fault(error),
    }
}

/// Template text without trailing spaces and with one newline at its end.
fn tidy(text: &str) -> String {
    let mut lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    while lines.last().is_some_and(|line| line.is_empty()) {
        lines.pop();
    }
    lines.dedup_by(|a, b| a.is_empty() && b.is_empty());
    let mut text = lines.join("\n");
    text.push('\n');
    text
}
