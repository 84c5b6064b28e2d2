//! A plant that is linear while its input is held: from sample to sample by the matrix exponential.
//!
//! x' = A x + v with a constant v = B u + c has x(s) = E x + F v, E = exp(A s) and F the integral of E.
//! Both are summed for a part of s in which ||A s|| is small, and doubled: F(2 s) = (I + E) F, E(2 s) = E E.

use super::Along;
use super::linear::SAME;
use super::solver::State;
use crate::program::{Input, Op, Program, Stage, Value};

/// A matrix, by rows.
type Rows = Vec<Vec<f64>>;

/// The rates x' = A x + B u + c with what they come to over some lengths of time.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    /// A, and the columns of B behind it.
    rates: Rows,
    /// c.
    constant: Vec<f64>,
    /// Lengths in s, each with E and F.
    over: Vec<(f64, Rows, Rows)>,
}

/// Lengths that are kept: a sample, its parts and those beside a delay.
const KEPT: usize = 8;

/// ||A s|| from which the series needs no more than [`TERMS`] for all digits.
const SMALL: f64 = 0.5;
const TERMS: u32 = 18;

/// Doublings above which the sum has lost too many digits.
const DOUBLINGS: i32 = 20;

/// By this much a state is moved, 2^60, so that c takes no digit from the slope.
const MOVED: f64 = 1_152_921_504_606_846_976.0;

impl Held {
    /// `None` where a rate of the plant is not linear in state and inputs, or goes with time.
    pub(super) fn of(program: &Program, rates: &[Value]) -> Option<Self> {
        let linear = linear(program);
        rates.iter().all(|rate| linear[rate.0] != Form::Other).then(Self::default)
    }

    /// Takes the numbers of a plant with so many `inputs`.
    pub(super) fn settle(&mut self, along: &mut Along, rates: &[Value], inputs: usize) {
        let mut point = vec![0.0; rates.len() + inputs];
        let mut at = |point: &[f64]| -> Vec<f64> {
            let (x, u) = point.split_at(rates.len());
            along.at(0.0, x, u);
            rates.iter().map(|rate| along.machine.get(*rate)).collect()
        };
        self.constant = at(&point);
        self.rates = vec![vec![0.0; point.len()]; rates.len()];
        for column in 0..point.len() {
            point[column] = MOVED;
            for ((row, moved), own) in self.rates.iter_mut().zip(at(&point)).zip(&self.constant) {
                row[column] = (moved - own) / MOVED;
            }
            point[column] = 0.0;
        }
        self.over.clear();
    }

    /// The state after `length` s under u; `None` where the exponential is beyond its numbers.
    pub(super) fn after(&mut self, x: &State, u: &[f64], length: f64) -> Option<State> {
        let near = |own: f64| (own - length).abs() <= SAME * length;
        let known = self.over.iter().position(|(own, _, _)| near(*own));
        let place = match known {
            Some(place) => place,
            None => {
                let (whole, integral) = self.flow(length)?;
                if self.over.len() == KEPT {
                    self.over.clear();
                }
                self.over.push((length, whole, integral));
                self.over.len() - 1
            }
        };
        let (_, whole, integral) = &self.over[place];
        let n = self.rates.len();
        let dot = |row: &[f64], v: &[f64]| row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>();
        let mut pushed = State::zeros();
        for ((pushed, row), own) in pushed.iter_mut().zip(&self.rates).zip(&self.constant) {
            *pushed = own + dot(&row[n..], u);
        }
        let mut next = State::zeros();
        for ((next, row), of_input) in next.iter_mut().zip(whole).zip(integral) {
            *next = dot(row, x.as_slice()) + dot(of_input, pushed.as_slice());
        }
        Some(next)
    }

    /// E and F over a length.
    fn flow(&self, length: f64) -> Option<(Rows, Rows)> {
        let n = self.rates.len();
        let norm = |row: &Vec<f64>| row[..n].iter().map(|a| a.abs()).sum::<f64>();
        let norm = self.rates.iter().map(norm).fold(0.0, f64::max) * length;
        let doublings = (0..=DOUBLINGS).find(|k| norm * 0.5_f64.powi(*k) <= SMALL)?;
        let part = length * 0.5_f64.powi(doublings);
        let identity = |factor: f64| -> Rows {
            (0..n).map(|i| (0..n).map(|j| if i == j { factor } else { 0.0 }).collect()).collect()
        };
        // F = s (I + A s/2 (I + A s/3 (...))).
        let mut sum = identity(1.0);
        for term in (2..=TERMS).rev() {
            sum = self.times(&sum, part / f64::from(term));
            sum.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
        }
        let mut whole = self.times(&sum, part);
        let mut integral = sum;
        integral.iter_mut().flatten().for_each(|value| *value *= part);
        whole.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
        for _ in 0..doublings {
            let more = product(&whole, &integral);
            integral
                .iter_mut()
                .flatten()
                .zip(more.into_iter().flatten())
                .for_each(|(a, b)| *a += b);
            whole = product(&whole, &whole);
        }
        Some((whole, integral))
    }

    /// A times a matrix and a factor.
    fn times(&self, matrix: &Rows, factor: f64) -> Rows {
        let mut product = product(&self.rates, matrix);
        product.iter_mut().flatten().for_each(|value| *value *= factor);
        product
    }
}

/// The product with a matrix; columns of the left one beyond its rows do not count.
fn product(left: &Rows, right: &Rows) -> Rows {
    let column = |row: &Vec<f64>, j: usize| row.iter().zip(right).map(|(a, b)| a * b[j]).sum();
    left.iter().map(|row| (0..right.len()).map(|j| column(row, j)).collect()).collect()
}

/// How a value depends on state and inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Form {
    Constant,
    Linear,
    Other,
}

/// The form of each value of a plant.
fn linear(program: &Program) -> Vec<Form> {
    let mut forms: Vec<Form> = Vec::with_capacity(program.values.len());
    for definition in &program.values {
        let of = |value: Value| forms[value.0];
        let product =
            |a: Form, b: Form| if a.min(b) == Form::Constant { a.max(b) } else { Form::Other };
        let form = match definition.op {
            _ if definition.stage <= Stage::Arm => Form::Constant,
            Op::Input(Input::State(_) | Input::Control) => Form::Linear,
            Op::Neg(a) => of(a),
            Op::Add(a, b) | Op::Sub(a, b) => of(a).max(of(b)),
            Op::Mul(a, b) => product(of(a), of(b)),
            Op::Fused(a, b, c) => product(of(a), of(b)).max(of(c)),
            Op::Div(a, b) if of(b) == Form::Constant => of(a),
            _ => Form::Other,
        };
        forms.push(form);
    }
    forms
}
