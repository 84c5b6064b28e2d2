//! C++17: one header, in which all that calls no function of a library is `constexpr`.

mod block;
mod header;
mod target;
mod text;

pub(in crate::emit) use target::TARGET;

use super::block::{Block, Ends};
use super::called::{calls_library, paired};
use super::gives::Gives;
use super::text::{Lines, Text};
use crate::code::{Access, Code, Finish, Function, Shape, Status};
use crate::emit::File;
use crate::internal::fault;
use crate::parameter::Precision;

/// The header of a controller.
pub(in crate::emit) fn file(code: &Code) -> File {
    File { name: format!("{}.hpp", code.name), text: Cpp::new(code).header() }
}

pub(super) struct Cpp<'a> {
    code: &'a Code,
    /// Result of the function being printed.
    gives: Gives,
    /// The text around the name of a field.
    prefix: &'static str,
    suffix: &'static str,
    out: Lines,
}

impl<'a> Cpp<'a> {
    pub(super) fn new(code: &'a Code) -> Self {
        Self { code, gives: Gives::Status, prefix: "", suffix: "_", out: Lines::default() }
    }

    fn real_type(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "float" } else { "double" }
    }

    fn type_of(&self, shape: Shape) -> String {
        let real = self.real_type();
        match shape {
            Shape::Count => "std::uint32_t".to_owned(),
            Shape::Real => real.to_owned(),
            Shape::Reals(length) => format!("std::array<{real}, {length}>"),
            Shape::Lists(count, length) => {
                format!("std::array<std::array<{real}, {length}>, {count}>")
            }
            Shape::Statuses(count) => format!("std::array<Status, {count}>"),
            Shape::Gains => "Gains".to_owned(),
        }
    }

    fn function(&mut self, function: &Function) {
        let real = self.real_type();
        self.gives = Gives::of(function);
        let given = || {
            let result = function.results.first().unwrap_or_else(|| fault("nothing to give"));
            self.type_of(result.shape)
        };
        let result = match self.gives {
            Gives::Nothing => "void".to_owned(),
            Gives::Status | Gives::Progress => "Status".to_owned(),
            Gives::Control => format!("Control<{real}>"),
            Gives::Rate => format!("Rate<{}>", given()),
            Gives::Value | Gives::Values | Gives::Count => format!("Value<{}>", given()),
            Gives::Gains | Gives::Array | Gives::Number => given(),
            Gives::Axes => {
                let Some(axes) = self.code.axes() else { fault("axes of a controller of one") };
                format!("Axes<{real}, {axes}>")
            }
        };
        let mut list: Vec<_> = function
            .arguments
            .iter()
            .map(|argument| {
                let (kind, name) = (self.type_of(argument.shape), &argument.name);
                match argument.shape.length() {
                    Some(_) => format!("const {kind}& {name}"),
                    None => format!("{kind} {name}"),
                }
            })
            .collect();
        let kinds: Vec<_> = function.callbacks.iter().map(|callback| kind(callback.name)).collect();
        let called = function.callbacks.iter().zip(&kinds);
        list.extend(called.map(|(callback, kind)| format!("{kind}&& {}", callback.name)));
        self.out.line("");
        self.out.words("/// ", &function.about);
        for callback in &function.callbacks {
            self.out.words("/// ", &format!("`{}`: {}", callback.name, callback.about));
        }
        if self.gives == Gives::Progress {
            self.out.line("/// On a negative status nothing has changed.");
        } else if function.failures.contains(&Status::Range) && self.gives != Gives::Axes {
            self.out.line("/// On a negative status u is 0 and nothing has changed.");
        } else if self.gives == Gives::Status {
            self.out.line("/// Ok, or Param with nothing changed.");
        }
        if !kinds.is_empty() {
            let kinds: Vec<_> = kinds.iter().map(|kind| format!("class {kind}")).collect();
            self.out.line(format!("template <{}>", kinds.join(", ")));
        }
        let typed = matches!(
            self.gives,
            Gives::Control
                | Gives::Rate
                | Gives::Value
                | Gives::Values
                | Gives::Count
                | Gives::Gains
                | Gives::Nothing
                | Gives::Axes
        );
        let discard = if typed { "" } else { "[[nodiscard]] " };
        let constant = if calls_library(function) { "" } else { "constexpr " };
        let access = if function.access == Access::Read { " const" } else { "" };
        let throws = if kinds.is_empty() { " noexcept" } else { "" };
        let (name, list) = (function.name, list.join(", "));
        self.out.line(format!("{discard}{constant}{result} {name}({list}){access}{throws}"));
        self.out.open("{");
        self.work(function);
        self.out.close("}");
    }

    fn work(&mut self, function: &Function) {
        if function.owner == crate::code::Owner::Gains {
            let zero = self.literal("0.0");
            self.out
                .line(format!("if (status < Status::Ok) {{\n    return {{{zero}, status}};\n}}"));
        }
        if let (Finish::Stands, Some(count)) = (&function.finish, self.code.axes()) {
            let real = self.real_type();
            self.out.line(format!("Axes<{real}, {count}> all{{}};"));
            self.block(&function.body);
            return self.out.line("return all;");
        }
        self.block(&function.body);
        if self.gives == Gives::Gains {
            self.out.line("Gains gains{};");
            let values = function.finish.every();
            let places = self.code.gains.iter().flat_map(|field| match field.shape.length() {
                Some(n) => (0..n).map(|i| format!("{}[{i}]", field.name)).collect(),
                None => vec![field.name.clone()],
            });
            for (place, value) in paired(places, values) {
                let value = self.alone(value);
                self.out.line(format!("gains.{place} = {value};"));
            }
        }
        self.finish(&function.finish);
        if self.gives == Gives::Gains {
            self.out.line("return gains;");
        }
    }
}

/// The type of a function of the user's.
fn kind(callback: &str) -> &'static str {
    if callback == "pi0" { "Pi0" } else { "Then" }
}

fn word(status: Status) -> String {
    format!("Status::{}", status.name())
}
