//! Random calls of the controller of a design, and what the interpreter gives for them.

use std::collections::BTreeMap;

use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Argument, Code, Function, Instance, Outcome, Shape};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::law::Law;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::{Guard, Spec};
use ptc_codegen::samples;

use crate::harness::optimised;
use crate::harness::random::Random;
use crate::harness::specs::rounded;

/// Calls of each controller.
const CALLS: usize = 60;

/// Every how many of them has an argument that is not finite, where arguments are checked.
const ODD: usize = 7;

/// A controller and what its calls are given.
pub(super) struct Calls {
    pub(super) code: Code,
    /// Parameters, and a latched state, by name.
    pub(super) parameters: BTreeMap<String, Vec<f64>>,
    /// For each call its arguments, in their order.
    pub(super) all: Vec<Vec<Vec<f64>>>,
}

/// A status, and behind it every u by its bits, in double precision, and the statuses of several inputs.
pub(super) type Line = (i64, Vec<u64>, Vec<i64>);

impl Calls {
    /// Calls of `step`; `None` where there is none, or one that calls functions of the user's.
    pub(super) fn of(spec: &Spec, seed: u64) -> Option<Self> {
        let code = whole(spec);
        let step = code.function("step").filter(|step| step.callbacks.is_empty())?;
        let mut random = Random(seed);
        let mut parameters: BTreeMap<_, Vec<f64>> = BTreeMap::new();
        for parameter in spec.run_time_parameters() {
            parameters.entry(parameter.key().to_owned()).or_default().push(value(parameter));
        }
        let state = code.start.as_ref().and_then(|start| start.state.as_ref());
        if let Some(state) = state {
            let length = state.shape.length().unwrap_or(1);
            let values = (0..length).map(|_| rounded(random.between(-2.0, 2.0), spec.precision));
            parameters.insert(state.name.clone(), values.collect());
        }
        let checked = spec.guard == Guard::Full;
        let draw = |index| arguments(step, spec.precision, index, checked, &mut random);
        let all = (0..CALLS).map(draw).collect();
        Some(Self { parameters, all, code })
    }

    pub(super) fn step(&self) -> &Function {
        self.code.function("step").expect("a step")
    }

    /// Returns the results of the interpreter: the status of `init`, and a line for each call where it succeeds.
    pub(super) fn interpreted(&self) -> Vec<Line> {
        let given: Vec<Argument<'_>> =
            self.parameters.iter().map(|(name, values)| (&**name, &**values)).collect();
        let mut controller = match Instance::new(&self.code, &given) {
            Ok(controller) => controller,
            Err(status) => return vec![(i64::from(status.number()), Vec::new(), Vec::new())],
        };
        let step = self.step();
        let call = |arguments: &Vec<Vec<f64>>| {
            let names = step.arguments.iter().map(|argument| &*argument.name);
            let given: Vec<_> = names.zip(arguments.iter().map(Vec::as_slice)).collect();
            line(&controller.call("step", &given))
        };
        std::iter::once((0, Vec::new(), Vec::new())).chain(self.all.iter().map(call)).collect()
    }
}

/// The program of the whole controller.
fn whole(spec: &Spec) -> Code {
    if let Some(sampled) = spec.sampled() {
        return samples::controller(spec, sampled, Vec::new());
    }
    let (report, law, program) = (examine(spec), Law::of(spec), optimised(spec));
    controller::whole(&Controller { report: &report, law: &law, program: &program, measured: &[] })
}

/// A value of a parameter that is left to run time, which both precisions hold.
fn value(parameter: Parameter) -> f64 {
    match parameter {
        Parameter::StartTime => 0.0,
        Parameter::Eps => 0.015_625,
        Parameter::UMax => 24.0,
        Parameter::UMin => -3.0,
        Parameter::Gain(i) => 10.0 + f64::from(u32::try_from(i).expect("a small number")),
        Parameter::Rate(i) => 0.75 + f64::from(u32::try_from(i).expect("a small number")) / 8.0,
        Parameter::Named(_) => 1.75,
        _ => 1.0,
    }
}

fn arguments(
    step: &Function,
    precision: Precision,
    index: usize,
    checked: bool,
    random: &mut Random,
) -> Vec<Vec<f64>> {
    let size = random.magnitude(1e-3, 10.0);
    let odd = (checked && index % ODD == 3).then(|| random.below(step.arguments.len() as u64));
    let of = |(place, argument): (usize, &ptc_codegen::code::Variable)| {
        let mut values: Vec<f64> = match argument.shape {
            // Ticks, from the first on.
            Shape::Count => return vec![f64::from(u32::try_from(index).expect("a tick"))],
            Shape::Real => vec![random.between(0.0, 1.75)],
            shape => {
                let count = shape.length().unwrap_or(1);
                (0..count).map(|_| random.between(-size, size)).collect()
            }
        };
        if odd == Some(place as u64) {
            let last = values.len() - 1;
            values[last] = [f64::NAN, f64::INFINITY, -1e30][index % 3];
        }
        values.into_iter().map(|value| rounded(value, precision)).collect()
    };
    step.arguments.iter().enumerate().map(of).collect()
}

#[allow(clippy::cast_possible_truncation)]
fn line(outcome: &Outcome) -> Line {
    let results = |name: &str| outcome.results.get(name).map_or(&[][..], Vec::as_slice);
    let u = match results("u") {
        [] => vec![0.0_f64.to_bits()],
        given => given.iter().map(|u| u.to_bits()).collect(),
    };
    let axes = results("axes").iter().map(|status| *status as i64).collect();
    (i64::from(outcome.status.number()), u, axes)
}
