//! Prescribed-time controller ptc_rational_inputs4: outputs of order 1, 1, 1, 1, mapping rational.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros
//! Version 0.1.0, design d53160516d12.
//!
//! Plant, with the inputs a, b, c, d: p' = sin(q)*b + 3*c + r*d, q' = 2*a + p*b + m*d + p*r,
//!       r' = r*a + (3 + q^2)*b + s*c, s' = a - p*c + 4*d, output 1 = p, output 2 = q, output
//!       3 = r, output 4 = s. Time in s.
//! Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
//!       up to the error that the hold at eps, sampling, what differs from the model and
//!       clipping leave. The checks below say what is known of this design.
//! The law takes the plant to be the model. What differs from it is not part of the law.
//! Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
//!       input of this number.
//!
//! SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
//!       is stable. Run the emitted step with a model of the plant, sampled.
//!
//! Parameters:
//!   tau: prescribed settling time [s], from 1e-150 to 1e150
//!   t0: start time [s], finite
//!   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
//!   u_max: bound of |u| [unit of u], > 0, infinity allowed
//!   a: rate of stretched time [1/s], from 1e-150 to 1e150
//!   k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
//!   m: parameter of the model, finite
//!
//! Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
//!       the stretched time since t0:
//!   mu(t)     = tau*a*t/(1 + a*t)
//!   kappa(Dt) = Dt/(a*T)
//! Derivatives r_k = mu^(k)(kappa(Dt)):
//!   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
//!   r_1 = tau^-1*a*T^2
//! Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
//!   B_{0,0} = 1
//!
//! Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
//!   pi0 = -k_1 xi_1
//!   gain_j = inv_T_squared^(n+1-j) row_j
//!   K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
//!   row_1 = -K1
//!   inv_T_squared = 1/T^2
//! Output 1, of order n = 1:
//!   x_1 = p
//! Output 2, of order n = 1:
//!   x_1 = q
//!   f_2 = p*r
//! Output 3, of order n = 1:
//!   x_1 = r
//! Output 4, of order n = 1:
//!   x_1 = s
//! u of D u = w with w_i = v_i - f_i, by elimination with pivots:
//!   D = [[0, sin(q), 3, r], [2, p, 0, m], [r, 3 + q^2, s, 0], [1, 0, -p, 4]]
//!
//! From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
//!       deadline.
//! Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: rational is of class M for all its parameters.
//!   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
//!   sampling: not checked: `sample_time` is not given.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: it needs a value of `tau`.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degrees are 1, 1, 1, 1, whose sum is the number of
//!       states.
//!
//! Operations of one step, without input checks and clipping: 38 additions or comparisons, 33
//!       multiplications, 14 divisions, 1 function call.
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

/// Run-time parameters of [`PtcRationalInputs4`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcRationalInputs4Params {
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
    /// gains of pi0 = -k_1 xi_1, finite; k\[0\] is k_1 \[1/s\].
    pub k: [f64; 1],
    /// parameter of the model, finite.
    pub m: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PtcRationalInputs4 {
    /// prescribed settling time.
    tau: f64,
    /// coefficient of x1, axis 1.
    c1_axis1: f64,
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
    /// parameter of an expression of the design.
    p_m: f64,
    /// bound of |u|.
    u_max: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl PtcRationalInputs4 {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PtcRationalInputs4Params) -> Result<Self, Error> {
        let tau = params.tau;
        let t0 = params.t0;
        let eps = params.eps;
        let u_max = params.u_max;
        let a = params.a;
        let k1 = params.k[0];
        let p_m = params.m;
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
            && p_m.is_finite()
            && (eps < tau))
        {
            return Err(Error::Param);
        }
        let rate_axis1 = a / tau;
        let K1_axis1 = k1 / rate_axis1;
        let c1_axis1 = -K1_axis1;
        let hold_from = -eps;
        let size_K1_axis1 = if k1.abs() <= 0.0 {
            1e-200
        } else {
            K1_axis1.abs()
        };
        let size_p_m = if p_m.abs() <= 0.0 { 1e-200 } else { p_m.abs() };
        if !((size_K1_axis1 >= 1e-200)
            && (size_p_m >= 1e-200)
            && c1_axis1.is_finite()
            && hold_from.is_finite())
        {
            return Err(Error::Param);
        }
        let mut built = Self {
            tau,
            c1_axis1,
            eps,
            hold_from,
            p_m,
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

    /// u = (a, b, c, d) at time t \[s\] and state x = (p, q, r, s). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 4]) -> Axes<4, f64> {
        let failed = |error| Axes {
            u: [0.0; 4],
            axes: [Err(error); 4],
            status: Err(error),
        };
        let mut u = [0.0; 4];
        let mut axes = [Ok(Status::Ok); 4];
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
        let late = if past < self.hold_from {
            past
        } else {
            self.hold_from
        };
        let v1 = late * late;
        let wanted_axis1 = (self.c1_axis1 * x1) / v1;
        let drift_axis2 = x1 * x3;
        let wanted_axis2 = ((self.c1_axis1 * x2) / v1) - drift_axis2;
        let wanted_axis3 = (self.c1_axis1 * x3) / v1;
        let wanted_axis4 = (self.c1_axis1 * x4) / v1;
        let given_inputs = [wanted_axis1, wanted_axis2, wanted_axis3, wanted_axis4];
        let inputs_a = [
            0.0,
            math::sin(x2),
            3.0,
            x3,
            2.0,
            x1,
            0.0,
            self.p_m,
            x3,
            3.0 + (x2 * x2),
            x4,
            0.0,
            1.0,
            0.0,
            -x1,
            4.0,
        ];
        let inputs = Self::eliminate(given_inputs, inputs_a);
        let control1 = inputs[0];
        let control2 = inputs[1];
        let control3 = inputs[2];
        let control4 = inputs[3];
        if late < self.hold_from {
            status = Ok(Status::Ok);
        } else {
            status = Ok(Status::Hold);
        }
        if control1.is_finite()
            && control2.is_finite()
            && control3.is_finite()
            && control4.is_finite()
        {
            u[0] = control1;
            axes[0] = status;
            u[1] = control2;
            axes[1] = status;
            u[2] = control3;
            axes[2] = status;
            u[3] = control4;
            axes[3] = status;
            if control1 > self.u_max {
                u[0] = self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control1 < -self.u_max {
                u[0] = -self.u_max;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control2 > self.u_max {
                u[1] = self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control2 < -self.u_max {
                u[1] = -self.u_max;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control3 > self.u_max {
                u[2] = self.u_max;
                axes[2] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control3 < -self.u_max {
                u[2] = -self.u_max;
                axes[2] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if control4 > self.u_max {
                u[3] = self.u_max;
                axes[3] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if control4 < -self.u_max {
                u[3] = -self.u_max;
                axes[3] = Ok(Status::Saturated);
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
            u[2] = 0.0;
            if control3.is_finite() {
                axes[2] = status;
            } else {
                axes[2] = Err(Error::Range);
            }
            u[3] = 0.0;
            if control4.is_finite() {
                axes[3] = status;
            } else {
                axes[3] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }

    /// Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
    /// becomes x, NaN where a is singular.
    fn eliminate(mut b: [f64; 4], mut a: [f64; 16]) -> [f64; 4] {
        for k in 0..4 {
            let mut most = k;
            let mut largest = (a[(4 * k) + k]).abs();
            for i in k + 1..4 {
                let size = (a[(4 * i) + k]).abs();
                if largest < size {
                    largest = size;
                    most = i;
                }
            }
            for i in k + 1..4 {
                if most == i {
                    let kept = b[k];
                    b[k] = b[i];
                    b[i] = kept;
                    for j in k..4 {
                        let entry = a[(4 * k) + j];
                        a[(4 * k) + j] = a[(4 * i) + j];
                        a[(4 * i) + j] = entry;
                    }
                }
            }
            a[(4 * k) + k] = if a[(4 * k) + k] < 0.0 || a[(4 * k) + k] > 0.0 {
                a[(4 * k) + k]
            } else {
                f64::NAN
            };
            for i in k + 1..4 {
                let factor = a[(4 * i) + k] / a[(4 * k) + k];
                for j in k + 1..4 {
                    a[(4 * i) + j] = a[(4 * i) + j] - (factor * a[(4 * k) + j]);
                }
                b[i] = b[i] - (factor * b[k]);
            }
        }
        for k in (0..4).rev() {
            for j in k + 1..4 {
                b[k] = b[k] - (a[(4 * k) + j] * b[j]);
            }
            b[k] = b[k] / a[(4 * k) + k];
        }
        b
    }
}
