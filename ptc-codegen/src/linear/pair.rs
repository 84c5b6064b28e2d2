//! The plant between two samples: x_{k+1} = Phi x_k + Gamma u_k, exactly, in the sample period as
//! the unit of time.

use num_traits::{One, Zero};

use super::exponential::exponential;
use super::matrix::Matrix;
use super::{Delay, Linear};
use crate::algebra::BigRational;
use crate::expansion::bell::factorials;

/// Effect of a held input on the states from one sample to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Pair {
    /// Phi.
    pub(crate) phi: Matrix,
    /// Gamma.
    pub(crate) gamma: Vec<BigRational>,
    /// The part of Gamma that is due to an input which takes over within the sample; 0 where none
    /// does.
    pub(crate) newer: Vec<BigRational>,
    /// The power p of each state, which is divided by h^p here.
    pub(crate) powers: Vec<i64>,
}

impl Pair {
    /// The chain x_1' = x_2, ..., x_n' = `gain` u, where the next input takes over after `part` of
    /// the sample. State x_j is counted in units of u h^(n+1-j).
    pub(crate) fn chain(n: usize, gain: &BigRational, part: &BigRational) -> Self {
        let inverse = |k: usize| BigRational::one() / factorial(k);
        let phi =
            Matrix::new(n, n, |i, j| if j >= i { inverse(j - i) } else { BigRational::zero() });
        let gamma = (0..n).map(|i| gain * inverse(n - i)).collect();
        let rest = BigRational::one() - part;
        let newer = (0..n).map(|i| gain * inverse(n - i) * num_traits::pow(rest.clone(), n - i));
        Self {
            phi,
            gamma,
            newer: newer.collect(),
            powers: (1..=n).rev().map(|power| i64::try_from(power).unwrap_or(i64::MAX)).collect(),
        }
    }

    /// x' = A x + B u, sampled with period `h`, where the next input takes over after `part` of the
    /// sample; `None` if the period is too long for its modes.
    pub(crate) fn linear(plant: &Linear, h: &BigRational, part: &BigRational) -> Option<Self> {
        let n = plant.b.len();
        let newer = match part.is_one() {
            true => vec![BigRational::zero(); n],
            false => {
                Self::linear(plant, &(h * (BigRational::one() - part)), &BigRational::one())?.gamma
            }
        };
        let entry = |i: usize, j: usize| match (i < n, j < n) {
            (true, true) => &plant.a[i][j] * h,
            (true, false) => &plant.b[i] * h,
            (false, _) => BigRational::zero(),
        };
        let whole = exponential(&Matrix::new(n + 1, n + 1, entry))?;
        Some(Self {
            phi: Matrix::new(n, n, |i, j| whole.at(i, j).clone()),
            gamma: (0..n).map(|i| whole.at(i, n).clone()).collect(),
            newer,
            powers: vec![0; n],
        })
    }

    /// Number of states.
    pub(crate) fn order(&self) -> usize {
        self.gamma.len()
    }

    /// Phi in the units of the states, for a period `h`.
    pub(crate) fn in_units(&self, h: &BigRational) -> Matrix {
        let entry = |i: usize, j: usize| {
            self.phi.at(i, j) * power_of_period(h, self.powers[i] - self.powers[j])
        };
        Matrix::new(self.order(), self.order(), entry)
    }

    /// The same with a delay in which `inputs` of earlier samples act or are under way; its states
    /// are x, u_{k-1}, ..., u_{k-inputs}, the oldest of which acts first.
    #[must_use]
    pub(crate) fn delayed(&self, inputs: usize) -> Self {
        let (n, order) = (self.order(), self.order() + inputs);
        if inputs == 0 {
            return self.clone();
        }
        // Where the input of age a, in samples, is kept.
        let kept = |age: usize| n + age - 1;
        let entry = |i: usize, j: usize| {
            if i < n && j < n {
                self.phi.at(i, j).clone()
            } else if i < n && j == kept(inputs) {
                &self.gamma[i] - &self.newer[i]
            } else if i < n && inputs > 1 && j == kept(inputs - 1) {
                self.newer[i].clone()
            } else if i > n && j + 1 == i {
                BigRational::one()
            } else {
                BigRational::zero()
            }
        };
        let unit = |i: usize| match i {
            i if i < n && inputs == 1 => self.newer[i].clone(),
            i if i == n => BigRational::one(),
            _ => BigRational::zero(),
        };
        let powers = (0..order).map(|i| self.powers.get(i).copied().unwrap_or(0)).collect();
        Self {
            phi: Matrix::new(order, order, entry),
            gamma: (0..order).map(unit).collect(),
            newer: vec![BigRational::zero(); order],
            powers,
        }
    }

    /// The same over `part` of the sample, of a chain.
    #[must_use]
    pub(crate) fn over(&self, part: &BigRational) -> Self {
        let scale = |power: i64| num_traits::pow(part.clone(), usize::try_from(power).unwrap_or(0));
        let (n, powers) = (self.order(), &self.powers);
        let entry = |i: usize, j: usize| self.phi.at(i, j) * scale(powers[i] - powers[j]);
        Self {
            phi: Matrix::new(n, n, entry),
            gamma: (0..n).map(|i| &self.gamma[i] * scale(powers[i])).collect(),
            newer: vec![BigRational::zero(); n],
            powers: powers.clone(),
        }
    }

    /// The states at the time from which the input of now acts, by the states of [`delayed`](Self::delayed); `part` is
    /// the plant over the part of a sample in which the oldest input acts.
    pub(crate) fn predicted(&self, inputs: usize, part: &Self) -> Matrix {
        let n = self.order();
        let late = self.delayed(inputs).phi;
        let all = (1..inputs).fold(Matrix::identity(n + inputs), |all, _| late.times(&all));
        // The input of the last sample is the oldest by then.
        let last = n + inputs - 1;
        Matrix::new(n, n + inputs, |i, j| {
            let moved = (0..n).map(|k| part.phi.at(i, k) * all.at(k, j));
            moved.sum::<BigRational>() + &part.gamma[i] * all.at(last, j)
        })
    }

    /// D = Phi - 1.
    pub(crate) fn step(&self) -> Matrix {
        self.phi.plus(&-BigRational::one(), &Matrix::identity(self.order()))
    }

    /// The rows of S and the drift a with z = S x, Delta z_i = z_{i+1}, Delta z_m = u + sum a_i z_i;
    /// `None` if the pair is not controllable.
    pub(crate) fn flat(&self) -> Option<(Matrix, Vec<BigRational>)> {
        let (order, step) = (self.order(), self.step());
        let mut columns = vec![self.gamma.clone()];
        while columns.len() < order {
            let next = step.on(&columns[columns.len() - 1]);
            columns.push(next);
        }
        // c D^i Gamma is 0 for i < m - 1, and 1 for i = m - 1.
        let unit: Vec<_> = (1..=order)
            .map(|i| if i == order { BigRational::one() } else { BigRational::zero() })
            .collect();
        let mut rows = vec![Matrix::of(columns).solve(&unit)?];
        while rows.len() <= order {
            let next = step.after_row(&rows[rows.len() - 1]);
            rows.push(next);
        }
        let last = rows.pop()?;
        let s = Matrix::of(rows);
        let drift = s.transpose().solve(&last)?;
        Some((s, drift))
    }
}

/// A plant over a sample in which its input is held: x(t + h) = Phi x(t) + Gamma u.
#[derive(Clone, Debug)]
pub(crate) struct ZeroOrderHold {
    /// Phi, by rows.
    pub(crate) phi: Vec<Vec<BigRational>>,
    /// The part of Gamma that is due to the oldest input that acts.
    pub(crate) older: Vec<BigRational>,
    /// The part that is due to the input that takes over from it within the sample.
    pub(crate) newer: Vec<BigRational>,
}

/// A plant over a sample; `None` where a mode is too fast for `h`.
pub(crate) fn zero_order_hold(
    plant: &Linear,
    h: &BigRational,
    delay: &Delay,
) -> Option<ZeroOrderHold> {
    let pair = Pair::linear(plant, h, &delay.part())?;
    let n = pair.order();
    let row = |i: usize| (0..n).map(|j| pair.phi.at(i, j).clone()).collect();
    let older = pair.gamma.iter().zip(&pair.newer).map(|(all, newer)| all - newer).collect();
    Some(ZeroOrderHold { phi: (0..n).map(row).collect(), older, newer: pair.newer })
}

/// h to a power of either sign.
pub(crate) fn power_of_period(h: &BigRational, power: i64) -> BigRational {
    let size = usize::try_from(power.unsigned_abs()).unwrap_or(0);
    let size = num_traits::pow(h.clone(), size);
    if power < 0 { BigRational::one() / size } else { size }
}

/// k!.
pub(crate) fn factorial(k: usize) -> BigRational {
    BigRational::from_integer(factorials(k).swap_remove(k))
}

/// The binomial coefficient of `n` over `k`.
pub(crate) fn binomial(n: usize, k: usize) -> BigRational {
    if k > n { BigRational::zero() } else { factorial(n) / (factorial(k) * factorial(n - k)) }
}
