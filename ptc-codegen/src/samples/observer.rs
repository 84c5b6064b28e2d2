//! The observer, by duality: gains L with which C e is a combination of T^(p).
//!
//! e_{k+1} = Phi (1 - L_k C) e_k is to satisfy the recurrence of the law in shifts, y_{k+m} +
//! sum_j c_{j,k} y_{k+j} = 0. With det(z - Phi) = sum alpha_i z^i that is one constant system:
//! beta_j L_k = c_{j,k-j} - alpha_j, beta_j = sum_{i>j} alpha_i C Phi^(i-j), j = 0..m-1.
//! c_{j,k-j} holds only the factors M, ..., M-m+1 of time-to-go M at sample k, so L is a polynomial
//! over the falling power M^(m).

use num_traits::{One, Zero};

use crate::algebra::{BigInt, BigRational};
use crate::linear::{Matrix, Outputs, Pair, binomial, dot, factorial};

/// c_{0,k}, ..., c_{m-1,k-m+1}: what gains at sample k are made of.
#[derive(Clone, Debug)]
pub(super) struct Recurrence {
    /// Coefficients q_1..q_m of each c with c = constant - sum_j q_j/((M-j+1)...(M-m+1)).
    law: Vec<Vec<BigRational>>,
    constant: Vec<BigRational>,
    /// All c at 0, 1, ..., m - 1 samples below the instant at which deadbeat takes over.
    end: Vec<Vec<BigRational>>,
    /// All c once the estimates are exact, where they are others then.
    after: Option<Vec<BigRational>>,
}

impl Recurrence {
    /// Builds the recurrence from the `rows` of a law; `switch` is M at which deadbeat takes over, and `after` holds
    /// the coefficients of the polynomial that follows.
    pub(super) fn new(
        rows: &[BigRational],
        switch: &BigInt,
        after: Option<Vec<BigRational>>,
    ) -> Self {
        let m = rows.len();
        // c_j of an Euler chain, where rho = 0.
        let constant: Vec<_> = (0..m).map(|j| signed(m - j, binomial(m, j))).collect();
        // The numerators have a degree below m, so m points give them.
        let law = |j: usize| newton((0..m).map(|i| numerator(rows, j, &whole(i))).collect());
        let switch = BigRational::from_integer(switch.clone());
        let end = |below: usize| {
            let now = &switch - whole(below);
            let c = |j: usize| match j <= below {
                true => BigRational::zero(),
                false => &constant[j] - numerator(rows, j, &now) / falling(&now, m),
            };
            (0..m).map(c).collect()
        };
        Self { law: (0..m).map(law).collect(), end: (0..m).map(end).collect(), constant, after }
    }
}

/// The gains of an observer for one measured value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Injection {
    /// Coefficients q_1..q_m of each state with L = sum_j q_j/((M-j+1)...(M-m+1)), then the constant that is added at
    /// every M.
    pub(super) law: Vec<(Vec<BigRational>, BigRational)>,
    /// Gain of each state at 0, 1, ..., m - 1 samples below the instant at which deadbeat takes over; the last one
    /// stays.
    pub(super) end: Vec<Vec<BigRational>>,
    /// Gain of each state once the estimates are exact, where it is another one then.
    pub(super) after: Option<Vec<BigRational>>,
}

impl Injection {
    /// The gains `base` + `map` c of all states.
    fn new(recurrence: &Recurrence, base: &[BigRational], map: &Matrix) -> Self {
        let m = recurrence.constant.len();
        let one = BigRational::one();
        let gain = |state: usize, c: &[BigRational]| {
            let terms = (0..m).map(|j| (map.at(state, j), &c[j]));
            dot(terms.chain([(&base[state], &one)]))
        };
        let law = |state: usize| {
            let weight = |q: usize| -dot((0..m).map(|j| (map.at(state, j), &recurrence.law[j][q])));
            ((0..m).map(weight).collect(), gain(state, &recurrence.constant))
        };
        let end = |state: usize| recurrence.end.iter().map(|c| gain(state, c)).collect();
        let states = 0..base.len();
        let after = recurrence.after.as_ref();
        let after = after.map(|c| states.clone().map(|state| gain(state, c)).collect());
        Self { law: states.clone().map(law).collect(), end: states.map(end).collect(), after }
    }

    /// The gains of block `i` of several measured values.
    pub(super) fn of_block(outputs: &Outputs, i: usize, recurrence: &Recurrence) -> Self {
        let columns = &outputs.columns[i];
        let size = outputs.blocks[i];
        let map = Matrix::new(columns[0].len(), size, |state, j| columns[j][state].clone());
        Self::new(recurrence, &columns[size], &map)
    }

    /// The gains L, beta_j L = c_j - alpha_j, for the states of `pair` measured as `c` x; `None` if
    /// the pair is not observable.
    pub(super) fn of(pair: &Pair, c: &[BigRational], recurrence: &Recurrence) -> Option<Self> {
        let m = pair.order();
        let alpha = pair.phi.characteristic();
        let mut powers = vec![c.to_vec()];
        for _ in 0..m {
            let next = pair.phi.after_row(&powers[powers.len() - 1]);
            powers.push(next);
        }
        let beta = |j: usize| -> Vec<BigRational> {
            let entry = |state: usize| dot((j + 1..=m).map(|i| (&alpha[i], &powers[i - j][state])));
            (0..m).map(entry).collect()
        };
        let map = Matrix::of((0..m).map(beta).collect()).inverse()?;
        let base: Vec<_> = map.on(&alpha[..m]).iter().map(|value| -value).collect();
        Some(Self::new(recurrence, &base, &map))
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
