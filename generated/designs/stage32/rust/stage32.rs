//! Prescribed-time controller stage32: outputs of order 2, 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01
//! Version 0.1.0, design 241446d65458.
//!
//! Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
//!       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
//! Goal: every output with its derivatives is 0 at sample N after the start, from any state,
//!       as long as no u is clipped and the plant is the model. The plant is known at the
//!       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
//!       n.
//! Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
//!       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
//!       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
//!       Output 2: Close to the end deadbeat takes over.
//! Output 1, of order n = 2:
//!   x_1 = q1
//!   x_2 = w1
//! Output 2, of order n = 2:
//!   x_1 = q2
//!   x_2 = w2
//! u = M v + bias
//! With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
//!       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
//!       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
//!       constant there.
//! t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
//!       which u acts:
//!   of output 1: r = size*dt^2/(1 + t^2), r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2,
//!       r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 +
//!       t^2)^3
//!   of output 2: r = 0, r^(1) = 0, r^(2) = 0
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!
//! Parameters:
//!   samples = 30 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0.04 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a [1/s]: rate of stretched time
//!   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!   m [as in its expression]: parameter of an expression of the design
//!   size [as in its expression]: parameter of an expression of the design
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: output 1: near rest at sample 30, not at rest: the gains are held from 4
//!       samples to go, and |u| is bounded; so does what f + g u and r do between samples.
//!   sampling: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   deadline: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   loop: not checked: `a` is left to run time.
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

/// Result of a step of several axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f64> {
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

/// Run-time parameters of [`Stage32`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage32Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time \[1/s\], from 1e-150 to 1e150.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^2\], finite.
    pub k: [f64; 2],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub m: f64,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub size: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage32 {
    /// tick at which it was armed.
    start: u32,
    /// parameter of an expression of the design.
    p_size: f64,
    /// derived from the parameters.
    c_r3: f64,
    /// weight of x1 in the law.
    w1_1_1: f64,
    /// weight of x2 in the law.
    w1_2_1: f64,
    /// weight of x2 in the law.
    w2_2_1: f64,
    /// parameter of an expression of the design.
    p_m: f64,
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
impl Stage32 {
    /// 1/100, sample period.
    const H: f64 = 0.01;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 30;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 4.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage32Params) -> Result<Self, Error> {
        if !((params.u_max > 0.0)
            && (1e-150 <= params.a)
            && (params.a <= 1e150)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0)
            && params.m.is_finite()
            && params.size.is_finite())
        {
            return Err(Error::Param);
        }
        let p_size = params.size;
        let c_r3 = 2.0 * p_size;
        let w1_1_1 = 10000.0 * (-(params.k[0] / (params.a * params.a)));
        let w1_2_1 = 100.0 * ((-0.5) * (-(params.k[0] / (params.a * params.a))));
        let w2_2_1 = 100.0 * (1.0 - (params.k[1] / params.a));
        let p_m = params.m;
        let u_max = params.u_max;
        if !(c_r3.is_finite() && w1_1_1.is_finite() && w1_2_1.is_finite() && w2_2_1.is_finite()) {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            p_size,
            c_r3,
            w1_1_1,
            w1_2_1,
            w2_2_1,
            p_m,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of
    /// them is not finite, as at a state at which the inputs do not decouple the outputs, every u
    /// is 0; else the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 4]) -> Axes<2, f64> {
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

        // The chain of each output.
        let x1_1 = x[0];
        let x2_1 = x[2];
        let x1_2 = x[1];
        let x2_2 = x[3];

        // The tracking error.
        let t = (elapsed as f64) * Self::H;
        let v_r1 = t * t;
        let v_r2 = 1.0 + v_r1;
        let reference0_1 = (self.p_size * v_r1) / v_r2;
        let reference1_1 = (self.c_r3 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
        let v_r4 = t + 0.005;
        let v_r5 = v_r4 * v_r4;
        let v_r6 = 1.0 + v_r5;
        let v_r7 = v_r6 * v_r6;
        let s1 = (v_r7 + (4.0 * v_r5 * v_r5)) - (4.0 * v_r6 * v_r4 * v_r4);
        let rho0_1 = (self.c_r3 * (s1 - (v_r6 * v_r5))) / (v_r6 * v_r7);
        let e1_1 = x1_1 - reference0_1;
        let e2_1 = x2_1 - reference1_1;
        let e1_2 = x1_2;
        let e2_2 = x2_2;
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let m0_1 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let law_1: f64;

        // The exact law in samples.
        let z1_1 = (self.w1_1_1 * e1_1) + (self.w1_2_1 * e2_1);
        let z2_1 = self.w2_2_1 * e2_1;
        law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))) + rho0_1;
        let m0_2 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let law_2: f64;
        let z1_2 = (self.w1_1_1 * e1_2) + (self.w1_2_1 * e2_2);
        let z2_2 = self.w2_2_1 * e2_2;
        law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));

        // The inputs that give all of them.
        let s2 = ((self.p_m + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2);
        let control1 = s2 + (self.p_m * x1_2 * x2_1 * x2_2);
        let control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5) - x1_1);
        if (left as f64) > Self::HOLD {
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
