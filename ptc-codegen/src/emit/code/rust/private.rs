//! The functions of routines, and the `step` of several inputs of one plant.

use super::super::block::{Block, WRITTEN};
use super::Rust;
use crate::code::{Function, Kind, Shape, Statement};

impl Rust<'_> {
    /// The function of a routine.
    pub(super) fn routine(&mut self, kind: Kind) {
        let given = kind.given();
        let list = given.map(|own| {
            let changes = if own.changes { "mut " } else { "" };
            format!("{changes}{}: {}", own.name, self.type_of(Shape::Reals(own.length)))
        });
        let (name, gives) = (kind.name(), self.type_of(Shape::Reals(given[0].length)));
        self.out.line("");
        self.out.words("/// ", kind.about());
        self.out.open(format!("fn {name}({}) -> {gives} {{", list.join(", ")));
        self.block(&kind.body(WRITTEN));
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
