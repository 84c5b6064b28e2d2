//! A model at a sample: its chains, and its inputs from what the laws want.

use super::builder::Builder;
use super::closed_loop::no_limits;
use super::coupled::inputs;
use super::plant::{Form, cheapest, control};
use crate::model::Coupled;
use crate::program::{Input, Op, Program};
use crate::request::Spec;

/// x_1..x_n of the states of the model of `spec`, all watched, or of each output in turn; its step is
/// u = (w - f)/g, or that of each input, where [`Input::Wanted`] stands for w, the last rate that the law of
/// an output wants.
pub fn at_sample(spec: &Spec) -> Program {
    match spec.decoupled() {
        Some(coupled) => of_outputs(spec, coupled),
        None => cheapest(spec, false, &|form| of_form(spec, form)),
    }
}

fn of_form(spec: &Spec, form: Form) -> Program {
    let coordinates = form.coordinates.clone();
    let mut b = Builder::new(spec);
    b.form = Some(form);
    let watched = coordinates.iter().map(|coordinate| b.scalar(coordinate)).collect();
    let wanted = b.push(Op::Input(Input::Wanted(1)));
    let step = control(&mut b, wanted);
    let limits = no_limits(&mut b);
    Program { watched, ..b.finish(step, limits) }
}

fn of_outputs(spec: &Spec, coupled: &Coupled) -> Program {
    let designs = spec.designs();
    let mut b = Builder::new(spec);
    let coordinates = coupled.outputs.iter().flat_map(|output| &output.coordinates);
    let watched = coordinates.map(|coordinate| b.scalar(coordinate)).collect();
    let mut wanted = Vec::with_capacity(designs.len());
    for (index, own) in (1..).zip(&designs) {
        b.of_axis(own, index);
        let law = b.push(Op::Input(Input::Wanted(index)));
        wanted.push(control(&mut b, law));
    }
    b.of_all(spec);
    let (step, others, determinant) = inputs(&mut b, coupled, wanted);
    let limits = no_limits(&mut b);
    Program { watched, others, determinant, ..b.finish(step, limits) }
}
