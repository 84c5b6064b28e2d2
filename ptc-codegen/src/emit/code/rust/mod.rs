//! Rust: `no_std`, no allocation, no panic, no unsafe code.

mod block;
mod items;
mod private;
mod text;

use super::gives::Gives;
use super::text::{Lines, Text};
use crate::code::{Code, Expr, Shape};
use crate::internal::fault;
use crate::parameter::{Precision, type_name};

/// The items of a controller, whose types are at the path `runtime`.
pub(in crate::emit) fn items(code: &Code, runtime: &'static str) -> String {
    Rust::new(code, runtime).items()
}

pub(in crate::emit) struct Rust<'a> {
    code: &'a Code,
    /// Path of the types that the items use.
    runtime: &'static str,
    /// Result of the function being printed.
    gives: Gives,
    /// True if u and its status are chosen together.
    together: bool,
    /// Position of a line and the text to put before it, which takes up part of its width.
    lead: (usize, &'static str),
    out: Lines,
}

/// Columns of an array in one line, and of each of its elements if several share a line.
const ARRAY: usize = 60;
const SHORT: usize = 10;

/// Columns of a choice in one line.
const CHOICE: usize = 50;

impl<'a> Rust<'a> {
    pub(in crate::emit) fn new(code: &'a Code, runtime: &'static str) -> Self {
        let (gives, together, lead) = (Gives::Status, false, (usize::MAX, ""));
        Self { code, runtime, gives, together, lead, out: Lines::default() }
    }

    fn type_of(&self, shape: Shape) -> String {
        let real = if self.code.precision == Precision::F32 { "f32" } else { "f64" };
        match shape {
            Shape::Count => "u32".to_owned(),
            Shape::Real => real.to_owned(),
            Shape::Reals(length) => format!("[{real}; {length}]"),
            Shape::Lists(count, length) => format!("[[{real}; {length}]; {count}]"),
            Shape::Statuses(_) => fault("statuses are no argument"),
            Shape::Gains => format!("{}Gains", type_name(&self.code.name)),
        }
    }

    /// The line that opens a block; the brace goes to a line of its own where the test takes several, or
    /// takes all of `one`.
    fn with_brace(&self, line: String, one: String) -> String {
        match line.strip_suffix(" {").filter(|line| line.contains('\n')) {
            Some(_) if self.out.has_room(&one) => format!("{one}\n{{"),
            Some(test) => format!("{test}\n{{"),
            None => line,
        }
    }

    /// An array in as many lines as rustfmt gives it.
    fn array_text(&self, before: &str, list: &[String], behind: &str) -> String {
        let one = list.join(", ");
        if one.len() <= ARRAY {
            return format!("{before}{one}{behind}");
        }
        let mut lines: Vec<String> = Vec::new();
        for value in list {
            match lines.last_mut() {
                Some(last)
                    if list.iter().all(|value| value.len() <= SHORT)
                        && self.out.has_room(&format!("    {last} {value},")) =>
                {
                    last.push_str(&format!(" {value},"));
                }
                _ => lines.push(format!("{value},")),
            }
        }
        format!("{before}\n    {}\n{behind}", lines.join("\n    "))
    }

    fn list(&self, values: &[Expr]) -> Vec<String> {
        values.iter().map(|value| self.alone(value)).collect()
    }
}
