//! Python: one typed module on NumPy, whose scalars round to their precision and divide by zero.

mod batch;
mod class;
mod masked;
mod module;
mod statement;
mod target;

use std::collections::BTreeMap;

pub(in crate::emit) use target::TARGET;

use super::gives::Gives;
use super::literal::through_double;
use super::text::{Level, Lines, Text, bare};
use crate::code::{AXIS, Code, Expr, Shape, Status, Test};
use crate::emit::File;
use crate::parameter::Precision;

pub(super) struct Python<'a> {
    code: &'a Code,
    /// True if a call takes a batch of times and states.
    batch: bool,
    /// Mask of the elements of a batch in which a statement takes effect; `None` for all.
    mask: Option<String>,
    /// The indices of the loops around a statement.
    indices: Vec<String>,
    /// Error message, if the function fails by an exception.
    raises: Option<String>,
    /// The local values that are parameters.
    copies: BTreeMap<String, Expr>,
    /// Result of the function being printed.
    gives: Gives,
    /// The text before the name of a field.
    owner: &'static str,
    out: Lines,
}

/// The module of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    File { name: format!("{}.py", code.name), text: Python::new(code).module() }
}

impl Text for Python<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

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
        format!("{}{name}", self.owner)
    }

    fn parameter(&self, name: &str) -> String {
        format!("given_{name}")
    }

    /// The states of a batch, and its reference, are taken out one by one.
    fn element(&self, array: &str, index: usize) -> String {
        match (self.batch, array) {
            (true, "x" | "xi") => format!("x{}", index + 1),
            (true, "x0") => format!("x{}_0", index + 1),
            (true, "r") => format!("r{index}"),
            (true, "q" | "v" | "a") if self.code.is_stateless() => format!("{array}{}", index + 1),
            (true, "laws") => format!("laws[..., {index}]"),
            _ => format!("{array}[{index}]"),
        }
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Choice, format!("({a} - {b}) & _WRAP"))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("max({a} - {b}, 0)"))
    }

    fn count_over(&self, count: &str, by: u32) -> (Level, String) {
        (Level::Product, format!("{count} // {by}"))
    }

    fn table(&self, name: &str) -> String {
        format!("_{}", name.to_uppercase())
    }

    fn tabulated(&self, table: &str, row: &str, column: usize) -> String {
        format!("{}[{row}, {column}]", self.table(table))
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("_R({count})"))
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = match function {
            "ln" => "log",
            "pow" => "power",
            "atan" => "arctan",
            "atanh" => "arctanh",
            "asin" => "arcsin",
            "acos" => "arccos",
            function => function,
        };
        format!("np.{function}({})", arguments.join(", "))
    }

    fn fused(&self, _operands: &[String; 3]) -> Option<String> {
        None
    }

    fn abs(&self, a: &str) -> String {
        format!("np.abs({a})")
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let (zero, one) = (self.literal("0.0"), self.literal("1.0"));
        let text = format!("np.where({a} > {zero}, {one}, np.where({a} < {zero}, -{one}, {a}))");
        (Level::Atom, text)
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("np.where({}, {a} / {b}, {})", self.not_zero(b), self.nan()))
    }

    fn nan(&self) -> String {
        "_R(np.nan)".to_owned()
    }

    /// Test of a number, which may be one of a batch.
    fn not_zero(&self, a: &str) -> String {
        let zero = self.literal("0.0");
        format!("({a} < {zero}) | ({a} > {zero})")
    }

    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        let array = format!("np.asarray({array}, dtype=_R)");
        format!("np.asarray({name}({array}, np.asarray({time})), dtype=_R)")
    }

    fn of_axis(&self, name: &str, stride: usize, index: usize) -> String {
        let place = match stride {
            1 => AXIS.to_owned(),
            stride => format!("{stride} * {AXIS} + {index}"),
        };
        format!("{}[..., {place}]", self.field(name))
    }

    fn entry(&self, array: &str, row: &str, column: usize) -> String {
        format!("{array}[..., {row}, {column}]")
    }

    fn field_element(&self, name: &str, index: usize) -> String {
        format!("{}[..., {index}]", self.field(name))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        if self.batch {
            return (Level::Atom, format!("np.where({test}, {yes}, {no})"));
        }
        let (yes, no) = (boxed(yes), boxed(no));
        match boxed_test(test) == format!("{no} < {yes}") {
            true => (Level::Atom, format!("max({no}, {yes})")),
            false => (Level::Choice, format!("{yes} if {test} else {no}")),
        }
    }

    fn status(&self, status: Status) -> String {
        format!("Status.{}", word(status))
    }

    fn finite(&self, value: &str) -> String {
        format!("np.isfinite({})", bare(value.to_owned()))
    }

    fn not_number(&self, value: &str) -> String {
        format!("np.isnan({})", bare(value.to_owned()))
    }

    /// Comparisons of which one goes on where that before it ends are one: `a <= b < c`.
    fn all(&self, tests: &[Test]) -> Vec<String> {
        let mut parts: Vec<String> = Vec::new();
        let mut end = None;
        for (i, test) in tests.iter().enumerate() {
            let (start, sign, next) = match test {
                Test::Less(a, b) if !self.batch => (Some(a), "<", Some(b)),
                Test::AtMost(a, b) if !self.batch => (Some(a), "<=", Some(b)),
                _ => (None, "", None),
            };
            match (next, parts.last_mut()) {
                (Some(next), Some(last)) if start == end => {
                    last.pop();
                    last.push_str(&format!(" {sign} {})", self.within(next, Level::Sum)));
                }
                _ => parts.extend(self.operands(test, tests.get(i + 1))),
            }
            end = next;
        }
        if let [one] = parts.as_mut_slice() {
            *one = bare(std::mem::take(one));
        }
        parts
    }

    fn and(&self) -> &'static str {
        if self.batch { "&" } else { "and" }
    }

    fn or(&self) -> &'static str {
        if self.batch { "|" } else { "or" }
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

impl<'a> Python<'a> {
    pub(super) fn new(code: &'a Code) -> Self {
        Self {
            code,
            batch: false,
            mask: None,
            indices: Vec::new(),
            raises: None,
            copies: BTreeMap::new(),
            gives: Gives::Status,
            owner: "self._",
            out: Lines::default(),
        }
    }

    fn list(&self, values: &[Expr]) -> Vec<String> {
        values.iter().map(|value| self.alone(value)).collect()
    }

    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "float32" } else { "float64" }
    }
}

fn annotation(shape: Shape) -> &'static str {
    match shape {
        Shape::Real => "float",
        Shape::Count => "int",
        Shape::Reals(_) | Shape::Lists(..) | Shape::Statuses(_) => "Sequence[float]",
        Shape::Gains => "Gains",
    }
}

/// The message of the error that stands for a status in a function that gives a number.
fn refusal(status: Status) -> &'static str {
    match status {
        Status::Soon => "no number of samples was found that keeps the limits",
        _ => "an argument, or what follows from it, is not finite",
    }
}

fn word(status: Status) -> String {
    status.name().to_uppercase()
}
