//! Prescribed-time controller stage45: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu exp --name stage45 --clock samples --delay-law=predict --precision f32 --guard none --eps=0 --delay=5
//! Version 0.1.0, design 494dc2a017da.
//!
//! Plant: x1' = x2, x2' = u; u held from sample to sample, 5 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M + 5 samples to go and z = S x, u h^2 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. Close
//!       to the end deadbeat takes over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard none: finite measurements are the responsibility of the caller.
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

/// Run-time parameters of [`Stage45`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage45Params {
    /// samples N from the start to rest \[samples\], at least 7.
    pub samples: u32,
    /// sample period \[s\], from 1e-18 to 1e18.
    pub h: f32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
    /// rate of stretched time \[1/s\], from 1e-18 to 1e18.
    pub a: f32,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^2\], finite.
    pub k: [f32; 2],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage45 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f32,
    /// input of 2 samples ago.
    u2: f32,
    /// input of 3 samples ago.
    u3: f32,
    /// input of 4 samples ago.
    u4: f32,
    /// input of 5 samples ago.
    u5: f32,
    /// samples to go at which deadbeat takes over.
    deadbeat: f32,
    /// weight of x1 in the law.
    w1_1: f32,
    /// weight of x2 in the law.
    w1_2: f32,
    /// weight of u2 in the law.
    w1_4: f32,
    /// weight of u3 in the law.
    w1_5: f32,
    /// weight of u4 in the law.
    w1_6: f32,
    /// weight of u5 in the law.
    w1_7: f32,
    /// weight of x2 in the law.
    w2_2: f32,
    /// weight of u1 in the law.
    w2_3: f32,
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
impl Stage45 {
    /// Weight of u1 in the law.
    const B_3: f32 = -2.0;
    /// Weight of u2 in the law.
    const B_4: f32 = -3.0;
    /// Weight of u3 in the law.
    const B_5: f32 = -4.0;
    /// Weight of u4 in the law.
    const B_6: f32 = -5.0;
    /// Weight of u5 in the law.
    const B_7: f32 = -6.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage45Params) -> Result<Self, Error> {
        if !((params.samples > 6)
            && (1e-18 <= params.h)
            && (params.h <= 1e18)
            && (params.u_max > 0.0)
            && (1e-18 <= params.a)
            && (params.a <= 1e18)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = ((params.k[1] / params.a) - 1.0) + 2.0;
        let s2 = if s1 < 4.0 { 4.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let s3 = -(params.k[0] / (params.a * params.a));
        let w1_1 = s3 * (1.0 / (params.h * params.h));
        let s4 = 4.5 * (-(params.k[0] / (params.a * params.a)));
        let w1_2 = s4 * (1.0 / params.h);
        let w1_4 = -(params.k[0] / (params.a * params.a));
        let w1_5 = 2.0 * (-(params.k[0] / (params.a * params.a)));
        let w1_6 = 3.0 * (-(params.k[0] / (params.a * params.a)));
        let w1_7 = 4.0 * (-(params.k[0] / (params.a * params.a)));
        let w2_2 = (1.0 - (params.k[1] / params.a)) * (1.0 / params.h);
        let w2_3 = 1.0 - (params.k[1] / params.a);
        let b_1 = -(1.0 / (params.h * params.h));
        let b_2 = (-6.5) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_4.is_finite()
            && w1_5.is_finite()
            && w1_6.is_finite()
            && w1_7.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
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
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
            u4: 0.0,
            u5: 0.0,
            deadbeat,
            w1_1,
            w1_2,
            w1_4,
            w1_5,
            w1_6,
            w1_7,
            w2_2,
            w2_3,
            b_1,
            b_2,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f32; 2]) -> Result<Control<f32>, Error> {
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let left = self.samples.saturating_sub(elapsed);
        let m0 = (left as f32) - 5.0;
        let v: f32;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let s1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_4 * self.u2);
            let s2 = s1 + (self.w1_5 * self.u3) + (self.w1_6 * self.u4);
            let z1 = s2 + (self.w1_7 * self.u5);
            let s3 = (self.w2_2 * x2) + (self.w2_3 * self.u1);
            let s4 = s3 + (self.w2_3 * self.u2) + (self.w2_3 * self.u3);
            let z2 = s4 + (self.w2_3 * self.u4) + (self.w2_3 * self.u5);
            v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
        } else {
            // Deadbeat.
            let s5 = (self.b_1 * x1) + (self.b_2 * x2) + (Self::B_3 * self.u1);
            let s6 = s5 + (Self::B_4 * self.u2) + (Self::B_5 * self.u3);
            v = s6 + (Self::B_6 * self.u4) + (Self::B_7 * self.u5);
        }
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f32;
        if v > self.u_max {
            u_now = self.u_max;
        } else if v < -self.u_max {
            u_now = -self.u_max;
        } else {
            u_now = v;
        }
        self.u5 = self.u4;
        self.u4 = self.u3;
        self.u3 = self.u2;
        self.u2 = self.u1;
        self.u1 = u_now;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if elapsed < self.samples {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(Control { u: u_now, status })
    }
}
