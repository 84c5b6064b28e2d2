//! Prescribed-time filter ceiling_filter: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --name ceiling --what filter --keep-below=1 --keep-tolerance=1e-3 --keep-poles=-3,-5,-8 --poles="least-energy(weight=1)" --precision f32 --tau=1 --f="1/2" --g="-2" --sample-time=0.01 --delay=1.5
//! Version 0.1.0, design deb0d31bb8ee.
//!
//! Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample, 1.5 samples late.
//! Goal: x1 <= 1, at and between all samples, under any controller, from every state from
//!       which that is possible and as long as nothing else acts on the plant.
//! Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
//!       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -3, -5, -8
//!       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
//!       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
//!       the limit of u.
//! From any other state u is held to the law least-energy(weight=1) of the chain of each x_i
//!       less its bound too, so that x_i is within it at the latest N samples after the last
//!       safe one, as long as neither the limits of u nor those by other bounds are in the way.
//!
//! Parameters:
//!   samples = 100 [samples], fixed: samples N in which a state outside returns
//!   h = 0.01 [s], fixed: sample period
//!   u_max [unit of u]: bound of |u|
//!
//! k counts samples and may wrap; call step at least once within 2^32 - N samples.
//! u is u_nominal where no bound is near (status OK), and else the nearest that they allow
//!       (SATURATED).
//! INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
//!       those of x2 and so on, the limits of u before all.
//! |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
//! Guard full: x and u_nominal are finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: not checked: a filter has no law.
//!   sampling: not checked: a filter has no law.
//!   deadline: not checked: a filter has no law.
//!   loop: not checked: `u_max` is left to run time.
//!   envelope: not checked: a filter has no law.
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

/// Run-time parameters of [`CeilingFilter`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct CeilingFilterParams {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
}

/// Prescribed-time filter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct CeilingFilter {
    /// tick of the last safe sample, or of `arm`.
    start: u32,
    /// input of the last sample.
    u1: f32,
    /// input of 2 samples ago.
    u2: f32,
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
impl CeilingFilter {
    /// -1/2, weight of x1 in the law.
    const S1_1: f32 = -0.5;
    /// -1/400, weight of x2 in the law.
    const S1_2: f32 = -0.0025;
    /// 1/480000, weight of x3 in the law.
    const S1_3: f32 = 2.0833334e-6;
    /// -1/16000000, weight of u2 in the law.
    const S1_5: f32 = -6.25e-8;
    /// -1/2, weight of x2 in the law.
    const S2_2: f32 = -0.5;
    /// -1/200, weight of x3 in the law.
    const S2_3: f32 = -0.005;
    /// 3/80000, weight of u2 in the law.
    const S2_5: f32 = 3.75e-5;
    /// -1/2, weight of x3 in the law.
    const S3_3: f32 = -0.5;
    /// 1/100, weight of u1 in the law.
    const S3_4: f32 = 0.01;
    /// 1/200, weight of u2 in the law.
    const S3_5: f32 = 0.005;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: CeilingFilterParams) -> Result<Self, Error> {
        if !(params.u_max > 0.0) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            u_max,
        })
    }

    /// From tick `k` on a state outside has N samples to return. Estimates and inputs under way are
    /// kept.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and
    /// the state x = (x1, x1', ...). Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f32; 3], u_nominal: f32) -> Result<Control<f32>, Error> {
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite() && u_nominal.is_finite()) {
            return Err(Error::Input);
        }
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let s1 = (Self::S1_1 * x1) + (Self::S1_2 * x2) + (Self::S1_3 * x3);
        let z1 = s1 + (Self::S1_5 * (self.u2 - 0.25));
        let s2 = (Self::S2_2 * x2) + (Self::S2_3 * x3);
        let z2 = s2 + (Self::S2_5 * (self.u2 - 0.25));
        let s3 = (Self::S3_3 * x3) + (Self::S3_4 * (self.u1 - 0.25));
        let z3 = s3 + (Self::S3_5 * (self.u2 - 0.25));

        // The limits of u that keep a safe state safe.
        let q1_1 = z2 + (2.9554467 * z1);
        let q1_2 = z3 + (7.8325043 * z2) + (14.413883 * z1);
        let q1_3 = (15.520869 * z3) + (74.63303 * z2) + (110.8192 * z1);
        let mut low1 = (-55.1596) - q1_3;
        let mut since = self.start;
        let mut safe = 1_u32;
        if (z1 >= -0.5005) && (q1_1 >= -1.4792011) && (q1_2 >= -7.2141485) {
            since = k;
        } else {
            safe = 0;

            // Outside: u is held to the law of return too.
            let left = 98_u32.saturating_sub(k.wrapping_sub(since)) as f32;
            let t1 = if left < 3.0 { 3.0 } else { left };
            let s4 = ((((-120000000.0) * z1) / (t1 + 3.0)) - (600000.0 * z2)) / (t1 + 2.0);
            let law1 = ((s4 - (1200.0 * z3)) / (t1 + 1.0)) + 0.25;
            let weight1 = (((-120000000.0) / (t1 + 3.0)) / (t1 + 2.0)) / (t1 + 1.0);
            let low1_back = law1 - ((-0.5) * weight1);
            if low1 < low1_back {
                low1 = low1_back;
            }
        }

        // u within them, the bounds of x1 last.
        let mut u_now = u_nominal;
        if u_now < low1 {
            u_now = low1;
        }
        if u_now > self.u_max {
            u_now = self.u_max;
        }
        if u_now < -self.u_max {
            u_now = -self.u_max;
        }
        if !(u_now.is_finite() && low1.is_finite()) {
            return Err(Error::Range);
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        self.start = since;
        let status = if (safe == 0) || (u_now < low1 - 0.0554096) {
            Status::Infeasible
        } else if (u_now < u_nominal) || (u_nominal < u_now) {
            Status::Saturated
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }
}
