//! Prescribed-time controller stage9: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1
//! Version 0.1.0, design a9f2dd91a5f7.
//!
//! Plant: x1' = x2, ..., x3' = u; u held from sample to sample, one sample late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   u_max = 1e3 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample N/2 after the start on where the measurement is; with
//!       noise or sensor_step given, or observer_eps, the gains of the observer are then held
//!       below deadbeat.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what the held observer leaves
//!       of its error, whatever the poles, and |u| is bounded.
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

/// Run-time parameters of [`Stage9`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage9Params {
    /// samples N from the start to rest \[samples\], at least 8.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^4\], finite.
    pub k: [f64; 4],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage9 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// prediction of x1 from x2.
    phi1_2: f64,
    /// prediction of x1 from x3.
    phi1_3: f64,
    /// prediction from u.
    gamma1: f64,
    /// samples to go at which the observer is held.
    hold_o: f64,
    /// weight in the observer's gain l2.
    q2_1: f64,
    /// weight in the observer's gain l2.
    q2_2: f64,
    /// weight in the observer's gain l3.
    q3_1: f64,
    /// samples to go at which the gains are held.
    hold: f64,
    /// weight of x1 in the law.
    w1_1: f64,
    /// weight of x2 in the law.
    w1_2: f64,
    /// weight of x3 in the law.
    w1_3: f64,
    /// weight of x2 in the law.
    w2_2: f64,
    /// weight of x3 in the law.
    w2_3: f64,
    /// weight of x3 in the law.
    w3_3: f64,
    /// weight of u1 in the law.
    w4_4: f64,
    /// weight of x1 in the law.
    b_1: f64,
    /// weight of x2 in the law.
    b_2: f64,
    /// weight of x3 in the law.
    b_3: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage9 {
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 120.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -60.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// 7/2, samples to go at which deadbeat takes over.
    const DEADBEAT: f64 = 3.5;
    /// Weight of u1 in the law.
    const B_4: f64 = -3.0;
    /// Bound of |u|.
    const U_MAX: f64 = 1000.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage9Params) -> Result<Self, Error> {
        if !((params.samples > 7)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.k[3].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let phi1_2 = params.h;
        let phi1_3 = 0.5 * (params.h * params.h);
        let gamma1 = 0.16666666666666666 * (params.h * params.h * params.h);
        let hold_o = 0.05 / params.h;
        let q2_1 = (-108.0) * (1.0 / params.h);
        let q2_2 = 36.0 * (1.0 / params.h);
        let q3_1 = 24.0 * (1.0 / (params.h * params.h));
        let hold = 0.02 / params.h;
        let w1_1 = (-params.k[0]) * (1.0 / (params.h * params.h * params.h));
        let w1_2 = params.k[0] * (1.0 / (params.h * params.h));
        let w1_3 = 0.3333333333333333 * (-params.k[0]) * (1.0 / params.h);
        let s1 = ((1.0 - params.k[1]) + params.k[2]) - params.k[3];
        let w2_2 = s1 * (1.0 / (params.h * params.h));
        let s2 = (-0.5) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w2_3 = s2 * (1.0 / params.h);
        let w3_3 = (((-7.0) - params.k[2]) + (3.0 * params.k[3])) * (1.0 / params.h);
        let w4_4 = 6.0 - params.k[3];
        let b_1 = -(1.0 / (params.h * params.h * params.h));
        let b_2 = (-3.0) * (1.0 / (params.h * params.h));
        let b_3 = (-4.333333333333333) * (1.0 / params.h);
        if !(phi1_3.is_finite()
            && gamma1.is_finite()
            && hold_o.is_finite()
            && q2_1.is_finite()
            && q2_2.is_finite()
            && q3_1.is_finite()
            && hold.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w3_3.is_finite()
            && w4_4.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && b_3.is_finite()
            && (params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h) >= 1e-200)
            && (hold_o >= 3.0))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            phi1_2,
            phi1_3,
            gamma1,
            hold_o,
            q2_1,
            q2_2,
            q3_1,
            hold,
            w1_1,
            w1_2,
            w1_3,
            w2_2,
            w2_3,
            w3_3,
            w4_4,
            b_1,
            b_2,
            b_3,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.x3_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.x3_hat = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
        let p1 = s1 + (self.phi1_3 * self.x3_hat) + (self.gamma1 * self.u2);
        let s2 = self.x2_hat + (self.phi1_2 * self.x3_hat);
        let p2 = s2 + (self.phi1_3 * self.u2);
        let p3 = self.x3_hat + (self.phi1_2 * self.u2);

        // Correct by what is measured.
        let base: f64;
        let miss: f64;
        if self.seen == 0 {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        let left_o = (self.samples / 2).saturating_sub(elapsed);
        let o0 = if (left_o as f64) < self.hold_o {
            self.hold_o
        } else {
            left_o as f64
        };
        let l1: f64;
        let l2: f64;
        let l3: f64;
        let o0f2 = o0 * (o0 - 1.0);
        let r0 = 1.0 / (o0f2 * (o0 - 2.0));
        l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
        l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
        l3 = self.q3_1 * r0;
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let x3 = p3 + (l3 * miss);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = if (left as f64) < self.hold {
            self.hold
        } else {
            left as f64
        };
        let v: f64;
        if m0 > Self::DEADBEAT {
            // The exact law in samples.
            let z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
            let z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
            let z3 = self.w3_3 * x3;
            let z4 = self.w4_4 * self.u1;
            let m0f2 = m0 * (m0 - 1.0);
            let m0f3 = m0f2 * (m0 - 2.0);
            let s3 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s3 + self.u1;
        } else {
            // Deadbeat.
            let s4 = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
            v = s4 + (Self::B_4 * self.u1);
        }
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f64;
        if v > Self::U_MAX {
            u_now = Self::U_MAX;
        } else if v < -Self::U_MAX {
            u_now = -Self::U_MAX;
        } else {
            u_now = v;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.x3_hat = x3;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f64) <= self.hold {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }
}
