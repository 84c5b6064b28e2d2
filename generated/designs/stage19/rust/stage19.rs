//! Prescribed-time controller stage19: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero
//! Version 0.1.0, design 837b86fb35a8.
//!
//! Plant: the input V: q' = w, w' = i/(1 + q^2) - w/4, i' = 50*(V - 2*i - w), output q; u held
//!       from sample to sample.
//! Goal: the output and its derivatives up to order 2, x, are 0 at sample N after the start,
//!       from any state, as long as u is not clipped and the plant is the model. f and g are
//!       known at the samples alone, which leaves an error of order h^(5-i) in x_i.
//! Law: with M samples to go and z = S x, w h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2)),
//!       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. Close to the
//!       end deadbeat takes over.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max = inf [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on u = 0 (status AFTER).
//! u is not clipped.
//! Guard none: finite measurements are the responsibility of the caller.
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what f + g u does between
//!       samples, whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
//!   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
//!   loop: not checked: `samples` is left to run time.
//!   envelope: not checked: it does not examine a clock in samples.
//!   zeros: sound: none: the relative degree is 3, the number of states.
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

/// Run-time parameters of [`Stage19`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage19Params {
    /// samples N from the start to rest \[samples\], at least 3.
    pub samples: u32,
    /// sample period \[s\], from 1e-18 to 1e18.
    pub h: f32,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^3\], finite.
    pub k: [f32; 3],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage19 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// samples to go at which deadbeat takes over.
    deadbeat: f32,
    /// weight of x1 in the law.
    w1_1: f32,
    /// weight of x2 in the law.
    w1_2: f32,
    /// weight of x3 in the law.
    w1_3: f32,
    /// weight of x2 in the law.
    w2_2: f32,
    /// weight of x3 in the law.
    w2_3: f32,
    /// weight of x3 in the law.
    w3_3: f32,
    /// weight of x1 in the law.
    b_1: f32,
    /// weight of x2 in the law.
    b_2: f32,
    /// weight of x3 in the law.
    b_3: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage19 {
    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage19Params) -> Result<Self, Error> {
        if !((params.samples > 2)
            && (1e-18 <= params.h)
            && (params.h <= 1e18)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = (params.k[2] - 4.0) + 3.0;
        let s2 = if s1 < 6.0 { 6.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1 = (-params.k[0]) * (1.0 / (params.h * params.h * params.h));
        let w1_2 = params.k[0] * (1.0 / (params.h * params.h));
        let w1_3 = 0.33333334 * (-params.k[0]) * (1.0 / params.h);
        let s3 = ((-1.0) - params.k[1]) + params.k[2];
        let w2_2 = s3 * (1.0 / (params.h * params.h));
        let s4 = (-0.5) * (((-1.0) - params.k[1]) + params.k[2]);
        let w2_3 = s4 * (1.0 / params.h);
        let w3_3 = (3.0 - params.k[2]) * (1.0 / params.h);
        let b_1 = -(1.0 / (params.h * params.h * params.h));
        let b_2 = (-2.0) * (1.0 / (params.h * params.h));
        let b_3 = (-1.8333334) * (1.0 / params.h);
        if !(deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w3_3.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && b_3.is_finite()
            && (params.h * params.h * params.h >= 1e-30)
            && (1.0 / (params.h * params.h * params.h) >= 1e-30))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            deadbeat,
            w1_1,
            w1_2,
            w1_3,
            w2_2,
            w2_3,
            w3_3,
            b_1,
            b_2,
            b_3,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x of the model.
    ///
    /// # Errors
    /// `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f32; 3]) -> Result<Control<f32>, Error> {
        let elapsed = k.wrapping_sub(self.start);

        // The chain of the output.
        let x1 = x[0];
        let x2 = x[1];
        let v1 = 1.0 + (x1 * x1);
        let x3 = (x[2] / v1) - (x2 * 0.25);
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f32;
        let w: f32;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
            let z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
            let z3 = self.w3_3 * x3;
            w = ((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0);
        } else {
            // Deadbeat.
            w = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
        }
        let s1 = ((-50.0) * (x2 + (2.0 * x[2])) * v1) - (x[2] * (2.0 * x1 * x2));
        let v = (w - ((s1 / (v1 * v1)) - (x3 * 0.25))) * v1 * 0.02;
        let (u, status) = if v.is_finite() {
            if elapsed < self.samples {
                (v, Status::Ok)
            } else {
                (0.0, Status::After)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
