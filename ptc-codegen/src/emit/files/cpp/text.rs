//! Expressions in C++.

use super::super::text::{Level, Text};
use super::{Cpp, word};
use crate::code::{Index, Status, Whose};
use crate::parameter::Precision;

impl Text for Cpp<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn field(&self, name: &str) -> String {
        format!("{}{name}{}", self.prefix, self.suffix)
    }

    fn parameter(&self, name: &str) -> String {
        format!("params.{name}")
    }

    fn table(&self, name: &str) -> String {
        format!("{name}_")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = if function == "ln" { "log" } else { function };
        format!("std::{function}({})", arguments.join(", "))
    }

    fn fused(&self, operands: &[String; 3]) -> Option<String> {
        Some(self.call("fma", operands))
    }

    /// std::fabs is not constant.
    fn abs(&self, a: &str) -> String {
        format!("absolute({a})")
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        self.choose(&self.not_zero(b), &format!("{a} / {b}"), &self.nan())
    }

    fn nan(&self) -> String {
        format!("std::numeric_limits<{}>::quiet_NaN()", self.real_type())
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("static_cast<{}>({count})", self.real_type()))
    }

    fn input(&self, index: &Index) -> String {
        format!("all.u[{}]", self.place(index, 0))
    }

    fn status(&self, status: Status) -> String {
        word(status)
    }

    fn status_of(&self, whose: &Whose) -> String {
        match whose {
            Whose::Call => "all.status".to_owned(),
            Whose::Input(index) => format!("all.axes[{}]", self.place(index, 0)),
        }
    }

    fn finite(&self, value: &str) -> String {
        format!("finite({value})")
    }

    fn not_number(&self, value: &str) -> String {
        format!("(!({value} <= {value}))")
    }
}
