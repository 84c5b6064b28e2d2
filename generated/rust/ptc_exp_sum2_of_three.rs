//! Prescribed-time controller ptc_exp_sum2_of_three: order n = 2, mapping exp_sum.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp_sum(3)" --name ptc_exp_sum2_of_three
//! Version 0.1.0, design c48049514aae.
//!
//! Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
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
//!   rates: rates a_i of stretched time, from 1e-150 to 1e150; rates[0] is a_1 [1/s], rates[1]
//!       is a_2 [1/s], rates[2] is a_3 [1/s]
//!   k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*mean_i(1 - exp(-a_i*t))
//!   kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
//!   in terms of e_i = exp(-a_i*t)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
//!   r_1 = 1/3*tau*a1*e1 + 1/3*tau*a2*e2 + 1/3*tau*a3*e3
//!   r_2 = -1/3*tau*a1^2*e1 - 1/3*tau*a2^2*e2 - 1/3*tau*a3^2*e3
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = r1
//!   B_{2,1} = r2
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   u = sum_j gain_j x_j
//!   gain_j = r_1^-(n+1-j) row_j
//!   row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1
//!   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp_sum is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 46 additions or comparisons, 62
//!       multiplications, 5 divisions, 7 function calls. One round of the iteration is
//!       counted; it takes at most 12.
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
    pub fn exp(a: f64) -> f64 {
        #[cfg(feature = "libm")]
        {
            libm::exp(a)
        }
        #[cfg(not(feature = "libm"))]
        {
            a.exp()
        }
    }

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

/// Run-time parameters of [`PtcExpSum2OfThree`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum2OfThreeParams {
    /// prescribed settling time \[s\], from 1e-150 to 1e150.
    pub tau: f64,
    /// start time \[s\], finite.
    pub t0: f64,
    /// time-to-go at which the gains are held \[s\], >= 1e-150, < tau.
    pub eps: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rates a_i of stretched time, from 1e-150 to 1e150; rates\[0\] is a_1 \[1/s\], rates\[1\] is a_2 \[1/s\], rates\[2\] is a_3 \[1/s\].
    pub rates: [f64; 3],
    /// gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k\[0\] is k_1 \[1/s^2\], k\[1\] is k_2 \[1/s\].
    pub k: [f64; 2],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum2OfThree {
    /// rates a_i of stretched time.
    a1: f64,
    /// rates a_i of stretched time.
    a2: f64,
    /// rates a_i of stretched time.
    a3: f64,
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
    /// N/tau, N the number of rates.
    target_rate: f64,
    /// 1/min a_i.
    slowest: f64,
    /// 1/mean a_i.
    mean_period: f64,
    /// size of the last step of the iteration.
    tolerance: f64,
    /// weight of exp(-a1*y) in r1/1!.
    b1_1: f64,
    /// weight of exp(-a2*y) in r1/1!.
    b1_2: f64,
    /// weight of exp(-a3*y) in r1/1!.
    b1_3: f64,
    /// weight of exp(-a1*y) in r2/2!.
    b2_1: f64,
    /// weight of exp(-a2*y) in r2/2!.
    b2_2: f64,
    /// weight of exp(-a3*y) in r2/2!.
    b2_3: f64,
    /// weighted gain -0!*k1.
    w1: f64,
    /// weighted gain -1!*k2.
    w2: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcExpSum2OfThree`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum2OfThreeGains {
    /// u = gain\[0\] x\[0\] + ... + gain\[1\] x\[1\].
    pub gain: [f64; 2],
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
impl PtcExpSum2OfThree {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcExpSum2OfThreeParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a1 = params.rates[0];
        let a2 = params.rates[1];
        let a3 = params.rates[2];
        let k1 = params.k[0];
        let k2 = params.k[1];
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && a1.is_finite()
            && (1e-150 <= a1)
            && (a1 <= 1e150)
            && a2.is_finite()
            && (1e-150 <= a2)
            && (a2 <= 1e150)
            && a3.is_finite()
            && (1e-150 <= a3)
            && (a3 <= 1e150)
            && k1.is_finite()
            && k2.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let target_rate = 3.0 / tau;
        let v1 = 1.0 / a1;
        let v2 = if a1 < a2 { a2 } else { a1 };
        let v3 = 1.0 / a2;
        let v4 = if v1 < v3 { v3 } else { v1 };
        let v5 = 1.0 / a3;
        let slowest = if v4 < v5 { v5 } else { v4 };
        let mean_period = 3.0 / (a1 + a2 + a3);
        let s1 = if v2 < a3 { a3 } else { v2 };
        let tolerance = 0.03 / s1;
        let b1_1 = 0.3333333333333333 * a1 * tau;
        let b1_2 = 0.3333333333333333 * a2 * tau;
        let b1_3 = 0.3333333333333333 * a3 * tau;
        let b2_1 = (-0.16666666666666666) * (a1 * a1) * tau;
        let b2_2 = (-0.16666666666666666) * (a2 * a2) * tau;
        let b2_3 = (-0.16666666666666666) * (a3 * a3) * tau;
        let w1 = -k1;
        let w2 = -k2;
        let size_w1 = if k1.abs() <= 0.0 { 1e-200 } else { w1.abs() };
        let size_w2 = if k2.abs() <= 0.0 { 1e-200 } else { w2.abs() };
        if !((b2_1 <= -1e-200)
            && (b2_2 <= -1e-200)
            && (b2_3 <= -1e-200)
            && (size_w1 >= 1e-200)
            && (size_w2 >= 1e-200)
            && hold_from.is_finite()
            && target_rate.is_finite()
            && slowest.is_finite()
            && mean_period.is_finite()
            && tolerance.is_finite()
            && b1_1.is_finite()
            && b1_2.is_finite()
            && b1_3.is_finite()
            && b2_1.is_finite()
            && b2_2.is_finite()
            && b2_3.is_finite()
            && w1.is_finite()
            && w2.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            a1,
            a2,
            a3,
            tau,
            eps,
            hold_from,
            target_rate,
            slowest,
            mean_period,
            tolerance,
            b1_1,
            b1_2,
            b1_3,
            b2_1,
            b2_2,
            b2_3,
            w1,
            w2,
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
        let target = T * self.target_rate;
        let v1 = -math::ln(target / 3.0);
        let v2 = v1 * self.mean_period;
        let v3 = (v1 - 1.098611831665039) * self.slowest;
        let mut y = if v2 < v3 { v3 } else { v2 };
        let mut y_low = v2;
        let mut y_high = v1 * self.slowest;
        for _ in 0..12 {
            let v4 = math::exp(-(self.a1 * y));
            let v5 = math::exp(-(self.a2 * y));
            let v6 = math::exp(-(self.a3 * y));
            let v7 = self.a1 * v4;
            let v8 = self.a2 * v5;
            let v9 = v4 + v5 + v6;
            let v10 = self.a3 * v6;
            let v11 = (2.0 * (v9 - target)) / (v9 + target);
            let v12 = v11 * (1.0 + (0.08333333333333333 * (v11 * v11)));
            let v13 = 1.0 / (v7 + v8 + v10);
            let v14 = v9 * v13;
            let s1 = ((self.a1 * v7) + (self.a2 * v8) + (self.a3 * v10)) * v13;
            let v15 = v12 * v14 * (1.0 + (0.5 * v12 * ((s1 * v14) - 1.0)));
            let y_next = y + v15;
            let y_size = v15.abs();
            if v12 > 0.0 {
                y_low = y;
            } else {
                y_high = y;
            }
            if (y_low <= y_next) && (y_next <= y_high) {
                y = y_next;
            } else {
                y = 0.5 * (y_low + y_high);
            }
            if y_size <= self.tolerance {
                break;
            }
        }
        let v16 = math::exp(-(self.a1 * y));
        let v17 = math::exp(-(self.a2 * y));
        let v18 = math::exp(-(self.a3 * y));
        let v19 = self.a1 * v16;
        let v20 = self.a2 * v17;
        let v21 = self.a3 * v18;
        let v22 = 1.0 / (v19 + v20 + v21);
        let v23 = ((v16 + v17 + v18) - target) * v22;
        let s2 = ((self.a1 * v19) + (self.a2 * v20) + (self.a3 * v21)) * v22;
        let v24 = v23 * (1.0 + (0.5 * (s2 * v23)));
        let v25 = self.a1 * v24;
        let v26 = v16 - (v16 * (v25 * (1.0 - (0.5 * v25))));
        let v27 = self.a2 * v24;
        let v28 = v17 - (v17 * (v27 * (1.0 - (0.5 * v27))));
        let v29 = self.a3 * v24;
        let v30 = v18 - (v18 * (v29 * (1.0 - (0.5 * v29))));
        let s3 = (self.b1_1 * v26) + (self.b1_2 * v28) + (self.b1_3 * v30);
        let inv_r1 = 1.0 / s3;
        let s4 = (self.b2_1 * v26) + (self.b2_2 * v28) + (self.b2_3 * v30);
        let p2 = s4 * inv_r1;
        let s5 = (self.w1 * x[0] * inv_r1) + ((self.w2 + ((-2.0) * p2)) * x[1]);
        let v = s5 * inv_r1;
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

    /// The gains at time t \[s\], for several axes that share one deadline: tick once, then axis
    /// for each. The result of tick and axis may differ from that of step in the last bits.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn tick(&self, t: f64) -> Result<PtcExpSum2OfThreeGains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let T = -late;
        let target = T * self.target_rate;
        let v1 = -math::ln(target / 3.0);
        let v2 = v1 * self.mean_period;
        let v3 = (v1 - 1.098611831665039) * self.slowest;
        let mut y = if v2 < v3 { v3 } else { v2 };
        let mut y_low = v2;
        let mut y_high = v1 * self.slowest;
        for _ in 0..12 {
            let v4 = math::exp(-(self.a1 * y));
            let v5 = math::exp(-(self.a2 * y));
            let v6 = math::exp(-(self.a3 * y));
            let v7 = self.a1 * v4;
            let v8 = self.a2 * v5;
            let v9 = v4 + v5 + v6;
            let v10 = self.a3 * v6;
            let v11 = (2.0 * (v9 - target)) / (v9 + target);
            let v12 = v11 * (1.0 + (0.08333333333333333 * (v11 * v11)));
            let v13 = 1.0 / (v7 + v8 + v10);
            let v14 = v9 * v13;
            let s1 = ((self.a1 * v7) + (self.a2 * v8) + (self.a3 * v10)) * v13;
            let v15 = v12 * v14 * (1.0 + (0.5 * v12 * ((s1 * v14) - 1.0)));
            let y_next = y + v15;
            let y_size = v15.abs();
            if v12 > 0.0 {
                y_low = y;
            } else {
                y_high = y;
            }
            if (y_low <= y_next) && (y_next <= y_high) {
                y = y_next;
            } else {
                y = 0.5 * (y_low + y_high);
            }
            if y_size <= self.tolerance {
                break;
            }
        }
        let v16 = math::exp(-(self.a1 * y));
        let v17 = math::exp(-(self.a2 * y));
        let v18 = math::exp(-(self.a3 * y));
        let v19 = self.a1 * v16;
        let v20 = self.a2 * v17;
        let v21 = self.a3 * v18;
        let v22 = 1.0 / (v19 + v20 + v21);
        let v23 = ((v16 + v17 + v18) - target) * v22;
        let s2 = ((self.a1 * v19) + (self.a2 * v20) + (self.a3 * v21)) * v22;
        let v24 = v23 * (1.0 + (0.5 * (s2 * v23)));
        let v25 = self.a1 * v24;
        let v26 = v16 - (v16 * (v25 * (1.0 - (0.5 * v25))));
        let v27 = self.a2 * v24;
        let v28 = v17 - (v17 * (v27 * (1.0 - (0.5 * v27))));
        let v29 = self.a3 * v24;
        let v30 = v18 - (v18 * (v29 * (1.0 - (0.5 * v29))));
        let s3 = (self.b1_1 * v26) + (self.b1_2 * v28) + (self.b1_3 * v30);
        let inv_r1 = 1.0 / s3;
        let s4 = (self.b2_1 * v26) + (self.b2_2 * v28) + (self.b2_3 * v30);
        let p2 = s4 * inv_r1;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcExpSum2OfThreeGains {
            gain: [
                self.w1 * inv_r1 * inv_r1,
                (self.w2 + ((-2.0) * p2)) * inv_r1,
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
impl PtcExpSum2OfThreeGains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        let v = (self.gain[0] * x[0]) + (self.gain[1] * x[1]);
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) {
            (v, self.status)
        } else if x[0].is_finite() && x[1].is_finite() {
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

impl Controller<2> for PtcExpSum2OfThree {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
