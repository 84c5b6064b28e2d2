//! The `step` of several axes.

use super::Cpp;
use crate::code::{Function, Shape};

/// What such a step gives.
pub(super) const AXES: &str = "
#ifndef PTC_AXES_HPP
#define PTC_AXES_HPP
/// What a step of several axes gives.
template <class Real, std::size_t Count>
struct [[nodiscard]] Axes {
    std::array<Real, Count> u{}; ///< inputs of the plants, 0 on a negative status
    std::array<Status, Count> axes{}; ///< status of each axis
    Status status{Status::Input}; ///< that of the first axis that fails; else Saturated where one is
};
#endif
";

impl Cpp<'_> {
    /// `tick`, and then `axis` for each of so many.
    pub(super) fn axes(&mut self, function: &Function, count: usize) {
        let real = self.real_type();
        let lists = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        let mut given: Vec<_> = lists.map(|a| format!("{}[axis]", a.name)).collect();
        if self.code.numbers_axes() {
            given.insert(0, "axis".to_owned());
        }
        let given = given.join(", ");
        self.out.line(format!(
            "const Gains gains = tick(t);
Axes<{real}, {count}> all{{}};
all.status = gains.status;
for (std::uint32_t axis = 0U; axis < {count}U; axis++) {{
    const Control<{real}> control = gains.axis({given});
    all.u[axis] = control.u;
    all.axes[axis] = control.status;
    if ((all.status >= Status::Ok)
        && ((control.status < Status::Ok) || (control.status == Status::Saturated))) {{
        all.status = control.status;
    }}
}}
if (all.status < Status::Ok) {{
    all.u = {{}};
}}
return all;"
        ));
    }
}
