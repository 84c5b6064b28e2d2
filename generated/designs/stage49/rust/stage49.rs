//! Prescribed-time controller stage49: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage49 --clock samples --A="[[0,1],[-4,-0.2]]" --B="[0,1]" --delay-law=extend --poles-end="least-energy(weight=2)" --end-samples=50 --precision f32 --guard none --tau=1.7 --eps=0 --poles=least-energy --gain-bytes=300 --after zero --sample-time=0.01 --delay=2
//! Version 0.1.0, design 50fbb26d547a.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 2 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
//!       sum of u^2. From 50 samples to go on it is that of u^2/(M ... (M+1)). The gains are a
//!       table of 224 bytes: exact below 8 samples to go, and before it those of a grid of 14
//!       nodes, interpolated in a line. The gains of 4 samples to go stay: they are deadbeat.
//!
//! Parameters:
//!   samples = 170 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on u = 0 (status AFTER).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard none: finite measurements are the responsibility of the caller.
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 170 from any state, and |u| is bounded.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
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

/// Run-time parameters of [`Stage49`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage49Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage49 {
    /// tick at which it was armed.
    start: u32,
    /// input of the last sample.
    u1: f32,
    /// input of 2 samples ago.
    u2: f32,
    /// bound of |u|.
    u_max: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage49 {
    /// Samples from the start to rest.
    const SAMPLES: u32 = 170;

    /// Gains of least energy of each state, a row for the samples to go of a node.
    #[rustfmt::skip]
    const GAINS: &'static [[f32; 4]; 14] = &[
        [-9986.377, -348.87903, -1.9976025, -2.9924133],
        [-5777.1006, -233.30489, -1.4711981, -2.0461898],
        [-3881.3403, -176.5856, -1.1873256, -1.5733153],
        [-2833.6228, -142.71356, -1.005122, -1.2866975],
        [-2181.0964, -120.080894, -0.8762361, -1.0928065],
        [-1018.34033, -74.13646, -0.5902821, -0.6911077],
        [-599.1994, -53.811737, -0.4494777, -0.50864094],
        [-281.46225, -34.714703, -0.30574974, -0.33338922],
        [-162.40263, -25.523401, -0.23148729, -0.2473471],
        [-72.591675, -16.511925, -0.15463428, -0.16164158],
        [-10.503921, -5.7482643, -0.0560507, -0.0570108],
        [-2.4759388, -3.1387978, -0.031095704, -0.03129342],
        [-0.2871313, -1.8002806, -0.018005349, -0.018005254],
        [-0.12725501, -0.7570639, -0.0075707315, -0.007571343],
    ];

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage49Params) -> Result<Self, Error> {
        if !(params.u_max > 0.0) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x. Call it once for each tick.
    ///
    /// # Errors
    /// `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f32; 2]) -> Result<Control<f32>, Error> {
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let to_go: u32;
        if left > 4 {
            to_go = left;
        } else {
            to_go = 4;
        }

        // Its place between the nodes of the table.
        let row: u32;
        let part: f32;
        if to_go < 8 {
            row = to_go.wrapping_sub(4);
            part = 0.0;
        } else if to_go < 16 {
            row = (to_go / 4) + 2;
            part = (0.25 * (to_go as f32)) - ((to_go / 4) as f32);
        } else if to_go < 32 {
            row = (to_go / 8) + 4;
            part = (0.125 * (to_go as f32)) - ((to_go / 8) as f32);
        } else if to_go < 64 {
            row = (to_go / 16) + 6;
            part = (0.0625 * (to_go as f32)) - ((to_go / 16) as f32);
        } else if to_go < 128 {
            row = (to_go / 32) + 8;
            part = (0.03125 * (to_go as f32)) - ((to_go / 32) as f32);
        } else {
            row = (to_go / 64) + 10;
            part = (0.015625 * (to_go as f32)) - ((to_go / 64) as f32);
        }

        // The law of least energy.
        let above = row + 1;
        let v: f32;
        let s1 = part * (Self::GAINS[above as usize][0] - Self::GAINS[row as usize][0]);
        let s2 = part * (Self::GAINS[above as usize][1] - Self::GAINS[row as usize][1]);
        let s3 = (Self::GAINS[row as usize][0] + s1) * x1;
        let s4 = part * (Self::GAINS[above as usize][2] - Self::GAINS[row as usize][2]);
        let s5 = (Self::GAINS[row as usize][2] + s4) * self.u1;
        let s6 = part * (Self::GAINS[above as usize][3] - Self::GAINS[row as usize][3]);
        let s7 = s3 + ((Self::GAINS[row as usize][1] + s2) * x2) + s5;
        v = s7 + ((Self::GAINS[row as usize][3] + s6) * self.u2);
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f32;
        if elapsed < Self::SAMPLES {
            if v > self.u_max {
                u_now = self.u_max;
            } else if v < -self.u_max {
                u_now = -self.u_max;
            } else {
                u_now = v;
            }
        } else {
            u_now = 0.0;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        let status = if elapsed < Self::SAMPLES {
            if (v > self.u_max) || (v < -self.u_max) {
                Status::Saturated
            } else {
                Status::Ok
            }
        } else {
            Status::After
        };
        Ok(Control { u: u_now, status })
    }
}
