//! Prescribed-time controller shaken: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0
//! Version 0.1.0, design db5a18285eee.
//!
//! Plant: x1' = x2, x2' = g (u + d), d an unknown sine(omega=60); u held from sample to
//!       sample, 1.75 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant. What d
//!       does within a sample remains, of order h^(4-i) in x_i.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
//!       the rows are those of Theorem 1 for the mapping exp. The gains of 12 samples to go
//!       stay.
//!
//! Parameters:
//!   samples = 600 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.01 [s], fixed: time-to-go at which the gains are held
//!   u_max = 8 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
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
//!   growth: sound: near rest at sample 600, not at rest: the gains are held from 10 samples
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

/// Run-time parameters of [`Shaken`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct ShakenParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Shaken {
    /// tick at which it was armed.
    start: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// input of 3 samples ago.
    u3: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of d.
    d_hat: f64,
    /// estimate of d_rate.
    d_rate_hat: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Shaken {
    /// 1/1000, prediction of x1 from x2.
    const PHI1_2: f64 = 0.001;
    /// Prediction of x1 from d.
    const PHI1_3: f64 = 9.997000359976858e-7;
    /// 3/3200000, prediction from u.
    const GAMMA1: f64 = 9.375e-7;
    /// 1/16000000, prediction from u.
    const LATE_GAMMA1: f64 = 6.25e-8;
    /// Prediction of x1 from d_rate.
    const PHI1_4: f64 = 3.3327333847593334e-10;
    /// Prediction of x2 from d.
    const PHI2_3: f64 = 0.001998800215981487;
    /// 3/2000, prediction from u.
    const GAMMA2: f64 = 0.0015;
    /// 1/2000, prediction from u.
    const LATE_GAMMA2: f64 = 0.0005;
    /// Prediction of x2 from d_rate.
    const PHI2_4: f64 = 9.997000359976858e-7;
    /// Prediction of d from d_rate.
    const PHI3_4: f64 = 0.0009994001079907434;
    /// Prediction of d from d.
    const PHI3_3: f64 = 0.9982005399352042;
    /// Prediction of d_rate from d_rate.
    const PHI4_4: f64 = 0.9982005399352042;
    /// Prediction of d_rate from d.
    const PHI4_3: f64 = -3.597840388766676;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 200;
    /// Samples to go at which the observer is held.
    const HOLD_O: f64 = 30.0;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = -840.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = 480.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = -120.0;
    /// Weight in the observer's gain l1.
    const Q1_4: f64 = 16.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = 907032.0947896534;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = -431395.04961199313;
    /// Weight in the observer's gain l2.
    const Q2_3: f64 = 71827.15332755336;
    /// Weight in the observer's gain l2.
    const Q2_4: f64 = 28.808643111533488;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = -166538409.07329616;
    /// Weight in the observer's gain l3.
    const Q3_2: f64 = 47150402.59237033;
    /// Weight in the observer's gain l3.
    const Q3_3: f64 = 216000.0;
    /// Weight in the observer's gain l3.
    const Q3_4: f64 = -28800.0;
    /// Weight in the observer's gain l4.
    const Q4_1: f64 = 10370942877.471207;
    /// Weight in the observer's gain l4.
    const Q4_2: f64 = 776511089.3015876;
    /// Weight in the observer's gain l4.
    const Q4_3: f64 = -129288875.98959604;
    /// Weight in the observer's gain l4.
    const Q4_4: f64 = -51855.55760076028;
    /// Weight of d in d0.
    const D0_D: f64 = 0.990752702693308;
    /// Weight of d_rate in d0.
    const D0_D_RATE: f64 = 0.002242835389486039;
    /// Weight of d in d1.
    const D1_D: f64 = 0.9970392465203709;
    /// Weight of d_rate in d1.
    const D1_D_RATE: f64 = 0.0012486411387069352;
    /// Weight of d in d2.
    const D2_D: f64 = 0.9996625341702274;
    /// Weight of d_rate in d2.
    const D2_D_RATE: f64 = 0.0003749367230213299;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 600;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 10.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -6000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = -7500.0;
    /// -63/8, weight of u2 in the law.
    const W1_4: f64 = -7.875;
    /// Weight of x2 in the law.
    const W2_2: f64 = -3000.0;
    /// Weight of u1 in the law.
    const W2_3: f64 = -6.0;
    /// -9/2, weight of u2 in the law.
    const W2_4: f64 = -4.5;
    /// Bound of |u|.
    const U_MAX: f64 = 8.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: ShakenParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            d_hat: 0.0,
            d_rate_hat: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.d_hat).abs();
        let size = s1 + (self.d_rate_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.d_hat = 0.0;
            self.d_rate_hat = 0.0;
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
        let s3 = (Self::GAMMA1 * self.u3) + (Self::LATE_GAMMA1 * self.u2);
        let p1 = s2 + (Self::PHI1_4 * self.d_rate_hat) + s3;
        let s4 = self.x2_hat + (Self::PHI2_3 * self.d_hat);
        let s5 = (Self::GAMMA2 * self.u3) + (Self::LATE_GAMMA2 * self.u2);
        let p2 = s4 + (Self::PHI2_4 * self.d_rate_hat) + s5;
        let s6 = Self::PHI3_4 * self.d_rate_hat;
        let p3 = (Self::PHI3_3 * self.d_hat) + s6;
        let s7 = Self::PHI4_4 * self.d_rate_hat;
        let p4 = (Self::PHI4_3 * self.d_hat) + s7;

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
        let l4: f64;
        let o0f2 = o0 * (o0 - 1.0);
        let o0f3 = o0f2 * (o0 - 2.0);
        let r0 = 1.0 / (o0f3 * (o0 - 3.0));
        let s8 = Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2);
        l1 = ((s8 + (Self::Q1_4 * o0f3)) * r0) - 3.8011523294569497e-121;
        let s9 = Self::Q2_1 + (Self::Q2_2 * o0) + (Self::Q2_3 * o0f2);
        l2 = ((s9 + (Self::Q2_4 * o0f3)) * r0) - 3.601080388941686;
        let s10 = Self::Q3_1 + (Self::Q3_2 * o0) + (Self::Q3_3 * o0f2);
        l3 = ((s10 + (Self::Q3_4 * o0f3)) * r0) + 1.3694003898462869e-117;
        let s11 = Self::Q4_1 + (Self::Q4_2 * o0) + (Self::Q4_3 * o0f2);
        l4 = ((s11 + (Self::Q4_4 * o0f3)) * r0) + 6481.944700095035;
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);
        let d_rate = p4 + (l4 * miss);

        // The disturbance while each input acts.
        let d0 = (Self::D0_D * d) + (Self::D0_D_RATE * d_rate);
        let d1 = (Self::D1_D * d) + (Self::D1_D_RATE * d_rate);
        let d2 = (Self::D2_D * d) + (Self::D2_D_RATE * d_rate);
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let s12 = (left as f64) - 2.0;
        let m0 = if s12 < Self::HOLD { Self::HOLD } else { s12 };
        let v: f64;

        // The exact law in samples.
        let s13 = (Self::W1_1 * x1) + (Self::W1_2 * x2);
        let z1 = s13 + (Self::W1_4 * (self.u2 + d2));
        let s14 = (Self::W2_2 * x2) + (Self::W2_3 * (self.u1 + d1));
        let z2 = s14 + (Self::W2_4 * (self.u2 + d2));
        let m0f1 = m0 + 2.0;
        v = ((z1 + (z2 * m0f1)) / (m0f1 * (m0 + 1.0))) - d0;
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
        self.u3 = self.u2;
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.d_hat = d;
        self.d_rate_hat = d_rate;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f64) - 2.0 <= Self::HOLD {
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

    /// The estimate of the sine that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
