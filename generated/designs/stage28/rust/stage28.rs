//! Prescribed-time controller stage28: outputs of order 1, 1, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a"
//! Version 0.1.0, design e8fd88f575ec.
//!
//! Plant: the inputs A, B: a' = A*(b - 1), b' = A + B - k*a, output 1 = a, output 2 = b; u
//!       held from sample to sample.
//! Goal: every output with its derivatives is 0 at sample N after the start, from any state,
//!       as long as no u is clipped and the plant is the model. The plant is known at the
//!       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
//!       n.
//! Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
//!       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
//!       v_i is law_i in step. s = 0, 0. Output 1: Close to the end, with 9 samples to go
//!       deadbeat takes over. Output 2: Close to the end, with 9 samples to go deadbeat takes
//!       over.
//! Output 1, of order n = 1:
//!   x_1 = a
//! Output 2, of order n = 1:
//!   x_1 = b
//!   f_2 = -k*a
//! u = adj(D) w/det(D) with w_i = v_i - f_i:
//!   det(D) = b - 1
//!   adj(D) = [[1, 0], [-1, b - 1]]
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: k = 3
//!   output 2: k = 4.5
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k [as in its expression]: parameter of an expression of the design
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
//!   growth: sound: at rest at sample N from any state, but for what f + g u does between
//!       samples, whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   deadline: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   loop: not checked: `samples` is left to run time.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 1, 1, whose sum is the number of states.
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

/// Run-time parameters of [`Stage28`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage28Params {
    /// samples N from the start to rest \[samples\], at least 1.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub k: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage28 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// weight of x1 in the law.
    w1_1_1: f64,
    /// weight of x1 in the law.
    b_1_1: f64,
    /// weight of x1 in the law.
    w1_1_2: f64,
    /// parameter of an expression of the design.
    p_k: f64,
    /// derived from the parameters.
    c1: f64,
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
impl Stage28 {
    /// Samples to go at which deadbeat takes over.
    const DEADBEAT_1: f64 = 9.0;
    /// Samples to go at which deadbeat takes over.
    const DEADBEAT_2: f64 = 9.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage28Params) -> Result<Self, Error> {
        if !((params.samples > 0)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && (params.u_max > 0.0)
            && params.k.is_finite())
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let w1_1_1 = (-3.0) * (1.0 / params.h);
        let b_1_1 = -(1.0 / params.h);
        let w1_1_2 = (-4.5) * (1.0 / params.h);
        let p_k = params.k;
        let c1 = -p_k;
        let u_max = params.u_max;
        if !(w1_1_1.is_finite()
            && b_1_1.is_finite()
            && w1_1_2.is_finite()
            && c1.is_finite()
            && (params.h >= 1e-200)
            && (1.0 / params.h >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            w1_1_1,
            b_1_1,
            w1_1_2,
            p_k,
            c1,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (A, B) from tick `k`, which may wrap, and state x = (a, b). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 2]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(x[0].is_finite() && x[1].is_finite()) {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of each output.
        let x1_1 = x[0];
        let x1_2 = x[1];
        let left = self.samples.saturating_sub(elapsed);
        let m0_1 = left as f64;
        let law_1: f64;
        let m0_2 = left as f64;
        let law_2: f64;
        if m0_1 > Self::DEADBEAT_1 {
            // The exact law in samples.
            let z1_1 = self.w1_1_1 * x1_1;
            law_1 = z1_1 / m0_1;
        } else {
            // Deadbeat.
            law_1 = self.b_1_1 * x1_1;
        }
        if m0_2 > Self::DEADBEAT_2 {
            // The exact law in samples.
            let z1_2 = self.w1_1_2 * x1_2;
            law_2 = z1_2 / m0_2;
        } else {
            // Deadbeat.
            law_2 = self.b_1_1 * x1_2;
        }

        // The inputs that give all of them.
        let v2 = x1_2 - 1.0;
        let v3 = if v2 < 0.0 || v2 > 0.0 {
            1.0 / v2
        } else {
            f64::NAN
        };
        let control1 = law_1 * v3;
        let control2 = ((-law_1) + (v2 * (law_2 - (self.c1 * x1_1)))) * v3;
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
