//! Prescribed-time controller ptc_algebraic5: order n = 5, mapping algebraic.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 5 --mu algebraic
//! Version 0.1.0, design 30fc958d5b69.
//!
//! Plant: x1' = x2, ..., x5' = f + u. Time in s, x1 in any unit U, x2 in U/s, ..., x5 in
//!       U/s^4, u in U/s^5.
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
//!   k: gains of pi0 = -(k_1 xi_1 + ... + k_5 xi_5), finite; k[0] is k_1 [1/s^5], ..., k[4] is
//!       k_5 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*a*t/sqrt(1 + (a*t)^2)
//!   kappa(Dt) = y/a, y = (tau - T)/sqrt(T*(2*tau - T))
//!   in terms of y = a*t, h = 1/sqrt(1 + y^2)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = tau a^k v^(1 + k/2) Q_k(s), s = 1 - T/tau, v = 1 - s^2, Q_1 = 1, Q_{k+1} = v Q_k' -
//!       (k+2) s Q_k
//!   r_1 = tau*a*h^3
//!   r_2 = -3*tau*a^2*y*h^5
//!   r_3 = 12*tau*a^3*y^2*h^7 - 3*tau*a^3*h^7
//!   r_4 = 45*tau*a^4*y*h^9 - 60*tau*a^4*y^3*h^9
//!   r_5 = -540*tau*a^5*y^2*h^11 + 360*tau*a^5*y^4*h^11 + 45*tau*a^5*h^11
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = tau*a*h^3
//!   B_{2,1} = -3*tau*a^2*y*h^5
//!   B_{2,2} = tau^2*a^2*h^6
//!   B_{3,1} = 12*tau*a^3*y^2*h^7 - 3*tau*a^3*h^7
//!   B_{3,2} = -9*tau^2*a^3*y*h^8
//!   B_{3,3} = tau^3*a^3*h^9
//!   B_{4,1} = 45*tau*a^4*y*h^9 - 60*tau*a^4*y^3*h^9
//!   B_{4,2} = 75*tau^2*a^4*y^2*h^10 - 12*tau^2*a^4*h^10
//!   B_{4,3} = -18*tau^3*a^4*y*h^11
//!   B_{4,4} = tau^4*a^4*h^12
//!   B_{5,1} = -540*tau*a^5*y^2*h^11 + 360*tau*a^5*y^4*h^11 + 45*tau*a^5*h^11
//!   B_{5,2} = 315*tau^2*a^5*y*h^12 - 660*tau^2*a^5*y^3*h^12
//!   B_{5,3} = 255*tau^3*a^5*y^2*h^13 - 30*tau^3*a^5*h^13
//!   B_{5,4} = -30*tau^4*a^5*y*h^14
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_5 xi_5)
//!   u = sum_j gain_j x_j
//!   gain_j = sec^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -tau^-5*K1*one_plus_y2^5
//!   row_2 = -45*tau^-4 - tau^-4*K2 - 4*tau^-4*K2*y^2 - 6*tau^-4*K2*y^4 - 4*tau^-4*K2*y^6 -
//!       tau^-4*K2*y^8 + 3*tau^-4*K3*y + 9*tau^-4*K3*y^3 + 9*tau^-4*K3*y^5 + 3*tau^-4*K3*y^7 +
//!       3*tau^-4*K4 - 6*tau^-4*K4*y^2 - 21*tau^-4*K4*y^4 - 12*tau^-4*K4*y^6 - 45*tau^-4*K5*y
//!       + 15*tau^-4*K5*y^3 + 60*tau^-4*K5*y^5 + 540*tau^-4*y^2 - 360*tau^-4*y^4
//!   row_3 = -tau^-3*K3 - 3*tau^-3*K3*y^2 - 3*tau^-3*K3*y^4 - tau^-3*K3*y^6 + 9*tau^-3*K4*y +
//!       18*tau^-3*K4*y^3 + 9*tau^-3*K4*y^5 + 12*tau^-3*K5 - 63*tau^-3*K5*y^2 -
//!       75*tau^-3*K5*y^4 - 315*tau^-3*y + 660*tau^-3*y^3
//!   row_4 = 30*tau^-2 - tau^-2*K4 - 2*tau^-2*K4*y^2 - tau^-2*K4*y^4 + 18*tau^-2*K5*y +
//!       18*tau^-2*K5*y^3 - 255*tau^-2*y^2
//!   row_5 = -tau^-1*K5 - tau^-1*K5*y^2 + 30*tau^-1*y
//!   one_plus_y2 = 1 + y^2
//!   sec = sqrt(1 + y^2)
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: algebraic is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 31 additions or comparisons, 36
//!       multiplications, 2 divisions, 1 square root.
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

/// Run-time parameters of [`PtcAlgebraic5`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcAlgebraic5Params {
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
    /// gains of pi0 = -(k_1 xi_1 + ... + k_5 xi_5), finite; k\[0\] is k_1 \[1/s^5\], ..., k\[4\] is k_5 \[1/s\].
    pub k: [f64; 5],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcAlgebraic5 {
    /// prescribed settling time.
    tau: f64,
    /// coefficient of one_plus_y2^5 in the gain of x1.
    c1_5: f64,
    /// start time.
    t0: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
    /// time-to-go at which the gains are held.
    eps: f64,
    /// -eps: later than this the gains are held.
    hold_from: f64,
    /// 2*tau.
    two_tau: f64,
    /// tau/2.
    half_tau: f64,
    /// coefficient of y^0 in the gain of x2.
    c2_0: f64,
    /// coefficient of y^1 in the gain of x2.
    c2_1: f64,
    /// coefficient of y^2 in the gain of x2.
    c2_2: f64,
    /// coefficient of y^3 in the gain of x2.
    c2_3: f64,
    /// coefficient of y^4 in the gain of x2.
    c2_4: f64,
    /// coefficient of y^5 in the gain of x2.
    c2_5: f64,
    /// coefficient of y^6 in the gain of x2.
    c2_6: f64,
    /// coefficient of y^7 in the gain of x2.
    c2_7: f64,
    /// coefficient of y^8 in the gain of x2.
    c2_8: f64,
    /// 1/tau.
    inv_tau: f64,
    /// coefficient of y^0 in the gain of x3.
    c3_0: f64,
    /// coefficient of y^1 in the gain of x3.
    c3_1: f64,
    /// coefficient of y^2 in the gain of x3.
    c3_2: f64,
    /// coefficient of y^3 in the gain of x3.
    c3_3: f64,
    /// coefficient of y^4 in the gain of x3.
    c3_4: f64,
    /// coefficient of y^5 in the gain of x3.
    c3_5: f64,
    /// coefficient of y^6 in the gain of x3.
    c3_6: f64,
    /// coefficient of y^0 in the gain of x4.
    c4_0: f64,
    /// coefficient of y^3 in the gain of x4.
    c4_3: f64,
    /// coefficient of y^2 in the gain of x4.
    c4_2: f64,
    /// coefficient of y^4 in the gain of x4.
    c4_4: f64,
    /// coefficient of y^2 in the gain of x5.
    c5_2: f64,
    /// coefficient of y^1 in the gain of x5.
    c5_1: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcAlgebraic5`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcAlgebraic5Gains {
    /// u = gain\[0\] x\[0\] + ... + gain\[4\] x\[4\].
    pub gain: [f64; 5],
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
impl PtcAlgebraic5 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcAlgebraic5Params) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        let k2 = params.k[1];
        let k3 = params.k[2];
        let k4 = params.k[3];
        let k5 = params.k[4];
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
            && k2.is_finite()
            && k3.is_finite()
            && k4.is_finite()
            && k5.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let v1 = a * a;
        let v2 = v1 * v1;
        let v3 = a * v2;
        let K1 = k1 / v3;
        let K2 = k2 / v2;
        let v4 = a * v1;
        let K3 = k3 / v4;
        let K4 = k4 / v1;
        let K5 = k5 / a;
        let v5 = tau * tau;
        let v6 = v5 * v5;
        let v7 = tau * v6;
        let c1_5 = (-K1) / v7;
        let hold_from = -eps;
        let two_tau = 2.0 * tau;
        let half_tau = 0.5 * tau;
        let v8 = -K2;
        let v9 = (v8 + (3.0 * K4)) - 45.0;
        let c2_0 = v9 / v6;
        let v10 = 3.0 * K3;
        let v11 = v10 - (45.0 * K5);
        let c2_1 = v11 / v6;
        let v12 = -(4.0 * K2);
        let v13 = (v12 - (6.0 * K4)) + 540.0;
        let c2_2 = v13 / v6;
        let v14 = 9.0 * K3;
        let v15 = v14 + (15.0 * K5);
        let c2_3 = v15 / v6;
        let v16 = ((-(6.0 * K2)) - (21.0 * K4)) - 360.0;
        let c2_4 = v16 / v6;
        let v17 = v14 + (60.0 * K5);
        let c2_5 = v17 / v6;
        let v18 = v12 - (12.0 * K4);
        let c2_6 = v18 / v6;
        let c2_7 = v10 / v6;
        let c2_8 = v8 / v6;
        let inv_tau = 1.0 / tau;
        let v19 = -K3;
        let v20 = v19 + (12.0 * K5);
        let v21 = tau * v5;
        let c3_0 = v20 / v21;
        let v22 = 9.0 * K4;
        let v23 = v22 - 315.0;
        let c3_1 = v23 / v21;
        let v24 = -v10;
        let v25 = v24 - (63.0 * K5);
        let c3_2 = v25 / v21;
        let v26 = (18.0 * K4) + 660.0;
        let c3_3 = v26 / v21;
        let v27 = v24 - (75.0 * K5);
        let c3_4 = v27 / v21;
        let c3_5 = v22 / v21;
        let c3_6 = v19 / v21;
        let v28 = -K4;
        let c4_0 = (v28 + 30.0) / v5;
        let c4_3 = (18.0 * K5) / v5;
        let c4_2 = ((-(2.0 * K4)) - 255.0) / v5;
        let c4_4 = v28 / v5;
        let c5_2 = (-K5) / tau;
        let c5_1 = 30.0 / tau;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let size_K3 = if k3.abs() <= 0.0 { 1e-200 } else { K3.abs() };
        let size_K4 = if k4.abs() <= 0.0 { 1e-200 } else { K4.abs() };
        let size_K5 = if k5.abs() <= 0.0 { 1e-200 } else { K5.abs() };
        let size_c1_5 = if k1.abs() <= 0.0 { 1e-200 } else { c1_5.abs() };
        let size_c2_0 = if v9.abs() <= 0.0 { 1e-200 } else { c2_0.abs() };
        let size_c2_1 = if v11.abs() <= 0.0 { 1e-200 } else { c2_1.abs() };
        let size_c2_2 = if v13.abs() <= 0.0 { 1e-200 } else { c2_2.abs() };
        let size_c2_3 = if v15.abs() <= 0.0 { 1e-200 } else { c2_3.abs() };
        let size_c2_4 = if v16.abs() <= 0.0 { 1e-200 } else { c2_4.abs() };
        let size_c2_5 = if v17.abs() <= 0.0 { 1e-200 } else { c2_5.abs() };
        let size_c2_6 = if v18.abs() <= 0.0 { 1e-200 } else { c2_6.abs() };
        let size_c2_7 = if k3.abs() <= 0.0 { 1e-200 } else { c2_7.abs() };
        let size_c2_8 = if k2.abs() <= 0.0 { 1e-200 } else { c2_8.abs() };
        let size_c3_0 = if v20.abs() <= 0.0 { 1e-200 } else { c3_0.abs() };
        let size_c3_1 = if v23.abs() <= 0.0 { 1e-200 } else { c3_1.abs() };
        let size_c3_2 = if v25.abs() <= 0.0 { 1e-200 } else { c3_2.abs() };
        let size_c3_3 = if v26.abs() <= 0.0 { 1e-200 } else { c3_3.abs() };
        let size_c3_4 = if v27.abs() <= 0.0 { 1e-200 } else { c3_4.abs() };
        let size_c3_5 = if k4.abs() <= 0.0 { 1e-200 } else { c3_5.abs() };
        let size_c3_6 = if k3.abs() <= 0.0 { 1e-200 } else { c3_6.abs() };
        let size_c4_3 = if k5.abs() <= 0.0 { 1e-200 } else { c4_3.abs() };
        let size_c4_4 = if k4.abs() <= 0.0 { 1e-200 } else { c4_4.abs() };
        let size_c5_2 = if k5.abs() <= 0.0 { 1e-200 } else { c5_2.abs() };
        if !((v2 >= 1e-200)
            && (v3 >= 1e-200)
            && (size_K1 >= 1e-200)
            && (size_K2 >= 1e-200)
            && (v4 >= 1e-200)
            && (size_K3 >= 1e-200)
            && (size_K4 >= 1e-200)
            && (size_K5 >= 1e-200)
            && (v6 >= 1e-200)
            && (v7 >= 1e-200)
            && (size_c1_5 >= 1e-200)
            && (size_c2_0 >= 1e-200)
            && (size_c2_1 >= 1e-200)
            && (size_c2_2 >= 1e-200)
            && (size_c2_3 >= 1e-200)
            && (size_c2_4 >= 1e-200)
            && (size_c2_5 >= 1e-200)
            && (size_c2_6 >= 1e-200)
            && (size_c2_7 >= 1e-200)
            && (size_c2_8 >= 1e-200)
            && (v21 >= 1e-200)
            && (size_c3_0 >= 1e-200)
            && (size_c3_1 >= 1e-200)
            && (size_c3_2 >= 1e-200)
            && (size_c3_3 >= 1e-200)
            && (size_c3_4 >= 1e-200)
            && (size_c3_5 >= 1e-200)
            && (size_c3_6 >= 1e-200)
            && (size_c4_3 >= 1e-200)
            && (size_c4_4 >= 1e-200)
            && (size_c5_2 >= 1e-200)
            && c1_5.is_finite()
            && hold_from.is_finite()
            && two_tau.is_finite()
            && half_tau.is_finite()
            && c2_0.is_finite()
            && c2_1.is_finite()
            && c2_2.is_finite()
            && c2_3.is_finite()
            && c2_4.is_finite()
            && c2_5.is_finite()
            && c2_6.is_finite()
            && c2_7.is_finite()
            && c2_8.is_finite()
            && inv_tau.is_finite()
            && c3_0.is_finite()
            && c3_1.is_finite()
            && c3_2.is_finite()
            && c3_3.is_finite()
            && c3_4.is_finite()
            && c3_5.is_finite()
            && c3_6.is_finite()
            && c4_0.is_finite()
            && c4_3.is_finite()
            && c4_2.is_finite()
            && c4_4.is_finite()
            && c5_2.is_finite()
            && c5_1.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            tau,
            c1_5,
            eps,
            hold_from,
            two_tau,
            half_tau,
            c2_0,
            c2_1,
            c2_2,
            c2_3,
            c2_4,
            c2_5,
            c2_6,
            c2_7,
            c2_8,
            inv_tau,
            c3_0,
            c3_1,
            c3_2,
            c3_3,
            c3_4,
            c3_5,
            c3_6,
            c4_0,
            c4_3,
            c4_2,
            c4_4,
            c5_2,
            c5_1,
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
    pub fn step(&self, t: f64, x: &[f64; 5]) -> Result<Control<f64>, Error> {
        if !(t >= self.t0) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let s1 = self.half_tau / (self.two_tau + late);
        let one_plus_y2 = s1 - (self.half_tau / late);
        let v1 = one_plus_y2 * one_plus_y2;
        let row1 = self.c1_5 * one_plus_y2 * v1 * v1;
        let sec = math::sqrt(one_plus_y2);
        let y = (self.tau + late) * self.inv_tau * sec;
        let y_squared = one_plus_y2 - 1.0;
        let s2 = ((self.c2_8 * y_squared) + self.c2_6) * y_squared;
        let s3 = (((s2 + self.c2_4) * y_squared) + self.c2_2) * y_squared;
        let s4 = ((self.c2_7 * y_squared) + self.c2_5) * y_squared;
        let s5 = (((s4 + self.c2_3) * y_squared) + self.c2_1) * y;
        let row2 = s3 + self.c2_0 + s5;
        let s6 = ((self.c3_6 * y_squared) + self.c3_4) * y_squared;
        let s7 = ((self.c3_5 * y_squared) + self.c3_3) * y_squared;
        let s8 = ((s6 + self.c3_2) * y_squared) + self.c3_0;
        let row3 = s8 + ((s7 + self.c3_1) * y);
        let s9 = ((self.c4_4 * y_squared) + self.c4_2) * y_squared;
        let row4 = s9 + self.c4_0 + (((self.c4_3 * y_squared) + self.c4_3) * y);
        let row5 = (self.c5_2 * y_squared) + self.c5_2 + (self.c5_1 * y);
        let s10 = ((((row1 * x[0] * sec) + (row2 * x[1])) * sec) + (row3 * x[2])) * sec;
        let v = (((s10 + (row4 * x[3])) * sec) + (row5 * x[4])) * sec;
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if t.is_finite()
            && x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && x[3].is_finite()
            && x[4].is_finite()
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
    pub fn tick(&self, t: f64) -> Result<PtcAlgebraic5Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let s1 = self.half_tau / (self.two_tau + late);
        let one_plus_y2 = s1 - (self.half_tau / late);
        let v1 = one_plus_y2 * one_plus_y2;
        let row1 = self.c1_5 * one_plus_y2 * v1 * v1;
        let sec = math::sqrt(one_plus_y2);
        let y = (self.tau + late) * self.inv_tau * sec;
        let y_squared = one_plus_y2 - 1.0;
        let s2 = ((self.c2_8 * y_squared) + self.c2_6) * y_squared;
        let s3 = (((s2 + self.c2_4) * y_squared) + self.c2_2) * y_squared;
        let s4 = ((self.c2_7 * y_squared) + self.c2_5) * y_squared;
        let s5 = (((s4 + self.c2_3) * y_squared) + self.c2_1) * y;
        let row2 = s3 + self.c2_0 + s5;
        let s6 = ((self.c3_6 * y_squared) + self.c3_4) * y_squared;
        let s7 = ((self.c3_5 * y_squared) + self.c3_3) * y_squared;
        let s8 = ((s6 + self.c3_2) * y_squared) + self.c3_0;
        let row3 = s8 + ((s7 + self.c3_1) * y);
        let s9 = ((self.c4_4 * y_squared) + self.c4_2) * y_squared;
        let row4 = s9 + self.c4_0 + (((self.c4_3 * y_squared) + self.c4_3) * y);
        let row5 = (self.c5_2 * y_squared) + self.c5_2 + (self.c5_1 * y);
        let v2 = sec * sec;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcAlgebraic5Gains {
            gain: [
                row1 * (v2 * sec) * v2,
                row2 * v2 * v2,
                row3 * v2 * sec,
                row4 * sec * sec,
                row5 * sec,
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
impl PtcAlgebraic5Gains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 5]) -> Result<Control<f64>, Error> {
        let s1 = (self.gain[0] * x[0]) + (self.gain[1] * x[1]);
        let s2 = s1 + (self.gain[2] * x[2]) + (self.gain[3] * x[3]);
        let v = s2 + (self.gain[4] * x[4]);
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max) {
            (v, self.status)
        } else if x[0].is_finite()
            && x[1].is_finite()
            && x[2].is_finite()
            && x[3].is_finite()
            && x[4].is_finite()
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

impl Controller<5> for PtcAlgebraic5 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 5]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
