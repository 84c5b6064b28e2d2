//! A program as operations on numbered slots: compiled once, run many times, the same bits each time.
//!
//! What the emitted code computes in `init`, `arm`, `tick` and `step` is run stage by stage, without
//! a search and, except for the loops of arrays, without an allocation.

use std::sync::Arc;

use super::arithmetic::{Arithmetic, way};
use super::elimination::eliminate;
use super::{Input, Op, Program, Root, Stage, Value, number, rows};
use crate::parameter::Precision;

/// The user's own law of xi_1..xi_n and stretched time.
pub type UserLaw<'a> = &'a dyn Fn(&[f64]) -> f64;

/// A program that runs.
#[derive(Clone, Debug)]
pub struct Machine {
    precision: Precision,
    /// The same for all copies.
    plan: Arc<Plan>,
    slots: Slots,
}

/// Steps of the computation, and their order.
#[derive(Clone, Debug)]
struct Plan {
    steps: Vec<Step>,
    /// Values that become known in each stage, in order of computation.
    due: [Vec<usize>; 5],
    /// The values on which the outputs depend, in order.
    deciding: Vec<Value>,
}

/// Present values.
#[derive(Clone, Debug)]
struct Slots {
    numbers: Vec<f64>,
    /// Contents of each value that is an array.
    arrays: Vec<Vec<f64>>,
    arguments: Vec<f64>,
}

/// Computation of one value.
#[derive(Clone, Debug)]
enum Step {
    Arithmetic(Arithmetic),
    /// Set from outside, or by the loop of a root.
    Given(Option<Input>),
    Law(Vec<usize>),
    Rows {
        tail: Vec<usize>,
        weights: Vec<usize>,
        fused: bool,
    },
    Elimination {
        matrix: Vec<usize>,
        right: Vec<usize>,
    },
    Element(usize, usize),
    Root(Root, Vec<usize>),
}

/// Callback that receives the branch taken by an operation with several branches.
pub(super) type Watch<'a> = &'a mut dyn FnMut(Value, &'static str);

impl Machine {
    /// The machine of `program`, which computes `outputs`. Values are NaN until they are computed.
    pub fn new(program: &Program, outputs: &[Value]) -> Self {
        let steps: Vec<_> =
            (0..program.values.len()).map(|i| Step::new(program, Value(i))).collect();
        let mut due: [Vec<usize>; 5] = Default::default();
        for value in program.needed(outputs) {
            let definition = program.get(value);
            if !definition.looped {
                due[definition.stage as usize].push(value.0);
            }
        }
        let count = steps.len();
        let slots = Slots {
            numbers: vec![f64::NAN; count],
            arrays: vec![Vec::new(); count],
            arguments: Vec::new(),
        };
        let plan = Arc::new(Plan { steps, due, deciding: program.deciding(outputs) });
        let mut machine = Self { precision: program.precision, plan, slots };
        for (index, definition) in program.values.iter().enumerate() {
            if definition.stage == Stage::Generation {
                machine.compute(index, None, &mut |_, _| {});
            }
        }
        machine
    }

    /// Returns the slot that holds `input`, if the outputs need it.
    pub fn slot(&self, input: Input) -> Option<Slot> {
        let mut asked = self.plan.due.iter().flatten();
        asked
            .find(|i| matches!(&self.plan.steps[**i], Step::Given(Some(own)) if *own == input))
            .map(|i| Slot(*i))
    }

    /// The inputs that the outputs need.
    pub fn inputs(&self) -> impl Iterator<Item = (Input, Slot)> {
        self.plan.due.iter().flatten().filter_map(|i| match &self.plan.steps[*i] {
            Step::Given(Some(input)) => Some((*input, Slot(*i))),
            _ => None,
        })
    }

    /// Sets an input, in the precision of the program. An unused input has no slot.
    pub fn set(&mut self, slot: Option<Slot>, value: f64) {
        if let Some(Slot(index)) = slot {
            self.slots.numbers[index] = number::settle(value, self.precision);
        }
    }

    /// Computes what the inputs of `stage` decide, those of earlier stages being computed.
    pub fn run(&mut self, stage: Stage, law: Option<UserLaw<'_>>) {
        for index in &self.plan.due[stage as usize] {
            // Nobody watches which way it takes.
            if let Step::Arithmetic(arithmetic) = &self.plan.steps[*index] {
                let numbers = &mut self.slots.numbers;
                numbers[*index] = arithmetic.result(|i| numbers[i], self.precision);
            } else {
                self.slots.compute(&self.plan.steps, *index, self.precision, law, &mut |_, _| {});
            }
        }
    }

    /// The number that `value` has.
    pub fn get(&self, value: Value) -> f64 {
        self.slots.numbers[value.0]
    }

    /// The values that become known in a stage.
    pub(super) fn due(&self, stage: Stage) -> &[usize] {
        &self.plan.due[stage as usize]
    }

    /// Returns true if the outputs depend on a value: see [`Program::deciding`].
    pub(super) fn decides(&self, index: usize) -> bool {
        self.plan.deciding.binary_search(&Value(index)).is_ok()
    }

    /// Returns the arithmetic of a value, where numbers alone decide it.
    pub(super) fn arithmetic(&self, index: usize) -> Option<Arithmetic> {
        match &self.plan.steps[index] {
            Step::Arithmetic(arithmetic) => Some(*arithmetic),
            _ => None,
        }
    }

    /// Computes a value otherwise from here on.
    pub(super) fn replace(&mut self, index: usize, arithmetic: Arithmetic) {
        Arc::make_mut(&mut self.plan).steps[index] = Step::Arithmetic(arithmetic);
    }

    /// Computes one value from its operands.
    pub(super) fn compute(&mut self, index: usize, law: Option<UserLaw<'_>>, watch: Watch<'_>) {
        self.slots.compute(&self.plan.steps, index, self.precision, law, watch);
    }

    /// Sets one value, whatever it is.
    pub(super) fn put(&mut self, index: usize, value: f64) {
        self.slots.numbers[index] = value;
    }
}

/// Slot in which a machine holds an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot(usize);

impl Step {
    fn new(program: &Program, value: Value) -> Self {
        let slots = |values: &[Value]| values.iter().map(|v| v.0).collect::<Vec<_>>();
        match &program.get(value).op {
            Op::Input(input) => Self::Given(Some(*input)),
            Op::Unknown => Self::Given(None),
            Op::Law(arguments) => Self::Law(slots(arguments)),
            Op::Rows { tail, weights, fused } => {
                Self::Rows { tail: slots(tail), weights: slots(weights), fused: *fused }
            }
            Op::Elimination { matrix, right } => {
                Self::Elimination { matrix: slots(matrix), right: slots(right) }
            }
            Op::Element(array, index) => Self::Element(array.0, *index),
            Op::Root(root) => Self::Root(*root, program.body(root).map(|v| v.0).collect()),
            op => {
                let operands = slots(&op.operands());
                let operand = |i: usize| operands.get(i).copied().unwrap_or(value.0);
                let operands = [0, 1, 2].map(operand);
                let arithmetic = Arithmetic::of(op, operands, program.precision);
                arithmetic.map_or(Self::Given(None), Self::Arithmetic)
            }
        }
    }
}

impl Slots {
    fn compute(
        &mut self,
        steps: &[Step],
        index: usize,
        precision: Precision,
        law: Option<UserLaw<'_>>,
        watch: Watch<'_>,
    ) {
        self.numbers[index] = match &steps[index] {
            Step::Arithmetic(arithmetic) => {
                let at = |i: usize| self.numbers[i];
                if let Some(way) = way(arithmetic, at) {
                    watch(Value(index), way);
                }
                arithmetic.result(at, precision)
            }
            Step::Given(_) => return,
            Step::Law(arguments) => {
                self.arguments.clear();
                self.arguments.extend(arguments.iter().map(|i| self.numbers[*i]));
                law.map_or(f64::NAN, |law| law(&self.arguments))
            }
            // An array is no number.
            Step::Rows { tail, weights, fused } => {
                let [tail, weights] = [tail, weights].map(|slots| self.all(slots));
                self.arrays[index] = rows::of_numbers(&tail, &weights, *fused, precision);
                f64::NAN
            }
            Step::Elimination { matrix, right } => {
                let [matrix, right] = [matrix, right].map(|slots| self.all(slots));
                self.arrays[index] = eliminate(&matrix, &right, precision);
                f64::NAN
            }
            Step::Element(array, element) => self.arrays[*array][*element],
            Step::Root(root, body) => self.root(steps, (index, root, body), precision, law, watch),
        };
    }

    fn all(&self, slots: &[usize]) -> Vec<f64> {
        slots.iter().map(|i| self.numbers[*i]).collect()
    }

    fn root(
        &mut self,
        steps: &[Step],
        (index, root, body): (usize, &Root, &[usize]),
        precision: Precision,
        law: Option<UserLaw<'_>>,
        watch: Watch<'_>,
    ) -> f64 {
        let value = Value(index);
        let at = |slots: &Self, value: Value| slots.numbers[value.0];
        let (mut low, mut high, mut y) =
            (at(self, root.low), at(self, root.high), at(self, root.start));
        let mut ended = "exhausted";
        for round in 0..root.rounds {
            self.numbers[root.unknown.0] = y;
            for value in body {
                self.compute(steps, *value, precision, law, watch);
            }
            let right = at(self, root.residual) > 0.0;
            if right {
                low = y;
            } else {
                high = y;
            }
            let next = at(self, root.next);
            let proposal = if next >= low && next <= high {
                "inside"
            } else if next >= low {
                "beyond"
            } else {
                "before"
            };
            watch(value, if right { "right" } else { "left" });
            watch(value, proposal);
            y = if next >= low && next <= high {
                next
            } else {
                number::settle(0.5 * number::settle(low + high, precision), precision)
            };
            if at(self, root.size) <= at(self, root.tolerance) {
                ended = "ended";
                break;
            }
            if round >= root.proposals {
                watch(value, "bisected");
                y = Root::middle(low, high, precision);
            }
        }
        watch(value, ended);
        y
    }
}
