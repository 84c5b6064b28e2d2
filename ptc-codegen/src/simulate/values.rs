//! What a run needs to know: the value of every parameter and symbol.

use std::collections::BTreeMap;

use super::Failure;
use crate::collect::map;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::plant::Plant;
use crate::program::machine::Machine;
use crate::program::{Input, number};
use crate::request::Spec;

/// The values of the parameters of a controller and the symbols of its plant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values(BTreeMap<Parameter, f64>);

impl Values {
    /// What the design and the plant fix. The start is at 0 and u without a bound unless they say
    /// otherwise.
    pub fn of(spec: &Spec, plant: &Plant) -> Self {
        let mut values = map([
            (Parameter::StartTime, 0.0),
            (Parameter::UMax, f64::INFINITY),
            (Parameter::Deadbeat, 0.0),
        ]);
        let fixed = spec.fixed.iter().chain(&plant.fixed);
        values.extend(fixed.map(|(parameter, value)| (*parameter, to_f64(value))));
        // What is not known of the plant is not what a model takes it to be.
        values.retain(|parameter, _| !plant.bounds.contains_key(parameter));
        Self(values)
    }

    /// The same with another value of one.
    #[must_use]
    pub fn with(mut self, parameter: Parameter, value: f64) -> Self {
        self.set(parameter, value);
        self
    }

    /// Gives one a value.
    pub fn set(&mut self, parameter: Parameter, value: f64) {
        self.0.insert(parameter, value);
    }

    /// The value of one; NaN where it has none.
    pub fn get(&self, parameter: Parameter) -> f64 {
        self.0.get(&parameter).copied().unwrap_or(f64::NAN)
    }

    /// Bound of |u| of each input of the controller of `spec`.
    pub fn limits(&self, spec: &Spec) -> Vec<f64> {
        let own = spec.axes.as_ref().map(|axes| axes.limits.as_slice()).unwrap_or_default();
        match own {
            [] => vec![self.get(Parameter::UMax); spec.input_names().len()],
            own => own.iter().map(|limit| rounded(limit, spec.precision)).collect(),
        }
    }

    /// The parameters and symbols without a value, without which the loop of `spec` and `plant` does
    /// not run; eps only where the emitted code is `emitted`.
    pub fn missing(&self, spec: &Spec, plant: &Plant, emitted: bool) -> Vec<Parameter> {
        let all = spec.parameters().into_iter().chain(plant.symbols(spec));
        let needed = all.filter(|p| emitted || *p != Parameter::Eps);
        needed.filter(|p| !self.0.contains_key(p)).collect()
    }

    /// Sets every parameter that `machine` needs.
    ///
    /// # Errors
    /// One that has no value.
    pub(crate) fn give(&self, machine: &mut Machine) -> Result<(), Failure> {
        let inputs: Vec<_> = machine.inputs().collect();
        for (input, slot) in inputs {
            if let Some(value) = self.of_input(input)? {
                machine.set(Some(slot), value);
            }
        }
        Ok(())
    }

    /// The value of an input that is a parameter.
    ///
    /// # Errors
    /// It has no value.
    pub(crate) fn of_input(&self, input: Input) -> Result<Option<f64>, Failure> {
        let parameter = match input {
            Input::Parameter(parameter) => parameter,
            Input::StartTime => Parameter::StartTime,
            _ => return Ok(None),
        };
        let value = self.0.get(&parameter).copied();
        value.map(Some).ok_or_else(|| {
            let name = parameter.spelling();
            Failure::input(
                format!("{name} ({}) has no value", parameter.meaning()),
                format!("give {name} a value for this run"),
            )
        })
    }
}

fn to_f64(value: &Fixed) -> f64 {
    rounded(value, Precision::F64)
}

/// A value as a precision holds it.
fn rounded(value: &Fixed, precision: Precision) -> f64 {
    value.number().map_or(f64::INFINITY, |exact| number::round(exact, precision))
}
