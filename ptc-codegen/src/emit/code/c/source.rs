//! The source: every function has one exit.

use super::super::block::{either, same};
use super::super::text::{Text, bare};
use super::{C, externs, word};
use crate::code::{
    Ending, Expr, Finish, Function, Owner, Place, Shape, Solve, Statement, Status, Test,
};
use crate::internal::fault;

/// What leads to a field in `init`, which sets the fields of the user's only where it succeeds.
const BUILT: &str = "built.";

impl C<'_> {
    pub(super) fn source(mut self) -> String {
        let code = self.code;
        let name = &code.name;
        let noun = code.noun();
        self.out.line(format!("/* Prescribed-time {noun} {name}: see {name}.h. DO NOT EDIT. */"));
        self.out.line(format!("#include \"{name}.h\"\n\n#include <math.h>\n#include <stddef.h>"));
        let counts = |statement: &Statement| {
            matches!(statement, Statement::Solve(_) | Statement::Rows { .. })
        };
        let loops = code.axes().is_some() && !code.has_inputs();
        if loops || code.functions.iter().any(|function| function.has(counts)) {
            self.out.line("#include <stdint.h>");
        }
        self.out.line("");
        self.init();
        let mut formed = false;
        for function in &code.functions {
            let rows = function.body.iter().find_map(|statement| match statement {
                Statement::Rows { weights, .. } => Some(weights.len()),
                _ => None,
            });
            if let Some(weights) = rows.filter(|_| !std::mem::replace(&mut formed, true)) {
                self.rows_function(weights);
            }
            self.function(function);
        }
        self.out.text()
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
        self.block(&code.init, &mut |this| {
            let Some(start) = &code.start else { return this.out.line("status = PTC_OK;") };
            let mut list = vec!["&built".to_owned(), this.alone(&start.time)];
            list.extend(start.state.iter().map(|state| state.name.clone()));
            this.out.line(format!("status = {name}_arm({});", list.join(", ")));
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
        if let Finish::Inputs(inputs) = &function.finish
            && fails
        {
            self.no_inputs(inputs.values.len(), first);
        }
        self.block(&function.body, &mut |this| {
            let done = this.stored.is_some() && function.finish.results().is_some();
            this.finish(function, &function.finish, done && !this.zeroed);
            if function.results.iter().any(|result| result.shape == Shape::Gains) {
                this.out.line("gains->status = status;");
            }
        });
        if function.guarded {
            self.out.close("}");
        }
        self.out.line("return status;");
        self.out.close("}");
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

    /// Whether the only result has been stored.
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
    fn finish(&mut self, function: &Function, finish: &Finish, done: bool) {
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
            Finish::Axes(count) => self.axes(function, *count),
            Finish::Inputs(inputs) => self.inputs(inputs),
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

    fn ends(&mut self, function: &Function, finish: &Finish, done: bool) {
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
                    let fields = self.code.gains.iter();
                    let place = |field: &crate::code::Variable| match field.shape.length() {
                        Some(n) => (0..n).map(|i| format!("{name}->{}[{i}]", field.name)).collect(),
                        None => vec![format!("{name}->{}", field.name)],
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

    /// Statements; what a test guards is inside it, and `then` ends the whole.
    fn block(&mut self, mut statements: &[Statement], then: &mut dyn FnMut(&mut Self)) {
        // Tests alone nest: the other statements may be tens of thousands.
        while let Some((first, rest)) = statements.split_first() {
            match first {
                Statement::Require(test, status) => return self.require(test, *status, rest, then),
                Statement::If(test, yes, no) => {
                    let text = self.test(test);
                    self.out.open(format!("if ({text}) {{"));
                    self.otherwise(yes, no);
                }
                other => self.statement(other),
            }
            statements = rest;
        }
        then(self);
    }

    fn require(
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
        self.block(rest, then);
        self.out.close("}");
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
                if let Some((_, result)) = self.stored.as_ref().filter(|(local, _)| local == name) {
                    let line = format!("*{result} = {name};");
                    self.out.line(line);
                }
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
            Statement::Array(name, values) => self.array("const ", name, values),
            Statement::Rows { name, tail, weights } => {
                self.array("", name, weights);
                self.array("const ", "p", tail);
                self.out.line(format!("{}_rows({name}, p);", self.code.name));
            }
            Statement::Solve(solve) => self.solve(solve),
            Statement::Note(text) => {
                self.out.gap();
                self.out.line(format!("/* {text} */"));
            }
            Statement::If(..) | Statement::Require(..) => {}
        }
    }

    fn array(&mut self, constant: &str, name: &str, values: &[Expr]) {
        let values: Vec<_> = values.iter().map(|value| self.alone(value)).collect();
        let (kind, n) = (self.type_of(Shape::Real), values.len());
        let before = format!("{constant}{kind} {name}[{n}] = {{");
        let line = self.out.list(&before, &values, "};");
        self.out.line(line);
    }

    fn solve(&mut self, solve: &Solve) {
        let (real, y) = (self.type_of(Shape::Real), &solve.unknown);
        let [low, high, next, size] = Solve::LOCALS.map(|local| format!("{y}_{local}"));
        for (name, value) in [(y, &solve.start), (&low, &solve.low), (&high, &solve.high)] {
            let value = self.alone(value);
            self.out.line(format!("{real} {name} = {value};"));
        }
        let rounds = solve.rounds;
        self.out.open(format!("for (uint32_t round = 0U; round < {rounds}U; round++) {{"));
        self.block(&solve.body, &mut |_| {});
        for (name, value) in [(&next, &solve.next), (&size, &solve.size)] {
            let value = self.alone(value);
            self.out.line(format!("const {real} {name} = {value};"));
        }
        let (zero, half) = (self.literal("0.0"), self.literal("0.5"));
        let (residual, tolerance) = (self.alone(&solve.residual), self.alone(&solve.tolerance));
        self.out.line(format!(
            "if ({residual} > {zero}) {{
    {low} = {y};
}} else {{
    {high} = {y};
}}
if (({next} >= {low}) && ({next} <= {high})) {{
    {y} = {next};
}} else {{
    {y} = {half} * ({low} + {high});
}}
if ({size} <= {tolerance}) {{
    break;
}}"
        ));
        self.out.close("}");
        if let Some(behind) = self.notes.behind {
            behind(solve, &tolerance, &real).into_iter().for_each(|line| self.out.line(line));
        }
    }
}
