//! Prescribed-time controller ptc_exp3_axes3_own: order n = 3, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --axes 3 --mu "exp(a=1)" --name ptc_exp3_axes3_own --limits=40,40,15 --poles="[[-4,-5,-6],[-4,-5,-6],[-6,-7,-8]]" --g="[1/m, 1/m, 2]"
//! Version 0.1.0, design 9566731ebf83.
//!
//! Plant: x1' = x2, ..., x3' = f + g u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, g
//!       u in U/s^3.
//! Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
//!       eps, sampling, f and clipping leave. The checks below say what is known of this
//!       design.
//! f is not part of the law: cancel its known terms before the call.
//! Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: k = 120, 74, 15; u_max = 40; g = 1/m
//!   axis 2: k = 120, 74, 15; u_max = 40; g = 1/m
//!   axis 3: k = 336, 146, 21; u_max = 15; g = 2
//!
//! SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
//!       sample periods below a limit that depends on eps and the gains. ptc-codegen check
//!       finds it once tau, eps, the gains and --sample-time are given.
//!
//! Parameters:
//!   a = 1 [1/s], fixed: rate of stretched time
//!   tau: prescribed settling time [s], from 1e-150 to 1e150
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
//!   m: parameter of g, finite
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
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = a*T
//!   B_{2,1} = -a^2*T
//!   B_{2,2} = a^2*T^2
//!   B_{3,1} = a^3*T
//!   B_{3,2} = -3*a^3*T^2
//!
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
//!   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
//!   u = (sum_j gain_j x_j)/g
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = -1 - K2 + K3
//!   row_3 = 3 - K3
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
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 9 additions or comparisons, 20
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

/// Run-time parameters of [`PtcExp3Axes3Own`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp3Axes3OwnParams {
    /// prescribed settling time \[s\], from 1e-150 to 1e150.
    pub tau: f64,
    /// start time \[s\], finite.
    pub t0: f64,
    /// time-to-go at which the gains are held \[s\], >= 1e-150, < tau.
    pub eps: f64,
    /// parameter of g, finite.
    pub m: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp3Axes3Own {
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
    /// g(x, t).
    input_gain: f64,
}

/// Feedback gains of [`PtcExp3Axes3Own`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcExp3Axes3OwnGains {
    /// u input_gain = gain\[3*axis\] x\[0\] + ... + gain\[3*axis + 2\] x\[2\].
    pub gain: [f64; 9],
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
impl PtcExp3Axes3Own {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcExp3Axes3OwnParams) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let p_m = params.m;
        if !(tau.is_finite()
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && t0.is_finite()
            && (eps >= 1e-150)
            && p_m.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let hold_from = -eps;
        let input_gain = 1.0 / p_m;
        let size_input_gain = if input_gain.abs() <= 0.0 {
            1e-200
        } else {
            input_gain.abs()
        };
        if !((size_input_gain >= 1e-200) && hold_from.is_finite() && input_gain.is_finite()) {
            return Err(Error::Param);
        }
        let mut built = Self {
            tau,
            eps,
            hold_from,
            input_gain,
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
    pub fn tick(&self, t: f64) -> Result<PtcExp3Axes3OwnGains, Error> {
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
        let v2 = (-120.0) * v1 * inv_T;
        let v3 = (-60.0) * inv_T * inv_T;
        let v4 = (-12.0) * inv_T;
        let status = if late < self.hold_from {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(PtcExp3Axes3OwnGains {
            gain: [
                v2,
                v3,
                v4,
                v2,
                v3,
                v4,
                (-336.0) * v1 * inv_T,
                (-126.0) * inv_T * inv_T,
                (-18.0) * inv_T,
            ],
            input_gain: [self.input_gain, self.input_gain, 2.0],
            u_max: [40.0, 40.0, 15.0],
            status,
        })
    }

    /// u of 3 axes at time t \[s\], from the state x = (x1, x1', ...) of each. Its status is that
    /// of the first axis that fails, and then every u is 0; else SATURATED where an axis is.
    #[inline]
    pub fn step(&self, t: f64, x: &[[f64; 3]; 3]) -> Axes<3, f64> {
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
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let inv_T = (-1.0) / late;
        let v1 = inv_T * inv_T;
        let v2 = (-120.0) * v1 * inv_T;
        let v3 = (-60.0) * inv_T * inv_T;
        let v4 = (-12.0) * inv_T;
        let mut gain = [0.0; 9];
        gain[0] = v2;
        gain[1] = v3;
        gain[2] = v4;
        gain[3] = v2;
        gain[4] = v3;
        gain[5] = v4;
        gain[6] = (-336.0) * v1 * inv_T;
        gain[7] = (-126.0) * inv_T * inv_T;
        gain[8] = (-18.0) * inv_T;
        let mut input_gain = [0.0; 3];
        input_gain[0] = self.input_gain;
        input_gain[1] = self.input_gain;
        input_gain[2] = 2.0;
        let mut u_max = [0.0; 3];
        u_max[0] = 40.0;
        u_max[1] = 40.0;
        u_max[2] = 15.0;
        if late < self.hold_from {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        let mut wanted = [0.0; 3];
        for axis in 0..3 {
            let s1 = (gain[3 * axis] * x[axis][0]) + (gain[(3 * axis) + 1] * x[axis][1]);
            let v5 = s1 + (gain[(3 * axis) + 2] * x[axis][2]);
            let g = input_gain[axis];
            wanted[axis] = if g < 0.0 || g > 0.0 { v5 / g } else { f64::NAN };
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
                    if x[axis][0].is_finite() && x[axis][1].is_finite() && x[axis][2].is_finite() {
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
impl PtcExp3Axes3OwnGains {
    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, axis: u32, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(axis < 3) {
            return Err(Error::Input);
        }
        let s1 = self.gain[3 * axis as usize] * x[0];
        let s2 = s1 + (self.gain[3 * axis as usize + 1] * x[1]);
        let v1 = s2 + (self.gain[3 * axis as usize + 2] * x[2]);
        let g = self.input_gain[axis as usize];
        let v = if g < 0.0 || g > 0.0 { v1 / g } else { f64::NAN };
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max[axis as usize]) {
            (v, self.status)
        } else if x[0].is_finite() && x[1].is_finite() && x[2].is_finite() {
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
