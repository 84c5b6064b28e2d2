//! Rust: `no_std`, no allocation, no panic, no unsafe code.

mod axes;
mod inputs;
mod items;
mod loops;

use super::block::{Block, Branch, either};
use super::gives::Gives;
use super::text::{Level, Lines, Text, bracketed};
use crate::code::{AXIS, Code, Ending, Expr, Shape, Solve, Status, Test};
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
    /// What the function gives that is being printed.
    gives: Gives,
    /// Whether u and its status are chosen together.
    together: bool,
    /// What is put before the line that comes at this place, which takes room.
    lead: (usize, &'static str),
    out: Lines,
}

impl Text for Rust<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn literal(&self, digits: &str) -> String {
        digits.to_owned()
    }

    fn count(&self, count: u32) -> String {
        count.to_string()
    }

    fn field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn parameter(&self, name: &str) -> String {
        format!("params.{name}")
    }

    fn of_axis(&self, name: &str, stride: usize, index: usize) -> String {
        let place = match (stride, index) {
            (1, _) => format!("{AXIS} as usize"),
            (stride, 0) => format!("{stride} * {AXIS} as usize"),
            (stride, index) => format!("{stride} * {AXIS} as usize + {index}"),
        };
        format!("{}[{place}]", self.field(name))
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}.wrapping_sub({b})", typed(a)))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}.saturating_sub({b})", typed(a)))
    }

    fn count_half(&self, count: &str) -> (Level, String) {
        (Level::Product, format!("{count} / 2"))
    }

    fn real(&self, count: &str) -> (Level, String) {
        // In brackets wherever it is compared: `<` behind a type opens its arguments.
        (Level::Choice, format!("{} as {}", bracketed(count), self.type_of(Shape::Real)))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Choice, format!("if {test} {{ {yes} }} else {{ {no} }}"))
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let path = match self.runtime {
            "" => "math".to_owned(),
            runtime => format!("{runtime}math::{}", self.type_of(Shape::Real)),
        };
        format!("{path}::{function}({})", arguments.join(", "))
    }

    fn fused(&self, operands: &[String; 3]) -> Option<String> {
        Some(self.call("mul_add", operands))
    }

    fn abs(&self, a: &str) -> String {
        let name = a.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if name { format!("{a}.abs()") } else { format!("({a}).abs()") }
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let text = format!("if {a} > 0.0 {{ 1.0 }} else if {a} < 0.0 {{ -1.0 }} else {{ {a} }}");
        (Level::Choice, text)
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        let (test, yes, no) = self.divisible(a, b);
        (Level::Choice, format!("if {test} {{ {yes} }} else {{ {no} }}"))
    }

    fn finite(&self, value: &str) -> String {
        format!("{value}.is_finite()")
    }

    fn not_number(&self, value: &str) -> String {
        format!("{value}.is_nan()")
    }
}

impl Block for Rust<'_> {
    fn as_block(&mut self) -> &mut dyn Block {
        self
    }

    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        let joint = "\n    && ";
        let (otherwise, end) = ("} else {", "}");
        Branch { open: "if ", turn: "} else if ", then: " {", joint, otherwise, end }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("// ", "")
    }

    /// With its type if the value holds only literals, which have no type.
    fn defined(&self, name: &str, shape: Shape, value: &Expr) -> String {
        match value.is_constant() {
            true => format!("{name}: {}", self.type_of(shape)),
            false => name.to_owned(),
        }
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        Some(format!("let {name}: {};", self.type_of(shape)))
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    /// A choice is a block each way where rustfmt makes it one.
    fn value(&self, value: &Expr) -> String {
        let text = self.alone(value);
        let (test, yes, no) = match value {
            _ if text.len() <= CHOICE => return text,
            Expr::Choose(test, yes, no) => (self.test(test), self.alone(yes), self.alone(no)),
            Expr::Quotient(a, b) => {
                self.divisible(&self.within(a, Level::Atom), &self.within(b, Level::Atom))
            }
            _ => return text,
        };
        format!("if {test} {{\n    {yes}\n}} else {{\n    {no}\n}}")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let one = format!("if !({})", self.parts(test).join(" && "));
        let line = self.unless("!", test, " {");
        self.out.open(self.with_brace(line, one));
        let failed = if self.gives == Gives::Axes { "failed" } else { "Err" };
        self.out.line(format!("return {failed}({}Error::{});", self.runtime, status.name()));
        self.out.close("}");
    }

    fn opened(&self, start: &str, tests: &[&Test]) -> String {
        let parts = match tests {
            [test] => self.parts(test),
            tests => vec![either(self, tests)],
        };
        let lead = if self.lead.0 == self.out.here() { self.lead.1 } else { "" };
        let before = format!("{lead}{start}");
        let line = self.out.joined(&before, &parts, ("&&", self.branch().joint), " {");
        let line = self.with_brace(line, format!("{before}{}", parts.join(" && ")));
        line.strip_prefix(lead).map_or(line.clone(), str::to_owned)
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        let list = self.list(values);
        let line = self.array_text(&format!("let {name} = &["), &list, "];");
        self.out.line(line);
    }

    fn rows(&mut self, name: &str, tail: &[Expr], weights: &[Expr]) {
        self.arrays([("weights", weights), ("tail", tail)]);
        self.out.line(format!("let {name} = Self::rows(weights, &tail);"));
    }

    fn elimination(&mut self, name: &str, matrix: &[Expr], right: &[Expr]) {
        self.arrays([("a", matrix), ("b", right)]);
        self.out.line(format!("let {name} = Self::eliminate(a, b);"));
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], _: usize) {
        self.out.line(format!("let {name} = {callback}({});", given.join(", ")));
    }

    fn rounds(&self, rounds: u32, counted: bool) -> [String; 2] {
        let round = if counted { Solve::ROUND } else { "_" };
        [format!("for {round} in 0..{rounds} {{"), "}".to_owned()]
    }

    fn leave(&self) -> &'static str {
        "break;"
    }

    fn begin(&self, name: &str, value: &str) -> String {
        format!("let mut {name} = {value};")
    }

    fn give(&mut self, values: &[Expr], ending: Ending) {
        let runtime = self.runtime;
        let list = self.list(values);
        let status = match ending {
            Ending::Known(status) => format!("{runtime}Status::{}", status.name()),
            Ending::OfGains => "self.status".to_owned(),
        };
        match self.gives {
            Gives::Nothing => {}
            Gives::Status => self.out.line("Ok(())"),
            Gives::Progress => self.out.line(format!("Ok({status})")),
            Gives::Control if self.together => {
                self.out.line(format!("({}, {status})", list.join(", ")));
            }
            Gives::Control | Gives::Gains => self.out.line(status),
            Gives::Rate | Gives::Values | Gives::Array => {
                let (before, behind) =
                    if self.gives == Gives::Array { ("[", "]") } else { ("Ok([", "])") };
                let line = self.array_text(before, &list, behind);
                self.out.line(line);
            }
            Gives::Value => self.out.line(format!("Ok({})", list.join(", "))),
            Gives::Number => self.out.line(list.join(", ")),
            Gives::Axes => fault("axes are the whole of a function"),
        }
    }

    fn fail(&mut self, status: Status) {
        let error = format!("Err({}Error::{})", self.runtime, status.name());
        // What is chosen is a value, unless the choice ends the call.
        self.out.line(match self.gives {
            Gives::Control | Gives::Gains => format!("return {error};"),
            _ => error,
        });
    }
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

    /// When a quotient exists, it, and what stands for it else.
    fn divisible(&self, a: &str, b: &str) -> (String, String, String) {
        let nan = format!("{}::NAN", self.type_of(Shape::Real));
        (format!("{b} < 0.0 || {b} > 0.0"), format!("{a} / {b}"), nan)
    }

    /// Two arrays that a function takes.
    fn arrays(&mut self, both: [(&str, &[Expr]); 2]) {
        for (array, values) in both {
            let list = self.list(values);
            let line = self.array_text(&format!("let {array} = ["), &list, "];");
            self.out.line(line);
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

/// A count whose type is known, so that a method can be called on it.
fn typed(count: &str) -> String {
    let is_number = count.bytes().all(|b| b.is_ascii_digit());
    format!("{count}{}", if is_number { "_u32" } else { "" })
}
