//! Prescribed-time controller ptc_exp1: order n = 1, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 1 --mu exp
//! Version 0.1.0, design efcc3c341c63.
//!
//! Plant: x1' = f + u. Time in s, x1 in any unit U, u in U/s.
//! Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
//!       eps, sampling, f and clipping leave. The checks below say what is known of this
//!       design.
//! f is not part of the law: cancel its known terms before the call.
//!
//! SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
//!       sample periods below a limit that depends on eps and the gains. ptc-codegen check
//!       finds it once tau, eps, the gains and --sample-time are given.
//!
//! Parameters:
//!   tau: prescribed settling time [s], from 1e-150 to 1e150
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a: rate of stretched time [1/s], from 1e-150 to 1e150
//!   k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*(1 - exp(-a*t))
//!   kappa(Dt) = -ln(T/tau)/a
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) a^k T
//!   r_1 = a*T
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -k_1 xi_1
//!   u = sum_j gain_j x_j
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   inv_T = 1/T
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 3 additions or comparisons, 1
//!       multiplication, 1 division.
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

/// Run-time parameters of [`PtcExp1`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp1Params {
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
    /// gains of pi0 = -k_1 xi_1, finite; k\[0\] is k_1 \[1/s\].
    pub k: [f64; 1],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp1 {
    /// scaled gain k1/rate^1.
    K1: f64,
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
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcExp1`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp1Gains {
    /// u = gain\[0\] x\[0\] + ... + gain\[0\] x\[0\].
    pub gain: [f64; 1],
    /// bound of |u|.
    pub u_max: f64,
    /// `Ok` or `Hold`.
    pub status: Status,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl PtcExp1 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcExp1Params) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && a.is_finite()
            && (1e-150 <= a)
            && (a <= 1e150)
            && k1.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let K1 = k1 / a;
        let hold_from = -eps;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        if !((size_K1 >= 1e-200) && K1.is_finite() && hold_from.is_finite()) {
            return Err(Error::Param);
        }
        let mut built = Self {
            K1,
            tau,
            eps,
            hold_from,
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
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !(t >= self.t0) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let v = (self.K1 * x[0]) / late;
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if t.is_finite() && x[0].is_finite() {
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

    /// The gains at time t \[s\], for several axes that share one deadline: tick once, then axis
    /// for each. The result of tick and axis may differ from that of step in the last bits.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn tick(&self, t: f64) -> Result<PtcExp1Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcExp1Gains {
            gain: [self.K1 / late],
            u_max: self.u_max,
            status,
        })
    }
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl PtcExp1Gains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 1]) -> Result<Control<f64>, Error> {
        let v = self.gain[0] * x[0];
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) {
            (v, self.status)
        } else if x[0].is_finite() {
            if v.is_finite() {
                if v > self.u_max {
                    (self.u_max, Status::Saturated)
                } else {
                    (-self.u_max, Status::Saturated)
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

impl Controller<1> for PtcExp1 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 1]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
