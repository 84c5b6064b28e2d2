//! Prescribed-time filter stop_filter: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --name stop --what filter --keep-below=0.5,0.8 --keep-above=-0.5,-0.8 --keep-poles=-10,-40 --tau=0.4 --u-max=10 --sample-time=1e-3
//! Version 0.1.0, design 74c45379c0da.
//!
//! Plant: x1' = x2, x2' = u; u held from sample to sample.
//! Goal: -0.5 <= x1 <= 0.5, -0.8 <= x2 <= 0.8, at and between all samples, under any
//!       controller, from every state from which that is possible and as long as nothing else
//!       acts on the plant.
//! Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
//!       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -10, -40
//!       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
//!       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
//!       the limit of u.
//! From any other state u is held to the law least-energy of the chain of each x_i less its
//!       bound too, so that x_i is within it at the latest N samples after the last safe one,
//!       as long as neither the limits of u nor those by other bounds are in the way.
//!
//! Parameters:
//!   samples = 400 [samples], fixed: samples N in which a state outside returns
//!   h = 1e-3 [s], fixed: sample period
//!   u_max = 10 [unit of u], fixed: bound of |u|
//!
//! k counts samples and may wrap; call step at least once within 2^32 - N samples.
//! u is u_nominal where no bound is near (status OK), and else the nearest that they allow
//!       (SATURATED).
//! INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
//!       those of x2 and so on, the limits of u before all.
//! |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
//! Guard full: x and u_nominal are finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: not checked: a filter has no law.
//!   sampling: not checked: a filter has no law.
//!   deadline: not checked: a filter has no law.
//!   loop: sound: from every safe state the bounds are kept at and between all samples, and no
//!       limit is in the way.
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

/// Run-time parameters of [`StopFilter`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct StopFilterParams {}

/// Prescribed-time filter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct StopFilter {
    /// tick of the last safe sample, or of `arm`.
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
impl StopFilter {
    /// -1/2000, weight of x2 in the law.
    const S1_2: f64 = -0.0005;
    /// Bound of |u|.
    const U_MAX: f64 = 10.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: StopFilterParams) -> Result<Self, Error> {
        Ok(Self { start: 0 })
    }

    /// From tick `k` on a state outside has N samples to return.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and
    /// the state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f64; 2], u_nominal: f64) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite() && x[1].is_finite() && u_nominal.is_finite()) {
            return Err(Error::Input);
        }
        let x1 = x[0];
        let x2 = x[1];
        let z1 = x1 + (Self::S1_2 * x2);
        let z2 = x2;

        // The limits of u that keep a safe state safe.
        let q1_1 = z2 + (9.950166250831947 * z1);
        let q1_2 = (49.16072709850874 * z2) + (390.1515992227461 * z1);
        let mut low1 = (-195.07579961137304) - q1_2;
        let mut high1 = 195.07579961137304 - q1_2;
        let q2_1 = 39.21056084767679 * z2;
        let mut low2 = (-31.368448678141434) - q2_1;
        let mut high2 = 31.368448678141434 - q2_1;
        let mut since = self.start;
        let mut safe = 1_u32;
        if (-0.5000000004656613 <= z1)
            && (z1 <= 0.5000000004656613)
            && (-4.975083130049381 <= q1_1)
            && (q1_1 <= 4.975083130049381)
            && (-0.8000000007450581 <= z2)
            && (z2 <= 0.8000000007450581)
        {
            since = k;
        } else {
            safe = 0;

            // Outside: u is held to the law of return too.
            let left = 400_u32.saturating_sub(k.wrapping_sub(since)) as f64;
            let t1 = if left < 2.0 { 2.0 } else { left };
            let law1 = ((((-6000000.0) * z1) / (t1 + 1.0)) - (4000.0 * z2)) / t1;
            let weight1 = ((-6000000.0) / (t1 + 1.0)) / t1;
            let low1_back = law1 - ((-0.5) * weight1);
            if low1 < low1_back {
                low1 = low1_back;
            }
            let high1_back = law1 - (0.5 * weight1);
            if high1_back < high1 {
                high1 = high1_back;
            }
            let t2 = if left < 1.0 { 1.0 } else { left };
            let law2 = ((-1000.0) * z2) / t2;
            let weight2 = (-1000.0) / t2;
            let low2_back = law2 - ((-0.8) * weight2);
            if low2 < low2_back {
                low2 = low2_back;
            }
            let high2_back = law2 - (0.8 * weight2);
            if high2_back < high2 {
                high2 = high2_back;
            }
        }

        // u within them, the bounds of x1 last.
        let mut u_now = u_nominal;
        if u_now < low2 {
            u_now = low2;
        }
        if high2 < u_now {
            u_now = high2;
        }
        if u_now < low1 {
            u_now = low1;
        }
        if high1 < u_now {
            u_now = high1;
        }
        if u_now > Self::U_MAX {
            u_now = Self::U_MAX;
        }
        if u_now < -Self::U_MAX {
            u_now = -Self::U_MAX;
        }
        if !(u_now.is_finite()
            && low1.is_finite()
            && high1.is_finite()
            && low2.is_finite()
            && high2.is_finite())
        {
            return Err(Error::Range);
        }
        self.start = since;
        let status = if (safe == 0) || (high2 + 2.9214144384620184e-8 < u_now) || (u_now < low2 - 2.9214144384620184e-8) || (high1 + 1.816784959392371e-7 < u_now) || (u_now < low1 - 1.816784959392371e-7) {
            Status::Infeasible
        } else if (u_now < u_nominal) || (u_nominal < u_now) {
            Status::Saturated
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }
}
