//! A model at a sample: its chain, and its input from what the law wants.

use super::builder::Builder;
use super::closed_loop::no_limits;
use super::plant::{Form, cheapest, control};
use crate::program::{Input, Op, Program};
use crate::request::Spec;

/// x_1..x_n of the states of the model of `spec`, all watched; its step is u = (w - f)/g, where
/// [`Input::Control`] stands for w, the last rate that the law wants.
pub fn at_sample(spec: &Spec) -> Program {
    cheapest(spec, false, &|form| of_form(spec, form))
}

fn of_form(spec: &Spec, form: Form) -> Program {
    let coordinates = form.coordinates.clone();
    let mut b = Builder::new(spec);
    b.form = Some(form);
    let watched = coordinates.iter().map(|coordinate| b.scalar(coordinate)).collect();
    let wanted = b.push(Op::Input(Input::Control));
    let step = control(&mut b, wanted);
    let limits = no_limits(&mut b);
    Program { watched, ..b.finish(step, limits) }
}
