//! Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
//!
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after
//!       extern
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
//!
//! Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
//!   mu(t)     = tau*tanh(a*t)
//!   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
//!   atoms: T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), g = 1/(1 + E)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
//!   r_1 = 2*a*T*g
//!   r_2 = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
//!   r_3 = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*a*T*g
//!   B_{2,1} = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
//!   B_{2,2} = 4*a^2*T^2*g^2
//!   B_{3,1} = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
//!   B_{3,2} = 24*a^3*T^2*E*g^3 - 24*a^3*T^2*g^3
//!
//! Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
//!   pi0 = a function of yours, called with xi and t_kappa
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
//!   membership: sound: tanh is of class M for all its parameters.
//!   growth: not checked: the law is no sum of gains, so its poles are not known.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step: 16 + - or comparison, 24 *, 4 /, 0 sqrt, 2 calls.
//! Latencies added up: x86-64 about 336 cycles, Cortex-M4F about 396 cycles.
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
    pub fn ln(a: f64) -> f64 {
        #[cfg(feature = "libm")]
        {
            libm::log(a)
        }
        #[cfg(not(feature = "libm"))]
        {
            a.ln()
        }
    }
}

/// Run-time parameters of [`PtcTanh3Extern`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh3ExternParams {
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
}

/// Prescribed-time controller of order 3.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh3Extern {
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
    /// known when the parameters are
    f16: f64,
    /// rate of stretched time
    a: f64,
    /// known when the parameters are
    f22: f64,
    /// known when the parameters are
    f24: f64,
    /// known when the parameters are
    f29: f64,
    /// bound of |u|
    u_max: f64,
}

#[allow(non_snake_case, dead_code, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcTanh3Extern {
    /// Takes the parameters and arms at the start time among them (or the fixed one).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it overflow.
    pub fn new(params: PtcTanh3ExternParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        if !(tau.is_finite()
            && (tau > 0.0)
            && t0.is_finite()
            && (eps > 0.0)
            && (u_max > 0.0)
            && a.is_finite()
            && (a > 0.0)
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let f16 = 2.0 * tau;
        let mut built = Self {
            tau,
            eps,
            hold_from,
            f16,
            a,
            f22: 2.0 * a,
            f24: f16 * a,
            f29: 1.0 / tau,
            u_max,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
        };
        if !(built.hold_from.is_finite()
            && built.f16.is_finite()
            && built.f22.is_finite()
            && built.f24.is_finite()
            && built.f29.is_finite())
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

/// u at time `t`, in s, and state `x` = (x1, x1', ...). `pi0` is the law of xi and stretched time. `after` gives u from x and t once the deadline is over.
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not finite, or `t` lies before the start. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 3], pi0: impl FnOnce(&[f64; 3], f64) -> f64, after: impl FnOnce(&[f64; 3], f64) -> f64) -> Result<Control<f64>, Error> {
        let [x1, x2, x3] = *x;
        if !(t.is_finite()
            && (t >= self.t0)
            && x1.is_finite()
            && x2.is_finite()
            && x3.is_finite())
        {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let T = -late;
        let v1 = T * self.a;
        let v2 = self.f24 + (-v1);
        let unit = self.f29 * v2;
        let v3 = v1 * (1.0 / v2);
        let v4 = v3 - 1.0;
        let v5 = v4 * 0.5;
        let v6 = T * unit;
        let inv_r1 = 1.0 / v6;
        let v7 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666 * (unit * unit);
        let xi2 = x2 * v6;
        let xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
        let t_kappa = self.t0 + ((-math::ln(T / (self.f16 - T))) / self.f22);
        let law = pi0(&[x1, xi2, xi3], t_kappa);
        let v8 = (((law * inv_r1) + ((-6.0) * v7 * x2)) * inv_r1) + ((-3.0) * ((v5 + v5) * unit) * x3);
        let u = if past >= 0.0 { after(x, t) } else { v8 * inv_r1 };
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
            Ok(Control { u, status: if past >= 0.0 { Status::After } else { Status::Hold } })
        }
    }
}
