//! Prescribed-time controller stage47: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage47 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=stationary --disturbance-walk=1/2 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --noise=1e-5,1e-3
//! Version 0.1.0, design bd3303578b4f.
//!
//! Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
//!       sample to sample, y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 2 samples to go and z = S x, the differences of a flat output, u = sum of
//!       row_j z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for
//!       the mapping exp. The gains of 6 samples to go stay.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0.06 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 60 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 47 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 12 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 20 after the start on where the measurement is; from
//!       there on the observer has the gains of the stationary Kalman filter for the noise and
//!       disturbance_walk.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample N, not at rest: the gains are held from 6 samples to
//!       go, and |u| is bounded.
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

/// Run-time parameters of [`Stage47`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage47Params {
    /// samples N from the start to rest \[samples\], at least 23.
    pub samples: u32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage47 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// prediction of x1 without u.
    x1_next: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// prediction of x2 without u.
    x2_next: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// prediction of x3 without u.
    x3_next: f64,
    /// estimate of d.
    d_hat: f64,
    /// prediction of d without u.
    d_next: f64,
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
impl Stage47 {
    /// Prediction from u.
    const GAMMA1: f64 = 0.00010803832226644697;
    /// Prediction from u.
    const GAMMA2: f64 = 0.030892799233141147;
    /// Prediction from u.
    const GAMMA3: f64 = 0.3745921515889058;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 20;
    /// Weight in the observer's gain l1_1.
    const Q1_1_1: f64 = -8.0;
    /// Weight in the observer's gain l1_1.
    const Q1_1_2: f64 = 8.0;
    /// Weight in the observer's gain l1_2.
    const Q1_2_1: f64 = 1207.0156938434693;
    /// Weight in the observer's gain l1_2.
    const Q1_2_2: f64 = -4.007471679722458;
    /// Weight in the observer's gain l1_4.
    const Q1_4_1: f64 = 359.9103398433305;
    /// Weight in the observer's gain l2_2.
    const Q2_2_1: f64 = -1.8587963031465917;
    /// Weight in the observer's gain l2_2.
    const Q2_2_2: f64 = 0.9913796378212842;
    /// Weight in the observer's gain l2_3.
    const Q2_3_1: f64 = -12.0;
    /// Weight in the observer's gain l2_3.
    const Q2_3_2: f64 = 12.0;
    /// Weight in the observer's gain l2_4.
    const Q2_4_1: f64 = 79.82759275642569;
    /// Gain of the observer at its end.
    const E0_1_1: f64 = 0.9950193780571475;
    /// Gain of the observer at its end.
    const E0_1_2: f64 = -0.49380107331759976;
    /// Gain of the observer at its end.
    const E0_1_3: f64 = 0.056139026437663865;
    /// Gain of the observer at its end.
    const E0_2_1: f64 = 0.0014392695129337434;
    /// Gain of the observer at its end.
    const E0_2_2: f64 = 0.220357858722901;
    /// Gain of the observer at its end.
    const E0_2_3: f64 = 1.0319630246108107;
    /// Gain of the observer at its end.
    const E0_2_4: f64 = 1.3304598792737614;
    /// Gain of the observer at its end.
    const E1_1_1: f64 = 1.9950193780571475;
    /// Gain of the observer at its end.
    const E1_1_2: f64 = 99.25595014702932;
    /// Gain of the observer at its end.
    const E1_1_3: f64 = 0.056139026437663865;
    /// Gain of the observer at its end.
    const E1_1_4: f64 = 29.992528320277543;
    /// Gain of the observer at its end.
    const E1_2_1: f64 = 0.0014392695129337434;
    /// Gain of the observer at its end.
    const E1_2_2: f64 = 0.24720839921003274;
    /// Gain of the observer at its end.
    const E1_2_3: f64 = 1.5319630246108107;
    /// Gain of the observer at its end.
    const E1_2_4: f64 = 2.660919758547523;
    /// Prediction of x1 from x2.
    const PHI1_2: f64 = 0.009942671770940647;
    /// Prediction of x1 from x3.
    const PHI1_3: f64 = 0.000617855984662823;
    /// Prediction of x1 from d.
    const PHI1_4: f64 = 0.00010803832226644697;
    /// Prediction of x2 from x2.
    const PHI2_2: f64 = 0.9857608243445873;
    /// Prediction of x2 from x3.
    const PHI2_3: f64 = 0.11206871748434033;
    /// Prediction of x2 from d.
    const PHI2_4: f64 = 0.030892799233141147;
    /// Prediction of x3 from x2.
    const PHI3_2: f64 = -0.11206871748434033;
    /// Prediction of x3 from x3.
    const PHI3_3: f64 = 0.5412215783233707;
    /// Prediction of x3 from d.
    const PHI3_4: f64 = 0.3745921515889058;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 6.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -106850.90292251826;
    /// Weight of x2 in the law.
    const W1_2: f64 = 1124.1848178645955;
    /// Weight of x3 in the law.
    const W1_3: f64 = -61.894579201640425;
    /// Weight of x2 in the law.
    const W2_2: f64 = -642.8726851005619;
    /// Weight of x3 in the law.
    const W2_3: f64 = 53.018026963569255;
    /// Weight of x2 in the law.
    const W3_2: f64 = 0.8030787004640786;
    /// Weight of x3 in the law.
    const W3_3: f64 = -24.09236101392236;
    /// Weight of x2 in the law.
    const C_2: f64 = 0.29872942459099683;
    /// Weight of x3 in the law.
    const C_3: f64 = 1.238117262270095;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage47Params) -> Result<Self, Error> {
        if !((params.samples > 22) && (params.u_max > 0.0)) {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            x3_hat: 0.0,
            x3_next: 0.0,
            d_hat: 0.0,
            d_next: 0.0,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_next).abs() + (self.x2_next).abs();
        let size = s1 + (self.x3_next).abs() + (self.d_next).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.x3_hat = 0.0;
            self.x3_next = 0.0;
            self.d_hat = 0.0;
            self.d_next = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(y[0].is_finite() && y[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f64;
        let x2: f64;
        let x3: f64;
        let d: f64;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            x3 = y[1];
            d = 0.0;
        } else {
            x1 = self.x1_next + (Self::GAMMA1 * self.u1);
            x2 = self.x2_next + (Self::GAMMA2 * self.u1);
            x3 = self.x3_next + (Self::GAMMA3 * self.u1);
            d = self.d_next;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let miss2 = y[1] - x3;
        let off1 = miss1;
        let off2 = miss2;
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1_1: f64;
        let l1_2: f64;
        let l1_3: f64;
        let l1_4: f64;
        let l2_1: f64;
        let l2_2: f64;
        let l2_3: f64;
        let l2_4: f64;
        if left_o == 0 {
            l1_1 = 0.5288853188994155;
            l1_2 = 11.043581739724111;
            l1_3 = -1.95232951580154;
            l1_4 = -4.310227400623051;
            l2_1 = 0.00186202868892253;
            l2_2 = 0.2724600360147846;
            l2_3 = 1.5302977387244094;
            l2_4 = 2.6662087225258313;
        } else if o0 > 8.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            let s1 = (Self::Q1_1_1 + (Self::Q1_1_2 * o0)) * r0;
            l1_1 = s1 - 0.004980621942852573;
            let s2 = (Self::Q1_2_1 + (Self::Q1_2_2 * o0)) * r0;
            l1_2 = s2 + 0.007132886647707467;
            l1_3 = 0.056139026437663865;
            l1_4 = Self::Q1_4_1 * r0;
            l2_1 = 0.0014392695129337434;
            let s3 = (Self::Q2_2_1 + (Self::Q2_2_2 * o0)) * r0;
            l2_2 = s3 + 0.11089234841732894;
            let s4 = (Self::Q2_3_1 + (Self::Q2_3_2 * o0)) * r0;
            l2_3 = s4 - 0.4680369753891894;
            l2_4 = Self::Q2_4_1 * r0;
        } else if left_o == 8 {
            l1_1 = Self::E0_1_1;
            l1_2 = Self::E0_1_2;
            l1_3 = Self::E0_1_3;
            l1_4 = 0.0;
            l2_1 = Self::E0_2_1;
            l2_2 = Self::E0_2_2;
            l2_3 = Self::E0_2_3;
            l2_4 = Self::E0_2_4;
        } else {
            l1_1 = Self::E1_1_1;
            l1_2 = Self::E1_1_2;
            l1_3 = Self::E1_1_3;
            l1_4 = Self::E1_1_4;
            l2_1 = Self::E1_2_1;
            l2_2 = Self::E1_2_2;
            l2_3 = Self::E1_2_3;
            l2_4 = Self::E1_2_4;
        }
        let s5 = x1 + (Self::PHI1_2 * x2) + (Self::PHI1_3 * x3);
        let x1_on = s5 + (Self::PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
        let s6 = (Self::PHI2_2 * x2) + (Self::PHI2_3 * x3);
        let x2_on = s6 + (Self::PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
        let s7 = (Self::PHI3_2 * x2) + (Self::PHI3_3 * x3);
        let x3_on = s7 + (Self::PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
        let d_on = d + (l1_4 * off1) + (l2_4 * off2);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let v: f64;

        // The exact law in samples.
        let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2) + (Self::W1_3 * x3);
        let z2 = (Self::W2_2 * x2) + (Self::W2_3 * x3);
        let z3 = (Self::W3_2 * x2) + (Self::W3_3 * x3);
        let m0f1 = m0 + 2.0;
        let m0f2 = m0f1 * (m0 + 1.0);
        let s8 = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0);
        v = (s8 + ((Self::C_2 * x2) + (Self::C_3 * x3))) - d;
        if !(v.is_finite()
            && x1_on.is_finite()
            && x2_on.is_finite()
            && x3_on.is_finite()
            && d_on.is_finite())
        {
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
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.d_hat = d;
        self.d_next = d_on;
        self.seen = 1;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if (left as f64) <= Self::HOLD {
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

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
