//! Prescribed-time controller stage36: outputs of order 2, 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02
//! Version 0.1.0, design 9c23f2154001.
//!
//! Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[2, 1/2],
//!       [1/2, 1]], bias = [3*q1 - c*q2 + w1/4, c*q2]; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
//!       no u is clipped and nothing else acts on the plant.
//! Law of each output, of order n, in its chain xi as it is sampled, which is the output with
//!       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
//!       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
//!       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
//!       law_i. s = 0, 0. Output 1: Close to the end deadbeat takes over. Output 2: Close to
//!       the end deadbeat takes over.
//! Output 1, of order n = 2, to four digits:
//!   xi_1 = q1 - 4.762e-6*w1 + 5.443e-11*w2
//!   xi_2 = w1 - 5.715e-5*w2
//!   f_1 = -1.712*q1 + 1.712*q2 - 0.1598*w1 + 0.01713*w2
//! Output 2, of order n = 2, to four digits:
//!   xi_1 = q2 + 2.381e-6*w1 - 2.722e-11*w2
//!   xi_2 = -2.858e-5*w1 + w2
//!   f_2 = 0.8558*q1 - 2.856*q2 + 0.07988*w1 - 0.02856*w2
//! u = G^-1 w with w_i = v_i - f_i, to four digits:
//!   G^-1 = [[2.003, 0.4999], [0.5, 1]]
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h = 0.02 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!   c = 2 [as in its expression], fixed: parameter of an expression of the design
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
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
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
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

/// Result of a step of several axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f32> {
    /// Inputs of the plants; 0 where `status` is an error.
    pub u: [R; M],
    /// Status of each axis.
    pub axes: [Result<Status, Error>; M],
    /// The error of the first axis that fails; else `Saturated` where one is, else that of the gains.
    pub status: Result<Status, Error>,
}

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

/// Run-time parameters of [`Stage36`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage36Params {
    /// samples N from the start to rest \[samples\], at least 2.
    pub samples: u32,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
    /// rate of stretched time \[1/s\], from 1e-18 to 1e18.
    pub a: f32,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^2\], finite.
    pub k: [f32; 2],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage36 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// samples to go at which deadbeat takes over.
    deadbeat_1: f32,
    /// weight of x1 in the law.
    w1_1_1: f32,
    /// weight of x2 in the law.
    w1_2_1: f32,
    /// weight of x2 in the law.
    w2_2_1: f32,
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
impl Stage36 {
    /// Weight of x1 in the law.
    const B_1_1: f32 = -2500.0;
    /// Weight of x2 in the law.
    const B_2_1: f32 = -75.0;
    /// Weight of x1 in the law.
    const B_1_2: f32 = -2500.0;
    /// Weight of x2 in the law.
    const B_2_2: f32 = -75.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage36Params) -> Result<Self, Error> {
        if !((params.samples > 1)
            && (params.u_max > 0.0)
            && (1e-18 <= params.a)
            && (params.a <= 1e18)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0))
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let s1 = ((params.k[1] / params.a) - 1.0) + 2.0;
        let s2 = if s1 < 4.0 { 4.0 } else { s1 };
        let deadbeat_1 = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let w1_1_1 = 2500.0 * (-(params.k[0] / (params.a * params.a)));
        let w1_2_1 = 50.0 * ((-0.5) * (-(params.k[0] / (params.a * params.a))));
        let w2_2_1 = 50.0 * (1.0 - (params.k[1] / params.a));
        let u_max = params.u_max;
        if !(deadbeat_1.is_finite()
            && w1_1_1.is_finite()
            && w1_2_1.is_finite()
            && w2_2_1.is_finite())
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            deadbeat_1,
            w1_1_1,
            w1_2_1,
            w2_2_1,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of
    /// them is not finite, as at a state at which the inputs do not decouple the outputs, every u
    /// is 0; else the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f32; 4]) -> Axes<2, f32> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite() && x[3].is_finite()) {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of each output as it is sampled.
        let x1_1 = x[0] + ((-4.7624485e-6) * x[2]) + (5.4430127e-11 * x[3]);
        let x2_1 = (1.0000571 * x[2]) + ((-5.71533e-5) * x[3]);
        let x1_2 = x[1] + (2.3814148e-6 * x[2]) + ((-2.7217397e-11) * x[3]);
        let x2_2 = ((-2.857665e-5) * x[2]) + (1.0000952 * x[3]);
        let left = self.samples.saturating_sub(elapsed);
        let m0_1 = left as f32;
        let law_1: f32;
        let m0_2 = left as f32;
        let law_2: f32;
        if m0_1 > self.deadbeat_1 {
            // The exact law in samples.
            let z1_1 = (self.w1_1_1 * x1_1) + (self.w1_2_1 * x2_1);
            let z2_1 = self.w2_2_1 * x2_1;
            law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
        } else {
            // Deadbeat.
            law_1 = (Self::B_1_1 * x1_1) + (Self::B_2_1 * x2_1);
        }
        if m0_2 > self.deadbeat_1 {
            // The exact law in samples.
            let z1_2 = (self.w1_1_1 * x1_2) + (self.w1_2_1 * x2_2);
            let z2_2 = self.w2_2_1 * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
        } else {
            // Deadbeat.
            law_2 = (Self::B_1_2 * x1_2) + (Self::B_2_2 * x2_2);
        }

        // The inputs that give all of them.
        let s1 = ((-1.7116923) * x[0]) + (1.7115782 * x[1]) + ((-0.15976757) * x[2]);
        let v1 = law_1 - (s1 + (0.017126543 * x[3]));
        let s2 = (0.855789 * x[0]) + ((-2.8555987) * x[1]) + (0.07987902 * x[2]);
        let v2 = law_2 - (s2 + ((-0.028563272) * x[3]));
        let control1 = (2.0026014 * v1) + (0.49993333 * v2);
        let control2 = (0.49999994 * v1) + (1.0000666 * v2);
        if elapsed < self.samples {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite() && control2.is_finite() {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            if control1 > self.u_max {
                u[0] = self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -self.u_max {
                u[0] = -self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > self.u_max {
                u[1] = self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -self.u_max {
                u[1] = -self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
        } else {
            u[0] = 0.0;
            if control1.is_finite() {
                axes[0] = status;
            } else {
                axes[0] = Err(Error::Range);
            }
            u[1] = 0.0;
            if control2.is_finite() {
                axes[1] = status;
            } else {
                axes[1] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }
}
