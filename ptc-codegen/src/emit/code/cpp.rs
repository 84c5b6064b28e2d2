//! C++17: one header. All of it is `constexpr`, for it calls no function of a library.

use super::block::{Block, Branch};
use super::text::{Level, Lines, Text, length};
use crate::code::{Access, Code, Function, Shape, Status, Test, Variable};
use crate::emit::File;
use crate::parameter::{Precision, type_name};

struct Cpp<'a> {
    code: &'a Code,
    /// What a call that fails gives.
    failure: Failure,
    out: Lines,
}

#[derive(Clone, Copy)]
enum Failure {
    Status,
    Control,
}

/// The header of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    let text = Cpp { code, failure: Failure::Status, out: Lines::default() }.header();
    File { name: format!("{}.hpp", code.name), text }
}

impl Text for Cpp<'_> {
    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn field(&self, name: &str) -> String {
        format!("{name}_")
    }

    fn parameter(&self, name: &str) -> String {
        format!("params.{name}")
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("static_cast<{}>({count})", self.real_type()))
    }

    fn finite(&self, value: &str) -> String {
        format!("finite({value})")
    }
}

impl Block for Cpp<'_> {
    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        Branch { open: "if (", turn: "} else if (", then: ") {", otherwise: "} else {", end: "}" }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("// ", "")
    }

    fn define(&self, name: &str, shape: Shape, value: &str) -> String {
        format!("const {} {name} = {value};", self.type_of(shape))
    }

    /// With a value, which a constant function of C++17 needs.
    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        Some(format!("{} {name}{{}};", self.type_of(shape)))
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.unless("!", test, "\n    && ", ") {");
        self.out.open(line);
        let word = word(status);
        let zero = self.literal("0.0");
        self.out.line(match self.failure {
            Failure::Status => format!("return {word};"),
            Failure::Control => format!("return {{{zero}, {word}}};"),
        });
        self.out.close("}");
    }
}

impl Cpp<'_> {
    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "float" } else { "double" }
    }

    fn type_of(&self, shape: Shape) -> String {
        let real = self.real_type();
        match shape {
            Shape::Count => "std::uint32_t".to_owned(),
            Shape::Real => real.to_owned(),
            Shape::Reals(length) => format!("std::array<{real}, {length}>"),
        }
    }

    fn member(&mut self, variable: &Variable, suffix: &str, comment: &str) {
        let (kind, name, about) = (self.type_of(variable.shape), &variable.name, &variable.about);
        self.out.line(format!("{kind} {name}{suffix}{{}}; {comment} {about}"));
    }

    fn header(mut self) -> String {
        let code = self.code;
        let (guard, kind) = (code.name.to_uppercase(), type_name(&code.name));
        self.out.line("/*");
        for line in &code.head {
            self.out.line(format!(" * {line}"));
        }
        self.out.line(format!(" */\n#ifndef {guard}_HPP\n#define {guard}_HPP\n"));
        self.out.line("#include <array>\n#include <cstdint>\n#include <limits>\n");
        self.out.line("namespace ptc {\n");
        self.out.line(include_str!("../../../templates/status.hpp.txt"));
        self.out.line("/// Run-time parameters.");
        self.out.open(format!("struct {kind}Params {{"));
        for parameter in &code.parameters {
            self.member(parameter, "", "///<");
        }
        self.out.close("};");
        self.out.line("\n/// Controller: set by init, changed by arm and by what is not const.");
        self.out.open(format!("class {kind} {{"));
        self.out.leave();
        self.out.open("public:");
        self.out.line(format!("using Params = {kind}Params;\n"));
        self.out.line(
            "/// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.",
        );
        let params = if code.parameters.is_empty() { "" } else { " params" };
        self.out
            .line(format!("[[nodiscard]] constexpr Status init(const Params&{params}) noexcept"));
        self.out.open("{");
        self.block(&code.init);
        self.out.line("return Status::Ok;");
        self.out.close("}");
        for function in &code.functions {
            self.function(function);
        }
        self.out.leave();
        self.out.line("");
        self.out.open("private:");
        let limits = format!("std::numeric_limits<{}>", self.real_type());
        self.out.line("/// std::isfinite is not constexpr in C++17.");
        self.out.line(format!("static constexpr bool finite({} v) noexcept", self.real_type()));
        self.out.open("{");
        self.out.line(format!("return (v >= {limits}::lowest()) && (v <= ({limits}::max)());"));
        self.out.close("}");
        self.out.line("");
        for field in &code.fields {
            self.member(field, "_", "//");
        }
        self.out.close("};");
        self.out.line("\n} // namespace ptc\n\n#endif");
        self.out.text()
    }

    fn function(&mut self, function: &Function) {
        let step = function.name == "step";
        self.failure = if step { Failure::Control } else { Failure::Status };
        let given = function.results.first();
        let result = match given {
            Some(given) if step => format!("Control<{}>", self.type_of(given.variable.shape)),
            Some(given) => self.type_of(given.variable.shape),
            None => "void".to_owned(),
        };
        let list = function.arguments.iter().map(|argument| {
            let (kind, name) = (self.type_of(argument.shape), &argument.name);
            match length(argument.shape) {
                Some(_) => format!("const {kind}& {name}"),
                None => format!("{kind} {name}"),
            }
        });
        let list = list.collect::<Vec<_>>().join(", ");
        let constant = if function.access == Access::Read { " const" } else { "" };
        self.out.line("");
        self.out.words("/// ", &function.about);
        if !function.failures.is_empty() {
            self.out.line("/// On a negative status u is 0 and nothing has changed.");
        }
        let discard = if given.is_some() && !step { "[[nodiscard]] " } else { "" };
        let name = function.name;
        self.out.line(format!("{discard}constexpr {result} {name}({list}){constant} noexcept"));
        self.out.open("{");
        self.block(&function.body);
        let Some(given) = given else { return self.out.close("}") };
        let values: Vec<_> = given.values.iter().map(|value| self.alone(value)).collect();
        let values = values.join(", ");
        match length(given.variable.shape) {
            _ if step => {
                let set = |status| format!("return {{{values}, {}}};", word(status));
                self.outcomes(&function.status, &set);
            }
            Some(_) => self.out.line(format!("return {{{{{values}}}}};")),
            None => self.out.line(format!("return {values};")),
        }
        self.out.close("}");
    }
}

fn word(status: Status) -> String {
    format!("Status::{}", status.name())
}
