//! A model and a reference at a sample: the chain of a model and its input from what the law wants, and the
//! reference with its derivatives.

use super::builder::Builder;
use super::closed_loop::no_limits;
use super::plant::{Form, cheapest, control};
use crate::algebra::integer;
use crate::expression::{Expression, Variable};
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Op, Program};
use crate::request::{Reference, Sampled, Spec};

/// x_1..x_n of the states of the model of `spec`, all watched; its step is u = (w - f)/g, where
/// [`Input::Control`] stands for w, the last rate that is wanted, that of the reference included.
pub fn at_sample(spec: &Spec) -> Program {
    let spec = &Spec { reference: None, ..spec.clone() };
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

/// The known reference of `spec` at time t since the start, that of a sample: r, ..., r^(n-1) there, then r^(n)
/// in the middle of the time in which the input of this sample acts, and of those in which the inputs under
/// way act; all watched.
pub fn reference_at_sample(spec: &Spec, sampled: &Sampled) -> Program {
    let Some(Reference::Known(derivatives)) = &spec.reference else {
        crate::internal::fault("no reference is known")
    };
    let at = |order: usize, time: &Expression| {
        derivatives[order].substitute(&|e| {
            matches!(e.variable()?, Variable::Time | Variable::Elapsed).then(|| time.clone())
        })
    };
    let period = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
    let period = period.map_or(Parameter::SampleTime.into(), |h| Expression::from(h.clone()));
    let now = Expression::from(Variable::Time);
    let mut all: Vec<_> = (0..spec.n).map(|order| at(order, &now)).collect();
    for middle in sampled.middles() {
        let time = now.clone().add(Expression::from(middle.clone()).mul(period.clone()));
        // Before the start there is no reference.
        let time = if middle < integer(0) { time.max(Expression::integer(0)) } else { time };
        all.push(at(spec.n, &time));
    }
    super::closed_loop::plant(spec, &all)
}
