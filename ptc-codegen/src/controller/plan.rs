//! Placement of values: the fields that `init` and `arm` leave, and the work of each function.

use std::collections::{BTreeMap, BTreeSet};

use crate::code::parameter_name;
use crate::lower::Plant;
use crate::parameter::Parameter;
use crate::program::{Input, Least, Op, Program, Stage, Value};

/// The emitted functions that compute something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Routine {
    /// Parameters to fields.
    Init,
    /// Start time to fields.
    Arm,
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
    /// True if `arm` sets it; otherwise `init` does.
    pub(crate) armed: bool,
}

/// Computations of one call: the stages between two sets of fields.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Phase {
    Init,
    Arm,
    Call,
}

impl Phase {
    fn of(stage: Stage) -> Self {
        match stage {
            Stage::Generation | Stage::Init => Self::Init,
            Stage::Arm => Self::Arm,
            Stage::Tick | Stage::Step => Self::Call,
        }
    }
}

/// The layout of a program in an emitted file.
pub(crate) struct Plan<'a> {
    /// The program.
    pub(crate) program: &'a Program,
    /// The fields, in order of computation.
    pub(crate) fields: Vec<Field>,
    names: BTreeMap<Value, String>,
}

impl<'a> Plan<'a> {
    /// The plan of `program`.
    pub(crate) fn new(program: &'a Program) -> Self {
        let mut plan = Self { program, fields: Vec::new(), names: BTreeMap::new() };
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
            let definition = program.get(value);
            let phase = Phase::of(definition.stage);
            let earlier = |v: &Value| Phase::of(program.get(*v).stage) < phase;
            kept.extend(definition.op.operands().into_iter().filter(earlier));
        }
        let of_plant = Plant::of(program).map(|plant| plant.at_a_time()).unwrap_or_default();
        let results = program
            .handed_over()
            .chain([&program.step])
            .chain(&program.others)
            .chain(&program.axis)
            .chain(&of_plant);
        kept.extend(results.filter(|v| Phase::of(program.get(**v).stage) < Phase::Call));
        let kept: Vec<_> = kept.into_iter().filter(|v| !plan.is_literal(*v)).collect();
        for value in kept {
            plan.keep(value);
        }
        plan
    }

    fn keep(&mut self, value: Value) {
        let definition = self.program.get(value);
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
            _ if definition.stage == Stage::Arm => "derived at the start time".to_owned(),
            _ => "derived from the parameters".to_owned(),
        };
        self.fields.push(Field { value, name, meaning, armed: definition.stage == Stage::Arm });
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
            Routine::Init => self.fields.iter().filter(|f| !f.armed).map(|f| f.value).collect(),
            Routine::Arm => self.fields.iter().filter(|f| f.armed).map(|f| f.value).collect(),
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

    fn of_plant(&self, of: impl Fn(Plant<'_>) -> Vec<Value>) -> Vec<Value> {
        Plant::of(self.program).map(of).unwrap_or_default()
    }

    /// Returns true if `function` reads `value` from a field instead of computing it.
    pub(crate) fn is_field(&self, function: Routine, value: Value) -> bool {
        let own = match function {
            Routine::Init => Phase::Init,
            // The state at the start is an argument here, and no field.
            Routine::Arm | Routine::Start => Phase::Arm,
            _ => Phase::Call,
        };
        !self.is_literal(value) && Phase::of(self.program.get(value).stage) < own
    }
}

/// Name of an input in every language.
fn input_name(input: Input) -> String {
    match input {
        Input::Parameter(parameter) => parameter_name(parameter),
        other => other.name(),
    }
}
