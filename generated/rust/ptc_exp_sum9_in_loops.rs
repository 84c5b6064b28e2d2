//! Prescribed-time controller ptc_exp_sum9_in_loops: order n = 9, mapping exp_sum.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 9 --mu "exp_sum(2)" --name ptc_exp_sum9_in_loops
//! Version 0.1.0, design 5f12a5cbef5a.
//!
//! Plant: x1' = x2, ..., x9' = f + u. Time in s, x1 in any unit U, x2 in U/s, ..., x9 in
//!       U/s^8, u in U/s^9.
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
//!       is a_2 [1/s]
//!   k: gains of pi0 = -(k_1 xi_1 + ... + k_9 xi_9), finite; k[0] is k_1 [1/s^9], ..., k[8] is
//!       k_9 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*mean_i(1 - exp(-a_i*t))
//!   kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
//!   in terms of e_i = exp(-a_i*t)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
//!   r_1 = 1/2*tau*a1*e1 + 1/2*tau*a2*e2
//!   r_2 = -1/2*tau*a1^2*e1 - 1/2*tau*a2^2*e2
//!   r_3 = 1/2*tau*a1^3*e1 + 1/2*tau*a2^3*e2
//!   r_4 = -1/2*tau*a1^4*e1 - 1/2*tau*a2^4*e2
//!   r_5 = 1/2*tau*a1^5*e1 + 1/2*tau*a2^5*e2
//!   r_6 = -1/2*tau*a1^6*e1 - 1/2*tau*a2^6*e2
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = r1
//!   B_{2,1} = r2
//!   B_{2,2} = r1^2
//!   B_{3,1} = r3
//!   B_{3,2} = 3*r1*r2
//!   B_{3,3} = r1^3
//!   B_{4,1} = r4
//!   B_{4,2} = 4*r1*r3 + 3*r2^2
//!   B_{4,3} = 6*r1^2*r2
//!   B_{4,4} = r1^4
//!   B_{5,1} = r5
//!   B_{5,2} = 5*r1*r4 + 10*r2*r3
//!   B_{5,3} = 15*r1*r2^2 + 10*r1^2*r3
//!   B_{5,4} = 10*r1^3*r2
//!   B_{5,5} = r1^5
//!   B_{6,1} = r6
//!   B_{6,2} = 6*r1*r5 + 15*r2*r4 + 10*r3^2
//!   B_{6,3} = 60*r1*r2*r3 + 15*r1^2*r4 + 15*r2^3
//!   B_{6,4} = 45*r1^2*r2^2 + 20*r1^3*r3
//!   B_{6,5} = 15*r1^4*r2
//!   (to order 6; all of them: ptc-codegen show matrix --n 9 --mu exp_sum)
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_9 xi_9)
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
//! Operations of one step, without input checks and clipping: 145 additions or comparisons,
//!       182 multiplications, 5 divisions, 5 function calls. One round of the iteration is
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

/// Run-time parameters of [`PtcExpSum9InLoops`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum9InLoopsParams {
    /// prescribed settling time \[s\], from 1e-150 to 1e150.
    pub tau: f64,
    /// start time \[s\], finite.
    pub t0: f64,
    /// time-to-go at which the gains are held \[s\], >= 1e-150, < tau.
    pub eps: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// rates a_i of stretched time, from 1e-150 to 1e150; rates\[0\] is a_1 \[1/s\], rates\[1\] is a_2 \[1/s\].
    pub rates: [f64; 2],
    /// gains of pi0 = -(k_1 xi_1 + ... + k_9 xi_9), finite; k\[0\] is k_1 \[1/s^9\], ..., k\[8\] is k_9 \[1/s\].
    pub k: [f64; 9],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum9InLoops {
    /// rates a_i of stretched time.
    a1: f64,
    /// rates a_i of stretched time.
    a2: f64,
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
    /// weight of exp(-a1*y) in r2/2!.
    b2_1: f64,
    /// weight of exp(-a2*y) in r2/2!.
    b2_2: f64,
    /// weight of exp(-a1*y) in r3/3!.
    b3_1: f64,
    /// weight of exp(-a2*y) in r3/3!.
    b3_2: f64,
    /// weight of exp(-a1*y) in r4/4!.
    b4_1: f64,
    /// weight of exp(-a2*y) in r4/4!.
    b4_2: f64,
    /// weight of exp(-a1*y) in r5/5!.
    b5_1: f64,
    /// weight of exp(-a2*y) in r5/5!.
    b5_2: f64,
    /// weight of exp(-a1*y) in r6/6!.
    b6_1: f64,
    /// weight of exp(-a2*y) in r6/6!.
    b6_2: f64,
    /// weight of exp(-a1*y) in r7/7!.
    b7_1: f64,
    /// weight of exp(-a2*y) in r7/7!.
    b7_2: f64,
    /// weight of exp(-a1*y) in r8/8!.
    b8_1: f64,
    /// weight of exp(-a2*y) in r8/8!.
    b8_2: f64,
    /// weight of exp(-a1*y) in r9/9!.
    b9_1: f64,
    /// weight of exp(-a2*y) in r9/9!.
    b9_2: f64,
    /// weighted gain -0!*k1.
    w1: f64,
    /// weighted gain -1!*k2.
    w2: f64,
    /// weighted gain -2!*k3.
    w3: f64,
    /// weighted gain -3!*k4.
    w4: f64,
    /// weighted gain -4!*k5.
    w5: f64,
    /// weighted gain -5!*k6.
    w6: f64,
    /// weighted gain -6!*k7.
    w7: f64,
    /// weighted gain -7!*k8.
    w8: f64,
    /// weighted gain -8!*k9.
    w9: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcExpSum9InLoops`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExpSum9InLoopsGains {
    /// u = gain\[0\] x\[0\] + ... + gain\[8\] x\[8\].
    pub gain: [f64; 9],
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
impl PtcExpSum9InLoops {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcExpSum9InLoopsParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a1 = params.rates[0];
        let a2 = params.rates[1];
        let k1 = params.k[0];
        let k2 = params.k[1];
        let k3 = params.k[2];
        let k4 = params.k[3];
        let k5 = params.k[4];
        let k6 = params.k[5];
        let k7 = params.k[6];
        let k8 = params.k[7];
        let k9 = params.k[8];
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
            && k1.is_finite()
            && k2.is_finite()
            && k3.is_finite()
            && k4.is_finite()
            && k5.is_finite()
            && k6.is_finite()
            && k7.is_finite()
            && k8.is_finite()
            && k9.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let target_rate = 2.0 / tau;
        let v1 = 1.0 / a1;
        let v2 = 1.0 / a2;
        let slowest = if v1 < v2 { v2 } else { v1 };
        let mean_period = 2.0 / (a1 + a2);
        let s1 = if a1 < a2 { a2 } else { a1 };
        let tolerance = 0.03 / s1;
        let b1_1 = 0.5 * a1 * tau;
        let b1_2 = 0.5 * a2 * tau;
        let v3 = a1 * a1;
        let b2_1 = (-0.25) * v3 * tau;
        let v4 = a2 * a2;
        let b2_2 = (-0.25) * v4 * tau;
        let v5 = a1 * v3;
        let b3_1 = 0.08333333333333333 * v5 * tau;
        let v6 = a2 * v4;
        let b3_2 = 0.08333333333333333 * v6 * tau;
        let v7 = v3 * v3;
        let b4_1 = (-0.020833333333333332) * v7 * tau;
        let v8 = v4 * v4;
        let b4_2 = (-0.020833333333333332) * v8 * tau;
        let v9 = a1 * v7;
        let b5_1 = 0.004166666666666667 * v9 * tau;
        let v10 = a2 * v8;
        let b5_2 = 0.004166666666666667 * v10 * tau;
        let v11 = v3 * v7;
        let b6_1 = (-0.0006944444444444445) * v11 * tau;
        let v12 = v4 * v8;
        let b6_2 = (-0.0006944444444444445) * v12 * tau;
        let v13 = v5 * v7;
        let b7_1 = 9.92063492063492e-5 * v13 * tau;
        let v14 = v6 * v8;
        let b7_2 = 9.92063492063492e-5 * v14 * tau;
        let v15 = v7 * v7;
        let b8_1 = (-1.240079365079365e-5) * v15 * tau;
        let v16 = v8 * v8;
        let b8_2 = (-1.240079365079365e-5) * v16 * tau;
        let v17 = a1 * v15;
        let b9_1 = 1.3778659611992946e-6 * v17 * tau;
        let v18 = a2 * v16;
        let b9_2 = 1.3778659611992946e-6 * v18 * tau;
        let w1 = -k1;
        let w2 = -k2;
        let w3 = (-2.0) * k3;
        let w4 = (-6.0) * k4;
        let w5 = (-24.0) * k5;
        let w6 = (-120.0) * k6;
        let w7 = (-720.0) * k7;
        let w8 = (-5040.0) * k8;
        let w9 = (-40320.0) * k9;
        let size_w1 = if k1.abs() <= 0.0 { 1e-200 } else { w1.abs() };
        let size_w2 = if k2.abs() <= 0.0 { 1e-200 } else { w2.abs() };
        let size_w3 = if k3.abs() <= 0.0 { 1e-200 } else { w3.abs() };
        let size_w4 = if k4.abs() <= 0.0 { 1e-200 } else { w4.abs() };
        let size_w5 = if k5.abs() <= 0.0 { 1e-200 } else { w5.abs() };
        let size_w6 = if k6.abs() <= 0.0 { 1e-200 } else { w6.abs() };
        let size_w7 = if k7.abs() <= 0.0 { 1e-200 } else { w7.abs() };
        let size_w8 = if k8.abs() <= 0.0 { 1e-200 } else { w8.abs() };
        let size_w9 = if k9.abs() <= 0.0 { 1e-200 } else { w9.abs() };
        if !((b2_1 <= -1e-200)
            && (b2_2 <= -1e-200)
            && (v5 >= 1e-200)
            && (b3_1 >= 1e-200)
            && (v6 >= 1e-200)
            && (b3_2 >= 1e-200)
            && (v7 >= 1e-200)
            && (b4_1 <= -1e-200)
            && (v8 >= 1e-200)
            && (b4_2 <= -1e-200)
            && (v9 >= 1e-200)
            && (b5_1 >= 1e-200)
            && (v10 >= 1e-200)
            && (b5_2 >= 1e-200)
            && (v11 >= 1e-200)
            && (b6_1 <= -1e-200)
            && (v12 >= 1e-200)
            && (b6_2 <= -1e-200)
            && (v13 >= 1e-200)
            && (b7_1 >= 1e-200)
            && (v14 >= 1e-200)
            && (b7_2 >= 1e-200)
            && (v15 >= 1e-200)
            && (b8_1 <= -1e-200)
            && (v16 >= 1e-200)
            && (b8_2 <= -1e-200)
            && (v17 >= 1e-200)
            && (b9_1 >= 1e-200)
            && (v18 >= 1e-200)
            && (b9_2 >= 1e-200)
            && (size_w1 >= 1e-200)
            && (size_w2 >= 1e-200)
            && (size_w3 >= 1e-200)
            && (size_w4 >= 1e-200)
            && (size_w5 >= 1e-200)
            && (size_w6 >= 1e-200)
            && (size_w7 >= 1e-200)
            && (size_w8 >= 1e-200)
            && (size_w9 >= 1e-200)
            && hold_from.is_finite()
            && target_rate.is_finite()
            && slowest.is_finite()
            && mean_period.is_finite()
            && tolerance.is_finite()
            && b1_1.is_finite()
            && b1_2.is_finite()
            && b2_1.is_finite()
            && b2_2.is_finite()
            && b3_1.is_finite()
            && b3_2.is_finite()
            && b4_1.is_finite()
            && b4_2.is_finite()
            && b5_1.is_finite()
            && b5_2.is_finite()
            && b6_1.is_finite()
            && b6_2.is_finite()
            && b7_1.is_finite()
            && b7_2.is_finite()
            && b8_1.is_finite()
            && b8_2.is_finite()
            && b9_1.is_finite()
            && b9_2.is_finite()
            && w1.is_finite()
            && w2.is_finite()
            && w3.is_finite()
            && w4.is_finite()
            && w5.is_finite()
            && w6.is_finite()
            && w7.is_finite()
            && w8.is_finite()
            && w9.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            a1,
            a2,
            tau,
            eps,
            hold_from,
            target_rate,
            slowest,
            mean_period,
            tolerance,
            b1_1,
            b1_2,
            b2_1,
            b2_2,
            b3_1,
            b3_2,
            b4_1,
            b4_2,
            b5_1,
            b5_2,
            b6_1,
            b6_2,
            b7_1,
            b7_2,
            b8_1,
            b8_2,
            b9_1,
            b9_2,
            w1,
            w2,
            w3,
            w4,
            w5,
            w6,
            w7,
            w8,
            w9,
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
    pub fn step(&self, t: f64, x: &[f64; 9]) -> Result<Control<f64>, Error> {
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
        let v1 = -math::ln(target / 2.0);
        let v2 = v1 * self.mean_period;
        let v3 = (v1 - 0.6931467056274414) * self.slowest;
        let mut y = if v2 < v3 { v3 } else { v2 };
        let mut y_low = v2;
        let mut y_high = v1 * self.slowest;
        for _ in 0..12 {
            let v4 = math::exp(-(self.a1 * y));
            let v5 = math::exp(-(self.a2 * y));
            let v6 = self.a1 * v4;
            let v7 = v4 + v5;
            let v8 = self.a2 * v5;
            let v9 = (2.0 * (v7 - target)) / (v7 + target);
            let v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
            let v11 = 1.0 / (v6 + v8);
            let v12 = v7 * v11;
            let s1 = (((self.a1 * v6) + (self.a2 * v8)) * v11 * v12) - 1.0;
            let v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
            let y_next = y + v13;
            let y_size = v13.abs();
            if v10 > 0.0 {
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
        let v14 = math::exp(-(self.a1 * y));
        let v15 = math::exp(-(self.a2 * y));
        let v16 = self.a1 * v14;
        let v17 = self.a2 * v15;
        let v18 = 1.0 / (v16 + v17);
        let v19 = ((v14 + v15) - target) * v18;
        let s2 = 1.0 + (0.5 * (((self.a1 * v16) + (self.a2 * v17)) * v18 * v19));
        let v20 = v19 * s2;
        let v21 = self.a1 * v20;
        let v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))));
        let v23 = self.a2 * v20;
        let v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))));
        let inv_r1 = 1.0 / ((self.b1_1 * v22) + (self.b1_2 * v24));
        let p2 = ((self.b2_1 * v22) + (self.b2_2 * v24)) * inv_r1;
        let p3 = ((self.b3_1 * v22) + (self.b3_2 * v24)) * inv_r1;
        let p4 = ((self.b4_1 * v22) + (self.b4_2 * v24)) * inv_r1;
        let p5 = ((self.b5_1 * v22) + (self.b5_2 * v24)) * inv_r1;
        let p6 = ((self.b6_1 * v22) + (self.b6_2 * v24)) * inv_r1;
        let p7 = ((self.b7_1 * v22) + (self.b7_2 * v24)) * inv_r1;
        let p8 = ((self.b8_1 * v22) + (self.b8_2 * v24)) * inv_r1;
        let p9 = ((self.b9_1 * v22) + (self.b9_2 * v24)) * inv_r1;
        let given_row = [
            self.w2, self.w3, self.w4, self.w5, self.w6, self.w7, self.w8, self.w9, -362880.0,
        ];
        let row_p = [p2, p3, p4, p5, p6, p7, p8, p9];
        let row = Self::row_sums(given_row, row_p);
        let row3 = row[1] * 0.5;
        let row4 = row[2] * 0.16666666666666666;
        let row5 = row[3] * 0.041666666666666664;
        let row6 = row[4] * 0.008333333333333333;
        let row7 = row[5] * 0.001388888888888889;
        let row8 = row[6] * 0.0001984126984126984;
        let row9 = row[7] * 2.48015873015873e-5;
        let s3 = ((self.w1 * x[0] * inv_r1) + (row[0] * x[1])) * inv_r1;
        let s4 = (((s3 + (row3 * x[2])) * inv_r1) + (row4 * x[3])) * inv_r1;
        let s5 = (((s4 + (row5 * x[4])) * inv_r1) + (row6 * x[5])) * inv_r1;
        let s6 = (((s5 + (row7 * x[6])) * inv_r1) + (row8 * x[7])) * inv_r1;
        let v = (s6 + (row9 * x[8])) * inv_r1;
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if t.is_finite()
            && x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && x[3].is_finite()
            && x[4].is_finite()
            && x[5].is_finite()
            && x[6].is_finite()
            && x[7].is_finite()
            && x[8].is_finite()
        {
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
    pub fn tick(&self, t: f64) -> Result<PtcExpSum9InLoopsGains, Error> {
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
        let v1 = -math::ln(target / 2.0);
        let v2 = v1 * self.mean_period;
        let v3 = (v1 - 0.6931467056274414) * self.slowest;
        let mut y = if v2 < v3 { v3 } else { v2 };
        let mut y_low = v2;
        let mut y_high = v1 * self.slowest;
        for _ in 0..12 {
            let v4 = math::exp(-(self.a1 * y));
            let v5 = math::exp(-(self.a2 * y));
            let v6 = self.a1 * v4;
            let v7 = v4 + v5;
            let v8 = self.a2 * v5;
            let v9 = (2.0 * (v7 - target)) / (v7 + target);
            let v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
            let v11 = 1.0 / (v6 + v8);
            let v12 = v7 * v11;
            let s1 = (((self.a1 * v6) + (self.a2 * v8)) * v11 * v12) - 1.0;
            let v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
            let y_next = y + v13;
            let y_size = v13.abs();
            if v10 > 0.0 {
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
        let v14 = math::exp(-(self.a1 * y));
        let v15 = math::exp(-(self.a2 * y));
        let v16 = self.a1 * v14;
        let v17 = self.a2 * v15;
        let v18 = 1.0 / (v16 + v17);
        let v19 = ((v14 + v15) - target) * v18;
        let s2 = 1.0 + (0.5 * (((self.a1 * v16) + (self.a2 * v17)) * v18 * v19));
        let v20 = v19 * s2;
        let v21 = self.a1 * v20;
        let v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))));
        let v23 = self.a2 * v20;
        let v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))));
        let inv_r1 = 1.0 / ((self.b1_1 * v22) + (self.b1_2 * v24));
        let p2 = ((self.b2_1 * v22) + (self.b2_2 * v24)) * inv_r1;
        let p3 = ((self.b3_1 * v22) + (self.b3_2 * v24)) * inv_r1;
        let p4 = ((self.b4_1 * v22) + (self.b4_2 * v24)) * inv_r1;
        let p5 = ((self.b5_1 * v22) + (self.b5_2 * v24)) * inv_r1;
        let p6 = ((self.b6_1 * v22) + (self.b6_2 * v24)) * inv_r1;
        let p7 = ((self.b7_1 * v22) + (self.b7_2 * v24)) * inv_r1;
        let p8 = ((self.b8_1 * v22) + (self.b8_2 * v24)) * inv_r1;
        let p9 = ((self.b9_1 * v22) + (self.b9_2 * v24)) * inv_r1;
        let given_row = [
            self.w2, self.w3, self.w4, self.w5, self.w6, self.w7, self.w8, self.w9, -362880.0,
        ];
        let row_p = [p2, p3, p4, p5, p6, p7, p8, p9];
        let row = Self::row_sums(given_row, row_p);
        let row3 = row[1] * 0.5;
        let row4 = row[2] * 0.16666666666666666;
        let row5 = row[3] * 0.041666666666666664;
        let row6 = row[4] * 0.008333333333333333;
        let row7 = row[5] * 0.001388888888888889;
        let row8 = row[6] * 0.0001984126984126984;
        let row9 = row[7] * 2.48015873015873e-5;
        let v25 = inv_r1 * inv_r1;
        let v26 = v25 * inv_r1;
        let v27 = v26 * inv_r1;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcExpSum9InLoopsGains {
            gain: [
                self.w1 * (v27 * inv_r1) * v27,
                row[0] * v27 * v27,
                row3 * v27 * v26,
                row4 * v26 * v26,
                row5 * v26 * v25,
                row6 * v25 * v25,
                row7 * v25 * inv_r1,
                row8 * inv_r1 * inv_r1,
                row9 * inv_r1,
            ],
            u_max: self.u_max,
            status,
        })
    }

    /// Loops over the powers of the Taylor series of mu, for the gains of all states at once; q is
    /// p^2.
    fn row_sums(mut row: [f64; 9], p: [f64; 8]) -> [f64; 9] {
        let mut q = [0.0; 8];
        q[0] = p[0] + p[0];
        q[1] = p[1] + p[1];
        q[1] = q[1] + (p[0] * p[0]);
        q[2] = p[2] + p[2];
        q[2] = q[2] + (p[0] * p[1]);
        q[2] = q[2] + (p[1] * p[0]);
        q[3] = p[3] + p[3];
        q[3] = q[3] + (p[0] * p[2]);
        q[3] = q[3] + (p[1] * p[1]);
        q[3] = q[3] + (p[2] * p[0]);
        q[4] = p[4] + p[4];
        q[4] = q[4] + (p[0] * p[3]);
        q[4] = q[4] + (p[1] * p[2]);
        q[4] = q[4] + (p[2] * p[1]);
        q[4] = q[4] + (p[3] * p[0]);
        q[5] = p[5] + p[5];
        q[5] = q[5] + (p[0] * p[4]);
        q[5] = q[5] + (p[1] * p[3]);
        q[5] = q[5] + (p[2] * p[2]);
        q[5] = q[5] + (p[3] * p[1]);
        q[5] = q[5] + (p[4] * p[0]);
        q[6] = p[6] + p[6];
        q[6] = q[6] + (p[0] * p[5]);
        q[6] = q[6] + (p[1] * p[4]);
        q[6] = q[6] + (p[2] * p[3]);
        q[6] = q[6] + (p[3] * p[2]);
        q[6] = q[6] + (p[4] * p[1]);
        q[6] = q[6] + (p[5] * p[0]);
        for round in (0..8).step_by(2) {
            let mut f = &p;
            if round == 0 {
                let mut v = row[0];
                v = v + (f[0] * row[1]);
                v = v + (f[1] * row[2]);
                v = v + (f[2] * row[3]);
                v = v + (f[3] * row[4]);
                v = v + (f[4] * row[5]);
                v = v + (f[5] * row[6]);
                v = v + (f[6] * row[7]);
                v = v + (f[7] * row[8]);
                row[0] = v;
                let mut w = row[1];
                w = w + (q[0] * row[2]);
                w = w + (q[1] * row[3]);
                w = w + (q[2] * row[4]);
                w = w + (q[3] * row[5]);
                w = w + (q[4] * row[6]);
                w = w + (q[5] * row[7]);
                w = w + (q[6] * row[8]);
                row[1] = w;
                f = &q;
            }
            if round < 4 {
                let mut v = row[2];
                v = v + (f[0] * row[3]);
                v = v + (f[1] * row[4]);
                v = v + (f[2] * row[5]);
                v = v + (f[3] * row[6]);
                v = v + (f[4] * row[7]);
                v = v + (f[5] * row[8]);
                row[2] = v;
                let mut w = row[3];
                w = w + (q[0] * row[4]);
                w = w + (q[1] * row[5]);
                w = w + (q[2] * row[6]);
                w = w + (q[3] * row[7]);
                w = w + (q[4] * row[8]);
                row[3] = w;
                f = &q;
            }
            if round < 6 {
                let mut v = row[4];
                v = v + (f[0] * row[5]);
                v = v + (f[1] * row[6]);
                v = v + (f[2] * row[7]);
                v = v + (f[3] * row[8]);
                row[4] = v;
                let mut w = row[5];
                w = w + (q[0] * row[6]);
                w = w + (q[1] * row[7]);
                w = w + (q[2] * row[8]);
                row[5] = w;
                f = &q;
            }
            let mut v = row[6];
            v = v + (f[0] * row[7]);
            v = v + (f[1] * row[8]);
            row[6] = v;
            let mut w = row[7];
            w = w + (q[0] * row[8]);
            row[7] = w;
        }
        row
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
impl PtcExpSum9InLoopsGains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 9]) -> Result<Control<f64>, Error> {
        let s1 = (self.gain[0] * x[0]) + (self.gain[1] * x[1]);
        let s2 = s1 + (self.gain[2] * x[2]) + (self.gain[3] * x[3]);
        let s3 = s2 + (self.gain[4] * x[4]) + (self.gain[5] * x[5]);
        let s4 = s3 + (self.gain[6] * x[6]) + (self.gain[7] * x[7]);
        let v = s4 + (self.gain[8] * x[8]);
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) {
            (v, self.status)
        } else if x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && x[3].is_finite()
            && x[4].is_finite()
            && x[5].is_finite()
            && x[6].is_finite()
            && x[7].is_finite()
            && x[8].is_finite()
        {
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

impl Controller<9> for PtcExpSum9InLoops {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 9]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
