//! Prescribed-time controller stage34: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --axes 2 --mu exp --name stage34 --clock samples --guard none --eps=0 --g="3" --reference input
//! Version 0.1.0, design 0d8dd7fc9d15.
//!
//! Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//! With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
//!       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
//!       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
//! Row i of r is of axis i, of order n: in its places 0..n-1 the reference and its derivatives
//!       at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean,
//!       (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
//! Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard none: finite measurements and references are the responsibility of the caller.
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what r does between samples,
//!       whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
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

/// Result of a step of several axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f64> {
    /// Inputs of the plants; 0 where `status` is an error.
    pub u: [R; M],
    /// Status of each axis.
    pub axes: [Result<Status, Error>; M],
    /// The error of the first axis that fails; else `Saturated` where one is, else that of the gains.
    pub status: Result<Status, Error>,
}

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

/// Run-time parameters of [`Stage34`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage34Params {
    /// samples N from the start to rest \[samples\], at least 3.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time \[1/s\], from 1e-150 to 1e150.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^3\], finite.
    pub k: [f64; 3],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage34 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// samples to go at which deadbeat takes over.
    deadbeat_1: f64,
    /// weight of x1 in the law.
    w1_1_1: f64,
    /// weight of x2 in the law.
    w1_2_1: f64,
    /// weight of x3 in the law.
    w1_3_1: f64,
    /// weight of x2 in the law.
    w2_2_1: f64,
    /// weight of x3 in the law.
    w2_3_1: f64,
    /// weight of x3 in the law.
    w3_3_1: f64,
    /// weight of x1 in the law.
    b_1_1: f64,
    /// weight of x2 in the law.
    b_2_1: f64,
    /// weight of x3 in the law.
    b_3_1: f64,
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
impl Stage34 {
    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage34Params) -> Result<Self, Error> {
        if !((params.samples > 2)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && (params.u_max > 0.0)
            && (1e-150 <= params.a)
            && (params.a <= 1e150)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = ((params.k[2] / params.a) - 4.0) + 3.0;
        let s2 = if s1 < 6.0 { 6.0 } else { s1 };
        let deadbeat_1 = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let s3 = -(params.k[0] / (params.a * params.a * params.a));
        let s4 = 1.0 / (params.h * params.h * params.h);
        let w1_1_1 = 0.3333333333333333 * s3 * s4;
        let s5 = -(params.k[0] / (params.a * params.a * params.a));
        let w1_2_1 = (-0.3333333333333333) * s5 * (1.0 / (params.h * params.h));
        let s6 = -(params.k[0] / (params.a * params.a * params.a));
        let w1_3_1 = 0.1111111111111111 * s6 * (1.0 / params.h);
        let s7 = (-1.0) - (params.k[1] / (params.a * params.a));
        let s8 = 0.3333333333333333 * (s7 + (params.k[2] / params.a));
        let w2_2_1 = s8 * (1.0 / (params.h * params.h));
        let s9 = (-1.0) - (params.k[1] / (params.a * params.a));
        let s10 = (-0.16666666666666666) * (s9 + (params.k[2] / params.a));
        let w2_3_1 = s10 * (1.0 / params.h);
        let s11 = 0.3333333333333333 * (3.0 - (params.k[2] / params.a));
        let w3_3_1 = s11 * (1.0 / params.h);
        let s12 = 1.0 / (params.h * params.h * params.h);
        let b_1_1 = (-0.3333333333333333) * s12;
        let b_2_1 = (-0.6666666666666666) * (1.0 / (params.h * params.h));
        let b_3_1 = (-0.6111111111111112) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(deadbeat_1.is_finite()
            && w1_1_1.is_finite()
            && w1_2_1.is_finite()
            && w1_3_1.is_finite()
            && w2_2_1.is_finite()
            && w2_3_1.is_finite()
            && w3_3_1.is_finite()
            && b_1_1.is_finite()
            && b_2_1.is_finite()
            && b_3_1.is_finite()
            && (params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            deadbeat_1,
            w1_1_1,
            w1_2_1,
            w1_3_1,
            w2_2_1,
            w2_3_1,
            w3_3_1,
            b_1_1,
            b_2_1,
            b_3_1,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) and the
    /// reference r of each. Where one of them is not finite, every u is 0; else the status is
    /// SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[[f64; 3]; 2], r: &[[f64; 4]; 2]) -> Axes<2, f64> {
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        let elapsed = k.wrapping_sub(self.start);
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x3_1 = x[0][2];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x3_2 = x[1][2];

        // The tracking error.
        let e1_1 = x1_1 - r[0][0];
        let e2_1 = x2_1 - r[0][1];
        let e3_1 = x3_1 - r[0][2];
        let e1_2 = x1_2 - r[1][0];
        let e2_2 = x2_2 - r[1][1];
        let e3_2 = x3_2 - r[1][2];
        let left = self.samples.saturating_sub(elapsed);
        let m0_1 = left as f64;
        let law_1: f64;
        let m0_2 = left as f64;
        let law_2: f64;
        if m0_1 > self.deadbeat_1 {
            // The exact law in samples.
            let s1 = (self.w1_1_1 * e1_1) + (self.w1_2_1 * e2_1);
            let z1_1 = s1 + (self.w1_3_1 * e3_1);
            let z2_1 = (self.w2_2_1 * e2_1) + (self.w2_3_1 * e3_1);
            let z3_1 = self.w3_3_1 * e3_1;
            let m0f_12 = m0_1 * (m0_1 - 1.0);
            let s2 = (z1_1 + (z2_1 * m0_1) + (z3_1 * m0f_12)) / (m0f_12 * (m0_1 - 2.0));
            law_1 = s2 + (0.3333333333333333 * r[0][3]);
        } else {
            // Deadbeat.
            let s3 = (self.b_1_1 * e1_1) + (self.b_2_1 * e2_1);
            law_1 = s3 + (self.b_3_1 * e3_1) + (0.3333333333333333 * r[0][3]);
        }
        if m0_2 > self.deadbeat_1 {
            // The exact law in samples.
            let s4 = (self.w1_1_1 * e1_2) + (self.w1_2_1 * e2_2);
            let z1_2 = s4 + (self.w1_3_1 * e3_2);
            let z2_2 = (self.w2_2_1 * e2_2) + (self.w2_3_1 * e3_2);
            let z3_2 = self.w3_3_1 * e3_2;
            let m0f_22 = m0_2 * (m0_2 - 1.0);
            let s5 = (z1_2 + (z2_2 * m0_2) + (z3_2 * m0f_22)) / (m0f_22 * (m0_2 - 2.0));
            law_2 = s5 + (0.3333333333333333 * r[1][3]);
        } else {
            // Deadbeat.
            let s6 = (self.b_1_1 * e1_2) + (self.b_2_1 * e2_2);
            law_2 = s6 + (self.b_3_1 * e3_2) + (0.3333333333333333 * r[1][3]);
        }
        if elapsed < self.samples {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if law_1.is_finite() && law_2.is_finite() {
            u[0] = law_1;
            axes[0] = status;
            u[1] = law_2;
            axes[1] = status;
            if law_1 > self.u_max {
                u[0] = self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_1 < -self.u_max {
                u[0] = -self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_2 > self.u_max {
                u[1] = self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_2 < -self.u_max {
                u[1] = -self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
        } else {
            u[0] = 0.0;
            if law_1.is_finite() {
                axes[0] = status;
            } else {
                axes[0] = Err(Error::Range);
            }
            u[1] = 0.0;
            if law_2.is_finite() {
                axes[1] = status;
            } else {
                axes[1] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }
}
