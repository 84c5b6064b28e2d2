//! The loop that a table of gains closes.

use num_traits::ToPrimitive;

use super::Row;
use crate::algebra::BigRational;
use crate::linear::horizon::Signal;
use crate::linear::horizon::span::times;
use crate::linear::{Matrix, Schedule};
use crate::parameter::Precision;

/// x -> A x by the samples to go, and the rows that give its signals.
pub(super) struct Closed {
    phi: Vec<Row>,
    gamma: Row,
    /// -K of each node of the table, as it is emitted.
    gains: Vec<Row>,
    /// For each number of samples to go that the table knows, its row and the part of the way to the next one.
    places: Vec<(usize, f64)>,
    /// Samples to go at and below which the gains stay.
    pub(super) rest: u32,
    /// The unit of each state, so that numbers of the same size stand side by side.
    pub(super) units: Row,
}

/// The signals from one number of samples to go on.
#[derive(Clone, Debug)]
pub(super) struct Future {
    /// Rows that bound the signal once the gains are held.
    pub(super) held: Vec<Row>,
    /// The signal with `first`, `first` + 1, ... samples to go, until now.
    pub(super) rows: Vec<Row>,
}

impl Closed {
    /// The loop of a plant with a schedule, whose gains are held from `held` samples to go on; `None` if a number is not
    /// finite.
    pub(super) fn new(
        (phi, gamma): (&Matrix, &[BigRational]),
        schedule: &Schedule,
        held: u32,
        precision: Precision,
    ) -> Option<Self> {
        let row =
            |all: &[BigRational]| all.iter().map(ToPrimitive::to_f64).collect::<Option<Row>>();
        let emitted = |all: &Vec<BigRational>| -> Option<Row> {
            Some(row(all)?.into_iter().map(|gain| -precision.rounded(gain)).collect())
        };
        let longest = schedule.samples;
        let rest = schedule.least().max(held);
        let mut closed = Self {
            phi: phi.rows().iter().map(|own| row(own)).collect::<Option<_>>()?,
            gamma: row(gamma)?,
            gains: schedule.gains.iter().map(emitted).collect::<Option<_>>()?,
            places: (0..=longest).map(|left| schedule.place(left.max(rest))).collect(),
            rest,
            units: Vec::new(),
        };
        closed.units = vec![1.0; closed.order()];
        closed.scale();
        Some(closed)
    }

    pub(super) fn order(&self) -> usize {
        self.gamma.len()
    }

    /// Counts each state in units in which the largest gain of the held loop is 1.
    fn scale(&mut self) {
        let n = self.order();
        let mut row = self.gain(self.rest);
        let mut units = vec![0.0_f64; n];
        for _ in 0..n {
            units.iter_mut().zip(&row).for_each(|(own, value)| *own = own.max(value.abs()));
            row = times(&row, &self.step(self.rest));
        }
        units.iter_mut().filter(|own| **own == 0.0).for_each(|own| *own = 1.0);
        for i in 0..n {
            self.gamma[i] *= units[i];
            for j in 0..n {
                self.phi[i][j] *= units[i] / units[j];
            }
        }
        for row in &mut self.gains {
            row.iter_mut().zip(&units).for_each(|(own, unit)| *own /= unit);
        }
        self.units = units;
    }

    /// The row that gives u.
    pub(super) fn gain(&self, left: u32) -> Row {
        let (row, part) = self.places[left as usize];
        let [a, b] = [&self.gains[row], &self.gains[row + 1]];
        a.iter().zip(b).map(|(a, b)| a + part * (b - a)).collect()
    }

    /// A, with so many samples to go.
    pub(super) fn step(&self, left: u32) -> Vec<Row> {
        let gain = self.gain(left);
        let row = |(own, gamma): (&Row, &f64)| {
            own.iter().zip(&gain).map(|(phi, gain)| phi + gamma * gain).collect()
        };
        self.phi.iter().zip(&self.gamma).map(row).collect()
    }

    /// The row that gives a signal.
    pub(super) fn signal(&self, signal: Signal, left: u32) -> Row {
        match signal {
            Signal::Input => self.gain(left),
            Signal::State(i) => {
                let unit = self.units[i].recip();
                (0..self.order()).map(|j| if i == j { unit } else { 0.0 }).collect()
            }
        }
    }

    /// The signal from so many samples to go on, where `held` bounds it once the gains are held.
    pub(super) fn future(&self, signal: Signal, held: &[Row], left: u32) -> Future {
        let n = self.order();
        let mut all: Vec<Row> =
            (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
        let mut rows = Vec::new();
        for left in (self.rest + 1..=left).rev() {
            rows.push(times(&self.signal(signal, left), &all));
            all = self.step(left).iter().map(|row| times(row, &all)).collect();
        }
        rows.reverse();
        Future { held: held.iter().map(|row| times(row, &all)).collect(), rows }
    }
}
