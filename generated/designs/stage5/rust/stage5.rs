//! Prescribed-time controller stage5: order n = 4, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2
//! Version 0.1.0, design af29f716abf2.
//!
//! Plant: x1' = x2, ..., x4' = u; u held from sample to sample, 2 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^6 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-5));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0.01 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s^6]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^5]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
//!   k_4 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_5 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_6 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard none: finite measurements are the responsibility of the caller.
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

/// Run-time parameters of [`Stage5`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage5Params {
    /// samples N from the start to rest \[samples\], at least 6.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time \[1/s\], from 1e-150 to 1e150.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^6\], finite.
    pub k: [f64; 6],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage5 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// samples to go at which the gains are held.
    hold: f64,
    /// weight of x1 in the law.
    w1_1: f64,
    /// weight of x2 in the law.
    w1_2: f64,
    /// weight of x3 in the law.
    w1_3: f64,
    /// weight of x4 in the law.
    w1_4: f64,
    /// weight of x2 in the law.
    w2_2: f64,
    /// weight of x3 in the law.
    w2_3: f64,
    /// weight of x4 in the law.
    w2_4: f64,
    /// weight of x3 in the law.
    w3_3: f64,
    /// weight of x4 in the law.
    w3_4: f64,
    /// weight of x4 in the law.
    w4_4: f64,
    /// weight of u2 in the law.
    w5_6: f64,
    /// weight of u1 in the law.
    w6_5: f64,
    /// weight of u2 in the law.
    w6_6: f64,
    /// weight of x1 in the law.
    b_1: f64,
    /// weight of x2 in the law.
    b_2: f64,
    /// weight of x3 in the law.
    b_3: f64,
    /// weight of x4 in the law.
    b_4: f64,
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
impl Stage5 {
    /// 11/2, samples to go at which deadbeat takes over.
    const DEADBEAT: f64 = 5.5;
    /// Weight of u1 in the law.
    const C_5: f64 = 2.0;
    /// Weight of u1 in the law.
    const B_5: f64 = -4.0;
    /// Weight of u2 in the law.
    const B_6: f64 = -10.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage5Params) -> Result<Self, Error> {
        if !((params.samples > 5)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && (params.u_max > 0.0)
            && (1e-150 <= params.a)
            && (params.a <= 1e150)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.k[3].is_finite()
            && params.k[4].is_finite()
            && params.k[5].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let hold = 0.01 / params.h;
        let s1 = params.a * params.a * params.a * params.a * params.a;
        let s2 = 1.0 / (params.h * params.h * params.h * params.h);
        let w1_1 = (-(params.k[0] / (s1 * params.a))) * s2;
        let s3 = params.a * params.a * params.a * params.a * params.a;
        let s4 = (-1.5) * (-(params.k[0] / (s3 * params.a)));
        let w1_2 = s4 * (1.0 / (params.h * params.h * params.h));
        let s5 = params.a * params.a * params.a * params.a * params.a;
        let s6 = 0.9166666666666666 * (-(params.k[0] / (s5 * params.a)));
        let w1_3 = s6 * (1.0 / (params.h * params.h));
        let s7 = params.a * params.a * params.a * params.a * params.a;
        let w1_4 = (-0.25) * (-(params.k[0] / (s7 * params.a))) * (1.0 / params.h);
        let s8 = params.a * params.a * params.a * params.a * params.a;
        let s9 = params.a * params.a * params.a * params.a;
        let s10 = params.k[3] / (params.a * params.a * params.a);
        let s11 = ((1.0 - (params.k[1] / s8)) + (params.k[2] / s9)) - s10;
        let s12 = s11 + (params.k[4] / (params.a * params.a));
        let s13 = 1.0 / (params.h * params.h * params.h);
        let w2_2 = (s12 - (params.k[5] / params.a)) * s13;
        let s14 = params.a * params.a * params.a * params.a * params.a;
        let s15 = params.a * params.a * params.a * params.a;
        let s16 = params.k[3] / (params.a * params.a * params.a);
        let s17 = ((1.0 - (params.k[1] / s14)) + (params.k[2] / s15)) - s16;
        let s18 = s17 + (params.k[4] / (params.a * params.a));
        let s19 = -(s18 - (params.k[5] / params.a));
        let w2_3 = s19 * (1.0 / (params.h * params.h));
        let s20 = params.a * params.a * params.a * params.a * params.a;
        let s21 = params.a * params.a * params.a * params.a;
        let s22 = params.k[3] / (params.a * params.a * params.a);
        let s23 = ((1.0 - (params.k[1] / s20)) + (params.k[2] / s21)) - s22;
        let s24 = s23 + (params.k[4] / (params.a * params.a));
        let s25 = 0.3333333333333333 * (s24 - (params.k[5] / params.a));
        let w2_4 = s25 * (1.0 / params.h);
        let s26 = params.a * params.a * params.a * params.a;
        let s27 = 3.0 * (params.k[3] / (params.a * params.a * params.a));
        let s28 = 7.0 * (params.k[4] / (params.a * params.a));
        let s29 = (((-31.0) - (params.k[2] / s26)) + s27) - s28;
        let s30 = s29 + (15.0 * (params.k[5] / params.a));
        let w3_3 = s30 * (1.0 / (params.h * params.h));
        let s31 = params.a * params.a * params.a * params.a;
        let s32 = 3.0 * (params.k[3] / (params.a * params.a * params.a));
        let s33 = 7.0 * (params.k[4] / (params.a * params.a));
        let s34 = (((-31.0) - (params.k[2] / s31)) + s32) - s33;
        let s35 = (-0.5) * (s34 + (15.0 * (params.k[5] / params.a)));
        let w3_4 = s35 * (1.0 / params.h);
        let s36 = 90.0 - (params.k[3] / (params.a * params.a * params.a));
        let s37 = s36 + (6.0 * (params.k[4] / (params.a * params.a)));
        let w4_4 = (s37 - (25.0 * (params.k[5] / params.a))) * (1.0 / params.h);
        let s38 = (-65.0) - (params.k[4] / (params.a * params.a));
        let w5_6 = s38 + (10.0 * (params.k[5] / params.a));
        let w6_5 = 15.0 - (params.k[5] / params.a);
        let w6_6 = -(15.0 - (params.k[5] / params.a));
        let b_1 = -(1.0 / (params.h * params.h * params.h * params.h));
        let b_2 = (-4.5) * (1.0 / (params.h * params.h * params.h));
        let b_3 = (-9.916666666666666) * (1.0 / (params.h * params.h));
        let b_4 = (-14.25) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(hold.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w1_4.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w2_4.is_finite()
            && w3_3.is_finite()
            && w3_4.is_finite()
            && w4_4.is_finite()
            && w5_6.is_finite()
            && w6_5.is_finite()
            && w6_6.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && b_3.is_finite()
            && b_4.is_finite()
            && (params.h * params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            u2: 0.0,
            hold,
            w1_1,
            w1_2,
            w1_3,
            w1_4,
            w2_2,
            w2_3,
            w2_4,
            w3_3,
            w3_4,
            w4_4,
            w5_6,
            w6_5,
            w6_6,
            b_1,
            b_2,
            b_3,
            b_4,
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
    pub fn step(&mut self, k: u32, x: &[f64; 4]) -> Result<Control<f64>, Error> {
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let x4 = x[3];
        let left = self.samples.saturating_sub(elapsed);
        let m0 = if (left as f64) < self.hold {
            self.hold
        } else {
            left as f64
        };
        let v: f64;
        if m0 > Self::DEADBEAT {
            // The exact law in samples.
            let s1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
            let z1 = s1 + (self.w1_4 * x4);
            let z2 = (self.w2_2 * x2) + (self.w2_3 * x3) + (self.w2_4 * x4);
            let z3 = (self.w3_3 * x3) + (self.w3_4 * x4);
            let z4 = self.w4_4 * x4;
            let z5 = self.w5_6 * self.u2;
            let z6 = (self.w6_5 * self.u1) + (self.w6_6 * self.u2);
            let m0f2 = m0 * (m0 - 1.0);
            let m0f3 = m0f2 * (m0 - 2.0);
            let m0f4 = m0f3 * (m0 - 3.0);
            let m0f5 = m0f4 * (m0 - 4.0);
            let s2 = z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3) + (z5 * m0f4);
            let s3 = (s2 + (z6 * m0f5)) / (m0f5 * (m0 - 5.0));
            v = s3 + ((Self::C_5 * self.u1) - self.u2);
        } else {
            // Deadbeat.
            let s4 = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
            let s5 = s4 + (self.b_4 * x4) + (Self::B_5 * self.u1);
            v = s5 + (Self::B_6 * self.u2);
        }
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f64;
        if v > self.u_max {
            u_now = self.u_max;
        } else if v < -self.u_max {
            u_now = -self.u_max;
        } else {
            u_now = v;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if (left as f64) <= self.hold {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }
}
