//! A plant between two samples, with its input held.
//!
//! z = (x, u) moves by z' = Z z, Z = (A B; 0 0). In parts of the sample, so short that powers of Z
//! fade, x_i is a Taylor polynomial and a rest. The polynomial is a convex combination of its control
//! points in Bernstein's form, of which the outer ones are x_i at the ends of the part, up to the rest.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::exponential::{balanced, exponential, power};
use super::{Linear, Matrix, binomial, factorial, scaled, sizes};
use crate::algebra::{BigRational, integer};

/// Norm of A over a part, in the best units of the states: the rest is below 1 % of them.
const NORM: f64 = 0.5;

/// Most parts of a sample.
const PARTS: f64 = 64.0;

/// Degree of the polynomials, where they do not end.
const DEGREE: usize = 3;

/// A plant between two samples.
#[derive(Clone, Debug)]
pub(crate) struct Between {
    pub(crate) parts: Vec<Part>,
    /// Length of a part.
    length: BigRational,
    /// Bound of the distance of x from its polynomials, over the sizes of x and u at the start of a part.
    pub(crate) rest: Matrix,
}

/// A part of a sample, in rows over x and u at the sample.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// x at its start.
    pub(crate) start: Matrix,
    /// Inner control points of each x_i.
    pub(crate) inner: Vec<Vec<Vec<BigRational>>>,
}

impl Between {
    /// The plant over a period `h`; `None` if a mode is too fast for it.
    pub(crate) fn new(plant: &Linear, h: &BigRational) -> Option<Self> {
        Self::of(&moves(plant), plant.b.len(), h)
    }

    /// The same of z' = Z z, of which the first `n` are states, and the rest are inputs.
    pub(crate) fn of(z: &Matrix, n: usize, h: &BigRational) -> Option<Self> {
        let all = z.len();
        // Rows of the powers of Z; those of a chain end.
        let mut powers = vec![Matrix::identity(all)];
        for _ in 0..=n.max(DEGREE) {
            powers.push(powers[powers.len() - 1].times(z));
        }
        let ends = |i: usize| (1..=n + 1).find(|l| (0..all).all(|j| powers[*l].at(i, j).is_zero()));
        let degrees: Vec<_> = (0..n).map(|i| ends(i).map_or(DEGREE, |l| l - 1)).collect();
        let exact = (0..n).all(|i| ends(i).is_some());
        let a = Matrix::new(n, n, |i, j| z.at(i, j).clone());
        let count = if exact { 1.0 } else { (norm(&a, h) / NORM).ceil().max(1.0) };
        (count <= PARTS).then_some(())?;
        #[allow(clippy::cast_possible_truncation)]
        let count = count as i64;
        let length = h / integer(count);
        let point = |i: usize, r: usize| {
            let term = |l: usize| {
                let weight = binomial(r, l) / binomial(degrees[i], l) / factorial(l);
                weight * num_traits::pow(length.clone(), l)
            };
            (0..=r).fold(vec![BigRational::zero(); all], |mut sum, l| {
                let weight = term(l);
                sum.iter_mut()
                    .enumerate()
                    .for_each(|(j, sum)| *sum += &weight * powers[l].at(i, j));
                sum
            })
        };
        let inner: Vec<Vec<_>> =
            (0..n).map(|i| (1..degrees[i]).map(|r| point(i, r)).collect()).collect();
        let part = |at: i64| {
            let start = exponential(&scaled(z, &(&length * integer(at))))?;
            let seen = |row: &Vec<BigRational>| start.after_row(row);
            let inner = inner.iter().map(|points| points.iter().map(seen).collect()).collect();
            Some(Part { start: Matrix::new(n, all, |i, j| start.at(i, j).clone()), inner })
        };
        let parts: Option<_> = (0..count).map(part).collect();
        let rest = match exact {
            true => Matrix::new(n, all, |_, _| BigRational::zero()),
            false => rest(&sizes(z), &length, &degrees, &ends)?,
        };
        Some(Self { parts: parts?, length, rest })
    }

    /// Bounds the effect on x of an impulse of u, from then on for a period and `late` more.
    pub(crate) fn kick(&self, plant: &Linear, late: &BigRational) -> Option<Vec<BigRational>> {
        let n = plant.b.len();
        let over = &self.length + late;
        let a = exponential(&scaled(&sizes(&Matrix::of(plant.a.clone())), &over))?;
        let first = a.on(&plant.b.iter().map(Signed::abs).collect::<Vec<_>>());
        let most = |i: usize| {
            let at = |part: &Part| {
                (0..n).map(|j| part.start.at(i, j).abs() * &first[j]).sum::<BigRational>()
            };
            self.parts.iter().map(at).max().unwrap_or_default()
        };
        Some((0..n).map(most).collect())
    }
}

/// Bounds the change of x in a time of up to `length`, over the sizes of x and u: n rows.
pub(crate) fn drift(plant: &Linear, length: &BigRational) -> Option<Matrix> {
    let whole = exponential(&scaled(&sizes(&moves(plant)), length))?;
    let one = |i: usize, j: usize| if i == j { BigRational::one() } else { BigRational::zero() };
    Some(Matrix::new(plant.b.len(), whole.len(), |i, j| whole.at(i, j) - one(i, j)))
}

/// Bounds the sum of the terms of exp(Z length) beyond the degree of each row, Z of sizes.
fn rest(
    z: &Matrix,
    length: &BigRational,
    degrees: &[usize],
    ends: &dyn Fn(usize) -> Option<usize>,
) -> Option<Matrix> {
    let over = scaled(z, length);
    let whole = exponential(&over)?;
    let mut terms = vec![Matrix::identity(z.len())];
    for l in 1..=DEGREE {
        let next = terms[l - 1].times(&over);
        terms.push(scaled(&next, &(factorial(l - 1) / factorial(l))));
    }
    Some(Matrix::new(degrees.len(), z.len(), |i, j| match ends(i) {
        Some(_) => BigRational::zero(),
        None => terms.iter().fold(whole.at(i, j).clone(), |left, term| left - term.at(i, j)),
    }))
}

/// Z of z' = Z z, z = (x, u).
fn moves(plant: &Linear) -> Matrix {
    let n = plant.b.len();
    Matrix::new(n + 1, n + 1, |i, j| match (i < n, j < n) {
        (true, true) => plant.a[i][j].clone(),
        (true, false) => plant.b[i].clone(),
        (false, _) => BigRational::zero(),
    })
}

/// The norm of A h in the best units of the states.
fn norm(a: &Matrix, h: &BigRational) -> f64 {
    let a = scaled(a, h);
    let units = balanced(&a);
    let row = |i: usize| {
        let entry = |j: usize| (a.at(i, j) * power(units[j] - units[i])).abs().to_f64();
        (0..a.len()).map(|j| entry(j).unwrap_or(f64::INFINITY)).sum::<f64>()
    };
    (0..a.len()).map(row).fold(0.0, f64::max)
}
