//! Inputs and outputs of an FMU whose deadline changes in flight: the functions of the controller that the importer has no
//! call for.

use super::signals::Signal;
use super::units::chain_units;
use crate::code::{Code, Function, Shape};
use crate::request::Spec;
use crate::samples::controller;

/// Inputs that change a controller while it runs.
#[derive(Default)]
pub(super) struct Steering {
    /// True with a clock in time, of which the duration alone changes.
    pub(super) in_time: bool,
    /// Inputs that are numbers, members of `steering`.
    pub(super) inputs: Vec<Signal>,
    /// Inputs that are 0 or 1.
    pub(super) switches: Vec<Signal>,
    /// True if x1 may be at rest elsewhere than at 0.
    pub(super) target: bool,
    /// True if estimates move with the target.
    pub(super) moves: bool,
    /// True if `arm_for` takes the measurement.
    pub(super) judges: bool,
    /// True if the drive may report the input that it applied.
    pub(super) applied: bool,
    /// Estimates that may be known.
    pub(super) known: usize,
    /// True if the disturbance is among the estimates.
    pub(super) disturbance: bool,
    /// True if the first of the estimates is that of x1.
    pub(super) estimates_x1: bool,
    /// The search for the soonest deadline, where there is one: true if it takes the measurement.
    pub(super) soonest: Option<bool>,
}

impl Steering {
    /// Returns it for a spec whose deadline changes in flight.
    pub(super) fn of(spec: &Spec) -> Option<Self> {
        if spec.changes_duration() {
            return Some(Self::of_duration(spec));
        }
        let sampled = spec.sampled().filter(|own| own.flight.is_some())?;
        let code = controller(spec, sampled, Vec::new());
        let known = code.function("assume").map_or(0, length);
        let first = spec.n + 1 - known;
        let mut steering = Self {
            target: spec.is_one_chain() && spec.reference.is_none(),
            moves: code.function("move").is_some(),
            judges: takes_state(&code, "arm_for"),
            applied: code.function("applied").is_some(),
            known,
            disturbance: code.function("assume_disturbance").is_some(),
            estimates_x1: known > 0 && first == 1,
            soonest: code.function("soonest").map(|_| takes_state(&code, "soonest")),
            ..Self::default()
        };
        steering.add_inputs(spec, first);
        Some(steering)
    }

    /// Returns it for a spec with a clock in time, whose duration changes.
    fn of_duration(spec: &Spec) -> Self {
        let mut steering = Self { in_time: true, ..Self::default() };
        steering.add_inputs(spec, 1);
        steering
    }

    fn add_inputs(&mut self, spec: &Spec, first: usize) {
        let signal = |name: &str, about: String| Signal {
            name: name.to_owned(),
            place: format!("steering.{name}"),
            about,
            axis: None,
        };
        let unit = |state| if self.target { chain_units(spec, state) } else { String::new() };
        let of_input = spec.input_unit().map_or(String::new(), |unit| format!(" [{unit}]"));
        if self.target {
            let about = format!("Place of x1 at rest; a change moves the target{}", unit(1));
            self.inputs.push(signal("target", about));
        }
        let about = "Time from the start to rest, asked for by a change; 0 leaves the deadline [s]";
        self.inputs.push(signal("deadline", about.to_owned()));
        if self.applied {
            let about = "Input that the drive applied in place of the last u, where `applied` is 1";
            self.inputs.push(signal("u_applied", format!("{about}{of_input}")));
            let about = "1 where u_applied is the input that the drive applied".to_owned();
            self.switches.push(signal("applied", about));
        }
        for (index, state) in (0..self.known).zip(first..) {
            let about = format!("x{state} where `known` becomes 1{}", unit(state));
            let place = format!("steering.x_known[{index}]");
            self.inputs.push(Signal { place, ..signal(&format!("x{state}_known"), about) });
        }
        if self.disturbance {
            let about = format!("Constant that is added to u, where `known` becomes 1{of_input}");
            self.inputs.push(signal("d_known", about));
        }
        if self.known > 0 {
            let about = "A change to 1 says that the state is known at this sample".to_owned();
            self.switches.push(signal("known", about));
        }
    }
}

/// The length of the array that a function is given.
fn length(function: &Function) -> usize {
    match function.arguments.first().map(|argument| argument.shape) {
        Some(Shape::Reals(count)) => count,
        _ => 0,
    }
}

fn takes_state(code: &Code, name: &str) -> bool {
    let arguments = code.function(name).map(|function| &function.arguments);
    arguments.is_some_and(|all| all.iter().any(|own| own.shape.length().is_some()))
}
