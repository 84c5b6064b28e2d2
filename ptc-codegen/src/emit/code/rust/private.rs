//! The functions of routines, and the `step` of several inputs of one plant.

use super::super::block::{Block, WRITTEN};
use super::Rust;
use crate::code::{Function, Shape, Statement, Subroutine};

impl Rust<'_> {
    /// The function of a subroutine.
    pub(super) fn subroutine(&mut self, of: Subroutine) {
        let given = of.given();
        let list = given.map(|own| {
            let changes = if own.changes { "mut " } else { "" };
            format!("{changes}{}: {}", own.name, self.type_of(Shape::Reals(own.length)))
        });
        let (name, gives) = (of.name(), self.type_of(Shape::Reals(given[0].length)));
        self.out.line("");
        self.out.words("/// ", of.about());
        self.out.open(format!("fn {name}({}) -> {gives} {{", list.join(", ")));
        self.block(&of.body(WRITTEN));
        self.out.line(given[0].name);
        self.out.close("}");
    }

    /// Several inputs, which statements give.
    pub(super) fn inputs(&mut self, function: &Function, count: usize) {
        let runtime = self.runtime;
        if function.has(|statement| matches!(statement, Statement::Require(..))) {
            self.out.line(format!(
                "let failed = |error| {runtime}Axes {{
    u: [0.0; {count}],
    axes: [Err(error); {count}],
    status: Err(error),
}};"
            ));
        }
        self.out.line(format!(
            "let mut u = [0.0; {count}];\nlet mut axes = [Ok({runtime}Status::Ok); {count}];\nlet mut status;"
        ));
        self.block(&function.body);
        self.out.line(format!("{runtime}Axes {{ u, axes, status }}"));
    }
}
