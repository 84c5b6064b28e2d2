//! A model and a reference at a sample: the chains of a model and its inputs from what the laws want, and the
//! reference with its derivatives.

use super::builder::Builder;
use super::closed_loop::no_limits;
use super::coupled::inputs;
use super::plant::{Form, cheapest, control};
use crate::algebra::{BigRational, integer};
use crate::expression::{Expression, Variable};
use crate::model::Coupled;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Op, Program};
use crate::request::{Sampled, Spec};

/// x_1..x_n of the states of the model of `spec`, all watched, or of each output in turn; its step is
/// u = (w - f)/g, or that of each input, where [`Input::Wanted`] stands for w, the last rate that is wanted of
/// an output, that of the reference included.
pub fn at_sample(spec: &Spec) -> Program {
    let mut spec = Spec { reference: None, ..spec.clone() };
    spec.axes.iter_mut().for_each(|axes| axes.references.clear());
    let spec = &spec;
    cheapest(spec, false, &|form| match spec.decoupled() {
        Some(coupled) => of_outputs(spec, coupled, form),
        None => of_form(spec, form),
    })
}

fn of_form(spec: &Spec, form: Form) -> Option<Program> {
    let mut b = Builder::new(spec);
    form.enter(&mut b)?;
    let watched = (1..=spec.n).map(|j| b.chain(j)).collect();
    let wanted = b.push(Op::Input(Input::Wanted(1)));
    let step = control(&mut b, wanted);
    let limits = no_limits(&mut b);
    Some(Program { watched, ..b.finish(step, limits) })
}

/// The known reference of `spec` at time t since the start, that of a sample: r, ..., r^(n-1) there, then r^(n)
/// in the middle of the time in which the input of this sample acts, and of those in which the inputs under
/// way act; all watched, of several outputs one after the other. Of a linear plant its states on the reference,
/// and its input.
pub fn reference_at_sample(spec: &Spec, sampled: &Sampled) -> Program {
    let at = |derivative: &Expression, time: &Expression| {
        derivative.substitute(&|e| {
            matches!(e.variable()?, Variable::Time | Variable::Elapsed).then(|| time.clone())
        })
    };
    let period = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
    let period = period.map_or(Parameter::SampleTime.into(), |h| Expression::from(h.clone()));
    let now = Expression::from(Variable::Time);
    let middle = |middle: BigRational| {
        let time = now.clone().add(Expression::from(middle.clone()).mul(period.clone()));
        // Before the start there is no reference.
        if middle < integer(0) { time.max(Expression::integer(0)) } else { time }
    };
    let middles: Vec<_> = sampled.middles().map(middle).collect();
    let mut all = Vec::new();
    for derivatives in spec.known_references() {
        let followed = sampled.followed(derivatives);
        let Some((last, below)) = followed.split_last() else { continue };
        all.extend(below.iter().map(|derivative| at(derivative, &now)));
        all.extend(middles.iter().map(|middle| at(last, middle)));
    }
    super::closed_loop::plant(spec, &all)
}

fn of_outputs(spec: &Spec, coupled: &Coupled, form: Form) -> Option<Program> {
    let designs = spec.designs();
    let mut b = Builder::new(spec);
    form.enter(&mut b)?;
    let mut watched = Vec::new();
    for (index, own) in (1..).zip(&designs) {
        b.of_axis(own, index);
        watched.extend((1..=own.n).map(|j| b.chain(j)));
    }
    let mut wanted = Vec::with_capacity(designs.len());
    for (index, own) in (1..).zip(&designs) {
        b.of_axis(own, index);
        let law = b.push(Op::Input(Input::Wanted(index)));
        wanted.push(control(&mut b, law));
    }
    b.of_all(spec);
    let (step, others, determinant) = inputs(&mut b, coupled, wanted);
    let limits = no_limits(&mut b);
    Some(Program { watched, others, determinant, ..b.finish(step, limits) })
}
