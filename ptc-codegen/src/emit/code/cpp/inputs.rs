//! The inputs of one plant.

use super::super::text::{Text, bare};
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
        for index in 0..count {
            for (way, (test, clipped)) in inputs.clips(index).into_iter().enumerate() {
                let (test, clipped) = (bare(self.test(&test)), self.alone(&clipped));
                match way {
                    0 => self.out.open(format!("if ({test}) {{")),
                    _ => self.out.turn(format!("}} else if ({test}) {{")),
                }
                self.out.line(format!("all.u[{index}] = {clipped};"));
                self.out.line(format!("all.axes[{index}] = Status::Saturated;"));
                self.out.line("all.status = Status::Saturated;");
            }
            if inputs.limits[index].is_some() {
                self.out.close("}");
            }
        }
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
