//! The emitted controller: its code, run by the interpreter.

use std::sync::Arc;

use super::{Control, Failure, Values};
use crate::check::examine::{greatest, legal};
use crate::code::{Code, Expr, Handle, Instance, Slot, Test, parameter_name};
use crate::controller::of_program;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::{Program, passes};
use crate::reference::Status;
use crate::request::{After, Feedback, Spec, What};
use crate::samples;

/// A controller that runs.
#[derive(Clone, Debug)]
pub struct Controller {
    emitted: Arc<Emitted>,
    instance: Instance,
    /// The duration of the design.
    tau: f64,
}

/// The code of a controller and what is called in it.
#[derive(Debug)]
struct Emitted {
    spec: Spec,
    /// The program of a controller in time.
    program: Option<Program>,
    code: Code,
    /// Parameters left to run time.
    open: Vec<(Parameter, Slot)>,
    arm: Handle,
    /// Start with a duration, of a controller with a clock in time.
    arm_for: Option<Handle>,
    step: Handle,
    deadline: Option<Handle>,
}

/// The optimised program of a controller in time.
pub(super) fn optimised(spec: &Spec) -> Program {
    passes::optimise(lower(spec, &Law::of(spec)), &mut |_, _| {})
}

impl Controller {
    /// The controller of a spec.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec) -> Result<Self, Failure> {
        has_text(spec, true)?;
        let mut spec = Spec { what: What::Controller, ..spec.clone() }.apart();
        if spec.in_flight {
            // The run begins with it.
            spec.fixed.remove(&Parameter::Tau);
        }
        let (code, program) = match spec.sampled() {
            Some(sampled) => (samples::controller(&spec, sampled, Vec::new()), None),
            None => {
                let program = optimised(&spec);
                (of_program(&spec, &program, greatest(&spec).as_ref()), Some(program))
            }
        };
        let instance = Instance::blank(&code);
        let arm_for = code.function("arm_for").filter(|_| spec.in_flight);
        let arm_for = arm_for.map(|own| instance.handle(own.name));
        let slot = |parameter| Some((parameter, instance.slot(parameter)?));
        let open = spec.run_time_parameters().filter_map(slot).collect();
        let [arm, step] = ["arm", "step"].map(|name| instance.handle(name));
        let deadline = code.function("deadline").map(|own| instance.handle(own.name));
        let emitted = Emitted { spec, program, code, open, arm, arm_for, step, deadline };
        Ok(Self { emitted: Arc::new(emitted), instance, tau: f64::NAN })
    }

    /// Returns the result of a function without arguments, such as `estimate`; `None` where there is none.
    pub fn result(&mut self, function: &str) -> Option<&[f64]> {
        let own = self.emitted.code.function(function)?;
        let handle = self.instance.handle(own.name);
        self.instance.perform(handle, &[]);
        Some(self.instance.result(handle))
    }

    /// Returns the spec of the emitted code.
    pub(super) fn spec(&self) -> &Spec {
        &self.emitted.spec
    }

    /// Returns its code as it runs.
    pub(super) fn instance(&self) -> &Instance {
        &self.instance
    }

    /// Returns its code, for a state from elsewhere.
    pub(super) fn instance_mut(&mut self) -> &mut Instance {
        &mut self.instance
    }

    /// Returns its `step`, and its `deadline`, if it has one.
    pub(super) fn handles(&self) -> (Handle, Option<Handle>) {
        (self.emitted.step, self.emitted.deadline)
    }

    /// Returns the parameters that are given to its `init`.
    #[cfg(feature = "lab")]
    pub(super) fn open(&self) -> impl Iterator<Item = Parameter> {
        self.emitted.open.iter().map(|(parameter, _)| *parameter)
    }

    /// Returns its program; `None` for a clock in samples.
    pub(super) fn program(&self) -> Option<&Program> {
        self.emitted.program.as_ref()
    }
}

impl Control for Controller {
    fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        for (parameter, slot) in &self.emitted.open {
            self.instance.set(*slot, values.number(*parameter)?);
        }
        self.tau = values.get(Parameter::Tau);
        self.instance.init(x0).map_err(|_| self.emitted.refused(values))
    }

    fn arm(&mut self, start: f64, x0: &[f64]) -> bool {
        let armed = match self.emitted.arm_for {
            Some(arm_for) => self.instance.perform(arm_for, &[&[start], &[self.tau], x0]),
            None => self.instance.perform(self.emitted.arm, &[&[start], x0]),
        };
        armed.number() >= 0
    }

    fn step(&mut self, t: f64, x: &[f64]) -> (&[f64], Status) {
        let status = self.instance.perform(self.emitted.step, &[&[t], x]);
        (self.instance.result(self.emitted.step), status.into())
    }

    fn call(&mut self, function: &str, given: &[&[f64]]) -> Option<Status> {
        let own = self.emitted.code.function(function)?;
        let handle = self.instance.handle(own.name);
        Some(self.instance.perform(handle, given).into())
    }

    fn deadline(&mut self) -> Option<f64> {
        let deadline = self.emitted.deadline?;
        self.instance.perform(deadline, &[]);
        self.instance.result(deadline).first().copied()
    }
}

impl Emitted {
    /// Why `init` refuses these values.
    fn refused(&self, values: &Values) -> Failure {
        let given = self.open.iter().map(|(parameter, _)| (*parameter, values.get(*parameter)));
        let Some(test) = self.code.refusing(given) else {
            // Of legal parameters `arm_for` refuses what `init` does of others.
            let start = values.get(Parameter::StartTime);
            let finite = (start + values.get(Parameter::Tau)).is_finite();
            return match self.arm_for.filter(|_| finite) {
                Some(_) => without_digits(self.spec.precision),
                None => Failure::not_armed(start),
            };
        };
        match self.tested(test) {
            Some(parameter) => self.outside(parameter, values),
            None => without_digits(self.spec.precision),
        }
    }

    /// The first parameter of a test of parameters as they are given; `None` for a test of what follows from them.
    fn tested(&self, test: &Test) -> Option<Parameter> {
        let (mut given, mut found) = (true, None);
        test.visit(&mut |value| match value {
            Expr::Number(_) | Expr::Count(_) | Expr::Neg(_) => {}
            Expr::Local(_) | Expr::Parameter(_) | Expr::ParameterElement(..) => {
                let mut open = self.open.iter().map(|(parameter, _)| *parameter);
                found = found.or_else(|| open.find(|parameter| is_given(value, *parameter)));
            }
            _ => given = false,
        });
        found.filter(|_| given)
    }

    /// A parameter outside its domain.
    fn outside(&self, parameter: Parameter, values: &Values) -> Failure {
        let (name, value) = (parameter.spelling(), values.get(parameter));
        let mut domain = match (parameter, self.spec.sampled()) {
            (Parameter::Samples, Some(sampled)) => {
                format!("at least {}", sampled.least_samples(self.spec.highest_order()))
            }
            _ => legal(&self.spec, parameter),
        };
        if parameter == Parameter::Tau && self.spec.sampled().is_none() {
            domain += ", and greater than eps";
        }
        Failure::input(
            format!("{name} = {value} is outside its domain"),
            format!("{name} ({}) is {domain}", self.spec.meaning(parameter)),
        )
    }
}

/// Returns true if an expression of `init` is a parameter as it is given.
fn is_given(value: &Expr, parameter: Parameter) -> bool {
    match value {
        Expr::Local(name) => *name == parameter_name(parameter),
        Expr::Parameter(name) => name == parameter.key() && parameter.index().is_none(),
        Expr::ParameterElement(name, index) => {
            name == parameter.key() && parameter.index() == Some(*index)
        }
        _ => false,
    }
}

fn without_digits(precision: Precision) -> Failure {
    let precision = precision.name();
    Failure::input(
        format!("a coefficient of u leaves the range in which {precision} keeps its digits"),
        "the parameters and gains are too far from 1 together: take other units, of time for \
         example",
    )
}

/// Checks that a run in continuous time has a law at every instant.
pub(super) fn has_law(spec: &Spec) -> Result<(), Failure> {
    match spec.sampled() {
        None => Ok(()),
        Some(_) => Err(Failure::input(
            "a clock in samples has no law between the samples",
            "simulate its sampled loop",
        )),
    }
}

/// Checks that a simulation has all of the controller: no function of the user's program.
pub(super) fn has_text(spec: &Spec, after: bool) -> Result<(), Failure> {
    let key = match (&spec.feedback, spec.after) {
        (Feedback::Extern, _) => "pi0",
        (_, After::Extern) if after => "after",
        _ => return Ok(()),
    };
    Err(Failure::input(
        format!("`{key} = extern` is a function of your program, which a simulation does not have"),
        format!("give `{key}` another value for the simulation"),
    ))
}
