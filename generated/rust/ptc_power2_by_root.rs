//! Prescribed-time controller ptc_power2_by_root: order n = 2, mapping power.
//!
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "power(m=1.5)" --name ptc_power2_by_root
//! Version 0.1.0.
//!
//! It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
//!
//! Parameters:
//!   tau: prescribed settling time [s], finite, > 0
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], > 0, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a: rate of stretched time [1/s], finite, > 0
//!   m = 1.5, fixed: exponent of the power mapping [1], finite, > 0
//!   k: gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite
//!
//! Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
//!   mu(t)     = tau*(1 - (1 + a*m*t)^(-1/m))
//!   kappa(Dt) = ((T/tau)^-m - 1)/(a*m)
//!   atoms: T = time-to-go, P = (T/tau)^m
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) prod_{i<k}(1 + i*m) a^k T P^k
//!   r_1 = a*T*P
//!   r_2 = -a^2*m*T*P^2 - a^2*T*P^2
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
//!   B_{0,0} = 1
//!   B_{1,1} = a*T*P
//!   B_{2,1} = -a^2*m*T*P^2 - a^2*T*P^2
//!
//! Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_n xi_n)
//!   g   = 1
//!   u = (sum_j gain_j x_j)/g
//!   gain_j = inv_T^(n+1-j) row_j
//!   K_i = k_i/(a)^(n+1-i)
//!   row_1 = -K1*q^2
//!   row_2 = 1 + m - K2*q
//!   q = (T/tau)^-m
//!   inv_T = 1/T
//!
//! From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
//! |u| <= u_max always (status SATURATED where u was clipped).
//! Guard full: every input and pointer is checked.
//! Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
//!       (-ffp-contract=off).
//!
//! Checks of the design (ptc-codegen check tells more):
//!   membership: sound: power is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step: 5 + - or comparison, 10 *, 1 /, 1 sqrt, 0 calls.
//! Latencies added up: x86-64 about 92 cycles, Cortex-M4F about 43 cycles.
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

/// From `std`, or from the crate `libm` where the feature of that name is on.
#[allow(unexpected_cfgs)]
mod math {
    #[inline]
    pub fn sqrt(a: f64) -> f64 {
        #[cfg(feature = "libm")]
        {
            libm::sqrt(a)
        }
        #[cfg(not(feature = "libm"))]
        {
            a.sqrt()
        }
    }
}

/// Run-time parameters of [`PtcPower2ByRoot`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcPower2ByRootParams {
    /// prescribed settling time, unit s, finite, > 0.
    pub tau: f64,
    /// start time, unit s, finite.
    pub t0: f64,
    /// time-to-go at which the gains are held, unit s, > 0, < tau.
    pub eps: f64,
    /// bound of |u|, unit unit of u, > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time, unit 1/s, finite, > 0.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i, unit s^(i-1-n), finite.
    pub k: [f64; 2],
}

/// Prescribed-time controller of order 2.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcPower2ByRoot {
    /// coefficient of q^2 in the gain of x1
    c1_2: f64,
    /// prescribed settling time
    tau: f64,
    /// start time
    t0: f64,
    /// t0 + tau, rounded
    deadline: f64,
    /// what the rounding of t0 + tau left out
    correction: f64,
    /// time-to-go at which the gains are held
    eps: f64,
    /// -eps: later than this the gains are held
    hold_from: f64,
    /// -tau
    minus_tau: f64,
    /// coefficient of q^1 in the gain of x2
    c2_1: f64,
    /// 1/tau
    inv_tau: f64,
    /// bound of |u|
    u_max: f64,
}

/// Feedback gains of [`PtcPower2ByRoot`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PtcPower2ByRootGains {
    /// u = gain\[0\] x\[0\] + ... + gain\[1\] x\[1\].
    pub gain: [f64; 2],
    /// Bound of |u|.
    pub u_max: f64,
    /// `Ok` or `Hold`.
    pub status: Status,
}

#[allow(non_snake_case, dead_code, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcPower2ByRoot {
    /// Takes the parameters and arms at the start time among them (or the fixed one).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it overflow.
    pub fn new(params: PtcPower2ByRootParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        let k2 = params.k[1];
        if !(tau.is_finite()
            && (tau > 0.0)
            && t0.is_finite()
            && (eps > 0.0)
            && (u_max > 0.0)
            && a.is_finite()
            && (a > 0.0)
            && k1.is_finite()
            && k2.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let K1 = k1 / (a * a);
        let K2 = k2 / a;
        let c1_2 = -K1;
        let hold_from = -eps;
        let minus_tau = -tau;
        let c2_1 = -K2;
        let inv_tau = 1.0 / tau;
        let mut built = Self {
            c1_2,
            tau,
            eps,
            hold_from,
            minus_tau,
            c2_1,
            inv_tau,
            u_max,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
        };
        if !(built.c1_2.is_finite()
            && built.hold_from.is_finite()
            && built.minus_tau.is_finite()
            && built.c2_1.is_finite()
            && built.inv_tau.is_finite())
        {
            return Err(Error::Param);
        }
        built.arm(t0)?;
        Ok(built)
    }

    /// Starts again at `t0`, in s.
    ///
    /// # Errors
    /// `Param`: `t0` or the deadline is not finite; the controller is left as it was.
    pub fn arm(&mut self, t0: f64) -> Result<(), Error> {
        if !(t0.is_finite()) {
            return Err(Error::Param);
        }
        let deadline = t0 + self.tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (self.tau - v1);
        if !(deadline.is_finite()) {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

/// u at time `t`, in s, and state `x` = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not finite, or `t` lies before the start. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        let [x1, x2] = *x;
        if !(t.is_finite()
            && (t >= self.t0)
            && x1.is_finite()
            && x2.is_finite())
        {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let inv_w = self.minus_tau / late;
        let v1 = math::sqrt(inv_w);
        let q = v1 * (v1 * v1);
        let row1 = self.c1_2 * q * q;
        let row2 = (self.c2_1 * q) + 2.5;
        let inv_T = inv_w * self.inv_tau;
        let u = ((row1 * x1 * inv_T) + (row2 * x2)) * inv_T;
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

    /// The gains at time `t`, in s, for several axes that share one deadline. `tick` and `axis`
    /// round otherwise than `step` does.
    ///
    /// # Errors
    /// `Input`: `t` is not finite or lies before the start.
    #[inline]
    pub fn tick(&self, t: f64) -> Result<PtcPower2ByRootGains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let inv_w = self.minus_tau / late;
        let v1 = math::sqrt(inv_w);
        let q = v1 * (v1 * v1);
        let row1 = self.c1_2 * q * q;
        let row2 = (self.c2_1 * q) + 2.5;
        let inv_T = inv_w * self.inv_tau;
        let held = late >= self.hold_from;
        Ok(PtcPower2ByRootGains {
            gain: [
                row1 * inv_T * inv_T,
                row2 * inv_T,
            ],
            u_max: self.u_max,
            status: if held { Status::Hold } else { Status::Ok },
        })
    }
}

#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcPower2ByRootGains {
    /// u of one axis with state `x` = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: `x` is not finite. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        let [x1, x2] = *x;
        let [gain1, gain2] = self.gain;
        if !(x1.is_finite()
            && x2.is_finite())
        {
            return Err(Error::Input);
        }
        let u = (gain1 * x1) + (gain2 * x2);
if u > self.u_max {
            return Ok(Control { u: self.u_max, status: Status::Saturated });
        }
        if u < -self.u_max {
            return Ok(Control { u: -self.u_max, status: Status::Saturated });
        }
        if u.is_finite() {
            Ok(Control { u, status: self.status })
        } else {
            Err(Error::Range)
        }
    }
}

impl Controller<2> for PtcPower2ByRoot {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
