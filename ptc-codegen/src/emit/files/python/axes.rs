//! The `step` of several axes.

use super::Python;
use crate::code::{Function, Shape};

/// What such a step gives.
pub(super) const AXES: &str = "
class Axes(NamedTuple):
    \"\"\"What a step of several axes gives, for each time and state of the batch.\"\"\"

    u: Array
    \"\"\"Inputs of the plants along the last axis; 0 on a negative status.\"\"\"
    axes: NDArray[np.int8]
    \"\"\"The Status of each axis, along the last axis.\"\"\"
    status: NDArray[np.int8]
    \"\"\"That of the first axis that fails; else SATURATED where one is.\"\"\"
";

/// One axis of an array of arrays.
pub(super) const LISTS: &str = "\
def _of_axes(given: ArrayLike, count: int, length: int, name: str) -> Array:
    \"\"\"The numbers of each axis: the last two dimensions.\"\"\"
    numbers = np.asarray(given, dtype=_R)
    if numbers.shape[-2:] != (count, length):
        raise ValueError(f\"{name} has shape {numbers.shape}; legal: (..., {count}, {length})\")
    return numbers

";

impl Python<'_> {
    /// `tick`, and then `axis` for each of so many.
    pub(super) fn axes(&mut self, function: &Function, count: usize) {
        let name = function.name;
        let given = function.arguments.iter().map(|a| format!(", {}: ArrayLike", a.name));
        self.out.line("");
        self.out.open(format!("def {name}(self{}) -> Axes:", given.collect::<String>()));
        self.out.words("", &format!("\"\"\"{}", function.about));
        self.out.line(
            "\nEach argument may be a batch; axes and their states stand along the last two axes.",
        );
        self.out.line("\"\"\"");
        let mut own = String::new();
        for argument in &function.arguments {
            let Shape::Lists(count, length) = argument.shape else { continue };
            let name = &argument.name;
            self.out.line(format!("of_{name} = _of_axes({name}, {count}, {length}, \"{name}\")"));
            own.push_str(&format!(", of_{name}[..., axis, :]"));
        }
        let own = match self.code.numbers_axes() {
            true => format!("axis{own}"),
            false => own.trim_start_matches(", ").to_owned(),
        };
        self.out.line(format!(
            "gains = self.tick(t)
controls = [gains.axis({own}) for axis in range({count})]
u = np.stack(np.broadcast_arrays(*[control.u for control in controls]), axis=-1)
axes = np.stack(np.broadcast_arrays(*[control.status for control in controls]), axis=-1)
status = np.broadcast_to(gains.status, axes.shape[:-1])
for axis in range({count}):
    decides = (axes[..., axis] < 0) | (axes[..., axis] == Status.SATURATED)
    status = np.where((status >= 0) & decides, axes[..., axis], status)
u = np.where((status < 0)[..., np.newaxis], _R(0.0), u)
return Axes(u, axes.astype(np.int8), status.astype(np.int8))"
        ));
        self.out.leave();
    }
}
