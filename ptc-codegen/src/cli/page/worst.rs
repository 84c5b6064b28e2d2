//! The worst run of the sampled loop, drawn.

use crate::check::examine::Report;
use crate::check::sampled::trajectory;
use crate::diagnostic::digits;
use crate::plot::{Figure, Quantity, Trace};

use super::svg::Svg;
use crate::cli::report::Failure;

/// A drawing and what it shows.
pub(super) struct Drawn {
    pub(super) figure: Svg,
    pub(super) caption: String,
}

/// The run in which the state that is farthest from what is wanted ends worst; none where the loop was
/// not bounded.
pub(super) fn drawn(report: &Report) -> Result<Option<Drawn>, Failure> {
    let spec = &report.spec;
    let run = report.worst.as_ref().and_then(|_| trajectory(spec, report.expanded.as_ref()));
    let Some(run) = run else { return Ok(None) };
    let end = run.x[run.state].last().copied().unwrap_or(f64::NAN);
    let state = format!("x{}", run.state + 1);
    let caption = format!(
        "The signals of x0, noise, steps and f with which |{state}| ends worst, at {}: with the input gain in the middle, samples in time, and f held over each sample.",
        digits(end.abs())
    );
    let figure = Figure {
        title: format!("{}: worst run of the loop for {state}", spec.name()),
        states: (1..=run.x.len()).map(|j| Quantity::plain(format!("x{j}"))).collect(),
        inputs: vec![Quantity::plain("u")],
        traces: vec![Trace {
            label: format!("worst {state}"),
            start: 0.0,
            deadline: run.t.last().copied().unwrap_or(f64::NAN),
            stretched: vec![f64::NAN; run.t.len()],
            t: run.t,
            x: run.x,
            u: vec![run.u],
            held: true,
        }],
        ..Figure::default()
    };
    Ok(Some(Drawn { figure: Svg::of(&figure)?, caption }))
}
