//! Bounds of the effect that rounded constants have on the chains that held inputs move.
//!
//! With the constants as they are kept, xi moves from sample to sample as the chains do, and by J beside that: a
//! residual of these constants and of Phi and Gamma, which are known to so many bits. A chain can be brought
//! back from J by its input within as many samples as it has states. So there are chains eta that differ from xi by
//! what the last of these J do, which are moved by v and a force: J is no more than an error of xi as it is
//! measured, and a force.

use num_traits::One;

use super::{Chains, Several, sizes};
use crate::algebra::BigRational;
use crate::linear::{Matrix, Pair, binomial};

/// Bounds of J by what it comes from, and of what it does.
pub(crate) struct Left {
    /// Weights of the sizes of the states.
    of_states: Matrix,
    /// Weights of the sizes of v.
    of_wanted: Matrix,
    /// Weights of the sizes of u - G^-1 (v - F x).
    of_errors: Matrix,
    /// Weights of the sizes of u.
    of_inputs: Matrix,
    /// Distance of xi from eta by J.
    apart: Matrix,
    /// The force on each chain by J.
    forces: Matrix,
}

/// Bounds of what moves the states in a sample.
pub(crate) struct Moving<'a> {
    pub(crate) states: &'a [BigRational],
    pub(crate) wanted: &'a [BigRational],
    /// Sizes of u - G^-1 (v - F x).
    pub(crate) errors: &'a [BigRational],
    pub(crate) inputs: &'a [BigRational],
}

impl Left {
    /// Returns the bounds of chains moved by inputs that are held for `h`; `None` where a mode is too fast for it, or G
    /// is singular.
    pub(crate) fn new(plant: &Several, h: &BigRational, chains: &Chains) -> Option<Self> {
        let n = plant.states();
        let held = plant.held(h)?;
        let minus = -BigRational::one();
        let xi = Matrix::of(chains.coordinates.clone());
        let inverse = Matrix::of(chains.inverse.clone());
        let of_drift = inverse.times(&Matrix::of(chains.drift.clone()));
        let (phi, gamma) = of_chains(&plant.orders, h);
        let reached = xi.times(&held.gamma);
        let moved = xi.times(&held.phi).plus(&minus, &reached.times(&of_drift));
        let around = sizes(&xi).times(&plant.off(h));
        let part = |from: usize, count: usize| {
            Matrix::new(n, count, |i, j| around.at(i, from + j).clone())
        };
        let one = BigRational::one();
        let of_states = sizes(&moved.plus(&minus, &phi.times(&xi))).plus(&one, &part(0, n));
        let of_wanted = sizes(&reached.times(&inverse).plus(&minus, &gamma));
        let of_errors = sizes(&reached.plus(&minus, &gamma.times(&inverse.inverse()?)));
        let of_inputs = part(n, plant.orders.len());
        let (apart, forces) = brought_back(&plant.orders, h)?;
        Some(Self { of_states, of_wanted, of_errors, of_inputs, apart, forces })
    }

    /// Bounds the distance of each xi from eta, and the force on each chain.
    pub(crate) fn bounds(&self, moving: &Moving<'_>) -> (Vec<BigRational>, Vec<BigRational>) {
        let parts = [
            self.of_states.on(moving.states),
            self.of_wanted.on(moving.wanted),
            self.of_errors.on(moving.errors),
            self.of_inputs.on(moving.inputs),
        ];
        let all = |i: usize| parts.iter().map(|part| &part[i]).sum::<BigRational>();
        let jump: Vec<_> = (0..self.apart.len()).map(all).collect();
        (self.apart.on(&jump), self.forces.on(&jump))
    }
}

/// Phi and Gamma of all chains.
fn of_chains(orders: &[usize], h: &BigRational) -> (Matrix, Matrix) {
    let n = orders.iter().sum();
    let (mut phi, mut gamma) = (rows(n, n), rows(n, orders.len()));
    let mut from = 0;
    for (k, order) in orders.iter().enumerate() {
        let one = BigRational::one();
        let pair = Pair::chain(*order, &one, &one);
        for i in 0..*order {
            for j in i..*order {
                phi[from + i][from + j] = pair.phi.at(i, j) * num_traits::pow(h.clone(), j - i);
            }
            gamma[from + i][k] = &pair.gamma[i] * num_traits::pow(h.clone(), order - i);
        }
        from += order;
    }
    (Matrix::of(phi), Matrix::of(gamma))
}

/// Returns the effect of deadbeat, K, on J: sum |(Phi - Gamma K)^j| over the samples that it takes, and |K| times that.
fn brought_back(orders: &[usize], h: &BigRational) -> Option<(Matrix, Matrix)> {
    let n = orders.iter().sum();
    let (mut apart, mut forces) = (rows(n, n), rows(orders.len(), n));
    let mut from = 0;
    for (k, order) in orders.iter().copied().enumerate() {
        let one = BigRational::one();
        let pair = Pair::chain(order, &one, &one);
        let (s, _) = pair.flat()?;
        let gains: Vec<_> = (0..order).map(|j| binomial(order, j)).collect();
        let gains = s.after_row(&gains);
        let closed =
            Matrix::new(order, order, |i, j| pair.phi.at(i, j) - &pair.gamma[i] * &gains[j]);
        let mut power = Matrix::identity(order);
        let mut sum = sizes(&power);
        for _ in 1..order {
            power = power.times(&closed);
            sum = sum.plus(&one, &sizes(&power));
        }
        let gains = Matrix::of(vec![gains]);
        let force = sizes(&gains).times(&sum);
        for i in 0..order {
            for j in 0..order {
                let unit = num_traits::pow(h.clone(), i.abs_diff(j));
                let own = sum.at(i, j);
                apart[from + i][from + j] = if j >= i { own * unit } else { own / unit };
            }
            forces[k][from + i] = force.at(0, i) / num_traits::pow(h.clone(), order - i);
        }
        from += order;
    }
    Some((Matrix::of(apart), Matrix::of(forces)))
}

fn rows(count: usize, columns: usize) -> Vec<Vec<BigRational>> {
    vec![vec![BigRational::default(); columns]; count]
}

#[cfg(test)]
mod tests {
    use num_traits::Zero;

    use super::*;
    use crate::algebra::integer;

    /// Deadbeat brings every chain back in as many samples as it has states.
    #[test]
    fn deadbeat_removes_a_jump_in_order_many_samples() {
        for order in 1..=4 {
            let one = BigRational::one();
            let pair = Pair::chain(order, &one, &one);
            let (s, _) = pair.flat().expect("a chain");
            let gains: Vec<_> = (0..order).map(|j| binomial(order, j)).collect();
            let gains = s.after_row(&gains);
            let entry = |i: usize, j: usize| pair.phi.at(i, j) - &pair.gamma[i] * &gains[j];
            let closed = Matrix::new(order, order, entry);
            let power = (1..order).fold(closed.clone(), |power, _| power.times(&closed));
            assert!((0..order * order).all(|at| power.at(at / order, at % order).is_zero()));
        }
    }

    /// Expects only the last digits of a plant that is two chains, and the error of a wrong row.
    #[test]
    fn wrong_constants_leave_their_error() {
        let number = |rows: &[&[i64]]| -> Vec<Vec<BigRational>> {
            rows.iter().map(|row| row.iter().map(|v| integer(*v)).collect()).collect()
        };
        let plant = Several {
            a: number(&[&[0, 1, 0], &[-2, -1, 1], &[1, 0, -1]]),
            b: number(&[&[0, 0], &[1, 0], &[1, 2]]),
            c: number(&[&[1, 0, 0], &[0, 0, 1]]),
            orders: vec![2, 1],
        };
        let h = BigRational::new(1.into(), 10.into());
        let chains = plant.chains(&h, crate::parameter::Precision::F64).expect("chains");
        let ones = vec![integer(1); 3];
        let moving =
            Moving { states: &ones, wanted: &ones[..2], errors: &ones[..2], inputs: &ones[..2] };
        let most = |chains: &Chains| {
            let left = Left::new(&plant, &h, chains).expect("bounds");
            left.bounds(&moving).0.into_iter().max().expect("three")
        };
        let tiny = crate::linear::exponential::power(-140);
        assert!(most(&chains) < tiny, "{}", most(&chains));
        for place in 0..3 {
            let mut wrong = chains.clone();
            wrong.coordinates[1][place] += BigRational::new(1.into(), 1000.into());
            assert!(most(&wrong) > BigRational::new(1.into(), 100_000.into()));
            let mut wrong = chains.clone();
            wrong.drift[0][place] += BigRational::new(1.into(), 1000.into());
            assert!(most(&wrong) > BigRational::new(1.into(), 1_000_000.into()));
        }
    }
}
