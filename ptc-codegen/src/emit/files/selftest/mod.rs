//! The self-test of a controller in C: tables of calls, and the function that runs them.

mod commands;
mod numbers;
mod samples;
mod time;

use askama::Template;

use super::apart::apart;
use super::{File, text_of, tidy};
use crate::code::Code;
use crate::parameter::Precision;
use crate::request::{Spec, What};
use numbers::Numbers;

pub(super) use samples::files as in_samples;
pub(super) use time::files as in_time;

/// Contents of the header of a self-test.
struct About<'a> {
    sessions: usize,
    calls: usize,
    refused: usize,
    /// Subject and verb of the expectation, and the origin of the expected values, in lines.
    subject: &'static str,
    expected: &'a [String],
    /// Conditions that are not taken both ways, with the reasons.
    unreachable: Vec<(String, String)>,
}

impl<'a> Numbers<'a> {
    fn new(spec: &Spec, code: &'a Code) -> Self {
        Self { precision: spec.precision, declared: &code.parameters }
    }
}

/// The suffix of functions of the library.
fn suffix(spec: &Spec) -> &'static str {
    if spec.precision == Precision::F32 { "f" } else { "" }
}

/// The header and the source.
fn both(spec: &Spec, about: &About<'_>, source: askama::Result<String>) -> Vec<File> {
    let name = spec.name();
    let unreachable = about.unreachable.iter();
    let header = Header {
        name: &name,
        noun: if spec.what == What::Observer { "observer" } else { "controller" },
        command: &spec.command(),
        version: env!("CARGO_PKG_VERSION"),
        about,
        unreachable: &unreachable
            .map(|(c, reason)| (c.clone(), wrapped(c, reason)))
            .collect::<Vec<_>>(),
    };
    [(format!("{name}_selftest.h"), header.render()), (format!("{name}_selftest.c"), source)]
        .into_iter()
        .map(|(file, text)| apart(File { name: file, text: tidy(&text_of(text)) }, &name))
        .collect()
}

/// A reason in lines of the comment that its condition begins.
fn wrapped(condition: &str, reason: &str) -> String {
    let mut lines = String::new();
    let mut column = condition.len() + 6;
    for word in reason.split(' ') {
        if column + word.len() > 96 {
            lines.push_str("\n *    ");
            column = 6;
        }
        lines.push_str(if lines.is_empty() { "" } else { " " });
        lines.push_str(word);
        column += word.len() + 1;
    }
    lines
}

#[derive(Template)]
#[template(path = "selftest/header.h.txt", escape = "none")]
struct Header<'a> {
    name: &'a str,
    noun: &'a str,
    command: &'a str,
    version: &'static str,
    about: &'a About<'a>,
    unreachable: &'a [(String, String)],
}
