//! Budget of the bounds of the sampled loop by cause, as bars.

use crate::check::examine::Report;
use crate::check::sampled::causes;
use crate::diagnostic::{digits, digits_up};
use crate::request::one_or_each;

/// Colours of causes, which the page defines.
const COLOURS: usize = 8;

/// The bound of a state at the deadline.
pub(super) struct Bar {
    pub(super) state: String,
    pub(super) bound: String,
    /// Required error of the design, and its place on the bar in percent.
    pub(super) error: Option<(String, String)>,
    pub(super) parts: Vec<Part>,
}

/// Contribution of one cause.
pub(super) struct Part {
    pub(super) cause: String,
    pub(super) value: String,
    /// Part of the length of the bar.
    pub(super) percent: String,
    /// The class that gives it its colour.
    pub(super) colour: String,
}

/// One bar for each state, as long as the greater of its bound and of what is wanted; none where the
/// loop was not bounded.
pub(super) fn bars(report: &Report) -> Vec<Bar> {
    let Some(worst) = &report.worst else { return Vec::new() };
    let errors = &report.spec.promises.error;
    // The same cause has the same colour in each bar.
    let mut names: Vec<String> = Vec::new();
    let bars = worst.states.iter().enumerate().map(|(i, bound)| {
        let wanted = one_or_each(errors, i);
        let length = bound.total().max(wanted.unwrap_or(0.0));
        let percent = |part: f64| format!("{:.3}", 100.0 * part / length);
        let part = |(cause, part): (String, f64)| {
            let place = names.iter().position(|name| *name == cause).unwrap_or_else(|| {
                names.push(cause.clone());
                names.len() - 1
            });
            let colour = format!("cause{}", place % COLOURS);
            Part { value: digits(part), percent: percent(part), colour, cause }
        };
        Bar {
            state: format!("|x{}|", i + 1),
            bound: digits_up(bound.total()),
            error: wanted.map(|wanted| (digits(wanted), percent(wanted))),
            parts: causes(&report.spec, bound).into_iter().map(part).collect(),
        }
    });
    bars.filter(|bar| bar.parts.iter().all(|part| part.percent.parse().is_ok_and(f64::is_finite)))
        .collect()
}
