//! Prescribed-time controller ptc_tan2_in_flight: order n = 2, mapping tan.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu tan --name ptc_tan2_in_flight --in-flight
//! Version 0.1.0, design 4686ad8cbd17.
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
//!   a: rate of stretched time [1/s], from 1e-150 to 1e150
//!   k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]
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
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*pi^-1*tau*a*V
//!   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   u = sum_j gain_j x_j
//!   gain_j = row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1*slope^2
//!   row_2 = -2*pi^-1*tau*K2*cot_rate^2 - 1/2*pi*tau^-1*K2 + 2*cot_rate
//!   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
//!   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! In flight: arm_for starts again at t0 for another tau, at any time, and computes what
//!       follows from tau. arm keeps the tau last used: at first that of the parameters.
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
//! Operations of one step, without input checks and clipping: 23 additions or comparisons, 29
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

/// Run-time parameters of [`PtcTan2InFlight`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTan2InFlightParams {
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
    /// gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k\[0\] is k_1 \[1/s^2\], k\[1\] is k_2 \[1/s\].
    pub k: [f64; 2],
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTan2InFlight {
    /// gains k_i of pi0 = -sum k_i xi_i.
    k2: f64,
    /// coefficient of slope^2 in the gain of x1.
    c1_2: f64,
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
    /// derived from the parameters.
    f83: f64,
    /// coefficient of cot_rate^0 in the gain of x2.
    c2_0: f64,
    /// derived from the parameters.
    f88: f64,
    /// coefficient of cot_rate^2 in the gain of x2.
    c2_2: f64,
    /// bound of |u|.
    u_max: f64,
}

/// Feedback gains of [`PtcTan2InFlight`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTan2InFlightGains {
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
impl PtcTan2InFlight {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0) for `params.tau`.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcTan2InFlightParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        let k2 = params.k[1];
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
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let K1 = k1 / (a * a);
        let K2 = k2 / a;
        let c1_2 = -K1;
        let hold_from = -eps;
        let size_K1 = if k1.abs() <= 0.0 { 1e-200 } else { K1.abs() };
        let size_K2 = if k2.abs() <= 0.0 { 1e-200 } else { K2.abs() };
        let f83 = -(1.5707963267948966 * K2);
        let f88 = -(0.6366197723675814 * K2);
        if !((size_K1 >= 1e-200)
            && (size_K2 >= 1e-200)
            && c1_2.is_finite()
            && hold_from.is_finite()
            && f83.is_finite()
            && f88.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            k2,
            c1_2,
            eps,
            hold_from,
            f83,
            f88,
            u_max,
            tau: 0.0,
            angle_rate: 0.0,
            inv_angle_rate: 0.0,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
            inv_tau: 0.0,
            c2_0: 0.0,
            c2_2: 0.0,
        };
        built.arm_for(t0, tau)?;
        Ok(built)
    }

    /// Starts again at t0 \[s\], with the tau last used.
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

    /// Starts again at t0 \[s\] with another duration tau \[s\]: the deadline is t0 + tau.
    ///
    /// # Errors
    /// `Param`: an argument or what follows from it is not finite, or `tau` is outside its domain;
    /// nothing has changed.
    #[inline]
    pub fn arm_for(&mut self, t0: f64, tau: f64) -> Result<(), Error> {
        if !(t0.is_finite()
            && tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (tau > self.eps))
        {
            return Err(Error::Param);
        }
        let angle_rate = 1.5707963267948966 / tau;
        let inv_angle_rate = 0.6366197723675814 * tau;
        let deadline = t0 + tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (tau - v1);
        let inv_tau = 1.0 / tau;
        let c2_0 = self.f83 / tau;
        let c2_2 = self.f88 * tau;
        let size_c2_0 = if (self.k2).abs() <= 0.0 {
            1e-200
        } else {
            c2_0.abs()
        };
        let size_c2_2 = if (self.k2).abs() <= 0.0 {
            1e-200
        } else {
            c2_2.abs()
        };
        if !(deadline.is_finite()
            && (size_c2_0 >= 1e-200)
            && (size_c2_2 >= 1e-200)
            && angle_rate.is_finite()
            && inv_angle_rate.is_finite()
            && inv_tau.is_finite()
            && c2_0.is_finite()
            && c2_2.is_finite())
        {
            return Err(Error::Param);
        }
        self.tau = tau;
        self.angle_rate = angle_rate;
        self.inv_angle_rate = inv_angle_rate;
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        self.inv_tau = inv_tau;
        self.c2_0 = c2_0;
        self.c2_2 = c2_2;
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
        let row1 = self.c1_2 * slope * slope;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let row2 = (self.c2_2 * cot_rate_squared) + self.c2_0 + (2.0 * cot_rate);
        let v = (row1 * x[0]) + (row2 * x[1]);
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
    pub fn tick(&self, t: f64) -> Result<PtcTan2InFlightGains, Error> {
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
        let row1 = self.c1_2 * slope * slope;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let row2 = (self.c2_2 * cot_rate_squared) + self.c2_0 + (2.0 * cot_rate);
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcTan2InFlightGains {
            gain: [row1, row2],
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
impl PtcTan2InFlightGains {
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

impl Controller<2> for PtcTan2InFlight {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
