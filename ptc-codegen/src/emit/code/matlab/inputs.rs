//! The inputs of one plant.

use super::super::block::Block;
use super::super::text::{Text, bare};
use super::Matlab;
use crate::code::{Function, Inputs, Status};

impl Matlab<'_> {
    /// The statements, and every u within its bound with the status of each.
    pub(super) fn inputs(&mut self, function: &Function, inputs: &Inputs) {
        let (count, real) = (inputs.values.len(), self.real_type());
        let refused = Status::Input.number();
        self.out.line(format!("u = zeros({count}, 1, '{real}');"));
        self.out.line(format!("axes = repmat(int32({refused}), {count}, 1);"));
        for argument in &function.arguments {
            let name = &argument.name;
            self.out.line(format!("{name} = {real}({name});"));
        }
        self.block(&function.body);
        let tracks = bare(self.test(&inputs.tracks));
        self.out.line(format!(
            "if {tracks}\n    status = int32(0);\nelse\n    status = int32(1);\nend"
        ));
        self.out.line(format!("axes = repmat(status, {count}, 1);"));
        let values: Vec<_> = inputs.values.iter().map(|value| self.alone(value)).collect();
        let parts = self.parts(&inputs.finite());
        let line = self.out.joined("if ", &parts, ("&&", " ...\n    && "), "");
        self.out.open(line);
        self.out.line(format!("u = [{}];", values.join("; ")));
        for index in 0..count {
            let place = index + 1;
            for (way, (test, clipped)) in inputs.clips(index).into_iter().enumerate() {
                let (test, clipped) = (bare(self.test(&test)), self.alone(&clipped));
                match way {
                    0 => self.out.open(format!("if {test}")),
                    _ => self.out.turn(format!("elseif {test}")),
                }
                self.out.line(format!("u({place}) = {clipped};\naxes({place}) = int32(2);"));
                self.out.line("status = int32(2);");
            }
            if inputs.limits[index].is_some() {
                self.out.close("end");
            }
        }
        self.out.turn("else");
        self.out.line("status = int32(-3);");
        for (place, value) in (1..).zip(&values) {
            let finite = self.finite(value);
            self.out.line(format!("if ~{finite}\n    axes({place}) = int32(-3);\nend"));
        }
        self.out.close("end");
    }
}
