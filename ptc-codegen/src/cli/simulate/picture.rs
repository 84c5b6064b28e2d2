//! The picture of the runs.

use crate::plot::{Figure, Quantity, Trace};
use crate::request::Spec;
use num_traits::ToPrimitive;

use super::run::Run;

/// The picture of the runs of a design, with logarithmic axes where `by_decades`.
pub(super) fn figure(spec: &Spec, runs: &[Run], by_decades: bool) -> Figure {
    let loops = if runs.iter().any(|run| run.held) { "sampled" } else { "continuous" };
    let bounds = spec.promises.x_max.iter().filter_map(|bound| bound.number()?.to_f64());
    let several = runs.windows(2).any(|pair| pair[0].mapping != pair[1].mapping);
    let mapping = if several { String::new() } else { format!("{}, ", spec.mapping_name()) };
    Figure {
        title: format!("{}: {}, {mapping}{loops}", spec.name(), spec.order_text()),
        states: Quantity::states(spec),
        inputs: Quantity::inputs(spec),
        traces: runs.iter().map(trace).collect(),
        limits: runs.first().map(|run| run.limits.clone()).unwrap_or_default(),
        x_max: bounds.collect(),
        objectives: Vec::new(),
        by_decades,
    }
}

fn trace(run: &Run) -> Trace {
    let states = run.states.len();
    Trace {
        label: run.label.clone(),
        start: run.t0,
        deadline: run.t0 + run.tau,
        t: run.kept.instants(|row| row.t),
        stretched: run.kept.instants(|row| row.stretched),
        x: (0..states).map(|j| run.kept.curve(j)).collect(),
        u: (0..run.inputs.len()).map(|k| run.kept.curve(states + k)).collect(),
        held: run.held,
    }
}
