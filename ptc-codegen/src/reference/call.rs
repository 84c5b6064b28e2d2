//! A call as the inputs of a program, with which both are compared.

use super::Call;
use crate::parameter::Parameter;
use crate::program::Input;

/// The inputs of one call of a controller with so many states: every value is in the program's
/// precision already.
pub fn inputs(call: &Call<'_>, states: usize) -> impl Fn(Input) -> f64 {
    let of = |states: &[f64], j: usize| states.get(j - 1).copied().unwrap_or(f64::NAN);
    move |input| match input {
        Input::Parameter(parameter) => (call.parameter)(parameter),
        Input::StartTime => (call.parameter)(Parameter::StartTime),
        Input::Time => call.t,
        Input::State(j) => of(call.x, j),
        Input::Reference(order) => of(call.x, states + order + 1),
        Input::StateAtStart(j) => of(call.x0, j),
        Input::ReferenceOf(..)
        | Input::Gain(_)
        | Input::Divisor
        | Input::Drift
        | Input::Control
        | Input::Wanted(_) => f64::NAN,
    }
}
