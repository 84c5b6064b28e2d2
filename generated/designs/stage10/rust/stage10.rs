//! Prescribed-time controller stage10: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1.3)" --name stage10 --clock samples --deadbeat=20 --precision f32 --eps=0
//! Version 0.1.0, design 53d11c790cfa.
//!
//! Plant: x1' = x2, x2' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end, with 20
//!       samples to go deadbeat takes over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1.3 [1/s], fixed: rate of stretched time
//!   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat = 20 [samples], fixed: samples to go at which deadbeat takes over, 0 for a safe
//!       default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
pub struct Control<R = f32> {
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

/// Run-time parameters of [`Stage10`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage10Params {
    /// samples N from the start to rest \[samples\], at least 2.
    pub samples: u32,
    /// sample period \[s\], from 1e-18 to 1e18.
    pub h: f32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^2\], finite.
    pub k: [f32; 2],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage10 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// weight of x1 in the law.
    w1_1: f32,
    /// weight of x2 in the law.
    w1_2: f32,
    /// weight of x2 in the law.
    w2_2: f32,
    /// weight of x1 in the law.
    b_1: f32,
    /// weight of x2 in the law.
    b_2: f32,
    /// bound of |u|.
    u_max: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage10 {
    /// Samples to go at which deadbeat takes over.
    const DEADBEAT: f32 = 20.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage10Params) -> Result<Self, Error> {
        if !((params.samples > 1)
            && (1e-18 <= params.h)
            && (params.h <= 1e18)
            && (params.u_max > 0.0)
            && params.k[0].is_finite()
            && params.k[1].is_finite())
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let w1_1 = (-(params.k[0] / 1.69)) * (1.0 / (params.h * params.h));
        let w1_2 = (-0.5) * (-(params.k[0] / 1.69)) * (1.0 / params.h);
        let w2_2 = (1.0 - (params.k[1] / 1.3)) * (1.0 / params.h);
        let b_1 = -(1.0 / (params.h * params.h));
        let b_2 = (-1.5) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(w1_1.is_finite()
            && w1_2.is_finite()
            && w2_2.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && (params.h * params.h >= 1e-30)
            && (1.0 / (params.h * params.h) >= 1e-30))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            w1_1,
            w1_2,
            w2_2,
            b_1,
            b_2,
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
    pub fn step(&self, k: u32, x: &[f32; 2]) -> Result<Control<f32>, Error> {
        if !(x[0].is_finite() && x[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f32;
        let v: f32;
        if m0 > Self::DEADBEAT {
            // The exact law in samples.
            let z1 = (self.w1_1 * x1) + (self.w1_2 * x2);
            let z2 = self.w2_2 * x2;
            v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
        } else {
            // Deadbeat.
            v = (self.b_1 * x1) + (self.b_2 * x2);
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
