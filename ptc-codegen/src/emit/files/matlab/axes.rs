//! The `step` of several axes.

use super::Matlab;
use crate::code::{Function, Shape};

impl Matlab<'_> {
    /// `tick`, and then `axis` for each of so many.
    pub(super) fn axes(&mut self, function: &Function, count: usize) {
        let (name, real) = (&self.code.name, self.real_type());
        let lists = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        let own: String = lists.map(|a| format!(", {}(axis, :)", a.name)).collect();
        let numbered = if self.code.numbers_axes() { ", axis - 1" } else { "" };
        self.out.line(format!(
            "u = zeros({count}, 1, '{real}');
[gains, status] = {name}_tick(self, t);
axes = repmat(status, {count}, 1);
if status >= 0
    for axis = 1:{count}
        [u(axis), axes(axis)] = {name}_axis(gains{numbered}{own});
        if (status >= 0) && ((axes(axis) < 0) || (axes(axis) == 2))
            status = axes(axis);
        end
    end
end
if status < 0
    u = zeros({count}, 1, '{real}');
end"
        ));
    }
}
