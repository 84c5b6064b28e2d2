//! Gains by the samples to go: exact ones at the end, before it a grid that grows with its distance from it.
//!
//! The last gains bring any state to rest, so those before need no exactness, and are interpolated in a line.

use num_traits::ToPrimitive;

use super::gramian::Gramian;
use super::matrix::Matrix;
use crate::algebra::BigRational;

/// Nodes for each factor of 2 in the samples to go, of the first grid and of the finest one.
const COARSE: u32 = 16;
const FINEST: u32 = 1 << 12;

/// Parts by which a loop may need more energy, and a higher peak, than that of a grid twice as fine.
const MORE_ENERGY: f64 = 7.5e-4;
const MORE_PEAK: f64 = 7.5e-3;

/// Gains of a loop by the samples to go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Weights of the law, and of the law of the last samples where it is another one.
    pub weights: Weights,
    /// Parts of the table with the same distance between their nodes, from the end on.
    pub pieces: Vec<Piece>,
    /// K_M of each node, for u = -K_M x.
    pub gains: Vec<Vec<BigRational>>,
    /// Most samples to go.
    pub samples: u32,
    /// Most bytes that the table may take, where they are limited.
    pub bytes: Option<u32>,
}

/// The weights of a law of least energy, whose sum of u^2/(M (M+1) ... (M + weight - 1)) is the least.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Weights {
    /// That of the law.
    pub law: u32,
    /// The samples to go from which on it is another one, and that one.
    pub end: Option<(u32, u32)>,
}

/// A part of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The first samples to go.
    pub from: u32,
    /// The distance of its nodes, a power of 2 that divides `from` unless it is 1.
    pub spacing: u32,
    /// The row of its first node.
    pub row: u32,
}

/// A demand for a schedule.
pub(crate) struct Demand<'a> {
    /// Phi.
    pub(crate) phi: &'a Matrix,
    /// Gamma.
    pub(crate) gamma: &'a [BigRational],
    pub(crate) weights: Weights,
    /// Samples to the deadline.
    pub(crate) samples: u32,
    /// Most numbers that the table may have.
    pub(crate) most: Option<usize>,
}

/// Reason for which there is no schedule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unscheduled {
    /// The gains have no digits, whatever the precision.
    Digits,
    /// The smallest table has so many numbers.
    Numbers(usize),
}

impl Demand<'_> {
    /// Returns the coarsest schedule whose loop needs no more than that of a finer one.
    pub(crate) fn schedule(&self) -> Result<Schedule, Unscheduled> {
        let fits = |per: &u32| self.most.is_none_or(|most| self.numbers(*per) <= most);
        let first = (0..=COARSE.ilog2()).map(|halved| COARSE >> halved).find(fits);
        let mut per = first.ok_or_else(|| Unscheduled::Numbers(self.numbers(1)))?;
        let mut own = self.of(per)?;
        while per < FINEST && 2 * per < self.samples && fits(&(2 * per)) {
            per *= 2;
            let finer = self.of(per)?;
            if self.is_as_good(&own, &finer) {
                break;
            }
            own = finer;
        }
        Ok(own)
    }

    fn least(&self) -> u32 {
        u32::try_from(self.gamma.len()).unwrap_or(u32::MAX)
    }

    fn numbers(&self, per: u32) -> usize {
        let (_, left) = grid(self.least(), self.samples, per);
        left.len() * self.gamma.len()
    }

    /// The schedule with `per` nodes for each factor of 2.
    fn of(&self, per: u32) -> Result<Schedule, Unscheduled> {
        let (pieces, left) = grid(self.least(), self.samples, per);
        let of = |weight: u32, left: &[u32]| {
            let gramian = Gramian { phi: self.phi, gamma: self.gamma, weight };
            gramian.gains(left).ok_or(Unscheduled::Digits)
        };
        let end = self.weights.end.map_or(0, |(samples, _)| samples);
        let (late, early) = left.split_at(left.partition_point(|left| *left <= end));
        let mut gains = match self.weights.end {
            Some((_, weight)) if !late.is_empty() => of(weight, late)?,
            _ => Vec::new(),
        };
        if !early.is_empty() {
            gains.extend(of(self.weights.law, early)?);
        }
        Ok(Schedule { weights: self.weights, pieces, gains, samples: self.samples, bytes: None })
    }

    /// Returns true if the loop of `own` needs hardly more than that of `finer`.
    fn is_as_good(&self, own: &Schedule, finer: &Schedule) -> bool {
        // From there on the gains are the same.
        let last = own.pieces.get(1).map_or(self.samples, |piece| piece.from);
        (0..self.gamma.len()).all(|from| {
            let [(energy, peak), (less, lower)] =
                [own, finer].map(|schedule| self.effort(schedule, from, last));
            energy <= less * (1.0 + MORE_ENERGY) && peak <= lower * (1.0 + MORE_PEAK)
        })
    }

    /// The energy and the peak of u from a unit of one state, to `last` samples to go.
    fn effort(&self, schedule: &Schedule, from: usize, last: u32) -> (f64, f64) {
        let double = |value: &BigRational| value.to_f64().unwrap_or(f64::NAN);
        let phi: Vec<Vec<f64>> =
            self.phi.rows().iter().map(|row| row.iter().map(double).collect()).collect();
        let gamma: Vec<f64> = self.gamma.iter().map(double).collect();
        let gains: Vec<Vec<f64>> =
            schedule.gains.iter().map(|row| row.iter().map(double).collect()).collect();
        let mut x = vec![0.0; gamma.len()];
        x[from] = 1.0;
        let (mut energy, mut peak) = (0.0, 0.0_f64);
        for left in (last..=self.samples).rev() {
            let (row, part) = schedule.place(left);
            let gain = |j: usize| gains[row][j] + part * (gains[row + 1][j] - gains[row][j]);
            let u = -(0..x.len()).map(|j| gain(j) * x[j]).sum::<f64>();
            let next = |i: usize| {
                phi[i].iter().zip(&x).map(|(phi, x)| phi * x).sum::<f64>() + gamma[i] * u
            };
            x = (0..x.len()).map(next).collect();
            energy += u * u;
            peak = peak.max(u.abs());
        }
        (energy, peak)
    }
}

impl Schedule {
    /// The samples to go below which the gains stay: the order of the loop.
    pub fn least(&self) -> u32 {
        self.pieces.first().map_or(0, |piece| piece.from)
    }

    /// The numbers of the table.
    pub fn numbers(&self) -> usize {
        self.gains.iter().map(Vec::len).sum()
    }

    /// K for so many samples to go.
    pub fn at(&self, left: u32) -> Vec<BigRational> {
        let (row, part) = self.place(left);
        let part = BigRational::from_float(part).unwrap_or_default();
        let between = |(a, b): (&BigRational, &BigRational)| a + &part * (b - a);
        self.gains[row].iter().zip(&self.gains[row + 1]).map(between).collect()
    }

    /// Returns the row before so many samples to go, and the part of the way to the next one.
    pub fn place(&self, left: u32) -> (usize, f64) {
        let left = left.max(self.least());
        let piece = self.pieces.iter().rev().find(|piece| piece.from <= left);
        let Some(Piece { from, spacing, row }) = piece else { return (0, 0.0) };
        let (cells, rest) = ((left - from) / spacing, (left - from) % spacing);
        ((row + cells) as usize, f64::from(rest) / f64::from(*spacing))
    }
}

/// Returns the pieces of a grid with `per` nodes for each factor of 2, and the samples to go of its nodes; the last one
/// is beyond `samples`.
fn grid(least: u32, samples: u32, per: u32) -> (Vec<Piece>, Vec<u32>) {
    let (mut pieces, mut left) = (Vec::new(), Vec::new());
    let (mut from, mut spacing) = (least, 1_u32);
    let mut end = (2 * per).max(least.next_power_of_two() * 2);
    loop {
        pieces.push(Piece { from, spacing, row: u32::try_from(left.len()).unwrap_or(u32::MAX) });
        let last = end.min(samples.saturating_add(1));
        left.extend((from..last).step_by(spacing as usize));
        if end > samples {
            // The node behind the last samples to go.
            let behind = left.last().map_or(from, |last| last + spacing);
            left.push(behind);
            return (pieces, left);
        }
        (from, spacing, end) = (end, end / per.min(end / 2), end.saturating_mul(2));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_count_lies_between_two_nodes() {
        for (least, samples, per) in
            [(2, 2, 16), (2, 31, 16), (3, 32, 16), (4, 1000, 16), (8, 5000, 1), (12, 77, 4)]
        {
            let (pieces, left) = grid(least, samples, per);
            assert!(left.is_sorted_by(|a, b| a < b), "{left:?}");
            for count in least..=samples {
                let piece = pieces.iter().rev().find(|piece| piece.from <= count).expect("a piece");
                let row = (piece.row + (count - piece.from) / piece.spacing) as usize;
                assert!(left[row] <= count && count < left[row + 1], "{count} of {left:?}");
                assert_eq!(left[row], count - (count - piece.from) % piece.spacing);
            }
        }
    }
}
