//! Appending operations to a program under construction.

use std::collections::{BTreeMap, HashMap};

use crate::algebra::{BigRational, Symbol, integer};
use crate::expansion::Expanded;
use crate::expression::Expression;
use crate::law::Law;
use crate::parameter::{Fixed, Parameter};
use crate::program::passes::append;
use crate::program::{Input, Limits, Op, Program, Stage, Value};
use crate::request::Spec;

use super::jet::Jets;
use super::mapping::Taylor;
use super::plant::Form;

/// A program under construction.
pub(super) struct Builder<'a> {
    pub(super) spec: &'a Spec,
    /// The closed forms of another engine.
    pub(super) expanded: Option<&'a Expanded>,
    program: Program,
    known: HashMap<Op, Value>,
    pub(super) quantities: BTreeMap<Symbol, Value>,
    /// Values of the symbols of a user-defined mapping.
    pub(super) values: BTreeMap<Symbol, Expression>,
    /// The squares of those that are evaluated by even and odd parts.
    pub(super) squares: BTreeMap<Symbol, Value>,
    /// The Taylor series of mu at the current time and at the start, each up to an order.
    pub(super) taylors: BTreeMap<(usize, bool), Taylor>,
    /// The states xi, at the current time and at the start.
    pub(super) states: [Vec<Value>; 2],
    /// Elapsed time held with the time-to-go, and tau.
    pub(super) elapsed: Option<(Value, Value)>,
    at_start: bool,
    /// tau - mu(t), where time is the stretched one and the time-to-go follows from it.
    complement: Option<Expression>,
    /// The plant, where time is time-to-go or stretched time.
    pub(super) plant: Option<PlantPoint>,
    /// The form of the plant that is computed, where it is not that of the request.
    pub(super) form: Option<Form>,
    /// The chains of a model, where they are expanded by Taylor arithmetic.
    pub(super) jets: Option<Jets>,
    /// True while factors that are numbers join, and signs move into sums: the terms of jets are full of both.
    pub(super) joins: bool,
    /// True if sines and cosines of sums of angles in the equations of motion come by the addition theorem.
    pub(super) splits_angles: bool,
    /// True while these equations are computed so.
    pub(super) splits_sums: bool,
    /// The axis whose values are being named, from 1, where each has its own.
    pub(super) axis: Option<usize>,
    /// Number of outputs of the plant.
    pub(super) outputs: usize,
    /// The output of the highest order, where there are several.
    pub(super) highest: Option<&'a Spec>,
}

/// Point of the plant.
#[derive(Clone, Debug, Default)]
pub(super) struct PlantPoint {
    /// States x_1..x_n; empty while they are computed from those of the infinite-time system.
    pub(super) states: Vec<Value>,
    /// Control u, once it is known.
    pub(super) control: Option<Value>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        let program =
            Program { in_flight: spec.changes_duration(), ..Program::empty(spec.precision) };
        Self {
            spec,
            expanded: None,
            program,
            quantities: BTreeMap::new(),
            values: BTreeMap::new(),
            squares: BTreeMap::new(),
            known: HashMap::new(),
            taylors: BTreeMap::new(),
            states: [Vec::new(), Vec::new()],
            elapsed: None,
            at_start: false,
            complement: None,
            plant: None,
            form: None,
            jets: None,
            joins: false,
            splits_angles: false,
            splits_sums: false,
            axis: None,
            outputs: spec.decoupled().map_or(1, |coupled| coupled.outputs.len()),
            highest: None,
        }
    }

    /// For the controller of `law`, from the closed forms that it is computed from.
    pub(super) fn of(spec: &'a Spec, law: &'a Law) -> Self {
        Self { expanded: law.expanded.as_ref(), ..Self::new(spec) }
    }

    pub(super) fn finish(self, step: Value, limits: Limits) -> Program {
        Program { step, limits, ..self.program }
    }

    /// From here on values are those of one axis, from 1, by its own spec.
    pub(super) fn of_axis(&mut self, spec: &'a Spec, index: usize) {
        (self.spec, self.axis) = (spec, Some(index));
    }

    /// From here on values are those of all axes again.
    pub(super) fn of_all(&mut self, spec: &'a Spec) {
        (self.spec, self.axis) = (spec, None);
    }

    /// The value of an operation: one that stands already where there is one, so that what is asked
    /// for twice is computed once. Looked up, never iterated: the order of the map decides nothing.
    pub(super) fn push(&mut self, op: Op) -> Value {
        if op == Op::Unknown {
            return append(&mut self.program, op, None);
        }
        if let Some(value) = self.known.get(&op) {
            return *value;
        }
        let sum = if self.splits_sums { self.of_angle_sum(&op) } else { None };
        let value = sum.unwrap_or_else(|| append(&mut self.program, op.clone(), None));
        self.known.insert(op, value);
        value
    }

    /// The operation of a value.
    pub(super) fn operation_of(&self, value: Value) -> &Op {
        &self.program.get(value).op
    }

    /// The values needed for `roots`, in order of computation.
    pub(super) fn needed(&self, roots: &[Value]) -> Vec<Value> {
        self.program.needed(roots)
    }

    /// The number that a value is.
    pub(super) fn constant(&self, value: Value) -> Option<&BigRational> {
        match self.operation_of(value) {
            Op::Number(number) => Some(number),
            _ => None,
        }
    }

    /// Returns the result of `compute` at the start, where the time-to-go is tau.
    pub(super) fn at_start<T>(&mut self, compute: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.at_start, true);
        let result = compute(self);
        self.at_start = before;
        result
    }

    /// From here on time is stretched time, and time-to-go is `complement` of it.
    pub(super) fn follow(&mut self, complement: Expression) {
        self.complement = Some(complement);
    }

    /// tau - mu(t), where time is stretched time.
    pub(super) fn followed(&self) -> Option<&Expression> {
        self.complement.as_ref().filter(|_| !self.at_start)
    }

    /// Returns true if time is the time-to-go itself.
    pub(super) fn counts_down(&self) -> bool {
        self.plant.is_some() && self.complement.is_none() && !self.at_start
    }

    /// Returns true if the state is that of the infinite-time system.
    pub(super) fn is_of_infinite_time(&self) -> bool {
        let unknown = |plant: &PlantPoint| plant.states.is_empty();
        self.followed().is_some() || self.counts_down() && self.plant.as_ref().is_some_and(unknown)
    }

    /// Returns true if values at the start are being computed.
    pub(super) fn is_at_start(&self) -> bool {
        self.at_start
    }

    /// Returns true if a value is known no sooner than time.
    pub(super) fn is_of_tick(&self, value: Value) -> bool {
        self.program.get(value).stage >= Stage::Tick
    }

    /// Names a value, with its meaning for the reader of the emitted code. An input has a name of
    /// its own, and values at the start keep theirs apart from those of a tick.
    pub(super) fn name(&mut self, value: Value, name: &str, meaning: &str) -> Value {
        let own =
            self.axis.map(|axis| (format!("{name}_axis{axis}"), format!("{meaning}, axis {axis}")));
        let (name, meaning) = match &own {
            // What several axes share keeps the name that it has.
            Some(_) if self.program.values[value.0].name.is_some() => return value,
            Some((name, meaning)) => (name.as_str(), meaning.as_str()),
            None => (name, meaning),
        };
        let of_tick = self.at_start && !name.ends_with("_0");
        if of_tick || matches!(self.program.values[value.0].op, Op::Input(_)) {
            return value;
        }
        self.program.values[value.0].name = Some((name.to_owned(), meaning.to_owned()));
        value
    }

    pub(super) fn number(&mut self, value: BigRational) -> Value {
        self.push(Op::Number(value))
    }

    pub(super) fn integer(&mut self, value: i64) -> Value {
        self.number(integer(value))
    }

    pub(super) fn add(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Add(a, b))
    }

    pub(super) fn sub(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Sub(a, b))
    }

    pub(super) fn mul(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Mul(a, b))
    }

    pub(super) fn div(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Div(a, b))
    }

    /// a + b, where an absent one adds nothing.
    pub(super) fn sum(&mut self, a: Option<Value>, b: Option<Value>) -> Option<Value> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.add(a, b)),
            (a, b) => a.or(b),
        }
    }

    /// base^exponent for exponent >= 1.
    pub(super) fn power(&mut self, base: Value, exponent: u32) -> Value {
        if exponent == 1 { base } else { self.push(Op::Power(base, exponent)) }
    }

    /// value * variable^exponent for exponent >= 0, the power in two halves: neither half leaves
    /// the range before the result does, whatever `value` makes up for.
    pub(super) fn shift(&mut self, value: Value, variable: Value, exponent: i32) -> Value {
        let exponent = exponent.unsigned_abs();
        let value = if exponent % 2 == 1 { self.mul(value, variable) } else { value };
        if exponent < 2 {
            return value;
        }
        let half = self.power(variable, exponent / 2);
        let value = self.mul(value, half);
        self.mul(value, half)
    }

    /// A parameter: the number it is fixed at, else a run-time input.
    pub(super) fn parameter(&mut self, parameter: Parameter) -> Value {
        match self.spec.fixed.get(&parameter).and_then(Fixed::number) {
            Some(number) => self.number(number.clone()),
            None => self.push(Op::Input(Input::Parameter(parameter))),
        }
    }
}
