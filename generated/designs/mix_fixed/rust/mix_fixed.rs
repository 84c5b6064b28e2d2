//! Prescribed-time controller mix_fixed: outputs of order 2, 1, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu "exp(a=1)" --name mix_fixed --guard result --tau=1 --eps=1e-2 --limits=40,15 --poles="[[-4,-5],[-3]]" --states="p, v, h" --inputs=a,b --outputs="p, h" --dynamics="v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"
//! Version 0.1.0, design 63889dce100a.
//!
//! Plant, with the inputs a, b: p' = v, v' = -v + (2 + sin(p))*a + h*b, h' = v*h + h*a + (2 +
//!       h^2)*b, output 1 = p, output 2 = h. Time in s.
//! Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
//!       up to the error that the hold at eps, sampling, what differs from the model and
//!       clipping leave. The checks below say what is known of this design.
//! The law takes the plant to be the model. What differs from it is not part of the law.
//! Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!   output 1: k = 20, 9; u_max = 40
//!   output 2: k = 3; u_max = 15
//!
//! SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
//!       is stable. Run the emitted step with a model of the plant, sampled.
//!
//! Parameters:
//!   tau = 1 [s], fixed: prescribed settling time
//!   eps = 1e-2 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
//!   t0: start time [s], finite
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
//! Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
//! Order n = 1:
//!   pi0 = -k_1 xi_1
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   inv_T = 1/T
//! Order n = 2:
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   gain_j = inv_T^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/a^(n+1-i)
//!   row_1 = -K1
//!   row_2 = 1 - K2
//!   inv_T = 1/T
//! Output 1, of order n = 2:
//!   x_1 = p
//!   x_2 = v
//!   f_1 = -v
//! Output 2, of order n = 1:
//!   x_1 = h
//!   f_2 = v*h
//! u = adj(D) w/det(D) with w_i = v_i - f_i:
//!   det(D) = (2 + sin(p))*(2 + h^2) - h*h
//!   adj(D) = [[2 + h^2, -h], [-h, 2 + sin(p)]]
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard result: t or x that is not finite is refused by one test on u (RANGE). t >= t0 is the
//!       responsibility of the caller.
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: x and u go to 0 at the deadline.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: `sample_time` is not given.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
//!
//! Operations of one step, without input checks and clipping: 13 additions or comparisons, 15
//!       multiplications, 2 divisions, 1 function call.
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
}

/// Run-time parameters of [`MixFixed`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct MixFixedParams {
    /// start time \[s\], finite.
    pub t0: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct MixFixed {
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
impl MixFixed {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: MixFixedParams) -> Result<Self, Error> {
        let t0 = params.t0;
        if !t0.is_finite() {
            return Err(Error::Param);
        }
        let mut built = Self {
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
        let deadline = t0 + 1.0;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (1.0 - v1);
        if !deadline.is_finite() {
            return Err(Error::Param);
        }
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

    /// u = (a, b) at time t \[s\] and state x = (p, v, h). Where one of them is not finite, as at a
    /// state at which the inputs do not decouple the outputs, every u is 0; else the status is
    /// SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 3]) -> Axes<2, f64> {
        let mut u = [0.0; 2];
        let mut axes = [Ok(Status::Ok); 2];
        let mut status;
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.01 { past } else { -0.01 };
        let inv_T_axis1 = (-1.0) / late;
        let drift_axis1 = -x2;
        let s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1;
        let wanted_axis1 = s1 - drift_axis1;
        let drift_axis2 = x2 * x3;
        let wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2;
        let v1 = 2.0 + math::sin(x1);
        let v2 = x3 * x3;
        let v3 = 2.0 + v2;
        let determinant = (v1 * v3) - v2;
        let over_determinant = if determinant < 0.0 || determinant > 0.0 {
            1.0 / determinant
        } else {
            f64::NAN
        };
        let v4 = -x3;
        let s2 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
        let control1 = s2 + (t - t);
        let s3 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
        let control2 = s3 + (t - t);
        if late < -0.01 {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite() && control2.is_finite() {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            if control1 > 40.0 {
                u[0] = 40.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -40.0 {
                u[0] = -40.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > 15.0 {
                u[1] = 15.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -15.0 {
                u[1] = -15.0;
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
