//! MATLAB and GNU Octave: a function file for each function. Integers saturate there, and a quotient
//! of them is rounded: differences of counts are taken in doubles, which hold them exactly.

mod functions;
mod helpers;
mod statement;
mod target;

use std::collections::BTreeMap;

pub(in crate::emit) use target::TARGET;

use super::gives::Gives;
use super::literal::through_double;
use super::text::{Level, Lines, Text};
use crate::code::{AXIS, Code, Expr, Owner, Status};
use crate::emit::File;
use crate::parameter::Precision;

pub(super) struct Matlab<'a> {
    code: &'a Code,
    /// Prefix of the access to a field.
    owner: &'static str,
    /// Error message, if the function fails by an error.
    raises: Option<String>,
    /// The local values that are parameters.
    copies: BTreeMap<String, Expr>,
    /// Result of the function being printed, and its name.
    gives: Gives,
    result: String,
    out: Lines,
}

/// The function files of a controller.
pub(in crate::emit) fn files(code: &Code) -> Vec<File> {
    let printer = |owner| Matlab::new(code, owner);
    let file = |name: &str, mut text: String| {
        for helper in &helpers::HELPERS {
            if text.contains(&format!("{}(", helper.name)) {
                text.push_str(helper.text);
            }
        }
        File { name: format!("{}_{name}.m", code.name), text }
    };
    let functions = code.functions.iter().map(|f| file(f.name, printer(f.owner).function(f)));
    std::iter::once(file("init", printer(Owner::Controller).init())).chain(functions).collect()
}

impl Text for Matlab<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn literal(&self, digits: &str) -> String {
        match self.code.precision {
            Precision::F32 => format!("single({})", through_double(digits)),
            Precision::F64 => digits.to_owned(),
        }
    }

    fn count(&self, count: u32) -> String {
        format!("uint32({count})")
    }

    fn field(&self, name: &str) -> String {
        format!("{}{name}", self.owner)
    }

    fn parameter(&self, name: &str) -> String {
        format!("given.{name}")
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}({})", index + 1)
    }

    fn entry(&self, array: &str, row: &str, column: usize) -> String {
        format!("{array}({row}, {})", column + 1)
    }

    fn first(&self) -> i32 {
        1
    }

    fn whole(&self, count: u32) -> String {
        count.to_string()
    }

    fn at(&self, array: &str, place: &str) -> String {
        format!("{array}({place})")
    }

    fn of_axis(&self, name: &str, stride: usize, index: usize) -> String {
        let place = match stride {
            1 => format!("{AXIS} + 1"),
            stride => format!("{stride} * {AXIS} + {}", index + 1),
        };
        format!("{}({place})", self.field(name))
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("uint32(mod(double({a}) - double({b}), 4294967296))"))
    }

    /// Saturates at 0.
    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Sum, format!("{a} - {b}"))
    }

    fn count_over(&self, count: &str, by: u32) -> (Level, String) {
        match by.is_power_of_two() {
            true => (Level::Atom, format!("bitshift({count}, -{})", by.trailing_zeros())),
            false => (Level::Atom, format!("idivide({count}, {})", self.count(by))),
        }
    }

    fn tabulated(&self, table: &str, row: &str, column: usize) -> String {
        self.entry(table, &format!("{row} + 1"), column)
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("{}({count})", self.real_type()))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Atom, format!("pick({test}, {yes}, {no})"))
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = match function {
            "sqrt" => "real_sqrt",
            "ln" => "real_log",
            "pow" => "real_pow",
            "atanh" => "real_atanh",
            "asin" => "real_asin",
            "acos" => "real_acos",
            "cbrt" => return format!("nthroot({}, 3)", arguments.join(", ")),
            function => function,
        };
        format!("{function}({})", arguments.join(", "))
    }

    fn fused(&self, _operands: &[String; 3]) -> Option<String> {
        None
    }

    fn abs(&self, a: &str) -> String {
        format!("abs({a})")
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let (zero, one) = (self.literal("0.0"), self.literal("1.0"));
        (Level::Atom, format!("pick({a} > {zero}, {one}, pick({a} < {zero}, -{one}, {a}))"))
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        self.choose(&self.not_zero(b), &format!("{a} / {b}"), &self.nan())
    }

    fn nan(&self) -> String {
        format!("{}(NaN)", self.real_type())
    }

    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        format!("{}({name}({array}, {time}))", self.real_type())
    }

    fn status(&self, status: Status) -> String {
        format!("int32({})", status.number())
    }

    fn finite(&self, value: &str) -> String {
        format!("isfinite({value})")
    }

    fn not_number(&self, value: &str) -> String {
        format!("isnan({value})")
    }
}

impl<'a> Matlab<'a> {
    pub(super) fn new(code: &'a Code, owner: Owner) -> Self {
        Self {
            code,
            owner: if owner == Owner::Gains { "gains." } else { "self." },
            raises: None,
            copies: BTreeMap::new(),
            gives: Gives::Status,
            result: String::new(),
            out: Lines::default(),
        }
    }

    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "single" } else { "double" }
    }

    fn list(&self, values: &[Expr]) -> Vec<String> {
        values.iter().map(|value| self.alone(value)).collect()
    }

    /// Returns true if a status is among the results.
    fn has_status(&self) -> bool {
        matches!(
            self.gives,
            Gives::Control
                | Gives::Rate
                | Gives::Value
                | Gives::Values
                | Gives::Count
                | Gives::Gains
                | Gives::Progress
                | Gives::Axes
        )
    }
}
