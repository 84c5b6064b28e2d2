//! Prescribed-time controller stage50: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage50 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --tau=0.2 --eps=0 --poles="least-energy(weight=1)" --reference input --sample-time=0.01
//! Version 0.1.0, design e09f892711c5.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
//!       sum of u^2/M. The gains are a table of 320 bytes: a row for each of them. The gains
//!       of 2 samples to go stay: they are deadbeat.
//! With the reference r with its derivatives r[0]..r[1] at tick k, x - x_r is in place of x
//!       above, and u = w + u_r: with them the output y = -2*x1 + x2 is r, and stays so. At
//!       sample N x = x_r where u_r is constant over each sample; else an error of order
//!       h^(4-i) is left in y^(i-1).
//! r[2] is r^(2) over the sample in which u acts: its mean, (r^(1)(t + h) - r^(1)(t))/h, or
//!       that in its middle. u_r is the mean over that sample. To four digits, the last at one
//!       time:
//!   x_r1 = -1.333*r - 0.3333*r^(1)
//!   x_r2 = -1.667*r - 0.6667*r^(1)
//!   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
//!
//! Parameters:
//!   samples = 20 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 20 from any state, but for what r does between samples,
//!       and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: it does not examine a clock in samples.
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

/// Run-time parameters of [`Stage50`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage50Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage50 {
    /// tick at which it was armed.
    start: u32,
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
impl Stage50 {
    /// Samples from the start to rest.
    const SAMPLES: u32 = 20;

    /// Gains of least energy of each state, a row for the samples to go of a node.
    #[rustfmt::skip]
    const GAINS: &'static [[f64; 2]; 20] = &[
        [-6519.426971737549, 3185.2084972182897],
        [-3857.2972468681514, 1869.370005740587],
        [-2535.8123523502322, 1218.7874484331383],
        [-1786.1499004408652, 851.2162504195531],
        [-1321.0288432240525, 624.1015587650261],
        [-1013.2253140462395, 474.4353779733671],
        [-799.355679292144, 370.8885689114117],
        [-644.9715751559836, 296.46788779068544],
        [-530.0507637726341, 241.31624608777554],
        [-442.31657026726884, 199.40198143585195],
        [-373.9055837746926, 166.86960699606502],
        [-319.59468864669316, 141.16347188259604],
        [-275.80616425447823, 120.53665432938753],
        [-240.02385825378445, 103.76315424562416],
        [-210.4372644374064, 89.96267023338274],
        [-185.7172734991974, 78.4903488691879],
        [-164.8707644351536, 68.86539241539502],
        [-147.1439010804336, 60.72364441333584],
        [-131.95635856841344, 53.785384714229195],
        [-118.85567957234355, 47.83301161237331],
    ];

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage50Params) -> Result<Self, Error> {
        if !(params.u_max > 0.0) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        Ok(Self { start: 0, u_max })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x, and the reference.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f64; 2], r: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite()
            && x[1].is_finite()
            && r[0].is_finite()
            && r[1].is_finite()
            && r[2].is_finite())
        {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];

        // The tracking error.
        let s1 = (0.3333333333333333 * r[0]) - (0.9983333333333333 * r[1]);
        let u_r = s1 - (0.3383277777777778 * r[2]);
        let e1 = x1 - (((-1.3333333333333333) * r[0]) - (0.3333333333333333 * r[1]));
        let e2 = x2 - (((-1.6666666666666667) * r[0]) - (0.6666666666666666 * r[1]));
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let to_go: u32;
        if left > 2 {
            to_go = left;
        } else {
            to_go = 2;
        }
        let row = to_go.wrapping_sub(2);

        // The law of least energy.
        let v: f64;
        v = (Self::GAINS[row as usize][0] * e1) + (Self::GAINS[row as usize][1] * e2) + u_r;
        let (u, status) = if v.is_finite() {
            if v > self.u_max {
                (self.u_max, Status::Saturated)
            } else if v < -self.u_max {
                (-self.u_max, Status::Saturated)
            } else if elapsed < Self::SAMPLES {
                (v, Status::Ok)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
