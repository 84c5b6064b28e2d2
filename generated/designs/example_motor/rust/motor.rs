//! Prescribed-time controller motor: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles=-4,-5,-6,-7 --sample-time=1e-3 --delay=1 --sensor-step=6e-6
//! Version 0.1.0, design c4f0b0da5e5e.
//!
//! Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
//!       sample to sample, one sample late, y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
//!       row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
//!       the mapping exp. The gains of 20 samples to go stay.
//!
//! Parameters:
//!   samples = 400 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   u_max = 24 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 150 after the start on where the measurement is; with
//!       noise or sensor_step given, or observer_eps, the gains of the observer are then held
//!       below deadbeat.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 400, not at rest: the gains are held from 20 samples
//!       to go, and |u| is bounded; so does what the held observer leaves of its error.
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

/// Run-time parameters of [`Motor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct MotorParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Motor {
    /// tick at which it was armed.
    start: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// prediction of x1 without u.
    x1_next: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// prediction of x2 without u.
    x2_next: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// prediction of x3 without u.
    x3_next: f64,
    /// estimate of d.
    d_hat: f64,
    /// prediction of d without u.
    d_next: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Motor {
    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: MotorParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            x3_hat: 0.0,
            x3_next: 0.0,
            d_hat: 0.0,
            d_next: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_next).abs() + (self.x2_next).abs();
        let size = s1 + (self.x3_next).abs() + (self.d_next).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.x3_hat = 0.0;
            self.x3_next = 0.0;
            self.d_hat = 0.0;
            self.d_next = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f64;
        let x2: f64;
        let x3: f64;
        let d: f64;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            x3 = 0.0;
            d = 0.0;
        } else {
            x1 = self.x1_next + (0.00010816330676811052 * self.u2);
            x2 = self.x2_next + (0.30941358230147875 * self.u2);
            x3 = self.x3_next + (0.37459048481653323 * self.u2);
            d = self.d_next;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let off1 = miss1;
        let left_o = 150_u32.saturating_sub(elapsed);
        let o0 = if (left_o as f64) < 40.0 {
            40.0
        } else {
            left_o as f64
        };
        let l1: f64;
        let l2: f64;
        let l3: f64;
        let l4: f64;
        let r0 = 1.0 / o0;
        let r1 = 1.0 / (o0 - 1.0);
        let r2 = 1.0 / (o0 - 2.0);
        let r3 = 1.0 / (o0 - 3.0);
        let s1 = (((((((-96.0) * r0) + 96.0) * r1) - 48.0) * r2) + 16.0) * r3;
        l1 = s1 - 0.46857164949780494;
        let s2 = ((859382.9277311233 * r0) - 513847.60335174634) * r1;
        let s3 = (((s2 + 125558.23800330989) * r2) - 9808.939721535125) * r3;
        l2 = s3 + 264.4187821124759;
        let s4 = (((-620544.0922410007) * r0) + 289368.54342637886) * r1;
        let s5 = (((s4 - 49493.69520132396) * r2) + 3680.3758886140504) * r3;
        l3 = s5 - 98.64522377262374;
        l4 = 42644.35104284018 * r0 * r1 * r2 * r3;
        let s6 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
        let x1_on = s6 + (0.00010816330676811052 * d) + (l1 * off1);
        let s7 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
        let x2_on = s7 + (0.30941358230147875 * d) + (l2 * off1);
        let s8 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
        let x3_on = s8 + (0.37459048481653323 * d) + (l3 * off1);
        let d_on = d + (l4 * off1);
        let left = 400_u32.saturating_sub(elapsed);
        let m0 = if (left as f64) < 20.0 {
            20.0
        } else {
            left as f64
        };
        let v: f64;

        // The exact law in samples.
        let s9 = ((-1492552.2864994062) * x1) + (1567.1688802442739 * x2);
        let z1 = s9 - (863.5135156573022 * x3);
        let z2 = ((-853.121915155696) * x2) + (704.6828966771754 * x3);
        let z3 = (0.10681268759856057 * x2) - (320.4380627956817 * x3);
        let s10 = (0.4798607068523099 * x2) + (19.61787944307025 * x3);
        let z4 = s10 - (16.0 * (self.u1 + d));
        let s11 = ((((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0)) + z3) / (m0 + 1.0);
        let s12 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3);
        let s13 = ((s11 + z4) / m0) + (s12 + (1.468571649497805 * (self.u1 + d)));
        v = s13 - d;
        if !(v.is_finite()
            && x1_on.is_finite()
            && x2_on.is_finite()
            && x3_on.is_finite()
            && d_on.is_finite())
        {
            return Err(Error::Range);
        }
        let u_now: f64;
        if 24.0 < v {
            u_now = 24.0;
        } else if v < -24.0 {
            u_now = -24.0;
        } else {
            u_now = v;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.d_hat = d;
        self.d_next = d_on;
        self.seen = 1;
        let status = if (24.0 < v) || (v < -24.0) {
            Status::Saturated
        } else if (left as f64) <= 20.0 {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
