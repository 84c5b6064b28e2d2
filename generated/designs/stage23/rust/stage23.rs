//! Prescribed-time controller stage23: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage23 --clock samples --A="[[0,1,0],[0,-1,10],[0,-2,-50]]" --B="[0,0,100]" --C="[[1,0,0]]" --output="[1,0,0]" --observer-poles=-4,-5,-6 --observer-samples=25 --tau=0.5 --eps=0 --poles=-4,-5,-6,-7 --reference input --sample-time=0.01 --delay=1
//! Version 0.1.0, design da426a349de3.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample, one sample late,
//!       y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
//!       row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
//!       the mapping exp. The gains of 4 samples to go stay: they are deadbeat.
//! With the reference r with its derivatives r[0]..r[2] at tick k, x - x_r is in place of x
//!       above, and u = w + u_r, where the inputs under way count less the u_r of their own
//!       samples: with them the output y = x1 is r, and stays so. At sample N x = x_r where
//!       u_r is constant over each sample; else an error of order h^(5-i) is left in y^(i-1).
//! r[3] is r^(3) over the sample in which u acts: its mean, (r^(2)(t + h) - r^(2)(t))/h, or
//!       that in its middle. u_r is the mean over that sample. To four digits, the last at one
//!       time:
//!   x_r1 = r
//!   x_r2 = r^(1)
//!   x_r3 = 0.1*r^(1) + 0.1*r^(2)
//!   u_r = 0.07*r^(1) + 0.051*r^(2) + 0.001*r^(3)
//!
//! Parameters:
//!   samples = 50 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 25 after the start on where the measurement is; with
//!       noise or sensor_step given, or observer_eps, the gains of the observer are then held
//!       below deadbeat.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 50 from any state, but for what r does between samples,
//!       whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
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

/// Run-time parameters of [`Stage23`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage23Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage23 {
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
    /// input on the reference, 1 samples ago.
    u_r1: f64,
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
impl Stage23 {
    /// Prediction from u.
    const GAMMA1: f64 = 0.00014736313620654503;
    /// Prediction from u.
    const GAMMA2: f64 = 0.04245805872561294;
    /// Prediction from u.
    const GAMMA3: f64 = 0.7866781644184895;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 25;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 24.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -24.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = -12098.699806867564;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = 5834.153087954333;
    /// Weight in the observer's gain l2.
    const Q2_3: f64 = -616.5581920200482;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = 90981.25917900148;
    /// Weight in the observer's gain l3.
    const Q3_2: f64 = -29002.765439771665;
    /// Weight in the observer's gain l3.
    const Q3_3: f64 = 2998.7909601002407;
    /// Gain of the observer at its end.
    const E0_1: f64 = 1.0950153689199909;
    /// Gain of the observer at its end.
    const E0_2: f64 = 15.297392853547647;
    /// Gain of the observer at its end.
    const E0_3: f64 = 98.32269091567703;
    /// Gain of the observer at its end.
    const E1_1: f64 = 1.309301083205705;
    /// Gain of the observer at its end.
    const E1_2: f64 = 6.605837883444068;
    /// Gain of the observer at its end.
    const E1_3: f64 = -407.1438225313707;
    /// Gain of the observer at its end.
    const E2_1: f64 = 2.5950153689199906;
    /// Gain of the observer at its end.
    const E2_2: f64 = 180.07490250022406;
    /// Gain of the observer at its end.
    const E2_3: f64 = 358.78371927742626;
    /// Prediction of x1 from x2.
    const PHI1_2: f64 = 0.009947226521739929;
    /// Prediction of x1 from x3.
    const PHI1_3: f64 = 0.00042458058725612934;
    /// Prediction of x2 from x2.
    const PHI2_2: f64 = 0.9892036123037478;
    /// Prediction of x2 from x3.
    const PHI2_3: f64 = 0.07824323585459282;
    /// Prediction of x3 from x2.
    const PHI3_2: f64 = -0.015648647170918566;
    /// Prediction of x3 from x3.
    const PHI3_3: f64 = 0.605811756616243;
    /// Weight of x1 in the law.
    const W1_1: f64 = -1072951.6050632286;
    /// Weight of x2 in the law.
    const W1_2: f64 = 11224.193450693596;
    /// Weight of x3 in the law.
    const W1_3: f64 = -404.795716419329;
    /// Weight of x2 in the law.
    const W2_2: f64 = -6164.422229232715;
    /// Weight of x3 in the law.
    const W2_3: f64 = 332.70200299979865;
    /// Weight of x2 in the law.
    const W3_2: f64 = 15.336789013047456;
    /// Weight of x3 in the law.
    const W3_3: f64 = -153.36789013047456;
    /// Weight of u1 in the law.
    const W4_4: f64 = -16.0;
    /// Weight of x2 in the law.
    const W4_2: f64 = 0.29792241063993585;
    /// Weight of x3 in the law.
    const W4_3: f64 = 8.220775893600642;
    /// Weight of u1 in the law.
    const C_4: f64 = 1.4049846310800091;
    /// Weight of x2 in the law.
    const C_2: f64 = -0.00824128170492625;
    /// Weight of x3 in the law.
    const C_3: f64 = -0.20107642470674394;
    /// Weight of x1 in the law.
    const B_1: f64 = -1277.3233393609864;
    /// Weight of x2 in the law.
    const B_2: f64 = -37.174971411649004;
    /// Weight of x3 in the law.
    const B_3: f64 = -3.523659928569286;
    /// Weight of u1 in the law.
    const B_4: f64 = -2.5950153689199906;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 50;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage23Params) -> Result<Self, Error> {
        if !(params.u_max > 0.0) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            x3_hat: 0.0,
            x3_next: 0.0,
            u_r1: 0.0,
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

    /// u from tick `k`, which may wrap, and what is measured, y = C x, and the reference. Call it
    /// once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1], r: &[f64; 4]) -> Result<Control<f64>, Error> {
        if !(y[0].is_finite()
            && r[0].is_finite()
            && r[1].is_finite()
            && r[2].is_finite()
            && r[3].is_finite())
        {
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
            x1 = self.x1_next + (Self::GAMMA1 * self.u2);
            x2 = self.x2_next + (Self::GAMMA2 * self.u2);
            x3 = self.x3_next + (Self::GAMMA3 * self.u2);
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let off1 = miss1;
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        let l3: f64;
        if o0 > 8.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let r0 = 1.0 / (o0f2 * (o0 - 2.0));
            let s1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
            l1 = s1 - 0.4049846310800092;
            let s2 = (Self::Q2_1 + (Self::Q2_2 * o0) + (Self::Q2_3 * o0f2)) * r0;
            l2 = s2 + 20.107642470674392;
            let s3 = (Self::Q3_1 + (Self::Q3_2 * o0) + (Self::Q3_3 * o0f2)) * r0;
            l3 = s3 - 97.7033199358119;
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

        // The tracking error.
        let u_r = (0.07 * r[1]) + (0.05205 * r[2]) + (0.0017731666666666666 * r[3]);
        let e1 = x1 - r[0];
        let e2 = x2 - r[1];
        let e3 = x3 - ((0.1 * r[1]) + (0.1 * r[2]));
        let v: f64;
        if elapsed < 46 {
            // The exact law in samples.
            let m0 = 53_u32.wrapping_sub(elapsed) as f64;
            let z1 = (Self::W1_1 * e1) + (Self::W1_2 * e2) + (Self::W1_3 * e3);
            let z2 = (Self::W2_2 * e2) + (Self::W2_3 * e3);
            let z3 = (Self::W3_2 * e2) + (Self::W3_3 * e3);
            let s4 = Self::W4_4 * (self.u1 - self.u_r1);
            let z4 = (Self::W4_2 * e2) + (Self::W4_3 * e3) + s4;
            let m0f2 = m0 * (m0 - 1.0);
            let m0f3 = m0f2 * (m0 - 2.0);
            let s5 = Self::C_4 * (self.u1 - self.u_r1);
            let s6 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s6 + ((Self::C_2 * e2) + (Self::C_3 * e3) + s5) + u_r;
        } else {
            // Deadbeat.
            let s7 = (Self::B_1 * e1) + (Self::B_2 * e2) + (Self::B_3 * e3);
            v = s7 + (Self::B_4 * (self.u1 - self.u_r1)) + u_r;
        }
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
        self.u2 = self.u1;
        self.u1 = u_now;
        self.u_r1 = u_r;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.seen = 1;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if elapsed < Self::SAMPLES {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }
}
