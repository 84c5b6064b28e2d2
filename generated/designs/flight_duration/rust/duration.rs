//! Prescribed-time controller duration: order n = 3, mapping tan.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6
//! Version 0.1.0, design 3d20bda1c4e1.
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
//!   u_max = 100 [unit of u], fixed: bound of |u|
//!   k_1 = 120 [1/s^3], fixed: gain of xi_1
//!   k_2 = 74 [1/s^2], fixed: gain of xi_2
//!   k_3 = 15 [1/s], fixed: gain of xi_3
//!   tau: prescribed settling time [s], from 1e-18 to 1e18
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
//!   a: rate of stretched time [1/s], from 1e-18 to 1e18
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
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*pi^-1*tau*a*V
//!   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
//!   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
//!   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
//!   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
//!   u = sum_j gain_j x_j
//!   gain_j = row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1*slope^3
//!   row_2 = -4*pi^-2*tau^2*K2*cot_rate^4 + 4*pi^-1*tau*K3*cot_rate^3 + pi*tau^-1*K3*cot_rate
//!       + 1/2*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K2 - 2*K2*cot_rate^2 - 6*cot_rate^2
//!   row_3 = -2*pi^-1*tau*K3*cot_rate^2 - 1/2*pi*tau^-1*K3 + 6*cot_rate
//!   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
//!   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! In flight: arm_for starts again at t0 for another tau, at any time, and computes what
//!       follows from tau. arm keeps the tau last used: at first that of the parameters.
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: tan is of class M for all its parameters.
//!   growth: sound: x and u go to 0 at the deadline.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 21 additions or comparisons, 28
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
pub struct Control<R = f32> {
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

/// Run-time parameters of [`Duration`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DurationParams {
    /// prescribed settling time \[s\], from 1e-18 to 1e18.
    pub tau: f32,
    /// start time \[s\], finite.
    pub t0: f32,
    /// time-to-go at which the gains are held \[s\], >= 1e-18, < tau.
    pub eps: f32,
    /// rate of stretched time \[1/s\], from 1e-18 to 1e18.
    pub a: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Duration {
    /// coefficient of slope^3 in the gain of x1.
    c1_3: f32,
    /// prescribed settling time.
    tau: f32,
    /// pi/(2*tau).
    angle_rate: f32,
    /// 2*tau/pi.
    inv_angle_rate: f32,
    /// start time.
    t0: f32,
    /// t0 + tau, rounded.
    deadline: f32,
    /// low part of t0 + tau (compensated sum).
    correction: f32,
    /// time-to-go at which the gains are held.
    eps: f32,
    /// -eps: later than this the gains are held.
    hold_from: f32,
    /// 1/tau.
    inv_tau: f32,
    /// derived from the parameters.
    f69: f32,
    /// coefficient of cot_rate^0 in the gain of x2.
    c2_0: f32,
    /// derived from the parameters.
    f73: f32,
    /// coefficient of cot_rate^1 in the gain of x2.
    c2_1: f32,
    /// coefficient of cot_rate^2 in the gain of x2.
    c2_2: f32,
    /// derived from the parameters.
    f81: f32,
    /// coefficient of cot_rate^3 in the gain of x2.
    c2_3: f32,
    /// derived from the parameters.
    f85: f32,
    /// coefficient of cot_rate^4 in the gain of x2.
    c2_4: f32,
    /// derived from the parameters.
    f99: f32,
    /// coefficient of cot_rate^0 in the gain of x3.
    c3_0: f32,
    /// derived from the parameters.
    f103: f32,
    /// coefficient of cot_rate^2 in the gain of x3.
    c3_2: f32,
}

/// Feedback gains of [`Duration`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DurationGains {
    /// u = gain\[0\] x\[0\] + ... + gain\[2\] x\[2\].
    pub gain: [f32; 3],
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
impl Duration {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0) for `params.tau`.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: DurationParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let a = params.a;
        if !(tau.is_finite()
            && (1e-18 <= tau)
            && (tau <= 1e18)
            && t0.is_finite()
            && (eps >= 1e-18)
            && a.is_finite()
            && (1e-18 <= a)
            && (a <= 1e18)
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let v1 = a * a;
        let v2 = a * v1;
        let K1 = 120.0 / v2;
        let K2 = 74.0 / v1;
        let K3 = 15.0 / a;
        let c1_3 = -K1;
        let hold_from = -eps;
        let c2_2 = (-(2.0 * K2)) - 6.0;
        let f69 = (-(2.467401 * K2)) + 4.934802;
        let f73 = 3.1415927 * K3;
        let f81 = 1.2732395 * K3;
        let f85 = -(0.40528473 * K2);
        let f99 = -(1.5707964 * K3);
        let f103 = -(0.63661975 * K3);
        if !((v2 >= 1e-30)
            && (K1 >= 1e-30)
            && c1_3.is_finite()
            && hold_from.is_finite()
            && f69.is_finite()
            && f73.is_finite()
            && c2_2.is_finite()
            && f81.is_finite()
            && f85.is_finite()
            && f99.is_finite()
            && f103.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            c1_3,
            eps,
            hold_from,
            f69,
            f73,
            c2_2,
            f81,
            f85,
            f99,
            f103,
            tau: 0.0,
            angle_rate: 0.0,
            inv_angle_rate: 0.0,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
            inv_tau: 0.0,
            c2_0: 0.0,
            c2_1: 0.0,
            c2_3: 0.0,
            c2_4: 0.0,
            c3_0: 0.0,
            c3_2: 0.0,
        };
        built.arm_for(t0, tau)?;
        Ok(built)
    }

    /// Starts again at t0 \[s\], with the tau last used.
    ///
    /// # Errors
    /// `Param`: an argument or what follows from it is not finite; nothing has changed.
    #[inline]
    pub fn arm(&mut self, t0: f32) -> Result<(), Error> {
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
    pub fn arm_for(&mut self, t0: f32, tau: f32) -> Result<(), Error> {
        if !(t0.is_finite()
            && tau.is_finite()
            && (1e-18 <= tau)
            && (tau <= 1e18)
            && (tau > self.eps))
        {
            return Err(Error::Param);
        }
        let angle_rate = 1.5707964 / tau;
        let inv_angle_rate = 0.63661975 * tau;
        let deadline = t0 + tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (tau - v1);
        let inv_tau = 1.0 / tau;
        let v2 = tau * tau;
        let c2_0 = self.f69 / v2;
        let c2_1 = self.f73 / tau;
        let c2_3 = self.f81 * tau;
        let c2_4 = self.f85 * v2;
        let c3_0 = self.f99 / tau;
        let c3_2 = self.f103 * tau;
        if !(deadline.is_finite()
            && (c2_4 <= -1e-30)
            && angle_rate.is_finite()
            && inv_angle_rate.is_finite()
            && inv_tau.is_finite()
            && c2_0.is_finite()
            && c2_1.is_finite()
            && c2_3.is_finite()
            && c2_4.is_finite()
            && c3_0.is_finite()
            && c3_2.is_finite())
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
        self.c2_1 = c2_1;
        self.c2_3 = c2_3;
        self.c2_4 = c2_4;
        self.c3_0 = c3_0;
        self.c3_2 = c3_2;
        Ok(())
    }

    /// u at time t \[s\] and state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f32, x: &[f32; 3]) -> Result<Control<f32>, Error> {
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
        let s1 = (((((-9.25448e-5) * v2) - 7.2446054e-9) * v2) - 0.0006016576) * v2;
        let s2 = ((((s1 - 0.0018990984) * v2) - 0.007859069) * v2) - 0.031790096;
        let th_cot_th = (((((s2 * v2) - 0.13529049) * v2) - 0.822467) * v2) + 1.0;
        let cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        let slope = self.angle_rate + (self.inv_angle_rate * cot_rate_squared);
        let row1 = self.c1_3 * slope * slope * slope;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let s3 = (self.c2_4 * cot_rate_squared) + self.c2_2;
        let s4 = ((self.c2_3 * cot_rate_squared) + self.c2_1) * cot_rate;
        let row2 = (s3 * cot_rate_squared) + self.c2_0 + s4;
        let row3 = (self.c3_2 * cot_rate_squared) + self.c3_0 + (6.0 * cot_rate);
        let v = (row1 * x[0]) + (row2 * x[1]) + (row3 * x[2]);
        let (u, status) = if v.is_finite() && (v.abs() <= 100.0) && (late < self.hold_from) {
            (v, Status::Ok)
        } else if t.is_finite() && x[0].is_finite() && x[1].is_finite() && x[2].is_finite() {
            if v.is_finite() {
                if v > 100.0 {
                    (100.0, Status::Saturated)
                } else if v < -100.0 {
                    (-100.0, Status::Saturated)
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
    pub fn tick(&self, t: f32) -> Result<DurationGains, Error> {
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
        let s1 = (((((-9.25448e-5) * v2) - 7.2446054e-9) * v2) - 0.0006016576) * v2;
        let s2 = ((((s1 - 0.0018990984) * v2) - 0.007859069) * v2) - 0.031790096;
        let th_cot_th = (((((s2 * v2) - 0.13529049) * v2) - 0.822467) * v2) + 1.0;
        let cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        let slope = self.angle_rate + (self.inv_angle_rate * cot_rate_squared);
        let row1 = self.c1_3 * slope * slope * slope;
        let T = -late;
        let cot_rate = T * inv_T_squared * th_cot_th;
        let s3 = (self.c2_4 * cot_rate_squared) + self.c2_2;
        let s4 = ((self.c2_3 * cot_rate_squared) + self.c2_1) * cot_rate;
        let row2 = (s3 * cot_rate_squared) + self.c2_0 + s4;
        let row3 = (self.c3_2 * cot_rate_squared) + self.c3_0 + (6.0 * cot_rate);
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(DurationGains {
            gain: [row1, row2, row3],
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
impl DurationGains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f32; 3]) -> Result<Control<f32>, Error> {
        let s1 = (self.gain[0] * x[0]) + (self.gain[1] * x[1]);
        let v = s1 + (self.gain[2] * x[2]);
        let (u, status) = if v.is_finite() && (v.abs() <= 100.0) {
            (v, self.status)
        } else if x[0].is_finite() && x[1].is_finite() && x[2].is_finite() {
            if v.is_finite() {
                if v > 100.0 {
                    (100.0, Status::Saturated)
                } else {
                    (-100.0, Status::Saturated)
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

impl Controller<3> for Duration {
    type Real = f32;

    fn arm(&mut self, t0: f32) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f32, x: &[f32; 3]) -> Result<Control<f32>, Error> {
        Self::step(self, t, x)
    }
}
