//! Prescribed-time controller ptc_tanh5: order n = 5, mapping tanh.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 5 --mu tanh
//! Version 0.1.0, design 47e304f2d81a.
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
//!   mu(t)     = tau*tanh(a*t)
//!   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
//!   in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
//!   r_1 = 2*a*T*L
//!   r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
//!   r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
//!   r_4 = 176*a^4*T*E*L^4 - 176*a^4*T*E^2*L^4 + 16*a^4*T*E^3*L^4 - 16*a^4*T*L^4
//!   r_5 = -832*a^5*T*E*L^5 + 2112*a^5*T*E^2*L^5 - 832*a^5*T*E^3*L^5 + 32*a^5*T*E^4*L^5 +
//!       32*a^5*T*L^5
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*a*T*L
//!   B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
//!   B_{2,2} = 4*a^2*T^2*L^2
//!   B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
//!   B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3
//!   B_{3,3} = 8*a^3*T^3*L^3
//!   B_{4,1} = 176*a^4*T*E*L^4 - 176*a^4*T*E^2*L^4 + 16*a^4*T*E^3*L^4 - 16*a^4*T*L^4
//!   B_{4,2} = -352*a^4*T^2*E*L^4 + 112*a^4*T^2*E^2*L^4 + 112*a^4*T^2*L^4
//!   B_{4,3} = 96*a^4*T^3*E*L^4 - 96*a^4*T^3*L^4
//!   B_{4,4} = 16*a^4*T^4*L^4
//!   B_{5,1} = -832*a^5*T*E*L^5 + 2112*a^5*T*E^2*L^5 - 832*a^5*T*E^3*L^5 + 32*a^5*T*E^4*L^5 +
//!       32*a^5*T*L^5
//!   B_{5,2} = 3360*a^5*T^2*E*L^5 - 3360*a^5*T^2*E^2*L^5 + 480*a^5*T^2*E^3*L^5 -
//!       480*a^5*T^2*L^5
//!   B_{5,3} = -2240*a^5*T^3*E*L^5 + 800*a^5*T^3*E^2*L^5 + 800*a^5*T^3*L^5
//!   B_{5,4} = 320*a^5*T^4*E*L^5 - 320*a^5*T^4*L^5
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_5 xi_5)
//!   u = sum_j gain_j x_j
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/(2*a)^(n+1-i)
//!   row_1 = -K1*one_plus_E^5
//!   row_2 = -1 - K2 - 4*K2*E - 6*K2*E^2 - 4*K2*E^3 - K2*E^4 + K3 + 2*K3*E - 2*K3*E^3 - K3*E^4
//!       - K4 + 2*K4*E + 6*K4*E^2 + 2*K4*E^3 - K4*E^4 + K5 - 10*K5*E + 10*K5*E^3 - K5*E^4 +
//!       26*E - 66*E^2 + 26*E^3 - E^4
//!   row_3 = 15 - K3 - 3*K3*E - 3*K3*E^2 - K3*E^3 + 3*K4 + 3*K4*E - 3*K4*E^2 - 3*K4*E^3 - 7*K5
//!       + 15*K5*E + 15*K5*E^2 - 7*K5*E^3 - 105*E + 105*E^2 - 15*E^3
//!   row_4 = -25 - K4 - 2*K4*E - K4*E^2 + 6*K5 - 6*K5*E^2 + 70*E - 25*E^2
//!   row_5 = 10 - K5 - K5*E - 10*E
//!   inv_T = 1/T
//!   one_plus_E = 1 + E
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: tanh is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 19 additions or comparisons, 24
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

/// Run-time parameters of [`PtcTanh5`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh5Params {
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
pub struct PtcTanh5 {
    /// coefficient of one_plus_E^5 in the gain of x1.
    c1_5: f64,
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
    /// -2*tau.
    minus_two_tau: f64,
    /// coefficient of E^0 in the gain of x2.
    c2_0: f64,
    /// coefficient of E^1 in the gain of x2.
    c2_1: f64,
    /// coefficient of E^2 in the gain of x2.
    c2_2: f64,
    /// coefficient of E^3 in the gain of x2.
    c2_3: f64,
    /// coefficient of E^4 in the gain of x2.
    c2_4: f64,
    /// coefficient of E^0 in the gain of x3.
    c3_0: f64,
    /// coefficient of E^1 in the gain of x3.
    c3_1: f64,
    /// coefficient of E^2 in the gain of x3.
    c3_2: f64,
    /// coefficient of E^3 in the gain of x3.
    c3_3: f64,
    /// coefficient of E^0 in the gain of x4.
    c4_0: f64,
    /// coefficient of E^1 in the gain of x4.
    c4_1: f64,
    /// coefficient of E^2 in the gain of x4.
    c4_2: f64,
    /// coefficient of E^0 in the gain of x5.
    c5_0: f64,
    /// coefficient of E^1 in the gain of x5.
    c5_1: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcTanh5`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh5Gains {
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
impl PtcTanh5 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcTanh5Params) -> Result<Self, Error> {
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
        let rate = 2.0 * a;
        let v1 = rate * rate;
        let v2 = v1 * v1;
        let v3 = rate * v2;
        let K1 = k1 / v3;
        let K2 = k2 / v2;
        let v4 = rate * v1;
        let K3 = k3 / v4;
        let K4 = k4 / v1;
        let K5 = k5 / rate;
        let c1_5 = -K1;
        let hold_from = -eps;
        let two_tau = 2.0 * tau;
        let minus_two_tau = -two_tau;
        let v5 = -K2;
        let c2_0 = (((v5 + K3) - K4) + K5) - 1.0;
        let v6 = -(4.0 * K2);
        let v7 = 2.0 * K3;
        let v8 = 2.0 * K4;
        let v9 = 10.0 * K5;
        let c2_1 = ((v6 + v7 + v8) - v9) + 26.0;
        let c2_2 = ((-(6.0 * K2)) + (6.0 * K4)) - 66.0;
        let c2_3 = (v6 - v7) + v8 + v9 + 26.0;
        let c2_4 = (((v5 - K3) - K4) - K5) - 1.0;
        let v10 = -K3;
        let v11 = 3.0 * K4;
        let v12 = 7.0 * K5;
        let c3_0 = ((v10 + v11) - v12) + 15.0;
        let v13 = -(3.0 * K3);
        let v14 = 15.0 * K5;
        let c3_1 = (v13 + v11 + v14) - 105.0;
        let c3_2 = (v13 - v11) + v14 + 105.0;
        let c3_3 = ((v10 - v11) - v12) - 15.0;
        let v15 = -K4;
        let v16 = 6.0 * K5;
        let c4_0 = (v15 + v16) - 25.0;
        let c4_1 = (-v8) + 70.0;
        let c4_2 = (v15 - v16) - 25.0;
        let v17 = -K5;
        let c5_0 = v17 + 10.0;
        let c5_1 = v17 - 10.0;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let size_K3 = if k3.abs() <= 0.0 { 1e-200 } else { K3.abs() };
        let size_K4 = if k4.abs() <= 0.0 { 1e-200 } else { K4.abs() };
        let size_K5 = if k5.abs() <= 0.0 { 1e-200 } else { K5.abs() };
        if !((v2 >= 1e-200)
            && (v3 >= 1e-200)
            && (size_K1 >= 1e-200)
            && (size_K2 >= 1e-200)
            && (v4 >= 1e-200)
            && (size_K3 >= 1e-200)
            && (size_K4 >= 1e-200)
            && (size_K5 >= 1e-200)
            && c1_5.is_finite()
            && hold_from.is_finite()
            && minus_two_tau.is_finite()
            && c2_0.is_finite()
            && c2_1.is_finite()
            && c2_2.is_finite()
            && c2_3.is_finite()
            && c2_4.is_finite()
            && c3_0.is_finite()
            && c3_1.is_finite()
            && c3_2.is_finite()
            && c3_3.is_finite()
            && c4_0.is_finite()
            && c4_1.is_finite()
            && c4_2.is_finite()
            && c5_0.is_finite()
            && c5_1.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            c1_5,
            tau,
            eps,
            hold_from,
            minus_two_tau,
            c2_0,
            c2_1,
            c2_2,
            c2_3,
            c2_4,
            c3_0,
            c3_1,
            c3_2,
            c3_3,
            c4_0,
            c4_1,
            c4_2,
            c5_0,
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
        let E = late / (self.minus_two_tau - late);
        let one_plus_E = 1.0 + E;
        let v1 = one_plus_E * one_plus_E;
        let row1 = self.c1_5 * one_plus_E * v1 * v1;
        let s1 = ((((self.c2_4 * E) + self.c2_3) * E) + self.c2_2) * E;
        let row2 = ((s1 + self.c2_1) * E) + self.c2_0;
        let s2 = ((((self.c3_3 * E) + self.c3_2) * E) + self.c3_1) * E;
        let row3 = s2 + self.c3_0;
        let row4 = (((self.c4_2 * E) + self.c4_1) * E) + self.c4_0;
        let row5 = (self.c5_1 * E) + self.c5_0;
        let inv_T = (-1.0) / late;
        let s3 = (((row1 * x[0] * inv_T) + (row2 * x[1])) * inv_T) + (row3 * x[2]);
        let v = ((((s3 * inv_T) + (row4 * x[3])) * inv_T) + (row5 * x[4])) * inv_T;
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
    pub fn tick(&self, t: f64) -> Result<PtcTanh5Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let E = late / (self.minus_two_tau - late);
        let one_plus_E = 1.0 + E;
        let v1 = one_plus_E * one_plus_E;
        let row1 = self.c1_5 * one_plus_E * v1 * v1;
        let s1 = ((((self.c2_4 * E) + self.c2_3) * E) + self.c2_2) * E;
        let row2 = ((s1 + self.c2_1) * E) + self.c2_0;
        let s2 = ((((self.c3_3 * E) + self.c3_2) * E) + self.c3_1) * E;
        let row3 = s2 + self.c3_0;
        let row4 = (((self.c4_2 * E) + self.c4_1) * E) + self.c4_0;
        let row5 = (self.c5_1 * E) + self.c5_0;
        let inv_T = (-1.0) / late;
        let v2 = inv_T * inv_T;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcTanh5Gains {
            gain: [
                row1 * (v2 * inv_T) * v2,
                row2 * v2 * v2,
                row3 * v2 * inv_T,
                row4 * inv_T * inv_T,
                row5 * inv_T,
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
impl PtcTanh5Gains {
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

impl Controller<5> for PtcTanh5 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 5]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
