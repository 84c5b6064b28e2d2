//! The instructions of a program in lanes, stage by stage.

use super::Register;
use crate::program::arithmetic::Arithmetic;
use crate::program::{Input, Op, Program, Root, Stage, Value};

#[derive(Debug)]
pub(super) struct Tape {
    /// Instructions of each stage, in order of computation.
    pub(super) due: [Vec<Instruction>; 5],
    pub(super) inputs: Vec<(Input, Register)>,
    /// The register of each value that is needed.
    pub(super) places: Vec<usize>,
    /// The stage of each register, and the last one that reads it.
    pub(super) stages: Vec<(Stage, Option<Stage>)>,
    /// Number of reads of each register, by instructions or from outside.
    pub(super) uses: Vec<usize>,
}

#[derive(Debug)]
pub(super) struct Instruction {
    pub(super) to: usize,
    pub(super) work: Work,
}

#[derive(Debug)]
pub(super) enum Work {
    Arithmetic(Arithmetic),
    /// a b + c, a b - c and c - a b of the registers a, b and c, rounded twice: what reads a product is most often the only
    /// one, and an instruction costs more than its arithmetic.
    Plus([usize; 3]),
    Minus([usize; 3]),
    Less([usize; 3]),
    Rows {
        tail: Vec<usize>,
        weights: Vec<usize>,
        fused: bool,
    },
    Element(usize, usize),
    Root(Box<Loop>),
}

/// A [`Root`] with its places, and the values that each round computes.
#[derive(Debug)]
pub(super) struct Loop {
    pub(super) unknown: usize,
    pub(super) start: usize,
    pub(super) low: usize,
    pub(super) high: usize,
    pub(super) residual: usize,
    pub(super) next: usize,
    pub(super) size: usize,
    pub(super) tolerance: usize,
    pub(super) proposals: u32,
    pub(super) rounds: u32,
    pub(super) body: Vec<Instruction>,
}

impl Work {
    /// Returns true for plain arithmetic.
    pub(super) fn is_simple(&self) -> bool {
        matches!(self, Self::Arithmetic(_) | Self::Plus(_) | Self::Minus(_) | Self::Less(_))
    }

    /// A sum with a product in it, where one of its terms is the product of the factors that are found for it.
    fn with_product(&self, product: impl Fn(usize) -> Option<[usize; 2]>) -> Option<(usize, Self)> {
        let both = |term: usize, other: usize| Some((product(term)?, term, other));
        let Self::Arithmetic(arithmetic) = self else { return None };
        match *arithmetic {
            Arithmetic::Add(a, b) => {
                let ([x, y], term, other) = both(b, a).or_else(|| both(a, b))?;
                Some((term, Self::Plus([x, y, other])))
            }
            Arithmetic::Sub(a, b) => match (product(a), product(b)) {
                (_, Some([x, y])) => Some((b, Self::Less([x, y, a]))),
                (Some([x, y]), None) => Some((a, Self::Minus([x, y, b]))),
                (None, None) => None,
            },
            _ => None,
        }
    }
}

/// The same with each product that is read once, by a sum, in that sum.
pub(super) fn with_products(due: Vec<Instruction>, uses: &[usize]) -> Vec<Instruction> {
    let mut products: Vec<Option<[usize; 2]>> = vec![None; uses.len()];
    let mut taken = vec![false; uses.len()];
    let mut all = Vec::with_capacity(due.len());
    for Instruction { to, work } in due {
        let work = match work.with_product(|term| products[term].filter(|_| uses[term] == 1)) {
            Some((term, sum)) => {
                taken[term] = true;
                sum
            }
            None => work,
        };
        if let Work::Arithmetic(Arithmetic::Mul(a, b)) = work {
            products[to] = Some([a, b]);
        }
        all.push(Instruction { to, work });
    }
    all.retain(|own| !taken[own.to]);
    all
}

impl Tape {
    pub(super) fn instruction(&self, program: &Program, value: Value) -> Option<Instruction> {
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
        let body = with_products(body.collect::<Option<_>>()?, &self.uses);
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
