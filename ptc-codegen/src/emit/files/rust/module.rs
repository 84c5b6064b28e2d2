//! The module around the items of a self-contained file.

use askama::Template;

use crate::emit::files::text_of;
use crate::emit::tidy;
use crate::expression::Function;
use crate::parameter::Precision;

/// A self-contained module: its head, the types that the items use, and the items.
pub(super) fn text(head: &[String], precision: Precision, items: &str) -> String {
    let calls = |function: &str| items.contains(&format!("math::{function}("));
    let names = Function::ALL.iter().map(|(name, _)| *name).chain(["pow", "mul_add"]);
    let functions = names.filter(|f| calls(f));
    let module = Module {
        head: &documented(head),
        real: real_of(precision),
        functions: functions.map(|f| MathFunction::new(f, precision)).collect(),
        axes: items.contains(" -> Axes<"),
        items,
    };
    tidy(&text_of(module.render()))
}

/// The head as rustdoc, its formulas as they stand.
fn documented(head: &[String]) -> String {
    let (first, rest) = head.split_first().map_or(("", head), |(first, rest)| (first, rest));
    let lines = ["", "```text"].into_iter().chain(rest.iter().map(String::as_str).skip(1));
    let lines = std::iter::once(first).chain(lines).chain(["```"]);
    lines.map(|line| format!("//! {line}\n")).collect()
}

fn real_of(precision: Precision) -> &'static str {
    match precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    }
}

/// A function of the file's own `math` module: its signature, the method of `std` and the
/// function of `libm`.
struct MathFunction {
    signature: String,
    method: String,
    libm: String,
}

impl MathFunction {
    fn new(function: &str, precision: Precision) -> Self {
        let real = if precision == Precision::F32 { "f32" } else { "f64" };
        let suffix = if precision == Precision::F32 { "f" } else { "" };
        let libm = if function == "ln" { "log" } else { function };
        if function == "pow" {
            return Self {
                signature: format!("pow(a: {real}, b: {real}) -> {real}"),
                method: "a.powf(b)".to_owned(),
                libm: format!("libm::pow{suffix}(a, b)"),
            };
        }
        if function == "mul_add" {
            return Self {
                signature: format!("mul_add(a: {real}, b: {real}, c: {real}) -> {real}"),
                method: "a.mul_add(b, c)".to_owned(),
                libm: format!("libm::fma{suffix}(a, b, c)"),
            };
        }
        Self {
            signature: format!("{function}(a: {real}) -> {real}"),
            method: format!("a.{function}()"),
            libm: format!("libm::{libm}{suffix}(a)"),
        }
    }
}

#[derive(Template)]
#[template(path = "module.rs.txt", escape = "none")]
struct Module<'a> {
    head: &'a str,
    real: &'static str,
    functions: Vec<MathFunction>,
    axes: bool,
    items: &'a str,
}
