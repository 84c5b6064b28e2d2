//! The plant of the loop that stays over a sample: rigid, as the law knows it, or with a resonance.

use num_traits::ToPrimitive;

use super::super::chain::Chain;
use crate::algebra::BigRational;
use crate::linear::{Linear, Rows, flow};
use crate::request::Side;

/// Motion over a sample of the states of the plant, and of the input that acts. The plant has `n` known states and then
/// others.
#[derive(Clone, Debug)]
pub(super) struct Plant {
    pub(super) n: usize,
    pub(super) others: usize,
    /// Matrix of the motion row by row, all states in a row.
    pub(super) motion: Vec<f64>,
    pub(super) input: Vec<f64>,
}

impl Plant {
    /// The plant that the law knows.
    pub(super) fn rigid(chain: &Chain) -> Self {
        let input = chain.input.iter().map(|(value, _)| *value).collect();
        Self { n: chain.n, others: 0, motion: chain.motion.entries.clone(), input }
    }
}

/// Numbers of a resonance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spring {
    /// Hz.
    pub(super) frequency: f64,
    pub(super) damping: f64,
    pub(super) inertia_ratio: f64,
}

/// A plant whose input acts through a spring between motor and load, sampled.
#[derive(Clone, Debug)]
pub(super) struct Flexible {
    /// (A, B) by rows, of the plant that the law knows.
    rates: Rows,
    /// Sample period in s.
    pub(super) h: f64,
    /// Part of a sample in which the older of two inputs acts; 1 for the whole of one.
    part: f64,
    measured: Side,
    gain: f64,
}

impl Flexible {
    pub(super) fn new(plant: &Linear, h: f64, part: &BigRational, measured: Side) -> Self {
        let number = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
        let rows = plant.a.iter().zip(&plant.b);
        let rates = rows.map(|(row, b)| row.iter().chain([b]).map(number).collect()).collect();
        Self { rates, h, part: number(part), measured, gain: 1.0 }
    }

    /// The same with an input gain beside B.
    pub(super) fn with_gain(self, gain: f64) -> Self {
        Self { gain, ..self }
    }

    /// The plant with a spring; `None` if that is too fast for the sample period.
    pub(super) fn plant(&self, spring: Spring) -> Option<Plant> {
        let (a, b) = self.joined(spring);
        let after = |part: f64| flow(&a, part * self.h);
        let of = |integral: &Rows| -> Vec<f64> {
            integral.iter().map(|row| row.iter().zip(&b).map(|(f, b)| f * b).sum()).collect()
        };
        let known = self.rates.len();
        if self.part >= 1.0 {
            let (whole, integral) = after(1.0)?;
            let input = of(&integral).into_iter().map(|own| self.gain * own).collect();
            return Some(Plant { n: known, others: 2, motion: whole.concat(), input });
        }
        // The input that acted last is the last of the known states, as it acted.
        let (first, of_first) = after(self.part)?;
        let (rest, of_rest) = after(1.0 - self.part)?;
        let times = |row: &Vec<f64>, j: usize| row.iter().zip(&first).map(|(a, b)| a * b[j]).sum();
        let older = of(&of_first);
        let older = |row: &Vec<f64>| row.iter().zip(&older).map(|(e, own)| e * own).sum::<f64>();
        let newer = of(&of_rest);
        let (size, n) = (a.len() + 1, known + 1);
        let place = |i: usize| if i < known { i } else { i + 1 };
        let mut motion = vec![0.0; size * size];
        let mut input = vec![0.0; size];
        for (i, row) in rest.iter().enumerate() {
            for j in 0..a.len() {
                motion[place(i) * size + place(j)] = times(row, j);
            }
            motion[place(i) * size + known] = older(row);
            input[place(i)] = self.gain * newer[i];
        }
        input[known] = self.gain;
        Some(Plant { n, others: 2, motion, input })
    }

    /// A and B with the spring: w d and d' behind the states, d the twist in units of the input and w its frequency.
    fn joined(&self, spring: Spring) -> (Rows, Vec<f64>) {
        let Spring { frequency, damping, inertia_ratio: r } = spring;
        let omega = 2.0 * std::f64::consts::PI * frequency;
        let pull = [omega, 2.0 * damping * omega];
        // Effects of the input and of the spring on the measured side.
        let (direct, share) = match self.measured {
            Side::Motor => (1.0 + r, -r / (1.0 + r)),
            Side::Load => (0.0, 1.0 / (1.0 + r)),
        };
        let n = self.rates.len();
        let row = |row: &Vec<f64>| {
            let b = row[n];
            row[..n].iter().copied().chain(pull.map(|own| b * share * own)).collect()
        };
        let mut a: Rows = self.rates.iter().map(row).collect();
        a.push([vec![0.0; n], vec![0.0, omega]].concat());
        a.push([vec![0.0; n], pull.map(|own| -own).to_vec()].concat());
        let b = self.rates.iter().map(|row| direct * row[n]).chain([0.0, 1.0 + r]).collect();
        (a, b)
    }
}
