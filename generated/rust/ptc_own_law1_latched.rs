//! Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.
//!
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched
//!       --pi0="-2*xi1 - xi1*xi1_0"
//! Version 0.1.0.
//!
//! It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
//!
//! Parameters:
//!   tau: prescribed settling time [s], finite, > 0
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], > 0, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a = 1, fixed: rate of stretched time [1/s], finite, > 0
//!
//! Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
//!   mu(t)     = tau*(1 - exp(-a*t))
//!   kappa(Dt) = -ln(T/tau)/a
//!   atoms: T = time-to-go
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) a^k T
//!   r_1 = a*T
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
//!   B_{0,0} = 1
//!
//! Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
//!   pi0 = -2*xi1 - xi1*xi1_0
//!   g   = 1
//!   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
//!   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l
//!
//! From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
//! |u| <= u_max always (status SATURATED where u was clipped).
//! Guard full: every input and pointer is checked.
//! Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
//!       (-ffp-contract=off).
//!
//! Checks of the design (ptc-codegen check tells more):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: not checked: the law is no sum of gains, so its poles are not known.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step: 5 + - or comparison, 3 *, 1 /, 0 sqrt, 0 calls.
//! Latencies added up: x86-64 about 46 cycles, Cortex-M4F about 22 cycles.
#![forbid(unsafe_code)]

/// How a valid u came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking: u is that of the law.
    Ok,
    /// Time-to-go is held at eps: the deadline is near or over.
    Hold,
    /// |u| was clipped to u_max; wins over `Hold` and `After`.
    Saturated,
    /// The deadline is over, and what was chosen for then gives u.
    After,
}

/// What a step gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f64> {
    /// Input of the plant.
    pub u: R,
    /// How it came about.
    pub status: Status,
}

/// Why there is no controller, or no u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A parameter is outside its domain, or the coefficients derived from it overflow.
    Param,
    /// x or t is not finite, or t lies before the start.
    Input,
    /// u is not finite.
    Range,
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Param => "a parameter is outside its domain",
            Self::Input => "x or t is not finite, or t is before t0",
            Self::Range => "u is not finite",
        })
    }
}

impl core::error::Error for Error {}

/// A controller of the plant x1' = x2, ..., xN' = u.
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

/// Run-time parameters of [`PtcOwnLaw1Latched`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcOwnLaw1LatchedParams {
    /// prescribed settling time, unit s, finite, > 0.
    pub tau: f64,
    /// start time, unit s, finite.
    pub t0: f64,
    /// time-to-go at which the gains are held, unit s, > 0, < tau.
    pub eps: f64,
    /// bound of |u|, unit unit of u, > 0, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller of order 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcOwnLaw1Latched {
    /// start time
    t0: f64,
    /// prescribed settling time
    tau: f64,
    /// t0 + tau, rounded
    deadline: f64,
    /// what the rounding of t0 + tau left out
    correction: f64,
    /// time-to-go at which the gains are held
    eps: f64,
    /// -eps: later than this the gains are held
    hold_from: f64,
    /// state at the start
    x1_0: f64,
    /// bound of |u|
    u_max: f64,
}

#[allow(non_snake_case, dead_code, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcOwnLaw1Latched {
    /// Takes the parameters and arms at the start time among them (or the fixed one).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it overflow.
    pub fn new(params: PtcOwnLaw1LatchedParams, x0: &[f64; 1]) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        if !(tau.is_finite()
            && (tau > 0.0)
            && t0.is_finite()
            && (eps > 0.0)
            && (u_max > 0.0)
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let mut built = Self {
            tau,
            eps,
            hold_from,
            u_max,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
            x1_0: 0.0,
        };
        if !(built.hold_from.is_finite())
        {
            return Err(Error::Param);
        }
        built.arm(t0, x0)?;
        Ok(built)
    }

    /// Starts again at `t0`, in s.
    ///
    /// # Errors
    /// `Param`: `t0` or the deadline is not finite; the controller is left as it was.
    pub fn arm(&mut self, t0: f64, x0: &[f64; 1]) -> Result<(), Error> {
        if !(t0.is_finite() && x0[0].is_finite()) {
            return Err(Error::Param);
        }
        let x1_0 = x0[0];
        let deadline = t0 + self.tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (self.tau - v1);
        if !(deadline.is_finite()) {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        self.x1_0 = x1_0;
        Ok(())
    }

/// u at time `t`, in s, and state `x` = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not finite, or `t` lies before the start. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 1]) -> Result<Control<f64>, Error> {
        let [x1] = *x;
        if !(t.is_finite()
            && (t >= self.t0)
            && x1.is_finite())
        {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let T = -late;
        let inv_r1 = 1.0 / T;
        let law = ((-2.0) * x1) - (x1 * self.x1_0);
        let u = law * inv_r1;
if u > self.u_max {
            return Ok(Control { u: self.u_max, status: Status::Saturated });
        }
        if u < -self.u_max {
            return Ok(Control { u: -self.u_max, status: Status::Saturated });
        }
        // Time-to-go, or NaN where u is not finite: one comparison tells tracking.
        let margin = (u - u) - late;
        if margin > self.eps {
            Ok(Control { u, status: Status::Ok })
        } else if margin.is_nan() {
            Err(Error::Range)
        } else {
            Ok(Control { u, status: Status::Hold })
        }
    }
}
