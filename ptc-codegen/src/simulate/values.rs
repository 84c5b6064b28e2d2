//! Values that a run needs to know: those of every parameter and symbol.

use std::sync::Arc;

use super::Failure;
use crate::collect::map;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::plant::Plant;
use crate::program::Input;
use crate::program::machine::{Machine, Slot};
use crate::program::range::{Range, rounded};
use crate::request::Spec;

/// The values of the parameters of a controller and the symbols of its plant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    /// Parameters that have a value, in order. Copies share it, so that a place that was looked up once serves them
    /// all.
    names: Arc<[Parameter]>,
    numbers: Vec<f64>,
}

impl Values {
    /// Collects the values that the design and the plant fix. The start is at 0 and u without a bound unless they say
    /// otherwise.
    pub fn of(spec: &Spec, plant: &Plant) -> Self {
        let mut values = map([
            (Parameter::StartTime, 0.0),
            (Parameter::UMax, f64::INFINITY),
            (Parameter::UMin, f64::NEG_INFINITY),
            (Parameter::Deadbeat, 0.0),
        ]);
        let fixed = spec.fixed.iter().chain(&plant.fixed);
        values.extend(fixed.map(|(parameter, value)| (*parameter, to_f64(value))));
        // What is not known of the plant is not what a model takes it to be.
        values.retain(|parameter, _| !plant.bounds.contains_key(parameter));
        Self { names: values.keys().copied().collect(), numbers: values.into_values().collect() }
    }

    /// The same with another value of one.
    #[must_use]
    pub fn with(mut self, parameter: Parameter, value: f64) -> Self {
        self.set(parameter, value);
        self
    }

    /// Gives one a value.
    pub fn set(&mut self, parameter: Parameter, value: f64) {
        let place = self.named(parameter);
        self.put(place, value);
    }

    /// The place of one among these values and their copies. One without a value gets NaN.
    pub(crate) fn named(&mut self, parameter: Parameter) -> usize {
        match self.names.binary_search(&parameter) {
            Ok(place) => place,
            Err(place) => {
                let (before, after) = self.names.split_at(place);
                self.names = before.iter().chain([&parameter]).chain(after).copied().collect();
                self.numbers.insert(place, f64::NAN);
                place
            }
        }
    }

    /// Gives the one at a place a value.
    pub(crate) fn put(&mut self, place: usize, value: f64) {
        self.numbers[place] = value;
    }

    /// The value of one; NaN where it has none.
    pub fn get(&self, parameter: Parameter) -> f64 {
        self.find(parameter).map_or(f64::NAN, |place| self.numbers[place])
    }

    /// The value of one.
    ///
    /// # Errors
    /// It has none.
    pub(super) fn number(&self, parameter: Parameter) -> Result<f64, Failure> {
        self.required(parameter).map(|place| self.numbers[place])
    }

    fn find(&self, parameter: Parameter) -> Option<usize> {
        self.names.binary_search(&parameter).ok()
    }

    /// Limits of each input of the controller of `spec`.
    pub fn limits(&self, spec: &Spec) -> Vec<Range> {
        let shared = self.shared_limits(spec.u_min);
        let of = |index| match spec.own_limits(index) {
            Some(_) => Range::fixed(spec, index),
            None => shared,
        };
        (0..spec.input_names().len()).map(of).collect()
    }

    /// The limits of u that are parameters, where it has a lower one of its own or not.
    pub(super) fn shared_limits(&self, own_least: bool) -> Range {
        let most = self.get(Parameter::UMax);
        Range { least: if own_least { self.get(Parameter::UMin) } else { -most }, most }
    }

    /// The parameters and symbols without a value, without which the loop of `spec` and `plant` does
    /// not run; eps only where the emitted code is `emitted`.
    pub fn missing(&self, spec: &Spec, plant: &Plant, emitted: bool) -> Vec<Parameter> {
        let all = spec.parameters().into_iter().chain(plant.symbols(spec));
        let needed = all.filter(|p| emitted || *p != Parameter::Eps);
        needed.filter(|p| self.find(*p).is_none()).collect()
    }

    /// Sets every parameter that `machine` needs.
    ///
    /// # Errors
    /// One that has no value.
    pub(crate) fn give(&self, machine: &mut Machine) -> Result<(), Failure> {
        Given::default().give(self, machine)
    }

    /// The place of an input that is a parameter.
    ///
    /// # Errors
    /// It has no value.
    fn place(&self, input: Input) -> Result<Option<usize>, Failure> {
        let parameter = match input {
            Input::Parameter(parameter) => parameter,
            Input::StartTime => Parameter::StartTime,
            _ => return Ok(None),
        };
        self.required(parameter).map(Some)
    }

    fn required(&self, parameter: Parameter) -> Result<usize, Failure> {
        self.find(parameter).ok_or_else(|| {
            let name = parameter.spelling();
            Failure::input(
                format!("{name} ({}) has no value", parameter.meaning()),
                format!("give {name} a value for this run"),
            )
        })
    }
}

/// The inputs of a program that are parameters, each with its place among values: looked up once for all values
/// of the same names.
#[derive(Clone, Debug)]
pub(crate) struct Given<S> {
    names: Option<Arc<[Parameter]>>,
    places: Vec<(S, usize)>,
}

impl<S> Default for Given<S> {
    fn default() -> Self {
        Self { names: None, places: Vec::new() }
    }
}

impl<S: Copy> Given<S> {
    /// Looks the inputs of a program up, where they are not known.
    ///
    /// # Errors
    /// One that has no value.
    pub(crate) fn find<I: Iterator<Item = (Input, S)>>(
        &mut self,
        values: &Values,
        inputs: impl FnOnce() -> I,
    ) -> Result<(), Failure> {
        if self.names.as_ref().is_some_and(|names| Arc::ptr_eq(names, &values.names)) {
            return Ok(());
        }
        self.names = None;
        self.places.clear();
        for (input, to) in inputs() {
            self.places.extend(values.place(input)?.map(|place| (to, place)));
        }
        self.names = Some(Arc::clone(&values.names));
        Ok(())
    }

    /// The inputs that were found, each with its value.
    pub(crate) fn of(&self, values: &Values) -> impl Iterator<Item = (S, f64)> {
        self.places.iter().map(|(to, place)| (*to, values.numbers[*place]))
    }
}

impl Given<Slot> {
    /// Sets every parameter that `machine` needs.
    ///
    /// # Errors
    /// One that has no value.
    pub(crate) fn give(&mut self, values: &Values, machine: &mut Machine) -> Result<(), Failure> {
        self.find(values, || machine.inputs())?;
        self.of(values).for_each(|(slot, value)| machine.set(Some(slot), value));
        Ok(())
    }
}

fn to_f64(value: &Fixed) -> f64 {
    rounded(value, Precision::F64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_survive_copies_and_are_looked_up_again_for_new_names() {
        let mut values = Values::default().with(Parameter::A, 1.0);
        let mut given = Given::default();
        let inputs = || [(Input::Parameter(Parameter::A), 'a'), (Input::Time, 't')].into_iter();
        given.find(&values, inputs).expect("a value");
        let copy = values.clone().with(Parameter::A, 2.0);
        given.find(&copy, || -> std::iter::Empty<_> { panic!("it is known") }).expect("a value");
        assert_eq!(given.of(&copy).collect::<Vec<_>>(), [('a', 2.0)]);
        // A name before it moves its place.
        values.set(Parameter::Tau, 3.0);
        given.find(&values, inputs).expect("a value");
        assert_eq!(given.of(&values).collect::<Vec<_>>(), [('a', 1.0)]);
        assert_eq!([Parameter::Tau, Parameter::A].map(|p| values.get(p)), [3.0, 1.0]);
        let eps = || [(Input::Parameter(Parameter::Eps), 'e')].into_iter();
        assert!(given.find(&Values::default(), eps).is_err());
    }
}
