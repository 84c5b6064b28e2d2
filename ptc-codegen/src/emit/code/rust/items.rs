//! The items: structures, functions and the trait.

use super::super::block::{Block, Ends};
use super::super::gives::Gives;
use super::super::text::{Text, capital};
use super::{CHOICE, Rust};
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Variable,
};
use crate::internal::fault;
use crate::parameter::type_name;

/// Columns of the fields of a structure in one line.
const FIELDS: usize = 18;

impl Rust<'_> {
    pub(super) fn items(mut self) -> String {
        let code = self.code;
        let kind = type_name(&code.name);
        let about = format!("Run-time parameters of [`{kind}`].");
        self.structure(&format!("{kind}Params"), &about, &code.parameters, true);
        // In a file the head stands above all.
        let head = if self.runtime.is_empty() { "" } else { &format!(" {}", code.head.join(" ")) };
        let about = format!("{}.{head}", code.title());
        self.structure(&kind, &about, &code.fields, false);
        if !code.gains.is_empty() {
            let about = format!("Feedback gains of [`{kind}`] at one time.");
            self.structure(&format!("{kind}Gains"), &about, &code.gains, true);
        }
        self.out.line(ALLOWED);
        self.out.open(format!("impl {kind} {{"));
        self.constants();
        self.tables();
        self.init(&kind);
        for function in code.functions.iter().filter(|f| f.owner == Owner::Controller) {
            self.function(function);
        }
        code.subroutines().into_iter().for_each(|of| self.subroutine(of));
        self.out.close("}");
        if !code.gains.is_empty() {
            self.out.line("");
            self.out.line(ALLOWED);
            self.out.open(format!("impl {kind}Gains {{"));
            for function in code.functions.iter().filter(|f| f.owner == Owner::Gains) {
                self.function(function);
            }
            self.out.close("}");
        }
        self.implementation(&kind);
        self.out.text()
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
        if name.ends_with("Gains") && public {
            self.out.line("/// `Ok` or `Hold`.");
            self.out.line(format!("pub status: {}Status,", self.runtime));
        }
        self.out.close("}");
        self.out.line("");
    }

    fn constants(&mut self) {
        let constants = self.code.constants();
        for own in &constants {
            let (name, value) = (own.name.to_uppercase(), self.literal_of(own));
            let kind = self.type_of(own.shape);
            self.out.line(format!("/// {}.", doc(&capital(&own.described()))));
            self.out.line(format!("const {name}: {kind} = {value};"));
        }
        if !constants.is_empty() {
            self.out.line("");
        }
    }

    fn tables(&mut self) {
        let (code, real) = (self.code, self.type_of(Shape::Real));
        for table in &code.tables {
            let (rows, columns) = (table.rows.len(), table.columns());
            let name = table.name.to_uppercase();
            self.out.line(format!("/// {}.", doc(&capital(&table.about))));
            self.out.line("#[rustfmt::skip]");
            self.out.open(format!("const {name}: &'static [[{real}; {columns}]; {rows}] = &["));
            for row in self.rows(table) {
                self.out.line(format!("[{}],", row.join(", ")));
            }
            self.out.close("];\n");
        }
    }

    fn init(&mut self, kind: &str) {
        let (code, runtime) = (self.code, self.runtime);
        let quoted = |text: String, name: &str| text.replace(name, &format!("`{name}`"));
        let starts = ["params.t0", "params.tau"].into_iter().fold(code.starts(), quoted);
        self.out.words("/// ", &starts);
        self.out.line("///");
        self.out.line("/// # Errors");
        self.out.line("/// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.");
        let result = format!(" -> Result<Self, {runtime}Error>");
        let mut list = vec![format!("params: {kind}Params")];
        let state = code.start.as_ref().and_then(|start| start.state.as_ref());
        list.extend(state.map(|state| format!("{}: &{}", state.name, self.type_of(state.shape))));
        self.signature("new", &list, &result);
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
        let Some(start) = &code.start else {
            self.built("Ok(Self", &fields, ")");
            return self.out.close("}");
        };
        self.built("let mut built = Self", &fields, ";");
        let mut list: Vec<_> = start.numbers().map(|number| self.alone(number)).collect();
        list.extend(state.map(|state| state.name.clone()));
        let (called, list) = (start.function(), list.join(", "));
        self.out.line(format!("built.{called}({list})?;\nOk(built)"));
        self.out.close("}");
    }

    fn built(&mut self, before: &str, fields: &[String], behind: &str) {
        if fields.join(", ").len() <= FIELDS {
            return self.out.line(format!("{before} {{ {} }}{behind}", fields.join(", ")));
        }
        self.out.open(format!("{before} {{"));
        for field in fields {
            self.out.line(format!("{field},"));
        }
        self.out.close(format!("}}{behind}"));
    }

    fn function(&mut self, function: &Function) {
        let runtime = self.runtime;
        self.gives = Gives::of(function);
        let access = if function.access == Access::Read { "&self" } else { "&mut self" };
        let mut list = vec![access.to_owned()];
        for argument in &function.arguments {
            let kind = self.type_of(argument.shape);
            let by = if argument.shape.length().is_some() { "&" } else { "" };
            list.push(format!("{}: {by}{kind}", argument.name));
        }
        let real = self.type_of(Shape::Real);
        for callback in &function.callbacks {
            let (name, given) = (callback.name, self.type_of(Shape::Reals(callback.length)));
            list.push(match callback.gives {
                1 => format!("{name}: impl FnOnce(&{given}, {real}) -> {real}"),
                count => {
                    format!("{name}: impl FnOnce(&{given}, {real}, {real}) -> [{real}; {count}]")
                }
            });
        }
        let given = function.results.first().map(|result| self.type_of(result.shape));
        let given = given.unwrap_or_else(|| "()".to_owned());
        let result = match self.gives {
            Gives::Nothing => String::new(),
            Gives::Control => format!(" -> Result<{runtime}Control<{given}>, {runtime}Error>"),
            Gives::Array | Gives::Number => format!(" -> {given}"),
            Gives::Axes => {
                let count = self.code.axes().unwrap_or_default();
                format!(" -> {runtime}Axes<{count}, {real}>")
            }
            Gives::Progress => format!(" -> Result<{runtime}Status, {runtime}Error>"),
            _ => format!(" -> Result<{given}, {runtime}Error>"),
        };
        self.out.gap();
        self.out.words("/// ", &doc(&function.about));
        for callback in &function.callbacks {
            self.out.words("/// ", &doc(&format!("`{}`: {}", callback.name, callback.about)));
        }
        if result.contains("Error") {
            let counts = function.arguments.iter().any(|own| own.shape == Shape::Count);
            let errors = function.failures.iter().map(|status| match status {
                Status::Soon => "`Soon`: a limit could be exceeded with so few samples, or with any.",
                Status::Param if function.takes_duration() => "`Param`: an argument or what follows from it is not finite, or `tau` is outside its domain; nothing has changed.",
                Status::Param if counts => "`Param`: the number of samples is out of its range.",
                Status::Param => "`Param`: an argument or what follows from it is not finite; nothing has changed.",
                Status::Input => "`Input`: an argument is not finite or out of its domain.",
                _ if self.gives == Gives::Count => "`Range`: a state is too large to compute with.",
                _ if self.gives == Gives::Progress => "`Range`: an estimate is not finite. Nothing has changed.",
                _ if matches!(self.gives, Gives::Value | Gives::Values) => "`Range`: what is given is not finite.",
                _ => "`Range`: u is not finite.",
            });
            let errors: Vec<_> = errors.collect();
            let errors = if errors.is_empty() { "None.".to_owned() } else { errors.join(" ") };
            self.out.line("///\n/// # Errors");
            self.out.words("/// ", &errors);
        }
        self.out.line("#[inline]");
        self.signature(&method(function.name), &list, &result);
        if let (Finish::Stands, Some(count)) = (&function.finish, self.code.axes()) {
            self.inputs(function, count);
            return self.out.close("}");
        }
        self.block(&function.body);
        let same = function.finish.results();
        let here = self.out.here();
        match self.gives {
            Gives::Gains => {
                let lead = "let status = ";
                self.lead = (here, lead);
                self.finish(&function.finish);
                self.out.wrap(here, lead, ";", CHOICE);
                self.gains(&given, function.finish.every());
            }
            Gives::Control => {
                self.together = same.is_none();
                let lead = if self.together { "let (u, status) = " } else { "let status = " };
                self.lead = (here, lead);
                self.finish(&function.finish);
                self.out.wrap(here, lead, ";", CHOICE);
                let u = match same {
                    Some(values) => format!("u: {}", self.list(values).join(", ")),
                    None => "u".to_owned(),
                };
                self.out.line(format!("Ok({runtime}Control {{ {u}, status }})"));
            }
            _ => self.finish(&function.finish),
        }
        self.out.close("}");
    }

    fn gains(&mut self, kind: &str, values: &[Expr]) {
        let mut values = self.list(values).into_iter();
        self.out.open(format!("Ok({kind} {{"));
        for field in &self.code.gains {
            let name = &field.name;
            let value = match field.shape.length() {
                Some(n) => {
                    let own: Vec<_> = values.by_ref().take(n).collect();
                    self.array_text("[", &own, "]")
                }
                None => values.next().unwrap_or_else(|| fault("a gain without a value")),
            };
            self.out.line(format!("{name}: {value},"));
        }
        self.out.line("status,");
        self.out.close("})");
    }

    /// The type of the states.
    fn states(&self) -> String {
        let arguments = self.code.functions.iter().flat_map(|function| &function.arguments);
        let array = arguments.map(|argument| argument.shape).find(|shape| shape.length().is_some());
        self.type_of(array.unwrap_or(Shape::Reals(1)))
    }

    /// The trait of all controllers that need nothing but t and x.
    fn implementation(&mut self, kind: &str) {
        let (code, runtime) = (self.code, self.runtime);
        let (Some(arm), Some(step), Some(_)) =
            (code.function("arm"), code.function("step"), &code.start)
        else {
            return;
        };
        if code.axes().is_some()
            || arm.arguments.len() > 1
            || step.arguments.len() > 2
            || !step.callbacks.is_empty()
        {
            return;
        }
        let (real, array) = (self.type_of(Shape::Real), self.states());
        let n = step.arguments.iter().find_map(|argument| argument.shape.length()).unwrap_or(1);
        self.out.line("");
        self.out.open(format!("impl {runtime}Controller<{n}> for {kind} {{"));
        self.out.line(format!("type Real = {real};\n"));
        let result = format!(" -> Result<(), {runtime}Error>");
        self.method("fn arm", &["&mut self".to_owned(), format!("t0: {real}")], &result);
        self.out.line("Self::arm(self, t0)");
        self.out.close("}");
        self.out.line("");
        let result = format!(" -> Result<{runtime}Control<{real}>, {runtime}Error>");
        let list = ["&self".to_owned(), format!("t: {real}"), format!("x: &{array}")];
        self.method("fn step", &list, &result);
        self.out.line("Self::step(self, t, x)");
        self.out.close("}");
        self.out.close("}");
    }

    fn signature(&mut self, name: &str, list: &[String], result: &str) {
        self.method(&format!("pub fn {name}"), list, result);
    }

    fn method(&mut self, name: &str, list: &[String], result: &str) {
        let line = format!("{name}({}){result} {{", list.join(", "));
        if self.out.has_room(&line) {
            return self.out.open(line);
        }
        self.out.open(format!("{name}("));
        for argument in list {
            self.out.line(format!("{argument},"));
        }
        self.out.turn(format!("){result} {{"));
    }
}

/// Lints to allow: names and shape follow the formulas.
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

/// The name of a method: `move` is a word of the language.
fn method(name: &str) -> String {
    if name == "move" { format!("r#{name}") } else { name.to_owned() }
}
