//! Calls of the functions of a deadline in flight in a self-test.

use super::numbers::Numbers;
use crate::code::{Code, Function, Shape};
use crate::emit::files::c;
use crate::selftest::samples::{Command, commands, count, is_measured, numbers};

/// The functions, each with its call in C.
pub(super) struct Commands {
    /// Their names, and their calls with the entry `call` of the table.
    pub(super) calls: Vec<(&'static str, String)>,
    /// Most numbers that one is given.
    pub(super) numbers: usize,
    /// True if one gives a count.
    pub(super) finds: bool,
}

impl Commands {
    pub(super) fn of(code: &Code) -> Self {
        let call = |function: &Function| (function.name, written(code, function));
        Self {
            calls: commands(code).map(call).collect(),
            numbers: commands(code).map(numbers).max().unwrap_or(0),
            finds: commands(code).any(|function| !function.results.is_empty()),
        }
    }
}

/// The call of a function with what an entry of the table holds.
fn written(code: &Code, function: &Function) -> String {
    let mut at = 0;
    let mut arguments = vec!["self".to_owned()];
    for argument in &function.arguments {
        let own = match (argument.shape, argument.name.as_str()) {
            (Shape::Count, "k") => "call->k".to_owned(),
            (Shape::Count, _) => "call->samples".to_owned(),
            (_, name) if is_measured(name) => "call->y".to_owned(),
            (Shape::Real, _) => format!("call->given[{at}]"),
            (Shape::Lists(_, columns), _) => {
                format!("(const {} (*)[{columns}])&call->given[{at}]", c::real(code.precision))
            }
            _ => format!("&call->given[{at}]"),
        };
        let of_its_own = !is_measured(&argument.name);
        at += if of_its_own { count(argument.shape) } else { 0 };
        arguments.push(own);
    }
    if !function.results.is_empty() {
        arguments.push("&found".to_owned());
    }
    format!("{}_{}({})", code.name, function.name, arguments.join(", "))
}

impl Numbers<'_> {
    /// The fields of a call before that of `step`.
    pub(super) fn command(&self, command: &Command, all: &Commands) -> String {
        let index = all.calls.iter().zip(1..).find(|((name, _), _)| *name == command.name);
        let mut fields = vec![
            format!(".command = {}U", index.map_or(0, |(_, index)| index)),
            format!(".samples = {}U", command.samples),
            format!(".told = {}", c::word(command.status)),
        ];
        if !command.given.is_empty() {
            fields.push(format!(".given = {{{}}}", self.list(&command.given)));
        }
        if all.finds {
            fields.push(format!(".found = {}U", command.found));
        }
        fields.join(", ")
    }
}
