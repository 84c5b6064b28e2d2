//! Prescribed-time controller ptc_exp12_axes2: order n = 12, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 12 --axes 2 --mu exp --name ptc_exp12_axes2
//! Version 0.1.0, design 27250cbd8a20.
//!
//! Plant: x1' = x2, ..., x12' = f + u. Time in s, x1 in any unit U, x2 in U/s, ..., x12 in
//!       U/s^11, u in U/s^12.
//! Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
//!       eps, sampling, f and clipping leave. The checks below say what is known of this
//!       design.
//! f is not part of the law: cancel its known terms before the call.
//! Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
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
//!   k: gains of pi0 = -(k_1 xi_1 + ... + k_12 xi_12), finite; k[0] is k_1 [1/s^12], ...,
//!       k[11] is k_12 [1/s]
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*(1 - exp(-a*t))
//!   kappa(Dt) = -ln(T/tau)/a
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) a^k T
//!   r_1 = a*T
//!   r_2 = -a^2*T
//!   r_3 = a^3*T
//!   r_4 = -a^4*T
//!   r_5 = a^5*T
//!   r_6 = -a^6*T
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = a*T
//!   B_{2,1} = -a^2*T
//!   B_{2,2} = a^2*T^2
//!   B_{3,1} = a^3*T
//!   B_{3,2} = -3*a^3*T^2
//!   B_{3,3} = a^3*T^3
//!   B_{4,1} = -a^4*T
//!   B_{4,2} = 7*a^4*T^2
//!   B_{4,3} = -6*a^4*T^3
//!   B_{4,4} = a^4*T^4
//!   B_{5,1} = a^5*T
//!   B_{5,2} = -15*a^5*T^2
//!   B_{5,3} = 25*a^5*T^3
//!   B_{5,4} = -10*a^5*T^4
//!   B_{5,5} = a^5*T^5
//!   B_{6,1} = -a^6*T
//!   B_{6,2} = 31*a^6*T^2
//!   B_{6,3} = -90*a^6*T^3
//!   B_{6,4} = 65*a^6*T^4
//!   B_{6,5} = -15*a^6*T^5
//!   (to order 6; all of them: ptc-codegen show matrix --n 12 --mu exp)
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_12 xi_12)
//!   u = sum_j gain_j x_j
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = 1 - K2 + K3 - K4 + K5 - K6 + K7 - K8 + K9 - K10 + K11 - K12
//!   row_3 = -2047 - K3 + 3*K4 - 7*K5 + 15*K6 - 31*K7 + 63*K8 - 127*K9 + 255*K10 - 511*K11 +
//!       1023*K12
//!   row_4 = 86526 - K4 + 6*K5 - 25*K6 + 90*K7 - 301*K8 + 966*K9 - 3025*K10 + 9330*K11 -
//!       28501*K12
//!   row_5 = -611501 - K5 + 10*K6 - 65*K7 + 350*K8 - 1701*K9 + 7770*K10 - 34105*K11 +
//!       145750*K12
//!   row_6 = 1379400 - K6 + 15*K7 - 140*K8 + 1050*K9 - 6951*K10 + 42525*K11 - 246730*K12
//!   inv_T = 1/T
//!   (the first 6; all of them: ptc-codegen show law --n 12 --mu exp)
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
//! Operations of one step, without input checks and clipping: 25 additions or comparisons, 52
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

/// Result of a step of several axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f64> {
    /// Inputs of the plants; 0 where `status` is an error.
    pub u: [R; M],
    /// Status of each axis.
    pub axes: [Result<Status, Error>; M],
    /// The error of the first axis that fails; else `Saturated` where one is, else that of the gains.
    pub status: Result<Status, Error>,
}

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

/// Run-time parameters of [`PtcExp12Axes2`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp12Axes2Params {
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
    /// gains of pi0 = -(k_1 xi_1 + ... + k_12 xi_12), finite; k\[0\] is k_1 \[1/s^12\], ..., k\[11\] is k_12 \[1/s\].
    pub k: [f64; 12],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp12Axes2 {
    /// coefficient of x1.
    c1: f64,
    /// coefficient of x2.
    c2: f64,
    /// coefficient of x3.
    c3: f64,
    /// coefficient of x4.
    c4: f64,
    /// coefficient of x5.
    c5: f64,
    /// coefficient of x6.
    c6: f64,
    /// coefficient of x7.
    c7: f64,
    /// coefficient of x8.
    c8: f64,
    /// coefficient of x9.
    c9: f64,
    /// coefficient of x10.
    c10: f64,
    /// coefficient of x11.
    c11: f64,
    /// coefficient of x12.
    c12: f64,
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

/// Feedback gains of [`PtcExp12Axes2`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp12Axes2Gains {
    /// u = gain\[0\] x\[0\] + ... + gain\[11\] x\[11\].
    pub gain: [f64; 12],
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
impl PtcExp12Axes2 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcExp12Axes2Params) -> Result<Self, Error> {
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
        let k6 = params.k[5];
        let k7 = params.k[6];
        let k8 = params.k[7];
        let k9 = params.k[8];
        let k10 = params.k[9];
        let k11 = params.k[10];
        let k12 = params.k[11];
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
            && k6.is_finite()
            && k7.is_finite()
            && k8.is_finite()
            && k9.is_finite()
            && k10.is_finite()
            && k11.is_finite()
            && k12.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let v1 = a * a;
        let v2 = v1 * v1;
        let v3 = v2 * v2;
        let v4 = v2 * v3;
        let K1 = k1 / v4;
        let v5 = a * v1;
        let v6 = v5 * v3;
        let K2 = k2 / v6;
        let v7 = v1 * v3;
        let K3 = k3 / v7;
        let v8 = a * v3;
        let K4 = k4 / v8;
        let K5 = k5 / v3;
        let v9 = v5 * v2;
        let K6 = k6 / v9;
        let v10 = v1 * v2;
        let K7 = k7 / v10;
        let v11 = a * v2;
        let K8 = k8 / v11;
        let K9 = k9 / v2;
        let K10 = k10 / v5;
        let K11 = k11 / v1;
        let K12 = k12 / a;
        let c1 = -K1;
        let s1 = ((((((((((-K2) + K3) - K4) + K5) - K6) + K7) - K8) + K9) - K10) + K11) - K12;
        let c2 = s1 + 1.0;
        let s2 = ((((-K3) + (3.0 * K4)) - (7.0 * K5)) + (15.0 * K6)) - (31.0 * K7);
        let s3 = (((s2 + (63.0 * K8)) - (127.0 * K9)) + (255.0 * K10)) - (511.0 * K11);
        let c3 = (s3 + (1023.0 * K12)) - 2047.0;
        let s4 = ((((-K4) + (6.0 * K5)) - (25.0 * K6)) + (90.0 * K7)) - (301.0 * K8);
        let s5 = ((s4 + (966.0 * K9)) - (3025.0 * K10)) + (9330.0 * K11);
        let c4 = (s5 - (28501.0 * K12)) + 86526.0;
        let s6 = ((((-K5) + (10.0 * K6)) - (65.0 * K7)) + (350.0 * K8)) - (1701.0 * K9);
        let s7 = ((s6 + (7770.0 * K10)) - (34105.0 * K11)) + (145750.0 * K12);
        let c5 = s7 - 611501.0;
        let s8 = (((-K6) + (15.0 * K7)) - (140.0 * K8)) + (1050.0 * K9);
        let s9 = ((s8 - (6951.0 * K10)) + (42525.0 * K11)) - (246730.0 * K12);
        let c6 = s9 + 1379400.0;
        let s10 = (((-K7) + (21.0 * K8)) - (266.0 * K9)) + (2646.0 * K10);
        let c7 = ((s10 - (22827.0 * K11)) + (179487.0 * K12)) - 1323652.0;
        let s11 = (((-K8) + (28.0 * K9)) - (462.0 * K10)) + (5880.0 * K11);
        let c8 = (s11 - (63987.0 * K12)) + 627396.0;
        let s12 = (((-K9) + (36.0 * K10)) - (750.0 * K11)) + (11880.0 * K12);
        let c9 = s12 - 159027.0;
        let c10 = (((-K10) + (45.0 * K11)) - (1155.0 * K12)) + 22275.0;
        let c11 = ((-K11) + (55.0 * K12)) - 1705.0;
        let c12 = (-K12) + 66.0;
        let hold_from = -eps;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let size_K3 = if k3.abs() <= 0.0 { 1e-200 } else { K3.abs() };
        let size_K4 = if k4.abs() <= 0.0 { 1e-200 } else { K4.abs() };
        let size_K5 = if k5.abs() <= 0.0 { 1e-200 } else { K5.abs() };
        let size_K6 = if k6.abs() <= 0.0 { 1e-200 } else { K6.abs() };
        let size_K7 = if k7.abs() <= 0.0 { 1e-200 } else { K7.abs() };
        let size_K8 = if k8.abs() <= 0.0 { 1e-200 } else { K8.abs() };
        let size_K9 = if k9.abs() <= 0.0 { 1e-200 } else { K9.abs() };
        let size_K10 = if k10.abs() <= 0.0 { 1e-200 } else { K10.abs() };
        let size_K11 = if k11.abs() <= 0.0 { 1e-200 } else { K11.abs() };
        let size_K12 = if k12.abs() <= 0.0 { 1e-200 } else { K12.abs() };
        if !((v2 >= 1e-200)
            && (v3 >= 1e-200)
            && (v4 >= 1e-200)
            && (size_K1 >= 1e-200)
            && (v5 >= 1e-200)
            && (v6 >= 1e-200)
            && (size_K2 >= 1e-200)
            && (v7 >= 1e-200)
            && (size_K3 >= 1e-200)
            && (v8 >= 1e-200)
            && (size_K4 >= 1e-200)
            && (size_K5 >= 1e-200)
            && (v9 >= 1e-200)
            && (size_K6 >= 1e-200)
            && (v10 >= 1e-200)
            && (size_K7 >= 1e-200)
            && (v11 >= 1e-200)
            && (size_K8 >= 1e-200)
            && (size_K9 >= 1e-200)
            && (size_K10 >= 1e-200)
            && (size_K11 >= 1e-200)
            && (size_K12 >= 1e-200)
            && c1.is_finite()
            && c2.is_finite()
            && c3.is_finite()
            && c4.is_finite()
            && c5.is_finite()
            && c6.is_finite()
            && c7.is_finite()
            && c8.is_finite()
            && c9.is_finite()
            && c10.is_finite()
            && c11.is_finite()
            && c12.is_finite()
            && hold_from.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            c1,
            c2,
            c3,
            c4,
            c5,
            c6,
            c7,
            c8,
            c9,
            c10,
            c11,
            c12,
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

    /// The gains at time t \[s\] for all axes, from which step computes u of each.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn tick(&self, t: f64) -> Result<PtcExp12Axes2Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let inv_T = (-1.0) / late;
        let v1 = inv_T * inv_T;
        let v2 = v1 * inv_T;
        let v3 = v2 * inv_T;
        let v4 = v3 * inv_T;
        let v5 = v4 * inv_T;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcExp12Axes2Gains {
            gain: [
                self.c1 * v5 * v5,
                self.c2 * v5 * v4,
                self.c3 * v4 * v4,
                self.c4 * v4 * v3,
                self.c5 * v3 * v3,
                self.c6 * v3 * v2,
                self.c7 * v2 * v2,
                self.c8 * v2 * v1,
                self.c9 * v1 * v1,
                self.c10 * v1 * inv_T,
                self.c11 * inv_T * inv_T,
                self.c12 * inv_T,
            ],
            u_max: self.u_max,
            status,
        })
    }

    /// u of 2 axes at time t \[s\], from the state x = (x1, x1', ...) of each. Its status is that
    /// of the first axis that fails, and then every u is 0; else SATURATED where an axis is.
    #[inline]
    pub fn step(&self, t: f64, x: &[[f64; 12]; 2]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        if !(t.is_finite() && (t >= self.t0)) {
            return failed(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let inv_T = (-1.0) / late;
        let v1 = inv_T * inv_T;
        let v2 = v1 * inv_T;
        let v3 = v2 * inv_T;
        let v4 = v3 * inv_T;
        let v5 = v4 * inv_T;
        let mut gain = [0.0; 12];
        gain[0] = self.c1 * v5 * v5;
        gain[1] = self.c2 * v5 * v4;
        gain[2] = self.c3 * v4 * v4;
        gain[3] = self.c4 * v4 * v3;
        gain[4] = self.c5 * v3 * v3;
        gain[5] = self.c6 * v3 * v2;
        gain[6] = self.c7 * v2 * v2;
        gain[7] = self.c8 * v2 * v1;
        gain[8] = self.c9 * v1 * v1;
        gain[9] = self.c10 * v1 * inv_T;
        gain[10] = self.c11 * inv_T * inv_T;
        gain[11] = self.c12 * inv_T;
        if late < self.hold_from {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        let mut part = [0.0; 8];
        for axis in 0..2 {
            let s1 = (gain[0] * x[axis][0]) + (gain[4] * x[axis][4]);
            part[4 * axis] = s1 + (gain[8] * x[axis][8]);
            let s2 = (gain[1] * x[axis][1]) + (gain[5] * x[axis][5]);
            part[(4 * axis) + 1] = s2 + (gain[9] * x[axis][9]);
            let s3 = (gain[2] * x[axis][2]) + (gain[6] * x[axis][6]);
            part[(4 * axis) + 2] = s3 + (gain[10] * x[axis][10]);
            let s4 = (gain[3] * x[axis][3]) + (gain[7] * x[axis][7]);
            part[(4 * axis) + 3] = s4 + (gain[11] * x[axis][11]);
        }
        let mut half = [0.0; 4];
        for axis in 0..2 {
            half[2 * axis] = part[4 * axis] + part[(4 * axis) + 2];
            half[(2 * axis) + 1] = part[(4 * axis) + 1] + part[(4 * axis) + 3];
        }
        let mut wanted = [0.0; 2];
        for axis in 0..2 {
            wanted[axis] = half[2 * axis] + half[(2 * axis) + 1];
        }
        let bound = if self.u_max < 1.7976931348623157e308 {
            self.u_max
        } else {
            1.7976931348623157e308
        };
        u[0] = wanted[0];
        u[1] = wanted[1];
        for axis in 0..2 {
            axes[axis] = status;
        }
        let mut outside = 0_u32;
        for axis in 0..2 {
            let v = wanted[axis];
            if !(v.abs() <= bound) {
                outside = 1;
                break;
            }
        }
        if outside == 1 {
            for axis in 0..2 {
                let v = wanted[axis];
                if !(v.abs() <= bound) {
                    if x[axis][0].is_finite()
                        && x[axis][1].is_finite()
                        && x[axis][2].is_finite()
                        && x[axis][3].is_finite()
                        && x[axis][4].is_finite()
                        && x[axis][5].is_finite()
                        && x[axis][6].is_finite()
                        && x[axis][7].is_finite()
                        && x[axis][8].is_finite()
                        && x[axis][9].is_finite()
                        && x[axis][10].is_finite()
                        && x[axis][11].is_finite()
                    {
                        if v.is_finite() {
                            if v > self.u_max {
                                u[axis] = self.u_max;
                                axes[axis] = Ok(Status::Saturated);
                            } else {
                                u[axis] = -self.u_max;
                                axes[axis] = Ok(Status::Saturated);
                            }
                        } else {
                            axes[axis] = Err(Error::Range);
                        }
                    } else {
                        axes[axis] = Err(Error::Input);
                    }
                    if status.is_ok() {
                        status = axes[axis];
                    }
                }
            }
            if status.is_err() {
                for axis in 0..2 {
                    u[axis] = 0.0;
                }
            }
        }
        Axes { u, axes, status }
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
impl PtcExp12Axes2Gains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 12]) -> Result<Control<f64>, Error> {
        let s1 = (self.gain[0] * x[0]) + (self.gain[4] * x[4]);
        let s2 = (self.gain[2] * x[2]) + (self.gain[6] * x[6]);
        let s3 = (self.gain[1] * x[1]) + (self.gain[5] * x[5]);
        let s4 = (self.gain[3] * x[3]) + (self.gain[7] * x[7]);
        let s5 = s1 + (self.gain[8] * x[8]) + (s2 + (self.gain[10] * x[10]));
        let v = s5 + (s3 + (self.gain[9] * x[9]) + (s4 + (self.gain[11] * x[11])));
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
            && x[9].is_finite()
            && x[10].is_finite()
            && x[11].is_finite()
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
