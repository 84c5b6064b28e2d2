//! The inputs of one plant.

use super::super::text::{Text, bare};
use super::C;
use crate::code::{Inputs, Status};

impl C<'_> {
    /// What the call gives where it ends early.
    pub(super) fn no_inputs(&mut self, count: usize, status: Status) {
        let zero = self.literal("0.0");
        for index in 0..count {
            self.out.line(format!("u[{index}] = {zero};"));
            self.out.line(format!("axes[{index}] = {};", super::word(status)));
        }
    }

    /// Every u within its bound, and the status of each.
    pub(super) fn inputs(&mut self, inputs: &Inputs) {
        let tracks = self.test(&inputs.tracks);
        let parts = self.parts(&inputs.finite());
        self.out.line(format!("status = ({tracks}) ? PTC_OK : PTC_HOLD;"));
        let line = self.out.joined("if (", &parts, ("&&", "\n    && "), ") {");
        self.out.open(line);
        for (index, value) in inputs.values.iter().enumerate() {
            let value = self.alone(value);
            self.out.line(format!("u[{index}] = {value};\naxes[{index}] = status;"));
        }
        for index in 0..inputs.values.len() {
            for (way, (test, clipped)) in inputs.clips(index).into_iter().enumerate() {
                let (test, clipped) = (bare(self.test(&test)), self.alone(&clipped));
                match way {
                    0 => self.out.open(format!("if ({test}) {{")),
                    _ => self.out.turn(format!("}} else if ({test}) {{")),
                }
                self.out.line(format!("u[{index}] = {clipped};\naxes[{index}] = PTC_SATURATED;"));
            }
            if inputs.limits[index].is_some() {
                self.out.turn("} else {");
                self.out.line("/* within its bound */");
                self.out.close("}");
            }
        }
        if inputs.are_limited() {
            let each = (0..inputs.values.len()).filter(|index| inputs.limits[*index].is_some());
            let each: Vec<_> =
                each.map(|index| format!("(axes[{index}] == PTC_SATURATED)")).collect();
            let any = bare(each.join(" || "));
            self.out.line(format!("if ({any}) {{\n    status = PTC_SATURATED;\n}}"));
        }
        self.out.turn("} else {");
        let zero = self.literal("0.0");
        for (index, value) in inputs.values.iter().enumerate() {
            let finite = self.finite(&self.alone(value));
            self.out.line(format!("u[{index}] = {zero};"));
            self.out.line(format!("axes[{index}] = {finite} ? status : PTC_E_RANGE;"));
        }
        self.out.line("status = PTC_E_RANGE;");
        self.out.close("}");
    }
}
