//! Runs of the closed loop as a figure.

use num_traits::ToPrimitive;

use super::{Figure, Quantity, Trace, range};
use crate::program::range::Range;
use crate::request::Spec;
use crate::simulate::kept::Kept;

/// Most states and most inputs that the legend lists of a run.
const LISTED: usize = 3;

/// Characters of a label beside which there is room for so many.
const SHORT: usize = 24;

/// A run that is drawn.
pub struct Drawn<'a> {
    /// Label that distinguishes it from the others.
    pub label: String,
    /// Its time mapping.
    pub mapping: &'a str,
    /// Settling time in s.
    pub tau: f64,
    /// Start time in s.
    pub t0: f64,
    /// True if u is held between the rows.
    pub held: bool,
    /// Its rows.
    pub kept: &'a Kept,
}

impl Drawn<'_> {
    /// Returns the label of the only run with this settling time.
    pub fn label(tau: f64) -> String {
        format!("tau = {tau} s")
    }

    /// Returns the last states and the largest inputs, for the legend: of each as many as fit.
    fn outcome(&self, spec: &Spec) -> String {
        let Some(last) = self.kept.last() else { return String::new() };
        let most = if self.label.len() > SHORT { 1 } else { LISTED };
        let list = |names: Vec<String>, values: &mut dyn Iterator<Item = f64>| {
            let more = if names.len() > most { ", .." } else { "" };
            let named = names.iter().zip(values).take(most);
            let all = named.map(|(name, value)| format!("{name} = {}", range::label(value)));
            all.collect::<Vec<_>>().join(", ") + more
        };
        let inputs = spec.input_names().iter().map(|name| format!("|{name}|")).collect();
        let peaks = list(inputs, &mut self.kept.peaks.iter().map(|(peak, _)| *peak));
        format!(": final {}; peak {peaks}", list(spec.state_names(), &mut last.x.iter().copied()))
    }

    fn trace(&self, spec: &Spec) -> Trace {
        let (states, inputs) = (spec.states(), spec.input_names().len());
        Trace {
            label: format!("{}{}", self.label, self.outcome(spec)),
            start: self.t0,
            deadline: self.t0 + self.tau,
            t: self.kept.instants(|row| row.t),
            stretched: self.kept.instants(|row| row.stretched),
            x: (0..states).map(|j| self.kept.curve(j)).collect(),
            u: (0..inputs).map(|k| self.kept.curve(states + k)).collect(),
            held: self.held,
        }
    }
}

impl Figure {
    /// Draws runs of the design `spec` beside its `limits` of u and bounds of x, with logarithmic axes where
    /// `by_decades`.
    pub fn of_runs(spec: &Spec, runs: &[Drawn<'_>], limits: Vec<Range>, by_decades: bool) -> Self {
        let loops = if runs.iter().any(|run| run.held) { "sampled" } else { "continuous" };
        let bounds = spec.promises.x_max.iter().filter_map(|bound| bound.number()?.to_f64());
        let several = runs.windows(2).any(|pair| pair[0].mapping != pair[1].mapping);
        let mapping = if several { String::new() } else { format!("{}, ", spec.mapping_name()) };
        Self {
            title: format!("{}: {}, {mapping}{loops}", spec.name(), spec.order_text()),
            states: Quantity::states(spec),
            inputs: Quantity::inputs(spec),
            traces: runs.iter().map(|run| run.trace(spec)).collect(),
            limits,
            x_max: bounds.collect(),
            objectives: Vec::new(),
            by_decades,
        }
    }
}
