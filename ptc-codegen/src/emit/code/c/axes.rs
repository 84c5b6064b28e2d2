//! The `step` of several axes.

use super::super::text::Text;
use super::C;
use crate::code::{Function, Shape};

impl C<'_> {
    /// `tick`, and then `axis` for each of so many.
    pub(super) fn axes(&mut self, function: &Function, count: usize) {
        let name = &self.code.name;
        let (zero, real) = (self.literal("0.0"), self.type_of(Shape::Gains));
        let numbered = if self.code.numbers_axes() { "axis, " } else { "" };
        let own = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        let own: String = own.map(|argument| format!("{}[axis], ", argument.name)).collect();
        self.out.line(format!(
            "{real} gains;
const ptc_status now = {name}_tick(self, t, &gains);

status = now;
for (uint32_t axis = 0U; axis < {count}U; axis++) {{
    u[axis] = {zero};
    axes[axis] = now;
    if (now >= PTC_OK) {{
        axes[axis] = {name}_axis(&gains, {numbered}{own}&u[axis]);
    }}
    if ((status >= PTC_OK) && ((axes[axis] < PTC_OK) || (axes[axis] == PTC_SATURATED))) {{
        status = axes[axis];
    }}
}}
if (status < PTC_OK) {{
    for (uint32_t axis = 0U; axis < {count}U; axis++) {{
        u[axis] = {zero};
    }}
}}"
        ));
    }
}
