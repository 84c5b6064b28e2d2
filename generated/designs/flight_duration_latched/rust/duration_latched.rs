//! Prescribed-time controller duration_latched: order n = 2, mapping custom.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth
//! Version 0.1.0, design 618c09f23c7e.
//!
//! Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
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
//!   c: parameter of kappa, from 0.5 to 2
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   kappa(dt) = dt/(c*tau*(tau - dt)) + dt
//!   kappa = (tau + tau^2*c*T - tau*c*T^2 - T)/(tau*c*T)
//!   r_1 = T*(c*T/(1 + c*T^2))
//! r_k and BB_n are computed from the Taylor series of mu at each call.
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -6*xi1 - 5*xi2 + xi1_0/8
//!   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
//!   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
//!
//! From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
//! In flight: arm_for starts again at t0 for another tau, at any time, and computes what
//!       follows from tau. arm keeps the tau last used: at first that of the parameters.
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: the mapping is of its class, proved.
//!   growth: not checked: the law is not a sum of gains, so its poles are not known.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a linear law.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 11 additions or comparisons, 15
//!       multiplications, 3 divisions.
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

/// Run-time parameters of [`DurationLatched`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DurationLatchedParams {
    /// prescribed settling time \[s\], from 1e-150 to 1e150.
    pub tau: f64,
    /// start time \[s\], finite.
    pub t0: f64,
    /// time-to-go at which the gains are held \[s\], >= 1e-150, < tau.
    pub eps: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// parameter of kappa, from 0.5 to 2.
    pub c: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DurationLatched {
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
    /// parameter of an expression of the design.
    p_c: f64,
    /// derived at the start time.
    f44: f64,
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
impl DurationLatched {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0) for `params.tau`, latching
    /// the state x0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: DurationLatchedParams, x0: &[f64; 2]) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let p_c = params.c;
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && (0.5 <= p_c)
            && (p_c <= 2.0)
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        if !hold_from.is_finite() {
            return Err(Error::Param);
        }
        let mut built = Self {
            eps,
            hold_from,
            p_c,
            u_max,
            t0: 0.0,
            tau: 0.0,
            deadline: 0.0,
            correction: 0.0,
            f44: 0.0,
        };
        built.arm_for(t0, tau, x0)?;
        Ok(built)
    }

    /// Starts again at t0 \[s\], with the tau last used, latching the state x0.
    ///
    /// # Errors
    /// `Param`: an argument or what follows from it is not finite; nothing has changed.
    #[inline]
    pub fn arm(&mut self, t0: f64, x0: &[f64; 2]) -> Result<(), Error> {
        if !(t0.is_finite() && x0[0].is_finite() && x0[1].is_finite()) {
            return Err(Error::Param);
        }
        let deadline = t0 + self.tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (self.tau - v1);
        let f44 = x0[0] * 0.125;
        if !(deadline.is_finite() && f44.is_finite()) {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        self.f44 = f44;
        Ok(())
    }

    /// Starts again at t0 \[s\] with another duration tau \[s\]: the deadline is t0 + tau, latching
    /// the state x0.
    ///
    /// # Errors
    /// `Param`: an argument or what follows from it is not finite, or `tau` is outside its domain;
    /// nothing has changed.
    #[inline]
    pub fn arm_for(&mut self, t0: f64, tau: f64, x0: &[f64; 2]) -> Result<(), Error> {
        if !(t0.is_finite()
            && x0[0].is_finite()
            && x0[1].is_finite()
            && tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (tau > self.eps))
        {
            return Err(Error::Param);
        }
        let deadline = t0 + tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (tau - v1);
        let f44 = x0[0] * 0.125;
        if !(deadline.is_finite() && f44.is_finite()) {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.tau = tau;
        self.deadline = deadline;
        self.correction = correction;
        self.f44 = f44;
        Ok(())
    }

    /// u at time t \[s\] and state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(t >= self.t0) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let T = -late;
        let v1 = T * T * self.p_c;
        let v2 = 1.0 + v1;
        let unit = (T * self.p_c) / v2;
        let v3 = T * unit;
        let inv_r1 = 1.0 / v3;
        let xi2 = x[1] * v3;
        let law = (((-6.0) * x[0]) - (5.0 * xi2)) + self.f44;
        let s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit);
        let v = ((law * inv_r1) + (s1 * x[1])) * inv_r1;
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if t.is_finite() && x[0].is_finite() && x[1].is_finite() {
            if v.is_finite() {
                if v > self.u_max {
                    (self.u_max, Status::Saturated)
                } else if v < -self.u_max {
                    (-self.u_max, Status::Saturated)
                } else {
                    (v, Status::Hold)
                }
            } else {
                return Err(Error::Range);
            }
        } else {
            return Err(Error::Input);
        };
        Ok(Control { u, status })
    }
}
