//! Prescribed-time controller pendulum: order n = 2, mapping exp.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name pendulum --tau=0.8 --eps=6.00e-3 --u-max=25 --poles=-3,-4 --states="q, w" --input=M --output="q" --dynamics="w, (M - drag*w)/(m*l^2) - grav/l*sin(q)" --param drag=0.02 --param grav=9.81 --param l=0.5 --param m=1 --sample-time=1e-3 --noise=1e-4,1e-3
//! Version 0.1.0, design d3c8a839e63d.
//!
//! Plant, with the input M: q' = w, w' = (M - drag*w)/(m*l^2) - grav/l*sin(q), output q. Time
//!       in s.
//! Goal: the output and its rate, x, are 0 at the deadline t0 + tau from any state at t0, up
//!       to the error that the hold at eps, sampling, what differs from the model and clipping
//!       leave. The checks below say what is known of this design.
//! The law takes the plant to be the model. What differs from it is not part of the law.
//!
//! Parameters:
//!   tau = 0.8 [s], fixed: prescribed settling time
//!   eps = 6.00e-3 [s], fixed: time-to-go at which the gains are held
//!   u_max = 25 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 12 [1/s^2], fixed: gain of xi_1
//!   k_2 = 7 [1/s], fixed: gain of xi_2
//!   drag = 0.02, fixed: parameter of the model
//!   grav = 9.81, fixed: parameter of the model
//!   l = 0.5, fixed: parameter of the model
//!   m = 1, fixed: parameter of the model
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
//! Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
//!   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
//!   pi0 = -(k_1 xi_1 + k_2 xi_2)
//!   x_1 = q
//!   x_2 = w
//!   f = -(drag*w)/(m*l^2) - grav/l*sin(q)
//!   g = 1/(l^2*m)
//!   u = (sum_j gain_j x_j - f)/g
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
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
//!       mathematical library.
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: x and u go to 0 at the deadline.
//!   sampling: undecided: f is cancelled at the samples alone; with f = 0: eps = 0.006 s is 2
//!       times the minimum for a period of 0.001 s.
//!   deadline: not checked: `error` is not given.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: `x_max` is not given.
//!   zeros: sound: none: the relative degree is 2, the number of states.
//!
//! Operations of one step, without input checks and clipping: 6 additions or comparisons, 6
//!       multiplications, 1 division, 1 function call.
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

/// Run-time parameters of [`Pendulum`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PendulumParams {
    /// start time \[s\], finite.
    pub t0: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Pendulum {
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
impl Pendulum {
    /// Takes the parameters and arms at `params.t0` (or the fixed t0).
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PendulumParams) -> Result<Self, Error> {
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
        let deadline = t0 + 0.8;
        let v1 = deadline - t0;
        let correction = (t0 - (deadline - v1)) + (0.8 - v1);
        if !deadline.is_finite() {
            return Err(Error::Param);
        }
        self.t0 = t0;
        self.deadline = deadline;
        self.correction = correction;
        Ok(())
    }

    /// u at time t \[s\] and state x = (q, w).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        let x1 = x[0];
        if !((t >= self.t0) && x1.is_finite()) {
            return Err(Error::Input);
        }
        let past = (t - self.deadline) - self.correction;
        let late = if past < -0.006 { past } else { -0.006 };
        let inv_T = (-1.0) / late;
        let drift = ((-4.905) * math::sin(x1)) - (0.02 * x[1]);
        let v = ((((-3.0) * x1 * inv_T) + ((-1.5) * x[1])) * inv_T) - drift;
        let (u, status) = if v.is_finite() && (v.abs() <= 25.0) && (late < -0.006) {
            (v, Status::Ok)
        } else if t.is_finite() && x[1].is_finite() {
            if v.is_finite() {
                if v > 25.0 {
                    (25.0, Status::Saturated)
                } else if v < -25.0 {
                    (-25.0, Status::Saturated)
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
}

impl Controller<2> for Pendulum {
    type Real = f64;

    fn arm(&mut self, t0: f64) -> Result<(), Error> {
        Self::arm(self, t0)
    }

    fn step(&self, t: f64, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        Self::step(self, t, x)
    }
}
