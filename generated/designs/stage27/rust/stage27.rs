//! Prescribed-time controller stage27: outputs of order 1, 2, 1, 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a"
//! Version 0.1.0, design 7fcab43de361.
//!
//! Plant: the inputs A, B, C, D: a' = A*(2 + b^2) + B - a*c, b' = b1, b1' = B*(3 + a) + C*d -
//!       b*d1, c' = C + D*a - c^2, d' = d1, d1' = D*(2 - b) + A*c + a, output 1 = a, output 2
//!       = b, output 3 = c, output 4 = d; u held from sample to sample.
//! Goal: every output with its derivatives is 0 at sample N after the start, from any state,
//!       as long as no u is clipped and the plant is the model. The plant is known at the
//!       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
//!       n.
//! Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
//!       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
//!       v_i is law_i in step. s = 3, -2, -1, -2. Output 1: The gains of 1 sample to go stay:
//!       they are deadbeat. Rest is planned 1 sample early, and the last gains bring down what
//!       f and g did between samples. Output 2: From 6 samples to go on these are M - 3 and
//!       the exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they
//!       are deadbeat. Rest is planned 2 samples early, and the last gains bring down what f
//!       and g did between samples. Output 3: From 7 samples to go on these are M - 6 and the
//!       exponents 7, those of least energy. The gains of 1 sample to go stay: they are
//!       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
//!       did between samples. Output 4: From 9 samples to go on these are M - 3 and the
//!       exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they are
//!       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
//!       did between samples.
//! Output 1, of order n = 1:
//!   x_1 = a
//!   f_1 = -a*c
//! Output 2, of order n = 2:
//!   x_1 = b
//!   x_2 = b1
//!   f_2 = -b*d1
//! Output 3, of order n = 1:
//!   x_1 = c
//!   f_3 = -c^2
//! Output 4, of order n = 2:
//!   x_1 = d
//!   x_2 = d1
//!   f_4 = a
//! u of D u = w with w_i = v_i - f_i, by elimination with pivots:
//!   D = [[2 + b^2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]]
//! Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: k = 4
//!   output 2: k = 12, 7
//!   output 3: k = 5
//!   output 4: k = 15, 8.5
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max = inf [unit of u], fixed: bound of |u|
//!   a = 0.8 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! u is not clipped.
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
//!   zeros: sound: none: the relative degrees are 1, 2, 1, 2, whose sum is the number of
//!       states.
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

/// Run-time parameters of [`Stage27`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage27Params {
    /// samples N from the start to rest \[samples\], at least 2.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage27 {
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
    /// weight of x1 in the law.
    w1_1_3: f64,
    /// weight of x1 in the law.
    end1_1_3: f64,
    /// weight of x1 in the law.
    w1_1_4: f64,
    /// weight of x2 in the law.
    w1_2_4: f64,
    /// weight of x2 in the law.
    w2_2_4: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage27 {
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_2: f64 = 6.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_3: f64 = 7.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_4: f64 = 9.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage27Params) -> Result<Self, Error> {
        if !((params.samples > 1) && (1e-150 <= params.h) && (params.h <= 1e150)) {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let w1_1_1 = (-5.0) * (1.0 / params.h);
        let w1_1_2 = (-18.75) * (1.0 / (params.h * params.h));
        let w1_2_2 = 9.375 * (1.0 / params.h);
        let w2_2_2 = (-7.75) * (1.0 / params.h);
        let end1_1_2 = (-20.0) * (1.0 / (params.h * params.h));
        let end1_2_2 = 10.0 * (1.0 / params.h);
        let end2_2_2 = (-8.0) * (1.0 / params.h);
        let w1_1_3 = (-6.25) * (1.0 / params.h);
        let end1_1_3 = (-7.0) * (1.0 / params.h);
        let w1_1_4 = (-23.4375) * (1.0 / (params.h * params.h));
        let w1_2_4 = 11.71875 * (1.0 / params.h);
        let w2_2_4 = (-9.625) * (1.0 / params.h);
        if !(w1_1_1.is_finite()
            && w1_1_2.is_finite()
            && w1_2_2.is_finite()
            && w2_2_2.is_finite()
            && end1_1_2.is_finite()
            && end1_2_2.is_finite()
            && end2_2_2.is_finite()
            && w1_1_3.is_finite()
            && end1_1_3.is_finite()
            && w1_1_4.is_finite()
            && w1_2_4.is_finite()
            && w2_2_4.is_finite()
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
            w1_1_3,
            end1_1_3,
            w1_1_4,
            w1_2_4,
            w2_2_4,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u = (A, B, C, D) from tick `k`, which may wrap, and state x = (a, b, b1, c, d, d1). Where
    /// one of them is not finite, as at a state at which the inputs do not decouple the outputs,
    /// every u is 0; else the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 6]) -> Axes<4, f64> {
        let failed = |error| Axes {
            u: [0.0; 4],
            axes: [Err(error); 4],
            status: Err(error),
        };
        let mut u = [0.0; 4];
        let mut axes = [Ok(Status::Ok); 4];
        let mut status;
        if !(x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && x[3].is_finite()
            && x[4].is_finite()
            && x[5].is_finite())
        {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of each output.
        let x1_1 = x[0];
        let x1_2 = x[1];
        let x2_2 = x[2];
        let x1_3 = x[3];
        let x1_4 = x[4];
        let x2_4 = x[5];
        let left = self.samples.saturating_sub(elapsed);
        let s1 = (left as f64) - 1.0;
        let m0_1 = if s1 < 1.0 { 1.0 } else { s1 };
        let law_1: f64;

        // The exact law in samples.
        let z1_1 = self.w1_1_1 * x1_1;
        law_1 = z1_1 / (m0_1 + 4.0);
        let m0_2 = (left as f64) - 2.0;
        let law_2: f64;
        let m0_3 = (left as f64) - 1.0;
        let law_3: f64;
        let m0_4 = (left as f64) - 2.0;
        let law_4: f64;
        if m0_2 > Self::END_SAMPLES_2 {
            // The exact law in samples.
            let z1_2 = (self.w1_1_2 * x1_2) + (self.w1_2_2 * x2_2);
            let z2_2 = self.w2_2_2 * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
        } else {
            // The law of least energy to the end.
            let m1_2 = if m0_2 < 2.0 { 2.0 } else { m0_2 };
            let y1_2 = (self.end1_1_2 * x1_2) + (self.end1_2_2 * x2_2);
            let y2_2 = self.end2_2_2 * x2_2;
            let m1f_21 = m1_2 + 3.0;
            law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 2.0));
        }
        if m0_3 > Self::END_SAMPLES_3 {
            // The exact law in samples.
            let z1_3 = self.w1_1_3 * x1_3;
            law_3 = z1_3 / m0_3;
        } else {
            // The law of least energy to the end.
            let m1_3 = if m0_3 < 1.0 { 1.0 } else { m0_3 };
            let y1_3 = self.end1_1_3 * x1_3;
            law_3 = y1_3 / (m1_3 + 6.0);
        }
        if m0_4 > Self::END_SAMPLES_4 {
            // The exact law in samples.
            let z1_4 = (self.w1_1_4 * x1_4) + (self.w1_2_4 * x2_4);
            let z2_4 = self.w2_2_4 * x2_4;
            law_4 = (z1_4 + (z2_4 * m0_4)) / (m0_4 * (m0_4 - 1.0));
        } else {
            // The law of least energy to the end.
            let m1_4 = if m0_4 < 2.0 { 2.0 } else { m0_4 };
            let y1_4 = (self.end1_1_2 * x1_4) + (self.end1_2_2 * x2_4);
            let y2_4 = self.end2_2_2 * x2_4;
            let m1f_41 = m1_4 + 3.0;
            law_4 = (y1_4 + (y2_4 * m1f_41)) / (m1f_41 * (m1_4 + 2.0));
        }

        // The inputs that give all of them.
        let given_v1 = [
            law_1 - ((-x1_1) * x1_3),
            law_2 - ((-x1_2) * x2_4),
            law_3 - (-(x1_3 * x1_3)),
            law_4 - x1_1,
        ];
        let v1_a = [
            2.0 + (x1_2 * x1_2),
            1.0,
            0.0,
            0.0,
            0.0,
            3.0 + x1_1,
            x1_4,
            0.0,
            0.0,
            0.0,
            1.0,
            x1_1,
            x1_3,
            0.0,
            0.0,
            2.0 - x1_2,
        ];
        let v1 = Self::eliminate(given_v1, v1_a);
        let control1 = v1[0];
        let control2 = v1[1];
        let control3 = v1[2];
        let control4 = v1[3];
        if elapsed < self.samples {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite()
            && control2.is_finite()
            && control3.is_finite()
            && control4.is_finite()
        {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            u[2] = control3;
            axes[2] = status;
            u[3] = control4;
            axes[3] = status;
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
            u[2] = 0.0;
            if control3.is_finite() {
                axes[2] = status;
            } else {
                axes[2] = Err(Error::Range);
            }
            u[3] = 0.0;
            if control4.is_finite() {
                axes[3] = status;
            } else {
                axes[3] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }

    /// Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
    /// becomes x, NaN where a is singular.
    fn eliminate(mut b: [f64; 4], mut a: [f64; 16]) -> [f64; 4] {
        for k in 0..4 {
            let mut most = k;
            let mut largest = (a[(4 * k) + k]).abs();
            for i in k + 1..4 {
                let size = (a[(4 * i) + k]).abs();
                if largest < size {
                    largest = size;
                    most = i;
                }
            }
            for i in k + 1..4 {
                if most == i {
                    let kept = b[k];
                    b[k] = b[i];
                    b[i] = kept;
                    for j in k..4 {
                        let entry = a[(4 * k) + j];
                        a[(4 * k) + j] = a[(4 * i) + j];
                        a[(4 * i) + j] = entry;
                    }
                }
            }
            a[(4 * k) + k] = if a[(4 * k) + k] < 0.0 || a[(4 * k) + k] > 0.0 {
                a[(4 * k) + k]
            } else {
                f64::NAN
            };
            for i in k + 1..4 {
                let factor = a[(4 * i) + k] / a[(4 * k) + k];
                for j in k + 1..4 {
                    a[(4 * i) + j] = a[(4 * i) + j] - (factor * a[(4 * k) + j]);
                }
                b[i] = b[i] - (factor * b[k]);
            }
        }
        for k in (0..4).rev() {
            for j in k + 1..4 {
                b[k] = b[k] - (a[(4 * k) + j] * b[j]);
            }
            b[k] = b[k] / a[(4 * k) + k];
        }
        b
    }
}
