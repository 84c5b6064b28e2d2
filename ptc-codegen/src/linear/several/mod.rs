//! Linear plants with as many outputs as inputs, whose held inputs move chains of integrators exactly.
//!
//! With x_{k+1} = Phi x_k + Gamma u_k, D = (Phi - 1)/h and Delta x = (x_{k+1} - x_k)/h, output k of order r has a
//! row c with c D^i Gamma = 0 for i < r - 1. Then z_i = c D^(i-1) x moves by Delta z_i = z_{i+1} and
//! Delta z_r = F x + G u, which is what a chain of r integrators, sampled with the same period, does in its
//! differences ([`Pair::flat`]): xi = S^-1 z are the states of that chain, and u = G^-1 (v - F x) moves it by v, with
//! no error at all. Of the rows that are left c is the one nearest to the output: in the coordinates
//! C_j A^i, which c may contain for i <= r_j - r, it is 1 at the output and 0 at all others, so that xi is the
//! output and its derivatives up to O(h).
//!
//! These are as many equations as states where no order is above another by more than 1.

mod left;
mod rounded;

use num_traits::{One, Signed, Zero};

pub(crate) use left::{Left, Moving};
use rounded::{Sized, long, rounded};

use super::condition::{alone, most, radius};
use super::exponential::{balanced, exponential, power};
use super::{Matrix, Pair};
use crate::algebra::BigRational;
use crate::parameter::Precision;

/// The matrix exponential is within 2^-190 of the true one, in the best units of the states.
const EXPONENTIAL: i64 = -190;

/// A linear plant x' = A x + B u, y = C x whose outputs and their derivatives give all states.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Several {
    /// A, by rows.
    pub a: Vec<Vec<BigRational>>,
    /// B, by rows.
    pub b: Vec<Vec<BigRational>>,
    /// C, by rows.
    pub c: Vec<Vec<BigRational>>,
    /// Relative degree of each output.
    pub orders: Vec<usize>,
}

/// The chains that held inputs move, xi = `coordinates` x, and these inputs, u = `inverse` (v - `drift` x), in numbers of
/// more digits than any precision has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chains {
    /// Row of each xi, one chain after the other.
    pub coordinates: Vec<Vec<BigRational>>,
    /// F.
    pub drift: Vec<Vec<BigRational>>,
    /// G^-1.
    pub inverse: Vec<Vec<BigRational>>,
}

/// Why held inputs do not move the chains of a plant one by one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum IllSampled {
    /// A mode is too fast for the sample period.
    Fast,
    /// They hardly do, with this condition number.
    Singular(f64),
}

/// Phi and Gamma, or the same over a part of a sample.
pub(crate) struct Held {
    pub(crate) phi: Matrix,
    pub(crate) gamma: Matrix,
}

impl Several {
    /// Number of states.
    pub(crate) fn states(&self) -> usize {
        self.a.len()
    }

    /// Returns true if the equations of the chains are as many as the states.
    pub(crate) fn has_chains(&self) -> bool {
        let ends = [self.orders.iter().min(), self.orders.iter().max()];
        let near = matches!(ends, [Some(least), Some(most)] if most - least <= 1);
        near && self.orders.iter().sum::<usize>() == self.states()
    }

    /// Z of z' = Z z, z = (x, u) with a held u.
    pub(crate) fn moves(&self) -> Matrix {
        let (n, m) = (self.states(), self.orders.len());
        Matrix::new(n + m, n + m, |i, j| match (i < n, j < n) {
            (true, true) => self.a[i][j].clone(),
            (true, false) => self.b[i][j - n].clone(),
            (false, _) => BigRational::zero(),
        })
    }

    /// Returns Phi and Gamma of a time `over`; `None` where a mode is too fast for it.
    pub(crate) fn held(&self, over: &BigRational) -> Option<Held> {
        let (n, m) = (self.states(), self.orders.len());
        let whole = exponential(&scaled(&self.moves(), over))?;
        Some(Held {
            phi: Matrix::new(n, n, |i, j| whole.at(i, j).clone()),
            gamma: Matrix::new(n, m, |i, j| whole.at(i, n + j).clone()),
        })
    }

    /// Bounds the errors of the entries of (Phi, Gamma) of such a time.
    pub(crate) fn off(&self, over: &BigRational) -> Matrix {
        let units = balanced(&scaled(&self.moves(), over));
        let entry = |i: usize, j: usize| power(EXPONENTIAL + units[i] - units[j]);
        Matrix::new(self.states(), units.len(), entry)
    }

    /// The outputs and their derivatives, C_k A^i, one output after the other.
    pub(crate) fn derivatives(&self) -> Matrix {
        let a = Matrix::of(self.a.clone());
        let all = self.c.iter().zip(&self.orders).flat_map(|(row, order)| {
            std::iter::successors(Some(row.clone()), |row| Some(a.after_row(row))).take(*order)
        });
        Matrix::of(all.collect())
    }

    /// The chains that inputs move which are held for `h`.
    ///
    /// # Errors
    /// That they do not move them one by one, or not with the digits of `precision`.
    pub(crate) fn chains(
        &self,
        h: &BigRational,
        precision: Precision,
    ) -> Result<Chains, IllSampled> {
        let held = self.held(h).ok_or(IllSampled::Fast)?;
        let singular = IllSampled::Singular(f64::INFINITY);
        let derivatives = self.derivatives();
        let back = derivatives.inverse().ok_or(singular.clone())?;
        let over = h.recip();
        let one = Matrix::identity(self.states());
        let step = long(&scaled(&held.phi.plus(&-BigRational::one(), &one), &over));
        let gamma = long(&held.gamma);
        let (mut z, mut drift, mut gain) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..self.orders.len() {
            let first = self.first(k, (&step, &gamma), &back).ok_or(singular.clone())?;
            let mut row = first;
            for _ in 1..self.orders[k] {
                z.push(row.clone());
                row = row.times(&step);
            }
            z.push(row.clone());
            gain.push(row.times(&scaled(&gamma, &over)));
            drift.push(row.times(&step));
        }
        let coordinates = self.coordinates(h, &z);
        let gain = Sized::stacked(gain);
        let inverse = long(&Matrix::of(gain.value.clone()).inverse().ok_or(singular)?);
        // What a sample makes of the derivatives and of the decoupling matrix, in any units.
        let decoupling = self.decoupling(&derivatives);
        let of_states = Matrix::of(coordinates.value.clone()).times(&back);
        let of_inputs = decoupling.times(&inverse);
        let condition = [alone(&of_states), alone(&of_inputs), radius(&of_inputs)];
        let condition = condition.into_iter().fold(0.0, f64::max);
        if condition.is_nan() || condition > most(precision) {
            return Err(IllSampled::Singular(condition));
        }
        let inverse = Sized::of_inverse(inverse, &gain);
        Ok(Chains {
            coordinates: rounded(&coordinates),
            drift: rounded(&Sized::stacked(drift)),
            inverse: rounded(&inverse),
        })
    }

    /// The row c of an output.
    fn first(&self, k: usize, (step, gamma): (&Matrix, &Matrix), back: &Matrix) -> Option<Sized> {
        let order = self.orders[k];
        let mut equations = Vec::with_capacity(self.states());
        let mut right = Vec::with_capacity(self.states());
        let mut reached = gamma.transpose();
        for _ in 1..order {
            equations.extend_from_slice(reached.rows());
            right.resize(equations.len(), BigRational::zero());
            reached = long(&reached.times(&step.transpose()));
        }
        let back = back.transpose();
        let mut place = 0;
        for (j, other) in self.orders.iter().enumerate() {
            for i in 0..*other {
                if i + order <= *other {
                    equations.push(back.rows()[place].clone());
                    right.push(match (j, i) == (k, 0) {
                        true => BigRational::one(),
                        false => BigRational::zero(),
                    });
                }
                place += 1;
            }
        }
        let equations = Matrix::of(equations);
        let inverse = equations.inverse()?;
        Some(Sized::solution(&inverse, &equations, &right))
    }

    /// xi = S^-1 z of each chain.
    fn coordinates(&self, h: &BigRational, z: &[Sized]) -> Sized {
        let mut all = Vec::with_capacity(z.len());
        let mut rest = z;
        for order in &self.orders {
            let (own, others) = rest.split_at(*order);
            rest = others;
            let one = BigRational::one();
            let flat = Pair::chain(*order, &one, &one).flat();
            let Some(inverse) = flat.and_then(|(s, _)| s.inverse()) else { continue };
            // Counted in units of v h^(r+1-i) there.
            let inverse = Matrix::new(*order, *order, |i, j| {
                let power = num_traits::pow(h.clone(), i.abs_diff(j));
                if j >= i { inverse.at(i, j) * power } else { inverse.at(i, j) / power }
            });
            all.extend(Sized::stacked(own.to_vec()).after(&inverse));
        }
        Sized::stacked(all)
    }

    /// C_k A^(r_k-1) B.
    fn decoupling(&self, derivatives: &Matrix) -> Matrix {
        let mut last = 0;
        let rows = self.orders.iter().map(|order| {
            last += order;
            derivatives.rows()[last - 1].clone()
        });
        Matrix::of(rows.collect()).times(&Matrix::of(self.b.clone()))
    }
}

pub(crate) fn scaled(of: &Matrix, factor: &BigRational) -> Matrix {
    Matrix::new(of.len(), of.columns(), |i, j| of.at(i, j) * factor)
}

/// The sizes of the entries.
pub(crate) fn sizes(of: &Matrix) -> Matrix {
    Matrix::new(of.len(), of.columns(), |i, j| of.at(i, j).abs())
}
