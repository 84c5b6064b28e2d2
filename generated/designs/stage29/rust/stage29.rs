//! Prescribed-time controller stage29: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --axes 3 --mu "exp(a=1)" --name stage29 --clock samples --tau=0.3 --eps=0 --limits=1,2,3 --poles="[[-4,-5],[-3+i,-3-i],[-6,-7.5]]" --g="[1/2, 2, -1]" --sample-time=0.01
//! Version 0.1.0, design 4feab5b1e49c.
//!
//! Plant: x1' = x2, x2' = g u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
//!       the rows are those of Theorem 1 for the mapping exp. From 9 samples to go on these
//!       are M - 2 and the exponents 3, 4, those of least energy. The gains of 2 samples to go
//!       stay: they are deadbeat.
//! Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: k = 20, 9; u_max = 1; g = 1/2
//!   axis 2: k = 10, 6; u_max = 2; g = 2
//!   axis 3: k = 45, 13.5; u_max = 3; g = -1
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

/// Run-time parameters of [`Stage29`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage29Params {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage29 {
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
impl Stage29 {
    /// Weight of x1 in the law.
    const W1_1_1: f64 = -400000.0;
    /// Weight of x2 in the law.
    const W1_2_1: f64 = 2000.0;
    /// Weight of x2 in the law.
    const W2_2_1: f64 = -1600.0;
    /// Weight of x1 in the law.
    const W1_1_2: f64 = -50000.0;
    /// Weight of x2 in the law.
    const W1_2_2: f64 = 250.0;
    /// Weight of x2 in the law.
    const W2_2_2: f64 = -250.0;
    /// Weight of x1 in the law.
    const END1_1_2: f64 = -60000.0;
    /// Weight of x2 in the law.
    const END1_2_2: f64 = 300.0;
    /// Weight of x2 in the law.
    const END2_2_2: f64 = -300.0;
    /// Weight of x1 in the law.
    const W1_1_3: f64 = 450000.0;
    /// Weight of x2 in the law.
    const W1_2_3: f64 = -2250.0;
    /// Weight of x2 in the law.
    const W2_2_3: f64 = 1250.0;
    /// Weight of x1 in the law.
    const END1_1_3: f64 = 420000.0;
    /// Weight of x2 in the law.
    const END1_2_3: f64 = -2100.0;
    /// Weight of x2 in the law.
    const END2_2_3: f64 = 1200.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage29Params) -> Result<Self, Error> {
        Ok(Self { start: 0 })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    #[inline]
    pub fn step(&self, k: u32, x: &[[f64; 2]; 3]) -> Axes<3, f64> {
        let failed = |error| Axes {
            u: [0.0; 3],
            axes: [Err(error); 3],
            status: Err(error),
        };
        let mut u = [0.0; 3];
        let mut axes = [Ok(Status::Ok); 3];
        let mut status;
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[2][0].is_finite()
            && x[2][1].is_finite())
        {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x1_3 = x[2][0];
        let x2_3 = x[2][1];
        let law_1: f64;

        // The exact law in samples.
        let m0_1 = if elapsed < 28 {
            33_u32.wrapping_sub(elapsed) as f64
        } else {
            5.0
        };
        let z1_1 = (Self::W1_1_1 * x1_1) + (Self::W1_2_1 * x2_1);
        let z2_1 = Self::W2_2_1 * x2_1;
        law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
        let law_2: f64;
        let law_3: f64;
        if elapsed < 26 {
            // The exact law in samples.
            let m0_2 = 30_u32.wrapping_sub(elapsed) as f64;
            let z1_2 = (Self::W1_1_2 * x1_2) + (Self::W1_2_2 * x2_2);
            let z2_2 = Self::W2_2_2 * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
        } else {
            // The law of least energy to the end.
            let m1_2 = if elapsed < 28 {
                32_u32.wrapping_sub(elapsed) as f64
            } else {
                4.0
            };
            let y1_2 = (Self::END1_1_2 * x1_2) + (Self::END1_2_2 * x2_2);
            let y2_2 = Self::END2_2_2 * x2_2;
            law_2 = (y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - 1.0));
        }
        if elapsed < 21 {
            // The exact law in samples.
            let m0_3 = 30_u32.wrapping_sub(elapsed) as f64;
            let z1_3 = (Self::W1_1_3 * x1_3) + (Self::W1_2_3 * x2_3);
            let z2_3 = Self::W2_2_3 * x2_3;
            law_3 = (z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - 1.0));
        } else {
            // The law of least energy to the end.
            let m1_3 = if elapsed < 28 {
                35_u32.wrapping_sub(elapsed) as f64
            } else {
                7.0
            };
            let y1_3 = (Self::END1_1_3 * x1_3) + (Self::END1_2_3 * x2_3);
            let y2_3 = Self::END2_2_3 * x2_3;
            law_3 = (y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - 1.0));
        }
        if elapsed < 30 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if law_1.is_finite() && law_2.is_finite() && law_3.is_finite() {
            u[0] = law_1;
            axes[0] = status;
            u[1] = law_2;
            axes[1] = status;
            u[2] = law_3;
            axes[2] = status;
            if law_1 > 1.0 {
                u[0] = 1.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_1 < -1.0 {
                u[0] = -1.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_2 > 2.0 {
                u[1] = 2.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_2 < -2.0 {
                u[1] = -2.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_3 > 3.0 {
                u[2] = 3.0;
                axes[2] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_3 < -3.0 {
                u[2] = -3.0;
                axes[2] = Ok(Status::Saturated);
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
            u[2] = 0.0;
            if law_3.is_finite() {
                axes[2] = status;
            } else {
                axes[2] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }
}
