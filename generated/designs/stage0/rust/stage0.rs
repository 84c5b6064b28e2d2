//! Prescribed-time controller stage0: order n = 1, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 1 --mu exp --name stage0 --clock samples --eps=0
//! Version 0.1.0, design 14ec59d52490.
//!
//! Plant: x1' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^1 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-0));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
//!   loop: not checked: `samples` is left to run time.
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

/// Run-time parameters of [`Stage0`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage0Params {
    /// samples N from the start to rest \[samples\], at least 1.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time \[1/s\], from 1e-150 to 1e150.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s\], finite.
    pub k: [f64; 1],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage0 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// samples to go at which deadbeat takes over.
    deadbeat: f64,
    /// weight of x1 in the law.
    w1_1: f64,
    /// weight of x1 in the law.
    b_1: f64,
    /// bound of |u|.
    u_max: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage0 {
    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage0Params) -> Result<Self, Error> {
        if !((params.samples > 0)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && (params.u_max > 0.0)
            && (1e-150 <= params.a)
            && (params.a <= 1e150)
            && params.k[0].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = (params.k[0] / params.a) + 1.0;
        let s2 = if s1 < 2.0 { 2.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1 = (-(params.k[0] / params.a)) * (1.0 / params.h);
        let b_1 = -(1.0 / params.h);
        let u_max = params.u_max;
        if !(deadbeat.is_finite()
            && w1_1.is_finite()
            && b_1.is_finite()
            && (params.h >= 1e-200)
            && (1.0 / params.h >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            deadbeat,
            w1_1,
            b_1,
            u_max,
        })
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
    pub fn step(&self, k: u32, x: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !x[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f64;
        let v: f64;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let z1 = self.w1_1 * x1;
            v = z1 / m0;
        } else {
            // Deadbeat.
            v = self.b_1 * x1;
        }
        let (u, status) = if v.is_finite() {
            if v > self.u_max {
                (self.u_max, Status::Saturated)
            } else if v < -self.u_max {
                (-self.u_max, Status::Saturated)
            } else if elapsed < self.samples {
                (v, Status::Ok)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
