//! The inputs of one plant.

use super::super::block::Block;
use super::super::text::{Text, bare};
use super::Matlab;
use crate::code::{Function, Inputs, Shape, Status};

impl Matlab<'_> {
    /// The statements, and every u within its bound with the status of each.
    pub(super) fn inputs(&mut self, function: &Function, inputs: &Inputs) {
        let (count, real) = (inputs.values.len(), self.real_type());
        let refused = Status::Input.number();
        self.out.line(format!("u = zeros({count}, 1, '{real}');"));
        self.out.line(format!("axes = repmat(int32({refused}), {count}, 1);"));
        for argument in &function.arguments {
            let name = &argument.name;
            match argument.shape {
                Shape::Count => self.tick(name, true),
                _ => self.out.line(format!("{name} = {real}({name});")),
            }
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
        self.clip(inputs, &|index, bound| {
            let place = index + 1;
            format!("u({place}) = {bound};\naxes({place}) = int32(2);\nstatus = int32(2);")
        });
        self.out.turn("else");
        self.out.line("status = int32(-3);");
        for (place, value) in (1..).zip(&values) {
            let finite = self.finite(value);
            self.out.line(format!("if ~{finite}\n    axes({place}) = int32(-3);\nend"));
        }
        self.out.close("end");
    }
}
