//! Statements of a function: what a test guards is inside it.

use super::super::block::{Around, Block, Branch, WRITTEN, counted, of_statement};
use super::super::text::{Lines, Text, bare};
use super::source::BUILT;
use super::{C, word};
use crate::code::{Expr, For, Shape, Statement, Status, Subroutine, Test};
use crate::internal::fault;

impl C<'_> {
    /// Statements: a requirement becomes a test around those behind it, and `then` ends the whole.
    pub(super) fn nested(&mut self, mut statements: &[Statement], then: &mut dyn FnMut(&mut Self)) {
        // Tests alone nest: the other statements may be tens of thousands.
        while let Some((first, rest)) = statements.split_first() {
            match first {
                Statement::Require(test, status) => return self.guard(test, *status, rest, then),
                other => self.statement(other),
            }
            statements = rest;
        }
        then(self);
    }

    fn guard(
        &mut self,
        test: &Test,
        status: Status,
        rest: &[Statement],
        then: &mut dyn FnMut(&mut Self),
    ) {
        if self.standing != Some(status) {
            self.out.line(format!("status = {};", word(status)));
            self.standing = Some(status);
        }
        if self.owner == BUILT {
            self.notes.before_tests.into_iter().for_each(|note| self.out.line(note));
        }
        let mut parts = self.parts(test);
        if let [only] = parts.as_mut_slice() {
            *only = bare(std::mem::take(only));
        }
        let line = self.out.joined("if (", &parts, ("&&", "\n    && "), ") {");
        self.out.open(line);
        self.nested(rest, then);
        if let Some(count) = self.inputs {
            // Not before, as u may lie where x does.
            let (zero, status) = (self.literal("0.0"), word(status));
            self.out.turn("} else {");
            self.out.open(format!("for (uint32_t i = 0U; i < {count}U; i++) {{"));
            self.out.line(format!("u[i] = {zero};\naxes[i] = {status};"));
            self.out.close("}");
        }
        self.out.close("}");
    }
}

impl Block for C<'_> {
    fn as_block(&mut self) -> &mut dyn Block {
        self
    }

    fn out(&mut self) -> &mut Lines {
        &mut self.out
    }

    fn lines(&self) -> &Lines {
        &self.out
    }

    fn branch(&self) -> Branch {
        let joint = "\n    && ";
        let (otherwise, end) = ("} else {", "}");
        Branch { open: "if (", not: "!", turn: "} else if (", then: ") {", joint, otherwise, end }
    }

    /// Rules of MISRA end every chain with `else`.
    fn neither(&mut self) {
        self.out.turn("} else {");
        self.out.line("/* neither */");
    }

    fn comment(&self) -> (&'static str, &'static str) {
        ("/* ", " */")
    }

    fn define(&self, name: &str, shape: Shape, value: &str) -> String {
        format!("const {} {name} = {value};", self.type_of(shape))
    }

    fn declare(&self, name: &str, shape: Shape) -> Option<String> {
        let length = shape.length().map(|length| format!("[{length}]")).unwrap_or_default();
        Some(format!("{} {name}{length};", self.type_of(shape)))
    }

    fn require(&mut self, _: &Test, _: Status) {
        fault("what a test guards is inside it")
    }

    fn array(&mut self, name: &str, values: &[Expr]) {
        self.array_of("const ", name, values);
    }

    fn view(&self, name: &str, array: &str, first: bool) -> String {
        let kind = format!("const {} *", self.type_of(Shape::Real));
        format!("{}{name} = {array};", if first { kind.as_str() } else { "" })
    }

    fn apply(&mut self, name: &str, subroutine: Subroutine, [changed, other]: &[Vec<Expr>; 2]) {
        let [_, own] = subroutine.given();
        let [_, given] = subroutine.arguments(name);
        self.array_of("", name, changed);
        self.array_of(if own.changes { "" } else { "const " }, &given, other);
        let (code, called) = (&self.code.name, subroutine.name());
        self.out.line(format!("{code}_{called}({name}, {given});"));
    }

    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], count: usize) {
        let (real, given) = (self.type_of(Shape::Real), given.join(", "));
        let zeros = vec![self.literal("0.0"); count].join(", ");
        self.out.line(format!("{real} {name}[{count}] = {{{zeros}}};"));
        self.out.line(format!("{callback}(context, {given}, {name});"));
    }

    fn each(&self, each: &For) -> Around {
        counted(self, each, "uint32_t")
    }

    fn begin(&self, name: &str, shape: Shape, value: &str) -> String {
        format!("{} {name} = {value};", self.type_of(shape))
    }

    fn block(&mut self, statements: &[Statement]) {
        self.nested(statements, &mut |_| {});
    }

    fn statement(&mut self, statement: &Statement) {
        of_statement(self, statement);
        match (statement, &self.stored, self.notes.behind) {
            (Statement::Let(name, ..), Some((local, result)), _) if local == name => {
                let line = format!("*{result} = {name};");
                self.out.line(line);
            }
            (Statement::Root(root, tolerance), _, Some(behind)) => {
                let real = self.type_of(Shape::Real);
                let lines = behind(root, &self.alone(tolerance), &real);
                lines.into_iter().for_each(|line| self.out.line(line));
            }
            _ => {}
        }
    }
}

impl C<'_> {
    fn array_of(&mut self, constant: &str, name: &str, values: &[Expr]) {
        let values: Vec<_> = values.iter().map(|value| self.alone(value)).collect();
        let (kind, n) = (self.type_of(Shape::Real), values.len());
        let before = format!("{constant}{kind} {name}[{n}] = {{");
        let line = self.out.list(&before, &values, "};");
        self.out.line(line);
    }

    /// The function of a subroutine.
    pub(super) fn subroutine(&mut self, of: Subroutine) {
        let (name, real) = (&self.code.name, self.type_of(Shape::Real));
        let given = of.given().map(|own| {
            let constant = if own.changes { "" } else { "const " };
            format!("{constant}{real} {}[{}]", own.name, own.length)
        });
        let signature = format!("static void {name}_{}({})", of.name(), given.join(", "));
        self.out.line("");
        self.remark(of.about());
        self.out.line(signature);
        self.out.open("{");
        self.block(&of.body(WRITTEN));
        self.out.close("}");
    }
}
