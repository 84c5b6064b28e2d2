//! Prescribed-time controller stage22: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage22 --clock samples --tau=0.3 --eps=0 --poles=-3,-4 --states="q, w" --input=F --output="q + q^3/6" --dynamics="w, F/(2 + q^2) - k*q^3 - 3*w" --reference input --sample-time=0.01
//! Version 0.1.0, design 1531839ead9d.
//!
//! Plant: the input F: q' = w, w' = F/(2 + q^2) - k*q^3 - 3*w, output q + q^3/6; u held from
//!       sample to sample.
//! Goal: the output and its derivatives up to order 1, x, are 0 at sample N after the start,
//!       from any state, as long as u is not clipped and the plant is the model. f and g are
//!       known at the samples alone, which leaves an error of order h^(4-i) in x_i.
//! Law: with M samples to go and z = S x, w h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1)),
//!       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. The gains of
//!       2 samples to go stay: they are deadbeat. Rest is planned 2 samples early, and the
//!       last gains bring down what f and g did between samples.
//! With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = (w + rho -
//!       f)/g. At sample N e is 0 where r^(n) is constant over each sample; else an error of
//!       order h^(4-i) is left in e_i.
//! e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
//!       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
//!       r^(n-1)(t))/h, or that in its middle.
//!
//! Parameters:
//!   samples = 30 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k [as in its expression]: parameter of an expression of the design
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
//!   growth: sound: at rest at sample 30 from any state, but for what f + g u and r do between
//!       samples, whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
//!   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
//!   loop: not checked: `k` is left to run time.
//!   envelope: not checked: it does not examine a clock in samples.
//!   zeros: sound: none: the relative degree is 2, the number of states.
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

/// Run-time parameters of [`Stage22`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage22Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub k: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage22 {
    /// tick at which it was armed.
    start: u32,
    /// parameter of an expression of the design.
    p_k: f64,
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
impl Stage22 {
    /// Weight of x1 in the law.
    const W1_1: f64 = -120000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = 600.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -600.0;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 30;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage22Params) -> Result<Self, Error> {
        if !((params.u_max > 0.0) && params.k.is_finite()) {
            return Err(Error::Param);
        }
        let p_k = params.k;
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            p_k,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x of the model, and the reference.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 2], r: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite()
            && x[1].is_finite()
            && r[0].is_finite()
            && r[1].is_finite()
            && r[2].is_finite())
        {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The chain of the output.
        let v1 = x[0] * x[0];
        let v2 = x[0] * v1;
        let x1 = x[0] + (v2 * 0.16666666666666666);
        let v3 = 2.0 + v1;
        let x2 = x[1] * v3 * 0.5;

        // The tracking error.
        let e1 = x1 - r[0];
        let e2 = x2 - r[1];
        let w: f64;

        // The exact law in samples.
        let m0 = if elapsed < 26 {
            30_u32.wrapping_sub(elapsed) as f64
        } else {
            4.0
        };
        let z1 = (Self::W1_1 * e1) + (Self::W1_2 * e2);
        let z2 = Self::W2_2 * e2;
        w = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) + r[2];
        let s1 = (-((self.p_k * v2) + (3.0 * x[1]))) * v3;
        let v = (w - ((s1 + (x[1] * (2.0 * x[0] * x[1]))) * 0.5)) * 2.0;
        let (u, status) = if v.is_finite() {
            if v > self.u_max {
                (self.u_max, Status::Saturated)
            } else if v < -self.u_max {
                (-self.u_max, Status::Saturated)
            } else if elapsed < Self::SAMPLES {
                (v, Status::Ok)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
