//! Description of several axes in the head of an emitted file.

use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Describes the number of axes, and the values that differ between them.
pub(super) fn lines(spec: &Spec) -> Vec<String> {
    let Some(axes) = &spec.axes else { return Vec::new() };
    let (each, first) = match &spec.coupled {
        None => (
            "axis",
            format!(
                "Axes: {}, each a chain of its own with this deadline and mapping. step computes what depends on time once.",
                axes.count
            ),
        ),
        Some(_) => (
            "output",
            format!(
                "Outputs: {}, each with a law of its own, with this deadline and mapping; {} of the input of this number.",
                axes.count,
                if axes.lower.is_empty() { "u_max is" } else { "u_min and u_max are" }
            ),
        ),
    };
    let mut lines = vec![first];
    if !axes.differ() {
        return lines;
    }
    let list = |values: &[Fixed]| {
        let values: Vec<_> = values.iter().map(ToString::to_string).collect();
        values.join(", ")
    };
    for index in 0..axes.count {
        let gains = axes.gains.get(index).map(|gains| format!("k = {}", list(gains)));
        let limit = axes.limits.get(index).map(|limit| match axes.lower.get(index) {
            Some(least) => format!("u_min = {least}, u_max = {limit}"),
            None => format!("u_max = {limit}"),
        });
        let gain = axes.input_gains.get(index).map(|g| format!("g = {g}"));
        let bound = axes.state_max.get(index).map(|most| format!("state_max = {}", list(most)));
        let own: Vec<_> = [gains, limit, bound, gain].into_iter().flatten().collect();
        if !own.is_empty() {
            lines.push(format!("  {each} {}: {}", index + 1, own.join("; ")));
        }
    }
    lines
}

/// Returns true if each axis has its own value of a parameter that the spec fixes.
pub(in crate::emit::files) fn have_own(spec: &Spec, parameter: Parameter) -> bool {
    spec.axes.as_ref().is_some_and(|axes| match parameter {
        Parameter::Gain(_) => !axes.gains.is_empty(),
        Parameter::UMax | Parameter::UMin => !axes.limits.is_empty(),
        _ => false,
    })
}
