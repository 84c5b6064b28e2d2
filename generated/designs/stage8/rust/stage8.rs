//! Prescribed-time controller stage8: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage8 --clock samples --tau=0.03 --eps=0.005 --u-max=3 --poles=-4,-5 --after zero --sample-time=1e-3
//! Version 0.1.0, design 2d9dd723208a.
//!
//! Plant: x1' = x2, x2' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, u h^2 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. The
//!       gains of 5 samples to go stay.
//!
//! Parameters:
//!   samples = 30 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.005 [s], fixed: time-to-go at which the gains are held
//!   u_max = 3 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on u = 0 (status AFTER).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 30, not at rest: the gains are held from 5 samples to
//!       go, and |u| is bounded.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: it does not examine a clock in samples.
//! ```
#![forbid(unsafe_code)]

/// Status of a valid u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking: u is that of the law.
    Ok,
    /// Time-to-go is held at eps: the deadline is near or over.
    Hold,
    /// u was clipped to its limits; wins over `Hold` and `After`.
    Saturated,
    /// The deadline is over: u is 0 or that of the user-defined law.
    After,
    /// A reading was not believed: u by prediction alone; wins over all above.
    Gated,
    /// The deadline was put off, as a limit would have been exceeded.
    Late,
    /// The bounds of a filter cannot be kept from here: u is the nearest to them.
    Infeasible,
}

/// Result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f64> {
    /// Input of the plant.
    pub u: R,
    /// Its status.
    pub status: Status,
}

/// Why there is no controller, or no u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A parameter is outside its domain, or the coefficients derived from it leave the range.
    Param,
    /// x or t is not finite, or t lies before the start.
    Input,
    /// u is not finite.
    Range,
    /// A deadline is too soon for the limits, or none keeps them.
    Soon,
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Param => "a parameter is outside its domain",
            Self::Input => "x or t is not finite, or t is before t0",
            Self::Range => "u is not finite",
            Self::Soon => "no deadline so soon keeps the limits",
        })
    }
}

impl core::error::Error for Error {}

/// A controller of a chain of N integrators.
pub trait Controller<const N: usize> {
    /// Floating-point type.
    type Real;

    /// Starts again at `t0`, in s.
    ///
    /// # Errors
    /// `Param`: `t0` is not finite.
    fn arm(&mut self, t0: Self::Real) -> Result<(), Error>;

    /// u at time `t`, in s, and state `x`.
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not legal. `Range`: u is not finite.
    fn step(&self, t: Self::Real, x: &[Self::Real; N]) -> Result<Control<Self::Real>, Error>;
}

/// Run-time parameters of [`Stage8`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage8Params {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage8 {
    /// tick at which it was armed.
    start: u32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage8 {
    /// Samples from the start to rest.
    const SAMPLES: u32 = 30;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 5.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -20000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = 10000.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -8000.0;
    /// Bound of |u|.
    const U_MAX: f64 = 3.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage8Params) -> Result<Self, Error> {
        Ok(Self { start: 0 })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite() && x[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let m0 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let v: f64;

        // The exact law in samples.
        let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2);
        let z2 = Self::W2_2 * x2;
        let m0f1 = m0 + 3.0;
        v = (z1 + (z2 * m0f1)) / (m0f1 * (m0 + 2.0));
        let (u, status) = if v.is_finite() {
            if elapsed < Self::SAMPLES {
                if v > Self::U_MAX {
                    (Self::U_MAX, Status::Saturated)
                } else if v < -Self::U_MAX {
                    (-Self::U_MAX, Status::Saturated)
                } else if (left as f64) <= Self::HOLD {
                    (v, Status::Hold)
                } else {
                    (v, Status::Ok)
                }
            } else {
                (0.0, Status::After)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
