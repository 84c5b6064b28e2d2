//! A model at a sample: its chain, and its input from what the law wants.

use super::builder::Builder;
use super::closed_loop::no_limits;
use super::input_gain::over_input_gain;
use super::without_drift;
use crate::program::{Input, Op, Program};
use crate::request::Spec;

/// x_1..x_n of the states of the model of `spec`, all watched; its step is u = (w - f)/g, where
/// [`Input::Control`] stands for w, the last rate that the law wants.
pub fn at_sample(spec: &Spec) -> Program {
    let mut b = Builder::new(spec);
    let model = spec.model.iter().flat_map(|model| &model.coordinates);
    let watched = model.map(|coordinate| b.scalar(coordinate)).collect();
    let wanted = b.push(Op::Input(Input::Control));
    let left = without_drift(&mut b, wanted);
    let step = over_input_gain(&mut b, left);
    let limits = no_limits(&mut b);
    Program { watched, ..b.finish(step, limits) }
}
