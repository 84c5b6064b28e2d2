//! Margins of the loop of a regulator and its plant: written as a matrix, column by column, by the steps that run.

use nalgebra::{Complex, DMatrix, DVector, Schur};

use super::nominal::Nominal;
use super::regulator::Regulator;
use super::target::Target;
use crate::check::sampled::{Margin, margin_of};
use crate::program::range::Range;

/// Frequencies at which the sensitivity is computed, and the lowest one in rad per sample.
const FREQUENCIES: usize = 400;
const LOWEST: f64 = 1e-4;

/// Most steps of an eigenvalue iteration.
const STEPS: usize = 1000;

/// Most doublings of a sum over samples.
const DOUBLINGS: usize = 64;

/// A regulator around its plant, to which a test signal is added at the plant's input.
pub(super) struct Loop<'a> {
    nominal: &'a Nominal,
    regulator: &'a dyn Regulator,
}

/// The loop from sample to sample: s+ = A s + B r, and the input that acts is C s + r. The regulator gives D s.
struct Closed {
    a: DMatrix<f64>,
    b: DVector<f64>,
    c: DVector<f64>,
    d: DVector<f64>,
}

/// State and u of a loop after one sample.
struct Response {
    state: DVector<f64>,
    u: f64,
}

impl<'a> Loop<'a> {
    /// Returns the loop of a regulator.
    pub(super) fn new(nominal: &'a Nominal, regulator: &'a dyn Regulator) -> Self {
        Self { nominal, regulator }
    }

    /// The loop with a true input gain of `gain` times the known one, that acts `more` samples later.
    fn closed(&self, gain: f64, more: usize) -> Closed {
        let Self { nominal, regulator } = self;
        let (n, late) = (nominal.order(), nominal.delay + more);
        let size = n + late + regulator.order();
        let rest = Target::rest(n);
        let mut a = DMatrix::zeros(size, size);
        let (mut c, mut d) = (DVector::zeros(size), DVector::zeros(size));
        for column in 0..size {
            let mut state = vec![0.0; size];
            state[column] = 1.0;
            let (x, rest_of_state) = state.split_at_mut(n);
            let (under_way, kept) = rest_of_state.split_at_mut(late);
            let x = DVector::from_row_slice(x);
            let y = &nominal.c * &x;
            let u = regulator.step(kept, y.as_slice(), &rest, Range::ALL);
            let acts = Nominal::acting(under_way, u);
            (c[column], d[column]) = (gain * acts, u);
            let next = &nominal.phi * x + &nominal.gamma * (gain * acts);
            state[..n].copy_from_slice(next.as_slice());
            a.set_column(column, &DVector::from_vec(state));
        }
        let mut b = DVector::zeros(size);
        b.rows_mut(0, n).copy_from(&nominal.gamma);
        Closed { a, b, c, d }
    }

    /// Returns the modulus margin, the least distance of the open loop from -1; 0 where the loop is not stable.
    pub(super) fn modulus(&self) -> f64 {
        let closed = self.closed(1.0, 0);
        if !closed.is_stable() {
            return 0.0;
        }
        let ratio = (std::f64::consts::PI / LOWEST).ln();
        let angle = |i: usize| LOWEST * (ratio * i as f64 / (FREQUENCIES - 1) as f64).exp();
        let most = (0..FREQUENCIES).filter_map(|i| closed.sensitivity(angle(i)));
        1.0 / most.fold(0.0, f64::max)
    }

    /// Returns the standard deviation of u from the errors of the sensors, taken as white noise; infinite where the loop
    /// is not stable.
    pub(super) fn noise(&self) -> f64 {
        let closed = self.closed(1.0, 0);
        if !closed.is_stable() {
            return f64::INFINITY;
        }
        let all = self.nominal.noise.iter().enumerate();
        let all = all.map(|(j, variance)| variance * closed.variance(&self.of_sensor(j)));
        all.sum::<f64>().sqrt()
    }

    /// The response to a sample in which one measured value is 1 and all else is 0.
    fn of_sensor(&self, j: usize) -> Response {
        let Self { nominal, regulator } = self;
        let (n, late) = (nominal.order(), nominal.delay);
        let mut y = vec![0.0; nominal.c.nrows()];
        y[j] = 1.0;
        let mut state = DVector::zeros(n + late + regulator.order());
        let kept = &mut state.as_mut_slice()[n + late..];
        let u = regulator.step(kept, &y, &Target::rest(n), Range::ALL);
        match late {
            0 => state.rows_mut(0, n).axpy(u, &nominal.gamma, 1.0),
            _ => state[n + late - 1] = u,
        }
        Response { state, u }
    }

    /// Returns the input gains and the samples of delay with which it is stable; `None` if it is not stable as it is.
    pub(super) fn margin(&self) -> Option<Margin> {
        margin_of(&|gain, more| self.closed(gain, more).is_stable())
    }
}

impl Closed {
    fn is_stable(&self) -> bool {
        let schur = Schur::try_new(self.a.clone(), f64::EPSILON, STEPS);
        schur.is_some_and(|own| own.complex_eigenvalues().iter().all(|z| z.norm() < 1.0))
    }

    /// Sum of the squares of u from a sample on, over all samples, by doubling.
    fn variance(&self, response: &Response) -> f64 {
        let Response { state, u } = response;
        let (mut step, mut sum) = (self.a.clone(), state * state.transpose());
        for _ in 0..DOUBLINGS {
            let more = &step * &sum * step.transpose();
            let is_settled = more.norm() <= f64::EPSILON * sum.norm();
            sum += more;
            if is_settled {
                break;
            }
            step = &step * &step;
        }
        (self.d.transpose() * sum * &self.d)[0] + u * u
    }

    /// |S| at an angle in rad per sample; `None` at a pole of S.
    fn sensitivity(&self, angle: f64) -> Option<f64> {
        let size = self.b.len();
        let z = Complex::from_polar(1.0, angle);
        let system = DMatrix::from_fn(size, size, |i, j| {
            Complex::from(-self.a[(i, j)]) + if i == j { z } else { Complex::from(0.0) }
        });
        let moved = system.lu().solve(&self.b.map(Complex::from))?;
        let back: Complex<f64> = self.c.iter().zip(&moved).map(|(c, x)| x * *c).sum();
        Some((back + 1.0).norm())
    }
}
