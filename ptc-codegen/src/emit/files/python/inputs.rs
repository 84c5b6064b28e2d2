//! The inputs of one plant.

use super::super::block::Block;
use super::super::text::Text;
use super::{Python, word};
use crate::code::{Inputs, Status, Test};

impl Python<'_> {
    /// Every u within its bound with the status of each, for a batch of calls.
    pub(super) fn inputs(&mut self, inputs: &Inputs, legal: &[(&Test, Status)]) {
        let count = inputs.values.len();
        let values: Vec<_> = inputs.values.iter().map(|value| self.alone(value)).collect();
        let (tracks, usable) = (self.test(&inputs.tracks), self.test(&inputs.finite()));
        self.out.line(format!("now = np.where({tracks}, Status.OK, Status.HOLD)"));
        self.out.line(format!("usable = {usable}"));
        self.out.line("status = np.where(usable, now, Status.RANGE)");
        for (index, value) in values.iter().enumerate() {
            let (u, axis) = (format!("u{}", index + 1), format!("axis{}", index + 1));
            let finite = self.finite(value);
            self.out.line(format!("{u} = {value}"));
            self.out.line(format!("{axis} = np.where({finite}, now, Status.RANGE)"));
            for (test, clipped) in inputs.clips(index) {
                let (test, clipped) = (self.test(&test), self.alone(&clipped));
                self.out.line(format!("beyond = usable & ({test})"));
                self.out.line(format!("{u} = np.where(beyond, {clipped}, {u})"));
                self.out.line(format!("{axis} = np.where(beyond, Status.SATURATED, {axis})"));
                self.out.line("status = np.where(beyond, Status.SATURATED, status)");
            }
        }
        let axes: Vec<_> = (1..=count).map(|index| format!("axis{index}")).collect();
        for (test, status) in legal.iter().rev() {
            let (test, status) = (self.test(test), word(*status));
            self.out.line(format!("legal = {test}"));
            for name in axes.iter().map(String::as_str).chain(["status"]) {
                self.out.line(format!("{name} = np.where(legal, {name}, Status.{status})"));
            }
        }
        let u: Vec<_> = (1..=count).map(|index| format!("u{index}")).collect();
        for (name, each) in [("u", u), ("axes", axes)] {
            let each = each.join(", ");
            self.out.line(format!("each = np.broadcast_arrays({each}, status)[:-1]"));
            self.out.line(format!("{name} = np.stack(each, axis=-1)"));
        }
        self.out.line(
            "u = np.where((status < 0)[..., np.newaxis], _R(0.0), u)
return Axes(u, axes.astype(np.int8), status.astype(np.int8))",
        );
    }
    /// The same for one call.
    pub(super) fn inputs_of_call(&mut self, inputs: &Inputs) {
        let values: Vec<_> = inputs.values.iter().map(|value| self.alone(value)).collect();
        let (count, tracks) = (values.len(), self.test(&inputs.tracks));
        self.out.line(format!("status = Status.OK if {tracks} else Status.HOLD"));
        self.out.line(format!("u = np.array([{}], dtype=_R)", values.join(", ")));
        self.out.line(format!("axes = np.full({count}, status, dtype=np.int8)"));
        self.out.line("usable = np.isfinite(u)");
        self.out.open("if not usable.all():");
        self.out.line("axes[~usable] = Status.RANGE");
        self.out.line(format!("u = np.zeros({count}, dtype=_R)"));
        self.out.line("return Axes(u, axes, np.asarray(Status.RANGE, dtype=np.int8))");
        self.out.leave();
        self.clip(inputs, &|index, bound| {
            let saturated = "Status.SATURATED";
            format!("u[{index}] = {bound}\naxes[{index}] = {saturated}\nstatus = {saturated}")
        });
        self.out.line("return Axes(u, axes, np.asarray(status, dtype=np.int8))");
    }

    /// What such a call gives where it fails before it has computed them.
    pub(super) fn no_inputs(&self, word: &str) -> String {
        let count = self.code.axes().unwrap_or_default();
        format!(
            "refused = np.full({count}, Status.{word}, dtype=np.int8)\nreturn Axes(np.zeros({count}, dtype=_R), refused, np.asarray(Status.{word}, dtype=np.int8))"
        )
    }
}
