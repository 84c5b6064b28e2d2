//! Controllability and observability of a linear plant in samples, with digits to spare.
//!
//! Two numbers decide, and the greater one is reported. Of K = (Gamma, Phi Gamma, ...), or (C; C Phi;
//! ...), the condition number in the best units of the states: min cond(E K F) over diagonal E and F
//! is the spectral radius of |K^-1| |K| (Bauer 1963). Rounding grows by that factor in a round of
//! deadbeat. Of (Gamma, D Gamma, ...), D = Phi - 1, the same where states that act on each other
//! share a unit: it measures how near the plant is to one with an unreachable mode, at any period.

// Numbers of states become small numbers here.
#![allow(clippy::cast_precision_loss)]

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::exponential::{balanced, power};
use super::matrix::Matrix;
use super::outputs::Outputs;
use super::pair::Pair;
use super::singular::{least, norm};
use super::{Complex, Delay, Disturbance, Linear, roots};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::{BigInt, BigRational};
use crate::parameter::Precision;

/// Bits of a row that count.
const DIGITS: i64 = 400;

/// Sweeps of the iteration for a spectral radius.
const SWEEPS: usize = 200;

/// Defect of a plant.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Ill {
    /// A mode is too fast for the sample period.
    Fast,
    /// Rows of C depend on each other.
    Dependent,
    /// The input does not reach a mode, or hardly.
    Uncontrollable { condition: f64, mode: Option<Complex> },
    /// The measurement does not show a mode, or hardly.
    Unobservable { condition: f64, mode: Option<Complex> },
}

/// The greatest condition number that leaves half of the digits.
pub(super) fn most(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => 1e8,
        Precision::F32 => 1e4,
    }
}

/// Examines a plant sampled with period `h`, whose input is late by `delay`, none where it does
/// not control; with a disturbance of the input, which is observed. Gives how
/// many of the states that are estimated each row of C accounts for; nothing where it shows all of
/// them.
pub(crate) fn examine(
    plant: &Linear,
    h: &BigRational,
    delay: Option<&Delay>,
    disturbance: Option<&Disturbance>,
    precision: Precision,
) -> Result<Vec<usize>, Ill> {
    let limit = most(precision);
    let part = delay.map_or_else(BigRational::one, Delay::part);
    let pair = Pair::linear(plant, h, &part).ok_or(Ill::Fast)?;
    if let Some(delay) = delay {
        controllable(plant, h, &pair, delay, limit)?;
    }
    if rank(&plant.c) < plant.c.len() {
        return Err(Ill::Dependent);
    }
    if plant.c.len() == plant.b.len() && disturbance.is_none() {
        return Ok(Vec::new());
    }
    let unseen = |condition| {
        // A plant that can be observed alone leaves the mode of the disturbance.
        let alone = |_: &&Disturbance| examine(plant, h, delay, None, precision).is_ok();
        let mode = match disturbance.filter(alone) {
            Some(disturbance) => Some(disturbance.mode()),
            None => mode(plant, h, &pair, &plant.c, true),
        };
        Err(Ill::Unobservable { condition, mode })
    };
    let observed = match disturbance {
        Some(disturbance) => Pair::linear_with(disturbance, plant, h, &part).ok_or(Ill::Fast)?,
        None => pair.clone(),
    };
    let Some(outputs) = Outputs::new(&observed, &plant.c) else { return unseen(f64::INFINITY) };
    let shown = |step: &Matrix| {
        let rows = plant.c.iter().zip(&outputs.blocks).flat_map(|(row, size)| {
            let mut row = row.clone();
            row.resize(observed.order(), BigRational::zero());
            powers(step, &row, *size)
        });
        rows.collect()
    };
    let coupled = Coupled::new(plant, h, observed.order());
    let condition = self::condition(shown(&observed.phi), &Coupled::none(observed.order()))
        .max(self::condition(shown(&observed.step()), &coupled));
    match condition > limit || condition.is_nan() {
        true => unseen(condition),
        false => Ok(outputs.blocks),
    }
}

/// Checks that the input of `pair`, a plant sampled with period `h`, controls it with a delay.
fn controllable(
    plant: &Linear,
    h: &BigRational,
    pair: &Pair,
    delay: &Delay,
    limit: f64,
) -> Result<(), Ill> {
    let late = pair.delayed(delay.inputs());
    let coupled = Coupled::new(plant, h, late.order());
    let reached = |step: &Matrix| powers(&step.transpose(), &late.gamma, late.order());
    let condition = condition(reached(&late.phi), &Coupled::none(late.order()))
        .max(self::condition(reached(&late.step()), &coupled.dual()));
    if condition > limit || condition.is_nan() {
        let mode = mode(plant, h, pair, std::slice::from_ref(&pair.gamma), false);
        return Err(Ill::Uncontrollable { condition, mode });
    }
    Ok(())
}

/// row, row A, ..., row A^(count-1).
fn powers(a: &Matrix, row: &[BigRational], count: usize) -> Vec<Vec<BigRational>> {
    let next = |row: &Vec<BigRational>| Some(rounded(a.after_row(row)));
    std::iter::successors(Some(row.to_vec()), next).take(count).collect()
}

/// A row to 2^-400 of its largest entry: without, its digits grow with each power.
pub(super) fn rounded(row: Vec<BigRational>) -> Vec<BigRational> {
    let most = row.iter().map(Signed::abs).max().unwrap_or_default();
    if most.is_zero() {
        return row;
    }
    let bits = |value: &BigInt| i64::try_from(value.bits()).unwrap_or(i64::MAX);
    let grid = power(bits(most.numer()) - bits(most.denom()) - DIGITS);
    row.iter().map(|entry| (entry / &grid).round() * &grid).collect()
}

/// The units of states that act on each other.
struct Coupled {
    /// Number of the group of each state.
    groups: Vec<usize>,
    /// Power of 2 that is the unit of each state.
    units: Vec<i64>,
}

impl Coupled {
    /// Each state has a unit of its own.
    fn none(order: usize) -> Self {
        Self { groups: (0..order).collect(), units: vec![0; order] }
    }

    /// Returns the groups and units of a plant, with other states behind its own up to `order`.
    fn new(plant: &Linear, h: &BigRational, order: usize) -> Self {
        let n = plant.b.len();
        let mut acts: Vec<Vec<bool>> =
            plant.a.iter().map(|row| row.iter().map(|entry| !entry.is_zero()).collect()).collect();
        for via in 0..n {
            for i in 0..n {
                for j in 0..n {
                    acts[i][j] |= acts[i][via] && acts[via][j];
                }
            }
        }
        let first = |i: usize| (0..i).find(|j| acts[i][*j] && acts[*j][i]).unwrap_or(i);
        let mut units = balanced(&Matrix::new(n, n, |i, j| &plant.a[i][j] * h));
        units.resize(order, 0);
        Self { groups: (0..order).map(|i| if i < n { first(i) } else { i }).collect(), units }
    }

    /// The same for what moves the states in place of what shows them.
    fn dual(self) -> Self {
        Self { units: self.units.iter().map(|unit| -unit).collect(), ..self }
    }
}

/// The spectral radius of |K| |K^-1|, in which the states of a group count together; infinite where K
/// is singular.
fn condition(rows: Vec<Vec<BigRational>>, coupled: &Coupled) -> f64 {
    let (n, rows) = (rows.len(), Matrix::of(rows));
    let rows = Matrix::new(n, n, |i, j| rows.at(i, j) * power(coupled.units[j]));
    // Rows of one size: the radius stays, and the numbers stay in range.
    let size = |i: usize| (0..n).map(|j| rows.at(i, j).abs()).max().unwrap_or_default();
    let sizes: Vec<_> = (0..n).map(size).collect();
    if sizes.iter().any(Zero::is_zero) {
        return f64::INFINITY;
    }
    let rows = Matrix::new(n, n, |i, j| rows.at(i, j) / &sizes[i]);
    let Some(inverse) = rows.inverse() else { return f64::INFINITY };
    let double = |m: &Matrix, i, j| m.at(i, j).to_f64().map_or(f64::INFINITY, f64::abs);
    let group = |g: usize| (0..n).filter(move |i| coupled.groups[*i] == g);
    let entry = |i: usize, j: usize| {
        let parts = (0..n).map(|g| {
            let most = group(g).map(|state| double(&rows, i, state)).fold(0.0, f64::max);
            most * group(g).map(|state| double(&inverse, state, j)).sum::<f64>()
        });
        parts.sum()
    };
    let row = |i| (0..n).map(|j| entry(i, j)).collect();
    let product: Vec<Vec<f64>> = (0..n).map(row).collect();
    spectral(&product)
}

/// The same in the best unit of each state.
pub(super) fn alone(of: &Matrix) -> f64 {
    condition(of.rows().to_vec(), &Coupled::none(of.len()))
}

/// The spectral radius of |K|; infinite where it is 0.
pub(super) fn radius(of: &Matrix) -> f64 {
    let size = |value: &BigRational| value.to_f64().map_or(f64::INFINITY, f64::abs);
    let sizes = of.rows().iter().map(|row| row.iter().map(size).collect());
    spectral(&sizes.collect::<Vec<_>>())
}

/// The spectral radius of a matrix without negative entries; infinite where it is 0.
fn spectral(of: &[Vec<f64>]) -> f64 {
    let mut vector = vec![1.0; of.len()];
    let mut radius = 0.0;
    for _ in 0..SWEEPS {
        let after = |row: &Vec<f64>| row.iter().zip(&vector).map(|(a, x)| a * x).sum();
        vector = of.iter().map(after).collect();
        radius = vector.iter().copied().fold(0.0, f64::max);
        vector.iter_mut().for_each(|x| *x /= radius);
    }
    if vector.iter().all(|x| x.is_finite()) { radius } else { f64::INFINITY }
}

fn rank(rows: &[Vec<BigRational>]) -> usize {
    let mut kept: Vec<Vec<BigRational>> = rows.to_vec();
    let mut rank = 0;
    for column in 0..kept.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..kept.len()).find(|i| !kept[*i][column].is_zero()) else {
            continue;
        };
        kept.swap(rank, pivot);
        let lead = kept[rank].clone();
        for row in &mut kept[rank + 1..] {
            let factor = &row[column] / &lead[column];
            row.iter_mut().zip(&lead).for_each(|(entry, above)| *entry -= &factor * above);
        }
        rank += 1;
    }
    rank
}

/// The eigenvalue of A whose mode the input, or what is measured, is furthest from: of the matrices
/// (D - z, Gamma), z = exp(lambda h) - 1, that with the least singular value.
fn mode(
    plant: &Linear,
    h: &BigRational,
    pair: &Pair,
    ports: &[Vec<BigRational>],
    measured: bool,
) -> Option<Complex> {
    let n = pair.order();
    let a = Matrix::new(n, n, |i, j| &plant.a[i][j] * h);
    let units = balanced(&a);
    let own = roots(&Polynomial::new(a.characteristic()))?;
    let step = pair.step();
    let rows = |m: &Matrix| -> Option<Vec<Vec<f64>>> {
        let entry = |i, j| (m.at(i, j) * power(units[j] - units[i])).to_f64();
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    };
    let step = rows(&step)?;
    let step = |i: usize, j: usize| if measured { step[j][i] } else { step[i][j] };
    let column = |port: &Vec<BigRational>| -> Option<Vec<f64>> {
        let unit = |i: usize| power(if measured { units[i] } else { -units[i] });
        let column: Option<Vec<_>> = (0..n).map(|i| (&port[i] * unit(i)).to_f64()).collect();
        let size = column.as_deref().map(norm).filter(|size| *size > 0.0).unwrap_or(1.0);
        column.map(|column| column.iter().map(|x| x / size).collect())
    };
    let ports: Vec<_> = ports.iter().map(column).collect::<Option<_>>()?;
    // All in the size of what the modes themselves do in a sample.
    let all: Vec<_> = (0..n * n).map(|at| step(at / n, at % n)).collect();
    let size = norm(&all).max(f64::MIN_POSITIVE);
    // A complex row u + v i as the two real rows (u, -v) and (v, u): all singular values twice.
    let distance = |value: &Complex| {
        let z = value.exp_m1();
        let row = |i: usize, imaginary: bool| {
            let diagonal = |j: usize, entry: f64| if i == j { entry / size } else { 0.0 };
            let real = (0..n).map(|j| step(i, j) / size - diagonal(j, z.re)).collect();
            let turned = |sign: f64| (0..n).map(|j| sign * diagonal(j, z.im)).collect::<Vec<_>>();
            let shown = ports.iter().map(|port| port[i]).collect();
            let none = vec![0.0; ports.len()];
            match imaginary {
                false => [real, shown, turned(1.0), none].concat(),
                true => [turned(-1.0), none, real, shown].concat(),
            }
        };
        least((0..n).flat_map(|i| [row(i, false), row(i, true)]).collect())
    };
    let period = h.to_f64()?;
    let nearest = own.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    Some(Complex::new(nearest.re / period, nearest.im.abs() / period))
}
