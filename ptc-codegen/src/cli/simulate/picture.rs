//! The picture of the runs.

use crate::plot::{Drawn, Figure};
use crate::request::Spec;

use super::run::Run;

/// The picture of the runs of a design, with logarithmic axes where `by_decades`.
pub(super) fn figure(spec: &Spec, runs: &[Run], by_decades: bool) -> Figure {
    let limits = runs.first().map(|run| run.limits.clone()).unwrap_or_default();
    let drawn: Vec<_> = runs.iter().map(drawn).collect();
    Figure::of_runs(spec, &drawn, limits, by_decades)
}

fn drawn(run: &Run) -> Drawn<'_> {
    let Run { label, mapping, tau, t0, held, kept, .. } = run;
    Drawn { label: label.clone(), mapping, tau: *tau, t0: *t0, held: *held, kept }
}
