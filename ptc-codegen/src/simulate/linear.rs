//! A linear plant whose input is held: from sample to sample by the matrix exponential.

use num_traits::{FromPrimitive, ToPrimitive};

use super::Failure;
#[cfg(feature = "lab")]
use super::held::Effect;
use super::held::{Row, is_same};
use super::method::State;
use crate::algebra::BigRational;
use crate::linear::{self, Delay, Rows, flow, zero_order_hold};

/// Relative tolerance within which a length counts as the period.
pub(super) const SAME: f64 = 1e-9;

/// ||A s|| up to which doubles keep all digits but two.
const MILD: f64 = 32.0;

/// x' = A x + B u, y = C x.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    plant: linear::Linear,
    /// (A, B) by rows.
    rates: Rows,
    c: Rows,
    /// A length in s with the rows of (Phi, Gamma).
    over: Option<(f64, Rows)>,
}

impl Linear {
    /// The plant, sampled with period `h`.
    pub(super) fn new(plant: &linear::Linear, h: Option<&BigRational>) -> Self {
        let c = plant.c.iter().map(|row| row.iter().map(double).collect()).collect();
        let rows = plant.a.iter().zip(&plant.b);
        let rates = rows.map(|(row, b)| row.iter().chain([b]).map(double).collect()).collect();
        let mut linear = Self { plant: plant.clone(), rates, c, over: None };
        if let Some(h) = h {
            linear.over = linear.rows(h).map(|rows| (double(h), rows));
        }
        linear
    }

    /// (Phi, Gamma) over the period.
    fn rows(&self, h: &BigRational) -> Option<Rows> {
        let held = zero_order_hold(&self.plant, h, &Delay::default())?;
        let rows = held.phi.iter().zip(&held.older);
        Some(rows.map(|(row, gamma)| row.iter().chain([gamma]).map(double).collect()).collect())
    }

    /// The same over part of a period, in doubles: a run has many parts of different lengths.
    fn part(&self, length: f64) -> Option<Rows> {
        let is_mild = linear::norm(&self.rates) * length <= MILD;
        let Some((whole, integral)) = flow(&self.rates, length).filter(|_| is_mild) else {
            return self.rows(&BigRational::from_f64(length)?);
        };
        let n = self.order();
        let gamma = |row: &Vec<f64>| row.iter().zip(&self.rates).map(|(f, own)| f * own[n]).sum();
        let rows = whole.into_iter().zip(&integral);
        Some(rows.map(|(row, of_input)| [row, vec![gamma(of_input)]].concat()).collect())
    }

    /// Number of states.
    pub(super) fn order(&self) -> usize {
        self.rates.len()
    }

    /// The rates, times `scale`.
    pub(super) fn rates(&self, scale: f64, x: &[f64], u: f64, rates: &mut State) {
        for (rate, row) in rates.iter_mut().zip(&self.rates) {
            let own = row.iter().zip(x.iter().chain([&u])).map(|(factor, x)| factor * x);
            *rate = scale * own.sum::<f64>();
        }
    }

    /// y.
    pub(super) fn measured(&self, x: &[f64]) -> Vec<f64> {
        self.c.iter().map(|row| row.iter().zip(x).map(|(c, x)| c * x).sum()).collect()
    }

    /// Returns the rows over a length that is the period, and the period; `None` over another one.
    pub(super) fn known(&self, length: f64) -> Option<(f64, Vec<Row<'_>>)> {
        let (own, rows) = self.over.as_ref().filter(|(own, _)| is_same(*own, length))?;
        // Not even a zero changes by what is added.
        let all = rows.iter().map(|row| {
            let (whole, of_input) = row.split_at(self.order());
            (whole, of_input, -0.0)
        });
        Some((*own, all.collect()))
    }

    /// What a length comes to.
    #[cfg(feature = "lab")]
    pub(super) fn effect(&self, length: f64) -> Option<Effect> {
        let known = self.over.as_ref().filter(|(own, _)| is_same(*own, length));
        let other = match known {
            Some(_) => None,
            None => self.part(length),
        };
        let rows = known.map(|(_, rows)| rows).or(other.as_ref())?;
        let split = |row: &Vec<f64>| {
            let (whole, of_input) = row.split_at(self.order());
            (whole.to_vec(), of_input.to_vec(), -0.0)
        };
        let rows = rows.iter().map(split).collect();
        let (length, is_kept) = known.map_or((length, false), |(own, _)| (*own, true));
        Some(Effect { length, is_kept, rows, waves: 0 })
    }

    /// The rows of y = C x.
    #[cfg(feature = "lab")]
    pub(super) fn output_rows(&self) -> &Rows {
        &self.c
    }

    /// The state after `length` s with u.
    pub(super) fn after(&mut self, x: State, u: f64, length: f64) -> Result<State, Failure> {
        let known = self.over.as_ref().filter(|(own, _)| is_same(*own, length));
        let other = match known {
            Some(_) => None,
            None => self.part(length),
        };
        let Some(rows) = known.map(|(_, rows)| rows).or(other.as_ref()) else {
            return Err(Failure::input(
                format!("the plant is not sampled with a period of {length} s"),
                "give a shorter sample_time".to_owned(),
            ));
        };
        let mut next = x;
        for (i, row) in rows.iter().enumerate() {
            let states = row.iter().zip(x.as_slice()).take(rows.len());
            next[i] = states.map(|(factor, x)| factor * x).sum::<f64>() + row[rows.len()] * u;
            if !next[i].is_finite() {
                return Err(Failure::range());
            }
        }
        Ok(next)
    }
}

fn double(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
