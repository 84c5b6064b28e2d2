//! Prescribed-time controller stage31: outputs of order 1, 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "exp(a=1)" --name stage31 --clock samples --eps=0 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --reference input
//! Version 0.1.0, design 2c157dacc07c.
//!
//! Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
//!       = h, output 2 = e; u held from sample to sample.
//! Goal: every output with its derivatives is 0 at sample N after the start, from any state,
//!       as long as no u is clipped and the plant is the model. The plant is known at the
//!       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
//!       n.
//! Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
//!       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
//!       v_i is law_i in step. s = 2, -2. Output 1: The gains of 1 sample to go stay: they are
//!       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
//!       did between samples. Output 2: From 6 samples to go on these are M - 2 and the
//!       exponents 3, 4, those of least energy. The gains of 2 samples to go stay: they are
//!       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
//!       did between samples.
//! Output 1, of order n = 1:
//!   x_1 = h
//!   f_1 = -h/10
//! Output 2, of order n = 2:
//!   x_1 = e
//!   x_2 = (c - e)*(1 + h)
//!   f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
//! u = adj(D) w/det(D) with w_i = v_i - f_i:
//!   det(D) = 1 + h
//!   adj(D) = [[1 + h, 0], [-(c - e), 1]]
//! With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
//!       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
//!       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
//!       constant there.
//! Row i of r is of output i, of order n: in its places 0..n-1 the reference and its
//!       derivatives at tick k, and in place n rho, r^(n) over the sample in which u acts: its
//!       mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: k = 4; u_max = 2
//!   output 2: k = 13.5, 7.5; u_max = 3
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what f + g u and r do between
//!       samples, whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   deadline: not checked: `loop` bounds what the period leaves of a plant with several
//!       inputs.
//!   loop: not checked: `samples` is left to run time.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
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

/// Run-time parameters of [`Stage31`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage31Params {
    /// samples N from the start to rest \[samples\], at least 2.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage31 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// weight of x1 in the law.
    w1_1_1: f64,
    /// weight of x1 in the law.
    w1_1_2: f64,
    /// weight of x2 in the law.
    w1_2_2: f64,
    /// weight of x2 in the law.
    w2_2_2: f64,
    /// weight of x1 in the law.
    end1_1_2: f64,
    /// weight of x2 in the law.
    end1_2_2: f64,
    /// weight of x2 in the law.
    end2_2_2: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage31 {
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_2: f64 = 6.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage31Params) -> Result<Self, Error> {
        if !((params.samples > 1) && (1e-150 <= params.h) && (params.h <= 1e150)) {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let w1_1_1 = (-4.0) * (1.0 / params.h);
        let w1_1_2 = (-13.5) * (1.0 / (params.h * params.h));
        let w1_2_2 = 6.75 * (1.0 / params.h);
        let w2_2_2 = (-6.5) * (1.0 / params.h);
        let end1_1_2 = (-12.0) * (1.0 / (params.h * params.h));
        let end1_2_2 = 6.0 * (1.0 / params.h);
        let end2_2_2 = (-6.0) * (1.0 / params.h);
        if !(w1_1_1.is_finite()
            && w1_1_2.is_finite()
            && w1_2_2.is_finite()
            && w2_2_2.is_finite()
            && end1_1_2.is_finite()
            && end1_2_2.is_finite()
            && end2_2_2.is_finite()
            && (params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            w1_1_1,
            w1_1_2,
            w1_2_2,
            w2_2_2,
            end1_1_2,
            end1_2_2,
            end2_2_2,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (q, p) from tick `k`, which may wrap, state x = (h, c, e) and the reference r of each
    /// output. Where one of them is not finite, as at a state at which the inputs do not decouple
    /// the outputs, every u is 0; else the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 3], r: &[[f64; 3]; 2]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && r[0][0].is_finite()
            && r[0][1].is_finite()
            && r[1][0].is_finite()
            && r[1][1].is_finite()
            && r[1][2].is_finite())
        {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of each output.
        let x1_1 = x[0];
        let x1_2 = x[2];
        let v1 = x[1] - x1_2;
        let v2 = 1.0 + x1_1;
        let x2_2 = v1 * v2;

        // The tracking error.
        let e1_1 = x1_1 - r[0][0];
        let e1_2 = x1_2 - r[1][0];
        let e2_2 = x2_2 - r[1][1];
        let left = self.samples.saturating_sub(elapsed);
        let s1 = (left as f64) - 1.0;
        let m0_1 = if s1 < 1.0 { 1.0 } else { s1 };
        let law_1: f64;

        // The exact law in samples.
        let z1_1 = self.w1_1_1 * e1_1;
        law_1 = (z1_1 / (m0_1 + 3.0)) + r[0][1];
        let m0_2 = (left as f64) - 2.0;
        let law_2: f64;
        if m0_2 > Self::END_SAMPLES_2 {
            // The exact law in samples.
            let z1_2 = (self.w1_1_2 * e1_2) + (self.w1_2_2 * e2_2);
            let z2_2 = self.w2_2_2 * e2_2;
            law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))) + r[1][2];
        } else {
            // The law of least energy to the end.
            let m1_2 = if m0_2 < 2.0 { 2.0 } else { m0_2 };
            let y1_2 = (self.end1_1_2 * e1_2) + (self.end1_2_2 * e2_2);
            let y2_2 = self.end2_2_2 * e2_2;
            let m1f_21 = m1_2 + 2.0;
            law_2 = ((y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0))) + r[1][2];
        }

        // The inputs that give all of them.
        let v3 = (-x1_1) * 0.1;
        let v4 = law_1 - v3;
        let v5 = if v2 < 0.0 || v2 > 0.0 {
            1.0 / v2
        } else {
            f64::NAN
        };
        let control1 = v2 * v4 * v5;
        let s2 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)));
        let control2 = s2 * v5;
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
            if control1 > 2.0 {
                u[0] = 2.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -2.0 {
                u[0] = -2.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > 3.0 {
                u[1] = 3.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -3.0 {
                u[1] = -3.0;
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
