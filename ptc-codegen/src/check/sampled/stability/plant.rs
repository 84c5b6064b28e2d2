//! The plant of the loop that stays over a sample: rigid, as the law knows it, or with a resonance.

use num_traits::ToPrimitive;

use super::super::chain::Chain;
use crate::algebra::BigRational;
use crate::linear::{Joint, Linear, Rows, Side, Spring, Twist, flow};

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
    pub(super) fn plant(&self, joint: Joint<f64>) -> Option<Plant> {
        let (a, b) = self.joined(joint);
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
    fn joined(&self, joint: Joint<f64>) -> (Rows, Vec<f64>) {
        let spring = Spring::scaled(joint);
        // A column each: the angle and its rate.
        let units = [[1.0, 0.0], [0.0, 1.0]].map(|[angle, rate]| Twist { angle, rate });
        let rest = Twist { angle: 0.0, rate: 0.0 };
        let pull = units.map(|twist| spring.pull(twist));
        let direct = spring.moved(self.measured, 1.0, 0.0);
        let share = spring.moved(self.measured, 0.0, 1.0);
        let [of_angle, of_rate] = units.map(|twist| spring.rates(twist, 0.0));
        let driven = spring.rates(rest, spring.driven(1.0));
        let n = self.rates.len();
        let row = |row: &Vec<f64>| {
            let b = row[n];
            row[..n].iter().copied().chain(pull.map(|own| b * share * own)).collect()
        };
        let mut a: Rows = self.rates.iter().map(row).collect();
        a.extend([0, 1].map(|i| [vec![0.0; n], vec![of_angle[i], of_rate[i]]].concat()));
        let b = self.rates.iter().map(|row| direct * row[n]).chain(driven).collect();
        (a, b)
    }
}
