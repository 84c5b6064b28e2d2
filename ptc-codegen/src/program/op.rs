//! The operations of a program.

use std::hash::{Hash, Hasher};

use super::{Input, Value, number};
use crate::algebra::BigRational;
use crate::expression::Function;
use crate::parameter::Precision;

/// A bracketed iteration for the root y of a decreasing residual: from `start`, each round takes
/// the root to lie right of y where `residual > 0`, steps to `next`, falls back to the middle of
/// the bracket when `next` leaves it, and ends once the step's `size` is at most `tolerance`. After
/// `proposals` rounds it takes the geometric middle of the bracket, [`middle`](Root::middle), which
/// reaches every root within its range: nothing is known of how fast a residual brings `next` there.
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
    /// Rounds in which `next` counts.
    pub proposals: u32,
    /// Bound on the number of rounds.
    pub rounds: u32,
}

impl Root {
    /// Lower and upper bound of the roots but 0 that bisection reaches.
    pub fn range(precision: Precision) -> [f64; 2] {
        match precision {
            Precision::F64 => [1e-300, 1e300],
            Precision::F32 => [1e-37_f32, 1e37].map(f64::from),
        }
    }

    /// Rounds of bisection from that range to neighbouring numbers: 2 ln 10^300 2^-60 = 1.2e-15, and
    /// 2 ln 10^37 2^-32 = 4e-8.
    pub fn bisections(precision: Precision) -> u32 {
        match precision {
            Precision::F64 => 60,
            Precision::F32 => 32,
        }
    }

    /// sqrt(low + lower) sqrt(high), each operation rounded, with the lower bound of [`Root::range`], which
    /// changes no other low than 0.
    pub fn middle(low: f64, high: f64, precision: Precision) -> f64 {
        let [lower, _] = Self::range(precision);
        let settle = |value| number::settle(value, precision);
        settle(settle(settle(low + lower).sqrt()) * settle(high.sqrt()))
    }

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
    /// a * b + c, rounded once: what the pass `fuse` makes of a product and a sum.
    Fused(Value, Value, Value),
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
    /// The user's own law pi0: its arguments are xi_1..xi_n and stretched time. That of one output of several
    /// has the xi of all, kappa' behind time, and its place among the outputs, from 0, at the end.
    Law(Vec<Value>),
    /// An array by loops: with p(z) = z + sum_d tail_d z^(d+2) and one weight more than the tail has
    /// coefficients, element j is sum_i weights_i \[z^(i+1)\] p^(j+1), as [`rows`](super::rows::rows) gives it.
    Rows {
        /// Coefficients of z^2, z^3, ...
        tail: Vec<Value>,
        /// Weights of z, z^2, ...
        weights: Vec<Value>,
        /// True if each product and its sum are rounded once.
        fused: bool,
    },
    /// An array by loops: the solution of a x = b and behind it det a, as
    /// [`eliminate`](super::elimination::eliminate) gives them.
    Elimination {
        /// a, row by row.
        matrix: Vec<Value>,
        /// b.
        right: Vec<Value>,
    },
    /// An element of an array, from 0.
    Element(Value, usize),
    /// The unknown of a [`Root`].
    Unknown,
    /// The root.
    Root(Root),
}

/// Written by hand, because a ratio hashes its continued fraction, which takes longer than all the rest.
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
    pub(super) fn each_operand(&self, mut give: impl FnMut(Value)) {
        match self {
            Self::Number(_) | Self::Input(_) | Self::Unknown => {}
            Self::Neg(a) | Self::Power(a, _) | Self::Call(_, a) | Self::Element(a, _) => give(*a),
            Self::Law(arguments) => arguments.iter().copied().for_each(give),
            Self::Rows { tail, weights, .. } => tail.iter().chain(weights).copied().for_each(give),
            Self::Elimination { matrix, right } => {
                matrix.iter().chain(right).copied().for_each(give);
            }
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Quotient(a, b)
            | Self::Max(a, b)
            | Self::Min(a, b)
            | Self::Pow(a, b) => [*a, *b].into_iter().for_each(give),
            Self::Fused(a, b, c) => [*a, *b, *c].into_iter().for_each(give),
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
            Self::Rows { tail, weights, fused } => Self::Rows {
                tail: tail.iter().map(|v| to(*v)).collect(),
                weights: weights.iter().map(|v| to(*v)).collect(),
                fused: *fused,
            },
            Self::Elimination { matrix, right } => Self::Elimination {
                matrix: matrix.iter().map(|v| to(*v)).collect(),
                right: right.iter().map(|v| to(*v)).collect(),
            },
            Self::Add(a, b) => Self::Add(to(*a), to(*b)),
            Self::Sub(a, b) => Self::Sub(to(*a), to(*b)),
            Self::Mul(a, b) => Self::Mul(to(*a), to(*b)),
            Self::Fused(a, b, c) => Self::Fused(to(*a), to(*b), to(*c)),
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
                proposals: r.proposals,
                rounds: r.rounds,
            }),
        }
    }
}
