//! Controllers in samples, run in every language from one list of calls.
//!
//! A driver reads words: `D i` chooses a design, `I` and its parameters initialise it, `A k` arms it,
//! `S k` and its measurements step it. Numbers are the bits of doubles in hexadecimal. It writes a
//! line for each `I` (the status) and for each `S`: the status, u, and all that the controller gives
//! beside it; of several inputs every u, and then the status of each.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::code::{Access, Code, Function, Instance, Shape};
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::{Precision, type_name};

use super::run;

mod interpreted;
mod native;
mod rust;

pub(crate) use interpreted::{in_octave, in_python, in_structured_text, octave, python_with};
pub(crate) use native::{in_c, in_cpp};
pub(crate) use rust::in_rust;

/// A controller under test.
pub(crate) struct Design {
    /// Its program.
    pub(crate) code: Code,
    /// The folder of its files.
    pub(crate) folder: PathBuf,
}

/// A call of a controller. Behind the measurements, `Step` gives u to an observer, and the reference to a controller
/// that follows one.
#[derive(Clone, Debug)]
pub(crate) enum Call {
    Init(Vec<f64>),
    Arm(u32),
    Step(u32, Vec<f64>),
}

impl Design {
    fn real(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "float" } else { "double" }
    }

    fn kind(&self) -> String {
        type_name(&self.code.name)
    }

    /// Returns true if it is an observer alone.
    pub(crate) fn observes(&self) -> bool {
        self.code.function("update").is_some()
    }

    /// Returns the function that is called at each tick.
    fn called(&self) -> &Function {
        let name = if self.observes() { "update" } else { "step" };
        self.code.function(name).expect("a call for each tick")
    }

    /// Returns the number of measured values that a step takes.
    pub(crate) fn measured(&self) -> usize {
        self.given_to("x") + self.given_to("y")
    }

    /// Returns the number of reference values behind the measured ones.
    pub(crate) fn references(&self) -> usize {
        self.given_to("r")
    }

    /// The length of an array that a step is given; 0 where it is not.
    fn given_to(&self, argument: &str) -> usize {
        let found = self.called().arguments.iter().find(|a| a.name == argument);
        found.and_then(|a| a.shape.length()).unwrap_or(0)
    }

    /// Number of states in a row, if a step takes a row of states for each axis.
    fn columns(&self) -> Option<usize> {
        self.row_of("x")
    }

    /// Number of reference values in a row, if a step takes a row for each output.
    fn row(&self) -> Option<usize> {
        self.row_of("r")
    }

    fn row_of(&self, argument: &str) -> Option<usize> {
        let found = self.called().arguments.iter().find(|a| a.name == argument);
        match found?.shape {
            Shape::Lists(_, columns) => Some(columns),
            _ => None,
        }
    }

    /// Statements of C that read what is measured into `x`, and the reference into `r`.
    fn read_in_c(&self) -> String {
        let place = |columns: Option<usize>, j: usize| match columns {
            Some(columns) => format!("[{}][{}]", j / columns, j % columns),
            None => format!("[{j}]"),
        };
        let x = (0..self.measured()).map(|j| format!("x{}", place(self.columns(), j)));
        let r = (0..self.references()).map(|j| format!("r{}", place(self.row(), j)));
        x.chain(r).map(|to| format!("{to} = ({})number(); ", self.real())).collect()
    }

    /// Returns the functions other than the tick and `arm`, with the length of the array that each returns.
    fn given(&self) -> impl Iterator<Item = (&Function, Option<usize>)> {
        let others =
            self.code.functions.iter().filter(|f| ![self.called().name, "arm"].contains(&f.name));
        others.map(|function| match function.results[0].shape {
            Shape::Reals(length) => (function, Some(length)),
            _ => (function, None),
        })
    }

    /// The numbers of its parameters, with the name and shape of each.
    fn parameters(&self) -> impl Iterator<Item = (&str, Shape)> {
        self.code.parameters.iter().map(|p| (p.name.as_str(), p.shape))
    }

    /// Returns the count of numbers that `init` takes.
    pub(crate) fn numbers(&self) -> usize {
        self.parameters().map(|(_, shape)| length(shape)).sum()
    }

    /// Returns the answers of the interpreter.
    pub(crate) fn interpreted(&self, calls: &[Call]) -> Vec<String> {
        let mut instance: Option<Instance> = None;
        let mut lines = Vec::new();
        for call in calls {
            match (call, instance.as_mut()) {
                (Call::Init(values), _) => {
                    let mut rest = values.as_slice();
                    let mut given = Vec::new();
                    for (name, shape) in self.parameters() {
                        let (now, later) = rest.split_at(length(shape));
                        given.push((name, now));
                        rest = later;
                    }
                    let made = Instance::new(&self.code, &given);
                    lines.push(format!("I {}", made.as_ref().err().map_or(0, |s| s.number())));
                    instance = made.ok().or(instance);
                }
                (Call::Arm(k), Some(instance)) => {
                    instance.call("arm", &[("k", &[f64::from(*k)])]);
                }
                (Call::Step(k, x), Some(instance)) => {
                    let (k, x) = ([f64::from(*k)], x.as_slice());
                    let (y, behind) = x.split_at(self.measured());
                    let given = [("k", &k[..]), ("x", y), ("y", y), ("r", behind), ("u", behind)];
                    let outcome = instance.call(self.called().name, &given);
                    let mut line = format!("S {}", outcome.status.number());
                    let of = |name: &str| outcome.results.get(name).cloned();
                    if !self.observes() {
                        for u in of("u").unwrap_or_else(|| vec![0.0]) {
                            write!(line, " {}", word(u)).expect("a string");
                        }
                    }
                    for status in of("axes").into_iter().flatten() {
                        write!(line, " {status}").expect("a string");
                    }
                    for (function, _) in self.given() {
                        for value in instance.call(function.name, &[]).results.values().flatten() {
                            write!(line, " {}", word(*value)).expect("a string");
                        }
                    }
                    lines.push(line);
                }
                (_, None) => panic!("the first call is no legal init"),
            }
        }
        lines
    }
}

/// Bits; all that is not a number is alike.
fn word(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{:016x}", value.to_bits()) }
}

/// The calls of all designs, as a driver reads them.
pub(crate) fn script(calls: &[Vec<Call>]) -> String {
    let mut text = String::new();
    for (index, calls) in calls.iter().enumerate() {
        writeln!(text, "D {index}").expect("a string");
        for call in calls {
            let (head, numbers) = match call {
                Call::Init(values) => ("I".to_owned(), values.as_slice()),
                Call::Arm(k) => (format!("A {k}"), &[][..]),
                Call::Step(k, x) => (format!("S {k}"), x.as_slice()),
            };
            text.push_str(&head);
            for number in numbers {
                write!(text, " {:016x}", number.to_bits()).expect("a string");
            }
            text.push('\n');
        }
    }
    text
}

/// Returns the answers of a driver to the script in `folder`.
fn answers(command: &mut Command, folder: &Path) -> Vec<String> {
    let script = fs::File::open(folder.join("script")).expect("a script");
    let text = run(command.stdin(Stdio::from(script)));
    String::from_utf8(text).expect("text").lines().map(str::to_owned).collect()
}

/// The languages that are compared, by their names.
pub(crate) const LANGUAGES: [Language; 6] = [
    Language::C,
    Language::Rust,
    Language::Cpp,
    Language::Python,
    Language::Matlab,
    Language::StructuredText,
];

/// Returns the count of numbers in a shape.
pub(crate) fn length(shape: Shape) -> usize {
    if let Shape::Reals(length) = shape { length } else { 1 }
}
