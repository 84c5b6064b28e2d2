//! The interpreter: whole controllers, in the operations and the precision of the emitted code.

mod frame;
mod statements;

use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use super::branch::Taken;
use super::{Access, Code, Shape, Status, Variable};
use crate::collect::map;
use crate::internal::fault;
use crate::parameter::{Parameter, Precision};
use crate::program::number;
use frame::{Frame, Settled};

/// Value of a name.
#[derive(Clone, Debug, PartialEq)]
enum Held {
    Real(f64),
    Count(u32),
    Reals(Vec<f64>),
}

/// A value handed to a call or given by it.
pub type Argument<'a> = (&'a str, &'a [f64]);

/// A controller that runs.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    code: &'a Code,
    fields: BTreeMap<&'a str, Held>,
    /// The status of gains; that of a controller is not asked for.
    status: Status,
    /// The branches taken, where they are recorded.
    taken: Option<Taken>,
}

/// Outcome of a call: its status, and its results, which are empty on failure. A call for several axes has them all the
/// same: every u, 0 where it failed, and the status of each as a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its status.
    pub status: Status,
    /// Its results by name; those of gains by the names in them.
    pub results: BTreeMap<String, Vec<f64>>,
}

/// A function of the user's: its name, and what it gives for an array and a time. Where it gives several
/// values, kappa' and the place of the value, from 0, stand behind the array.
pub type Called<'a> = (&'a str, &'a dyn Fn(&[f64], f64) -> f64);

impl<'a> Instance<'a> {
    /// The controller that `init` makes of the parameters, each a list of numbers; counts are given
    /// as numbers. A state that is latched is given by its name too.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn new(code: &'a Code, given: &[Argument<'_>]) -> Result<Self, Status> {
        Self::started(code, given, None).0
    }

    fn started(
        code: &'a Code,
        given: &[Argument<'_>],
        taken: Option<Taken>,
    ) -> (Result<Self, Status>, Option<Taken>) {
        let unset =
            |field: &'a Variable| (field.name.as_str(), held(field, &[f64::NAN], code.precision));
        let mut fields = map(code.fields.iter().map(unset));
        let mut frame = Frame {
            precision: code.precision,
            fields: &mut fields,
            parameters: bound(&code.parameters, given, code.precision),
            locals: BTreeMap::new(),
            callbacks: &[],
            settled: Settled::default(),
            divided_by_zero: Cell::new(false),
            taken: taken.map(RefCell::new),
        };
        let failed = frame.fails(&code.init);
        let start = code.start.as_ref().filter(|_| failed.is_none());
        let time = start.map(|start| frame.real(&start.time));
        let taken = frame.taken.map(RefCell::into_inner);
        if let Some(status) = failed {
            return (Err(status), taken);
        }
        let watching = taken.is_some().then(Taken::default);
        let mut built = Self { code, fields, status: Status::Ok, taken: watching };
        if let (Some(time), Some(start)) = (time, &code.start) {
            let x0 = start.state.as_ref().and_then(|state| {
                given.iter().find(|(name, _)| *name == state.name).map(|(_, values)| *values)
            });
            let outcome = built.call("arm", &[("t0", &[time]), ("x0", x0.unwrap_or_default())]);
            if outcome.status.number() < 0 {
                return (Err(outcome.status), taken);
            }
        }
        (Ok(built), taken)
    }

    /// The controller that `init` makes of its run-time parameters; the elements of an array are in
    /// their order.
    ///
    /// # Errors
    /// The status with which `init` fails.
    pub fn with_parameters(
        code: &'a Code,
        values: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> Result<Self, Status> {
        let given = grouped(values);
        Self::new(code, &arguments(&given))
    }

    /// The same, with the branches that `init` took; those of later calls are added to
    /// [`Instance::taken`].
    pub fn watched(
        code: &'a Code,
        values: impl IntoIterator<Item = (Parameter, f64)>,
    ) -> (Result<Self, Status>, Taken) {
        let given = grouped(values);
        let (built, taken) = Self::started(code, &arguments(&given), Some(Taken::default()));
        (built, taken.unwrap_or_default())
    }

    /// The gains that a call gave, for the functions that belong to them.
    pub fn gains(&self, outcome: &Outcome) -> Self {
        let values = |name: &str| outcome.results.get(name).map_or(&[][..], Vec::as_slice);
        let field =
            |of: &'a Variable| (of.name.as_str(), held(of, values(&of.name), self.code.precision));
        let fields = self.code.gains.iter().map(field).collect();
        Self { code: self.code, fields, status: outcome.status, taken: None }
    }

    /// Calls a function with its arguments.
    pub fn call(&mut self, name: &str, arguments: &[Argument<'_>]) -> Outcome {
        self.call_with(name, arguments, &[])
    }

    /// Calls a function with its arguments and the functions that it calls.
    pub fn call_with(
        &mut self,
        name: &str,
        arguments: &[Argument<'_>],
        callbacks: &[Called<'_>],
    ) -> Outcome {
        let Some(function) = self.code.function(name) else { fault(format!("no function {name}")) };
        let mut changed = self.fields.clone();
        let mut frame = Frame {
            precision: self.code.precision,
            fields: &mut changed,
            parameters: BTreeMap::new(),
            locals: bound(&function.arguments, arguments, self.code.precision)
                .into_iter()
                .map(|(name, held)| (Cow::from(name), held))
                .collect(),
            callbacks,
            settled: Settled::default(),
            divided_by_zero: Cell::new(false),
            taken: self.taken.take().map(RefCell::new),
        };
        let outcome = frame.run(function, self.status, &self.code.gains);
        self.taken = frame.taken.map(RefCell::into_inner);
        if function.access == Access::Change && outcome.status.number() >= 0 {
            self.fields = changed;
        }
        outcome
    }

    /// The branches that its calls took, where it is watched.
    pub fn taken(&self) -> Option<&Taken> {
        self.taken.as_ref()
    }

    /// Returns the value of a field, as a number.
    pub fn field(&self, name: &str) -> Option<f64> {
        match self.fields.get(name)? {
            Held::Real(value) => Some(*value),
            Held::Count(count) => Some(f64::from(*count)),
            Held::Reals(_) => None,
        }
    }
}

/// The values of parameters by their names, those of an array together.
fn grouped(values: impl IntoIterator<Item = (Parameter, f64)>) -> BTreeMap<&'static str, Vec<f64>> {
    let mut given: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    for (parameter, value) in values {
        given.entry(parameter.key()).or_default().push(value);
    }
    given
}

fn arguments<'b>(given: &'b BTreeMap<&'static str, Vec<f64>>) -> Vec<Argument<'b>> {
    given.iter().map(|(key, values)| (*key, values.as_slice())).collect()
}

/// `values` as `variable` holds them.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn held(variable: &Variable, values: &[f64], precision: Precision) -> Held {
    let first = values.first().copied().unwrap_or(f64::NAN);
    match variable.shape {
        Shape::Real => Held::Real(number::settle(first, precision)),
        // A count beyond 2^32 is given modulo 2^32, as a counter wraps.
        Shape::Count => Held::Count(first as u64 as u32),
        Shape::Reals(_) | Shape::Lists(..) => {
            Held::Reals(values.iter().map(|v| number::settle(*v, precision)).collect())
        }
        Shape::Gains | Shape::Statuses(_) => fault("gains and statuses are no values".to_owned()),
    }
}

fn bound<'b>(
    variables: &'b [Variable],
    given: &[Argument<'_>],
    precision: Precision,
) -> BTreeMap<&'b str, Held> {
    let value = |variable: &'b Variable| {
        let values = given.iter().find(|(name, _)| *name == variable.name).map(|(_, v)| *v);
        (variable.name.as_str(), held(variable, values.unwrap_or_default(), precision))
    };
    map(variables.iter().map(value))
}
