//! Expressions in Rust.

use super::super::text::{Level, Text, bare, bracketed};
use super::Rust;
use crate::code::{AXIS, Shape, Status};
use crate::parameter::Precision;

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
        (Level::Atom, format!("{}.saturating_sub({})", typed(a), bare(b.to_owned())))
    }

    fn table(&self, name: &str) -> String {
        format!("Self::{}", name.to_uppercase())
    }

    fn tabulated(&self, table: &str, row: &str, column: usize) -> String {
        format!("{}[{} as usize][{column}]", self.table(table), bracketed(row))
    }

    fn real(&self, count: &str) -> (Level, String) {
        // In brackets wherever it is compared: `<` behind a type opens its arguments.
        (Level::Choice, format!("{} as {}", bracketed(count), self.type_of(Shape::Real)))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        let [yes, no] = [yes, no].map(|way| bare(way.to_owned()));
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
        let a = self.receiver(a);
        let name = a.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if name { format!("{a}.abs()") } else { format!("({a}).abs()") }
    }

    fn sign(&self, a: &str) -> (Level, String) {
        let text = format!("if {a} > 0.0 {{ 1.0 }} else if {a} < 0.0 {{ -1.0 }} else {{ {a} }}");
        (Level::Choice, text)
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        self.choose(&self.not_zero(b), &format!("{a} / {b}"), &self.nan())
    }

    fn nan(&self) -> String {
        format!("{}::NAN", self.type_of(Shape::Real))
    }

    fn not_zero(&self, a: &str) -> String {
        format!("{a} < 0.0 || {a} > 0.0")
    }

    fn status(&self, status: Status) -> String {
        let runtime = self.runtime;
        match status.number() < 0 {
            true => format!("Err({runtime}Error::{})", status.name()),
            false => format!("Ok({runtime}Status::{})", status.name()),
        }
    }

    fn stands(&self, status: &str) -> String {
        format!("{status}.is_ok()")
    }

    fn fails(&self, status: &str) -> String {
        format!("{status}.is_err()")
    }

    fn finite(&self, value: &str) -> String {
        format!("{}.is_finite()", self.receiver(value))
    }

    fn not_number(&self, value: &str) -> String {
        format!("{}.is_nan()", self.receiver(value))
    }
}

impl Rust<'_> {
    /// A value whose type is known, so that a method can be called on it: that of a literal is open.
    fn receiver(&self, value: &str) -> String {
        let inner = value.trim_start_matches(['(', '-']).trim_end_matches(')');
        match inner.parse::<f64>() {
            Ok(_) if inner.starts_with(|c: char| c.is_ascii_digit()) => {
                value.replacen(inner, &format!("{inner}_{}", self.type_of(Shape::Real)), 1)
            }
            _ => value.to_owned(),
        }
    }
}

/// A count whose type is known, so that a method can be called on it.
pub(super) fn typed(count: &str) -> String {
    let is_number = count.bytes().all(|b| b.is_ascii_digit());
    format!("{count}{}", if is_number { "_u32" } else { "" })
}
