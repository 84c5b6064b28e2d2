//! The source: every function has one exit.

use super::super::block::{either, same};
use super::super::text::{Text, bare, capital};
use super::assumptions::{assumptions, classification};
use super::{C, externs, word};
use crate::code::{
    Ending, Expr, Finish, Function, Owner, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;

/// Prefix of a field in `init`, which copies the fields to those of the user only on success.
pub(super) const BUILT: &str = "built.";

impl C<'_> {
    pub(super) fn source(mut self) -> String {
        let code = self.code;
        let name = &code.name;
        let title = code.title();
        self.init();
        code.subroutines().into_iter().for_each(|of| self.subroutine(of));
        code.functions.iter().for_each(|function| self.function(function));
        let functions = std::mem::take(&mut self.out).text();
        self.out.line(format!("/* {title} {name}: see {name}.h. DO NOT EDIT. */"));
        self.out.line(format!(
            "#include \"{name}.h\"\n\n#include <float.h>\n#include <math.h>\n#include <stddef.h>"
        ));
        let is_list = |result: &Variable| matches!(result.shape, Shape::Reals(_));
        let lists = |f: &Function| f.guarded && f.results.iter().any(is_list);
        if code.functions.iter().any(lists) || code.counts() {
            self.out.line("#include <stdint.h>");
        }
        self.out.line("");
        self.out.line(assumptions(code.precision));
        self.out.line(classification(code.precision, &functions));
        self.constants();
        self.tables();
        self.out.line(functions);
        self.out.text()
    }

    fn constants(&mut self) {
        let constants = self.code.constants();
        if !constants.is_empty() {
            self.out.line("\n/* Numbers of the design, each rounded once. */");
        }
        for own in &constants {
            let value = self.literal_of(own);
            let value = if value.starts_with('-') { format!("({value})") } else { value };
            let name = self.constant(own);
            self.out.line(format!("#define {name} {value} /* {} */", own.described()));
        }
        if !constants.is_empty() && self.code.tables.is_empty() {
            self.out.line("");
        }
    }

    fn tables(&mut self) {
        let (code, real) = (self.code, self.type_of(Shape::Real));
        for table in &code.tables {
            let (rows, columns) = (table.rows.len(), table.columns());
            let name = self.table(&table.name);
            self.out.line("");
            self.out.line(format!("/* {} */", capital(&table.about)));
            self.out.open(format!("static const {real} {name}[{rows}][{columns}] = {{"));
            for row in self.rows(table) {
                self.out.line(format!("{{{}}},", row.join(", ")));
            }
            self.out.close("};");
        }
    }

    fn init(&mut self) {
        let code = self.code;
        let name = &code.name;
        self.out.line(self.init_signature());
        self.out.open("{");
        self.out.line("ptc_status status = PTC_E_PARAM;");
        if code.start.is_some() {
            self.out.line(format!("struct {name} built;"));
            self.owner = BUILT;
        }
        self.standing = Some(Status::Param);
        self.out.line("");
        let uses = !code.parameters.is_empty();
        if !uses {
            self.out.line("(void)params;");
        }
        let given = if uses { "(self != NULL) && (params != NULL)" } else { "self != NULL" };
        self.out.open(format!("if ({given}) {{"));
        self.nested(&code.init, &mut |this| {
            let Some(start) = &code.start else { return this.out.line("status = PTC_OK;") };
            let mut list = vec!["&built".to_owned()];
            list.extend(start.numbers().map(|number| this.alone(number)));
            list.extend(start.state.iter().map(|state| state.name.clone()));
            this.out.line(format!("status = {name}_{}({});", start.function(), list.join(", ")));
            this.out.line("if (status == PTC_OK) {\n    *self = built;\n}");
        });
        self.out.close("}");
        self.out.line("return status;");
        self.out.close("}");
    }

    fn function(&mut self, function: &Function) {
        self.out.line("");
        self.out.line(self.signature(function));
        self.out.open("{");
        self.owner = if function.owner == Owner::Gains { "gains->" } else { "self->" };
        let first = match function.guarded {
            true => function.failures.first().copied().unwrap_or(Status::Input),
            false => Status::Ok,
        };
        self.out.line(format!("ptc_status status = {};", word(first)));
        self.standing = Some(first);
        self.out.line("");
        let fails = function.has(|statement| matches!(statement, Statement::Require(..)));
        self.zeroed = function.guarded || fails;
        if self.zeroed && !function.failures.is_empty() {
            let zero = self.literal("0.0");
            for result in function.results.iter().filter(|result| result.shape == Shape::Real) {
                let name = &result.name;
                self.out.line(match function.guarded {
                    true => format!("if ({name} != NULL) {{\n    *{name} = {zero};\n}}"),
                    false => format!("*{name} = {zero};"),
                });
            }
        }
        self.stored = self.stored_early(function);
        if function.guarded {
            let tests = self.pointers(function);
            self.out.open(format!("if ({tests}) {{"));
        }
        let several = function.results.first().filter(|_| function.finish == Finish::Stands);
        self.inputs = several.and_then(|u| u.shape.length());
        self.nested(&function.body, &mut |this| {
            let done = this.stored.is_some() && function.finish.results().is_some();
            this.finish(function, &function.finish, done && !this.zeroed);
            if function.results.iter().any(|result| result.shape == Shape::Gains) {
                this.out.line("gains->status = status;");
            }
        });
        if function.guarded {
            if function.finish == Finish::Stands {
                self.without_pointers(function);
            }
            self.out.close("}");
        }
        let fails = function.guarded || !function.failures.is_empty();
        if fails && function.finish != Finish::Stands {
            self.clear_lists(function);
        }
        self.out.line("return status;");
        self.out.close("}");
    }

    /// A list of results is 0 where a pointer is missing, as one is from the start, and a list of
    /// statuses has that of the call.
    fn without_pointers(&mut self, function: &Function) {
        let zero = self.literal("0.0");
        let lists: Vec<_> = function
            .results
            .iter()
            .filter_map(|result| match result.shape {
                Shape::Reals(count) => Some((&result.name, count, zero.as_str())),
                Shape::Statuses(count) => Some((&result.name, count, word(Status::Input))),
                _ => None,
            })
            .collect();
        if lists.is_empty() {
            return;
        }
        self.out.turn("} else {");
        for (name, count, value) in lists {
            self.out.open(format!("if ({name} != NULL) {{"));
            self.out.open(format!("for (uint32_t i = 0U; i < {count}U; i++) {{"));
            self.out.line(format!("{name}[i] = {value};"));
            self.out.close("}");
            self.out.close("}");
        }
    }

    /// The local value that is the only result on every way, or on the first one, which is taken most
    /// often: it is stored as soon as it is known, which saves instructions.
    fn stored_early(&self, function: &Function) -> Option<(String, String)> {
        let first = match &function.finish {
            Finish::If(_, first, _) if self.zeroed => first.results(),
            finish => finish.results().filter(|_| !self.zeroed),
        };
        let ([result], Some([Expr::Local(name)])) = (function.results.as_slice(), first) else {
            return None;
        };
        let is_it = |s: &Statement| matches!(s, Statement::Let(local, ..) if local == name);
        let is_stored = result.shape == Shape::Real && function.body.iter().any(is_it);
        is_stored.then(|| (name.clone(), result.name.clone()))
    }

    /// Returns true if the only result has been stored.
    fn is_stored(&self, values: &[Expr]) -> bool {
        let stored = self.stored.as_ref();
        stored.is_some_and(|(local, _)| matches!(values, [Expr::Local(name)] if name == local))
    }

    /// The tests that no pointer is NULL.
    fn pointers(&self, function: &Function) -> String {
        let owner = if function.owner == Owner::Gains { "gains" } else { "self" };
        let arrays = function.arguments.iter().filter(|a| a.shape.length().is_some());
        let externs = externs("", &function.callbacks);
        let externs = externs.iter().map(|(_, name)| *name).filter(|name| *name != "context");
        let pointers = std::iter::once(owner)
            .chain(arrays.map(|a| a.name.as_str()))
            .chain(externs)
            .chain(function.results.iter().map(|result| result.name.as_str()));
        let pointers: Vec<_> = pointers.collect();
        match pointers.as_slice() {
            [only] => format!("{only} != NULL"),
            all => all.iter().map(|p| format!("({p} != NULL)")).collect::<Vec<_>>().join(" && "),
        }
    }

    /// Hands the results over, unless that is `done`, and settles the status.
    pub(super) fn finish(&mut self, function: &Function, finish: &Finish, done: bool) {
        let mut fails = false;
        finish.each(&mut |end| fails |= matches!(end, Finish::Fail(_)));
        match finish {
            Finish::Give(values, ending) => {
                if !done && !self.is_stored(values) {
                    self.hand_over(function, values);
                }
                self.settle(*ending);
            }
            Finish::Fail(status) => self.fail(function, *status),
            Finish::Stands => {}
            Finish::If(..) => {
                // One store for all ends, but where the result is 0 from the start.
                let scalar = function.results.iter().all(|result| result.shape == Shape::Real);
                let early = !fails || (scalar && !self.zeroed);
                let same = finish.results().filter(|_| early && !done);
                let same = same.filter(|values| !self.is_stored(values));
                if let Some(values) = same {
                    self.hand_over(function, values);
                }
                self.ends(function, finish, done || same.is_some());
            }
        }
    }

    pub(super) fn ends(&mut self, function: &Function, finish: &Finish, done: bool) {
        if done
            && matches!(finish, Finish::If(..))
            && let (tests, Finish::Give(_, Ending::Known(status)), rest) = same(finish)
            && self.standing == Some(*status)
        {
            // The way that is taken most often leaves all as it stands.
            let test = bare(either(self, &tests));
            self.out.open(format!("if (!({test})) {{"));
            self.ends(function, rest, done);
            return self.out.close("}");
        }
        let (mut rest, mut first) = (finish, true);
        while let Finish::If(..) = rest {
            let (tests, yes, no) = same(rest);
            let parts = match tests.as_slice() {
                [test @ Test::All(all)] if all.len() > 1 => self.parts(test),
                tests => vec![bare(either(self, tests))],
            };
            let joint = ("&&", "\n    && ");
            match std::mem::take(&mut first) {
                true => {
                    let line = self.out.joined("if (", &parts, joint, ") {");
                    self.out.open(line);
                }
                false => {
                    let line = self.out.joined("} else if (", &parts, joint, ") {");
                    self.out.turn(line);
                }
            }
            self.finish(function, yes, done);
            rest = no;
        }
        if first {
            return self.finish(function, rest, done);
        }
        self.out.turn("} else {");
        self.finish(function, rest, done);
        self.out.close("}");
    }

    fn settle(&mut self, ending: Ending) {
        let status = match ending {
            Ending::Known(status) => word(status),
            Ending::OfGains => "gains->status",
        };
        self.out.line(format!("status = {status};"));
    }

    fn fail(&mut self, function: &Function, status: Status) {
        if !self.zeroed || self.stored.is_some() {
            let zero = self.literal("0.0");
            for result in function.results.iter().filter(|result| result.shape == Shape::Real) {
                self.out.line(format!("*{} = {zero};", result.name));
            }
        }
        self.out.line(format!("status = {};", word(status)));
    }

    /// Sets lists of results to 0 where the call fails: at its end, as one may lie where an argument does.
    fn clear_lists(&mut self, function: &Function) {
        let zero = self.literal("0.0");
        for result in &function.results {
            let (Shape::Reals(count), name) = (result.shape, &result.name) else {
                continue;
            };
            let ok = word(Status::Ok);
            self.out.open(match function.guarded {
                true => format!("if ((status < {ok}) && ({name} != NULL)) {{"),
                false => format!("if (status < {ok}) {{"),
            });
            self.out.open(format!("for (uint32_t i = 0U; i < {count}U; i++) {{"));
            self.out.line(format!("{name}[i] = {zero};"));
            self.out.close("}");
            self.out.close("}");
        }
    }

    fn hand_over(&mut self, function: &Function, values: &[Expr]) {
        let mut values =
            values.iter().map(|value| self.alone(value)).collect::<Vec<_>>().into_iter();
        for result in &function.results {
            let name = &result.name;
            let places: Vec<String> = match result.shape {
                Shape::Reals(n) | Shape::Statuses(n) => {
                    (0..n).map(|index| format!("{name}[{index}]")).collect()
                }
                Shape::Lists(..) => fault("an array of arrays is given"),
                Shape::Gains => {
                    let (fields, gains) = (self.code.gains.iter(), "gains->");
                    let place = |field: &Variable| match field.shape.length() {
                        Some(n) => (0..n).map(|i| format!("{gains}{}[{i}]", field.name)).collect(),
                        None => vec![format!("{gains}{}", field.name)],
                    };
                    fields.flat_map(place).collect()
                }
                Shape::Real | Shape::Count => vec![format!("*{name}")],
            };
            for (place, value) in places.into_iter().zip(values.by_ref()) {
                self.out.line(format!("{place} = {value};"));
            }
        }
    }
}
