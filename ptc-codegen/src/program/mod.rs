//! The staged program: straight-line values, each computed once, as early as it can be known.
//!
//! Invariants, checked by [`Program::check`] between passes:
//! - operands come before their users, so index order is an order of computation;
//! - a value's stage is the latest of its operands' stages, and never earlier;
//! - a value that depends on an [`Op::Unknown`] is used only by such values and by the
//!   [`Op::Root`] that solves for it;
//! - an [`Op::Rows`] is an array: it is used only by its [`Op::Element`]s;
//! - names are unique.
//!
//! Passes keep every bit: the interpreter gives the same results before and after each of them.

mod arithmetic;
pub mod cost;
pub mod digits;
pub mod dump;
pub mod interpret;
pub mod kink;
pub mod lanes;
pub mod machine;
pub mod number;
pub mod passes;
mod reach;
pub mod rows;

pub use arithmetic::apply;

use std::hash::{Hash, Hasher};

use crate::algebra::BigRational;
use crate::expression::Function;
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
    /// When the start time is given.
    Arm,
    /// When time is given.
    Tick,
    /// When the state is given.
    Step,
}

/// What comes from outside.
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
}

impl Input {
    /// When the input becomes known.
    pub fn stage(self) -> Stage {
        match self {
            Self::Parameter(_) => Stage::Init,
            Self::StartTime | Self::StateAtStart(_) => Stage::Arm,
            Self::Time => Stage::Tick,
            Self::State(_)
            | Self::Reference(_)
            | Self::Gain(_)
            | Self::Divisor
            | Self::Drift
            | Self::Control => Stage::Step,
        }
    }
}

/// A bracketed iteration for the root y of a decreasing residual: from `start`, each round takes
/// the root to lie right of y where `residual > 0`, steps to `next`, falls back to the middle of
/// the bracket when `next` leaves it, and ends once the step's `size` is at most `tolerance`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Root {
    /// The unknown y, an [`Op::Unknown`].
    pub unknown: Value,
    /// First y.
    pub start: Value,
    /// Lower end of the bracket.
    pub low: Value,
    /// Upper end of the bracket.
    pub high: Value,
    /// Residual at y.
    pub residual: Value,
    /// Proposed next y.
    pub next: Value,
    /// Size of the proposed step.
    pub size: Value,
    /// Size at which the iteration ends.
    pub tolerance: Value,
    /// Bound on the number of rounds.
    pub rounds: u32,
}

impl Root {
    /// Operands in the order of the fields.
    pub fn operands(&self) -> [Value; 8] {
        let Self { unknown, start, low, high, residual, next, size, tolerance, .. } = *self;
        [unknown, start, low, high, residual, next, size, tolerance]
    }
}

/// An operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Op {
    /// An exact number, rounded once to the program's precision.
    Number(BigRational),
    /// A value from outside.
    Input(Input),
    /// -a.
    Neg(Value),
    /// a + b.
    Add(Value, Value),
    /// a - b.
    Sub(Value, Value),
    /// a * b.
    Mul(Value, Value),
    /// a / b.
    Div(Value, Value),
    /// a / b, and NaN in place of a division by 0.
    Quotient(Value, Value),
    /// a^k, k >= 2: the multiplication chain of the binary digits of k, squares first.
    Power(Value, u32),
    /// The greater one: b where a < b, else a.
    Max(Value, Value),
    /// The smaller one: a where a < b, else b.
    Min(Value, Value),
    /// A function of one number.
    Call(Function, Value),
    /// a^b for a > 0.
    Pow(Value, Value),
    /// The user's own law pi0: its arguments are xi_1..xi_n and stretched time.
    Law(Vec<Value>),
    /// An array by loops: with p(z) = z + sum_d tail_d z^(d+2) and one weight more than the tail has
    /// coefficients, element j is sum_i weights_i \[z^(i+1)\] p^(j+1), as [`rows`](rows::rows) gives it.
    Rows {
        /// Coefficients of z^2, z^3, ...
        tail: Vec<Value>,
        /// Weights of z, z^2, ...
        weights: Vec<Value>,
    },
    /// An element of an array, from 0.
    Element(Value, usize),
    /// The unknown of a [`Root`].
    Unknown,
    /// The root.
    Root(Root),
}

/// By hand, because a ratio hashes its continued fraction, which takes longer than all the rest.
impl Hash for Op {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(self).hash(state);
        match self {
            Self::Number(value) => (value.numer(), value.denom()).hash(state),
            Self::Input(input) => input.hash(state),
            Self::Power(base, exponent) => (base, exponent).hash(state),
            Self::Call(function, operand) => (function, operand).hash(state),
            Self::Element(array, index) => (array, index).hash(state),
            op => op.operands().hash(state),
        }
    }
}

impl Op {
    /// The values it uses.
    pub fn operands(&self) -> Vec<Value> {
        let mut all = Vec::new();
        self.each_operand(|operand| all.push(operand));
        all
    }

    /// Gives its operands one by one.
    fn each_operand(&self, mut give: impl FnMut(Value)) {
        match self {
            Self::Number(_) | Self::Input(_) | Self::Unknown => {}
            Self::Neg(a) | Self::Power(a, _) | Self::Call(_, a) | Self::Element(a, _) => give(*a),
            Self::Law(arguments) => arguments.iter().copied().for_each(give),
            Self::Rows { tail, weights } => tail.iter().chain(weights).copied().for_each(give),
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Quotient(a, b)
            | Self::Max(a, b)
            | Self::Min(a, b)
            | Self::Pow(a, b) => [*a, *b].into_iter().for_each(give),
            Self::Root(root) => root.operands().into_iter().for_each(give),
        }
    }

    /// The same operation on other values.
    pub fn map(&self, mut to: impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Number(_) | Self::Input(_) | Self::Unknown => self.clone(),
            Self::Neg(a) => Self::Neg(to(*a)),
            Self::Power(a, k) => Self::Power(to(*a), *k),
            Self::Call(function, a) => Self::Call(*function, to(*a)),
            Self::Element(array, index) => Self::Element(to(*array), *index),
            Self::Law(arguments) => Self::Law(arguments.iter().map(|a| to(*a)).collect()),
            Self::Rows { tail, weights } => Self::Rows {
                tail: tail.iter().map(|v| to(*v)).collect(),
                weights: weights.iter().map(|v| to(*v)).collect(),
            },
            Self::Add(a, b) => Self::Add(to(*a), to(*b)),
            Self::Sub(a, b) => Self::Sub(to(*a), to(*b)),
            Self::Mul(a, b) => Self::Mul(to(*a), to(*b)),
            Self::Div(a, b) => Self::Div(to(*a), to(*b)),
            Self::Quotient(a, b) => Self::Quotient(to(*a), to(*b)),
            Self::Max(a, b) => Self::Max(to(*a), to(*b)),
            Self::Pow(a, b) => Self::Pow(to(*a), to(*b)),
            Self::Min(a, b) => Self::Min(to(*a), to(*b)),
            Self::Root(r) => Self::Root(Root {
                unknown: to(r.unknown),
                start: to(r.start),
                low: to(r.low),
                high: to(r.high),
                residual: to(r.residual),
                next: to(r.next),
                size: to(r.size),
                tolerance: to(r.tolerance),
                rounds: r.rounds,
            }),
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
    /// Whether it depends on the unknown of a [`Root`], and so belongs to its loop.
    pub looped: bool,
}

/// A controller as values and the roles that some of them play.
#[derive(Clone, Debug)]
pub struct Program {
    /// Precision in which every operation rounds.
    pub precision: Precision,
    /// All values, operands before users.
    pub values: Vec<Definition>,
    /// What the frame of the emitted functions compares with.
    pub limits: Limits,
    /// u of one call of `step`, before it is clipped.
    pub step: Value,
    /// Feedback gains of x_1..x_n, for `tick`, one axis after the other where each has its own; empty if
    /// the law is not a sum of gains.
    pub gains: Vec<Value>,
    /// Input gains g, for `tick`: one, or one for each axis; empty where g is a number or 1.
    pub divisors: Vec<Value>,
    /// Bounds of |u| of each axis, for `tick`; empty where they share one.
    pub bounds: Vec<Value>,
    /// u from the gains that `tick` left, before it is clipped; `None` if there are no gains.
    pub axis: Option<Value>,
    /// What a simulation reads beside these; none in a program that is emitted.
    pub watched: Vec<Value>,
}

/// Values that the frame of the emitted functions uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Start time, kept by `arm` where `step` checks t against it.
    pub start_time: Option<Value>,
    /// Bound of |u|; none for infinity.
    pub u_max: Option<Value>,
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

impl Program {
    /// What `tick` hands over to `axis`.
    pub fn handed_over(&self) -> impl Iterator<Item = &Value> {
        self.gains.iter().chain(&self.divisors).chain(&self.bounds)
    }

    /// How many gains `axis` reads: where `tick` gives more, each axis has its own.
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
        outputs.extend(self.axis);
        outputs.extend(self.handed_over());
        outputs.extend(&self.watched);
        outputs.extend(self.limits.past);
        outputs.extend(self.limits.start_time);
        outputs.extend(self.limits.u_max);
        outputs.extend(self.limits.elapsed.map(|(elapsed, _)| elapsed));
        outputs
    }

    /// The values needed for `roots`, in order of computation.
    pub fn needed(&self, roots: &[Value]) -> Vec<Value> {
        let mut wanted = vec![false; roots.iter().map(|root| root.0 + 1).max().unwrap_or(0)];
        for root in roots {
            wanted[root.0] = true;
        }
        for index in (0..wanted.len()).rev() {
            if wanted[index] {
                self.values[index].op.each_operand(|operand| wanted[operand.0] = true);
            }
        }
        (0..wanted.len()).filter(|i| wanted[*i]).map(Value).collect()
    }

    /// The stage at which `op` is known, from its operands.
    pub fn stage_of(&self, op: &Op) -> Stage {
        match op {
            Op::Number(_) => Stage::Generation,
            Op::Input(input) => input.stage(),
            Op::Unknown => Stage::Tick,
            _ => {
                op.operands().iter().map(|v| self.get(*v).stage).max().unwrap_or(Stage::Generation)
            }
        }
    }

    /// Whether `op` belongs to the loop of a root.
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
            let array = |v: &Value| matches!(self.get(*v).op, Op::Rows { .. });
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
