//! C99.

use super::text::{Level, Lines, Text, length};
use crate::code::{Access, Code, Function, Outcomes, Place, Shape, Statement, Status, Variable};
use crate::emit::File;
use crate::parameter::Precision;

struct C<'a> {
    code: &'a Code,
    /// What the variable `status` holds, where it is known.
    standing: Option<Status>,
    out: Lines,
}

/// The header and the source of a controller.
pub(in crate::emit) fn files(code: &Code) -> Vec<File> {
    let name = &code.name;
    let printer = || C { code, standing: None, out: Lines::default() };
    let (header, source) = (printer().header(), printer().source());
    vec![
        File { name: format!("{name}.h"), text: header },
        File { name: format!("{name}.c"), text: source },
    ]
}

impl Text for C<'_> {
    fn precision(&self) -> Precision {
        self.code.precision
    }

    fn field(&self, name: &str) -> String {
        format!("self->{name}")
    }

    fn parameter(&self, name: &str) -> String {
        format!("params->{name}")
    }

    fn real(&self, count: &str) -> (Level, String) {
        let atom = count.bytes().all(|b| b.is_ascii_alphanumeric() || b"_->.".contains(&b));
        let count = if atom { count.to_owned() } else { format!("({count})") };
        (Level::Sign, format!("({}){count}", self.type_of(Shape::Real)))
    }

    fn finite(&self, value: &str) -> String {
        format!("(isfinite({value}) != 0)")
    }
}

impl C<'_> {
    fn type_of(&self, shape: Shape) -> &'static str {
        match (shape, self.code.precision) {
            (Shape::Count, _) => "uint32_t",
            (_, Precision::F32) => "float",
            (_, Precision::F64) => "double",
        }
    }

    fn zero(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "0.0f" } else { "0.0" }
    }

    fn member(&mut self, variable: &Variable) {
        let array = length(variable.shape).map(|n| format!("[{n}]")).unwrap_or_default();
        let (kind, name, about) = (self.type_of(variable.shape), &variable.name, &variable.about);
        self.out.line(format!("{kind} {name}{array}; /* {about} */"));
    }

    fn header(mut self) -> String {
        let code = self.code;
        let (name, guard) = (&code.name, code.name.to_uppercase());
        self.out.line("/*");
        for line in &code.head {
            self.out.line(format!(" * {line}"));
        }
        self.out.line(" */");
        for line in [
            &format!("#ifndef {guard}_H"),
            &format!("#define {guard}_H"),
            "",
            "#include <stdint.h>",
            "",
        ] {
            self.out.line(line);
        }
        self.out.line("#ifdef __cplusplus\nextern \"C\" {\n#endif\n");
        self.out.line(include_str!("../../../templates/status.h.txt"));
        self.out.line("/* Run-time parameters. */");
        self.out.open(format!("typedef struct {name}_params {{"));
        for parameter in &code.parameters {
            self.member(parameter);
        }
        if code.parameters.is_empty() {
            self.out.line("char none; /* every parameter is fixed */");
        }
        self.out.close(format!("}} {name}_params;"));
        self.out.line("");
        self.out.line(
            "/* Controller: set by init, changed by arm and by what takes it without const. */",
        );
        self.out.open(format!("typedef struct {name} {{"));
        for field in &code.fields {
            self.member(field);
        }
        self.out.close(format!("}} {name};"));
        self.out.line("");
        self.remark(
            "Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched.",
        );
        self.out.line(format!("{};", self.init_signature()));
        for function in &code.functions {
            self.out.line("");
            let failed = match function.results.as_slice() {
                [] => "",
                _ if function.failures.is_empty() => "",
                _ => " On a negative status u is 0 and nothing has changed.",
            };
            self.remark(&format!("{}{failed}", function.about.trim_end()));
            self.out.line(format!("{};", self.signature(function)));
        }
        self.out.line("\n#ifdef __cplusplus\n}\n#endif\n\n#endif");
        self.out.text()
    }

    /// A comment, in as many lines as it needs.
    fn remark(&mut self, text: &str) {
        let line = format!("/* {text} */");
        if self.out.has_room(&line) {
            return self.out.line(line);
        }
        self.out.line("/*");
        self.out.words(" * ", text);
        self.out.line(" */");
    }

    fn init_signature(&self) -> String {
        let name = &self.code.name;
        self.declared("init", &[format!("{name} *self"), format!("const {name}_params *params")])
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
        let mut list = vec![format!("{constant}{name} *self")];
        for argument in &function.arguments {
            let kind = self.type_of(argument.shape);
            list.push(match length(argument.shape) {
                Some(n) => format!("const {kind} {}[{n}]", argument.name),
                None => format!("{kind} {}", argument.name),
            });
        }
        for given in &function.results {
            let (kind, result) = (self.type_of(given.variable.shape), &given.variable.name);
            list.push(match length(given.variable.shape) {
                Some(n) => format!("{kind} {result}[{n}]"),
                None => format!("{kind} *{result}"),
            });
        }
        self.declared(function.name, &list)
    }

    fn source(mut self) -> String {
        let code = self.code;
        let name = &code.name;
        self.out
            .line(format!("/* Prescribed-time controller {name}: see {name}.h. DO NOT EDIT. */"));
        self.out.line(format!("#include \"{name}.h\"\n\n#include <math.h>\n#include <stddef.h>\n"));
        self.out.line(self.init_signature());
        self.out.open("{");
        self.out.line("ptc_status status = PTC_E_PARAM;");
        self.standing = Some(Status::Param);
        self.out.line("");
        let uses = !code.parameters.is_empty();
        if !uses {
            self.out.line("(void)params;");
        }
        let given = if uses { "(self != NULL) && (params != NULL)" } else { "self != NULL" };
        self.out.open(format!("if ({given}) {{"));
        self.block(&code.init, &mut |this| this.out.line("status = PTC_OK;"));
        self.out.close("}");
        self.out.line("return status;");
        self.out.close("}");
        for function in &code.functions {
            self.function(function);
        }
        self.out.text()
    }

    fn function(&mut self, function: &Function) {
        self.out.line("");
        self.out.line(self.signature(function));
        self.out.open("{");
        let first = match function.guarded {
            true => Status::Input,
            false => function.failures.first().copied().unwrap_or(Status::Ok),
        };
        self.out.line(format!("ptc_status status = {};", word(first)));
        self.standing = Some(first);
        self.out.line("");
        let may_fail = !function.failures.is_empty();
        let single: Vec<_> = function
            .results
            .iter()
            .filter(|given| length(given.variable.shape).is_none())
            .collect();
        if may_fail {
            for given in &single {
                let result = &given.variable.name;
                let zero = format!("*{result} = {};", self.zero());
                match function.guarded {
                    true => {
                        self.out.open(format!("if ({result} != NULL) {{"));
                        self.out.line(zero);
                        self.out.close("}");
                    }
                    false => self.out.line(zero),
                }
            }
        }
        if function.guarded {
            let arrays = function.arguments.iter().filter(|a| length(a.shape).is_some());
            let pointers = arrays
                .map(|a| a.name.as_str())
                .chain(function.results.iter().map(|given| given.variable.name.as_str()));
            let all: Vec<_> = std::iter::once("self").chain(pointers).collect();
            let tests = match all.as_slice() {
                [only] => format!("{only} != NULL"),
                all => {
                    all.iter().map(|p| format!("({p} != NULL)")).collect::<Vec<_>>().join(" && ")
                }
            };
            self.out.open(format!("if ({tests}) {{"));
        }
        self.block(&function.body, &mut |this| this.finish(function));
        if function.guarded {
            self.out.close("}");
        }
        self.out.line("return status;");
        self.out.close("}");
    }

    /// Hands the results over and settles the status.
    fn finish(&mut self, function: &Function) {
        for given in &function.results {
            let result = &given.variable.name;
            match length(given.variable.shape) {
                Some(_) => {
                    for (index, value) in given.values.iter().enumerate() {
                        let value = self.alone(value);
                        self.out.line(format!("{result}[{index}] = {value};"));
                    }
                }
                None => {
                    let value = given.values.first().map(|v| self.alone(v)).unwrap_or_default();
                    self.out.line(format!("*{result} = {value};"));
                }
            }
        }
        match &function.status {
            Outcomes::One(status) => self.out.line(format!("status = {};", word(*status))),
            Outcomes::First(ways, last) => {
                for (index, (test, status)) in self.ways(ways).into_iter().enumerate() {
                    match index {
                        0 => self.out.open(format!("if ({test}) {{")),
                        _ => self.out.turn(format!("}} else if ({test}) {{")),
                    }
                    self.out.line(format!("status = {};", word(status)));
                }
                self.out.turn("} else {");
                self.out.line(format!("status = {};", word(*last)));
                self.out.close("}");
            }
        }
    }

    /// Statements; what a test guards is inside it, and `then` ends the whole.
    fn block(&mut self, statements: &[Statement], then: &mut dyn FnMut(&mut Self)) {
        let Some((first, rest)) = statements.split_first() else { return then(self) };
        match first {
            Statement::Require(test, status) => {
                if self.standing != Some(*status) {
                    self.out.line(format!("status = {};", word(*status)));
                    self.standing = Some(*status);
                }
                let mut parts = self.parts(test);
                if let [only] = parts.as_mut_slice() {
                    // The brackets of the statement are enough.
                    let bare = only.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
                    *only = bare.unwrap_or(only).to_owned();
                }
                let line = self.out.joined("if (", &parts, ("&&", "\n    && "), ") {");
                self.out.open(line);
                self.block(rest, then);
                self.out.close("}");
                return;
            }
            Statement::If(test, yes, no) => {
                let text = self.test(test);
                self.out.open(format!("if ({text}) {{"));
                self.otherwise(yes, no);
            }
            other => self.statement(other),
        }
        self.block(rest, then);
    }

    /// The branches of a test that is open; a branch that only tests again is `else if`.
    fn otherwise(&mut self, yes: &[Statement], no: &[Statement]) {
        self.block(yes, &mut |_| {});
        match no {
            [] => {}
            [Statement::If(test, yes, no)] => {
                let text = self.test(test);
                self.out.turn(format!("}} else if ({text}) {{"));
                return self.otherwise(yes, no);
            }
            no => {
                self.out.turn("} else {");
                self.block(no, &mut |_| {});
            }
        }
        self.out.close("}");
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(name, shape, value) => {
                let (kind, value) = (self.type_of(*shape), self.alone(value));
                self.out.line(format!("const {kind} {name} = {value};"));
            }
            Statement::Variable(name, shape) => {
                let kind = self.type_of(*shape);
                self.out.line(format!("{kind} {name};"));
            }
            Statement::Set(place, value) => {
                let value = self.alone(value);
                let place = match place {
                    Place::Local(name) => name.clone(),
                    Place::Field(name) => self.field(name),
                };
                self.out.line(format!("{place} = {value};"));
            }
            Statement::Note(text) => {
                self.out.gap();
                self.out.line(format!("/* {text} */"));
            }
            Statement::If(..) | Statement::Require(..) => {}
        }
    }
}

/// The word of a status.
fn word(status: Status) -> &'static str {
    match status {
        Status::Ok => "PTC_OK",
        Status::Hold => "PTC_HOLD",
        Status::Saturated => "PTC_SATURATED",
        Status::After => "PTC_AFTER",
        Status::Param => "PTC_E_PARAM",
        Status::Input => "PTC_E_INPUT",
        Status::Range => "PTC_E_RANGE",
    }
}
