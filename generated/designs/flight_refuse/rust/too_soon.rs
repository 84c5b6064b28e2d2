//! Prescribed-time controller too_soon: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01
//! Version 0.1.0, design 9b0d3c826af2.
//!
//! Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
//!       gains of 3 samples to go stay: they are deadbeat.
//!
//! Parameters:
//!   samples = 150 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max = 20 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
//!       so their Bernstein coefficients, linear in z, bound them. If these are within the
//!       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
//!       plant and state are as they are known.
//! late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
//!       bounded.
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

/// Run-time parameters of [`TooSoon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct TooSoonParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct TooSoon {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest, as planned now.
    last: u32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl TooSoon {
    /// Weight of x1 in the law.
    const W1_1: f32 = -120000000.0;
    /// Weight of x2 in the law.
    const W1_2: f32 = 1200000.0;
    /// Weight of x3 in the law.
    const W1_3: f32 = -4000.0;
    /// Weight of x2 in the law.
    const W2_2: f32 = -600000.0;
    /// Weight of x3 in the law.
    const W2_3: f32 = 3000.0;
    /// Weight of x3 in the law.
    const W3_3: f32 = -1200.0;
    /// Bound of |u|.
    const U_MAX: f32 = 20.0;
    /// Weight of x1 in the law.
    const S1_1: f32 = 1000000.0;
    /// Weight of x2 in the law.
    const S1_2: f32 = -10000.0;
    /// 100/3, weight of x3 in the law.
    const S1_3: f32 = 33.333332;
    /// Weight of x2 in the law.
    const S2_2: f32 = 10000.0;
    /// Weight of x3 in the law.
    const S2_3: f32 = -50.0;
    /// Weight of x3 in the law.
    const S3_3: f32 = 100.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: TooSoonParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            last: 150,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 150;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f32; 3]) -> Result<Control<f32>, Error> {
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let left = self.last.saturating_sub(elapsed);
        let m0 = if (left as f32) < 3.0 {
            3.0
        } else {
            left as f32
        };
        let v: f32;

        // The exact law in samples.
        let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2) + (Self::W1_3 * x3);
        let z2 = (Self::W2_2 * x2) + (Self::W2_3 * x3);
        let z3 = Self::W3_3 * x3;
        let m0f1 = m0 + 3.0;
        let m0f2 = m0f1 * (m0 + 2.0);
        v = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0));
        let (u, status) = if v.is_finite() {
            if v > Self::U_MAX {
                (Self::U_MAX, Status::Saturated)
            } else if v < -Self::U_MAX {
                (-Self::U_MAX, Status::Saturated)
            } else if elapsed < self.last {
                (v, Status::Ok)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. A deadline before which a limit could be exceeded is refused
    /// (E_SOON).
    ///
    /// # Errors
    /// `Param`: the number of samples is out of its range. `Input`: an argument is not finite or
    /// out of its domain. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn arm_for(&mut self, k: u32, samples: u32, x: &[f32; 3]) -> Result<(), Error> {
        if !((samples > 2) && (samples < 2147483649)) {
            return Err(Error::Param);
        }
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite()) {
            return Err(Error::Input);
        }
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2) + (Self::S1_3 * x3);
        let flat2 = (Self::S2_2 * x2) + (Self::S2_3 * x3);
        let flat3 = Self::S3_3 * x3;
        let least: f32 = 0.9949459 * (-Self::U_MAX);
        let most: f32 = 0.9949459 * Self::U_MAX;
        let most2: f32 = 0.49747294;
        let most3: f32 = 3.9797835;
        let tried = samples;
        let mut fits = 0_u32;
        let m = tried as f32;
        let power1 = m + 3.0;
        let power2 = power1 * (m + 2.0);
        let power3 = power2 * (m + 1.0);
        let power4 = power3 * m;
        let power5 = power4 * (m - 1.0);
        let power6 = power5 * (m - 2.0);
        let scaled2 = flat2 * power1;
        let scaled3 = flat3 * power2;
        let w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
        let w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
        let w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
        let length = m - 4.0;
        let b0_c = (((-96.0) * w1) - (720.0 * w2)) - (2880.0 * w3);
        let b1_c = ((((-24.0) * w1) - (420.0 * w2)) - (3120.0 * w3)) * length;
        let b2_l = length * length;
        let b2_c = (((-60.0) * w2) - (1080.0 * w3)) * b2_l;
        let b3_l = b2_l * length;
        let b3_c = (-120.0) * w3 * b3_l;
        let b1 = b0_c + (0.14285715 * b1_c);
        let b2 = b0_c + (0.2857143 * b1_c) + (0.04761905 * b2_c);
        let s10 = b0_c + (0.42857143 * b1_c) + (0.14285715 * b2_c);
        let b3 = s10 + (0.028571429 * b3_c);
        let s11 = b0_c + (0.5714286 * b1_c) + (0.2857143 * b2_c);
        let b4 = s11 + (0.114285715 * b3_c);
        let s12 = b0_c + (0.71428573 * b1_c) + (0.47619048 * b2_c);
        let b5 = s12 + (0.2857143 * b3_c);
        let s13 = b0_c + (0.85714287 * b1_c) + (0.71428573 * b2_c);
        let b6 = s13 + (0.5714286 * b3_c);
        let b7 = b0_c + b1_c + b2_c + b3_c;
        let s0_c = (((-0.036) * w1) - (0.12 * w2)) - (0.252 * w3);
        let s1_c = ((((-0.0242) * w1) - (0.124 * w2)) - (0.3954 * w3)) * length;
        let s2_l = length * length;
        let s2_c = ((((-0.0054) * w1) - (0.0475 * w2)) - (0.2415 * w3)) * s2_l;
        let s3_l = s2_l * length;
        let s3_c = ((((-0.0004) * w1) - (0.008 * w2)) - (0.072 * w3)) * s3_l;
        let s4_l = s3_l * length;
        let s4_c = (((-0.0005) * w2) - (0.0105 * w3)) * s4_l;
        let s5_l = s4_l * length;
        let s5_c = (-0.0006) * w3 * s5_l;
        let s1 = s0_c + (0.11111111 * s1_c);
        let s2 = s0_c + (0.22222222 * s1_c) + (0.027777778 * s2_c);
        let s14 = s0_c + (0.33333334 * s1_c) + (0.083333336 * s2_c);
        let s3 = s14 + (0.011904762 * s3_c);
        let s15 = s0_c + (0.44444445 * s1_c) + (0.16666667 * s2_c);
        let s4 = s15 + (0.04761905 * s3_c) + (0.007936508 * s4_c);
        let s16 = s0_c + (0.5555556 * s1_c) + (0.2777778 * s2_c);
        let s17 = s16 + (0.11904762 * s3_c) + (0.03968254 * s4_c);
        let s5 = s17 + (0.007936508 * s5_c);
        let s18 = s0_c + (0.6666667 * s1_c) + (0.41666666 * s2_c);
        let s19 = s18 + (0.23809524 * s3_c) + (0.11904762 * s4_c);
        let s6 = s19 + (0.04761905 * s5_c);
        let s20 = s0_c + (0.7777778 * s1_c) + (0.5833333 * s2_c);
        let s21 = s20 + (0.41666666 * s3_c) + (0.2777778 * s4_c);
        let s7 = s21 + (0.16666667 * s5_c);
        let s22 = s0_c + (0.8888889 * s1_c) + (0.7777778 * s2_c);
        let s23 = s22 + (0.6666667 * s3_c) + (0.5555556 * s4_c);
        let s8 = s23 + (0.44444445 * s5_c);
        let s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
        let v0_c = (2.4 * w1) + (12.0 * w2) + (36.0 * w3);
        let v1_c = ((1.08 * w1) + (9.4 * w2) + (46.2 * w3)) * length;
        let v2_l = length * length;
        let v2_c = ((0.12 * w1) + (2.4 * w2) + (21.3 * w3)) * v2_l;
        let v3_l = v2_l * length;
        let v3_c = ((0.2 * w2) + (4.2 * w3)) * v3_l;
        let v4_l = v3_l * length;
        let v4_c = 0.3 * w3 * v4_l;
        let v1 = v0_c + (0.125 * v1_c);
        let v2 = v0_c + (0.25 * v1_c) + (0.035714287 * v2_c);
        let s24 = v0_c + (0.375 * v1_c) + (0.10714286 * v2_c);
        let v3 = s24 + (0.017857144 * v3_c);
        let s25 = v0_c + (0.5 * v1_c) + (0.21428572 * v2_c) + (0.071428575 * v3_c);
        let v4 = s25 + (0.014285714 * v4_c);
        let s26 = v0_c + (0.625 * v1_c) + (0.35714287 * v2_c) + (0.17857143 * v3_c);
        let v5 = s26 + (0.071428575 * v4_c);
        let s27 = v0_c + (0.75 * v1_c) + (0.53571427 * v2_c) + (0.35714287 * v3_c);
        let v6 = s27 + (0.21428572 * v4_c);
        let s28 = v0_c + (0.875 * v1_c) + (0.75 * v2_c) + (0.625 * v3_c);
        let v7 = s28 + (0.5 * v4_c);
        let v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
        if (least <= b0_c)
            && (b0_c <= most)
            && (least <= b1)
            && (b1 <= most)
            && (least <= b2)
            && (b2 <= most)
            && (least <= b3)
            && (b3 <= most)
            && (least <= b4)
            && (b4 <= most)
            && (least <= b5)
            && (b5 <= most)
            && (least <= b6)
            && (b6 <= most)
            && (least <= b7)
            && (b7 <= most)
            && (-most2 <= s0_c)
            && (s0_c <= most2)
            && (-most2 <= s1)
            && (s1 <= most2)
            && (-most2 <= s2)
            && (s2 <= most2)
            && (-most2 <= s3)
            && (s3 <= most2)
            && (-most2 <= s4)
            && (s4 <= most2)
            && (-most2 <= s5)
            && (s5 <= most2)
            && (-most2 <= s6)
            && (s6 <= most2)
            && (-most2 <= s7)
            && (s7 <= most2)
            && (-most2 <= s8)
            && (s8 <= most2)
            && (-most2 <= s9)
            && (s9 <= most2)
            && (-most3 <= v0_c)
            && (v0_c <= most3)
            && (-most3 <= v1)
            && (v1 <= most3)
            && (-most3 <= v2)
            && (v2 <= most3)
            && (-most3 <= v3)
            && (v3 <= most3)
            && (-most3 <= v4)
            && (v4 <= most3)
            && (-most3 <= v5)
            && (v5 <= most3)
            && (-most3 <= v6)
            && (v6 <= most3)
            && (-most3 <= v7)
            && (v7 <= most3)
            && (-most3 <= v8)
            && (v8 <= most3)
            && (((((-72.0) * w1) - (360.0 * w2)) - (720.0 * w3)).abs() <= most)
            && ((((-48.0) * w1) - (120.0 * w2)).abs() <= most)
            && (((-24.0) * w1).abs() <= most)
            && (((((-0.0168) * w1) - (0.036 * w2)) - (0.036 * w3)).abs() <= most2)
            && (((((-0.006) * w1) - (0.006 * w2)) + (4.8789098e-18 * w3)).abs() <= most2)
            && ((((-0.0012) * w1) + (4.8789098e-18 * w2) + (4.8789098e-18 * w3)).abs() <= most2)
            && (((1.44 * w1) + (4.8 * w2) + (7.2 * w3)).abs() <= most3)
            && ((((0.72 * w1) + (1.2 * w2)) - (1.2490009e-15 * w3)).abs() <= most3)
            && (((0.24 * w1) + (2.9143354e-15 * w2) + (3.7470027e-15 * w3)).abs() <= most3)
        {
            fits = 1;
        }
        if !((tried > 3) && (tried < 100001) && (fits == 1)) {
            return Err(Error::Soon);
        }
        self.start = k;
        self.last = samples;
        Ok(())
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the state x, for sure. Give
    /// them to `arm_for`.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: a state is too large to
    /// compute with. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn soonest(&self, x: &[f32; 3]) -> Result<u32, Error> {
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite()) {
            return Err(Error::Input);
        }
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];
        let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2) + (Self::S1_3 * x3);
        let flat2 = (Self::S2_2 * x2) + (Self::S2_3 * x3);
        let flat3 = Self::S3_3 * x3;
        let mut low = 3_u32;
        let mut top = 100001_u32;
        let mut kept = 0_u32;
        let mut tried = 4_u32;
        for _ in 0..64 {
            let least: f32 = 0.9949459 * (-Self::U_MAX);
            let most: f32 = 0.9949459 * Self::U_MAX;
            let most2: f32 = 0.49747294;
            let most3: f32 = 3.9797835;
            let mut fits = 0_u32;
            let m = tried as f32;
            let power1 = m + 3.0;
            let power2 = power1 * (m + 2.0);
            let power3 = power2 * (m + 1.0);
            let power4 = power3 * m;
            let power5 = power4 * (m - 1.0);
            let power6 = power5 * (m - 2.0);
            let scaled2 = flat2 * power1;
            let scaled3 = flat3 * power2;
            let w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
            let w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
            let w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
            let length = m - 4.0;
            let b0_c = (((-96.0) * w1) - (720.0 * w2)) - (2880.0 * w3);
            let b1_c = ((((-24.0) * w1) - (420.0 * w2)) - (3120.0 * w3)) * length;
            let b2_l = length * length;
            let b2_c = (((-60.0) * w2) - (1080.0 * w3)) * b2_l;
            let b3_l = b2_l * length;
            let b3_c = (-120.0) * w3 * b3_l;
            let b1 = b0_c + (0.14285715 * b1_c);
            let b2 = b0_c + (0.2857143 * b1_c) + (0.04761905 * b2_c);
            let s10 = b0_c + (0.42857143 * b1_c) + (0.14285715 * b2_c);
            let b3 = s10 + (0.028571429 * b3_c);
            let s11 = b0_c + (0.5714286 * b1_c) + (0.2857143 * b2_c);
            let b4 = s11 + (0.114285715 * b3_c);
            let s12 = b0_c + (0.71428573 * b1_c) + (0.47619048 * b2_c);
            let b5 = s12 + (0.2857143 * b3_c);
            let s13 = b0_c + (0.85714287 * b1_c) + (0.71428573 * b2_c);
            let b6 = s13 + (0.5714286 * b3_c);
            let b7 = b0_c + b1_c + b2_c + b3_c;
            let s0_c = (((-0.036) * w1) - (0.12 * w2)) - (0.252 * w3);
            let s1_c = ((((-0.0242) * w1) - (0.124 * w2)) - (0.3954 * w3)) * length;
            let s2_l = length * length;
            let s2_c = ((((-0.0054) * w1) - (0.0475 * w2)) - (0.2415 * w3)) * s2_l;
            let s3_l = s2_l * length;
            let s3_c = ((((-0.0004) * w1) - (0.008 * w2)) - (0.072 * w3)) * s3_l;
            let s4_l = s3_l * length;
            let s4_c = (((-0.0005) * w2) - (0.0105 * w3)) * s4_l;
            let s5_l = s4_l * length;
            let s5_c = (-0.0006) * w3 * s5_l;
            let s1 = s0_c + (0.11111111 * s1_c);
            let s2 = s0_c + (0.22222222 * s1_c) + (0.027777778 * s2_c);
            let s14 = s0_c + (0.33333334 * s1_c) + (0.083333336 * s2_c);
            let s3 = s14 + (0.011904762 * s3_c);
            let s15 = s0_c + (0.44444445 * s1_c) + (0.16666667 * s2_c);
            let s4 = s15 + (0.04761905 * s3_c) + (0.007936508 * s4_c);
            let s16 = s0_c + (0.5555556 * s1_c) + (0.2777778 * s2_c);
            let s17 = s16 + (0.11904762 * s3_c) + (0.03968254 * s4_c);
            let s5 = s17 + (0.007936508 * s5_c);
            let s18 = s0_c + (0.6666667 * s1_c) + (0.41666666 * s2_c);
            let s19 = s18 + (0.23809524 * s3_c) + (0.11904762 * s4_c);
            let s6 = s19 + (0.04761905 * s5_c);
            let s20 = s0_c + (0.7777778 * s1_c) + (0.5833333 * s2_c);
            let s21 = s20 + (0.41666666 * s3_c) + (0.2777778 * s4_c);
            let s7 = s21 + (0.16666667 * s5_c);
            let s22 = s0_c + (0.8888889 * s1_c) + (0.7777778 * s2_c);
            let s23 = s22 + (0.6666667 * s3_c) + (0.5555556 * s4_c);
            let s8 = s23 + (0.44444445 * s5_c);
            let s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
            let v0_c = (2.4 * w1) + (12.0 * w2) + (36.0 * w3);
            let v1_c = ((1.08 * w1) + (9.4 * w2) + (46.2 * w3)) * length;
            let v2_l = length * length;
            let v2_c = ((0.12 * w1) + (2.4 * w2) + (21.3 * w3)) * v2_l;
            let v3_l = v2_l * length;
            let v3_c = ((0.2 * w2) + (4.2 * w3)) * v3_l;
            let v4_l = v3_l * length;
            let v4_c = 0.3 * w3 * v4_l;
            let v1 = v0_c + (0.125 * v1_c);
            let v2 = v0_c + (0.25 * v1_c) + (0.035714287 * v2_c);
            let s24 = v0_c + (0.375 * v1_c) + (0.10714286 * v2_c);
            let v3 = s24 + (0.017857144 * v3_c);
            let s25 = v0_c + (0.5 * v1_c) + (0.21428572 * v2_c) + (0.071428575 * v3_c);
            let v4 = s25 + (0.014285714 * v4_c);
            let s26 = v0_c + (0.625 * v1_c) + (0.35714287 * v2_c) + (0.17857143 * v3_c);
            let v5 = s26 + (0.071428575 * v4_c);
            let s27 = v0_c + (0.75 * v1_c) + (0.53571427 * v2_c) + (0.35714287 * v3_c);
            let v6 = s27 + (0.21428572 * v4_c);
            let s28 = v0_c + (0.875 * v1_c) + (0.75 * v2_c) + (0.625 * v3_c);
            let v7 = s28 + (0.5 * v4_c);
            let v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
            if (least <= b0_c)
                && (b0_c <= most)
                && (least <= b1)
                && (b1 <= most)
                && (least <= b2)
                && (b2 <= most)
                && (least <= b3)
                && (b3 <= most)
                && (least <= b4)
                && (b4 <= most)
                && (least <= b5)
                && (b5 <= most)
                && (least <= b6)
                && (b6 <= most)
                && (least <= b7)
                && (b7 <= most)
                && (-most2 <= s0_c)
                && (s0_c <= most2)
                && (-most2 <= s1)
                && (s1 <= most2)
                && (-most2 <= s2)
                && (s2 <= most2)
                && (-most2 <= s3)
                && (s3 <= most2)
                && (-most2 <= s4)
                && (s4 <= most2)
                && (-most2 <= s5)
                && (s5 <= most2)
                && (-most2 <= s6)
                && (s6 <= most2)
                && (-most2 <= s7)
                && (s7 <= most2)
                && (-most2 <= s8)
                && (s8 <= most2)
                && (-most2 <= s9)
                && (s9 <= most2)
                && (-most3 <= v0_c)
                && (v0_c <= most3)
                && (-most3 <= v1)
                && (v1 <= most3)
                && (-most3 <= v2)
                && (v2 <= most3)
                && (-most3 <= v3)
                && (v3 <= most3)
                && (-most3 <= v4)
                && (v4 <= most3)
                && (-most3 <= v5)
                && (v5 <= most3)
                && (-most3 <= v6)
                && (v6 <= most3)
                && (-most3 <= v7)
                && (v7 <= most3)
                && (-most3 <= v8)
                && (v8 <= most3)
                && (((((-72.0) * w1) - (360.0 * w2)) - (720.0 * w3)).abs() <= most)
                && ((((-48.0) * w1) - (120.0 * w2)).abs() <= most)
                && (((-24.0) * w1).abs() <= most)
                && (((((-0.0168) * w1) - (0.036 * w2)) - (0.036 * w3)).abs() <= most2)
                && (((((-0.006) * w1) - (0.006 * w2)) + (4.8789098e-18 * w3)).abs() <= most2)
                && ((((-0.0012) * w1) + (4.8789098e-18 * w2) + (4.8789098e-18 * w3)).abs() <= most2)
                && (((1.44 * w1) + (4.8 * w2) + (7.2 * w3)).abs() <= most3)
                && ((((0.72 * w1) + (1.2 * w2)) - (1.2490009e-15 * w3)).abs() <= most3)
                && (((0.24 * w1) + (2.9143354e-15 * w2) + (3.7470027e-15 * w3)).abs() <= most3)
            {
                fits = 1;
            }
            if fits == 1 {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            let gap = top.saturating_sub(low);
            if gap < 2 {
                break;
            }
            let half = gap / 2;
            if low < half {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if flat1.is_finite() && flat2.is_finite() && flat3.is_finite() {
            if kept > 0 {
                Ok(kept)
            } else {
                Err(Error::Soon)
            }
        } else {
            Err(Error::Range)
        }
    }

    /// The tick at which the loop is to be at rest.
    #[inline]
    pub fn deadline(&self) -> u32 {
        self.start.wrapping_sub(0_u32.wrapping_sub(self.last))
    }
}
