//! The header: types and prototypes.

use super::super::gives::Gives;
use super::super::text::capital;
use super::guard::once;
use super::{C, word};
use crate::code::{Finish, Function, Shape, Status, Variable};

impl C<'_> {
    pub(super) fn header(mut self) -> String {
        let code = self.code;
        self.out.line("/*");
        for line in &code.head {
            self.out.line(format!(" * {line}"));
        }
        self.out.line(" */");
        let head = std::mem::take(&mut self.out).text();
        let arguments = code.functions.iter().flat_map(|function| &function.arguments);
        let mut variables = code.parameters.iter().chain(&code.fields).chain(arguments);
        if variables.any(|variable| variable.shape == Shape::Count) {
            self.out.line("#include <stdint.h>\n");
        }
        self.out.line("#ifdef __cplusplus\nextern \"C\" {\n#endif\n");
        self.out.line(include_str!("../../../../templates/status.h.txt"));
        self.types();
        if !self.notes.predicates.is_empty() {
            self.out.line(format!("{}\n", self.notes.predicates));
        }
        let untouched = "PTC_OK, or PTC_E_PARAM with *self untouched.";
        self.remark(&format!("{} {untouched}", code.starts()));
        let signature = self.init_signature();
        self.prototype("init", &signature);
        for function in &code.functions {
            self.out.line("");
            self.remark(&self.about(function));
            let signature = self.signature(function);
            self.prototype(function.name, &signature);
        }
        self.out.line("\n#ifdef __cplusplus\n}\n#endif");
        once(code, &head, &self.out.text(), "H")
    }

    fn prototype(&mut self, function: &str, signature: &str) {
        if let Some(contract) = self.notes.contracts.get(function) {
            self.out.line(contract);
        }
        self.out.line(format!("{signature};"));
    }

    fn about(&self, function: &Function) -> String {
        let about = function.about.trim_end();
        let code_axes = function.finish == Finish::Stands;
        let handed = match function.callbacks.is_empty() {
            true => "",
            false => " context is passed on unchanged.",
        };
        let failed = match function.results.as_slice() {
            _ if function.failures.is_empty() => String::new(),
            [] if Gives::of(function) == Gives::Progress => {
                " On a negative status nothing has changed.".to_owned()
            }
            [] => format!(" PTC_OK, or {} with *self untouched.", words(&function.failures)),
            [result] => match result.shape {
                Shape::Real => " On a negative status u is 0 and nothing has changed.".to_owned(),
                Shape::Gains => " On a negative status *gains is unchanged.".to_owned(),
                Shape::Reals(_) => format!(" On a negative status {} is 0.", result.name),
                _ => format!(" On a negative status {} is unchanged.", result.name),
            },
            _ if code_axes => String::new(),
            _ => " On a negative status nothing has changed.".to_owned(),
        };
        format!("{about}{handed}{failed}{}", apart(function))
    }

    fn types(&mut self) {
        let code = self.code;
        let name = &code.name;
        self.out.line("/* Run-time parameters. */");
        self.out.open(format!("typedef struct {name}_params {{"));
        self.members(&code.parameters);
        if code.parameters.is_empty() {
            self.out.line("char none; /* every parameter is fixed */");
        }
        self.out.close(format!("}} {name}_params;\n"));
        let noun = capital(code.noun());
        let changed = match code.is_stateless() {
            true => "",
            false => ", changed by arm and by what takes it without const",
        };
        self.out.line(format!("/* {noun}: set by init{changed}. */"));
        self.out.open(format!("typedef struct {name} {{"));
        self.members(&code.fields);
        if code.fields.is_empty() {
            self.out.line("char none; /* every number is fixed */");
        }
        self.out.close(format!("}} {name};\n"));
        if !code.gains.is_empty() {
            self.out.line("/* Feedback gains at one time. */");
            self.out.open(format!("typedef struct {name}_gains {{"));
            self.members(&code.gains);
            self.out.line("ptc_status status; /* PTC_OK or PTC_HOLD */");
            self.out.close(format!("}} {name}_gains;\n"));
        }
        for callback in code.callbacks() {
            let (real, array) = (self.type_of(Shape::Real), callback.array);
            let (given, about, n) = (callback.name, callback.about, callback.length);
            self.remark(about);
            self.out.line(match callback.gives {
                1 => format!("typedef {real} (*{name}_{given})(void *context, const {real} {array}[{n}], {real} t);\n"),
                count => format!("typedef void (*{name}_{given})(void *context, const {real} {array}[{n}], {real} t, {real} rate, {real} {given}[{count}]);\n"),
            });
        }
    }

    fn members(&mut self, members: &[Variable]) {
        for member in members {
            let array = member.shape.length().map(|n| format!("[{n}]")).unwrap_or_default();
            let (kind, name, about) = (self.type_of(member.shape), &member.name, &member.about);
            self.out.line(format!("{kind} {name}{array}; /* {about} */"));
        }
    }

    /// A comment, in as many lines as it needs.
    pub(super) fn remark(&mut self, text: &str) {
        let line = format!("/* {text} */");
        if self.out.has_room(&line) {
            return self.out.line(line);
        }
        self.out.line("/*");
        self.out.words(" * ", text);
        self.out.line(" */");
    }
}

/// Statuses by their words.
fn words(statuses: &[Status]) -> String {
    let all: Vec<_> = statuses.iter().map(|status| word(*status)).collect();
    all.join(" or ")
}

/// Returns the memory of a call that must not overlap: results are set before the arguments are read.
fn apart(function: &Function) -> String {
    let name = |own: &Variable| own.name.clone();
    let given: Vec<_> = function.results.iter().map(name).collect();
    let is_array = |own: &&Variable| matches!(own.shape, Shape::Reals(_) | Shape::Lists(..));
    let read: Vec<_> = function.arguments.iter().filter(is_array).map(name).collect();
    match given.is_empty() || read.is_empty() {
        true => String::new(),
        false => format!(" {} must not overlap {}.", given.join(" and "), read.join(" or ")),
    }
}
