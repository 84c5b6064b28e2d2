//! The file around the functions.

use super::super::block::{Block, WRITTEN};
use super::super::c::{assumptions, once};
use super::super::called::{calls, calls_library};
use super::super::gives::Gives;
use super::super::text::{Text, capital};
use super::Cpp;
use crate::code::{Code, Expr, Function, Owner, Shape, Start, Subroutine, Variable};
use crate::expression::Function as Math;
use crate::parameter::type_name;

impl Cpp<'_> {
    pub(super) fn header(mut self) -> String {
        let code = self.code;
        let kind = type_name(&code.name);
        self.out.line("/*");
        for line in &code.head {
            self.out.line(format!(" * {line}"));
        }
        self.out.line(" */");
        let head = std::mem::take(&mut self.out).text();
        self.out.line("#include <array>");
        for (header, needed) in [
            ("cfloat", true),
            ("cmath", code.functions.iter().any(calls_library) || init_calls(code)),
            ("cstddef", code.axes().is_some()),
            (
                "cstdint",
                code.counts()
                    || code.axes().is_some()
                    || code
                        .functions
                        .iter()
                        .flat_map(|function| &function.arguments)
                        .chain(&code.fields)
                        .any(|variable| variable.shape == Shape::Count),
            ),
            ("limits", true),
        ] {
            if needed {
                self.out.line(format!("#include <{header}>"));
            }
        }
        self.out.line(format!("\n{}", assumptions(code.precision)));
        self.out.line("\nnamespace ptc {\n");
        self.out.line(include_str!("../../../../templates/status.hpp.txt"));
        let of_value = |function: &Function| {
            matches!(Gives::of(function), Gives::Value | Gives::Values | Gives::Count)
        };
        if code.functions.iter().any(of_value) {
            self.out.line(include_str!("../../../../templates/value.hpp.txt"));
        }
        if code.axes().is_some() {
            self.out.line(include_str!("../../../../templates/axes.hpp.txt"));
        }
        self.out.line("/// Run-time parameters.");
        self.out.open(format!("struct {kind}Params {{"));
        for parameter in &code.parameters {
            self.member(parameter, "", "///<");
        }
        self.out.close("};");
        if !code.gains.is_empty() {
            self.gains(&kind);
        }
        self.class(&kind);
        self.out.line("\n} // namespace ptc");
        once(code, &head, &self.out.text(), "HPP")
    }

    fn member(&mut self, variable: &Variable, suffix: &str, comment: &str) {
        let (kind, name, about) = (self.type_of(variable.shape), &variable.name, &variable.about);
        self.out.line(format!("{kind} {name}{suffix}{{}}; {comment} {about}"));
    }

    fn gains(&mut self, kind: &str) {
        let code = self.code;
        self.out.line("\n/// Feedback gains at one time.");
        self.out.open(format!("struct [[nodiscard]] {kind}Gains {{"));
        for field in &code.gains {
            self.member(field, "", "///<");
        }
        self.out.line(
            "Status status{Status::Input}; ///< Ok or Hold; negative where there are no gains",
        );
        self.suffix = "";
        for function in code.functions.iter().filter(|f| f.owner == Owner::Gains) {
            self.function(function);
        }
        self.suffix = "_";
        self.out.leave();
        self.out.line("");
        self.out.open("private:");
        self.finite();
        self.absolute(Owner::Gains);
        self.out.close("};");
    }

    fn class(&mut self, kind: &str) {
        let code = self.code;
        let noun = capital(code.noun());
        let changed = match code.is_stateless() {
            true => "",
            false => ", changed by arm and by what is not const",
        };
        self.out.line(format!("\n/// {noun}: set by init{changed}."));
        self.out.open(format!("class {kind} {{"));
        self.out.leave();
        self.out.open("public:");
        self.out.line(format!("using Params = {kind}Params;"));
        let arm = code.function("arm").zip(code.start.as_ref());
        let states = code.functions.iter().flat_map(|function| &function.arguments);
        let state = states.map(|argument| argument.shape).find(|s| matches!(s, Shape::Reals(_)));
        if let Some(state) = state.filter(|_| arm.is_some()) {
            let state = self.type_of(state);
            self.out.line(format!("using State = {state};"));
        }
        if !code.gains.is_empty() {
            self.out.line(format!("using Gains = {kind}Gains;"));
        }
        self.out.line("");
        self.init(kind);
        for function in code.functions.iter().filter(|f| f.owner == Owner::Controller) {
            self.function(function);
        }
        self.out.leave();
        self.out.line("");
        self.out.open("private:");
        self.finite();
        self.absolute(Owner::Controller);
        code.subroutines().into_iter().for_each(|of| self.subroutine(of));
        self.constants();
        self.tables();
        self.out.line("");
        for field in &code.fields {
            self.member(field, "_", "//");
        }
        self.out.close("};");
    }

    fn constants(&mut self) {
        for own in &self.code.constants() {
            let (name, value) = (self.constant(own), self.literal_of(own));
            self.out.line(format!("/// {}.", capital(&own.described())));
            let kind = self.type_of(own.shape);
            self.out.line(format!("static constexpr {kind} {name}{{{value}}};"));
        }
    }

    fn tables(&mut self) {
        let (code, real) = (self.code, self.real_type());
        for table in &code.tables {
            let (rows, columns) = (table.rows.len(), table.columns());
            let name = self.table(&table.name);
            self.out.line("");
            self.out.line(format!("/// {}.", capital(&table.about)));
            self.out.open(format!(
                "static constexpr std::array<std::array<{real}, {columns}>, {rows}> {name}{{{{"
            ));
            for row in self.rows(table) {
                self.out.line(format!("{{{{{}}}}},", row.join(", ")));
            }
            self.out.close("}};");
        }
    }

    fn init(&mut self, kind: &str) {
        let code = self.code;
        self.out.words("/// ", &format!("{} Ok, or Param with nothing changed.", code.starts()));
        let params = if code.parameters.is_empty() { "" } else { " params" };
        let mut list = vec![format!("const Params&{params}")];
        let state = code.start.as_ref().and_then(|start| start.state.as_ref());
        list.extend(state.map(|state| format!("const State& {}", state.name)));
        let armed = code.function(code.start.as_ref().map_or("arm", Start::function));
        let calls = init_calls(code) || armed.is_some_and(calls_library);
        let constant = if calls { "" } else { "constexpr " };
        let list = list.join(", ");
        self.out.line(format!("[[nodiscard]] {constant}Status init({list}) noexcept"));
        self.out.open("{");
        self.gives = Gives::Status;
        match &code.start {
            None => {
                self.block(&code.init);
                self.out.line("return Status::Ok;");
            }
            Some(start) => {
                self.out.line(format!("{kind} built{{}};"));
                self.prefix = "built.";
                self.block(&code.init);
                self.prefix = "";
                let mut list: Vec<_> = start.numbers().map(|number| self.alone(number)).collect();
                list.extend(state.map(|state| state.name.clone()));
                let (called, list) = (start.function(), list.join(", "));
                self.out.line(format!("const Status status = built.{called}({list});"));
                self.out.line("if (status == Status::Ok) {\n    *this = built;\n}\nreturn status;");
            }
        }
        self.out.close("}");
    }

    fn finite(&mut self) {
        let real = self.real_type();
        let limits = format!("std::numeric_limits<{real}>");
        self.out.line("/// std::isfinite is not constexpr in C++17.");
        self.out.line(format!("static constexpr bool finite({real} v) noexcept"));
        self.out.open("{");
        self.out.line(format!("return (v >= {limits}::lowest()) && (v <= ({limits}::max)());"));
        self.out.close("}");
    }

    /// |v| as a constant expression, where the functions of `owner` take it.
    fn absolute(&mut self, owner: Owner) {
        let (code, real) = (self.code, self.real_type());
        let mut taken = false;
        let mut look = |value: &Expr| taken |= matches!(value, Expr::Call(Math::Abs, _));
        if owner == Owner::Controller {
            code.init.iter().for_each(|statement| statement.visit(&mut look));
        }
        let functions = code.functions.iter().filter(|function| function.owner == owner);
        functions.for_each(|function| function.visit(&mut look));
        if owner == Owner::Controller {
            let bodies = code.subroutines().into_iter().flat_map(|of| of.body(0));
            bodies.for_each(|statement| statement.visit(&mut look));
        }
        if taken {
            // 0 - v gives 0 for both zeros, and no number for none.
            let zero = self.literal("0.0");
            self.out.line("");
            self.out.line(format!("static constexpr {real} absolute({real} v) noexcept"));
            self.out.open("{");
            self.out.line(format!("return (v > {zero}) ? v : ({zero} - v);"));
            self.out.close("}");
        }
    }

    /// The function of a subroutine.
    fn subroutine(&mut self, of: Subroutine) {
        let given = of.given();
        let list = given.map(|own| {
            let (shape, name) = (self.type_of(Shape::Reals(own.length)), own.name);
            if own.changes { format!("{shape} {name}") } else { format!("const {shape}& {name}") }
        });
        // std::fma is not constant.
        let constant = if of.is_fused() { "" } else { "constexpr " };
        let (name, gives) = (of.name(), self.type_of(Shape::Reals(given[0].length)));
        self.out.line("");
        self.out.words("/// ", of.about());
        self.out
            .line(format!("static {constant}{gives} {name}(\n    {}) noexcept", list.join(", ")));
        self.out.open("{");
        self.block(&of.body(WRITTEN));
        self.out.line(format!("return {};", given[0].name));
        self.out.close("}");
    }
}

/// Returns true if `init` calls a function of the library.
fn init_calls(code: &Code) -> bool {
    code.init.iter().any(calls)
}
