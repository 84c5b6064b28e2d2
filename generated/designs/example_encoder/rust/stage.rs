//! Prescribed-time controller stage: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=250 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
//! Version 0.1.0, design 87cdac884d95.
//!
//! Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
//!       sample late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
//!       the rows are those of Theorem 1 for the mapping exp. From 250 samples to go on these
//!       are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
//!       go stay.
//!
//! Parameters:
//!   samples = 800 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   u_max = 6 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 200 after the start on where the measurement is; with
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
//!   growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
//!       to go, and |u| is bounded; so does what the held observer leaves of its error.
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

/// Run-time parameters of [`Stage`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct StageParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage {
    /// tick at which it was armed.
    start: u32,
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
    /// estimate of d.
    d_hat: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage {
    /// 1/1000, prediction of x1 from x2.
    const PHI1_2: f64 = 0.001;
    /// 1/3000000, prediction of x1 from d.
    const PHI1_3: f64 = 3.3333333333333335e-7;
    /// 1/3000000, prediction from u.
    const GAMMA1: f64 = 3.3333333333333335e-7;
    /// 1/1500, prediction of x2 from d.
    const PHI2_3: f64 = 0.0006666666666666666;
    /// 1/1500, prediction from u.
    const GAMMA2: f64 = 0.0006666666666666666;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 200;
    /// Samples to go at which the observer is held.
    const HOLD_O: f64 = 30.0;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 120.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -60.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = -108000.0;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = 36000.0;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = 36000000.0;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 800;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 20.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES: f64 = 250.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -9000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = -4500.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -6000.0;
    /// Weight of u1 in the law.
    const W2_3: f64 = -4.0;
    /// Weight of x1 in the law.
    const END1_1: f64 = -18000000.0;
    /// Weight of x2 in the law.
    const END1_2: f64 = -9000.0;
    /// Weight of x2 in the law.
    const END2_2: f64 = -9000.0;
    /// Weight of u1 in the law.
    const END2_3: f64 = -6.0;
    /// Bound of |u|.
    const U_MAX: f64 = 6.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: StageParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            d_hat: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.d_hat = 0.0;
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
        let s1 = self.x1_hat + (Self::PHI1_2 * self.x2_hat);
        let s2 = s1 + (Self::PHI1_3 * self.d_hat);
        let p1 = s2 + (Self::GAMMA1 * self.u2);
        let s3 = self.x2_hat + (Self::PHI2_3 * self.d_hat);
        let p2 = s3 + (Self::GAMMA2 * self.u2);
        let p3 = self.d_hat;

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
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = if (left_o as f64) < Self::HOLD_O {
            Self::HOLD_O
        } else {
            left_o as f64
        };
        let l1: f64;
        let l2: f64;
        let l3: f64;
        let o0f2 = o0 * (o0 - 1.0);
        let r0 = 1.0 / (o0f2 * (o0 - 2.0));
        l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
        l2 = (Self::Q2_1 + (Self::Q2_2 * o0)) * r0;
        l3 = Self::Q3_1 * r0;
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let s4 = (left as f64) - 1.0;
        let m0 = if s4 < Self::HOLD { Self::HOLD } else { s4 };
        let v: f64;
        if m0 > Self::END_SAMPLES {
            // The exact law in samples.
            let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2);
            let z2 = (Self::W2_2 * x2) + (Self::W2_3 * (self.u1 + d));
            let m0f1 = m0 + 1.0;
            v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
        } else {
            // The law of least energy to the end.
            let m1 = if m0 < 2.0 { 2.0 } else { m0 };
            let y1 = (Self::END1_1 * x1) + (Self::END1_2 * x2);
            let y2 = (Self::END2_2 * x2) + (Self::END2_3 * (self.u1 + d));
            let m1f1 = m1 + 2.0;
            v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
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
        self.d_hat = d;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f64) - 1.0 <= Self::HOLD {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
