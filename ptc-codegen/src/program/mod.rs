//! The staged program: straight-line values, each computed once, as early as it can be known.
//!
//! Invariants, checked by [`Program::check`] between passes:
//! - operands come before their users, so index order is an order of computation;
//! - a value's stage is the latest of its operands' stages, and never earlier;
//! - a value that depends on an [`Op::Unknown`] is used only by such values and by the
//!   [`Op::Root`] that solves for it;
//! - an [`Op::Rows`] or [`Op::Elimination`] is an array: it is used only by its [`Op::Element`]s;
//! - names are unique.
//!
//! Passes keep every bit: the interpreter gives the same results before and after each of them. The
//! exceptions are `balance`, which runs where [`Program::latency`] is set, and `fuse`, where
//! [`Program::fma`] is; the interpreter fuses likewise.

mod arithmetic;
#[cfg(feature = "files")]
mod axes;
pub mod cost;
pub mod digits;
#[cfg(feature = "files")]
pub mod dump;
pub mod elimination;
mod fusion;
pub mod interpret;
pub mod kink;
#[cfg(feature = "simulate")]
pub mod lanes;
pub mod machine;
pub mod number;
mod op;
pub mod passes;
pub mod range;
mod reach;
pub(crate) mod rounding;
pub mod rows;

#[cfg(feature = "files")]
pub(crate) use arithmetic::Arithmetic;
pub use arithmetic::apply;
pub(crate) use fusion::Fusion;
use range::Range;

pub use op::{Op, Root};

use crate::parameter::{Parameter, Precision};

/// Index of a value in its program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Value(pub usize);

/// When a value becomes known: its binding time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// When the code is generated.
    Generation,
    /// When the parameters are given.
    Init,
    /// When the start time is given, and the duration where it changes in flight.
    Arm,
    /// When time is given.
    Tick,
    /// When the state is given.
    Step,
}

/// Value from outside the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Input {
    /// A run-time parameter.
    Parameter(Parameter),
    /// The start time given to `arm`.
    StartTime,
    /// Time t.
    Time,
    /// State x_j, from 1.
    State(usize),
    /// Derivative of this order, from 0, of what the output follows, where each call is given it.
    Reference(usize),
    /// The same of one output of several, from 1: the output, and the order.
    ReferenceOf(usize, usize),
    /// State x_j given to `arm`, from 1.
    StateAtStart(usize),
    /// Feedback gain of x_j, from 1, as `tick` left it.
    Gain(usize),
    /// Input gain g as `tick` left it.
    Divisor,
    /// The plant's own f, where the associated system is computed.
    Drift,
    /// The control u, where the plant is computed.
    Control,
    /// Rate that the law demands of the last state of the chain of an output, from 1, where the plant of a controller
    /// in samples is computed.
    Wanted(usize),
}

impl Input {
    /// Returns its name, in emitted code as in messages.
    pub fn name(self) -> String {
        match self {
            Self::Parameter(parameter) => parameter.spelling(),
            Self::StartTime => "t0".to_owned(),
            Self::Time => "t".to_owned(),
            Self::State(j) => format!("x{j}"),
            Self::StateAtStart(j) => format!("x{j}_0"),
            Self::Reference(order) => format!("r{order}"),
            Self::ReferenceOf(output, order) => format!("r{order}_{output}"),
            Self::Drift => "f".to_owned(),
            Self::Control => "u".to_owned(),
            Self::Wanted(output) => format!("w_{output}"),
            Self::Gain(j) => format!("gain{j}"),
            Self::Divisor => "g".to_owned(),
        }
    }

    /// When the input becomes known.
    pub fn stage(self) -> Stage {
        match self {
            Self::Parameter(_) => Stage::Init,
            Self::StartTime | Self::StateAtStart(_) => Stage::Arm,
            Self::Time => Stage::Tick,
            Self::State(_)
            | Self::Reference(_)
            | Self::ReferenceOf(..)
            | Self::Gain(_)
            | Self::Divisor
            | Self::Drift
            | Self::Control
            | Self::Wanted(_) => Stage::Step,
        }
    }
}

/// A value: its operation, when it is known, and its name in emitted code if it has one.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The operation.
    pub op: Op,
    /// When it is known.
    pub stage: Stage,
    /// Name and meaning, for values that readers know by name.
    pub name: Option<(String, String)>,
    /// True if it depends on the unknown of a [`Root`], and so belongs to its loop.
    pub looped: bool,
}

/// A controller as values and the roles that some of them play.
#[derive(Clone, Debug)]
pub struct Program {
    /// Precision in which every operation rounds.
    pub precision: Precision,
    /// True if products and sums are fused where they can be.
    pub fma: bool,
    /// True if polynomials are evaluated as trees, for short chains of operations.
    pub latency: bool,
    /// True if tau changes in flight: it becomes known when the controller is armed.
    pub in_flight: bool,
    /// All values, operands before users.
    pub values: Vec<Definition>,
    /// Values with which the frame of the emitted functions compares.
    pub limits: Limits,
    /// u of one call of `step`, before it is clipped; of a plant with several inputs the first.
    pub step: Value,
    /// The other inputs of such a plant.
    pub others: Vec<Value>,
    /// Feedback gains of x_1..x_n, for `tick`, one axis after the other where each has its own; empty if
    /// the law is not a sum of gains.
    pub gains: Vec<Value>,
    /// Input gains g, for `tick`: one, or one for each axis; empty where g is a number or 1.
    pub divisors: Vec<Value>,
    /// Bounds of |u| of each axis, or its upper limits, for `tick`; empty where they share one.
    pub bounds: Vec<Value>,
    /// Lower limits of u of each axis, for `tick`; empty where they share one, or each is the opposite of the upper one.
    pub lower: Vec<Value>,
    /// u from the gains that `tick` left, before it is clipped; `None` if there are no gains.
    pub axis: Option<Value>,
    /// The sums of which `axis` is made, those of a level in the order of their computation and each level of
    /// the one before; empty where it is one sum.
    pub parts: Vec<Vec<Value>>,
    /// Determinant of the decoupling matrix, by which the inputs are divided; none where there is none, or
    /// it is a number.
    pub determinant: Option<Value>,
    /// Values that are read besides these: by a simulation, or by the functions of the associated system.
    pub watched: Vec<Value>,
}

/// Values that the frame of the emitted functions uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Start time, kept by `arm` where `step` checks t against it.
    pub start_time: Option<Value>,
    /// Bound of |u|, or the upper limit of u; none for infinity.
    pub u_max: Option<Value>,
    /// Lower limit of u.
    pub u_min: Least,
    /// Time past the deadline, where something else than the held gains follows it.
    pub past: Option<Value>,
    /// Time past the deadline, negative before it, held at `hold_from`.
    pub late: Value,
    /// -eps: from there on the gains are held.
    pub hold_from: Value,
    /// Time-to-go at which the gains are held.
    pub eps: Value,
    /// Elapsed time tau less the time-to-go, held with it, and tau; where it is computed from the
    /// start, which keeps its digits there.
    pub elapsed: Option<(Value, Value)>,
}

/// The lower limit of u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Least {
    /// -u_max.
    Opposite,
    /// None.
    Infinite,
    /// A value of its own.
    Own(Value),
}

impl Least {
    /// The value, where it is one of its own.
    pub fn value(self) -> Option<Value> {
        match self {
            Self::Own(value) => Some(value),
            Self::Opposite | Self::Infinite => None,
        }
    }
}

impl Limits {
    /// The limits of u as values of the program.
    pub fn of_u(&self) -> impl Iterator<Item = Value> {
        self.u_max.into_iter().chain(self.u_min.value())
    }

    /// The limits of u as numbers.
    pub fn range(&self, get: impl Fn(Value) -> f64) -> Range {
        let most = self.u_max.map_or(f64::INFINITY, &get);
        let least = match self.u_min {
            Least::Opposite => -most,
            Least::Infinite => f64::NEG_INFINITY,
            Least::Own(value) => get(value),
        };
        Range { least, most }
    }
}

impl Program {
    /// A program without values: all roles are those of value 0.
    pub(crate) fn empty(precision: Precision) -> Self {
        let nothing = Value(0);
        Self {
            precision,
            fma: false,
            latency: false,
            in_flight: false,
            values: Vec::new(),
            limits: Limits {
                start_time: None,
                u_max: None,
                u_min: Least::Opposite,
                past: None,
                late: nothing,
                hold_from: nothing,
                eps: nothing,
                elapsed: None,
            },
            step: nothing,
            others: Vec::new(),
            gains: Vec::new(),
            divisors: Vec::new(),
            bounds: Vec::new(),
            lower: Vec::new(),
            axis: None,
            parts: Vec::new(),
            determinant: None,
            watched: Vec::new(),
        }
    }

    /// Every u of one call of `step`.
    pub fn controls(&self) -> Vec<Value> {
        [&[self.step], self.others.as_slice()].concat()
    }

    /// Returns the values that `tick` hands over to `axis`.
    pub fn handed_over(&self) -> impl Iterator<Item = &Value> {
        self.gains.iter().chain(&self.divisors).chain(&self.bounds).chain(&self.lower)
    }

    /// Returns the number of gains that `axis` reads: where `tick` returns more, each axis has its own.
    pub fn gains_of_axis(&self) -> usize {
        let is_gain = |d: &&Definition| matches!(d.op, Op::Input(Input::Gain(_)));
        self.values.iter().filter(is_gain).count()
    }

    /// The definition of `value`.
    pub fn get(&self, value: Value) -> &Definition {
        &self.values[value.0]
    }

    /// Every value that something outside the program reads.
    pub fn outputs(&self) -> Vec<Value> {
        let Limits { late, hold_from, eps, .. } = self.limits;
        let mut outputs = vec![self.step, late, hold_from, eps];
        outputs.extend(&self.others);
        outputs.extend(self.axis);
        outputs.extend(self.determinant);
        outputs.extend(self.handed_over());
        outputs.extend(&self.watched);
        outputs.extend(self.limits.past);
        outputs.extend(self.limits.start_time);
        outputs.extend(self.limits.of_u());
        outputs.extend(self.limits.elapsed.map(|(elapsed, _)| elapsed));
        outputs
    }

    /// The values needed for `roots`, in order of computation.
    pub fn needed(&self, roots: &[Value]) -> Vec<Value> {
        self.reached(roots, |op, reach| op.each_operand(reach))
    }

    /// Returns the values on which the numbers of `roots` depend. A value that only guides the iteration of a [`Root`],
    /// such as its start, moves the root by less than its rounding.
    pub fn deciding(&self, roots: &[Value]) -> Vec<Value> {
        self.reached(roots, |op, reach| match op {
            Op::Root(root) => reach(root.residual),
            op => op.each_operand(reach),
        })
    }

    fn reached(&self, roots: &[Value], from: impl Fn(&Op, &mut dyn FnMut(Value))) -> Vec<Value> {
        let mut wanted = vec![false; roots.iter().map(|root| root.0 + 1).max().unwrap_or(0)];
        for root in roots {
            wanted[root.0] = true;
        }
        for index in (0..wanted.len()).rev() {
            if wanted[index] {
                from(&self.values[index].op, &mut |operand| wanted[operand.0] = true);
            }
        }
        (0..wanted.len()).filter(|i| wanted[*i]).map(Value).collect()
    }

    /// The values that each round of a root's loop computes, in order.
    pub fn body(&self, root: &Root) -> impl Iterator<Item = Value> {
        let unknown = root.unknown;
        let needed = self.needed(&[root.residual, root.next, root.size]).into_iter();
        needed.filter(move |v| self.get(*v).looped && *v != unknown)
    }

    /// The stage at which `op` is known, from its operands.
    pub fn stage_of(&self, op: &Op) -> Stage {
        match op {
            Op::Number(_) => Stage::Generation,
            Op::Input(Input::Parameter(Parameter::Tau)) if self.in_flight => Stage::Arm,
            Op::Input(input) => input.stage(),
            Op::Unknown => Stage::Tick,
            _ => {
                op.operands().iter().map(|v| self.get(*v).stage).max().unwrap_or(Stage::Generation)
            }
        }
    }

    /// Returns true for each value that the duration decides, at any start: those that stay where only the start time
    /// changes. None unless the duration changes in flight.
    pub fn of_duration(&self) -> Vec<bool> {
        let mut own: Vec<bool> = Vec::with_capacity(self.values.len());
        for definition in &self.values {
            let waits = |v: &Value| self.get(*v).stage == Stage::Arm && !own[v.0];
            let of_start = match &definition.op {
                Op::Input(input) => !matches!(input, Input::Parameter(_)),
                op => op.operands().iter().any(waits),
            };
            own.push(definition.stage == Stage::Arm && !of_start);
        }
        own
    }

    /// Returns true if `op` belongs to the loop of a root.
    pub fn looped(&self, op: &Op) -> bool {
        match op {
            Op::Unknown => true,
            Op::Root(_) => false,
            _ => op.operands().iter().any(|v| self.get(*v).looped),
        }
    }

    /// Checks the invariants of the module's doc.
    ///
    /// # Errors
    /// The first one that does not hold.
    pub fn check(&self) -> Result<(), String> {
        let mut names = std::collections::BTreeSet::new();
        for (index, definition) in self.values.iter().enumerate() {
            let operands = definition.op.operands();
            if operands.iter().any(|v| v.0 >= index) {
                return Err(format!("value {index} uses a later value"));
            }
            if definition.stage != self.stage_of(&definition.op) {
                return Err(format!("value {index} has the wrong stage"));
            }
            if definition.looped != self.looped(&definition.op) {
                return Err(format!("value {index} is on the wrong side of its loop"));
            }
            let array =
                |v: &Value| matches!(self.get(*v).op, Op::Rows { .. } | Op::Elimination { .. });
            let of_array = matches!(definition.op, Op::Element(..));
            if operands.iter().any(|v| array(v) != of_array) {
                return Err(format!("value {index} takes an array for a number, or the reverse"));
            }
            if let Some((name, _)) = &definition.name
                && !names.insert(name)
            {
                return Err(format!("the name {name} is given twice"));
            }
        }
        match self.outputs().iter().find(|v| v.0 >= self.values.len() || self.get(**v).looped) {
            Some(value) => Err(format!("output {} is no value outside a loop", value.0)),
            None => Ok(()),
        }
    }
}
