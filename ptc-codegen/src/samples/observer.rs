//! The observer, by duality: gains L with which C e is a combination of T^(p).
//!
//! e_{k+1} = Phi (1 - L_k C) e_k is to satisfy the recurrence of the law in shifts, y_{k+m} +
//! sum_j c_{j,k} y_{k+j} = 0. With det(z - Phi) = sum alpha_i z^i that is one constant system:
//! beta_j L_k = c_{j,k-j} - alpha_j, beta_j = sum_{i>j} alpha_i C Phi^(i-j), j = 0..m-1.
//! c_{j,k-j} holds only the factors M, ..., M-m+1 of time-to-go M at sample k, so L is a polynomial
//! over the falling power M^(m).

use num_traits::{One, Zero};

use super::matrix::Matrix;
use super::pair::{Pair, binomial, factorial};
use crate::algebra::{BigInt, BigRational};

/// The gains of an observer of one measured combination of the states.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Injection {
    /// Of each state the coefficients q_1..q_m with L = sum_j q_j/((M-j+1)...(M-m+1)), then what is
    /// added at every M.
    pub(super) law: Vec<(Vec<BigRational>, BigRational)>,
    /// Of each state its gain at 0, 1, ..., m - 1 samples below the instant at which deadbeat takes
    /// over; the last one stays.
    pub(super) end: Vec<Vec<BigRational>>,
}

impl Injection {
    /// The gains for the states of `pair` measured as `c` x, with `rows` of the law; none where the
    /// pair is not observable. `switch` is M at which deadbeat takes over.
    pub(super) fn new(
        pair: &Pair,
        c: &[BigRational],
        rows: &[BigRational],
        switch: &BigInt,
    ) -> Option<Self> {
        let m = pair.order();
        let alpha = pair.phi.characteristic();
        let mut powers = vec![c.to_vec()];
        for _ in 0..m {
            let next = pair.phi.after_row(&powers[powers.len() - 1]);
            powers.push(next);
        }
        let beta = |j: usize| -> Vec<BigRational> {
            let entry = |state: usize| {
                let terms = (j + 1..=m).map(|i| &alpha[i] * &powers[i - j][state]);
                terms.fold(BigRational::zero(), |sum, term| sum + term)
            };
            (0..m).map(entry).collect()
        };
        let system = Matrix::of_rows((0..m).map(beta).collect());
        // c_j of an Euler chain, where rho = 0.
        let chain = |j: usize| signed(m - j, binomial(m, j));
        let law_at = |point: &BigRational| {
            let right: Vec<_> = (0..m).map(|j| -numerator(rows, j, point)).collect();
            system.solve(&right)
        };
        // The numerators have a degree below m, so m points give them.
        let values: Option<Vec<_>> = (0..m).map(|i| law_at(&whole(i))).collect();
        let values = values?;
        let constant: Vec<_> = (0..m).map(|j| chain(j) - &alpha[j]).collect();
        let constant = system.solve(&constant)?;
        let law = (0..m).map(|state| {
            let column: Vec<_> = values.iter().map(|at| at[state].clone()).collect();
            (newton(column), constant[state].clone())
        });
        let switch = BigRational::from_integer(switch.clone());
        let end_at = |below: usize| {
            let now = &switch - whole(below);
            let right: Vec<_> = (0..m)
                .map(|j| {
                    if j <= below {
                        return -alpha[j].clone();
                    }
                    let falling = falling(&now, m);
                    chain(j) - numerator(rows, j, &now) / falling - &alpha[j]
                })
                .collect();
            system.solve(&right)
        };
        let end: Option<Vec<_>> = (0..m).map(end_at).collect();
        let end = end?;
        let end = (0..m).map(|state| end.iter().map(|at| at[state].clone()).collect()).collect();
        Some(Self { law: law.collect(), end })
    }
}

/// M^(m) times the part of -c_{j,k-j} that the rows make up.
fn numerator(rows: &[BigRational], j: usize, now: &BigRational) -> BigRational {
    let m = rows.len();
    let term = |i: usize| {
        let sign = signed(i - 1 - j, binomial(i - 1, j));
        // M^(m) over the factors (M+j-i+1)..(M+j-m+1) of the row's own denominator.
        let own = i - 1 - j..m - j;
        let others = (0..m).filter(|f| !own.contains(f)).map(|f| now - whole(f));
        others.fold(sign * &rows[i - 1], |product, factor| product * factor)
    };
    (j + 1..=m).map(term).fold(BigRational::zero(), |sum, term| sum + term)
}

/// The coefficients in falling powers of the polynomial with these values at 0, 1, ...
fn newton(mut values: Vec<BigRational>) -> Vec<BigRational> {
    let mut coefficients = Vec::with_capacity(values.len());
    for order in 0..values.len() {
        coefficients.push(&values[0] / factorial(order));
        values = values.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    }
    coefficients
}

fn falling(value: &BigRational, m: usize) -> BigRational {
    (0..m).fold(BigRational::one(), |product, i| product * (value - whole(i)))
}

fn signed(power: usize, value: BigRational) -> BigRational {
    if power.is_multiple_of(2) { value } else { -value }
}

fn whole(i: usize) -> BigRational {
    BigRational::from_integer(BigInt::from(i))
}
