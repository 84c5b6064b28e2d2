//! Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after extern
//! Version 0.1.0, design 04514e738293.
//!
//! Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
//!       in U/s^3.
//! Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
//!       eps, sampling, f and clipping leave. The checks below say what is known of this
//!       design.
//! f is not part of the law: cancel its known terms before the call.
//!
//! SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
//!       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
//!
//! Parameters:
//!   tau: prescribed settling time [s], from 1e-150 to 1e150
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a: rate of stretched time [1/s], from 1e-150 to 1e150
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*tanh(a*t)
//!   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
//!   in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
//!   r_1 = 2*a*T*L
//!   r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
//!   r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*a*T*L
//!   B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
//!   B_{2,2} = 4*a^2*T^2*L^2
//!   B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
//!   B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = a user-defined function of xi and t_kappa
//!   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
//!   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
//!
//! From t0 + tau - eps on, T is held at eps in the law (status HOLD). From t0 + tau on, u is
//!       the result of the user-defined function after (status AFTER).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: tanh is of class M for all its parameters.
//!   growth: not checked: the law is not a sum of gains, so its poles are not known.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a linear law.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 16 additions or comparisons, 24
//!       multiplications, 4 divisions, 2 function calls.
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
    /// prescribed settling time \[s\], from 1e-150 to 1e150.
    pub tau: f64,
    /// start time \[s\], finite.
    pub t0: f64,
    /// time-to-go at which the gains are held \[s\], >= 1e-150, < tau.
    pub eps: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time \[1/s\], from 1e-150 to 1e150.
    pub a: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh3Extern {
    /// start time.
    t0: f64,
    /// prescribed settling time.
    tau: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
    /// time-to-go at which the gains are held.
    eps: f64,
    /// -eps: later than this the gains are held.
    hold_from: f64,
    /// derived from the parameters.
    f16: f64,
    /// rate of stretched time.
    a: f64,
    /// derived from the parameters.
    f22: f64,
    /// derived from the parameters.
    f24: f64,
    /// derived from the parameters.
    f29: f64,
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
impl PtcTanh3Extern {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcTanh3ExternParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && a.is_finite()
            && (1e-150 <= a)
            && (a <= 1e150)
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let f16 = 2.0 * tau;
        let f22 = 2.0 * a;
        let f24 = f16 * a;
        let f29 = 1.0 / tau;
        if !(hold_from.is_finite()
            && f16.is_finite()
            && f22.is_finite()
            && f24.is_finite()
            && f29.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            tau,
            eps,
            hold_from,
            f16,
            a,
            f22,
            f24,
            f29,
            u_max,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
        };
        built.arm(t0)?;
        Ok(built)
    }

    /// Starts again at t0 \[s\].
    ///
    /// # Errors
    /// `Param`: an argument or what follows from it is not finite; nothing has changed.
    #[inline]
    pub fn arm(&mut self, t0: f64) -> Result<(), Error> {
        if !t0.is_finite() {
            return Err(Error::Param);
        }
        let deadline = t0 + self.tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (self.tau - v1);
        if !deadline.is_finite() {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

    /// u at time t \[s\] and state x = (x1, x1', ...).
    /// `pi0`: User-defined law pi0(xi, t); t is the stretched time kappa + t0.
    /// `after`: User-defined law for t >= t0 + tau.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(
        &self,
        t: f64,
        x: &[f64; 3],
        pi0: impl FnOnce(&[f64; 3], f64) -> f64,
        after: impl FnOnce(&[f64; 3], f64) -> f64,
    ) -> Result<Control<f64>, Error> {
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        if !(t.is_finite() && (t >= self.t0) && x1.is_finite() && x2.is_finite() && x3.is_finite())
        {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let T = -late;
        let v1 = T * self.a;
        let v2 = self.f24 + (-v1);
        let unit = self.f29 * v2;
        let v3 = v1 * (1.0 / v2);
        let v4 = v3 - 1.0;
        let v5 = v4 * 0.5;
        let v6 = T * unit;
        let inv_r1 = 1.0 / v6;
        let xi2 = x2 * v6;
        let xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
        let t_kappa = self.t0 + ((-math::ln(T / (self.f16 - T))) / self.f22);
        let xi = &[x1, xi2, xi3];
        let law = pi0(xi, t_kappa);
        let applied: f64;
        if past >= 0.0 {
            applied = after(x, t);
        } else {
            let s1 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666;
            let s2 = ((law * inv_r1) + ((-6.0) * (s1 * (unit * unit)) * x2)) * inv_r1;
            applied = (s2 + ((-3.0) * ((v5 + v5) * unit) * x3)) * inv_r1;
        }
        let v = applied;
        let (u, status) = if v.is_finite() {
            if v > self.u_max {
                (self.u_max, Status::Saturated)
            } else if v < -self.u_max {
                (-self.u_max, Status::Saturated)
            } else if late < self.hold_from {
                (v, Status::Ok)
            } else if past >= 0.0 {
                (v, Status::After)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
