//! Rust: `no_std`, no allocation, no panic, no unsafe code.

use askama::Template;

use super::frame::Frame;
use super::print::{RootText, Syntax};
use super::{Controller, Declared, File, Language, Target, declared, header, text_of, tidy};
use crate::expression::Function;
use crate::parameter::Precision;
use crate::program::Input;
use crate::request::{After, Guard, Spec};

pub(super) const TARGET: Target = Target {
    language: Language::Rust,
    name: "rust",
    about: "one no_std file that stands alone",
    comment: ("/* ", " */"),
    is_word: |_| false,
    refuse: |_, _, _| {},
    files: |controller| vec![file(controller)],
};

/// The file of a controller, which stands alone.
pub(super) fn file(controller: &Controller<'_>) -> File {
    let name = controller.spec().name();
    let items = render(controller, "");
    let head = header::lines(controller, Language::Rust);
    let text = module_text(&head, controller.spec().precision, &items);
    File { name: format!("{name}.rs"), text }
}

/// A module that stands alone: its head, the types that the items stand on, and the items.
pub(super) fn module_text(head: &[String], precision: Precision, items: &str) -> String {
    let calls = |function: &str| items.contains(&format!("math::{function}("));
    let names = Function::ALL.iter().map(|(name, _)| *name).chain(["pow"]);
    let functions = names.filter(|f| calls(f));
    let module = Module {
        head: &documented(head),
        real: real_of(precision),
        functions: functions.map(|f| MathFunction::new(f, precision)).collect(),
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

/// The items alone, on the types of the facade crate.
pub(super) fn items(controller: &Controller<'_>) -> String {
    tidy(&render(controller, "::ptc::"))
}

/// The items; `runtime` is the path of the types that they stand on.
fn render(controller: &Controller<'_>, runtime: &'static str) -> String {
    let spec = controller.spec();
    let frame = Frame::new(controller, real(spec), &Rust::new(spec, runtime));
    let (type_name, parameters) = (spec.type_name(), declared(spec, Language::Rust));
    let hold = match spec.after {
        After::Hold => format!("{runtime}Status::Hold"),
        After::Zero | After::Extern => {
            format!("if past >= 0.0 {{ {runtime}Status::After }} else {{ {runtime}Status::Hold }}")
        }
    };
    text_of(Items { type_name, runtime, parameters, hold, frame }.render())
}

pub(super) fn real(spec: &Spec) -> &'static str {
    real_of(spec.precision)
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
        Self {
            signature: format!("{function}(a: {real}) -> {real}"),
            method: format!("a.{function}()"),
            libm: format!("libm::{libm}{suffix}(a)"),
        }
    }
}

pub(super) struct Rust<'a> {
    spec: &'a Spec,
    runtime: &'static str,
}

impl<'a> Rust<'a> {
    /// `runtime` is the path of the types that the items stand on; none is their own module.
    pub(super) fn new(spec: &'a Spec, runtime: &'static str) -> Self {
        Self { spec, runtime }
    }
}

impl Syntax for Rust<'_> {
    fn literal(&self, text: &str) -> String {
        text.to_owned()
    }

    fn field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn built(&self, name: &str) -> String {
        format!("built.{name}")
    }

    fn gains_field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn finite(&self, name: &str) -> String {
        format!("{name}.is_finite()")
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("Self::kept({product}, {factor})")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let path = match self.runtime {
            "" => "math".to_owned(),
            runtime => format!("{runtime}math::{}", real(self.spec)),
        };
        format!("{path}::{function}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        let name = a.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if name { format!("{a}.abs()") } else { format!("({a}).abs()") }
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("if {a} > {zero} {{ {one} }} else if {a} < {zero} {{ -{one} }} else {{ {a} }}")
    }

    fn quotient(&self, a: &str, b: &str, zero: &str) -> String {
        let nan = format!("{}::NAN", real(self.spec));
        format!("if {b} < {zero} || {b} > {zero} {{ {a} / {b} }} else {{ {nan} }}")
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("if {condition} {{ {yes} }} else {{ {no} }}")
    }

    fn after(&self) -> String {
        "after(x, t)".to_owned()
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        (Vec::new(), format!("pi0(&[{}], {time})", xi.join(", ")))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("if {a} < {b} {{ {b} }} else {{ {a} }}")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("let {name} = {expression};")
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("if {a} < {b} {{ {a} }} else {{ {b} }}")
    }

    fn input(&self, _input: Input, name: &str) -> String {
        name.to_owned()
    }

    fn rows_function(&self, weights: usize) -> Vec<String> {
        let (real, tail) = (real(self.spec), weights - 1);
        let lines = [
            &format!(
                "fn rows(mut rows: [{real}; {weights}], tail: &[{real}; {tail}]) -> [{real}; {weights}] {{"
            ),
            &format!("    let mut square = [0.0; {}];", tail - 1),
            "    for (d, (sum, own)) in square.iter_mut().zip(tail).enumerate() {",
            "        *sum = *own + *own;",
            "        for (a, b) in tail.iter().take(d).zip(tail.iter().take(d).rev()) {",
            "            *sum += *a * *b;",
            "        }",
            "    }",
            "    let mut round: &mut [_] = &mut rows;",
            "    while !round.is_empty() {",
            "        let mut power: &[_] = tail;",
            "        let mut part = &mut *round;",
            "        while let Some((sum, later)) = part.split_first_mut() {",
            "            for (coefficient, row) in power.iter().zip(later.iter()) {",
            "                *sum += *coefficient * *row;",
            "            }",
            "            power = &square;",
            "            part = later;",
            "        }",
            "        round = round.get_mut(2..).unwrap_or_default();",
            "    }",
            "    rows",
            "}",
        ];
        lines.map(str::to_owned).to_vec()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        let (tail, weights) = (tail.join(", "), weights.join(", "));
        vec![format!("let {name} = Self::rows([{weights}], &[{tail}]);")]
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let y = root.unknown;
        let mut lines = vec![
            format!("let mut {y} = {};", root.start),
            format!("let mut {y}_low = {};", root.low),
            format!("let mut {y}_high = {};", root.high),
            format!("for _ in 0..{} {{", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    let {y}_next = {};", root.next),
            format!("    let {y}_size = {};", root.size),
            format!("    if {} > {} {{", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    } else {".to_owned(),
            format!("        {y}_high = {y};"),
            "    }".to_owned(),
            format!("    if {y}_next >= {y}_low && {y}_next <= {y}_high {{"),
            format!("        {y} = {y}_next;"),
            "    } else {".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    }".to_owned(),
            format!("    if {y}_size <= {} {{", root.tolerance),
            "        break;".to_owned(),
            "    }".to_owned(),
            "}".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "module.rs.txt", escape = "none")]
struct Module<'a> {
    head: &'a str,
    real: &'static str,
    functions: Vec<MathFunction>,
    items: &'a str,
}

#[derive(Template)]
#[template(path = "items.rs.txt", escape = "none")]
struct Items {
    type_name: String,
    runtime: &'static str,
    parameters: Vec<Declared>,
    /// Status where the gains are held or the deadline is over.
    hold: String,
    frame: Frame,
}
