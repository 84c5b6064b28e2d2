//! Prescribed-time controller quadrotor: order n = 2, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --axes 4 --mu "exp(a=1)" --name quadrotor --tau=2 --t0=0 --eps=0.02 --limits=8,0.4,0.4,0.1 --poles="[[-4,-5],[-6,-7],[-6,-7],[-4,-5]]" --g="[1/m, 1/Ix, 1/Iy, 1/Iz]" --reference input --param Ix=0.012 --param Iy=0.013 --param Iz=0.022 --param m=1.2 --sample-time=1e-3
//! Version 0.1.0, design b1624acb7533.
//!
//! Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
//! Goal: x = (r, r', ...) of the reference that each call is given at the deadline t0 + tau
//!       from any state at t0, up to the error that the hold at eps, sampling, f and clipping
//!       leave. The checks below say what is known of this design.
//! f is not part of the law: cancel its known terms before the call.
//! Axes: 4, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: k = 20, 9; u_max = 8; g = 1/m
//!   axis 2: k = 42, 13; u_max = 0.4; g = 1/Ix
//!   axis 3: k = 42, 13; u_max = 0.4; g = 1/Iy
//!   axis 4: k = 20, 9; u_max = 0.1; g = 1/Iz
//!
//! Parameters:
//!   tau = 2 [s], fixed: prescribed settling time
//!   t0 = 0 [s], fixed: start time
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
//!   Ix = 0.012, fixed: parameter of g
//!   Iy = 0.013, fixed: parameter of g
//!   Iz = 0.022, fixed: parameter of g
//!   m = 1.2, fixed: parameter of g
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
//! Law, Theorem 1, with xi = BB_n e and t_kappa = kappa(Dt) + t0:
//!   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T e) + r^(2))/g
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   e_i = x_i - r^(i-1), where r^(0)..r^(2) are the reference and its derivatives, r[0]..r[2]
//!       of each call
//!   u = (sum_j gain_j e_j + r^(2))/g
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = 1 - K2
//!   inv_T = 1/T
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t, x and r are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: x and u go to 0 at the deadline.
//!   sampling: undecided: axis 1: r is known at the samples alone; with a constant r: eps =
//!       0.02 s is 5 times the minimum for a period of 0.001 s.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: `x_max` is not given.
//!
//! Operations of one step, without input checks and clipping: 19 additions or comparisons, 14
//!       multiplications, 5 divisions.
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

/// Run-time parameters of [`Quadrotor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct QuadrotorParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Quadrotor {
    /// start time.
    t0: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
}

/// Feedback gains of [`Quadrotor`] at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct QuadrotorGains {
    /// u input_gain = gain\[2*axis\] e\[0\] + ... + gain\[2*axis + 1\] e\[1\] + r\[2\], e\[i\] = x\[i\] - r\[i\].
    pub gain: [f64; 8],
    /// g.
    pub input_gain: [f64; 4],
    /// bound of |u| of each axis.
    pub u_max: [f64; 4],
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
impl Quadrotor {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: QuadrotorParams) -> Result<Self, Error> {
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
        let deadline = t0 + 2.0;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (2.0 - v1);
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
    pub fn tick(&self, t: f64) -> Result<QuadrotorGains, Error> {
        if !(t.is_finite() && (t >= self.t0)) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.02 { past } else { -0.02 };
        let inv_T = (-1.0) / late;
        let v1 = (-20.0) * inv_T * inv_T;
        let v2 = (-8.0) * inv_T;
        let v3 = (-42.0) * inv_T * inv_T;
        let v4 = (-12.0) * inv_T;
        let status = if late < -0.02 {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(QuadrotorGains {
            gain: [v1, v2, v3, v4, v3, v4, v1, v2],
            input_gain: [
                0.8333333333333334,
                83.33333333333333,
                76.92307692307692,
                45.45454545454545,
            ],
            u_max: [8.0, 0.4, 0.4, 0.1],
            status,
        })
    }

    /// u of 4 axes at time t \[s\], from the state x = (x1, x1', ...) and the reference r = (r, r',
    /// ...) of each. Its status is that of the first axis that fails, and then every u is 0; else
    /// SATURATED where an axis is.
    #[inline]
    pub fn step(&self, t: f64, x: &[[f64; 2]; 4], r: &[[f64; 3]; 4]) -> Axes<4, f64> {
        let failed = |error| Axes {
            u: [0.0; 4],
            axes: [Err(error); 4],
            status: Err(error),
        };
        let mut u = [0.0; 4];
        let mut axes = [Ok(Status::Ok); 4];
        let mut status;
        if !(t.is_finite() && (t >= self.t0)) {
            return failed(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.02 { past } else { -0.02 };
        let inv_T = (-1.0) / late;
        let v1 = (-20.0) * inv_T * inv_T;
        let v2 = (-8.0) * inv_T;
        let v3 = (-42.0) * inv_T * inv_T;
        let v4 = (-12.0) * inv_T;
        let mut gain = [0.0; 8];
        gain[0] = v1;
        gain[1] = v2;
        gain[2] = v3;
        gain[3] = v4;
        gain[4] = v3;
        gain[5] = v4;
        gain[6] = v1;
        gain[7] = v2;
        let mut input_gain = [0.0; 4];
        input_gain[0] = 0.8333333333333334;
        input_gain[1] = 83.33333333333333;
        input_gain[2] = 76.92307692307692;
        input_gain[3] = 45.45454545454545;
        let mut u_max = [0.0; 4];
        u_max[0] = 8.0;
        u_max[1] = 0.4;
        u_max[2] = 0.4;
        u_max[3] = 0.1;
        if late < -0.02 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        let mut wanted = [0.0; 4];
        for axis in 0..4 {
            let e1 = x[axis][0] - r[axis][0];
            let e2 = x[axis][1] - r[axis][1];
            let v5 = (gain[2 * axis] * e1) + (gain[(2 * axis) + 1] * e2) + r[axis][2];
            let g = input_gain[axis];
            wanted[axis] = if g < 0.0 || g > 0.0 { v5 / g } else { f64::NAN };
        }
        u[0] = wanted[0];
        u[1] = wanted[1];
        u[2] = wanted[2];
        u[3] = wanted[3];
        for axis in 0..4 {
            axes[axis] = status;
        }
        let mut outside = 0_u32;
        for axis in 0..4 {
            let v = wanted[axis];
            if !(v.is_finite() && (v.abs() <= u_max[axis])) {
                outside = 1;
                break;
            }
        }
        if outside == 1 {
            for axis in 0..4 {
                let v = wanted[axis];
                if !(v.is_finite() && (v.abs() <= u_max[axis])) {
                    if x[axis][0].is_finite()
                        && x[axis][1].is_finite()
                        && r[axis][0].is_finite()
                        && r[axis][1].is_finite()
                        && r[axis][2].is_finite()
                    {
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
                for axis in 0..4 {
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
impl QuadrotorGains {
    /// u of one axis from its state x = (x1, x1', ...), its reference r = (r, r', ...) and the
    /// gains.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn axis(&self, axis: u32, x: &[f64; 2], r: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(axis < 4) {
            return Err(Error::Input);
        }
        let e1 = x[0] - r[0];
        let e2 = x[1] - r[1];
        let s1 = self.gain[2 * axis as usize] * e1;
        let v1 = s1 + (self.gain[2 * axis as usize + 1] * e2) + r[2];
        let g = self.input_gain[axis as usize];
        let v = if g < 0.0 || g > 0.0 { v1 / g } else { f64::NAN };
        let (u, status) = if v.is_finite() && (v.abs() <= self.u_max[axis as usize]) {
            (v, self.status)
        } else if x[0].is_finite()
            && x[1].is_finite()
            && r[0].is_finite()
            && r[1].is_finite()
            && r[2].is_finite()
        {
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
