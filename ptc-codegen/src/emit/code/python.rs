//! Python: one typed module on NumPy, whose scalars round to their precision and divide by zero.

use super::block::{Block, Branch, checks};
use super::text::{Level, Lines, Text, length};
use crate::code::{Code, Expr, Function, Shape, Status, Test};
use crate::emit::{File, print::through_double};
use crate::parameter::{Precision, type_name};

struct Python<'a> {
    code: &'a Code,
    /// Whether it is the constructor that fails.
    raises: bool,
    out: Lines,
}

/// The module of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    let text = Python { code, raises: true, out: Lines::default() }.module();
    File { name: format!("{}.py", code.name), text }
}

impl Text for Python<'_> {
    fn precision(&self) -> Precision {
        self.code.precision
    }

    /// A Python float beside a NumPy scalar of single precision would make a double of it before
    /// NumPy 2.
    fn literal(&self, digits: &str) -> String {
        match self.code.precision {
            Precision::F32 => format!("_R({})", through_double(digits)),
            Precision::F64 => digits.to_owned(),
        }
    }

    fn count(&self, count: u32) -> String {
        count.to_string()
    }

    fn field(&self, name: &str) -> String {
        format!("self._{name}")
    }

    fn parameter(&self, name: &str) -> String {
        format!("given_{name}")
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Choice, format!("({a} - {b}) & _WRAP"))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("max({a} - {b}, 0)"))
    }

    fn count_half(&self, count: &str) -> (Level, String) {
        (Level::Product, format!("{count} // 2"))
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("_R({count})"))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        let (yes, no) = (boxed(yes), boxed(no));
        match boxed_test(test) == format!("{no} < {yes}") {
            true => (Level::Atom, format!("max({no}, {yes})")),
            false => (Level::Choice, format!("{yes} if {test} else {no}")),
        }
    }

    fn finite(&self, value: &str) -> String {
        format!("np.isfinite({value})")
    }

    fn and(&self) -> &'static str {
        "and"
    }

    fn or(&self) -> &'static str {
        "or"
    }
}

/// A number that stands alone, as a NumPy scalar: Python's own would not divide by zero.
fn boxed(text: &str) -> String {
    if text.parse::<f64>().is_ok() { format!("_R({text})") } else { text.to_owned() }
}

/// A comparison with its numbers as NumPy scalars.
fn boxed_test(test: &str) -> String {
    match test.split_once(" < ") {
        Some((a, b)) => format!("{} < {}", boxed(a), boxed(b)),
        None => test.to_owned(),
    }
}

impl Block for Python<'_> {
    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        Branch { open: "if ", turn: "elif ", then: ":", otherwise: "else:", end: "" }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("# ", "")
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn declare(&self, _name: &str, _shape: Shape) -> Option<String> {
        None
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value}")
    }

    fn value(&self, value: &Expr) -> String {
        match value {
            Expr::Number(_) => boxed(&self.alone(value)),
            value => self.alone(value),
        }
    }

    fn require(&mut self, test: &Test, status: Status) {
        if !self.raises {
            let line = self.refused(test);
            self.out.open(line);
            self.out.line(format!("return Control(_R(0.0), Status.{})", word(status)));
            return self.out.leave();
        }
        for check in checks(test) {
            let line = self.refused(&check.test);
            self.out.open(line);
            let name = match &check.parameter {
                Some((name, Some(index))) => format!("{name}[{index}]"),
                Some((name, None)) => name.clone(),
                None => String::new(),
            };
            self.out.line(match name.as_str() {
                "" => "raise ValueError(\"the coefficients overflow; take smaller gains, or rates and sample periods nearer to 1\")".to_owned(),
                name => {
                    format!("raise ValueError(f\"params.{name} is {{params.{name}}}; legal: {}\")", check.legal)
                }
            });
            self.out.leave();
        }
    }
}

impl Python<'_> {
    /// The line that opens what happens where `test` does not hold.
    fn refused(&self, test: &Test) -> String {
        let line = self.unless("not ", test, "\n    and ", ":");
        match line.contains('\n') {
            true => line.replacen('(', "(\n    ", 1).replace("):", "\n):"),
            false => line,
        }
    }

    fn module(mut self) -> String {
        let code = self.code;
        let kind = type_name(&code.name);
        self.out.line("\"\"\"");
        for line in &code.head {
            self.out.line(line.replace('\\', "\\\\"));
        }
        self.out.line("\"\"\"\n\nfrom __future__ import annotations\n");
        let arrays = code.parameters.iter().any(|p| length(p.shape).is_some());
        if arrays {
            self.out.line("from collections.abc import Sequence");
        }
        self.out.line("from dataclasses import dataclass\nfrom enum import IntEnum\nfrom typing import NamedTuple\n");
        self.out.line("import numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n");
        let mut public = ["Control", "Params", "Status", &kind];
        public.sort_unstable();
        self.out.line(format!("__all__ = [\"{}\"]\n", public.join("\", \"")));
        let real = if code.precision == Precision::F32 { "float32" } else { "float64" };
        self.out.line(format!("_R = np.{real}\n_WRAP = 0xFFFFFFFF\nArray = NDArray[np.{real}]\n"));
        self.out.line(format!("\n{}", include_str!("../../../templates/status.py.txt")));
        let control = include_str!("../../../templates/control.py.txt").replace("REAL", real);
        self.out.line(format!("\n{control}"));
        self.out.line("\n@dataclass(frozen=True)");
        self.out.open("class Params:");
        self.out.line("\"\"\"Run-time parameters.\"\"\"\n");
        for parameter in &code.parameters {
            let (name, kind) = (&parameter.name, annotation(parameter.shape));
            self.out.line(format!("{name}: {kind}\n\"\"\"{}\"\"\"", parameter.about));
        }
        self.out.leave();
        self.out.line(format!("\n\n{}", include_str!("../../../templates/numbers.py.txt")));
        self.class(&kind);
        self.out.text()
    }

    fn class(&mut self, kind: &str) {
        let code = self.code;
        self.out.open(format!("class {kind}:"));
        self.out.line("\"\"\"The controller: takes the parameters and arms at tick 0.\n\nValueError where a parameter is outside its domain, or the coefficients overflow.\n\"\"\"\n");
        self.out.open("def __init__(self, params: Params) -> None:");
        self.out.open("with np.errstate(all=\"ignore\"):");
        for parameter in &code.parameters {
            let name = &parameter.name;
            match parameter.shape {
                Shape::Real => self.out.line(format!("given_{name} = _R(params.{name})")),
                Shape::Reals(length) => self.out.line(format!(
                    "given_{name} = _numbers(params.{name}, {length}, \"params.{name}\")"
                )),
                Shape::Count => {
                    self.out.line(format!("given_{name} = params.{name}.__index__()"));
                    self.out.open(format!("if given_{name} != given_{name} & _WRAP:"));
                    self.out.line(format!("raise ValueError(f\"params.{name} is {{params.{name}}}; legal: 0..2^32 - 1\")"));
                    self.out.leave();
                }
            }
        }
        self.raises = true;
        self.block(&code.init);
        self.out.leave();
        self.out.leave();
        self.raises = false;
        for function in &code.functions {
            self.function(function);
        }
        self.out.leave();
    }

    fn function(&mut self, function: &Function) {
        let step = function.name == "step";
        let real = if self.code.precision == Precision::F32 { "float32" } else { "float64" };
        let result = match function.results.first().map(|given| given.variable.shape) {
            None => "None".to_owned(),
            Some(_) if step => "Control".to_owned(),
            Some(Shape::Reals(_)) => "Array".to_owned(),
            Some(Shape::Count) => "int".to_owned(),
            Some(Shape::Real) => format!("np.{real}"),
        };
        let mut list = vec!["self".to_owned()];
        for argument in &function.arguments {
            let kind = match argument.shape {
                Shape::Reals(_) => "ArrayLike",
                shape => annotation(shape),
            };
            list.push(format!("{}: {kind}", argument.name));
        }
        self.out.line("");
        let name = function.name;
        self.out.open(format!("def {name}({}) -> {result}:", list.join(", ")));
        let line = format!("\"\"\"{}\"\"\"", function.about.trim_end());
        if function.failures.is_empty() && self.out.has_room(&line) {
            self.out.line(line);
        } else {
            self.out.words("", &format!("\"\"\"{}", function.about));
            if !function.failures.is_empty() {
                self.out.line("\nOn a negative status u is 0 and nothing has changed.");
            }
            self.out.line("\"\"\"");
        }
        let computes = !function.body.is_empty() && step;
        if computes {
            self.out.open("with np.errstate(all=\"ignore\"):");
        }
        for argument in &function.arguments {
            let name = &argument.name;
            match argument.shape {
                Shape::Count => self.out.line(format!("{name} = {name}.__index__() & _WRAP")),
                Shape::Real => self.out.line(format!("{name} = _R({name})")),
                Shape::Reals(length) => {
                    self.out.line(format!("{name} = _numbers({name}, {length}, \"{name}\")"));
                }
            }
        }
        self.block(&function.body);
        if let Some(given) = function.results.first() {
            let values: Vec<_> = given.values.iter().map(|value| self.value(value)).collect();
            let values = values.join(", ");
            match length(given.variable.shape) {
                _ if step => self.outcomes(&function.status, &|status| {
                    format!("return Control({values}, Status.{})", word(status))
                }),
                Some(_) => self.out.line(format!("return np.array([{values}], dtype=_R)")),
                None => self.out.line(format!("return {values}")),
            }
        }
        if computes {
            self.out.leave();
        }
        self.out.leave();
    }
}

fn annotation(shape: Shape) -> &'static str {
    match shape {
        Shape::Real => "float",
        Shape::Count => "int",
        Shape::Reals(_) => "Sequence[float]",
    }
}

fn word(status: Status) -> String {
    status.name().to_uppercase()
}
