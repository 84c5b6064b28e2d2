//! One sample of the loop that runs: the chain under a zero-order hold, the gains and the delay.
//!
//! The state is s = (x_1, ..., x_n, w_1, ..., w_d): the plant's and the inputs that are on their way,
//! the next one first; a controller in samples adds the states that it keeps. s_{k+1} = M_k s_k +
//! sum_l b_{l,k} w_l, w the errors of the measurement and of the actuator.

mod matrix;
mod rows;

pub(super) use matrix::Matrix;
pub(super) use rows::{Layout, Rows, Steps};

use super::rounded::{Rounded, unit_roundoff};
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::linear::{Delay, Linear, ZeroOrderHold, zero_order_hold};
use crate::parameter::Precision;

/// The feedback of one sample: u = sum_j gain_j x_j, with bounds of the distance of each gain from
/// what acts, rounding included.
#[derive(Clone, Debug)]
pub(super) struct Gains {
    pub(super) values: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

impl Gains {
    /// The gains that the emitted program acts with.
    pub(super) fn new(rounded: &[Rounded]) -> Self {
        let (values, errors) = rounded.iter().map(|gain| centre(gain.exact, gain.error)).unzip();
        Self { values, errors }
    }
}

/// A number in a range, and a bound of its distance from what is within `error` of the range.
pub(super) fn centre(range: Range, error: f64) -> Near {
    let middle = 0.5 * (range.low() + range.high());
    let radius = (range - Range::from(middle)).size().high();
    (middle, (radius + error).next_up())
}

/// A number and a bound of its distance from the true one.
pub(super) type Near = (f64, f64);

/// The sum of a row over a column, by index as the product of a row and a matrix in `worst`.
#[allow(clippy::needless_range_loop)]
pub(super) fn along(row: &[f64], column: &[Near]) -> f64 {
    let (length, mut sum) = (row.len().min(column.len()), 0.0);
    let (row, column) = (&row[..length], &column[..length]);
    for i in 0..length {
        sum += row[i] * column[i].0;
    }
    sum
}

/// A value as a sum over the states and the causes: the errors of each measured state, then that of
/// the actuator.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) of_state: Vec<Near>,
    pub(super) of_cause: Vec<Near>,
}

/// One sample of a loop: s_{k+1} = M s_k + sum_l column_l w_l, and u_k.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) matrix: Matrix,
    pub(super) columns: Vec<Vec<Near>>,
    pub(super) u: Row,
    /// Upper bound of the rounding error of a reference outside the states, in each state and in u.
    pub(super) lost: Vec<Near>,
    pub(super) lost_of_u: f64,
    /// Innovation of each measurement in an observer, and the rounding error of a reference in it; empty without an
    /// observer that can predict alone.
    pub(super) innovations: Vec<(Row, f64)>,
    /// Contribution of a constant f of 1 to each state over the joined samples; `None` for one sample.
    pub(super) force: Option<Vec<Near>>,
}

/// The unit of a state relative to u, in which all states have the same scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unit {
    /// A power of the time scale of the gains.
    Power(i32),
    /// The gains of state x_j and of its estimate.
    Gain(usize),
}

/// A plant, sampled with a period: the chain x_i' = x_{i+1}, x_n' = g u, or any other.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) n: usize,
    /// The first of them, those of the plant; the input that acted last may be one more.
    pub(super) moved: usize,
    /// Inputs under way.
    pub(super) delay: usize,
    /// Phi with its errors, n by n.
    pub(super) motion: Matrix,
    /// Gamma with its errors.
    pub(super) input: Vec<(f64, f64)>,
    /// h^j/j!, j = 0..=n, rounded.
    pub(super) shares: Vec<f64>,
    pub(super) gain: f64,
    /// Response of the states to an input of 1 over a whole sample, with its errors.
    pub(super) whole: Vec<Near>,
    /// The rows of y = C x; `None` if the states of a chain are measured.
    pub(super) outputs: Option<Vec<Vec<Near>>>,
}

impl Chain {
    /// The chain of order `n` with period `h`, an input gain of 1 and `delay` samples.
    pub(super) fn new(n: usize, h: Range, delay: usize) -> Self {
        let mut shares = vec![Range::from(1.0)];
        for j in 1..=n {
            #[allow(clippy::cast_precision_loss)]
            shares.push(shares[j - 1] * h / Range::from(j as f64));
        }
        let mut motion = Matrix { size: n, entries: vec![0.0; n * n], errors: vec![0.0; n * n] };
        for i in 0..n {
            for j in i..n {
                let (value, error) = if i == j { (1.0, 0.0) } else { centre(shares[j - i], 0.0) };
                (motion.entries[i * n + j], motion.errors[i * n + j]) = (value, error);
            }
        }
        let input: Vec<_> = (0..n).map(|i| centre(shares[n - i], 0.0)).collect();
        let shares = shares.iter().map(|share| centre(*share, 0.0).0).collect();
        let whole = input.clone();
        Self { n, moved: n, delay, motion, input, shares, gain: 1.0, whole, outputs: None }
    }

    /// A linear plant with period `h`; `None` if a mode is too fast for it. Where inputs take over
    /// within a sample, the one that acted last is its last state, as it acted.
    pub(super) fn linear(plant: &Linear, h: &BigRational, delay: &Delay) -> Option<Self> {
        let ZeroOrderHold { mut phi, older, newer } = zero_order_hold(plant, h, delay)?;
        let near = |value: &BigRational| centre(Range::from(&Interval::exact(value)), 0.0);
        let (moved, zero) = (older.len(), BigRational::default());
        let mut whole: Vec<_> = older.iter().zip(&newer).map(|(a, b)| near(&(a + b))).collect();
        let (mut input, mut under_way) = (whole.clone(), delay.inputs());
        if !delay.is_whole() {
            phi.iter_mut().zip(&older).for_each(|(row, older)| row.push(older.clone()));
            phi.push(vec![zero.clone(); moved + 1]);
            input = newer.iter().map(near).chain([(1.0, 0.0)]).collect();
            whole.push((0.0, 0.0));
            under_way -= 1;
        }
        let n = phi.len();
        let (entries, errors) = phi.iter().flatten().map(near).unzip();
        let row = |row: &Vec<BigRational>| {
            let all = row.iter().chain(std::iter::repeat(&zero)).take(n);
            all.map(near).collect()
        };
        Some(Self {
            n,
            moved,
            delay: under_way,
            motion: Matrix { size: n, entries, errors },
            input,
            shares: vec![1.0, near(h).0],
            gain: 1.0,
            whole,
            outputs: Some(plant.c.iter().map(row).collect()),
        })
    }

    /// The plant of gain 1 with an input gain.
    pub(super) fn with_gain(&self, g: Range) -> Self {
        let gained = |(value, error): &Near| {
            let (gained, own) = centre(g * Range::from(*value), 0.0);
            (gained, (own + error * g.size().high()).next_up().next_up())
        };
        let input = self.input.iter().map(gained).collect();
        Self { input, gain: self.gain * g.middle(), ..self.clone() }
    }

    /// The unit of x_j, from 1.
    pub(super) fn unit(&self, j: usize) -> Unit {
        match self.outputs {
            Some(_) if j > self.moved => Unit::Power(0),
            Some(_) => Unit::Gain(j),
            None => Unit::Power(i32::try_from(self.n + 1 - j).unwrap_or(i32::MAX)),
        }
    }

    /// Number of values that are measured with an error of their own.
    pub(super) fn sensors(&self) -> usize {
        self.outputs.as_ref().map_or(self.n, Vec::len)
    }

    /// Converts a sum over the measured values, with coefficients `near`, to one over the states.
    pub(super) fn of_states(&self, near: &[Near]) -> Vec<Near> {
        let Some(rows) = &self.outputs else {
            let one = |j: usize| near.get(j).copied().unwrap_or((0.0, 0.0));
            return (0..self.n).map(one).collect();
        };
        let unit = 4.0 * unit_roundoff(Precision::F64);
        let state = |j: usize| {
            near.iter().zip(rows).fold((0.0, 0.0), |(sum, off): Near, ((value, error), row)| {
                let (c, inexact) = row[j];
                let part = value * c;
                let off = off + error * (c.abs() + inexact) + value.abs() * inexact;
                (sum + part, (off + unit * (sum.abs() + part.abs())) * (1.0 + unit))
            })
        };
        (0..self.n).map(state).collect()
    }

    /// Length of the state with the inputs that are on their way.
    pub(super) fn size(&self) -> usize {
        self.n + self.delay
    }

    /// The sample at which the gains act on what is measured.
    pub(super) fn closed(&self, gains: &Gains) -> Rows {
        let size = self.size();
        let row = |j: usize| match j < self.n {
            true => (gains.values[j], gains.errors[j]),
            false => (0.0, 0.0),
        };
        let row: Vec<_> = (0..size).map(row).collect();
        let mut rows: Vec<Row> = (self.n..size)
            .map(|i| {
                let next = |j: usize| (f64::from(u8::from(j == i + 1)), 0.0);
                Row {
                    of_state: (0..size).map(next).collect(),
                    of_cause: vec![(0.0, 0.0); self.n + 1],
                }
            })
            .collect();
        let mut direct: Vec<_> = row[..self.n].to_vec();
        direct.push((1.0, 0.0));
        let u = Row { of_state: row, of_cause: direct };
        if let Some(last) = rows.last_mut() {
            *last = u.clone();
        }
        Rows::new(&u, &rows, &[])
    }

    /// The layout of [`closed`](Self::closed).
    pub(super) fn layout(&self) -> Layout {
        let acting = (self.delay > 0).then_some(self.n);
        Layout { size: self.size(), causes: self.n + 1, innovations: 0, acting }
    }
}
