//! Rust: `no_std`, no allocation, no panic, no unsafe code.

use super::block::{Block, Branch};
use super::text::{Level, Lines, Text, bracketed, length};
use crate::code::{
    Access, Code, Expr, Function, Outcomes, Place, Shape, Statement, Status, Test, Variable,
};
use crate::emit::{File, rust::module_text};
use crate::parameter::{Precision, type_name};

struct Rust<'a> {
    code: &'a Code,
    /// Path of the types that the items stand on.
    runtime: &'static str,
    out: Lines,
}

/// The file of a controller, which stands alone.
pub(in crate::emit) fn file(code: &Code) -> File {
    let items = Rust { code, runtime: "", out: Lines::default() }.items();
    let text = module_text(&code.head, code.precision, &items);
    File { name: format!("{}.rs", code.name), text }
}

/// The items alone, on the types of the facade crate.
pub(in crate::emit) fn items(code: &Code) -> String {
    Rust { code, runtime: "::ptc::", out: Lines::default() }.items()
}

impl Text for Rust<'_> {
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

    fn count_sub(&self, a: &str, b: &str) -> (Level, String) {
        (Level::Atom, format!("{a}.wrapping_sub({b})"))
    }

    fn count_left(&self, a: &str, b: &str) -> (Level, String) {
        let typed = a.bytes().all(|b| b.is_ascii_digit());
        (Level::Atom, format!("{a}{}.saturating_sub({b})", if typed { "_u32" } else { "" }))
    }

    fn count_half(&self, count: &str) -> (Level, String) {
        (Level::Product, format!("{count} / 2"))
    }

    fn real(&self, count: &str) -> (Level, String) {
        // In brackets wherever it is compared: `<` behind a type opens its arguments.
        (Level::Choice, format!("{} as {}", bracketed(count), self.type_of(Shape::Real)))
    }

    fn choose(&self, test: &str, yes: &str, no: &str) -> (Level, String) {
        (Level::Choice, format!("if {test} {{ {yes} }} else {{ {no} }}"))
    }

    fn finite(&self, value: &str) -> String {
        format!("{value}.is_finite()")
    }
}

impl Block for Rust<'_> {
    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        Branch { open: "if ", turn: "} else if ", then: " {", otherwise: "} else {", end: "}" }
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("// ", "")
    }

    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        Some(format!("let {name}: {};", self.type_of(shape)))
    }

    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    /// A choice is a block each way where rustfmt makes it one.
    fn value(&self, value: &Expr) -> String {
        let text = self.alone(value);
        match value {
            Expr::Choose(test, yes, no) if text.len() > CHOICE => {
                let (test, yes, no) = (self.test(test), self.alone(yes), self.alone(no));
                format!("if {test} {{\n    {yes}\n}} else {{\n    {no}\n}}")
            }
            _ => text,
        }
    }

    fn require(&mut self, test: &Test, status: Status) {
        let line = self.unless("!", test, "\n    && ", " {");
        let line = if line.contains('\n') { line.replace(") {", ")\n{") } else { line };
        self.out.open(line);
        self.out.line(format!("return Err({}Error::{});", self.runtime, status.name()));
        self.out.close("}");
    }
}

/// Columns of an array in one line.
const ARRAY: usize = 58;

/// Columns of the fields of a structure in one line.
const FIELDS: usize = 18;

/// Columns of a choice in one line.
const CHOICE: usize = 50;

impl Rust<'_> {
    fn type_of(&self, shape: Shape) -> String {
        let real = if self.code.precision == Precision::F32 { "f32" } else { "f64" };
        match shape {
            Shape::Count => "u32".to_owned(),
            Shape::Real => real.to_owned(),
            Shape::Reals(length) => format!("[{real}; {length}]"),
        }
    }

    fn structure(&mut self, name: &str, about: &str, members: &[Variable], public: bool) {
        self.out.line(format!("/// {about}"));
        self.out.line("#[derive(Clone, Copy, Debug, PartialEq)]");
        self.out.line("#[allow(non_snake_case)]");
        if members.is_empty() {
            return self.out.line(format!("pub struct {name} {{}}\n"));
        }
        self.out.open(format!("pub struct {name} {{"));
        for member in members {
            let kind = self.type_of(member.shape);
            self.out.line(format!("/// {}.", doc(&member.about)));
            let public = if public { "pub " } else { "" };
            self.out.line(format!("{public}{}: {kind},", member.name));
        }
        self.out.close("}");
        self.out.line("");
    }

    fn items(mut self) -> String {
        let (code, runtime) = (self.code, self.runtime);
        let kind = type_name(&code.name);
        let about = format!("Run-time parameters of [`{kind}`].");
        self.structure(&format!("{kind}Params"), &about, &code.parameters, true);
        self.structure(&kind, "Prescribed-time controller in samples.", &code.fields, false);
        self.out.line(ALLOWED);
        self.out.open(format!("impl {kind} {{"));
        self.out.line("/// Takes the parameters and arms at tick 0.");
        self.out.line("///");
        self.out.line("/// # Errors");
        self.out.line("/// `Param`: a parameter is outside its domain, or the coefficients derived from it overflow.");
        let result = format!(" -> Result<Self, {runtime}Error>");
        self.signature("new", &[format!("params: {kind}Params")], &result);
        let mut fields = Vec::new();
        for statement in &code.init {
            match statement {
                Statement::Set(Place::Field(name), value) => {
                    let value = self.alone(value);
                    fields.push(if *name == value { value } else { format!("{name}: {value}") });
                }
                other => self.statement(other),
            }
        }
        if fields.join(", ").len() <= FIELDS {
            self.out.line(format!("Ok(Self {{ {} }})", fields.join(", ")));
        } else {
            self.out.open("Ok(Self {");
            for field in fields {
                self.out.line(format!("{field},"));
            }
            self.out.close("})");
        }
        self.out.close("}");
        for function in &code.functions {
            self.function(function);
        }
        self.out.close("}");
        self.out.text()
    }

    fn function(&mut self, function: &Function) {
        let runtime = self.runtime;
        let access = if function.access == Access::Read { "&self" } else { "&mut self" };
        let mut list = vec![access.to_owned()];
        for argument in &function.arguments {
            let kind = self.type_of(argument.shape);
            let by = if length(argument.shape).is_some() { "&" } else { "" };
            list.push(format!("{}: {by}{kind}", argument.name));
        }
        let value = match function.results.as_slice() {
            [given] if function.name == "step" => {
                format!("{runtime}Control<{}>", self.type_of(given.variable.shape))
            }
            [given] => self.type_of(given.variable.shape),
            _ => "()".to_owned(),
        };
        let fails = !function.failures.is_empty();
        let result = match (fails, function.results.is_empty()) {
            (true, _) => format!(" -> Result<{value}, {runtime}Error>"),
            (false, true) => String::new(),
            (false, false) => format!(" -> {value}"),
        };
        self.out.line("");
        self.out.words("/// ", &doc(&function.about));
        if fails {
            let errors = function.failures.iter().map(|status| match status {
                Status::Input => "`Input`: an argument is not finite.",
                _ => "`Range`: u is not finite.",
            });
            let errors: Vec<_> = errors.collect();
            for line in ["", " # Errors", &format!(" {}", errors.join(" "))] {
                self.out.line(format!("///{line}"));
            }
        }
        self.out.line("#[inline]");
        self.signature(function.name, &list, &result);
        self.block(&function.body);
        self.finish(function, fails);
        self.out.close("}");
    }

    fn signature(&mut self, name: &str, list: &[String], result: &str) {
        let line = format!("pub fn {name}({}){result} {{", list.join(", "));
        if self.out.has_room(&line) {
            return self.out.open(line);
        }
        self.out.open(format!("pub fn {name}("));
        for argument in list {
            self.out.line(format!("{argument},"));
        }
        self.out.turn(format!("){result} {{"));
    }

    fn finish(&mut self, function: &Function, fails: bool) {
        let [given] = function.results.as_slice() else { return };
        let values: Vec<_> = given.values.iter().map(|value| self.alone(value)).collect();
        if function.name != "step" {
            let value = match length(given.variable.shape) {
                Some(_) if values.join(", ").len() > ARRAY => {
                    format!("[\n    {},\n]", values.join(",\n    "))
                }
                Some(_) => format!("[{}]", values.join(", ")),
                None => values.join(", "),
            };
            self.out.line(if fails { format!("Ok({value})") } else { value });
            return;
        }
        let runtime = self.runtime;
        let word = |status: Status| format!("{runtime}Status::{}", status.name());
        match &function.status {
            Outcomes::One(status) => {
                self.out.line(format!("let status = {};", word(*status)));
            }
            Outcomes::First(ways, last) => {
                let ways = self.ways(ways);
                let short = match ways.as_slice() {
                    [(test, status)] => {
                        format!("if {test} {{ {} }} else {{ {} }}", word(*status), word(*last))
                    }
                    _ => String::new(),
                };
                if (1..=CHOICE).contains(&short.len()) {
                    self.out.line(format!("let status = {short};"));
                } else {
                    for (index, (test, status)) in ways.into_iter().enumerate() {
                        match index {
                            0 => self.out.open(format!("let status = if {test} {{")),
                            _ => self.out.turn(format!("}} else if {test} {{")),
                        }
                        self.out.line(word(status));
                    }
                    self.out.turn("} else {");
                    self.out.line(word(*last));
                    self.out.close("};");
                }
            }
        }
        let u = if values[0] == "u" { "u".to_owned() } else { format!("u: {}", values[0]) };
        self.out.line(format!("Ok({runtime}Control {{ {u}, status }})"));
    }
}

/// What the lints need not judge: names and shape follow the formulas.
const ALLOWED: &str = "\
#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]";

/// Text as rustdoc, which takes brackets for links.
fn doc(text: &str) -> String {
    text.replace('[', "\\[").replace(']', "\\]")
}
