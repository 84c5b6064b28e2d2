//! The inputs of one plant.

use super::super::block::Block;
use super::super::text::Text;
use super::Cpp;
use crate::code::Inputs;

impl Cpp<'_> {
    /// Every u within its bound, and the status of each.
    pub(super) fn inputs(&mut self, inputs: &Inputs) {
        let count = inputs.values.len();
        let real = self.real_type();
        let values: Vec<_> = inputs.values.iter().map(|value| self.alone(value)).collect();
        let tracks = self.test(&inputs.tracks);
        self.out.line(format!("const Status now = ({tracks}) ? Status::Ok : Status::Hold;"));
        let (u, now) = (values.join(", "), vec!["now"; count].join(", "));
        self.out.line(format!("Axes<{real}, {count}> all{{{{{{{u}}}}}, {{{{{now}}}}}, now}};"));
        let parts = self.parts(&inputs.finite());
        let line = self.out.joined("if (", &parts, ("&&", "\n    && "), ") {");
        self.out.open(line);
        self.clip(inputs, &|index, bound| {
            format!(
                "all.u[{index}] = {bound};\nall.axes[{index}] = Status::Saturated;\nall.status = Status::Saturated;"
            )
        });
        self.out.turn("} else {");
        self.out.line("all.u = {};");
        for (index, value) in values.iter().enumerate() {
            let finite = self.finite(value);
            self.out.line(format!("all.axes[{index}] = {finite} ? now : Status::Range;"));
        }
        self.out.line("all.status = Status::Range;");
        self.out.close("}");
        self.out.line("return all;");
    }
}
