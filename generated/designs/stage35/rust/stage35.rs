//! Prescribed-time controller stage35: outputs of order 2, 1, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "exp(a=1)" --name stage35 --clock samples --tau=0.3 --eps=0 --limits=20,30 --poles="[[-3,-4],[-4]]" --states="s, v, i" --inputs=F,V --outputs="s, i" --dynamics="v, 3*i - 2*s - v/2 + F, V - 4*i + s/8" --sample-time=0.01
//! Version 0.1.0, design 28ee8693b5c2.
//!
//! Plant: the inputs F, V: s' = v, v' = 3*i - 2*s - v/2 + F, i' = V - 4*i + s/8, output 1 = s,
//!       output 2 = i; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
//!       no u is clipped and nothing else acts on the plant.
//! Law of each output, of order n, in its chain xi as it is sampled, which is the output with
//!       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
//!       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
//!       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
//!       law_i. s = 2, 3. Output 1: The gains of 2 samples to go stay: they are deadbeat.
//!       Output 2: The gains of 1 sample to go stay: they are deadbeat.
//! Output 1, of order n = 2, to four digits:
//!   xi_1 = s - 4.167e-6*v + 2.5e-5*i
//!   xi_2 = v
//!   f_1 = -1.993*s - 0.5087*v + 2.933*i
//! Output 2, of order n = 1, to four digits:
//!   xi_1 = i
//!   f_2 = 0.1225*s + 6.157e-4*v - 3.921*i
//! u = G^-1 w with w_i = v_i - f_i, to four digits:
//!   G^-1 = [[1.003, -0.01511], [-2.107e-6, 1.02]]
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: k = 12, 7; u_max = 20
//!   output 2: k = 4; u_max = 30
//!
//! Parameters:
//!   samples = 30 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
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
//!   growth: sound: at rest at sample 30 from any state, whatever the poles, and |u| is
//!       bounded.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
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

/// Run-time parameters of [`Stage35`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage35Params {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage35 {
    /// tick at which it was armed.
    start: u32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage35 {
    /// Weight of x1 in the law.
    const W1_1_1: f64 = -120000.0;
    /// Weight of x2 in the law.
    const W1_2_1: f64 = 600.0;
    /// Weight of x2 in the law.
    const W2_2_1: f64 = -600.0;
    /// Weight of x1 in the law.
    const W1_1_2: f64 = -400.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage35Params) -> Result<Self, Error> {
        Ok(Self { start: 0 })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (F, V) from tick `k`, which may wrap, and state x = (s, v, i). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 3]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite()) {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of each output as it is sampled.
        let x1_2 = x[2];
        let s1 = x[0] + ((-4.16676736285295e-6) * x[1]);
        let x1_1 = s1 + (2.499973960459077e-5 * x1_2);
        let x2_1 = 1.0000166669696244 * x[1];
        let law_1: f64;

        // The exact law in samples.
        let m0_1 = if elapsed < 28 {
            32_u32.wrapping_sub(elapsed) as f64
        } else {
            4.0
        };
        let z1_1 = (Self::W1_1_1 * x1_1) + (Self::W1_2_1 * x2_1);
        let z2_1 = Self::W2_2_1 * x2_1;
        law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
        let law_2: f64;
        let m0_2 = if elapsed < 29 {
            33_u32.wrapping_sub(elapsed) as f64
        } else {
            4.0
        };
        let z1_2 = Self::W1_1_2 * x1_2;
        law_2 = z1_2 / m0_2;

        // The inputs that give all of them.
        let s2 = ((-1.993127946172519) * x[0]) + ((-0.5087209499488312) * x[1]);
        let v1 = law_1 - (s2 + (2.9333536080559304 * x1_2));
        let s3 = (0.12252888444119461 * x[0]) + (0.0006157089861155933 * x[1]);
        let v2 = law_2 - (s3 + ((-3.921049966023507) * x1_2));
        let control1 = (1.002518807547881 * v1) + ((-0.015112747669367257) * v2);
        let control2 = ((-2.106833310985952e-6) * v1) + (1.0201333455511812 * v2);
        if elapsed < 30 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite() && control2.is_finite() {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            if control1 > 20.0 {
                u[0] = 20.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -20.0 {
                u[0] = -20.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > 30.0 {
                u[1] = 30.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -30.0 {
                u[1] = -30.0;
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
