//! Prescribed-time controller gantry: order n = 2, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --axes 3 --mu "exp(a=1)" --name gantry --tau=1.5 --t0=0 --eps=1.59e-2 --limits=900,400,150 --poles="[[-4,-5],[-4,-5],[-6,-7]]" --g="[1/m1, 1/m2, 1/m3]" --param m1=120 --param m2=45 --param m3=12 --sample-time=1e-3
//! Version 0.1.0, design 9ac95d6ea129.
//!
//! Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
//! Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
//!       eps, sampling, f and clipping leave. The checks below say what is known of this
//!       design.
//! f is not part of the law: cancel its known terms before the call.
//! Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: k = 20, 9; u_max = 900; g = 1/m1
//!   axis 2: k = 20, 9; u_max = 400; g = 1/m2
//!   axis 3: k = 42, 13; u_max = 150; g = 1/m3
//!
//! Parameters:
//!   tau = 1.5 [s], fixed: prescribed settling time
//!   t0 = 0 [s], fixed: start time
//!   eps = 1.59e-2 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
//!   m1 = 120, fixed: parameter of g
//!   m2 = 45, fixed: parameter of g
//!   m3 = 12, fixed: parameter of g
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*(1 - exp(-a*t))
//!   kappa(Dt) = -ln(T/tau)/a
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) a^k T
//!   r_1 = a*T
//!   r_2 = -a^2*T
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = a*T
//!   B_{2,1} = -a^2*T
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   u = (sum_j gain_j x_j)/g
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = 1 - K2
//!   inv_T = 1/T
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
//!   growth: sound: x and u go to 0 at the deadline.
//!   sampling: sound: axis 1: eps = 0.0159 s is 3.975 times the minimum for a period of 0.001
//!       s.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 6 additions or comparisons, 12
//!       multiplications, 4 divisions.
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

/// Run-time parameters of [`Gantry`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct GantryParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Gantry {
    /// start time.
    t0: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
}

/// Feedback gains of [`Gantry`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct GantryGains {
    /// u input_gain = gain\[2*axis\] x\[0\] + ... + gain\[2*axis + 1\] x\[1\].
    pub gain: [f64; 6],
    /// g.
    pub input_gain: [f64; 3],
    /// bound of |u| of each axis.
    pub u_max: [f64; 3],
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
impl Gantry {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: GantryParams) -> Result<Self, Error> {
        let mut built = Self {
            t0: 0.0,
            deadline: 0.0,
            correction: 0.0,
        };
        built.arm(0.0)?;
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
        let deadline = t0 + 1.5;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (1.5 - v1);
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
    pub fn tick(&self, t: f64) -> Result<GantryGains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.0159 { past } else { -0.0159 };
        let inv_T = (-1.0) / late;
        let v1 = (-20.0) * inv_T * inv_T;
        let v2 = (-8.0) * inv_T;
        let status = if late < -0.0159 {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(GantryGains {
            gain: [v1, v2, v1, v2, (-42.0) * inv_T * inv_T, (-12.0) * inv_T],
            input_gain: [
                0.008333333333333333,
                0.022222222222222223,
                0.08333333333333333,
            ],
            u_max: [900.0, 400.0, 150.0],
            status,
        })
    }

    /// u of 3 axes at time t \[s\], from the state x = (x1, x1', ...) of each. Its status is that
    /// of the first axis that fails, and then every u is 0; else SATURATED where an axis is.
    #[inline]
    pub fn step(&self, t: f64, x: &[[f64; 2]; 3]) -> Axes<3, f64> {
        let failed = |error| Axes {
            u: [0.0; 3],
            axes: [Err(error); 3],
            status: Err(error),
        };
        let mut u = [0.0; 3];
        let mut axes = [Ok(Status::Ok); 3];
        let mut status;
        if !(t.is_finite() && (t >= self.t0)) {
            return failed(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.0159 { past } else { -0.0159 };
        let inv_T = (-1.0) / late;
        let v1 = (-20.0) * inv_T * inv_T;
        let v2 = (-8.0) * inv_T;
        let mut gain = [0.0; 6];
        gain[0] = v1;
        gain[1] = v2;
        gain[2] = v1;
        gain[3] = v2;
        gain[4] = (-42.0) * inv_T * inv_T;
        gain[5] = (-12.0) * inv_T;
        let mut input_gain = [0.0; 3];
        input_gain[0] = 0.008333333333333333;
        input_gain[1] = 0.022222222222222223;
        input_gain[2] = 0.08333333333333333;
        let mut u_max = [0.0; 3];
        u_max[0] = 900.0;
        u_max[1] = 400.0;
        u_max[2] = 150.0;
        if late < -0.0159 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        let mut wanted = [0.0; 3];
        for axis in 0..3 {
            let v3 = (gain[2 * axis] * x[axis][0]) + (gain[(2 * axis) + 1] * x[axis][1]);
            let g = input_gain[axis];
            wanted[axis] = if g < 0.0 || g > 0.0 { v3 / g } else { f64::NAN };
        }
        u[0] = wanted[0];
        u[1] = wanted[1];
        u[2] = wanted[2];
        for axis in 0..3 {
            axes[axis] = status;
        }
        let mut outside = 0_u32;
        for axis in 0..3 {
            let v = wanted[axis];
            if !(v.is_finite() && (v.abs() <= u_max[axis])) {
                outside = 1;
                break;
            }
        }
        if outside == 1 {
            for axis in 0..3 {
                let v = wanted[axis];
                if !(v.is_finite() && (v.abs() <= u_max[axis])) {
                    if x[axis][0].is_finite() && x[axis][1].is_finite() {
                        if v.is_finite() {
                            if u_max[axis] < v {
                                u[axis] = u_max[axis];
                                axes[axis] = Ok(Status::Saturated);
                            } else {
                                u[axis] = -u_max[axis];
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
                for axis in 0..3 {
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
impl GantryGains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, axis: u32, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(axis < 3) {
            return Err(Error::Input);
        }
        let s1 = self.gain[2 * axis as usize] * x[0];
        let v1 = s1 + (self.gain[2 * axis as usize + 1] * x[1]);
        let g = self.input_gain[axis as usize];
        let v = if g < 0.0 || g > 0.0 { v1 / g } else { f64::NAN };
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max[axis as usize]) {
            (v, self.status)
        } else if x[0].is_finite() && x[1].is_finite() {
            if v.is_finite() {
                if v > self.u_max[axis as usize] {
                    (self.u_max[axis as usize], Status::Saturated)
                } else {
                    (-self.u_max[axis as usize], Status::Saturated)
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
