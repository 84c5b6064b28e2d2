//! Placement of values: the fields that `init` and `arm` leave, and the work of each function.

use std::collections::{BTreeMap, BTreeSet};

use crate::code::parameter_name;
use crate::lower::Plant;
use crate::parameter::Parameter;
use crate::program::digits::{self, Condition};
use crate::program::{Input, Least, Op, Program, Stage, Value};
use crate::request::Spec;

/// The emitted functions that compute something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Routine {
    /// Parameters to fields.
    Init,
    /// Start time to fields.
    Arm,
    /// Start time and duration to fields.
    ArmFor,
    /// Time and state to u.
    Step,
    /// Time to gains.
    Tick,
    /// Gains and state to u.
    Axis,
    /// The state of the plant, of the associated system.
    Plant,
    /// u, of the associated system.
    Control,
    /// The time of the plant, of that of the associated system.
    Time,
    /// The state of the associated system at the start, of that of the plant.
    Start,
}

/// A field of the controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Field {
    /// The value it keeps.
    pub(crate) value: Value,
    /// Its name.
    pub(crate) name: String,
    /// Its meaning.
    pub(crate) meaning: String,
    /// The arguments that decide it.
    pub(crate) phase: Phase,
}

/// The arguments that decide a value, and so the calls that compute it: stages, of which that of `arm` is parted where the
/// duration changes in flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Phase {
    /// The parameters: `init`.
    Init,
    /// The duration: `arm_for`.
    Duration,
    /// The start: `arm` and `arm_for`.
    Start,
    /// Time and state.
    Call,
}

/// The layout of a program in an emitted file.
pub(crate) struct Plan<'a> {
    /// The program.
    pub(crate) program: &'a Program,
    /// The fields, in order of computation.
    pub(crate) fields: Vec<Field>,
    names: BTreeMap<Value, String>,
    /// True for each value that the duration decides.
    of_duration: Vec<bool>,
}

impl<'a> Plan<'a> {
    /// The plan of `program`, which is that of `spec`.
    pub(crate) fn new(spec: &Spec, program: &'a Program) -> Self {
        let of_duration = program.of_duration();
        let mut plan = Self { program, fields: Vec::new(), names: BTreeMap::new(), of_duration };
        for (index, definition) in program.values.iter().enumerate() {
            let name = match (&definition.name, &definition.op) {
                (Some((name, _)), _) => name.clone(),
                (None, Op::Input(input)) => input_name(*input),
                _ => continue,
            };
            plan.names.insert(Value(index), name);
        }
        let mut kept = BTreeSet::new();
        kept.extend(program.limits.start_time);
        kept.extend(program.limits.of_u());
        kept.extend([program.limits.hold_from, program.limits.eps]);
        for value in program.needed(&program.outputs()) {
            let phase = plan.phase(value);
            let earlier = |v: &Value| plan.phase(*v) < phase;
            kept.extend(program.get(value).op.operands().into_iter().filter(earlier));
        }
        // What `arm_for` checks may follow from values of `init` that nothing else reads.
        let [_, checks] = digits::checks(spec, program);
        let of_init = |v: &Value| plan.phase(*v) < Phase::Duration;
        kept.extend(checks.iter().flat_map(Condition::values).filter(of_init));
        let of_plant = Plant::of(program).map(|plant| plant.at_a_time()).unwrap_or_default();
        let results = program
            .handed_over()
            .chain([&program.step])
            .chain(&program.others)
            .chain(&program.axis)
            .chain(&of_plant);
        kept.extend(results.filter(|v| plan.phase(**v) < Phase::Call));
        let kept: Vec<_> = kept.into_iter().filter(|v| !plan.is_literal(*v)).collect();
        for value in kept {
            plan.keep(value);
        }
        plan
    }

    fn keep(&mut self, value: Value) {
        let definition = self.program.get(value);
        let phase = self.phase(value);
        let name = self.names.entry(value).or_insert_with(|| format!("f{}", value.0)).clone();
        let meaning = match (&definition.name, &definition.op) {
            (Some((_, meaning)), _) => meaning.clone(),
            (None, Op::Input(Input::Parameter(Parameter::UMax)))
                if self.program.limits.u_min != Least::Opposite =>
            {
                Parameter::UPPER_LIMIT.to_owned()
            }
            (None, Op::Input(Input::Parameter(parameter))) => parameter.meaning().to_owned(),
            (None, Op::Input(Input::StartTime)) => "start time".to_owned(),
            (None, Op::Input(Input::StateAtStart(_))) => "state at the start".to_owned(),
            _ if phase == Phase::Start => "derived at the start time".to_owned(),
            _ if phase == Phase::Duration => "derived from the duration".to_owned(),
            _ => "derived from the parameters".to_owned(),
        };
        self.fields.push(Field { value, name, meaning, phase });
    }

    fn phase(&self, value: Value) -> Phase {
        match self.program.get(value).stage {
            Stage::Generation | Stage::Init => Phase::Init,
            Stage::Arm if self.of_duration[value.0] => Phase::Duration,
            Stage::Arm => Phase::Start,
            Stage::Tick | Stage::Step => Phase::Call,
        }
    }

    /// Returns true if a value is written as a literal wherever it is used.
    pub(crate) fn is_literal(&self, value: Value) -> bool {
        matches!(self.program.get(value).op, Op::Number(_))
    }

    /// Name of a value that has one.
    pub(crate) fn name(&self, value: Value) -> Option<&str> {
        self.names.get(&value).map(String::as_str)
    }

    /// Returns the values that `function` must compute.
    pub(crate) fn roots(&self, function: Routine) -> Vec<Value> {
        match function {
            Routine::Init | Routine::Arm | Routine::ArmFor => {
                self.set_by(function).map(|field| field.value).collect()
            }
            Routine::Step => {
                let limits = self.program.limits;
                let mut roots = self.program.controls();
                roots.push(limits.late);
                roots.extend(limits.past);
                roots
            }
            Routine::Tick => {
                self.program.handed_over().copied().chain([self.program.limits.late]).collect()
            }
            Routine::Axis => self.program.axis.into_iter().collect(),
            Routine::Plant => self.of_plant(|plant| plant.states.to_vec()),
            Routine::Control => self.of_plant(|plant| vec![plant.control]),
            Routine::Time => self.of_plant(|plant| vec![plant.time]),
            Routine::Start => self.of_plant(|plant| plant.start.to_vec()),
        }
    }

    /// The fields that `function` sets.
    pub(crate) fn set_by(&self, function: Routine) -> impl Iterator<Item = &Field> {
        self.fields.iter().filter(move |field| match function {
            Routine::Init => field.phase == Phase::Init,
            Routine::Arm => field.phase == Phase::Start,
            Routine::ArmFor => field.phase > Phase::Init,
            _ => false,
        })
    }

    fn of_plant(&self, of: impl Fn(Plant<'_>) -> Vec<Value>) -> Vec<Value> {
        Plant::of(self.program).map(of).unwrap_or_default()
    }

    /// Returns true if `function` reads `value` from a field instead of computing it.
    pub(crate) fn is_field(&self, function: Routine, value: Value) -> bool {
        let own = match function {
            Routine::Init => Phase::Init,
            // The state at the start is an argument here, and no field.
            Routine::Arm | Routine::Start => Phase::Start,
            Routine::ArmFor => Phase::Duration,
            _ => Phase::Call,
        };
        !self.is_literal(value) && self.phase(value) < own
    }
}

/// Name of an input in every language.
fn input_name(input: Input) -> String {
    match input {
        Input::Parameter(parameter) => parameter_name(parameter),
        other => other.name(),
    }
}
