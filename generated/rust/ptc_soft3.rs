//! Prescribed-time controller ptc_soft3: order n = 3, mapping soft.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu soft
//! Version 0.1.0, design 844f1b38480c.
//!
//! Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
//!       in U/s^3.
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
//!   start: a tau kappa' at the start, of the soft mapping [1], from 1e-12 to 1
//!   k: gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2
//!       [1/s^2], k[2] is k_3 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*(1 - 2*exp(-a*t)/(2 - start + sqrt(start^2 + 4*(1 - start)*(1 -
//!       exp(-a*t)))))
//!   kappa(Dt) = -ln(E)/a, E = w*(1 + (1 - start)*(1 - w)), w = T/tau
//!   in terms of E = exp(-a*t), S = tau*dE/dT, H = tau*E/S, y = (1 - start)*E/S^2
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = a^k H p_k(y), p_1 = 1, p_{k+1} = -(1 + 2*y) p_k - y (1 + 4*y) p_k'
//!   r_1 = a*H
//!   r_2 = -a^2*H - 2*a^2*H*y
//!   r_3 = a^3*H + 6*a^3*H*y + 12*a^3*H*y^2
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = a*H
//!   B_{2,1} = -a^2*H - 2*a^2*H*y
//!   B_{2,2} = a^2*H^2
//!   B_{3,1} = a^3*H + 6*a^3*H*y + 12*a^3*H*y^2
//!   B_{3,2} = -3*a^3*H^2 - 6*a^3*H^2*y
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
//!   u = sum_j gain_j x_j
//!   gain_j = inv_H^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = -1 - K2 + K3 + 2*K3*y - 6*y - 12*y^2
//!   row_3 = 3 - K3 + 6*y
//!   inv_H = 1/H = a*kappa'
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: soft is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 13 additions or comparisons, 13
//!       multiplications, 2 divisions.
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

/// Run-time parameters of [`PtcSoft3`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcSoft3Params {
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
    /// a tau kappa' at the start, of the soft mapping \[1\], from 1e-12 to 1.
    pub start: f64,
    /// gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k\[0\] is k_1 \[1/s^3\], k\[1\] is k_2 \[1/s^2\], k\[2\] is k_3 \[1/s\].
    pub k: [f64; 3],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcSoft3 {
    /// coefficient of x1.
    c1: f64,
    /// coefficient of y^0 in the gain of x2.
    c2_0: f64,
    /// coefficient of y^1 in the gain of x2.
    c2_1: f64,
    /// prescribed settling time.
    tau: f64,
    /// start*tau.
    first_slope: f64,
    /// 1 - start.
    softness: f64,
    /// start time.
    t0: f64,
    /// time-to-go at which the gains are held.
    eps: f64,
    /// tau - eps: the gains are held from there on.
    hold_after: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
    /// -eps: later than this the gains are held.
    hold_from: f64,
    /// coefficient of y^0 in the gain of x3.
    c3_0: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcSoft3`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcSoft3Gains {
    /// u = gain\[0\] x\[0\] + ... + gain\[2\] x\[2\].
    pub gain: [f64; 3],
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
impl PtcSoft3 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcSoft3Params) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let start = params.start;
        let k1 = params.k[0];
        let k2 = params.k[1];
        let k3 = params.k[2];
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && a.is_finite()
            && (1e-150 <= a)
            && (a <= 1e150)
            && start.is_finite()
            && (1e-12 <= start)
            && (start <= 1.0)
            && k1.is_finite()
            && k2.is_finite()
            && k3.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let v1 = a * a;
        let v2 = a * v1;
        let K1 = k1 / v2;
        let K2 = k2 / v1;
        let K3 = k3 / a;
        let c1 = -K1;
        let c2_0 = ((-K2) + K3) - 1.0;
        let c2_1 = (2.0 * K3) - 6.0;
        let first_slope = start * tau;
        let softness = 1.0 - start;
        let hold_after = tau - eps;
        let hold_from = -eps;
        let c3_0 = (-K3) + 3.0;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let size_K3 = if k3.abs() <= 0.0 { 1e-200 } else { K3.abs() };
        if !((v2 >= 1e-200)
            && (size_K1 >= 1e-200)
            && (size_K2 >= 1e-200)
            && (size_K3 >= 1e-200)
            && c1.is_finite()
            && c2_0.is_finite()
            && c2_1.is_finite()
            && first_slope.is_finite()
            && softness.is_finite()
            && hold_after.is_finite()
            && hold_from.is_finite()
            && c3_0.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            c1,
            c2_0,
            c2_1,
            tau,
            first_slope,
            softness,
            eps,
            hold_after,
            hold_from,
            c3_0,
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
    pub fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let v1 = t - self.t0;
        let elapsed = if v1 < self.hold_after {
            v1
        } else {
            self.hold_after
        };
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let T = -late;
        let v2 = self.softness * elapsed;
        let decay = T * (self.tau + v2);
        let fall = self.first_slope + (2.0 * v2);
        let inv_H = fall / decay;
        let y = self.softness / (fall * inv_H);
        let row2 = ((((-12.0) * y) + self.c2_1) * y) + self.c2_0;
        let row3 = (6.0 * y) + self.c3_0;
        let s1 = ((self.c1 * x[0] * inv_H) + (row2 * x[1])) * inv_H;
        let v = (s1 + (row3 * x[2])) * inv_H;
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if x[0].is_finite() && x[1].is_finite() && x[2].is_finite() {
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
    pub fn tick(&self, t: f64) -> Result<PtcSoft3Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let v1 = t - self.t0;
        let elapsed = if v1 < self.hold_after {
            v1
        } else {
            self.hold_after
        };
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let T = -late;
        let v2 = self.softness * elapsed;
        let decay = T * (self.tau + v2);
        let fall = self.first_slope + (2.0 * v2);
        let inv_H = fall / decay;
        let y = self.softness / (fall * inv_H);
        let row2 = ((((-12.0) * y) + self.c2_1) * y) + self.c2_0;
        let row3 = (6.0 * y) + self.c3_0;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcSoft3Gains {
            gain: [
                self.c1 * (inv_H * inv_H) * inv_H,
                row2 * inv_H * inv_H,
                row3 * inv_H,
            ],
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
impl PtcSoft3Gains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        let s1 = (self.gain[0] * x[0]) + (self.gain[1] * x[1]);
        let v = s1 + (self.gain[2] * x[2]);
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) {
            (v, self.status)
        } else if x[0].is_finite() && x[1].is_finite() && x[2].is_finite() {
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

impl Controller<3> for PtcSoft3 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
