//! The `step` of several axes.

use super::Rust;
use crate::code::{Function, Shape};

impl Rust<'_> {
    /// `tick`, and then `axis` for each of so many.
    pub(super) fn axes(&mut self, function: &Function, count: usize) {
        let runtime = self.runtime;
        let lists = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        let own: Vec<_> = lists.map(|argument| argument.name.as_str()).collect();
        let mut given: Vec<_> = own.iter().map(|name| format!("&{name}[axis]")).collect();
        if self.code.numbers_axes() {
            given.insert(0, "axis as u32".to_owned());
        }
        let given = given.join(", ");
        self.out.line(format!(
            "let failed = |error| {runtime}Axes {{
    u: [0.0; {count}],
    axes: [Err(error); {count}],
    status: Err(error),
}};
let gains = match self.tick(t) {{
    Ok(gains) => gains,
    Err(error) => return failed(error),
}};
let mut all = {runtime}Axes {{
    u: [0.0; {count}],
    axes: [Ok(gains.status); {count}],
    status: Ok(gains.status),
}};
for axis in 0..{count} {{
    let control = gains.axis({given});
    all.axes[axis] = control.map(|control| control.status);
    all.u[axis] = control.map_or(0.0, |control| control.u);
    if all.status.is_ok() && matches!(all.axes[axis], Err(_) | Ok({runtime}Status::Saturated)) {{
        all.status = all.axes[axis];
    }}
}}
if all.status.is_err() {{
    all.u = [0.0; {count}];
}}
all"
        ));
    }
}
