//! Prescribed-time controller ptc_tanh3: order n = 3, mapping tanh.
//!
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu tanh
//! Version 0.1.0.
//!
//! It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
//!
//! Parameters:
//!   tau: prescribed settling time [s], finite, > 0
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], > 0, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a: rate of stretched time [1/s], finite, > 0
//!   k: gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite
//!
//! Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
//!   mu(t)     = tau*tanh(a*t)
//!   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
//!   atoms: T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), g = 1/(1 + E)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
//!   r_1 = 2*a*T*g
//!   r_2 = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
//!   r_3 = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
//!   B_{0,0} = 1
//!   B_{1,1} = 2*a*T*g
//!   B_{2,1} = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
//!   B_{2,2} = 4*a^2*T^2*g^2
//!   B_{3,1} = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
//!   B_{3,2} = 24*a^3*T^2*E*g^3 - 24*a^3*T^2*g^3
//!
//! Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
//!   pi0 = -(k_1 xi_1 + ... + k_n xi_n)
//!   g   = 1
//!   u = (sum_j gain_j x_j)/g
//!   gain_j = inv_T^(n+1-j) row_j
//!   K_i = k_i/(2*a)^(n+1-i)
//!   row_1 = -K1*one_plus_E^3
//!   row_2 = -1 - K2 - 2*K2*E - K2*E^2 + K3 - K3*E^2 + 4*E - E^2
//!   row_3 = 3 - K3 - K3*E - 3*E
//!   inv_T = 1/T
//!   one_plus_E = 1 + E
//!
//! From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
//! |u| <= u_max always (status SATURATED where u was clipped).
//! Guard full: every input and pointer is checked.
//! Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
//!       (-ffp-contract=off).
//!
//! Checks of the design (ptc-codegen check tells more):
//!   membership: sound: tanh is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step: 10 + - or comparison, 16 *, 1 /, 0 sqrt, 0 calls.
//! Latencies added up: x86-64 about 118 cycles, Cortex-M4F about 40 cycles.
#![forbid(unsafe_code)]

/// How a valid u came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking: u is that of the law.
    Ok,
    /// Time-to-go is held at eps: the deadline is near or over.
    Hold,
    /// |u| was clipped to u_max; wins over `Hold` and `After`.
    Saturated,
    /// The deadline is over, and what was chosen for then gives u.
    After,
}

/// What a step gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f64> {
    /// Input of the plant.
    pub u: R,
    /// How it came about.
    pub status: Status,
}

/// Why there is no controller, or no u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A parameter is outside its domain, or the coefficients derived from it overflow.
    Param,
    /// x or t is not finite, or t lies before the start.
    Input,
    /// u is not finite.
    Range,
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Param => "a parameter is outside its domain",
            Self::Input => "x or t is not finite, or t is before t0",
            Self::Range => "u is not finite",
        })
    }
}

impl core::error::Error for Error {}

/// A controller of the plant x1' = x2, ..., xN' = u.
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

/// Run-time parameters of [`PtcTanh3`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh3Params {
    /// prescribed settling time, unit s, finite, > 0.
    pub tau: f64,
    /// start time, unit s, finite.
    pub t0: f64,
    /// time-to-go at which the gains are held, unit s, > 0, < tau.
    pub eps: f64,
    /// bound of |u|, unit unit of u, > 0, infinity allowed.
    pub u_max: f64,
    /// rate of stretched time, unit 1/s, finite, > 0.
    pub a: f64,
    /// gains k_i of pi0 = -sum k_i xi_i, unit s^(i-1-n), finite.
    pub k: [f64; 3],
}

/// Prescribed-time controller of order 3.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcTanh3 {
    /// coefficient of one_plus_E^3 in the gain of x1
    c1_3: f64,
    /// start time
    t0: f64,
    /// prescribed settling time
    tau: f64,
    /// t0 + tau, rounded
    deadline: f64,
    /// what the rounding of t0 + tau left out
    correction: f64,
    /// time-to-go at which the gains are held
    eps: f64,
    /// -eps: later than this the gains are held
    hold_from: f64,
    /// 2*tau
    two_tau: f64,
    /// coefficient of E^0 in the gain of x2
    c2_0: f64,
    /// coefficient of E^1 in the gain of x2
    c2_1: f64,
    /// coefficient of E^2 in the gain of x2
    c2_2: f64,
    /// coefficient of E^0 in the gain of x3
    c3_0: f64,
    /// coefficient of E^1 in the gain of x3
    c3_1: f64,
    /// bound of |u|
    u_max: f64,
}

/// Feedback gains of [`PtcTanh3`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PtcTanh3Gains {
    /// u = gain\[0\] x\[0\] + ... + gain\[2\] x\[2\].
    pub gain: [f64; 3],
    /// Bound of |u|.
    pub u_max: f64,
    /// `Ok` or `Hold`.
    pub status: Status,
}

#[allow(non_snake_case, dead_code, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcTanh3 {
    /// Takes the parameters and arms at the start time among them (or the fixed one).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it overflow.
    pub fn new(params: PtcTanh3Params) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        let k2 = params.k[1];
        let k3 = params.k[2];
        if !(tau.is_finite()
            && (tau > 0.0)
            && t0.is_finite()
            && (eps > 0.0)
            && (u_max > 0.0)
            && a.is_finite()
            && (a > 0.0)
            && k1.is_finite()
            && k2.is_finite()
            && k3.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let rate = 2.0 * a;
        let v1 = rate * rate;
        let K1 = k1 / (rate * v1);
        let K2 = k2 / v1;
        let K3 = k3 / rate;
        let c1_3 = -K1;
        let hold_from = -eps;
        let two_tau = 2.0 * tau;
        let v2 = -K2;
        let c2_0 = (v2 + K3) - 1.0;
        let c2_1 = (-(2.0 * K2)) + 4.0;
        let c2_2 = (v2 - K3) - 1.0;
        let v3 = -K3;
        let c3_0 = v3 + 3.0;
        let c3_1 = v3 - 3.0;
        let mut built = Self {
            c1_3,
            tau,
            eps,
            hold_from,
            two_tau,
            c2_0,
            c2_1,
            c2_2,
            c3_0,
            c3_1,
            u_max,
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
        };
        if !(built.c1_3.is_finite()
            && built.hold_from.is_finite()
            && built.two_tau.is_finite()
            && built.c2_0.is_finite()
            && built.c2_1.is_finite()
            && built.c2_2.is_finite()
            && built.c3_0.is_finite()
            && built.c3_1.is_finite())
        {
            return Err(Error::Param);
        }
        built.arm(t0)?;
        Ok(built)
    }

    /// Starts again at `t0`, in s.
    ///
    /// # Errors
    /// `Param`: `t0` or the deadline is not finite; the controller is left as it was.
    pub fn arm(&mut self, t0: f64) -> Result<(), Error> {
        if !(t0.is_finite()) {
            return Err(Error::Param);
        }
        let deadline = t0 + self.tau;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (self.tau - v1);
        if !(deadline.is_finite()) {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

/// u at time `t`, in s, and state `x` = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not finite, or `t` lies before the start. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        let [x1, x2, x3] = *x;
        if !(t.is_finite()
            && (t >= self.t0)
            && x1.is_finite()
            && x2.is_finite()
            && x3.is_finite())
        {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let v1 = self.two_tau + late;
        let v2 = (-1.0) / (late * v1);
        let E = late * (late * v2);
        let one_plus_E = 1.0 + E;
        let row1 = self.c1_3 * one_plus_E * one_plus_E * one_plus_E;
        let row2 = (((self.c2_2 * E) + self.c2_1) * E) + self.c2_0;
        let row3 = (self.c3_1 * E) + self.c3_0;
        let inv_T = v2 * v1;
        let v3 = ((((row1 * x1 * inv_T) + (row2 * x2)) * inv_T) + (row3 * x3)) * inv_T;
        let u = v3;
if u > self.u_max {
            return Ok(Control { u: self.u_max, status: Status::Saturated });
        }
        if u < -self.u_max {
            return Ok(Control { u: -self.u_max, status: Status::Saturated });
        }
        // Time-to-go, or NaN where u is not finite: one comparison tells tracking.
        let margin = (u - u) - late;
        if margin > self.eps {
            Ok(Control { u, status: Status::Ok })
        } else if margin.is_nan() {
            Err(Error::Range)
        } else {
            Ok(Control { u, status: Status::Hold })
        }
    }

    /// The gains at time `t`, in s, for several axes that share one deadline. `tick` and `axis`
    /// round otherwise than `step` does.
    ///
    /// # Errors
    /// `Input`: `t` is not finite or lies before the start.
    #[inline]
    pub fn tick(&self, t: f64) -> Result<PtcTanh3Gains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < self.hold_from { past } else { self.hold_from };
        let v1 = self.two_tau + late;
        let v2 = (-1.0) / (late * v1);
        let E = late * (late * v2);
        let one_plus_E = 1.0 + E;
        let row1 = self.c1_3 * one_plus_E * one_plus_E * one_plus_E;
        let row2 = (((self.c2_2 * E) + self.c2_1) * E) + self.c2_0;
        let row3 = (self.c3_1 * E) + self.c3_0;
        let inv_T = v2 * v1;
        let held = late >= self.hold_from;
        Ok(PtcTanh3Gains {
            gain: [
                row1 * (inv_T * inv_T) * inv_T,
                row2 * inv_T * inv_T,
                row3 * inv_T,
            ],
            u_max: self.u_max,
            status: if held { Status::Hold } else { Status::Ok },
        })
    }
}

#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl PtcTanh3Gains {
    /// u of one axis with state `x` = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: `x` is not finite. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        let [x1, x2, x3] = *x;
        let [gain1, gain2, gain3] = self.gain;
        if !(x1.is_finite()
            && x2.is_finite()
            && x3.is_finite())
        {
            return Err(Error::Input);
        }
        let u = (gain1 * x1) + (gain2 * x2) + (gain3 * x3);
if u > self.u_max {
            return Ok(Control { u: self.u_max, status: Status::Saturated });
        }
        if u < -self.u_max {
            return Ok(Control { u: -self.u_max, status: Status::Saturated });
        }
        if u.is_finite() {
            Ok(Control { u, status: self.status })
        } else {
            Err(Error::Range)
        }
    }
}

impl Controller<3> for PtcTanh3 {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
