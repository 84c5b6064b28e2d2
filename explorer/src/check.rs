//! Verdicts of the checks on a design, its cost and its poles.

use ptc_codegen::Accepted;
use ptc_codegen::check::examine::{self, Report};
use ptc_codegen::request::Spec;
use serde_json::{Value, json};

use crate::blocks;

/// Describes a design for the page, beside its text.
pub(crate) fn of_design(spec: &Spec) -> Value {
    json!({
        "name": spec.name(),
        "n": spec.n,
        "mapping": spec.mapping_name(),
        "samples": spec.sampled().is_some(),
        "states": spec.state_names(),
        "inputs": spec.input_names(),
        "command": spec.command(),
        "loop": blocks::of_loop(spec),
    })
}

/// The outcomes, and which of them refuse the design.
pub(crate) fn checks(report: &Report) -> Value {
    let refused: Vec<_> = report.refusals().map(|outcome| outcome.name).collect();
    let one = |outcome: &ptc_codegen::check::Outcome| {
        json!({
            "name": outcome.name,
            "verdict": outcome.verdict.text(),
            "summary": outcome.summary,
            "details": outcome.details,
            "fix": outcome.fix,
            "refuses": refused.contains(&outcome.name),
        })
    };
    report.outcomes.iter().map(one).collect()
}

/// The last line of the report, whether it leaves something open, and the margins.
pub(crate) fn verdict(report: &Report) -> Value {
    json!({ "text": report.verdict(), "open": report.is_open(), "margins": report.margins() })
}

/// The poles and the lines of the check `growth`; null where the gains are not fixed.
pub(crate) fn plane(spec: &Spec) -> Value {
    let Some(plane) = examine::plane(spec) else { return Value::Null };
    let poles: Vec<_> = plane.poles.iter().map(|pole| [pole.re, pole.im]).collect();
    json!({ "poles": poles, "state": plane.state, "control": plane.control })
}

/// The operations of one step; null where they are not counted.
pub(crate) fn cost(accepted: &Accepted) -> Value {
    let Some(cost) = accepted.cost() else { return Value::Null };
    json!({
        "add": cost.add,
        "mul": cost.mul,
        "fused": cost.fused,
        "div": cost.div,
        "sqrt": cost.sqrt,
        "calls": cost.calls,
    })
}
