//! Prescribed-time controller stage6: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3
//! Version 0.1.0, design 6c8ba09a0bea.
//!
//! Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h = 2e-3 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 0.7 [1/s], fixed: rate of stretched time
//!   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
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

/// Run-time parameters of [`Stage6`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage6Params {
    /// samples N from the start to rest \[samples\], at least 6.
    pub samples: u32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^3\], finite.
    pub k: [f64; 3],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage6 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// samples to go at which deadbeat takes over.
    deadbeat: f64,
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
impl Stage6 {
    /// 1/500, prediction of x2 from x3.
    const PHI1_2: f64 = 0.002;
    /// 1/250000, prediction from u.
    const GAMMA1: f64 = 4e-6;
    /// 1/250, prediction from u.
    const GAMMA2: f64 = 0.004;
    /// -2120/49, weight in the observer's gain l1.
    const Q1_1: f64 = -43.265306122448976;
    /// 86/7, weight in the observer's gain l1.
    const Q1_2: f64 = 12.285714285714286;
    /// 759000/49, weight in the observer's gain l2.
    const Q2_1: f64 = 15489.795918367347;
    /// 11500/63, gain of the observer at its end.
    const E0_2: f64 = 182.53968253968253;
    /// Gain of the observer at its end.
    const E1_2: f64 = 500.0;
    /// Weight of x1 in the law.
    const B_1: f64 = -62500000.0;
    /// Weight of x2 in the law.
    const B_2: f64 = -250000.0;
    /// -1375/3, weight of x3 in the law.
    const B_3: f64 = -458.3333333333333;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage6Params) -> Result<Self, Error> {
        if !((params.samples > 5)
            && (params.u_max > 0.0)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = ((params.k[2] / 0.7) - 4.0) + 3.0;
        let s2 = if s1 < 6.0 { 6.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1 = 125000000.0 * (0.5 * (-(params.k[0] / 0.343)));
        let w1_2 = 250000.0 * ((-0.5) * (-(params.k[0] / 0.343)));
        let w1_3 = 500.0 * (0.16666666666666666 * (-(params.k[0] / 0.343)));
        let s3 = 0.5 * (((-1.0) - (params.k[1] / 0.49)) + (params.k[2] / 0.7));
        let w2_2 = 250000.0 * s3;
        let s4 = (-0.25) * (((-1.0) - (params.k[1] / 0.49)) + (params.k[2] / 0.7));
        let w2_3 = 500.0 * s4;
        let w3_3 = 500.0 * (0.5 * (3.0 - (params.k[2] / 0.7)));
        let u_max = params.u_max;
        if !(deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w3_3.is_finite())
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            seen: 0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            deadbeat,
            w1_1,
            w1_2,
            w1_3,
            w2_2,
            w2_3,
            w3_3,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x2_hat).abs() + (self.x3_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
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
    pub fn step(&mut self, k: u32, y: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(y[0].is_finite() && y[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x2_hat + (Self::PHI1_2 * self.x3_hat);
        let p1 = s1 + (Self::GAMMA1 * (self.u1 + 0.25));
        let p2 = self.x3_hat + (Self::GAMMA2 * (self.u1 + 0.25));

        // Correct by what is measured.
        let base: f64;
        let miss: f64;
        if self.seen == 0 {
            base = y[1];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[1] - p1;
        }
        let left_o = (self.samples / 2).saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        if o0 > 9.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            l1 = (Self::Q1_1 + (Self::Q1_2 * o0)) * r0;
            l2 = Self::Q2_1 * r0;
        } else if left_o == 9 {
            l1 = 1.0;
            l2 = Self::E0_2;
        } else {
            l1 = 1.0;
            l2 = Self::E1_2;
        }
        let x1 = y[0];
        let x2 = base + (l1 * miss);
        let x3 = p2 + (l2 * miss);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f64;
        let v: f64;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
            let z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
            let z3 = self.w3_3 * x3;
            let m0f2 = m0 * (m0 - 1.0);
            v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - 0.25;
        } else {
            // Deadbeat.
            let s2 = (Self::B_1 * x1) + (Self::B_2 * x2) + (Self::B_3 * x3);
            v = s2 - 0.25;
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
        self.u1 = u_now;
        self.x2_hat = x2;
        self.x3_hat = x3;
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

    /// The estimates of x2, ... at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 2] {
        [self.x2_hat, self.x3_hat]
    }
}
