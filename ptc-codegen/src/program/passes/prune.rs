//! prune: drops values that nothing uses.

use super::{append, rebuild};
use crate::program::{Program, Value};

/// Keeps what the outputs need.
pub(super) fn run(program: Program) -> Program {
    let mut used = vec![false; program.values.len()];
    for value in program.needed(&program.outputs()) {
        used[value.0] = true;
    }
    let mut index = 0;
    rebuild(&program, &mut |new, definition| {
        index += 1;
        // A dropped value is never looked up again, so any index stands for it.
        if used[index - 1] { append(new, definition.op, definition.name) } else { Value(0) }
    })
}
