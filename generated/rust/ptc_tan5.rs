//! Prescribed-time controller ptc_tan5: order n = 5, mapping tan.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 5 --mu tan
//! Version 0.1.0, design b3d0266958f3.
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
//!   mu(t)     = (2*tau/pi)*atan(a*t)
//!   kappa(Dt) = cot(th)/a, th = pi*T/(2*tau)
//!   in terms of y = cot(th), V = 1/(1 + y^2)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k
//!   r_1 = 2*pi^-1*tau*a*V
//!   r_2 = -4*pi^-1*tau*a^2*y*V^2
//!   r_3 = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
//!   r_4 = 48*pi^-1*tau*a^4*y*V^4 - 48*pi^-1*tau*a^4*y^3*V^4
//!   r_5 = -480*pi^-1*tau*a^5*y^2*V^5 + 240*pi^-1*tau*a^5*y^4*V^5 + 48*pi^-1*tau*a^5*V^5
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*pi^-1*tau*a*V
//!   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
//!   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
//!   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
//!   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
//!   B_{3,3} = 8*pi^-3*tau^3*a^3*V^3
//!   B_{4,1} = 48*pi^-1*tau*a^4*y*V^4 - 48*pi^-1*tau*a^4*y^3*V^4
//!   B_{4,2} = 144*pi^-2*tau^2*a^4*y^2*V^4 - 32*pi^-2*tau^2*a^4*V^4
//!   B_{4,3} = -96*pi^-3*tau^3*a^4*y*V^4
//!   B_{4,4} = 16*pi^-4*tau^4*a^4*V^4
//!   B_{5,1} = -480*pi^-1*tau*a^5*y^2*V^5 + 240*pi^-1*tau*a^5*y^4*V^5 + 48*pi^-1*tau*a^5*V^5
//!   B_{5,2} = 640*pi^-2*tau^2*a^5*y*V^5 - 960*pi^-2*tau^2*a^5*y^3*V^5
//!   B_{5,3} = 960*pi^-3*tau^3*a^5*y^2*V^5 - 160*pi^-3*tau^3*a^5*V^5
//!   B_{5,4} = -320*pi^-4*tau^4*a^5*y*V^5
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_5 xi_5)
//!   u = sum_j gain_j x_j
//!   gain_j = row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1*slope^5
//!   row_2 = -16*pi^-4*tau^4*K2*cot_rate^8 + 16*pi^-3*tau^3*K3*cot_rate^7 -
//!       16*pi^-2*tau^2*K2*cot_rate^6 - 24*pi^-2*tau^2*K4*cot_rate^6 +
//!       12*pi^-1*tau*K3*cot_rate^5 + 48*pi^-1*tau*K5*cot_rate^5 + 3*pi*tau^-1*K3*cot_rate^3 -
//!       pi^2*tau^-2*K2*cot_rate^2 - 1/2*pi^2*tau^-2*K4*cot_rate^2 + 60*pi^2*tau^-2*cot_rate^2
//!       + 1/4*pi^3*tau^-3*K3*cot_rate - 3*pi^3*tau^-3*K5*cot_rate - 3/2*pi^4*tau^-4 -
//!       1/16*pi^4*tau^-4*K2 + 1/8*pi^4*tau^-4*K4 - 6*K2*cot_rate^4 - 10*K4*cot_rate^4 -
//!       120*cot_rate^4
//!   row_3 = -8*pi^-3*tau^3*K3*cot_rate^6 + 24*pi^-2*tau^2*K4*cot_rate^5 -
//!       6*pi^-1*tau*K3*cot_rate^4 - 72*pi^-1*tau*K5*cot_rate^4 - 3/2*pi*tau^-1*K3*cot_rate^2
//!       - 14*pi*tau^-1*K5*cot_rate^2 + 3/2*pi^2*tau^-2*K4*cot_rate - 40*pi^2*tau^-2*cot_rate
//!       - 1/8*pi^3*tau^-3*K3 + pi^3*tau^-3*K5 + 12*K4*cot_rate^3 + 240*cot_rate^3
//!   row_4 = -4*pi^-2*tau^2*K4*cot_rate^4 + 24*pi^-1*tau*K5*cot_rate^3 +
//!       6*pi*tau^-1*K5*cot_rate + 5*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K4 - 2*K4*cot_rate^2 -
//!       120*cot_rate^2
//!   row_5 = -2*pi^-1*tau*K5*cot_rate^2 - 1/2*pi*tau^-1*K5 + 20*cot_rate
//!   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
//!   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: tan is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 44 additions or comparisons, 52
//!       multiplications, 1 division.
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

/// Run-time parameters of [`PtcTan5`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTan5Params {
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
pub struct PtcTan5 {
    /// coefficient of slope^5 in the gain of x1.
    c1_5: f64,
    /// prescribed settling time.
    tau: f64,
    /// pi/(2*tau).
    angle_rate: f64,
    /// 2*tau/pi.
    inv_angle_rate: f64,
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
    /// 1/tau.
    inv_tau: f64,
    /// coefficient of cot_rate^0 in the gain of x2.
    c2_0: f64,
    /// coefficient of cot_rate^1 in the gain of x2.
    c2_1: f64,
    /// coefficient of cot_rate^2 in the gain of x2.
    c2_2: f64,
    /// coefficient of cot_rate^3 in the gain of x2.
    c2_3: f64,
    /// coefficient of cot_rate^4 in the gain of x2.
    c2_4: f64,
    /// coefficient of cot_rate^5 in the gain of x2.
    c2_5: f64,
    /// coefficient of cot_rate^6 in the gain of x2.
    c2_6: f64,
    /// coefficient of cot_rate^7 in the gain of x2.
    c2_7: f64,
    /// coefficient of cot_rate^8 in the gain of x2.
    c2_8: f64,
    /// coefficient of cot_rate^0 in the gain of x3.
    c3_0: f64,
    /// coefficient of cot_rate^1 in the gain of x3.
    c3_1: f64,
    /// coefficient of cot_rate^2 in the gain of x3.
    c3_2: f64,
    /// coefficient of cot_rate^3 in the gain of x3.
    c3_3: f64,
    /// coefficient of cot_rate^4 in the gain of x3.
    c3_4: f64,
    /// coefficient of cot_rate^5 in the gain of x3.
    c3_5: f64,
    /// coefficient of cot_rate^6 in the gain of x3.
    c3_6: f64,
    /// coefficient of cot_rate^0 in the gain of x4.
    c4_0: f64,
    /// coefficient of cot_rate^1 in the gain of x4.
    c4_1: f64,
    /// coefficient of cot_rate^2 in the gain of x4.
    c4_2: f64,
    /// coefficient of cot_rate^3 in the gain of x4.
    c4_3: f64,
    /// coefficient of cot_rate^4 in the gain of x4.
    c4_4: f64,
    /// coefficient of cot_rate^0 in the gain of x5.
    c5_0: f64,
    /// coefficient of cot_rate^2 in the gain of x5.
    c5_2: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcTan5`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTan5Gains {
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
impl PtcTan5 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcTan5Params) -> Result<Self, Error> {
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
        let c1_5 = -K1;
        let angle_rate = 1.5707963267948966 / tau;
        let inv_angle_rate = 0.6366197723675814 * tau;
        let hold_from = -eps;
        let inv_tau = 1.0 / tau;
        let s1 = (-(6.088068189625153 * K2)) + (12.176136379250305 * K4);
        let v5 = s1 - 146.11363655100365;
        let v6 = tau * tau;
        let v7 = v6 * v6;
        let c2_0 = v5 / v7;
        let v8 = (7.751569170074955 * K3) - (93.01883004089946 * K5);
        let v9 = tau * v6;
        let c2_1 = v8 / v9;
        let s2 = (-(9.869604401089358 * K2)) - (4.934802200544679 * K4);
        let c2_2 = (s2 + 592.1762640653615) / v6;
        let c2_3 = (9.42477796076938 * K3) / tau;
        let c2_4 = ((-(6.0 * K2)) - (10.0 * K4)) - 120.0;
        let v10 = (3.819718634205488 * K3) + (15.278874536821952 * K5);
        let c2_5 = v10 * tau;
        let v11 = 2.4317084074161066 * K4;
        let v12 = (-(1.6211389382774044 * K2)) - v11;
        let c2_6 = v12 * v6;
        let c2_7 = 0.5160245509311918 * K3 * v9;
        let c2_8 = (-(0.16425571607494938 * K2)) * v7;
        let v13 = (-(3.8757845850374775 * K3)) + (31.00627668029982 * K5);
        let c3_0 = v13 / v9;
        let c3_1 = ((14.804406601634039 * K4) - 394.78417604357435) / v6;
        let v14 = (-(4.71238898038469 * K3)) - (43.982297150257104 * K5);
        let c3_2 = v14 / tau;
        let c3_3 = (12.0 * K4) + 240.0;
        let v15 = (-(1.909859317102744 * K3)) - (22.91831180523293 * K5);
        let c3_4 = v15 * tau;
        let c3_5 = v11 * v6;
        let c3_6 = (-(0.2580122754655959 * K3)) * v9;
        let c4_0 = ((-(2.4674011002723395 * K4)) + 49.34802200544679) / v6;
        let c4_1 = (18.84955592153876 * K5) / tau;
        let c4_2 = (-(2.0 * K4)) - 120.0;
        let c4_3 = 7.639437268410976 * K5 * tau;
        let c4_4 = (-(0.4052847345693511 * K4)) * v6;
        let c5_0 = (-(1.5707963267948966 * K5)) / tau;
        let c5_2 = (-(0.6366197723675814 * K5)) * tau;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let size_K3 = if k3.abs() <= 0.0 { 1e-200 } else { K3.abs() };
        let size_K4 = if k4.abs() <= 0.0 { 1e-200 } else { K4.abs() };
        let size_K5 = if k5.abs() <= 0.0 { 1e-200 } else { K5.abs() };
        let size_c2_0 = if v5.abs() <= 0.0 { 1e-200 } else { c2_0.abs() };
        let size_c2_1 = if v8.abs() <= 0.0 { 1e-200 } else { c2_1.abs() };
        let size_c2_3 = if k3.abs() <= 0.0 { 1e-200 } else { c2_3.abs() };
        let size_c2_5 = if v10.abs() <= 0.0 { 1e-200 } else { c2_5.abs() };
        let size_c2_6 = if v12.abs() <= 0.0 { 1e-200 } else { c2_6.abs() };
        let size_c2_7 = if k3.abs() <= 0.0 { 1e-200 } else { c2_7.abs() };
        let size_c2_8 = if k2.abs() <= 0.0 { 1e-200 } else { c2_8.abs() };
        let size_c3_0 = if v13.abs() <= 0.0 { 1e-200 } else { c3_0.abs() };
        let size_c3_2 = if v14.abs() <= 0.0 { 1e-200 } else { c3_2.abs() };
        let size_c3_4 = if v15.abs() <= 0.0 { 1e-200 } else { c3_4.abs() };
        let size_c3_5 = if k4.abs() <= 0.0 { 1e-200 } else { c3_5.abs() };
        let size_c3_6 = if k3.abs() <= 0.0 { 1e-200 } else { c3_6.abs() };
        let size_c4_1 = if k5.abs() <= 0.0 { 1e-200 } else { c4_1.abs() };
        let size_c4_3 = if k5.abs() <= 0.0 { 1e-200 } else { c4_3.abs() };
        let size_c4_4 = if k4.abs() <= 0.0 { 1e-200 } else { c4_4.abs() };
        let size_c5_0 = if k5.abs() <= 0.0 { 1e-200 } else { c5_0.abs() };
        let size_c5_2 = if k5.abs() <= 0.0 { 1e-200 } else { c5_2.abs() };
        if !((v2 >= 1e-200)
            && (v3 >= 1e-200)
            && (size_K1 >= 1e-200)
            && (size_K2 >= 1e-200)
            && (v4 >= 1e-200)
            && (size_K3 >= 1e-200)
            && (size_K4 >= 1e-200)
            && (size_K5 >= 1e-200)
            && (v7 >= 1e-200)
            && (size_c2_0 >= 1e-200)
            && (v9 >= 1e-200)
            && (size_c2_1 >= 1e-200)
            && (size_c2_3 >= 1e-200)
            && (size_c2_5 >= 1e-200)
            && (size_c2_6 >= 1e-200)
            && (size_c2_7 >= 1e-200)
            && (size_c2_8 >= 1e-200)
            && (size_c3_0 >= 1e-200)
            && (size_c3_2 >= 1e-200)
            && (size_c3_4 >= 1e-200)
            && (size_c3_5 >= 1e-200)
            && (size_c3_6 >= 1e-200)
            && (size_c4_1 >= 1e-200)
            && (size_c4_3 >= 1e-200)
            && (size_c4_4 >= 1e-200)
            && (size_c5_0 >= 1e-200)
            && (size_c5_2 >= 1e-200)
            && c1_5.is_finite()
            && angle_rate.is_finite()
            && inv_angle_rate.is_finite()
            && hold_from.is_finite()
            && inv_tau.is_finite()
            && c2_0.is_finite()
            && c2_1.is_finite()
            && c2_2.is_finite()
            && c2_3.is_finite()
            && c2_4.is_finite()
            && c2_5.is_finite()
            && c2_6.is_finite()
            && c2_7.is_finite()
            && c2_8.is_finite()
            && c3_0.is_finite()
            && c3_1.is_finite()
            && c3_2.is_finite()
            && c3_3.is_finite()
            && c3_4.is_finite()
            && c3_5.is_finite()
            && c3_6.is_finite()
            && c4_0.is_finite()
            && c4_1.is_finite()
            && c4_2.is_finite()
            && c4_3.is_finite()
            && c4_4.is_finite()
            && c5_0.is_finite()
            && c5_2.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            c1_5,
            tau,
            angle_rate,
            inv_angle_rate,
            eps,
            hold_from,
            inv_tau,
            c2_0,
            c2_1,
            c2_2,
            c2_3,
            c2_4,
            c2_5,
            c2_6,
            c2_7,
            c2_8,
            c3_0,
            c3_1,
            c3_2,
            c3_3,
            c3_4,
            c3_5,
            c3_6,
            c4_0,
            c4_1,
            c4_2,
            c4_3,
            c4_4,
            c5_0,
            c5_2,
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
        let v1 = late * self.inv_tau;
        let inv_T_squared = 1.0 / (late * late);
        let v2 = v1 * v1;
        let s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
        let s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
        let s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
        let s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
        let s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
        let s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
        let s7 = ((s6 * v2) - 0.001955067633906801) * v2;
        let s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
        let s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
        let th_cot_th = (s9 * v2) + 1.0;
        let cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        let slope = self.angle_rate + (self.inv_angle_rate * cot_rate_squared);
        let v3 = slope * slope;
        let row1 = self.c1_5 * slope * v3 * v3;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let s10 = (self.c2_8 * cot_rate_squared) + self.c2_6;
        let s11 = ((s10 * cot_rate_squared) + self.c2_4) * cot_rate_squared;
        let s12 = (self.c2_7 * cot_rate_squared) + self.c2_5;
        let s13 = ((s12 * cot_rate_squared) + self.c2_3) * cot_rate_squared;
        let s14 = ((s11 + self.c2_2) * cot_rate_squared) + self.c2_0;
        let row2 = s14 + ((s13 + self.c2_1) * cot_rate);
        let s15 = (self.c3_6 * cot_rate_squared) + self.c3_4;
        let s16 = ((s15 * cot_rate_squared) + self.c3_2) * cot_rate_squared;
        let s17 = (self.c3_5 * cot_rate_squared) + self.c3_3;
        let s18 = ((s17 * cot_rate_squared) + self.c3_1) * cot_rate;
        let row3 = s16 + self.c3_0 + s18;
        let s19 = (self.c4_4 * cot_rate_squared) + self.c4_2;
        let s20 = ((self.c4_3 * cot_rate_squared) + self.c4_1) * cot_rate;
        let row4 = (s19 * cot_rate_squared) + self.c4_0 + s20;
        let s21 = (self.c5_2 * cot_rate_squared) + self.c5_0;
        let row5 = s21 + (20.0 * cot_rate);
        let s22 = (row1 * x[0]) + (row2 * x[1]) + (row3 * x[2]) + (row4 * x[3]);
        let v = s22 + (row5 * x[4]);
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
    pub fn tick(&self, t: f64) -> Result<PtcTan5Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let v1 = late * self.inv_tau;
        let inv_T_squared = 1.0 / (late * late);
        let v2 = v1 * v1;
        let s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
        let s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
        let s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
        let s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
        let s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
        let s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
        let s7 = ((s6 * v2) - 0.001955067633906801) * v2;
        let s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
        let s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
        let th_cot_th = (s9 * v2) + 1.0;
        let cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        let slope = self.angle_rate + (self.inv_angle_rate * cot_rate_squared);
        let v3 = slope * slope;
        let row1 = self.c1_5 * slope * v3 * v3;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let s10 = (self.c2_8 * cot_rate_squared) + self.c2_6;
        let s11 = ((s10 * cot_rate_squared) + self.c2_4) * cot_rate_squared;
        let s12 = (self.c2_7 * cot_rate_squared) + self.c2_5;
        let s13 = ((s12 * cot_rate_squared) + self.c2_3) * cot_rate_squared;
        let s14 = ((s11 + self.c2_2) * cot_rate_squared) + self.c2_0;
        let row2 = s14 + ((s13 + self.c2_1) * cot_rate);
        let s15 = (self.c3_6 * cot_rate_squared) + self.c3_4;
        let s16 = ((s15 * cot_rate_squared) + self.c3_2) * cot_rate_squared;
        let s17 = (self.c3_5 * cot_rate_squared) + self.c3_3;
        let s18 = ((s17 * cot_rate_squared) + self.c3_1) * cot_rate;
        let row3 = s16 + self.c3_0 + s18;
        let s19 = (self.c4_4 * cot_rate_squared) + self.c4_2;
        let s20 = ((self.c4_3 * cot_rate_squared) + self.c4_1) * cot_rate;
        let row4 = (s19 * cot_rate_squared) + self.c4_0 + s20;
        let s21 = (self.c5_2 * cot_rate_squared) + self.c5_0;
        let row5 = s21 + (20.0 * cot_rate);
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcTan5Gains {
            gain: [row1, row2, row3, row4, row5],
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
impl PtcTan5Gains {
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

impl Controller<5> for PtcTan5 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 5]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
