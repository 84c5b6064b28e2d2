//! Prescribed-time controller stage44: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage44 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0]]" --delay-law=predict --observer-poles=-4,-5,-6 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --delay=1.5
//! Version 0.1.0, design 985c02d3ad50.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 1.5 samples late,
//!       y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
//!       z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for the
//!       mapping exp. The gains of 8 samples to go stay.
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

/// Run-time parameters of [`Stage44`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage44Params {
    /// samples N from the start to rest \[samples\], at least 10.
    pub samples: u32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage44 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
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
impl Stage44 {
    /// Prediction from u.
    const GAMMA1: f64 = 9.353143640028875e-5;
    /// Prediction from u.
    const LATE_GAMMA1: f64 = 1.4506885866158227e-5;
    /// Prediction from u.
    const GAMMA2: f64 = 0.02240015856569381;
    /// Prediction from u.
    const LATE_GAMMA2: f64 = 0.008492640667447336;
    /// Prediction from u.
    const GAMMA3: f64 = 0.15880933131841984;
    /// Prediction from u.
    const LATE_GAMMA3: f64 = 0.21578282027048595;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 24.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -24.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = -12889.952685745366;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = 6304.212917508586;
    /// Weight in the observer's gain l2.
    const Q2_3: f64 = -742.8703573620571;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = 72521.99132748511;
    /// Weight in the observer's gain l3.
    const Q3_2: f64 = -24808.851670034343;
    /// Weight in the observer's gain l3.
    const Q3_3: f64 = 2767.4814294482285;
    /// Gain of the observer at its end.
    const E0_1: f64 = 1.026982402667958;
    /// Gain of the observer at its end.
    const E0_2: f64 = 9.393065010983802;
    /// Gain of the observer at its end.
    const E0_3: f64 = 72.1724949708503;
    /// Gain of the observer at its end.
    const E1_1: f64 = 1.2412681169536723;
    /// Gain of the observer at its end.
    const E1_2: f64 = -0.9955098611216602;
    /// Gain of the observer at its end.
    const E1_3: f64 = -271.5264302640074;
    /// Gain of the observer at its end.
    const E2_1: f64 = 2.526982402667958;
    /// Gain of the observer at its end.
    const E2_2: f64 = 168.91277532831796;
    /// Gain of the observer at its end.
    const E2_3: f64 = 171.81438886235838;
    /// Prediction of x1 from x2.
    const PHI1_2: f64 = 0.009942671770940647;
    /// Prediction of x1 from x3.
    const PHI1_3: f64 = 0.000617855984662823;
    /// Prediction of x2 from x2.
    const PHI2_2: f64 = 0.9857608243445873;
    /// Prediction of x2 from x3.
    const PHI2_3: f64 = 0.11206871748434033;
    /// Prediction of x3 from x2.
    const PHI3_2: f64 = -0.11206871748434033;
    /// Prediction of x3 from x3.
    const PHI3_3: f64 = 0.5412215783233707;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 6.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -106850.90292251826;
    /// Weight of x2 in the law.
    const W1_2: f64 = -482.3692808208648;
    /// Weight of x3 in the law.
    const W1_3: f64 = 4.807633485406011;
    /// Weight of u1 in the law.
    const W1_4: f64 = -1.2197801784387233e-74;
    /// Weight of u2 in the law.
    const W1_5: f64 = 4.609258112111791;
    /// Weight of x2 in the law.
    const W2_2: f64 = -633.6322203514217;
    /// Weight of x3 in the law.
    const W2_3: f64 = -73.36956899710586;
    /// Weight of u1 in the law.
    const W2_4: f64 = -1.2733281521282373e-76;
    /// Weight of u2 in the law.
    const W2_5: f64 = -14.786896717013052;
    /// Weight of x2 in the law.
    const W3_2: f64 = 4.311208496599377;
    /// Weight of x3 in the law.
    const W3_3: f64 = -9.337493806987991;
    /// Weight of u1 in the law.
    const W3_4: f64 = -9.0;
    /// Weight of u2 in the law.
    const W3_5: f64 = -2.7645844206856207;
    /// Weight of x2 in the law.
    const C_2: f64 = 0.10945032226632541;
    /// Weight of x3 in the law.
    const C_3: f64 = 0.5296658086896372;
    /// Weight of u1 in the law.
    const C_4: f64 = 0.47301759733204196;
    /// Weight of u2 in the law.
    const C_5: f64 = 0.15314166966017376;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage44Params) -> Result<Self, Error> {
        if !((params.samples > 9) && (params.u_max > 0.0)) {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            x3_hat: 0.0,
            x3_next: 0.0,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_next).abs() + (self.x2_next).abs();
        let size = s1 + (self.x3_next).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.x3_hat = 0.0;
            self.x3_next = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f64;
        let x2: f64;
        let x3: f64;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            x3 = 0.0;
        } else {
            let s1 = (Self::GAMMA1 * self.u3) + (Self::LATE_GAMMA1 * self.u2);
            x1 = self.x1_next + s1;
            let s2 = (Self::GAMMA2 * self.u3) + (Self::LATE_GAMMA2 * self.u2);
            x2 = self.x2_next + s2;
            let s3 = (Self::GAMMA3 * self.u3) + (Self::LATE_GAMMA3 * self.u2);
            x3 = self.x3_next + s3;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let off1 = miss1;
        let left_o = (self.samples / 2).saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        let l3: f64;
        if o0 > 8.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let r0 = 1.0 / (o0f2 * (o0 - 2.0));
            let s4 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
            l1 = s4 - 0.47301759733204196;
            let s5 = (Self::Q2_1 + (Self::Q2_2 * o0) + (Self::Q2_3 * o0f2)) * r0;
            l2 = s5 + 26.72716299730578;
            let s6 = (Self::Q3_1 + (Self::Q3_2 * o0) + (Self::Q3_3 * o0f2)) * r0;
            l3 = s6 - 98.86735283457841;
        } else if left_o == 8 {
            l1 = Self::E0_1;
            l2 = Self::E0_2;
            l3 = Self::E0_3;
        } else if left_o == 7 {
            l1 = Self::E1_1;
            l2 = Self::E1_2;
            l3 = Self::E1_3;
        } else {
            l1 = Self::E2_1;
            l2 = Self::E2_2;
            l3 = Self::E2_3;
        }
        let x1_on = x1 + (Self::PHI1_2 * x2) + (Self::PHI1_3 * x3) + (l1 * off1);
        let x2_on = (Self::PHI2_2 * x2) + (Self::PHI2_3 * x3) + (l2 * off1);
        let x3_on = (Self::PHI3_2 * x2) + (Self::PHI3_3 * x3) + (l3 * off1);
        let left = self.samples.saturating_sub(elapsed);
        let s7 = (left as f64) - 2.0;
        let m0 = if s7 < Self::HOLD { Self::HOLD } else { s7 };
        let v: f64;

        // The exact law in samples.
        let s8 = (Self::W1_1 * x1) + (Self::W1_2 * x2) + (Self::W1_3 * x3);
        let z1 = s8 + (Self::W1_4 * self.u1) + (Self::W1_5 * self.u2);
        let s9 = (Self::W2_2 * x2) + (Self::W2_3 * x3);
        let z2 = s9 + (Self::W2_4 * self.u1) + (Self::W2_5 * self.u2);
        let s10 = (Self::W3_2 * x2) + (Self::W3_3 * x3);
        let z3 = s10 + (Self::W3_4 * self.u1) + (Self::W3_5 * self.u2);
        let m0f1 = m0 + 2.0;
        let m0f2 = m0f1 * (m0 + 1.0);
        let s11 = (Self::C_2 * x2) + (Self::C_3 * x3);
        let s12 = s11 + (Self::C_4 * self.u1) + (Self::C_5 * self.u2);
        v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)) + s12;
        if !(v.is_finite() && x1_on.is_finite() && x2_on.is_finite() && x3_on.is_finite()) {
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
        self.u3 = self.u2;
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.seen = 1;
        let status = if (v > self.u_max) || (v < -self.u_max) {
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
    pub fn estimate(&self) -> [f64; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }
}
