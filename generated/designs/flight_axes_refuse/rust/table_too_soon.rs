//! Prescribed-time controller table_too_soon: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01
//! Version 0.1.0, design ed84b87c488b.
//!
//! Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
//!       the rows are those of Theorem 1 for the mapping exp. From 8 samples to go on these
//!       are M - 2 and the exponents 3, 4, 5, those of least energy. The gains of 3 samples to
//!       go stay: they are deadbeat.
//! Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: k = 60, 47, 12
//!   axis 2: k = 120, 74, 15
//!
//! Parameters:
//!   samples = 150 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: upper limit of u
//!   u_min [unit of u]: lower limit of u
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
//!       so their Bernstein coefficients, linear in z, bound them. If these are within the
//!       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
//!       plant and state are as they are known.
//! Axes: all come to rest at the same sample, and each deadline is tested for every one of
//!       them.
//! late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
//! u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
//!       deadline where it lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
//!       bounded.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
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

/// Run-time parameters of [`TableTooSoon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct TableTooSoonParams {
    /// upper limit of u \[unit of u\], > u_min, infinity allowed.
    pub u_max: f64,
    /// lower limit of u \[unit of u\], < u_max, -infinity allowed.
    pub u_min: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct TableTooSoon {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest, as planned now.
    last: u32,
    /// upper limit of u.
    u_max: f64,
    /// lower limit of u.
    u_min: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl TableTooSoon {
    /// Weight of x1 in the law.
    const W1_1_1: f64 = -60000000.0;
    /// Weight of x2 in the law.
    const W1_2_1: f64 = 600000.0;
    /// Weight of x3 in the law.
    const W1_3_1: f64 = -2000.0;
    /// Weight of x2 in the law.
    const W2_2_1: f64 = -360000.0;
    /// Weight of x3 in the law.
    const W2_3_1: f64 = 1800.0;
    /// Weight of x3 in the law.
    const W3_3_1: f64 = -900.0;
    /// Weight of x1 in the law.
    const W1_1_2: f64 = -120000000.0;
    /// Weight of x2 in the law.
    const W1_2_2: f64 = 1200000.0;
    /// Weight of x3 in the law.
    const W1_3_2: f64 = -4000.0;
    /// Weight of x2 in the law.
    const W2_2_2: f64 = -600000.0;
    /// Weight of x3 in the law.
    const W2_3_2: f64 = 3000.0;
    /// Weight of x3 in the law.
    const W3_3_2: f64 = -1200.0;
    /// Weight of x1 in the law.
    const S1_1_1: f64 = 1000000.0;
    /// Weight of x2 in the law.
    const S1_2_1: f64 = -10000.0;
    /// 100/3, weight of x3 in the law.
    const S1_3_1: f64 = 33.333333333333336;
    /// Weight of x2 in the law.
    const S2_2_1: f64 = 10000.0;
    /// Weight of x3 in the law.
    const S2_3_1: f64 = -50.0;
    /// Weight of x3 in the law.
    const S3_3_1: f64 = 100.0;
    /// Weight of x1 in the law.
    const S1_1_2: f64 = 1000000.0;
    /// Weight of x2 in the law.
    const S1_2_2: f64 = -10000.0;
    /// 100/3, weight of x3 in the law.
    const S1_3_2: f64 = 33.333333333333336;
    /// Weight of x2 in the law.
    const S2_2_2: f64 = 10000.0;
    /// Weight of x3 in the law.
    const S2_3_2: f64 = -50.0;
    /// Weight of x3 in the law.
    const S3_3_2: f64 = 100.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: TableTooSoonParams) -> Result<Self, Error> {
        if !(params.u_min < params.u_max) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        let u_min = params.u_min;
        Ok(Self {
            start: 0,
            last: 150,
            u_max,
            u_min,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 150;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[[f64; 3]; 2]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[0][2].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[1][2].is_finite())
        {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x3_1 = x[0][2];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x3_2 = x[1][2];
        let left = self.last.saturating_sub(elapsed);
        let m0_1 = if (left as f64) < 3.0 {
            3.0
        } else {
            left as f64
        };
        let law_1: f64;

        // The exact law in samples.
        let s1 = (Self::W1_1_1 * x1_1) + (Self::W1_2_1 * x2_1);
        let z1_1 = s1 + (Self::W1_3_1 * x3_1);
        let z2_1 = (Self::W2_2_1 * x2_1) + (Self::W2_3_1 * x3_1);
        let z3_1 = Self::W3_3_1 * x3_1;
        let m0f_11 = m0_1 + 2.0;
        let m0f_12 = m0f_11 * (m0_1 + 1.0);
        law_1 = (z1_1 + (z2_1 * m0f_11) + (z3_1 * m0f_12)) / (m0f_12 * m0_1);
        let m0_2 = if (left as f64) < 3.0 {
            3.0
        } else {
            left as f64
        };
        let law_2: f64;
        let s2 = (Self::W1_1_2 * x1_2) + (Self::W1_2_2 * x2_2);
        let z1_2 = s2 + (Self::W1_3_2 * x3_2);
        let z2_2 = (Self::W2_2_2 * x2_2) + (Self::W2_3_2 * x3_2);
        let z3_2 = Self::W3_3_2 * x3_2;
        let m0f_21 = m0_2 + 3.0;
        let m0f_22 = m0f_21 * (m0_2 + 2.0);
        let s3 = z1_2 + (z2_2 * m0f_21) + (z3_2 * m0f_22);
        law_2 = s3 / (m0f_22 * (m0_2 + 1.0));
        if elapsed < self.last {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if law_1.is_finite() && law_2.is_finite() {
            u[0] = law_1;
            axes[0] = status;
            u[1] = law_2;
            axes[1] = status;
            if law_1 > self.u_max {
                u[0] = self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_1 < self.u_min {
                u[0] = self.u_min;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_2 > self.u_max {
                u[1] = self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_2 < self.u_min {
                u[1] = self.u_min;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
        } else {
            u[0] = 0.0;
            if law_1.is_finite() {
                axes[0] = status;
            } else {
                axes[0] = Err(Error::Range);
            }
            u[1] = 0.0;
            if law_2.is_finite() {
                axes[1] = status;
            } else {
                axes[1] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. A deadline before which a limit could be exceeded is refused
    /// (E_SOON).
    ///
    /// # Errors
    /// `Param`: the number of samples is out of its range. `Input`: an argument is not finite or
    /// out of its domain. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn arm_for(&mut self, k: u32, samples: u32, x: &[[f64; 3]; 2]) -> Result<(), Error> {
        if !((samples > 2) && (samples < 2147483649)) {
            return Err(Error::Param);
        }
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[0][2].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[1][2].is_finite())
        {
            return Err(Error::Input);
        }
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x3_1 = x[0][2];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x3_2 = x[1][2];
        let s1 = (Self::S1_1_1 * x1_1) + (Self::S1_2_1 * x2_1);
        let flat1_1 = s1 + (Self::S1_3_1 * x3_1);
        let flat2_1 = (Self::S2_2_1 * x2_1) + (Self::S2_3_1 * x3_1);
        let flat3_1 = Self::S3_3_1 * x3_1;
        let s2 = (Self::S1_1_2 * x1_2) + (Self::S1_2_2 * x2_2);
        let flat1_2 = s2 + (Self::S1_3_2 * x3_2);
        let flat2_2 = (Self::S2_2_2 * x2_2) + (Self::S2_3_2 * x3_2);
        let flat3_2 = Self::S3_3_2 * x3_2;
        let least_1 = 0.999999999990586 * self.u_min;
        let most_1 = 0.999999999990586 * self.u_max;
        let most2_1: f64 = 0.499999999995293;
        let most3_1: f64 = 3.999999999962344;
        let least_2 = 0.999999999990586 * self.u_min;
        let most_2 = 0.999999999990586 * self.u_max;
        let most2_2: f64 = 0.499999999995293;
        let most3_2: f64 = 3.999999999962344;
        let tried = samples;
        let mut fits = 0_u32;
        let m_1 = tried as f64;
        let power1_1 = m_1 + 2.0;
        let power2_1 = power1_1 * (m_1 + 1.0);
        let power3_1 = power2_1 * m_1;
        let power4_1 = power3_1 * (m_1 - 1.0);
        let power5_1 = power4_1 * (m_1 - 2.0);
        let scaled2_1 = flat2_1 * power1_1;
        let scaled3_1 = flat3_1 * power2_1;
        let s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1);
        let w1_1 = s3 / power3_1;
        let w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1;
        let s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1);
        let w3_1 = s4 / power5_1;
        let length_1 = m_1 - 4.0;
        let b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1);
        let b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1;
        let b2_l_1 = length_1 * length_1;
        let b2_c_1 = (-60.0) * w3_1 * b2_l_1;
        let b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
        let s5 = b0_c_1 + (0.3333333333333333 * b1_c_1);
        let b2_1 = s5 + (0.06666666666666667 * b2_c_1);
        let b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
        let b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
        let s6 = b0_c_1 + (0.8333333333333334 * b1_c_1);
        let b5_1 = s6 + (0.6666666666666666 * b2_c_1);
        let b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
        let s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1);
        let s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1;
        let s2_l_1 = length_1 * length_1;
        let s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1;
        let s3_l_1 = s2_l_1 * length_1;
        let s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1;
        let s4_l_1 = s3_l_1 * length_1;
        let s4_c_1 = (-0.0005) * w3_1 * s4_l_1;
        let s1_1 = s0_c_1 + (0.125 * s1_c_1);
        let s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1);
        let s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1);
        let s3_1 = s7 + (0.017857142857142856 * s3_c_1);
        let s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1);
        let s9 = s8 + (0.07142857142857142 * s3_c_1);
        let s4_1 = s9 + (0.014285714285714285 * s4_c_1);
        let s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1);
        let s11 = s10 + (0.17857142857142858 * s3_c_1);
        let s5_1 = s11 + (0.07142857142857142 * s4_c_1);
        let s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1);
        let s13 = s12 + (0.35714285714285715 * s3_c_1);
        let s6_1 = s13 + (0.21428571428571427 * s4_c_1);
        let s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1);
        let s7_1 = s14 + (0.5 * s4_c_1);
        let s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1;
        let v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1);
        let v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1;
        let v2_l_1 = length_1 * length_1;
        let v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1;
        let v3_l_1 = v2_l_1 * length_1;
        let v3_c_1 = 0.2 * w3_1 * v3_l_1;
        let v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1);
        let s15 = v0_c_1 + (0.2857142857142857 * v1_c_1);
        let v2_1 = s15 + (0.047619047619047616 * v2_c_1);
        let s16 = v0_c_1 + (0.42857142857142855 * v1_c_1);
        let s17 = s16 + (0.14285714285714285 * v2_c_1);
        let v3_1 = s17 + (0.02857142857142857 * v3_c_1);
        let s18 = v0_c_1 + (0.5714285714285714 * v1_c_1);
        let s19 = s18 + (0.2857142857142857 * v2_c_1);
        let v4_1 = s19 + (0.11428571428571428 * v3_c_1);
        let s20 = v0_c_1 + (0.7142857142857143 * v1_c_1);
        let s21 = s20 + (0.47619047619047616 * v2_c_1);
        let v5_1 = s21 + (0.2857142857142857 * v3_c_1);
        let s22 = v0_c_1 + (0.8571428571428571 * v1_c_1);
        let s23 = s22 + (0.7142857142857143 * v2_c_1);
        let v6_1 = s23 + (0.5714285714285714 * v3_c_1);
        let v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1;
        let end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1);
        let end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1);
        let end53_1 = (-6.0) * w1_1;
        if (least_1 <= b0_c_1)
            && (b0_c_1 <= most_1)
            && (least_1 <= b1_1)
            && (b1_1 <= most_1)
            && (least_1 <= b2_1)
            && (b2_1 <= most_1)
            && (least_1 <= b3_1)
            && (b3_1 <= most_1)
            && (least_1 <= b4_1)
            && (b4_1 <= most_1)
            && (least_1 <= b5_1)
            && (b5_1 <= most_1)
            && (least_1 <= b6_1)
            && (b6_1 <= most_1)
            && (-most2_1 <= s0_c_1)
            && (s0_c_1 <= most2_1)
            && (-most2_1 <= s1_1)
            && (s1_1 <= most2_1)
            && (-most2_1 <= s2_1)
            && (s2_1 <= most2_1)
            && (-most2_1 <= s3_1)
            && (s3_1 <= most2_1)
            && (-most2_1 <= s4_1)
            && (s4_1 <= most2_1)
            && (-most2_1 <= s5_1)
            && (s5_1 <= most2_1)
            && (-most2_1 <= s6_1)
            && (s6_1 <= most2_1)
            && (-most2_1 <= s7_1)
            && (s7_1 <= most2_1)
            && (-most2_1 <= s8_1)
            && (s8_1 <= most2_1)
            && (-most3_1 <= v0_c_1)
            && (v0_c_1 <= most3_1)
            && (-most3_1 <= v1_1)
            && (v1_1 <= most3_1)
            && (-most3_1 <= v2_1)
            && (v2_1 <= most3_1)
            && (-most3_1 <= v3_1)
            && (v3_1 <= most3_1)
            && (-most3_1 <= v4_1)
            && (v4_1 <= most3_1)
            && (-most3_1 <= v5_1)
            && (v5_1 <= most3_1)
            && (-most3_1 <= v6_1)
            && (v6_1 <= most3_1)
            && (-most3_1 <= v7_1)
            && (v7_1 <= most3_1)
            && (least_1 <= end51_1)
            && (end51_1 <= most_1)
            && (least_1 <= end52_1)
            && (end52_1 <= most_1)
            && (least_1 <= end53_1)
            && (end53_1 <= most_1)
            && (((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)).abs() <= most2_1)
            && (((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)).abs() <= most2_1)
            && ((((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)).abs() <= most2_1)
            && (((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)).abs() <= most3_1)
            && ((((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)).abs() <= most3_1)
            && (((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)).abs() <= most3_1)
        {
            fits = 1;
        }
        if fits == 1 {
            let m_2 = tried as f64;
            let power1_2 = m_2 + 3.0;
            let power2_2 = power1_2 * (m_2 + 2.0);
            let power3_2 = power2_2 * (m_2 + 1.0);
            let power4_2 = power3_2 * m_2;
            let power5_2 = power4_2 * (m_2 - 1.0);
            let power6_2 = power5_2 * (m_2 - 2.0);
            let scaled2_2 = flat2_2 * power1_2;
            let scaled3_2 = flat3_2 * power2_2;
            let s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2);
            let w1_2 = s24 / power4_2;
            let w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2;
            let s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2);
            let w3_2 = s25 / power6_2;
            let length_2 = m_2 - 4.0;
            let b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2);
            let b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2;
            let b2_l_2 = length_2 * length_2;
            let b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2;
            let b3_l_2 = b2_l_2 * length_2;
            let b3_c_2 = (-120.0) * w3_2 * b3_l_2;
            let b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2);
            let s26 = b0_c_2 + (0.2857142857142857 * b1_c_2);
            let b2_2 = s26 + (0.047619047619047616 * b2_c_2);
            let s27 = b0_c_2 + (0.42857142857142855 * b1_c_2);
            let s28 = s27 + (0.14285714285714285 * b2_c_2);
            let b3_2 = s28 + (0.02857142857142857 * b3_c_2);
            let s29 = b0_c_2 + (0.5714285714285714 * b1_c_2);
            let s30 = s29 + (0.2857142857142857 * b2_c_2);
            let b4_2 = s30 + (0.11428571428571428 * b3_c_2);
            let s31 = b0_c_2 + (0.7142857142857143 * b1_c_2);
            let s32 = s31 + (0.47619047619047616 * b2_c_2);
            let b5_2 = s32 + (0.2857142857142857 * b3_c_2);
            let s33 = b0_c_2 + (0.8571428571428571 * b1_c_2);
            let s34 = s33 + (0.7142857142857143 * b2_c_2);
            let b6_2 = s34 + (0.5714285714285714 * b3_c_2);
            let b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2;
            let s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2);
            let s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2;
            let s2_l_2 = length_2 * length_2;
            let s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2;
            let s3_l_2 = s2_l_2 * length_2;
            let s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2;
            let s4_l_2 = s3_l_2 * length_2;
            let s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2;
            let s5_l_2 = s4_l_2 * length_2;
            let s5_c_2 = (-0.0006) * w3_2 * s5_l_2;
            let s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2);
            let s35 = s0_c_2 + (0.2222222222222222 * s1_c_2);
            let s2_2 = s35 + (0.027777777777777776 * s2_c_2);
            let s36 = s0_c_2 + (0.3333333333333333 * s1_c_2);
            let s37 = s36 + (0.08333333333333333 * s2_c_2);
            let s3_2 = s37 + (0.011904761904761904 * s3_c_2);
            let s38 = s0_c_2 + (0.4444444444444444 * s1_c_2);
            let s39 = s38 + (0.16666666666666666 * s2_c_2);
            let s40 = s39 + (0.047619047619047616 * s3_c_2);
            let s4_2 = s40 + (0.007936507936507936 * s4_c_2);
            let s41 = s0_c_2 + (0.5555555555555556 * s1_c_2);
            let s42 = s41 + (0.2777777777777778 * s2_c_2);
            let s43 = s42 + (0.11904761904761904 * s3_c_2);
            let s44 = s43 + (0.03968253968253968 * s4_c_2);
            let s5_2 = s44 + (0.007936507936507936 * s5_c_2);
            let s45 = s0_c_2 + (0.6666666666666666 * s1_c_2);
            let s46 = s45 + (0.4166666666666667 * s2_c_2);
            let s47 = s46 + (0.23809523809523808 * s3_c_2);
            let s48 = s47 + (0.11904761904761904 * s4_c_2);
            let s6_2 = s48 + (0.047619047619047616 * s5_c_2);
            let s49 = s0_c_2 + (0.7777777777777778 * s1_c_2);
            let s50 = s49 + (0.5833333333333334 * s2_c_2);
            let s51 = s50 + (0.4166666666666667 * s3_c_2);
            let s52 = s51 + (0.2777777777777778 * s4_c_2);
            let s7_2 = s52 + (0.16666666666666666 * s5_c_2);
            let s53 = s0_c_2 + (0.8888888888888888 * s1_c_2);
            let s54 = s53 + (0.7777777777777778 * s2_c_2);
            let s55 = s54 + (0.6666666666666666 * s3_c_2);
            let s56 = s55 + (0.5555555555555556 * s4_c_2);
            let s8_2 = s56 + (0.4444444444444444 * s5_c_2);
            let s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2;
            let v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2);
            let v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2;
            let v2_l_2 = length_2 * length_2;
            let v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2;
            let v3_l_2 = v2_l_2 * length_2;
            let v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2;
            let v4_l_2 = v3_l_2 * length_2;
            let v4_c_2 = 0.3 * w3_2 * v4_l_2;
            let v1_2 = v0_c_2 + (0.125 * v1_c_2);
            let v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2);
            let s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2);
            let v3_2 = s57 + (0.017857142857142856 * v3_c_2);
            let s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2);
            let s59 = s58 + (0.07142857142857142 * v3_c_2);
            let v4_2 = s59 + (0.014285714285714285 * v4_c_2);
            let s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2);
            let s61 = s60 + (0.17857142857142858 * v3_c_2);
            let v5_2 = s61 + (0.07142857142857142 * v4_c_2);
            let s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2);
            let s63 = s62 + (0.35714285714285715 * v3_c_2);
            let v6_2 = s63 + (0.21428571428571427 * v4_c_2);
            let s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2);
            let v7_2 = s64 + (0.5 * v4_c_2);
            let v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2;
            let end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2);
            let end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2);
            let end63_2 = (-24.0) * w1_2;
            if (least_2 <= b0_c_2)
                && (b0_c_2 <= most_2)
                && (least_2 <= b1_2)
                && (b1_2 <= most_2)
                && (least_2 <= b2_2)
                && (b2_2 <= most_2)
                && (least_2 <= b3_2)
                && (b3_2 <= most_2)
                && (least_2 <= b4_2)
                && (b4_2 <= most_2)
                && (least_2 <= b5_2)
                && (b5_2 <= most_2)
                && (least_2 <= b6_2)
                && (b6_2 <= most_2)
                && (least_2 <= b7_2)
                && (b7_2 <= most_2)
                && (-most2_2 <= s0_c_2)
                && (s0_c_2 <= most2_2)
                && (-most2_2 <= s1_2)
                && (s1_2 <= most2_2)
                && (-most2_2 <= s2_2)
                && (s2_2 <= most2_2)
                && (-most2_2 <= s3_2)
                && (s3_2 <= most2_2)
                && (-most2_2 <= s4_2)
                && (s4_2 <= most2_2)
                && (-most2_2 <= s5_2)
                && (s5_2 <= most2_2)
                && (-most2_2 <= s6_2)
                && (s6_2 <= most2_2)
                && (-most2_2 <= s7_2)
                && (s7_2 <= most2_2)
                && (-most2_2 <= s8_2)
                && (s8_2 <= most2_2)
                && (-most2_2 <= s9_2)
                && (s9_2 <= most2_2)
                && (-most3_2 <= v0_c_2)
                && (v0_c_2 <= most3_2)
                && (-most3_2 <= v1_2)
                && (v1_2 <= most3_2)
                && (-most3_2 <= v2_2)
                && (v2_2 <= most3_2)
                && (-most3_2 <= v3_2)
                && (v3_2 <= most3_2)
                && (-most3_2 <= v4_2)
                && (v4_2 <= most3_2)
                && (-most3_2 <= v5_2)
                && (v5_2 <= most3_2)
                && (-most3_2 <= v6_2)
                && (v6_2 <= most3_2)
                && (-most3_2 <= v7_2)
                && (v7_2 <= most3_2)
                && (-most3_2 <= v8_2)
                && (v8_2 <= most3_2)
                && (least_2 <= end61_2)
                && (end61_2 <= most_2)
                && (least_2 <= end62_2)
                && (end62_2 <= most_2)
                && (least_2 <= end63_2)
                && (end63_2 <= most_2)
                && (((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)).abs() <= most2_2)
                && (((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)).abs() <= most2_2)
                && ((((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)).abs() <= most2_2)
                && (((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)).abs() <= most3_2)
                && ((((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)).abs() <= most3_2)
                && (((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)).abs() <= most3_2)
            {
                fits = 2;
            }
        }
        if !((tried > 3) && (tried < 1073741825) && (fits == 2)) {
            return Err(Error::Soon);
        }
        self.start = k;
        self.last = samples;
        Ok(())
    }

    /// The fewest samples found, from the next call of `step` on, with which the law of each axis
    /// keeps u and the states within their limits at every sample to rest, from the state x of
    /// each, all of which come to rest at one sample, for sure. Give them to `arm_for`.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: a state is too large to
    /// compute with. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn soonest(&self, x: &[[f64; 3]; 2]) -> Result<u32, Error> {
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[0][2].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[1][2].is_finite())
        {
            return Err(Error::Input);
        }
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x3_1 = x[0][2];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x3_2 = x[1][2];
        let s1 = (Self::S1_1_1 * x1_1) + (Self::S1_2_1 * x2_1);
        let flat1_1 = s1 + (Self::S1_3_1 * x3_1);
        let flat2_1 = (Self::S2_2_1 * x2_1) + (Self::S2_3_1 * x3_1);
        let flat3_1 = Self::S3_3_1 * x3_1;
        let s2 = (Self::S1_1_2 * x1_2) + (Self::S1_2_2 * x2_2);
        let flat1_2 = s2 + (Self::S1_3_2 * x3_2);
        let flat2_2 = (Self::S2_2_2 * x2_2) + (Self::S2_3_2 * x3_2);
        let flat3_2 = Self::S3_3_2 * x3_2;
        let mut low = 3_u32;
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = 4_u32;
        for _ in 0..64 {
            let least_1 = 0.999999999990586 * self.u_min;
            let most_1 = 0.999999999990586 * self.u_max;
            let most2_1: f64 = 0.499999999995293;
            let most3_1: f64 = 3.999999999962344;
            let least_2 = 0.999999999990586 * self.u_min;
            let most_2 = 0.999999999990586 * self.u_max;
            let most2_2: f64 = 0.499999999995293;
            let most3_2: f64 = 3.999999999962344;
            let mut fits = 0_u32;
            let m_1 = tried as f64;
            let power1_1 = m_1 + 2.0;
            let power2_1 = power1_1 * (m_1 + 1.0);
            let power3_1 = power2_1 * m_1;
            let power4_1 = power3_1 * (m_1 - 1.0);
            let power5_1 = power4_1 * (m_1 - 2.0);
            let scaled2_1 = flat2_1 * power1_1;
            let scaled3_1 = flat3_1 * power2_1;
            let s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1);
            let w1_1 = s3 / power3_1;
            let w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1;
            let s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1);
            let w3_1 = s4 / power5_1;
            let length_1 = m_1 - 4.0;
            let b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1);
            let b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1;
            let b2_l_1 = length_1 * length_1;
            let b2_c_1 = (-60.0) * w3_1 * b2_l_1;
            let b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
            let s5 = b0_c_1 + (0.3333333333333333 * b1_c_1);
            let b2_1 = s5 + (0.06666666666666667 * b2_c_1);
            let b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
            let b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
            let s6 = b0_c_1 + (0.8333333333333334 * b1_c_1);
            let b5_1 = s6 + (0.6666666666666666 * b2_c_1);
            let b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
            let s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1);
            let s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1;
            let s2_l_1 = length_1 * length_1;
            let s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1;
            let s3_l_1 = s2_l_1 * length_1;
            let s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1;
            let s4_l_1 = s3_l_1 * length_1;
            let s4_c_1 = (-0.0005) * w3_1 * s4_l_1;
            let s1_1 = s0_c_1 + (0.125 * s1_c_1);
            let s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1);
            let s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1);
            let s3_1 = s7 + (0.017857142857142856 * s3_c_1);
            let s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1);
            let s9 = s8 + (0.07142857142857142 * s3_c_1);
            let s4_1 = s9 + (0.014285714285714285 * s4_c_1);
            let s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1);
            let s11 = s10 + (0.17857142857142858 * s3_c_1);
            let s5_1 = s11 + (0.07142857142857142 * s4_c_1);
            let s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1);
            let s13 = s12 + (0.35714285714285715 * s3_c_1);
            let s6_1 = s13 + (0.21428571428571427 * s4_c_1);
            let s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1);
            let s7_1 = s14 + (0.5 * s4_c_1);
            let s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1;
            let v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1);
            let v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1;
            let v2_l_1 = length_1 * length_1;
            let v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1;
            let v3_l_1 = v2_l_1 * length_1;
            let v3_c_1 = 0.2 * w3_1 * v3_l_1;
            let v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1);
            let s15 = v0_c_1 + (0.2857142857142857 * v1_c_1);
            let v2_1 = s15 + (0.047619047619047616 * v2_c_1);
            let s16 = v0_c_1 + (0.42857142857142855 * v1_c_1);
            let s17 = s16 + (0.14285714285714285 * v2_c_1);
            let v3_1 = s17 + (0.02857142857142857 * v3_c_1);
            let s18 = v0_c_1 + (0.5714285714285714 * v1_c_1);
            let s19 = s18 + (0.2857142857142857 * v2_c_1);
            let v4_1 = s19 + (0.11428571428571428 * v3_c_1);
            let s20 = v0_c_1 + (0.7142857142857143 * v1_c_1);
            let s21 = s20 + (0.47619047619047616 * v2_c_1);
            let v5_1 = s21 + (0.2857142857142857 * v3_c_1);
            let s22 = v0_c_1 + (0.8571428571428571 * v1_c_1);
            let s23 = s22 + (0.7142857142857143 * v2_c_1);
            let v6_1 = s23 + (0.5714285714285714 * v3_c_1);
            let v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1;
            let end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1);
            let end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1);
            let end53_1 = (-6.0) * w1_1;
            if (least_1 <= b0_c_1)
                && (b0_c_1 <= most_1)
                && (least_1 <= b1_1)
                && (b1_1 <= most_1)
                && (least_1 <= b2_1)
                && (b2_1 <= most_1)
                && (least_1 <= b3_1)
                && (b3_1 <= most_1)
                && (least_1 <= b4_1)
                && (b4_1 <= most_1)
                && (least_1 <= b5_1)
                && (b5_1 <= most_1)
                && (least_1 <= b6_1)
                && (b6_1 <= most_1)
                && (-most2_1 <= s0_c_1)
                && (s0_c_1 <= most2_1)
                && (-most2_1 <= s1_1)
                && (s1_1 <= most2_1)
                && (-most2_1 <= s2_1)
                && (s2_1 <= most2_1)
                && (-most2_1 <= s3_1)
                && (s3_1 <= most2_1)
                && (-most2_1 <= s4_1)
                && (s4_1 <= most2_1)
                && (-most2_1 <= s5_1)
                && (s5_1 <= most2_1)
                && (-most2_1 <= s6_1)
                && (s6_1 <= most2_1)
                && (-most2_1 <= s7_1)
                && (s7_1 <= most2_1)
                && (-most2_1 <= s8_1)
                && (s8_1 <= most2_1)
                && (-most3_1 <= v0_c_1)
                && (v0_c_1 <= most3_1)
                && (-most3_1 <= v1_1)
                && (v1_1 <= most3_1)
                && (-most3_1 <= v2_1)
                && (v2_1 <= most3_1)
                && (-most3_1 <= v3_1)
                && (v3_1 <= most3_1)
                && (-most3_1 <= v4_1)
                && (v4_1 <= most3_1)
                && (-most3_1 <= v5_1)
                && (v5_1 <= most3_1)
                && (-most3_1 <= v6_1)
                && (v6_1 <= most3_1)
                && (-most3_1 <= v7_1)
                && (v7_1 <= most3_1)
                && (least_1 <= end51_1)
                && (end51_1 <= most_1)
                && (least_1 <= end52_1)
                && (end52_1 <= most_1)
                && (least_1 <= end53_1)
                && (end53_1 <= most_1)
                && (((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)).abs() <= most2_1)
                && (((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)).abs() <= most2_1)
                && ((((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)).abs() <= most2_1)
                && (((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)).abs() <= most3_1)
                && ((((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)).abs() <= most3_1)
                && (((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)).abs() <= most3_1)
            {
                fits = 1;
            }
            if fits == 1 {
                let m_2 = tried as f64;
                let power1_2 = m_2 + 3.0;
                let power2_2 = power1_2 * (m_2 + 2.0);
                let power3_2 = power2_2 * (m_2 + 1.0);
                let power4_2 = power3_2 * m_2;
                let power5_2 = power4_2 * (m_2 - 1.0);
                let power6_2 = power5_2 * (m_2 - 2.0);
                let scaled2_2 = flat2_2 * power1_2;
                let scaled3_2 = flat3_2 * power2_2;
                let s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2);
                let w1_2 = s24 / power4_2;
                let w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2;
                let s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2);
                let w3_2 = s25 / power6_2;
                let length_2 = m_2 - 4.0;
                let b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2);
                let b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2;
                let b2_l_2 = length_2 * length_2;
                let b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2;
                let b3_l_2 = b2_l_2 * length_2;
                let b3_c_2 = (-120.0) * w3_2 * b3_l_2;
                let b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2);
                let s26 = b0_c_2 + (0.2857142857142857 * b1_c_2);
                let b2_2 = s26 + (0.047619047619047616 * b2_c_2);
                let s27 = b0_c_2 + (0.42857142857142855 * b1_c_2);
                let s28 = s27 + (0.14285714285714285 * b2_c_2);
                let b3_2 = s28 + (0.02857142857142857 * b3_c_2);
                let s29 = b0_c_2 + (0.5714285714285714 * b1_c_2);
                let s30 = s29 + (0.2857142857142857 * b2_c_2);
                let b4_2 = s30 + (0.11428571428571428 * b3_c_2);
                let s31 = b0_c_2 + (0.7142857142857143 * b1_c_2);
                let s32 = s31 + (0.47619047619047616 * b2_c_2);
                let b5_2 = s32 + (0.2857142857142857 * b3_c_2);
                let s33 = b0_c_2 + (0.8571428571428571 * b1_c_2);
                let s34 = s33 + (0.7142857142857143 * b2_c_2);
                let b6_2 = s34 + (0.5714285714285714 * b3_c_2);
                let b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2;
                let s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2);
                let s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2;
                let s2_l_2 = length_2 * length_2;
                let s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2;
                let s3_l_2 = s2_l_2 * length_2;
                let s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2;
                let s4_l_2 = s3_l_2 * length_2;
                let s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2;
                let s5_l_2 = s4_l_2 * length_2;
                let s5_c_2 = (-0.0006) * w3_2 * s5_l_2;
                let s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2);
                let s35 = s0_c_2 + (0.2222222222222222 * s1_c_2);
                let s2_2 = s35 + (0.027777777777777776 * s2_c_2);
                let s36 = s0_c_2 + (0.3333333333333333 * s1_c_2);
                let s37 = s36 + (0.08333333333333333 * s2_c_2);
                let s3_2 = s37 + (0.011904761904761904 * s3_c_2);
                let s38 = s0_c_2 + (0.4444444444444444 * s1_c_2);
                let s39 = s38 + (0.16666666666666666 * s2_c_2);
                let s40 = s39 + (0.047619047619047616 * s3_c_2);
                let s4_2 = s40 + (0.007936507936507936 * s4_c_2);
                let s41 = s0_c_2 + (0.5555555555555556 * s1_c_2);
                let s42 = s41 + (0.2777777777777778 * s2_c_2);
                let s43 = s42 + (0.11904761904761904 * s3_c_2);
                let s44 = s43 + (0.03968253968253968 * s4_c_2);
                let s5_2 = s44 + (0.007936507936507936 * s5_c_2);
                let s45 = s0_c_2 + (0.6666666666666666 * s1_c_2);
                let s46 = s45 + (0.4166666666666667 * s2_c_2);
                let s47 = s46 + (0.23809523809523808 * s3_c_2);
                let s48 = s47 + (0.11904761904761904 * s4_c_2);
                let s6_2 = s48 + (0.047619047619047616 * s5_c_2);
                let s49 = s0_c_2 + (0.7777777777777778 * s1_c_2);
                let s50 = s49 + (0.5833333333333334 * s2_c_2);
                let s51 = s50 + (0.4166666666666667 * s3_c_2);
                let s52 = s51 + (0.2777777777777778 * s4_c_2);
                let s7_2 = s52 + (0.16666666666666666 * s5_c_2);
                let s53 = s0_c_2 + (0.8888888888888888 * s1_c_2);
                let s54 = s53 + (0.7777777777777778 * s2_c_2);
                let s55 = s54 + (0.6666666666666666 * s3_c_2);
                let s56 = s55 + (0.5555555555555556 * s4_c_2);
                let s8_2 = s56 + (0.4444444444444444 * s5_c_2);
                let s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2;
                let v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2);
                let v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2;
                let v2_l_2 = length_2 * length_2;
                let v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2;
                let v3_l_2 = v2_l_2 * length_2;
                let v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2;
                let v4_l_2 = v3_l_2 * length_2;
                let v4_c_2 = 0.3 * w3_2 * v4_l_2;
                let v1_2 = v0_c_2 + (0.125 * v1_c_2);
                let v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2);
                let s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2);
                let v3_2 = s57 + (0.017857142857142856 * v3_c_2);
                let s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2);
                let s59 = s58 + (0.07142857142857142 * v3_c_2);
                let v4_2 = s59 + (0.014285714285714285 * v4_c_2);
                let s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2);
                let s61 = s60 + (0.17857142857142858 * v3_c_2);
                let v5_2 = s61 + (0.07142857142857142 * v4_c_2);
                let s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2);
                let s63 = s62 + (0.35714285714285715 * v3_c_2);
                let v6_2 = s63 + (0.21428571428571427 * v4_c_2);
                let s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2);
                let v7_2 = s64 + (0.5 * v4_c_2);
                let v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2;
                let end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2);
                let end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2);
                let end63_2 = (-24.0) * w1_2;
                if (least_2 <= b0_c_2)
                    && (b0_c_2 <= most_2)
                    && (least_2 <= b1_2)
                    && (b1_2 <= most_2)
                    && (least_2 <= b2_2)
                    && (b2_2 <= most_2)
                    && (least_2 <= b3_2)
                    && (b3_2 <= most_2)
                    && (least_2 <= b4_2)
                    && (b4_2 <= most_2)
                    && (least_2 <= b5_2)
                    && (b5_2 <= most_2)
                    && (least_2 <= b6_2)
                    && (b6_2 <= most_2)
                    && (least_2 <= b7_2)
                    && (b7_2 <= most_2)
                    && (-most2_2 <= s0_c_2)
                    && (s0_c_2 <= most2_2)
                    && (-most2_2 <= s1_2)
                    && (s1_2 <= most2_2)
                    && (-most2_2 <= s2_2)
                    && (s2_2 <= most2_2)
                    && (-most2_2 <= s3_2)
                    && (s3_2 <= most2_2)
                    && (-most2_2 <= s4_2)
                    && (s4_2 <= most2_2)
                    && (-most2_2 <= s5_2)
                    && (s5_2 <= most2_2)
                    && (-most2_2 <= s6_2)
                    && (s6_2 <= most2_2)
                    && (-most2_2 <= s7_2)
                    && (s7_2 <= most2_2)
                    && (-most2_2 <= s8_2)
                    && (s8_2 <= most2_2)
                    && (-most2_2 <= s9_2)
                    && (s9_2 <= most2_2)
                    && (-most3_2 <= v0_c_2)
                    && (v0_c_2 <= most3_2)
                    && (-most3_2 <= v1_2)
                    && (v1_2 <= most3_2)
                    && (-most3_2 <= v2_2)
                    && (v2_2 <= most3_2)
                    && (-most3_2 <= v3_2)
                    && (v3_2 <= most3_2)
                    && (-most3_2 <= v4_2)
                    && (v4_2 <= most3_2)
                    && (-most3_2 <= v5_2)
                    && (v5_2 <= most3_2)
                    && (-most3_2 <= v6_2)
                    && (v6_2 <= most3_2)
                    && (-most3_2 <= v7_2)
                    && (v7_2 <= most3_2)
                    && (-most3_2 <= v8_2)
                    && (v8_2 <= most3_2)
                    && (least_2 <= end61_2)
                    && (end61_2 <= most_2)
                    && (least_2 <= end62_2)
                    && (end62_2 <= most_2)
                    && (least_2 <= end63_2)
                    && (end63_2 <= most_2)
                    && (((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)).abs() <= most2_2)
                    && (((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)).abs() <= most2_2)
                    && ((((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)).abs() <= most2_2)
                    && (((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)).abs() <= most3_2)
                    && ((((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)).abs() <= most3_2)
                    && (((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)).abs() <= most3_2)
                {
                    fits = 2;
                }
            }
            if fits == 2 {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            let gap = top.saturating_sub(low);
            if gap < 2 {
                break;
            }
            let half = gap / 2;
            if low < half {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if flat1_1.is_finite()
            && flat2_1.is_finite()
            && flat3_1.is_finite()
            && flat1_2.is_finite()
            && flat2_2.is_finite()
            && flat3_2.is_finite()
        {
            if kept > 0 {
                Ok(kept)
            } else {
                Err(Error::Soon)
            }
        } else {
            Err(Error::Range)
        }
    }

    /// The tick at which the loop is to be at rest.
    #[inline]
    pub fn deadline(&self) -> u32 {
        self.start.wrapping_sub(0_u32.wrapping_sub(self.last))
    }
}
