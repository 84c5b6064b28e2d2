//! C99: a header and a source file.

mod assumptions;
mod conditions;
mod guard;
mod header;
mod hosts;
mod source;
mod statement;
mod target;

use std::collections::BTreeMap;

pub(in crate::emit) use assumptions::assumptions;
pub(in crate::emit) use conditions::{Condition, domain, start_tests, written, zero_tests};
pub(in crate::emit) use guard::once;
pub(in crate::emit) use hosts::refuse_macros;
pub(in crate::emit) use target::{TARGET, files_with_proof, real, sampled_files_with_proof};

use super::apart::apart;
use super::text::{Level, Lines, Text, bare};
use crate::code::{Access, Callback, Code, Constant, Function, Owner, Shape, Status};
use crate::emit::File;
use crate::parameter::Precision;

/// The lines behind an iteration with a tolerance, in numbers of a type.
type Behind = fn(root: &str, tolerance: &str, real: &str) -> Vec<String>;

/// Annotations added to the files of a controller for a proof.
#[derive(Default)]
pub(in crate::emit) struct Notes {
    /// Predicates of the contracts.
    pub(in crate::emit) predicates: String,
    /// Contracts by the names of functions, each a comment before a prototype.
    pub(in crate::emit) contracts: BTreeMap<&'static str, String>,
    /// The lines before the tests of `init`.
    pub(in crate::emit) before_tests: Option<&'static str>,
    /// The lines behind an iteration.
    pub(in crate::emit) behind: Option<Behind>,
}

/// The header and the source of a controller.
pub(in crate::emit) fn files(code: &Code, notes: &Notes) -> Vec<File> {
    let name = &code.name;
    let printer = || C::new(code, notes);
    let (header, source) = (printer().header(), printer().source());
    [(format!("{name}.h"), header), (format!("{name}.c"), source)]
        .into_iter()
        .map(|(file, text)| apart(File { name: file, text }, name))
        .collect()
}

/// Type and name of what a function takes for the functions of the user's that it calls.
pub(in crate::emit) fn externs(name: &str, callbacks: &[Callback]) -> Vec<(String, &'static str)> {
    let call = |callback: &Callback| (format!("{name}_{} ", callback.name), callback.name);
    let mut externs: Vec<_> = callbacks.iter().map(call).collect();
    if !externs.is_empty() {
        externs.push(("void *".to_owned(), "context"));
    }
    externs
}

pub(super) struct C<'a> {
    code: &'a Code,
    notes: &'a Notes,
    /// Prefix of the access to a field.
    owner: &'static str,
    /// Value of the variable `status`, where it is known.
    standing: Option<Status>,
    /// Number of inputs that the function returns, if several.
    inputs: Option<usize>,
    /// True if scalar results are 0 from the start.
    zeroed: bool,
    /// True if the text is for another file, which lacks the macros of the source.
    outside: bool,
    /// The local value that is stored as soon as it is known, and the result that it is.
    stored: Option<(String, String)>,
    out: Lines,
}

impl Text for C<'_> {
    fn as_text(&self) -> &dyn Text {
        self
    }

    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn field(&self, name: &str) -> String {
        format!("{}{name}", self.owner)
    }

    fn parameter(&self, name: &str) -> String {
        format!("params->{name}")
    }

    fn table(&self, name: &str) -> String {
        format!("{}_{name}", self.code.name)
    }

    fn constant(&self, own: &Constant) -> String {
        self.table(&own.name).to_uppercase()
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let suffix = if self.code.precision == Precision::F32 { "f" } else { "" };
        let function = if function == "ln" { "log" } else { function };
        format!("{function}{suffix}({})", arguments.join(", "))
    }

    fn fused(&self, operands: &[String; 3]) -> Option<String> {
        Some(self.call("fma", operands))
    }

    fn abs(&self, a: &str) -> String {
        self.call("fabs", &[a.to_owned()])
    }

    fn quotient(&self, a: &str, b: &str) -> (Level, String) {
        // A quotient between ? and : is a breach of MISRA's rule 12.1 as cppcheck reads it.
        (Level::Product, format!("{a} / ({})", self.divisor(b).1))
    }

    fn nan(&self) -> String {
        format!("({})NAN", self.type_of(Shape::Real))
    }

    fn callback(&self, name: &str, array: &str, time: &str) -> String {
        format!("{name}(context, {array}, {time})")
    }

    fn real(&self, count: &str) -> (Level, String) {
        let atom = count.bytes().all(|b| b.is_ascii_alphanumeric() || b"_->.".contains(&b));
        let count = if atom { count.to_owned() } else { format!("({count})") };
        (Level::Sign, format!("({}){count}", self.type_of(Shape::Real)))
    }

    fn status(&self, status: Status) -> String {
        word(status).to_owned()
    }

    fn finite(&self, value: &str) -> String {
        match self.outside {
            true => format!("(isfinite({value}) != 0)"),
            false => self.code.precision.finite_in_c(&bare(value.to_owned())),
        }
    }

    fn not_number(&self, value: &str) -> String {
        match self.outside {
            true => format!("(isnan({value}) != 0)"),
            false => self.code.precision.nan_in_c(&bare(value.to_owned())),
        }
    }
}

impl<'a> C<'a> {
    pub(super) fn new(code: &'a Code, notes: &'a Notes) -> Self {
        let out = Lines::default();
        Self {
            code,
            notes,
            owner: "self->",
            standing: None,
            inputs: None,
            zeroed: false,
            outside: false,
            stored: None,
            out,
        }
    }

    /// A printer of text for other files than the source.
    fn outside(code: &'a Code, notes: &'a Notes) -> Self {
        Self { outside: true, ..Self::new(code, notes) }
    }

    fn type_of(&self, shape: Shape) -> String {
        match (shape, self.code.precision) {
            (Shape::Gains, _) => format!("{}_gains", self.code.name),
            (Shape::Count, _) => "uint32_t".to_owned(),
            (Shape::Statuses(_), _) => "ptc_status".to_owned(),
            (_, Precision::F32) => "float".to_owned(),
            (_, Precision::F64) => "double".to_owned(),
        }
    }

    fn init_signature(&self) -> String {
        let name = &self.code.name;
        let mut list = vec![format!("{name} *self"), format!("const {name}_params *params")];
        if let Some(state) = self.code.start.as_ref().and_then(|start| start.state.as_ref()) {
            list.push(self.argument(&state.name, state.shape));
        }
        self.declared("init", &list)
    }

    fn argument(&self, name: &str, shape: Shape) -> String {
        let kind = self.type_of(shape);
        match (shape, shape.length()) {
            (Shape::Lists(count, n), _) => format!("const {kind} {name}[{count}][{n}]"),
            (_, Some(n)) => format!("const {kind} {name}[{n}]"),
            (_, None) => format!("{kind} {name}"),
        }
    }

    fn declared(&self, function: &str, list: &[String]) -> String {
        let open = format!("ptc_status {}_{function}(", self.code.name);
        let line = format!("{open}{})", list.join(", "));
        match self.out.has_room(&format!("{line};")) {
            true => line,
            false => format!("{open}\n    {})", list.join(",\n    ")),
        }
    }

    fn signature(&self, function: &Function) -> String {
        let name = &self.code.name;
        let constant = if function.access == Access::Read { "const " } else { "" };
        let mut list = vec![match function.owner {
            Owner::Controller => format!("{constant}{name} *self"),
            Owner::Gains => format!("{constant}{name}_gains *gains"),
        }];
        list.extend(function.arguments.iter().map(|a| self.argument(&a.name, a.shape)));
        let externs = externs(name, &function.callbacks);
        list.extend(externs.into_iter().map(|(kind, argument)| format!("{kind}{argument}")));
        for result in &function.results {
            let (kind, result, length) =
                (self.type_of(result.shape), &result.name, result.shape.length());
            list.push(match length {
                Some(n) => format!("{kind} {result}[{n}]"),
                None => format!("{kind} *{result}"),
            });
        }
        self.declared(function.name, &list)
    }
}

/// The word of a status.
pub(in crate::emit) fn word(status: Status) -> &'static str {
    match status {
        Status::Ok => "PTC_OK",
        Status::Hold => "PTC_HOLD",
        Status::Saturated => "PTC_SATURATED",
        Status::After => "PTC_AFTER",
        Status::Gated => "PTC_GATED",
        Status::Late => "PTC_LATE",
        Status::Infeasible => "PTC_INFEASIBLE",
        Status::Param => "PTC_E_PARAM",
        Status::Input => "PTC_E_INPUT",
        Status::Range => "PTC_E_RANGE",
        Status::Soon => "PTC_E_SOON",
    }
}
