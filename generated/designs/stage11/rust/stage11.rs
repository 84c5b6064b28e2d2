//! Prescribed-time controller stage11: order n = 4, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 4 --mu "exp(a=1)" --name stage11 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7,-8 --precision f32 --eps=0 --sample-time=0.01
//! Version 0.1.0, design a4fcc16c71ec.
//!
//! Plant: x1' = x2, ..., x4' = (u + d), d constant and unknown; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
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

/// Run-time parameters of [`Stage11`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage11Params {
    /// samples N from the start to rest \[samples\], at least 10.
    pub samples: u32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^4\], finite.
    pub k: [f32; 4],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage11 {
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
    /// estimate of x2.
    x2_hat: f32,
    /// estimate of x3.
    x3_hat: f32,
    /// estimate of x4.
    x4_hat: f32,
    /// estimate of d.
    d_hat: f32,
    /// samples to go at which deadbeat takes over.
    deadbeat: f32,
    /// weight of x1 in the law.
    w1_1: f32,
    /// weight of x2 in the law.
    w1_2: f32,
    /// weight of x3 in the law.
    w1_3: f32,
    /// weight of x4 in the law.
    w1_4: f32,
    /// weight of x2 in the law.
    w2_2: f32,
    /// weight of x3 in the law.
    w2_3: f32,
    /// weight of x4 in the law.
    w2_4: f32,
    /// weight of x3 in the law.
    w3_3: f32,
    /// weight of x4 in the law.
    w3_4: f32,
    /// weight of x4 in the law.
    w4_4: f32,
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
impl Stage11 {
    /// 1/100, prediction of x1 from x2.
    const PHI1_2: f32 = 0.01;
    /// 1/20000, prediction of x1 from x3.
    const PHI1_3: f32 = 5e-5;
    /// 1/6000000, prediction of x1 from x4.
    const PHI1_4: f32 = 1.6666667e-7;
    /// 1/2400000000, prediction of x1 from d.
    const PHI1_5: f32 = 4.1666667e-10;
    /// 1/2400000000, prediction from u.
    const GAMMA1: f32 = 4.1666667e-10;
    /// 1/100, prediction of x2 from x3.
    const PHI2_3: f32 = 0.01;
    /// 1/20000, prediction of x2 from x4.
    const PHI2_4: f32 = 5e-5;
    /// 1/6000000, prediction of x2 from d.
    const PHI2_5: f32 = 1.6666667e-7;
    /// 1/6000000, prediction from u.
    const GAMMA2: f32 = 1.6666667e-7;
    /// 1/100, prediction of x3 from x4.
    const PHI3_4: f32 = 0.01;
    /// 1/20000, prediction of x3 from d.
    const PHI3_5: f32 = 5e-5;
    /// 1/20000, prediction from u.
    const GAMMA3: f32 = 5e-5;
    /// 1/100, prediction of x4 from d.
    const PHI4_5: f32 = 0.01;
    /// 1/100, prediction from u.
    const GAMMA4: f32 = 0.01;
    /// Weight in the observer's gain l1.
    const Q1_1: f32 = 6720.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f32 = -4200.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f32 = 1200.0;
    /// Weight in the observer's gain l1.
    const Q1_4: f32 = -200.0;
    /// Weight in the observer's gain l1.
    const Q1_5: f32 = 20.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f32 = -808000.0;
    /// Weight in the observer's gain l2.
    const Q2_2: f32 = 454000.0;
    /// Weight in the observer's gain l2.
    const Q2_3: f32 = -108000.0;
    /// Weight in the observer's gain l2.
    const Q2_4: f32 = 12000.0;
    /// Weight in the observer's gain l3.
    const Q3_1: f32 = 38400000.0;
    /// Weight in the observer's gain l3.
    const Q3_2: f32 = -16800000.0;
    /// Weight in the observer's gain l3.
    const Q3_3: f32 = 2400000.0;
    /// Weight in the observer's gain l4.
    const Q4_1: f32 = -480000000.0;
    /// Weight in the observer's gain l4.
    const Q4_2: f32 = 120000000.0;
    /// 1675/33, gain of the observer at its end.
    const E0_2: f32 = 50.757576;
    /// 1092500/297, gain of the observer at its end.
    const E0_3: f32 = 3678.4512;
    /// -500000/3, gain of the observer at its end.
    const E0_4: f32 = -166666.67;
    /// 700000000/99, gain of the observer at its end.
    const E0_5: f32 = 7070707.0;
    /// 7850/99, gain of the observer at its end.
    const E1_2: f32 = 79.29293;
    /// -140000/99, gain of the observer at its end.
    const E1_3: f32 = -1414.1414;
    /// 23000000/33, gain of the observer at its end.
    const E1_4: f32 = 696969.7;
    /// -1600000000/33, gain of the observer at its end.
    const E1_5: f32 = -48484850.0;
    /// 950/9, gain of the observer at its end.
    const E2_2: f32 = 105.55556;
    /// -10000/9, gain of the observer at its end.
    const E2_3: f32 = -1111.1111;
    /// -1000000/3, gain of the observer at its end.
    const E2_4: f32 = -333333.34;
    /// 400000000/3, gain of the observer at its end.
    const E2_5: f32 = 133333336.0;
    /// 1250/9, gain of the observer at its end.
    const E3_2: f32 = 138.88889;
    /// 100000/27, gain of the observer at its end.
    const E3_3: f32 = 3703.7036;
    /// -5000000/3, gain of the observer at its end.
    const E3_4: f32 = -1666666.6;
    /// -1600000000/9, gain of the observer at its end.
    const E3_5: f32 = -177777780.0;
    /// 625/3, gain of the observer at its end.
    const E4_2: f32 = 208.33333;
    /// 87500/3, gain of the observer at its end.
    const E4_3: f32 = 29166.666;
    /// Gain of the observer at its end.
    const E4_4: f32 = 2500000.0;
    /// Gain of the observer at its end.
    const E4_5: f32 = 100000000.0;
    /// Weight of x1 in the law.
    const B_1: f32 = -100000000.0;
    /// Weight of x2 in the law.
    const B_2: f32 = -2500000.0;
    /// -87500/3, weight of x3 in the law.
    const B_3: f32 = -29166.666;
    /// -625/3, weight of x4 in the law.
    const B_4: f32 = -208.33333;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage11Params) -> Result<Self, Error> {
        if !((params.samples > 9)
            && (params.u_max > 0.0)
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
        let s1 = (params.k[3] - 9.0) + 4.0;
        let s2 = if s1 < 8.0 { 8.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1 = 100000000.0 * (-params.k[0]);
        let w1_2 = 1000000.0 * ((-1.5) * (-params.k[0]));
        let w1_3 = 10000.0 * (0.9166667 * (-params.k[0]));
        let w1_4 = 100.0 * ((-0.25) * (-params.k[0]));
        let s3 = ((1.0 - params.k[1]) + params.k[2]) - params.k[3];
        let w2_2 = 1000000.0 * s3;
        let s4 = -(((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w2_3 = 10000.0 * s4;
        let s5 = ((1.0 - params.k[1]) + params.k[2]) - params.k[3];
        let w2_4 = 100.0 * (0.33333334 * s5);
        let w3_3 = 10000.0 * (((-7.0) - params.k[2]) + (3.0 * params.k[3]));
        let w3_4 = 100.0 * ((-0.5) * (((-7.0) - params.k[2]) + (3.0 * params.k[3])));
        let w4_4 = 100.0 * (6.0 - params.k[3]);
        let u_max = params.u_max;
        if !(deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w1_4.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w2_4.is_finite()
            && w3_3.is_finite()
            && w3_4.is_finite()
            && w4_4.is_finite())
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            x4_hat: 0.0,
            d_hat: 0.0,
            deadbeat,
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
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.x3_hat).abs();
        let size = s1 + (self.x4_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e18) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.x3_hat = 0.0;
            self.x4_hat = 0.0;
            self.d_hat = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f32; 1]) -> Result<Control<f32>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (Self::PHI1_2 * self.x2_hat);
        let s2 = s1 + (Self::PHI1_3 * self.x3_hat);
        let s3 = s2 + (Self::PHI1_4 * self.x4_hat);
        let s4 = s3 + (Self::PHI1_5 * self.d_hat);
        let p1 = s4 + (Self::GAMMA1 * self.u1);
        let s5 = self.x2_hat + (Self::PHI2_3 * self.x3_hat);
        let s6 = s5 + (Self::PHI2_4 * self.x4_hat);
        let s7 = s6 + (Self::PHI2_5 * self.d_hat);
        let p2 = s7 + (Self::GAMMA2 * self.u1);
        let s8 = self.x3_hat + (Self::PHI3_4 * self.x4_hat);
        let s9 = s8 + (Self::PHI3_5 * self.d_hat);
        let p3 = s9 + (Self::GAMMA3 * self.u1);
        let s10 = self.x4_hat + (Self::PHI4_5 * self.d_hat);
        let p4 = s10 + (Self::GAMMA4 * self.u1);
        let p5 = self.d_hat;

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
        let l3: f32;
        let l4: f32;
        let l5: f32;
        if o0 > 12.0 {
            let r0 = 1.0 / o0;
            let r1 = 1.0 / (o0 - 1.0);
            let r2 = 1.0 / (o0 - 2.0);
            let r3 = 1.0 / (o0 - 3.0);
            let r4 = 1.0 / (o0 - 4.0);
            let s11 = ((((Self::Q1_1 * r0) + Self::Q1_2) * r1) + Self::Q1_3) * r2;
            l1 = (((s11 + Self::Q1_4) * r3) + Self::Q1_5) * r4;
            let s12 = ((((Self::Q2_1 * r0) + Self::Q2_2) * r1) + Self::Q2_3) * r2;
            l2 = (s12 + Self::Q2_4) * r3 * r4;
            let s13 = ((((Self::Q3_1 * r0) + Self::Q3_2) * r1) + Self::Q3_3) * r2;
            l3 = s13 * r3 * r4;
            l4 = ((Self::Q4_1 * r0) + Self::Q4_2) * r1 * r2 * r3 * r4;
            l5 = 0.0;
        } else if left_o == 12 {
            l1 = 1.0;
            l2 = Self::E0_2;
            l3 = Self::E0_3;
            l4 = Self::E0_4;
            l5 = Self::E0_5;
        } else if left_o == 11 {
            l1 = 1.0;
            l2 = Self::E1_2;
            l3 = Self::E1_3;
            l4 = Self::E1_4;
            l5 = Self::E1_5;
        } else if left_o == 10 {
            l1 = 1.0;
            l2 = Self::E2_2;
            l3 = Self::E2_3;
            l4 = Self::E2_4;
            l5 = Self::E2_5;
        } else if left_o == 9 {
            l1 = 1.0;
            l2 = Self::E3_2;
            l3 = Self::E3_3;
            l4 = Self::E3_4;
            l5 = Self::E3_5;
        } else {
            l1 = 1.0;
            l2 = Self::E4_2;
            l3 = Self::E4_3;
            l4 = Self::E4_4;
            l5 = Self::E4_5;
        }
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let x3 = p3 + (l3 * miss);
        let x4 = p4 + (l4 * miss);
        let d = p5 + (l5 * miss);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f32;
        let v: f32;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let s14 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
            let z1 = s14 + (self.w1_4 * x4);
            let z2 = (self.w2_2 * x2) + (self.w2_3 * x3) + (self.w2_4 * x4);
            let z3 = (self.w3_3 * x3) + (self.w3_4 * x4);
            let z4 = self.w4_4 * x4;
            let s15 = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) + z4;
            v = (s15 / (m0 - 3.0)) - d;
        } else {
            // Deadbeat.
            let s16 = (Self::B_1 * x1) + (Self::B_2 * x2) + (Self::B_3 * x3);
            v = (s16 + (Self::B_4 * x4)) - d;
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
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.x3_hat = x3;
        self.x4_hat = x4;
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
    pub fn estimate(&self) -> [f32; 4] {
        [self.x1_hat, self.x2_hat, self.x3_hat, self.x4_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f32 {
        self.d_hat
    }
}
