//! Prescribed-time controller stage2: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage2 --clock samples --guard none --tau=0.02 --eps=0 --u-max=inf --poles=-4,-5,-6 --sample-time=1e-3
//! Version 0.1.0, design 75680df23c07.
//!
//! Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
//!       gains of 3 samples to go stay: they are deadbeat.
//!
//! Parameters:
//!   samples = 20 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max = inf [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! u is not clipped.
//! Guard none: finite measurements are the responsibility of the caller.
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 20 from any state, whatever the poles, and |u| is
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

/// Run-time parameters of [`Stage2`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage2Params {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage2 {
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
impl Stage2 {
    /// Weight of x1 in the law.
    const W1_1: f64 = -120000000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = 120000000.0;
    /// Weight of x3 in the law.
    const W1_3: f64 = -40000.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -60000000.0;
    /// Weight of x3 in the law.
    const W2_3: f64 = 30000.0;
    /// Weight of x3 in the law.
    const W3_3: f64 = -12000.0;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 20;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage2Params) -> Result<Self, Error> {
        Ok(Self { start: 0 })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let v: f64;

        // The exact law in samples.
        let m0 = if elapsed < 17 {
            23_u32.wrapping_sub(elapsed) as f64
        } else {
            6.0
        };
        let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2) + (Self::W1_3 * x3);
        let z2 = (Self::W2_2 * x2) + (Self::W2_3 * x3);
        let z3 = Self::W3_3 * x3;
        let m0f2 = m0 * (m0 - 1.0);
        v = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
        let status = if v.is_finite() {
            if elapsed < Self::SAMPLES {
                Status::Ok
            } else {
                Status::Hold
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u: v, status })
    }
}
