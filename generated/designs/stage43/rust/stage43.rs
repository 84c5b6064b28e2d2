//! Prescribed-time controller stage43: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75
//! Version 0.1.0, design c760bae9e1f5.
//!
//! Plant: x1' = x2, ..., x3' = (u + d), d constant and unknown; u held from sample to sample,
//!       2.75 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
//!       the rows are those of Theorem 1 for the mapping exp. The gains of 6 samples to go
//!       stay: they are deadbeat.
//! With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
//!       where the inputs under way count less the rho of their own samples. At sample N e is
//!       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
//!       e_i.
//! t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
//!       which u acts:
//!   e_i = x_i - r^(i-1), with the reference r = t^2/2
//!   r^(1) = t
//!   r^(2) = 1
//!
//! Parameters:
//!   samples = 40 [samples], fixed: samples N from the start to rest
//!   h = 1e-2 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max = 6 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 20 after the start on where the measurement is; with
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
//!   growth: sound: at rest at sample 40 from any state, but for what r does between samples,
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

/// Run-time parameters of [`Stage43`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage43Params {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage43 {
    /// tick at which it was armed.
    start: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// input of 3 samples ago.
    u3: f64,
    /// input of 4 samples ago.
    u4: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of x3.
    x3_hat: f64,
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
impl Stage43 {
    /// 1/100, prediction of x1 from x2.
    const PHI1_2: f64 = 0.01;
    /// 1/20000, prediction of x1 from x3.
    const PHI1_3: f64 = 5e-5;
    /// 21/128000000, prediction from u.
    const GAMMA1: f64 = 1.640625e-7;
    /// 1/384000000, prediction from u.
    const LATE_GAMMA1: f64 = 2.604166666666667e-9;
    /// 1/6000000, prediction of x1 from d.
    const PHI1_4: f64 = 1.6666666666666668e-7;
    /// 1/100, prediction of x2 from x3.
    const PHI2_3: f64 = 0.01;
    /// 3/64000, prediction from u.
    const GAMMA2: f64 = 4.6875e-5;
    /// 1/320000, prediction from u.
    const LATE_GAMMA2: f64 = 3.125e-6;
    /// 1/20000, prediction of x2 from d.
    const PHI2_4: f64 = 5e-5;
    /// 3/400, prediction from u.
    const GAMMA3: f64 = 0.0075;
    /// 1/400, prediction from u.
    const LATE_GAMMA3: f64 = 0.0025;
    /// 1/100, prediction of x3 from d.
    const PHI3_4: f64 = 0.01;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 20;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = -840.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = 480.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = -120.0;
    /// Weight in the observer's gain l1.
    const Q1_4: f64 = 16.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = 90800.0;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = -43200.0;
    /// Weight in the observer's gain l2.
    const Q2_3: f64 = 7200.0;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = -3360000.0;
    /// Weight in the observer's gain l3.
    const Q3_2: f64 = 960000.0;
    /// Weight in the observer's gain l4.
    const Q4_1: f64 = 24000000.0;
    /// 430/9, gain of the observer at its end.
    const E0_2: f64 = 47.77777777777778;
    /// 8000/3, gain of the observer at its end.
    const E0_3: f64 = 2666.6666666666665;
    /// -200000/3, gain of the observer at its end.
    const E0_4: f64 = -66666.66666666667;
    /// 2200/27, gain of the observer at its end.
    const E1_2: f64 = 81.48148148148148;
    /// -20000/9, gain of the observer at its end.
    const E1_3: f64 = -2222.222222222222;
    /// 4000000/9, gain of the observer at its end.
    const E1_4: f64 = 444444.44444444444;
    /// 350/3, gain of the observer at its end.
    const E2_2: f64 = 116.66666666666667;
    /// Gain of the observer at its end.
    const E2_4: f64 = -1000000.0;
    /// 550/3, gain of the observer at its end.
    const E3_2: f64 = 183.33333333333334;
    /// Gain of the observer at its end.
    const E3_3: f64 = 20000.0;
    /// Gain of the observer at its end.
    const E3_4: f64 = 1000000.0;
    /// 1/100, sample period.
    const H: f64 = 0.01;
    /// Weight of x1 in the law.
    const W1_1: f64 = -120000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = -2100000.0;
    /// Weight of x3 in the law.
    const W1_3: f64 = -16375.0;
    /// -1155/16, weight of u3 in the law.
    const W1_6: f64 = -72.1875;
    /// Weight of x2 in the law.
    const W2_2: f64 = -600000.0;
    /// Weight of x3 in the law.
    const W2_3: f64 = -13500.0;
    /// Weight of u2 in the law.
    const W2_5: f64 = -60.0;
    /// -675/8, weight of u3 in the law.
    const W2_6: f64 = -84.375;
    /// Weight of x3 in the law.
    const W3_3: f64 = -1200.0;
    /// Weight of u1 in the law.
    const W3_4: f64 = -12.0;
    /// Weight of u2 in the law.
    const W3_5: f64 = -12.0;
    /// Weight of u3 in the law.
    const W3_6: f64 = -9.0;
    /// Bound of |u|.
    const U_MAX: f64 = 6.0;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 40;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage43Params) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
            u4: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            d_hat: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there. Estimates and inputs under way are kept. Estimates too large to compute with
    /// begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.x3_hat).abs();
        let size = s1 + (self.d_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.x3_hat = 0.0;
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
        let s2 = s1 + (Self::PHI1_3 * self.x3_hat);
        let s3 = (Self::GAMMA1 * self.u4) + (Self::LATE_GAMMA1 * self.u3);
        let p1 = s2 + (Self::PHI1_4 * self.d_hat) + s3;
        let s4 = self.x2_hat + (Self::PHI2_3 * self.x3_hat);
        let s5 = (Self::GAMMA2 * self.u4) + (Self::LATE_GAMMA2 * self.u3);
        let p2 = s4 + (Self::PHI2_4 * self.d_hat) + s5;
        let s6 = (Self::GAMMA3 * self.u4) + (Self::LATE_GAMMA3 * self.u3);
        let p3 = self.x3_hat + (Self::PHI3_4 * self.d_hat) + s6;
        let p4 = self.d_hat;

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
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        let l3: f64;
        let l4: f64;
        if o0 > 10.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let o0f3 = o0f2 * (o0 - 2.0);
            let r0 = 1.0 / (o0f3 * (o0 - 3.0));
            let s7 = Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2);
            l1 = (s7 + (Self::Q1_4 * o0f3)) * r0;
            l2 = (Self::Q2_1 + (Self::Q2_2 * o0) + (Self::Q2_3 * o0f2)) * r0;
            l3 = (Self::Q3_1 + (Self::Q3_2 * o0)) * r0;
            l4 = Self::Q4_1 * r0;
        } else if left_o == 10 {
            l1 = 1.0;
            l2 = Self::E0_2;
            l3 = Self::E0_3;
            l4 = Self::E0_4;
        } else if left_o == 9 {
            l1 = 1.0;
            l2 = Self::E1_2;
            l3 = Self::E1_3;
            l4 = Self::E1_4;
        } else if left_o == 8 {
            l1 = 1.0;
            l2 = Self::E2_2;
            l3 = 0.0;
            l4 = Self::E2_4;
        } else {
            l1 = 1.0;
            l2 = Self::E3_2;
            l3 = Self::E3_3;
            l4 = Self::E3_4;
        }
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let x3 = p3 + (l3 * miss);
        let d = p4 + (l4 * miss);

        // The tracking error.
        let t = (elapsed as f64) * Self::H;
        let reference1 = t;
        let reference0 = reference1 * reference1 * 0.5;
        let e1 = x1 - reference0;
        let e2 = x2 - reference1;
        let e3 = x3 - 1.0;
        let v: f64;

        // The exact law in samples.
        let m0 = if elapsed < 34 {
            40_u32.wrapping_sub(elapsed) as f64
        } else {
            6.0
        };
        let s8 = (Self::W1_1 * e1) + (Self::W1_2 * e2) + (Self::W1_3 * e3);
        let z1 = s8 + (Self::W1_6 * (self.u3 + d));
        let s9 = (Self::W2_2 * e2) + (Self::W2_3 * e3);
        let s10 = s9 + (Self::W2_5 * (self.u2 + d));
        let z2 = s10 + (Self::W2_6 * (self.u3 + d));
        let s11 = (Self::W3_3 * e3) + (Self::W3_4 * (self.u1 + d));
        let s12 = s11 + (Self::W3_5 * (self.u2 + d));
        let z3 = s12 + (Self::W3_6 * (self.u3 + d));
        let m0f2 = m0 * (m0 - 1.0);
        v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - d;
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
        self.u4 = self.u3;
        self.u3 = self.u2;
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.x3_hat = x3;
        self.d_hat = d;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
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

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
