//! `init`: a controller from its parameters, and the test that refuses them.

use super::{Argument, Instance, Slot, found, give, held};
use crate::code::branch::{Asked, Taken, at};
use crate::code::{Code, Statement, Status, Test};
use crate::parameter::Parameter;

impl Instance {
    /// The controller that `init` makes of the parameters, each a list of numbers; counts are given
    /// as numbers. A state that is latched is given by its name too.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn new(code: &Code, given: &[Argument<'_>]) -> Result<Self, Status> {
        let mut built = Self::blank(code);
        for parameter in &built.tape.parameters {
            give(&mut built.memory, parameter, found(given, &parameter.name), code.precision);
        }
        let state = code.start.as_ref().and_then(|start| start.state.as_ref());
        let x0 = state.map_or(&[][..], |state| found(given, &state.name));
        built.init(x0).map(|()| built)
    }

    /// The controller that `init` makes of its run-time parameters.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn with_parameters(
        code: &Code,
        values: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> Result<Self, Status> {
        let mut built = Self::blank(code);
        built.set_all(values);
        built.init(&[]).map(|()| built)
    }

    /// The same, with the branches that `init` took; those of later calls are added to
    /// [`Instance::taken`].
    pub fn watched(
        code: &Code,
        values: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> (Result<Self, Status>, Taken) {
        let mut built = Self::compiled(code, Some(Taken::default()));
        built.set_all(values);
        let begun = built.own_init();
        let taken = built.taken.replace(Taken::default()).unwrap_or_default();
        let begun = begun.and_then(|()| built.start(&[]));
        (begun.map(|()| built), taken)
    }

    fn set_all(&mut self, values: impl IntoIterator<Item = (Parameter, f64)>) {
        for (parameter, value) in values {
            if let Some(slot) = self.slot(parameter) {
                self.set(slot, value);
            }
        }
    }

    /// Finds a parameter that `init` is given.
    pub fn slot(&self, parameter: Parameter) -> Option<Slot> {
        let named = self.tape.parameters.iter().find(|named| named.name == parameter.key())?;
        Some(Slot(named.slots.element(parameter.index().unwrap_or(0)), named.shape))
    }

    /// Gives a parameter to the next `init`.
    pub fn set(&mut self, Slot(slot, shape): Slot, value: f64) {
        self.memory[slot] = held(value, shape, self.tape.precision);
    }

    /// `init` with the parameters that are set, and from the state `x0`, where it is latched.
    ///
    /// # Errors
    /// The status with which it fails.
    pub fn init(&mut self, x0: &[f64]) -> Result<(), Status> {
        self.own_init().and_then(|()| self.start(x0))
    }

    /// `init` before it arms.
    fn own_init(&mut self) -> Result<(), Status> {
        legal(self.run(|tape| &tape.init, &[]))
    }

    /// The call of `arm` or `arm_for` that ends `init`.
    fn start(&mut self, x0: &[f64]) -> Result<(), Status> {
        let Some(start) = &self.tape.start else { return Ok(()) };
        let handle = self.handle(start.function);
        let numbers: Vec<_> = start.numbers.iter().map(|slot| [self.memory[*slot]]).collect();
        let given: Vec<_> = numbers.iter().map(<[f64; 1]>::as_slice).chain([x0]).collect();
        legal(self.perform(handle, &given))
    }
}

impl Code {
    /// Finds the test for which `init` refuses parameters; `None` if its own tests hold.
    pub fn refusing(&self, values: impl IntoIterator<Item = (Parameter, f64)>) -> Option<&Test> {
        let (_, taken) = Instance::watched(self, values);
        let tests = self.init.iter().filter_map(|statement| match statement {
            Statement::Require(test, _) => Some(test),
            _ => None,
        });
        let mut parts = tests.flat_map(|test| match test {
            Test::All(parts) => parts.as_slice(),
            one => std::slice::from_ref(one),
        });
        parts.find(|part| taken.went(at(*part, Asked::Test), false))
    }
}

fn legal(status: Status) -> Result<(), Status> {
    if status.number() < 0 { Err(status) } else { Ok(()) }
}
