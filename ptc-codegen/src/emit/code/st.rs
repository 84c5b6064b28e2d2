//! IEC 61131-3 Structured Text: a function block. Counts never overflow in it, for what becomes of
//! them then depends on the controller.

use std::collections::BTreeMap;

use super::block::{Block, Branch, declared};
use super::text::{Level, Lines, Text, length};
use crate::code::{Code, Function, Shape, Status, Test};
use crate::emit::{File, st};
use crate::internal::fault;
use crate::parameter::Precision;

struct StructuredText<'a> {
    code: &'a Code,
    real: &'static str,
    out: Lines,
}

/// The file of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    let real = if code.precision == Precision::F32 { "REAL" } else { "LREAL" };
    let text = StructuredText { code, real, out: Lines::default() }.text();
    File { name: format!("{}.st", code.name), text }
}

impl Text for StructuredText<'_> {
    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn literal(&self, digits: &str) -> String {
        st::literal(digits, self.code.precision)
    }

    fn count(&self, count: u32) -> String {
        format!("UDINT#{count}")
    }

    /// Words of the language, and the function block's own names, are left to them.
    fn local(&self, name: &str) -> String {
        let own = ["ready", "self", "status", "u"].contains(&name);
        let given = self.code.functions.iter().any(|function| function.name == name);
        if own || given || st::is_word(name) { format!("{name}_now") } else { name.to_owned() }
    }

    fn field(&self, name: &str) -> String {
        format!("self.{}", self.local(name))
    }

    fn parameter(&self, name: &str) -> String {
        format!("params.{name}")
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{}]", index + 1)
    }

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}_ticks({a}, {b})", self.code.name))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{}_left({a}, {b})", self.code.name))
    }

    fn count_half(&self, count: &str) -> (Level, String) {
        (Level::Product, format!("{count} / UDINT#2"))
    }

    fn real(&self, count: &str) -> (Level, String) {
        (Level::Atom, format!("UDINT_TO_{}({count})", self.real))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Atom, format!("SEL({test}, {no}, {yes})"))
    }

    fn finite(&self, value: &str) -> String {
        format!("(ABS({value}) <= {})", st::greatest(self.code.precision))
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

impl Block for StructuredText<'_> {
    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        Branch { open: "IF ", turn: "ELSIF ", then: " THEN", otherwise: "ELSE", end: "END_IF;" }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("(* ", " *)")
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("{name} := {value};")
    }

    /// All variables stand before the statements.
    fn declare(&self, _name: &str, _shape: Shape) -> Option<String> {
        None
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} := {value};")
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.unless("NOT ", test, "\n    AND ", " THEN");
        self.out.open(line);
        self.out.line(format!("status := {};\nRETURN;", status.number()));
        self.out.close("END_IF;");
    }
}

impl StructuredText<'_> {
    fn type_of(&self, shape: Shape) -> String {
        match shape {
            Shape::Count => "UDINT".to_owned(),
            Shape::Real => self.real.to_owned(),
            Shape::Reals(length) => format!("ARRAY[1..{length}] OF {}", self.real),
        }
    }

    fn function(&self, name: &str) -> &Function {
        let found = self.code.functions.iter().find(|function| function.name == name);
        found.unwrap_or_else(|| fault(format!("no function {name}")))
    }

    /// The functions that give what the controller keeps: outputs of the function block.
    fn outputs(&self) -> impl Iterator<Item = &Function> {
        let outputs = self.code.functions.iter().filter(|f| !["step", "arm"].contains(&f.name));
        outputs.inspect(|function| {
            if !function.body.is_empty() || !function.arguments.is_empty() {
                fault(format!("{} does more than to give what is kept", function.name));
            }
        })
    }

    fn text(mut self) -> String {
        let code = self.code;
        let name = &code.name;
        self.out.line("(*");
        for line in code.head.iter().map(String::as_str).chain(["", USE.trim_end()]) {
            let line = line.replace("(*", "( *").replace("*)", "* )");
            self.out
                .line(line.split('\n').map(|l| format!("  {l}")).collect::<Vec<_>>().join("\n"));
        }
        self.out.line("*)\n");
        if !code.parameters.is_empty() {
            self.structure("params", code.parameters.iter().map(|p| (p.name.clone(), p)));
        }
        let fields = code.fields.iter().map(|field| (self.local(&field.name), field));
        let fields: Vec<_> = fields.collect();
        self.structure("fields", fields.into_iter());
        for (function, about, body) in [
            ("ticks", "a - b, modulo 2^32.", TICKS),
            ("left", "a - b, 0 where b is greater.", LEFT),
        ] {
            let result = format!("{name}_{function}");
            self.out.line(format!("(* {about} *)\nFUNCTION {result} : UDINT\nVAR_INPUT"));
            self.out.line("    a : UDINT;\n    b : UDINT;\nEND_VAR");
            self.out.line(body.replace("RESULT", &result));
            self.out.line("END_FUNCTION\n");
        }
        self.out.line(format!("FUNCTION_BLOCK {name}"));
        self.variables();
        self.out.line(format!("u := {};", self.literal("0.0")));
        self.out.open("IF init THEN");
        self.block(&code.init);
        self.give();
        self.out.line("ready := TRUE;\nstatus := 0;");
        self.out.turn("ELSIF arm THEN");
        self.out.line("status := -1;");
        self.out.open("IF ready THEN");
        let arm = self.function("arm").clone();
        self.block(&arm.body);
        self.out.line("status := 0;");
        self.out.close("END_IF;");
        self.out.turn("ELSIF NOT ready THEN");
        self.out.line("status := -2;");
        self.out.turn("ELSE");
        let step = self.function("step").clone();
        self.block(&step.body);
        if let Some(value) = step.results.first().and_then(|given| given.values.first()) {
            let line = format!("u := {};", self.alone(value));
            self.out.line(line);
        }
        self.give();
        self.outcomes(&step.status, &|status| format!("status := {};", status.number()));
        self.out.close("END_IF;");
        self.out.line("END_FUNCTION_BLOCK");
        self.out.text()
    }

    fn structure<'v>(
        &mut self,
        kind: &str,
        members: impl Iterator<Item = (String, &'v crate::code::Variable)>,
    ) {
        self.out.line(format!("TYPE {}_{kind} :", self.code.name));
        self.out.open("STRUCT");
        for (name, member) in members {
            let (kind, about) = (self.type_of(member.shape), &member.about);
            self.out.line(format!("{name} : {kind}; (* {about} *)"));
        }
        self.out.close("END_STRUCT\nEND_TYPE\n");
    }

    fn variables(&mut self) {
        let (code, name) = (self.code, &self.code.name);
        let (arm, step) = (self.function("arm").clone(), self.function("step").clone());
        self.out.open("VAR_INPUT");
        self.out.line("init : BOOL; (* take the parameters and start at tick 0 *)");
        if !code.parameters.is_empty() {
            self.out.line(format!("params : {name}_params;"));
        }
        self.out.line("arm : BOOL; (* start again at tick k *)");
        for argument in &step.arguments {
            let (name, about) = (self.local(&argument.name), &argument.about);
            self.out.line(format!("{name} : {}; (* {about} *)", self.type_of(argument.shape)));
        }
        self.out.close("END_VAR");
        self.out.open("VAR_OUTPUT");
        self.out.line(format!("u : {}; (* input of the plant *)", self.real));
        self.out.line("status : INT; (* see the head *)");
        let outputs: Vec<_> = self.outputs().cloned().collect();
        for function in &outputs {
            if let Some(given) = function.results.first() {
                let (kind, about) = (self.type_of(given.variable.shape), &function.about);
                self.out.line(format!("{} : {kind}; (* {about} *)", function.name));
            }
        }
        self.out.close("END_VAR");
        self.out.open("VAR");
        self.out.line(format!("ready : BOOL;\nself : {name}_fields;"));
        self.out.close("END_VAR");
        let mut locals = BTreeMap::new();
        for body in [&code.init, &arm.body, &step.body] {
            declared(body, &mut locals);
        }
        self.out.open("VAR_TEMP");
        for (name, shape) in locals {
            self.out.line(format!("{} : {};", self.local(&name), self.type_of(shape)));
        }
        self.out.close("END_VAR\n");
    }

    /// Sets the outputs that show what is kept.
    fn give(&mut self) {
        let outputs: Vec<_> = self.outputs().cloned().collect();
        for function in outputs {
            let Some(given) = function.results.first() else { continue };
            let array = length(given.variable.shape).is_some();
            for (index, value) in given.values.iter().enumerate() {
                let place = if array {
                    self.element(function.name, index)
                } else {
                    function.name.to_owned()
                };
                let value = self.alone(value);
                self.out.line(format!("{place} := {value};"));
            }
        }
    }
}

/// How the function block is used.
const USE: &str = include_str!("../../../templates/sampled.st.txt");

const TICKS: &str = "\
IF b <= a THEN
    RESULT := a - b;
ELSE
    RESULT := (UDINT#4294967295 - b) + a + UDINT#1;
END_IF;";

const LEFT: &str = "\
IF b < a THEN
    RESULT := a - b;
ELSE
    RESULT := UDINT#0;
END_IF;";
