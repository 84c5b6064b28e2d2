//! A program for several sets of inputs at once: each value is a pack of numbers, one for each lane,
//! and each operation is a loop over the lanes.
//!
//! Lanes do not see each other, so that a lane has the bits of a [`Machine`](super::machine::Machine)
//! with its inputs, whatever is in the others.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use std::sync::Arc;

use super::arithmetic::Arithmetic;
use super::rows::rows;
use super::{Input, Op, Program, Root, Stage, Value};
use crate::expression::Function;
use crate::parameter::Precision;

/// Lanes of a pack.
pub const LANES: usize = 8;

/// A number for each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Pack(pub [f64; LANES]);

impl Pack {
    /// The same number in all lanes.
    pub const fn all(value: f64) -> Self {
        Self([value; LANES])
    }

    /// A number for each lane, by a loop, as compilers leave calls in what the library makes arrays with.
    #[inline(always)]
    pub fn of(mut number: impl FnMut(usize) -> f64) -> Self {
        let mut all = [0.0; LANES];
        for lane in 0..LANES {
            all[lane] = number(lane);
        }
        Self(all)
    }

    /// A function of each number.
    #[inline(always)]
    #[must_use]
    pub fn map(&self, mut function: impl FnMut(f64) -> f64) -> Self {
        Self::of(|lane| function(self.0[lane]))
    }

    /// Takes some lanes of another pack.
    #[inline]
    pub fn take(&mut self, from: &Self, lanes: &[bool; LANES]) {
        for lane in 0..LANES {
            self.0[lane] = if lanes[lane] { from.0[lane] } else { self.0[lane] };
        }
    }
}

/// A program in lanes. Only programs in f64 without a user's law run in them.
#[derive(Clone, Debug)]
pub struct Lanes {
    tape: Arc<Tape>,
    registers: Vec<Pack>,
    arrays: Vec<Vec<Pack>>,
}

/// Where a program in lanes holds an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Register(usize);

#[derive(Debug)]
struct Tape {
    /// Of each stage, in order of computation.
    due: [Vec<Instruction>; 5],
    inputs: Vec<(Input, Register)>,
    /// The register of each value that is needed.
    places: Vec<usize>,
    /// The stage of each register, and the last one that reads it.
    stages: Vec<(Stage, Option<Stage>)>,
}

#[derive(Debug)]
struct Instruction {
    to: usize,
    work: Work,
}

#[derive(Debug)]
enum Work {
    Arithmetic(Arithmetic),
    Rows { tail: Vec<usize>, weights: Vec<usize>, fused: bool },
    Element(usize, usize),
    Root(Box<Loop>),
}

/// A [`Root`] with its places, and the values that each round computes.
#[derive(Debug)]
struct Loop {
    unknown: usize,
    start: usize,
    low: usize,
    high: usize,
    residual: usize,
    next: usize,
    size: usize,
    tolerance: usize,
    proposals: u32,
    rounds: u32,
    body: Vec<Instruction>,
}

impl Lanes {
    /// `program`, of which `outputs` are looked at; `None` where it does not run in lanes.
    pub fn new(program: &Program, outputs: &[Value]) -> Option<Self> {
        if program.precision != Precision::F64 {
            return None;
        }
        let needed = program.needed(outputs);
        let mut places = vec![usize::MAX; program.values.len()];
        for (place, value) in needed.iter().enumerate() {
            places[value.0] = place;
        }
        let mut stages: Vec<_> =
            needed.iter().map(|value| (program.get(*value).stage, None)).collect();
        for value in &needed {
            let definition = program.get(*value);
            // What a loop repeats may run later than its operands are known.
            let reader = if definition.looped { Stage::Step } else { definition.stage };
            definition.op.each_operand(|operand| {
                let (_, last) = &mut stages[places[operand.0]];
                *last = (*last).max(Some(reader));
            });
        }
        let mut tape = Tape { due: Default::default(), inputs: Vec::new(), places, stages };
        for value in &needed {
            let definition = program.get(*value);
            match &definition.op {
                _ if definition.looped => {}
                Op::Input(input) => {
                    tape.inputs.push((*input, Register(tape.places[value.0])));
                }
                _ => {
                    let instruction = tape.instruction(program, *value)?;
                    tape.due[definition.stage as usize].push(instruction);
                }
            }
        }
        let count = needed.len();
        let mut lanes = Self {
            tape: Arc::new(tape),
            registers: vec![Pack::all(f64::NAN); count],
            arrays: vec![Vec::new(); count],
        };
        lanes.run(Stage::Generation);
        Some(lanes)
    }

    /// Where `input` is held, if the outputs need it.
    pub fn register(&self, input: Input) -> Option<Register> {
        self.inputs().find(|(own, _)| *own == input).map(|(_, register)| register)
    }

    /// The inputs that the outputs need.
    pub fn inputs(&self) -> impl Iterator<Item = (Input, Register)> {
        self.tape.inputs.iter().copied()
    }

    /// Sets an input of one lane.
    pub fn set(&mut self, register: Register, lane: usize, value: f64) {
        self.registers[register.0].0[lane] = value;
    }

    /// Sets an input of all lanes. An unused input has no register.
    #[inline]
    pub fn fill(&mut self, register: Option<Register>, values: &Pack) {
        if let Some(Register(place)) = register {
            self.registers[place] = *values;
        }
    }

    /// Computes what the inputs of `stage` decide, those of earlier stages being computed.
    #[inline]
    pub fn run(&mut self, stage: Stage) {
        let Self { tape, registers, arrays } = self;
        perform(&tape.due[stage as usize], registers, arrays);
    }

    /// The registers that are known before `stage`.
    pub fn before(&self, stage: Stage) -> impl Iterator<Item = Register> {
        let stages = &self.tape.stages;
        (0..stages.len()).filter(move |place| stages[*place].0 < stage).map(Register)
    }

    /// The registers of `stage` that later ones or `outputs` read; `None` where arrays or loops are among its work.
    pub fn read_after(&self, stage: Stage, outputs: &[Value]) -> Option<Vec<Register>> {
        let Tape { due, stages, places, .. } = &*self.tape;
        let simple = |own: &Instruction| matches!(own.work, Work::Arithmetic(_));
        if !due[stage as usize].iter().all(simple) {
            return None;
        }
        let own = |place: &usize| {
            let (own, last) = stages[*place];
            let is_output = || outputs.iter().any(|value| places[value.0] == *place);
            own == stage && (last > Some(stage) || is_output())
        };
        Some((0..stages.len()).filter(own).map(Register).collect())
    }

    /// The numbers of a register.
    pub fn at(&self, Register(place): Register) -> &Pack {
        &self.registers[place]
    }

    /// The numbers that `value` has.
    #[inline]
    pub fn get(&self, value: Value) -> &Pack {
        &self.registers[self.tape.places[value.0]]
    }
}

impl Tape {
    fn instruction(&self, program: &Program, value: Value) -> Option<Instruction> {
        let place = |value: &Value| self.places[value.0];
        let all = |values: &[Value]| values.iter().map(place).collect::<Vec<_>>();
        let work = match &program.get(value).op {
            Op::Rows { tail, weights, fused } => {
                Work::Rows { tail: all(tail), weights: all(weights), fused: *fused }
            }
            Op::Element(array, index) => Work::Element(place(array), *index),
            Op::Root(root) => Work::Root(Box::new(self.of_root(program, root)?)),
            op => {
                let operands = all(&op.operands());
                let operand = |i: usize| operands.get(i).copied().unwrap_or(0);
                let operands = [0, 1, 2].map(operand);
                Work::Arithmetic(Arithmetic::of(op, operands, program.precision)?)
            }
        };
        Some(Instruction { to: self.places[value.0], work })
    }

    fn of_root(&self, program: &Program, root: &Root) -> Option<Loop> {
        let body = program.body(root).map(|value| self.instruction(program, value));
        let [unknown, start, low, high, residual, next, size, tolerance] =
            root.operands().map(|value| self.places[value.0]);
        let body = body.collect::<Option<_>>()?;
        let Root { proposals, rounds, .. } = *root;
        Some(Loop {
            unknown,
            start,
            low,
            high,
            residual,
            next,
            size,
            tolerance,
            proposals,
            rounds,
            body,
        })
    }
}

fn perform(due: &[Instruction], registers: &mut [Pack], arrays: &mut [Vec<Pack>]) {
    for Instruction { to, work } in due {
        let to = *to;
        match work {
            Work::Arithmetic(operation) => apply(operation, registers, to),
            Work::Rows { tail, weights, fused } => {
                let [tail, weights] = [tail, weights]
                    .map(|places| places.iter().map(|p| registers[*p]).collect::<Vec<_>>());
                let more = |a: Pack, b: Pack, c: Pack| match fused {
                    true => Pack::of(|lane| a.0[lane].mul_add(b.0[lane], c.0[lane])),
                    false => two(&c, &two(&a, &b, mul), add),
                };
                arrays[to] = rows(&tail, &weights, |a, b| two(&a, &b, add), more);
                // An array is no number.
                registers[to] = Pack::all(f64::NAN);
            }
            Work::Element(array, element) => registers[to] = arrays[*array][*element],
            Work::Root(root) => registers[to] = solve(root, registers, arrays),
        }
    }
}

#[inline(always)]
fn two(a: &Pack, b: &Pack, f: impl Fn(f64, f64) -> f64) -> Pack {
    let mut out = Pack::all(0.0);
    for lane in 0..LANES {
        out.0[lane] = f(a.0[lane], b.0[lane]);
    }
    out
}

fn add(a: f64, b: f64) -> f64 {
    a + b
}

fn mul(a: f64, b: f64) -> f64 {
    a * b
}

/// An operation in each lane; those that are loops of a compiler's vectors are written out. Each writes its
/// own result: one that all hand over would be copied once more.
#[inline]
fn apply(operation: &Arithmetic, registers: &mut [Pack], to: usize) {
    let at = |place: usize| &registers[place];
    match *operation {
        Arithmetic::Number(value) => registers[to] = Pack::all(value),
        Arithmetic::Neg(a) => registers[to] = two(at(a), at(a), |a, _| -a),
        Arithmetic::Add(a, b) => registers[to] = two(at(a), at(b), add),
        Arithmetic::Sub(a, b) => registers[to] = two(at(a), at(b), |a, b| a - b),
        Arithmetic::Mul(a, b) => registers[to] = two(at(a), at(b), mul),
        Arithmetic::Div(a, b) => registers[to] = two(at(a), at(b), |a, b| a / b),
        Arithmetic::Max(a, b) => {
            registers[to] = two(at(a), at(b), |a, b| if a < b { b } else { a });
        }
        Arithmetic::Min(a, b) => {
            registers[to] = two(at(a), at(b), |a, b| if a < b { a } else { b });
        }
        Arithmetic::Call(Function::Sqrt, a) => registers[to] = two(at(a), at(a), |a, _| a.sqrt()),
        Arithmetic::Copy(a) => registers[to] = *at(a),
        operation => {
            let result = |lane: usize| operation.result(|place| at(place).0[lane], Precision::F64);
            registers[to] = Pack::of(result);
        }
    }
}

/// The rounds that the slowest lane takes; one whose step is small enough keeps its root meanwhile.
fn solve(root: &Loop, registers: &mut [Pack], arrays: &mut [Vec<Pack>]) -> Pack {
    let [mut y, mut low, mut high] =
        [root.start, root.low, root.high].map(|place| registers[place]);
    let tolerance = registers[root.tolerance];
    let mut done = [false; LANES];
    for round in 0..root.rounds {
        registers[root.unknown] = y;
        perform(&root.body, registers, arrays);
        for lane in 0..LANES {
            if done[lane] {
                continue;
            }
            let at = |place: usize| registers[place].0[lane];
            let bound = if at(root.residual) > 0.0 { &mut low } else { &mut high };
            bound.0[lane] = y.0[lane];
            let (low, high, next) = (low.0[lane], high.0[lane], at(root.next));
            let inside = next >= low && next <= high;
            y.0[lane] = if inside { next } else { 0.5 * (low + high) };
            done[lane] = at(root.size) <= tolerance.0[lane];
            if !done[lane] && round >= root.proposals {
                y.0[lane] = Root::middle(low, high, Precision::F64);
            }
        }
        if done.iter().all(|done| *done) {
            break;
        }
    }
    y
}
