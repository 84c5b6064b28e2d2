//! Expressions and names.

use super::super::text::{Level, Text};
use super::target::{greatest, is_narrow, is_word, literal};
use super::{StructuredText, helpers};
use crate::code::{Constant, Expr, Status, Table};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::number;

impl Text for StructuredText<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn literal(&self, digits: &str) -> String {
        if self.code.precision == Precision::F32 || is_narrow(digits) {
            return literal(digits, self.code.precision);
        }
        let mut wide = self.wide.borrow_mut();
        let index = wide.iter().position(|one| one == digits).unwrap_or_else(|| {
            wide.push(digits.to_owned());
            wide.len() - 1
        });
        helpers::wide(index)
    }

    fn constant(&self, own: &Constant) -> String {
        match self.holds(own) {
            true => self.named(&own.name),
            false => self.within(&Expr::Number(own.value.clone()), Level::Atom),
        }
    }

    fn count(&self, count: u32) -> String {
        format!("UDINT#{count}")
    }

    fn local(&self, name: &str) -> String {
        if let Some((changed, to)) = &self.applied {
            return match name == *changed {
                true => self.named(to),
                false => helpers::of_subroutine(name),
            };
        }
        match self.given.iter().find(|(own, _)| own == name) {
            Some((_, input)) => input.clone(),
            None => self.named(name),
        }
    }

    fn first(&self) -> i32 {
        1
    }

    fn field(&self, name: &str) -> String {
        format!("{}.{}", self.owner, self.named(name))
    }

    fn parameter(&self, name: &str) -> String {
        format!("params.{name}")
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{}]", index + 1)
    }

    fn entry(&self, array: &str, row: &str, column: usize) -> String {
        format!("{array}[{row}, {}]", column + 1)
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}_ticks({a}, {b})", self.code.name))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}_left({a}, {b})", self.code.name))
    }

    fn tabulated(&self, table: &str, row: &str, column: usize) -> String {
        let columns = self.code.table(table).map_or(0, Table::columns);
        let cell = format!("UDINT#{columns} * {row}");
        match column {
            0 => format!("{}[{cell}]", self.named(table)),
            column => format!("{}[{cell} + UDINT#{column}]", self.named(table)),
        }
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("UDINT_TO_{}({count})", self.real))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Atom, format!("SEL({test}, {no}, {yes})"))
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = if function == "pow" { "EXPT".to_owned() } else { function.to_uppercase() };
        format!("{function}({})", arguments.join(", "))
    }

    fn fused(&self, _operands: &[String; 3]) -> Option<String> {
        None
    }

    fn abs(&self, a: &str) -> String {
        format!("ABS({a})")
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let (zero, one) = (self.literal("0.0"), self.literal("1.0"));
        (Level::Atom, format!("SEL({a} > {zero}, SEL({a} < {zero}, {a}, -{one}), {one})"))
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}_quotient({a}, {b})", self.code.name))
    }

    fn divisor(&self, a: &str) -> (Level, String) {
        (Level::Atom, format!("{}_divisor({a})", self.code.name))
    }

    fn nan(&self) -> String {
        fault("no number has no literal")
    }

    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        format!("{}_{name}({array}, {time})", self.code.name)
    }

    fn not_number(&self, value: &str) -> String {
        format!("({value} <> {value})")
    }

    fn status(&self, status: Status) -> String {
        status.number().to_string()
    }

    fn finite(&self, value: &str) -> String {
        format!("(ABS({value}) <= {})", self.literal(greatest(self.code.precision)))
    }

    fn and(&self) -> &'static str {
        "AND"
    }

    fn or(&self) -> &'static str {
        "OR"
    }

    fn equal(&self) -> &'static str {
        "="
    }
}

impl StructuredText<'_> {
    /// Returns true if a constant is declared: those that no literal holds are made by the block.
    pub(super) fn holds(&self, own: &Constant) -> bool {
        let value = number::round(&own.value, self.code.precision).abs();
        own.count().is_some()
            || self.code.precision == Precision::F32
            || is_narrow(&number::literal(value, self.code.precision))
    }

    /// A name of the code: capitals and small letters are one, and words of the language, and the function block's
    /// own names, are left to them.
    pub(super) fn named(&self, name: &str) -> String {
        let letter = |c: char| match c.is_ascii_uppercase() {
            true => format!("cap_{}", c.to_ascii_lowercase()),
            false => c.to_string(),
        };
        let name: String = name.chars().map(letter).collect();
        let own = ["built", "ready", "self", "status"].contains(&name.as_str());
        let own = own || (name == "u" && !self.observes());
        let own = own || (name == "axes" && self.several().is_some());
        let own = own || name.strip_prefix("wide").is_some_and(|rest| rest.parse::<u32>().is_ok());
        let given = self.outputs().any(|function| function.name == name);
        if own || given || is_word(&name) { format!("{name}_now") } else { name }
    }
}
