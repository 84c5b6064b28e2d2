//! C++17: one header, in which all that calls no function of a library is `constexpr`.

use askama::Template;

use super::frame::Frame;
use super::print::{RootText, Syntax};
use super::{
    Controller, Declared, File, Language, Target, declared, header, refuse_class, text_of, tidy,
};
use crate::controller::plan::Routine;
use crate::expression::Function;
use crate::parameter::Precision;
use crate::program::{Input, Op};
use crate::request::{After, Guard, Spec, What};

pub(super) const TARGET: Target = Target {
    language: Language::Cpp,
    name: "cpp",
    about: "one header, C++17 and constexpr",
    comment: ("/* ", " */"),
    is_word: |word| WORDS.split_whitespace().any(|one| one == word),
    refuse: |spec, _, found| refuse_class(spec, &CLASSES, found),
    files,
};

/// The words of C++17 and C++20 that are none of C or Rust.
const WORDS: &str = "
    and_eq bitand bitor char8_t char16_t char32_t concept consteval constinit const_cast co_await
    co_return co_yield decltype dynamic_cast mutable noexcept not_eq or_eq reinterpret_cast requires
    static_assert static_cast std thread_local wchar_t xor_eq
";

/// The header's own types: those beside the class, and those in it.
const CLASSES: [&str; 6] = ["Control", "Gains", "Params", "Rate", "State", "Status"];

fn files(controller: &Controller<'_>) -> Vec<File> {
    let spec = controller.spec();
    let syntax = Cpp::new(spec);
    let frame = Frame::new(controller, syntax.real, &syntax);
    // A user's function decides for itself whether it is constant; a library's is not in C++17.
    let word = |routines: &[Routine]| {
        let calls = routines.iter().any(|routine| frame.library.contains(routine));
        if calls { "" } else { "constexpr " }
    };
    let mut lines = frame.step.iter().chain(&frame.functions);
    let header = Header {
        name: &spec.name(),
        type_name: &spec.type_name(),
        head: &header::lines(controller, Language::Cpp),
        parameters: &declared(spec, Language::Cpp),
        init: word(&[Routine::Init, Routine::Arm]),
        arm: word(&[Routine::Arm]),
        step: word(&[Routine::Step]),
        tick: word(&[Routine::Tick]),
        loops: lines.any(|line| line.contains("std::size_t")),
        absolute: controller
            .program
            .values
            .iter()
            .any(|definition| matches!(definition.op, Op::Call(Function::Abs, _))),
        frame: &frame,
    };
    let text = tidy(&text_of(header.render()));
    vec![File { name: format!("{}.hpp", spec.name()), text }]
}

pub(super) struct Cpp<'a> {
    spec: &'a Spec,
    real: &'static str,
}

impl<'a> Cpp<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        let real = match spec.precision {
            Precision::F32 => "float",
            Precision::F64 => "double",
        };
        Self { spec, real }
    }

    fn array(&self, constant: bool, name: &str, values: &[String]) -> String {
        let word = if constant { "const " } else { "" };
        let (real, count) = (self.real, values.len());
        format!("{word}std::array<{real}, {count}> {name}{{{{{}}}}};", values.join(", "))
    }
}

impl Syntax for Cpp<'_> {
    fn literal(&self, text: &str) -> String {
        match self.spec.precision {
            Precision::F32 => format!("{text}f"),
            Precision::F64 => text.to_owned(),
        }
    }

    fn field(&self, name: &str) -> String {
        format!("{name}_")
    }

    fn built(&self, name: &str) -> String {
        format!("built.{name}_")
    }

    fn gains_field(&self, name: &str) -> String {
        name.to_owned()
    }

    fn finite(&self, name: &str) -> String {
        format!("finite({name})")
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("kept({product}, {factor})")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = if function == "ln" { "log" } else { function };
        format!("std::{function}({})", arguments.join(", "))
    }

    /// std::fabs is not constant; 0 - a gives 0 for both zeros, and NaN for NaN.
    fn abs(&self, a: &str) -> String {
        format!("absolute({a})")
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("({a} > {zero}) ? {one} : (({a} < {zero}) ? -{one} : {a})")
    }

    fn quotient(&self, a: &str, b: &str, zero: &str) -> String {
        let nan = format!("std::numeric_limits<{}>::quiet_NaN()", self.real);
        format!("(({b} < {zero}) || ({b} > {zero})) ? ({a} / {b}) : {nan}")
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("({condition}) ? {yes} : ({no})")
    }

    fn after(&self) -> String {
        "after(x, t)".to_owned()
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        // The infinite-time system is given xi as it is.
        let given = self.spec.what == What::Associated;
        let array = (!given).then(|| self.array(true, "xi", xi));
        (array.into_iter().collect(), format!("pi0(xi, {time})"))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("({a} < {b}) ? {b} : {a}")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("const {} {name} = {expression};", self.real)
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("({a} < {b}) ? {a} : {b}")
    }

    fn input(&self, input: Input, name: &str) -> String {
        match input {
            Input::Gain(j) => format!("gain[{}]", j - 1),
            _ => name.to_owned(),
        }
    }

    fn rows_function(&self, weights: usize) -> Vec<String> {
        let (real, tail) = (self.real, weights - 1);
        let lines = [
            &format!("static constexpr std::array<{real}, {weights}> rows("),
            &format!(
                "    std::array<{real}, {weights}> row, const std::array<{real}, {tail}>& p) noexcept"
            ),
            "{",
            &format!("    std::array<{real}, {}> q{{}}; // p^2", tail - 1),
            &format!("    for (std::size_t k = 0U; k < {}U; k++) {{", tail - 1),
            &format!("        {real} v = p[k] + p[k];"),
            "        for (std::size_t m = 0U; m < k; m++) {",
            "            v += p[m] * p[k - m - 1U];",
            "        }",
            "        q[k] = v;",
            "    }",
            &format!("    for (std::size_t round = 0U; round < {tail}U; round += 2U) {{"),
            &format!("        for (std::size_t k = round; k < {tail}U; k++) {{"),
            &format!("            {real} v = row[k];"),
            &format!("            for (std::size_t m = k + 1U; m < {weights}U; m++) {{"),
            "                v += ((k == round) ? p[m - k - 1U] : q[m - k - 1U]) * row[m];",
            "            }",
            "            row[k] = v;",
            "        }",
            "    }",
            "    return row;",
            "}",
        ];
        lines.map(str::to_owned).to_vec()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        let lines = [
            self.array(true, "p", tail),
            self.array(true, "w", weights),
            format!("const auto {name} = rows(w, p);"),
        ];
        lines.to_vec()
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let (real, y) = (self.real, root.unknown);
        let mut lines = vec![
            format!("{real} {y} = {};", root.start),
            format!("{real} {y}_low = {};", root.low),
            format!("{real} {y}_high = {};", root.high),
            format!("for (std::size_t round = 0U; round < {}U; round++) {{", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    const {real} {y}_next = {};", root.next),
            format!("    const {real} {y}_size = {};", root.size),
            format!("    if ({} > {}) {{", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    } else {".to_owned(),
            format!("        {y}_high = {y};"),
            "    }".to_owned(),
            format!("    if (({y}_next >= {y}_low) && ({y}_next <= {y}_high)) {{"),
            format!("        {y} = {y}_next;"),
            "    } else {".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    }".to_owned(),
            format!("    if ({y}_size <= {}) {{", root.tolerance),
            "        break;".to_owned(),
            "    }".to_owned(),
            "}".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.hpp.txt", escape = "none")]
struct Header<'a> {
    name: &'a str,
    type_name: &'a str,
    head: &'a [String],
    parameters: &'a [Declared],
    /// `constexpr`, or nothing, for each function.
    init: &'static str,
    arm: &'static str,
    step: &'static str,
    tick: &'static str,
    /// Whether it counts rounds.
    loops: bool,
    /// Whether it takes absolute values.
    absolute: bool,
    frame: &'a Frame,
}
