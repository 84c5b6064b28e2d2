//! Prescribed-time controller stage7: order n = 1, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 1 --mu "exp(a=1)" --name stage7 --clock samples --disturbance constant --observer-poles=-4,-5 --precision f32 --guard none --eps=0 --gains=3
//! Version 0.1.0, design 7a85fff93aef.
//!
//! Plant: x1' = (u + d), d constant and unknown; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 2 samples to go and z = S x, u h^1 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-0)); the rows are those of Theorem 1 for the mapping exp. The
//!       gains of 1 sample to go stay: they are deadbeat.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 3 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample N/2 after the start on where the measurement is; with
//!       noise or sensor_step given, or observer_eps, the gains of the observer are then held
//!       below deadbeat.
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

/// Run-time parameters of [`Stage7`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage7Params {
    /// samples N from the start to rest \[samples\], at least 4.
    pub samples: u32,
    /// sample period \[s\], from 1e-18 to 1e18.
    pub h: f32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage7 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f32,
    /// estimate of d.
    d_hat: f32,
    /// prediction of x1 from d.
    phi1_2: f32,
    /// weight in the observer's gain l2.
    q2_1: f32,
    /// gain of the observer at its end.
    e1_2: f32,
    /// gain of the observer at its end.
    e0_2: f32,
    /// weight of x1 in the law.
    w1_1: f32,
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
impl Stage7 {
    /// Weight in the observer's gain l1.
    const Q1_1: f32 = -20.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f32 = 8.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage7Params) -> Result<Self, Error> {
        if !((params.samples > 3)
            && (1e-18 <= params.h)
            && (params.h <= 1e18)
            && (params.u_max > 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let phi1_2 = params.h;
        let q2_1 = 12.0 * (1.0 / params.h);
        let e1_2 = 1.0 / params.h;
        let e0_2 = 0.33333334 * (1.0 / params.h);
        let w1_1 = (-3.0) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(q2_1.is_finite()
            && e1_2.is_finite()
            && e0_2.is_finite()
            && w1_1.is_finite()
            && (params.h >= 1e-30)
            && (1.0 / params.h >= 1e-30))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            seen: 0,
            x1_hat: 0.0,
            d_hat: 0.0,
            phi1_2,
            q2_1,
            e1_2,
            e0_2,
            w1_1,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x1_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e18) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.d_hat = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f32; 1]) -> Result<Control<f32>, Error> {
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (self.phi1_2 * self.d_hat);
        let p1 = s1 + (self.phi1_2 * self.u1);
        let p2 = self.d_hat;

        // Correct by what is measured.
        let base: f32;
        let miss: f32;
        if self.seen == 0 {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        let left_o = (self.samples / 2).saturating_sub(elapsed);
        let o0 = left_o as f32;
        let l1: f32;
        let l2: f32;
        if o0 > 6.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            l1 = (Self::Q1_1 + (Self::Q1_2 * o0)) * r0;
            l2 = self.q2_1 * r0;
        } else if left_o == 6 {
            l1 = 1.0;
            l2 = self.e0_2;
        } else {
            l1 = 1.0;
            l2 = self.e1_2;
        }
        let x1 = base + (l1 * miss);
        let d = p2 + (l2 * miss);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = if (left as f32) < 1.0 {
            1.0
        } else {
            left as f32
        };
        let v: f32;

        // The exact law in samples.
        let z1 = self.w1_1 * x1;
        v = (z1 / (m0 + 2.0)) - d;
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
        self.u1 = u_now;
        self.x1_hat = x1;
        self.d_hat = d;
        self.seen = 1;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if elapsed < self.samples {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f32; 1] {
        [self.x1_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f32 {
        self.d_hat
    }
}
