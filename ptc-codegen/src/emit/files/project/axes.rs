//! Several axes in a project: their gains and starts, and the words that differ in its templates.

use super::config::{Config, Words};
use super::constant;
use crate::algebra::integer;
use crate::program::number;
use crate::request::Spec;

/// The controller of each axis, or the only one.
pub(super) fn each(spec: &Spec) -> impl Iterator<Item = Spec> {
    let axes = spec.axes.as_ref().map(|axes| axes.count);
    let one = axes.is_none().then(|| spec.clone());
    one.into_iter().chain((0..axes.unwrap_or(0)).map(|index| spec.axis(index)))
}

/// The input gain of each axis; none where all are 1.
pub(super) fn gains(spec: &Spec, words: &Words) -> Vec<String> {
    let one = integer(1);
    let gain = |own: Spec| match own.sampled() {
        Some(sampled) => sampled.gain.clone(),
        None => own.input_gain.as_ref().and_then(constant).unwrap_or(&one).clone(),
    };
    let gains: Vec<_> = each(spec).filter(|_| spec.axes.is_some()).map(gain).collect();
    match gains.iter().all(|gain| *gain == one) {
        true => Vec::new(),
        false => {
            let text = |gain| words.number(number::round(gain, spec.precision));
            gains.iter().map(text).collect()
        }
    }
}

/// Words of the templates that differ with several axes.
impl Config {
    /// Dimensions of the state in C.
    pub(super) fn dimensions(&self) -> &'static str {
        if self.axes.is_some() { "[M][N]" } else { "[N]" }
    }

    /// The type of the state in Rust.
    pub(super) fn of_state(&self) -> String {
        let one = format!("[{}; N]", self.real);
        if self.axes.is_some() { format!("[{one}; M]") } else { one }
    }

    /// The function that gives the largest |x_i|.
    pub(super) fn norm(&self) -> &'static str {
        if self.axes.is_some() { "norm_of_axes" } else { "norm" }
    }

    /// The state that the function `plant` of a file of C with a global state moves.
    pub(super) fn moved(&self) -> &'static str {
        if self.axes.is_some() { "own" } else { "x" }
    }

    /// Factor of u of an axis.
    pub(super) fn acting(&self) -> &'static str {
        if self.gains.is_empty() { "" } else { "GAINS[axis] * " }
    }

    /// What `step` returns in Rust.
    pub(super) fn given(&self) -> &'static str {
        if self.axes.is_some() { "Axes" } else { "Control" }
    }

    /// The columns of the table.
    pub(super) fn printed(&self) -> String {
        match self.axes {
            Some(axes) => format!("x1_1..x{}_{axes}, u1..u{axes}", self.n),
            None => format!("x1..x{}, u", self.n),
        }
    }
}

/// The plant in a line: a chain, or one for each axis.
pub(super) fn about(spec: &Spec, chain: String) -> String {
    match &spec.axes {
        Some(axes) => format!("{} axes of {chain}", axes.count),
        None => chain,
    }
}
