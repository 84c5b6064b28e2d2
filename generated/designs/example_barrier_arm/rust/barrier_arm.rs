//! Prescribed-time controller barrier_arm: outputs of order 2, 2, mapping rational.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "rational(a=1/20)" --name barrier_arm --tau=20 --eps=1 --limits=120,60 --pi0="inverse_inertia_1_1*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 - (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_1_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 - (xi1_2/b2)^2) - d*xi2_2), inverse_inertia_1_2*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 - (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_2_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 - (xi1_2/b2)^2) - d*xi2_2)" --states="q1, q2, w1, w2" --inputs=M1,M2 --inertia="[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]" --bias="-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)" --param b1=1.2 --param b2=0.8 --param d=4 --param grav=9.81 --param h=0.45 --param k=3 --param l1=0.6 --param l2=0.5 --param m1=2 --param m2=1.5
//! Version 0.1.0, design 13fc70a766af.
//!
//! Plant, with the inputs M1, M2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[(m1 +
//!       m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 +
//!       m2*l1*l2*cos(q2), m2*l2^2]], bias = [-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 +
//!       m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 +
//!       m2*grav*l2*cos(q1 + q2)]. Time in s.
//! Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
//!       up to the error that the hold at eps, sampling, what differs from the model and
//!       clipping leave. The checks below say what is known of this design.
//! The law takes the plant to be the model. What differs from it is not part of the law.
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: u_max = 120
//!   output 2: u_max = 60
//!
//! SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
//!       is stable. Run the emitted step with a model of the plant, sampled.
//!
//! Parameters:
//!   tau = 20 [s], fixed: prescribed settling time
//!   eps = 1 [s], fixed: time-to-go at which the gains are held
//!   a = 1/20 [1/s], fixed: rate of stretched time
//!   b1 = 1.2, fixed: parameter of pi0
//!   b2 = 0.8, fixed: parameter of pi0
//!   d = 4, fixed: parameter of pi0
//!   grav = 9.81, fixed: parameter of the model
//!   h = 0.45, fixed: parameter of pi0
//!   k = 3, fixed: parameter of pi0
//!   l1 = 0.6, fixed: parameter of pi0 and the model
//!   l2 = 0.5, fixed: parameter of pi0 and the model
//!   m1 = 2, fixed: parameter of pi0 and the model
//!   m2 = 1.5, fixed: parameter of pi0 and the model
//!   t0: start time [s], finite
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*a*t/(1 + a*t)
//!   kappa(Dt) = Dt/(a*T)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
//!   r_1 = tau^-1*a*T^2
//!   r_2 = -2*tau^-2*a^2*T^3
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!   B_{1,1} = tau^-1*a*T^2
//!   B_{2,1} = -2*tau^-2*a^2*T^3
//!
//! Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
//!   pi0 of v_1 = inverse_inertia_1_1*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 -
//!       (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_1_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 -
//!       (xi1_2/b2)^2) - d*xi2_2)
//!   pi0 of v_2 = inverse_inertia_1_2*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 -
//!       (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_2_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 -
//!       (xi1_2/b2)^2) - d*xi2_2)
//!   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
//!   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
//! Output 1, of order n = 2:
//!   x_1 = q1
//!   x_2 = w1
//! Output 2, of order n = 2:
//!   x_1 = q2
//!   x_2 = w2
//! u = M v + bias
//!
//! From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: rational is of class M for all its parameters.
//!   growth: not checked: the law is not a sum of gains, so its poles are not known.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a linear law.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
//!
//! Operations of one step, without input checks and clipping: 29 additions or comparisons, 52
//!       multiplications, 5 divisions, 4 function calls.
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

/// From `std`, or from the crate `libm` where the feature of that name is on.
#[allow(unexpected_cfgs)]
mod math {
    #[inline]
    pub fn sin(a: f64) -> f64 {
        #[cfg(feature = "libm")]
        {
            libm::sin(a)
        }
        #[cfg(not(feature = "libm"))]
        {
            a.sin()
        }
    }

    #[inline]
    pub fn cos(a: f64) -> f64 {
        #[cfg(feature = "libm")]
        {
            libm::cos(a)
        }
        #[cfg(not(feature = "libm"))]
        {
            a.cos()
        }
    }
}

/// Run-time parameters of [`BarrierArm`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct BarrierArmParams {
    /// start time \[s\], finite.
    pub t0: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct BarrierArm {
    /// start time.
    t0: f64,
    /// t0 + tau, rounded.
    deadline: f64,
    /// low part of t0 + tau (compensated sum).
    correction: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl BarrierArm {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: BarrierArmParams) -> Result<Self, Error> {
        let t0 = params.t0;
        if !t0.is_finite() {
            return Err(Error::Param);
        }
        let mut built = Self {
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
        let deadline = t0 + 20.0;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (20.0 - v1);
        if !deadline.is_finite() {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

    /// u = (M1, M2) at time t \[s\] and state x = (q1, q2, w1, w2). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 4]) -> Axes<2, f64> {
        let failed = |error| Axes {
            u: [0.0; 2],
            axes: [Err(error); 2],
            status: Err(error),
        };
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let x4 = x[3];
        if !(t.is_finite()
            && (t >= self.t0)
            && x1.is_finite()
            && x2.is_finite()
            && x3.is_finite()
            && x4.is_finite())
        {
            return failed(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -1.0 { past } else { -1.0 };
        let T_axis1 = -late;
        let unit_axis1 = (0.05 * T_axis1) / 20.0;
        let v1 = T_axis1 * unit_axis1;
        let inv_r1_axis1 = 1.0 / v1;
        let xi2_axis1 = x3 * v1;
        let xi2_axis2 = x4 * v1;
        let v2 = math::cos(x2);
        let v3 = 1.635 + (0.8999999999999999 * v2);
        let v4 = 0.375 + (0.44999999999999996 * v2);
        let v5 = 1.0 / ((v3 * 0.375) - (v4 * v4));
        let v6 = math::sin(x2);
        let v7 = x1 * 0.8333333333333334;
        let s1 = (2.0 * xi2_axis1 * xi2_axis2) + (xi2_axis2 * xi2_axis2);
        let s2 = (0.45 * v6 * s1) - ((3.0 * x1) / (1.0 - (v7 * v7)));
        let v8 = s2 - (4.0 * xi2_axis1);
        let v9 = (-v4) * v5;
        let v10 = x2 * 1.25;
        let s3 = (-0.45) * v6 * (xi2_axis1 * xi2_axis1);
        let v11 = (s3 - ((3.0 * x2) / (1.0 - (v10 * v10)))) - (4.0 * xi2_axis2);
        let law_axis1 = (0.375 * v5 * v8) + (v9 * v11);
        let v12 = (-2.0) * (-unit_axis1);
        let wanted_axis1 = ((law_axis1 * inv_r1_axis1) + (v12 * x3)) * inv_r1_axis1;
        let law_axis2 = (v9 * v8) + (v3 * v5 * v11);
        let wanted_axis2 = ((law_axis2 * inv_r1_axis1) + (v12 * x4)) * inv_r1_axis1;
        let v13 = 7.3575 * math::cos(x1 + x2);
        let s4 = (-0.44999999999999996) * v6 * ((2.0 * x3 * x4) + (x4 * x4));
        let s5 = (v3 * wanted_axis1) + (v4 * wanted_axis2);
        let control1 = s5 + (s4 + (20.601 * math::cos(x1)) + v13);
        let s6 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
        let control2 = s6 + ((0.44999999999999996 * v6 * (x3 * x3)) + v13);
        if late < -1.0 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite() && control2.is_finite() {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            if control1 > 120.0 {
                u[0] = 120.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -120.0 {
                u[0] = -120.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > 60.0 {
                u[1] = 60.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -60.0 {
                u[1] = -60.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
        } else {
            u[0] = 0.0;
            if control1.is_finite() {
                axes[0] = status;
            } else {
                axes[0] = Err(Error::Range);
            }
            u[1] = 0.0;
            if control2.is_finite() {
                axes[1] = status;
            } else {
                axes[1] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }
}
