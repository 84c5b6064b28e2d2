//! Prescribed-time controller stage20: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25
//! Version 0.1.0, design c90aea54cafb.
//!
//! Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
//!       1.25 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//! With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
//!       where the inputs under way count less the rho of their own samples. At sample N e is
//!       0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
//!       e_i.
//! e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
//!       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
//!       r^(n-1)(t))/h, or that in its middle.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
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
//! Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what r does between samples,
//!       whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
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

/// Run-time parameters of [`Stage20`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage20Params {
    /// samples N from the start to rest \[samples\], at least 8.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^4\], finite.
    pub k: [f64; 4],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage20 {
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
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of d.
    d_hat: f64,
    /// prediction of x1 from x2.
    phi1_2: f64,
    /// prediction of x1 from d.
    phi1_3: f64,
    /// prediction from u.
    gamma1: f64,
    /// prediction from u.
    late_gamma1: f64,
    /// prediction of x2 from d.
    phi2_3: f64,
    /// prediction from u.
    gamma2: f64,
    /// prediction from u.
    late_gamma2: f64,
    /// weight in the observer's gain l2.
    q2_1: f64,
    /// weight in the observer's gain l2.
    q2_2: f64,
    /// weight in the observer's gain l3.
    q3_1: f64,
    /// gain of the observer at its end.
    e2_2: f64,
    /// gain of the observer at its end.
    e2_3: f64,
    /// gain of the observer at its end.
    e1_2: f64,
    /// gain of the observer at its end.
    e1_3: f64,
    /// gain of the observer at its end.
    e0_2: f64,
    /// gain of the observer at its end.
    e0_3: f64,
    /// last one of r, 1 samples ago.
    rho1: f64,
    /// last one of r, 2 samples ago.
    rho2: f64,
    /// samples to go at which deadbeat takes over.
    deadbeat: f64,
    /// weight of x1 in the law.
    w1_1: f64,
    /// weight of x2 in the law.
    w1_2: f64,
    /// weight of u2 in the law.
    w1_4: f64,
    /// weight of x2 in the law.
    w2_2: f64,
    /// weight of u2 in the law.
    w2_4: f64,
    /// weight of u2 in the law.
    w3_4: f64,
    /// weight of u1 in the law.
    w4_3: f64,
    /// weight of u2 in the law.
    w4_4: f64,
    /// weight of x1 in the law.
    b_1: f64,
    /// weight of x2 in the law.
    b_2: f64,
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
impl Stage20 {
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 120.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -60.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// Weight of u1 in the law.
    const C_3: f64 = 2.0;
    /// Weight of u1 in the law.
    const B_3: f64 = -2.0;
    /// -21/32, weight of u2 in the law.
    const B_4: f64 = -0.65625;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage20Params) -> Result<Self, Error> {
        if !((params.samples > 7)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
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
        let phi1_2 = params.h;
        let phi1_3 = 0.25 * (params.h * params.h);
        let gamma1 = 0.109375 * (params.h * params.h);
        let late_gamma1 = 0.140625 * (params.h * params.h);
        let phi2_3 = 0.5 * params.h;
        let gamma2 = 0.125 * params.h;
        let late_gamma2 = 0.375 * params.h;
        let q2_1 = (-108.0) * (1.0 / params.h);
        let q2_2 = 36.0 * (1.0 / params.h);
        let q3_1 = 48.0 * (1.0 / (params.h * params.h));
        let e2_2 = 1.5 * (1.0 / params.h);
        let e2_3 = 2.0 * (1.0 / (params.h * params.h));
        let e1_2 = 0.8571428571428571 * (1.0 / params.h);
        let e1_3 = (-0.5714285714285714) * (1.0 / (params.h * params.h));
        let e0_2 = 0.42857142857142855 * (1.0 / params.h);
        let e0_3 = 0.2857142857142857 * (1.0 / (params.h * params.h));
        let s1 = (params.k[3] - 9.0) + 4.0;
        let s2 = if s1 < 8.0 { 8.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1 = 2.0 * (-params.k[0]) * (1.0 / (params.h * params.h));
        let w1_2 = (-2.5) * (-params.k[0]) * (1.0 / params.h);
        let w1_4 = 0.65625 * (-params.k[0]);
        let s3 = 2.0 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w2_2 = s3 * (1.0 / params.h);
        let w2_4 = (-0.75) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w3_4 = ((-7.0) - params.k[2]) + (3.0 * params.k[3]);
        let w4_3 = 6.0 - params.k[3];
        let w4_4 = -(6.0 - params.k[3]);
        let b_1 = (-2.0) * (1.0 / (params.h * params.h));
        let b_2 = (-5.5) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(phi1_3.is_finite()
            && gamma1.is_finite()
            && late_gamma1.is_finite()
            && phi2_3.is_finite()
            && gamma2.is_finite()
            && late_gamma2.is_finite()
            && q2_1.is_finite()
            && q2_2.is_finite()
            && q3_1.is_finite()
            && e2_2.is_finite()
            && e2_3.is_finite()
            && e1_2.is_finite()
            && e1_3.is_finite()
            && e0_2.is_finite()
            && e0_3.is_finite()
            && deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_4.is_finite()
            && w2_2.is_finite()
            && w2_4.is_finite()
            && w3_4.is_finite()
            && w4_3.is_finite()
            && w4_4.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && (params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            d_hat: 0.0,
            phi1_2,
            phi1_3,
            gamma1,
            late_gamma1,
            phi2_3,
            gamma2,
            late_gamma2,
            q2_1,
            q2_2,
            q3_1,
            e2_2,
            e2_3,
            e1_2,
            e1_3,
            e0_2,
            e0_3,
            rho1: 0.0,
            rho2: 0.0,
            deadbeat,
            w1_1,
            w1_2,
            w1_4,
            w2_2,
            w2_4,
            w3_4,
            w4_3,
            w4_4,
            b_1,
            b_2,
            u_max,
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

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the reference.
    /// Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1], r: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(y[0].is_finite() && r[0].is_finite() && r[1].is_finite() && r[2].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
        let s2 = self.late_gamma1 * (self.u2 + 0.5);
        let s3 = (self.gamma1 * (self.u3 + 0.5)) + s2;
        let p1 = s1 + (self.phi1_3 * self.d_hat) + s3;
        let s4 = self.late_gamma2 * (self.u2 + 0.5);
        let s5 = self.x2_hat + (self.phi2_3 * self.d_hat);
        let p2 = s5 + ((self.gamma2 * (self.u3 + 0.5)) + s4);
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
        let left_o = (self.samples / 2).saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        let l3: f64;
        if o0 > 8.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
            l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
            l3 = self.q3_1 * r0;
        } else if left_o == 8 {
            l1 = 1.0;
            l2 = self.e0_2;
            l3 = self.e0_3;
        } else if left_o == 7 {
            l1 = 1.0;
            l2 = self.e1_2;
            l3 = self.e1_3;
        } else {
            l1 = 1.0;
            l2 = self.e2_2;
            l3 = self.e2_3;
        }
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);

        // The tracking error.
        let e1 = x1 - r[0];
        let e2 = x2 - r[1];
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f64;
        let v: f64;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let s6 = self.w1_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
            let z1 = (self.w1_1 * e1) + (self.w1_2 * e2) + s6;
            let s7 = self.w2_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
            let z2 = (self.w2_2 * e2) + s7;
            let z3 = self.w3_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
            let s8 = self.w4_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
            let z4 = s8 + (self.w4_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2)));
            let m0f2 = m0 * (m0 - 1.0);
            let m0f3 = m0f2 * (m0 - 2.0);
            let s9 = Self::C_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
            let s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            let s11 = (s10 + (s9 - ((self.u2 + (d + 0.5)) - (2.0 * self.rho2)))) - (d + 0.5);
            v = s11 + (2.0 * r[2]);
        } else {
            // Deadbeat.
            let s12 = Self::B_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
            let s13 = Self::B_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
            let s14 = ((self.b_1 * e1) + (self.b_2 * e2) + s12 + s13) - (d + 0.5);
            v = s14 + (2.0 * r[2]);
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
        self.u3 = self.u2;
        self.u2 = self.u1;
        self.u1 = u_now;
        self.rho2 = self.rho1;
        self.rho1 = r[2];
        self.x1_hat = x1;
        self.x2_hat = x2;
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
    pub fn estimate(&self) -> [f64; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
