//! Statements of a function: what a test guards is inside it.

use super::super::text::{Text, bare};
use super::source::BUILT;
use super::{C, word};
use crate::code::{Expr, Place, Shape, Solve, Statement, Status, Test};

impl C<'_> {
    /// Statements; what a test guards is inside it, and `then` ends the whole.
    pub(super) fn block(&mut self, mut statements: &[Statement], then: &mut dyn FnMut(&mut Self)) {
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
            Statement::Rows { name, tail, weights, .. } => {
                self.array("", name, weights);
                self.array("const ", "p", tail);
                self.out.line(format!("{}_rows({name}, p);", self.code.name));
            }
            Statement::Elimination { name, matrix, right } => {
                self.array("", "a", matrix);
                self.array("", name, right);
                self.out.line(format!("{}_eliminate(a, {name});", self.code.name));
            }
            Statement::Call { name, callback, array, times, count } => {
                let [time, rate] = times.each_ref().map(|value| self.alone(value));
                let (real, zero) = (self.type_of(Shape::Real), self.literal("0.0"));
                let zeros = vec![zero; *count].join(", ");
                self.out.line(format!("{real} {name}[{count}] = {{{zeros}}};"));
                self.out.line(format!("{callback}(context, {array}, {time}, {rate}, {name});"));
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
        let (rounds, round) = (solve.rounds, Solve::ROUND);
        self.out.open(format!("for (uint32_t {round} = 0U; {round} < {rounds}U; {round}++) {{"));
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
        if let Some((late, middle)) = solve.bisection(self.code.precision) {
            let set = Statement::Set(Place::Local(y.clone()), middle);
            self.statement(&Statement::If(late, vec![set], vec![]));
        }
        self.out.close("}");
        if let Some(behind) = self.notes.behind {
            behind(solve, &tolerance, &real).into_iter().for_each(|line| self.out.line(line));
        }
    }
}
