//! Profiles from a state to rest at 0.

mod jerk_limited;

use nalgebra::{DMatrix, DVector};

use super::nominal::Nominal;
use super::target::Target;
pub(super) use jerk_limited::{JerkLimited, duration};

/// The plant as a chain: its flat output z with n derivatives.
#[derive(Clone, Debug)]
pub struct Flat {
    /// Rows c, c A, ..., c A^(n-1) of z, ..., z^(n-1) by x.
    rows: DMatrix<f64>,
    /// x by z, ..., z^(n-1).
    states: DMatrix<f64>,
    /// c A^n: z^(n) = u + c A^n x.
    drift: DMatrix<f64>,
}

impl Flat {
    /// Returns the coordinates of a plant; `None` where it is not controllable.
    pub fn of(nominal: &Nominal) -> Option<Self> {
        let (a, b) = &nominal.rates;
        let n = b.len();
        let mut columns = vec![b.clone()];
        for _ in 1..n {
            columns.push(a * columns.last()?);
        }
        let inverse = DMatrix::from_columns(&columns).try_inverse()?;
        let mut rows = vec![inverse.row(n - 1).clone_owned()];
        for _ in 0..n {
            rows.push(rows.last()? * a);
        }
        let drift = DMatrix::from_row_slice(1, n, rows.pop()?.as_slice());
        let rows = DMatrix::from_rows(&rows);
        Some(Self { states: rows.clone().try_inverse()?, rows, drift })
    }

    /// State and input where z has these derivatives, n + 1 of them.
    fn state_and_input(&self, z: &DVector<f64>) -> (DVector<f64>, f64) {
        let n = self.rows.nrows();
        let x = &self.states * z.rows(0, n);
        let u = z[n] - (&self.drift * &x)[0];
        (x, u)
    }
}

/// A way to rest.
#[derive(Clone, Debug)]
pub(super) enum Profile {
    /// A polynomial of the time that is left.
    Polynomial(Polynomial),
    /// Segments of constant jerk.
    JerkLimited(Box<JerkLimited>),
}

/// Kind of profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The polynomial of degree 2n + 1 that begins and ends with the input 0 it needs at rest: for a chain of order 2
    /// the quintic of minimum jerk.
    Polynomial,
    /// A third of the time each to accelerate, coast and brake, with limited jerk.
    JerkLimited,
    /// The shortest one with the limits of u, in the part of them that the design plans with.
    Soonest,
}

impl Profile {
    /// Returns the profile of a shape from the state `x` to rest: in `length` seconds, or with |u| up to `limit`; `None`
    /// where there is none.
    pub(super) fn new(
        shape: Shape,
        flat: &Flat,
        x: &DVector<f64>,
        (length, limit): (f64, f64),
    ) -> Option<Self> {
        let found = match shape {
            Shape::Polynomial => return Polynomial::new(flat, x, length).map(Self::Polynomial),
            Shape::JerkLimited => JerkLimited::new(x.as_slice(), length)?,
            // z of a chain is x_1 in parts of the gain.
            Shape::Soonest => {
                JerkLimited::soonest(x.as_slice(), limit * flat.states[(0, 0)].abs())?
            }
        };
        Some(Self::JerkLimited(Box::new(found)))
    }

    /// Its length in s.
    pub(super) fn length(&self) -> f64 {
        match self {
            Self::Polynomial(own) => own.length,
            Self::JerkLimited(own) => own.length(),
        }
    }

    /// z and its n derivatives, `t` seconds after the start; that at the start before it.
    fn derivatives(&self, flat: &Flat, t: f64) -> DVector<f64> {
        match self {
            Self::Polynomial(own) => own.at(t),
            Self::JerkLimited(own) => {
                let n = flat.rows.nrows();
                let (x, last) = own.at(t.max(0.0));
                // z of a chain is x_1 in parts of the gain.
                let gain = flat.states[(0, 0)];
                DVector::from_fn(n + 1, |i, _| if i < n { x[i] } else { last } / gain)
            }
        }
    }

    /// Returns the target of sample `k` of a plant with a delay, of a profile that begins when the first input acts.
    pub(super) fn target(&self, flat: &Flat, nominal: &Nominal, k: f64) -> Target {
        let (h, delay) = (nominal.h, nominal.delay as f64);
        let at = |samples: f64| flat.state_and_input(&self.derivatives(flat, samples * h));
        let state = |samples: f64| at(samples).0.component_div(&nominal.units);
        Target { now: state(k - delay), later: state(k), u: at(k + 0.5).1 }
    }
}

/// z as a polynomial of time-to-go with a zero of order n + 1 at its end.
#[derive(Clone, Debug)]
pub(super) struct Polynomial {
    length: f64,
    /// Coefficients of the powers n + 1 to 2 n + 1 of the part of the time that is left.
    coefficients: DVector<f64>,
}

impl Polynomial {
    /// Returns the polynomial from the state `x`, at which the input is 0.
    fn new(flat: &Flat, x: &DVector<f64>, length: f64) -> Option<Self> {
        let n = flat.rows.nrows();
        let of_z = &flat.rows * x;
        let last = (&flat.drift * x)[0];
        let scale = |i: usize| (-length).powi(i32::try_from(i).unwrap_or(i32::MAX));
        let start = DVector::from_fn(n + 1, |i, _| scale(i) * if i < n { of_z[i] } else { last });
        let system = DMatrix::from_fn(n + 1, n + 1, |i, j| falling(n + 1 + j, i));
        let coefficients = system.lu().solve(&start)?;
        Some(Self { length, coefficients })
    }

    fn at(&self, t: f64) -> DVector<f64> {
        let count = self.coefficients.len();
        let share = (1.0 - t / self.length).clamp(0.0, 1.0);
        DVector::from_fn(count, |i, _| {
            let sum: f64 = (0..count)
                .map(|j| {
                    let power = count + j;
                    let left = i32::try_from(power - i).unwrap_or(i32::MAX);
                    self.coefficients[j] * falling(power, i) * share.powi(left)
                })
                .sum();
            sum / (-self.length).powi(i32::try_from(i).unwrap_or(i32::MAX))
        })
    }
}

/// power (power - 1) ... with `count` factors.
fn falling(power: usize, count: usize) -> f64 {
    (0..count).map(|i| (power - i) as f64).product()
}
