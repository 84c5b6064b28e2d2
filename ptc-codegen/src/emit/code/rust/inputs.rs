//! The inputs of one plant.

use super::super::block::Block;
use super::super::text::Text;
use super::Rust;
use crate::code::{Function, Inputs, Statement};

impl Rust<'_> {
    /// The statements, and every u within its bound with the status of each.
    pub(super) fn inputs(&mut self, function: &Function, inputs: &Inputs) {
        let (runtime, count) = (self.runtime, inputs.values.len());
        if function.has(|statement| matches!(statement, Statement::Require(..))) {
            self.out.line(format!(
                "let failed = |error| {runtime}Axes {{
    u: [0.0; {count}],
    axes: [Err(error); {count}],
    status: Err(error),
}};"
            ));
        }
        self.block(&function.body);
        let values: Vec<_> = inputs.values.iter().map(|value| self.alone(value)).collect();
        let tracks = self.test(&inputs.tracks);
        let u = self.array_text("let u = [", &values, "];");
        self.out.line(u);
        self.out.line(format!(
            "let now = if {tracks} {{
    {runtime}Status::Ok
}} else {{
    {runtime}Status::Hold
}};
let mut all = {runtime}Axes {{
    u,
    axes: [Ok(now); {count}],
    status: Ok(now),
}};"
        ));
        let parts = self.parts(&inputs.finite());
        let line = self.out.joined("if ", &parts, ("&&", "\n    && "), " {");
        self.out.open(self.with_brace(line, format!("if {}", parts.join(" && "))));
        self.clip(inputs, &|index, bound| {
            let saturated = format!("Ok({runtime}Status::Saturated)");
            format!(
                "all.u[{index}] = {bound};\nall.axes[{index}] = {saturated};\nall.status = {saturated};"
            )
        });
        self.out.turn("} else {");
        self.out.line(format!("all.u = [0.0; {count}];"));
        self.out.line(format!("all.status = Err({runtime}Error::Range);"));
        for (index, value) in values.iter().enumerate() {
            let finite = self.finite(value);
            self.out.line(format!(
                "if !{finite} {{\n    all.axes[{index}] = Err({runtime}Error::Range);\n}}"
            ));
        }
        self.out.close("}");
        self.out.line("all");
    }
}
