//! Prescribed-time controller paced: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1
//! Version 0.1.0, design d3e4f699dd7c.
//!
//! Plant: x1' = x2, x2' = u; u held from sample to sample, one sample late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
//!       gains of 3 samples to go stay: they are deadbeat.
//!
//! Parameters:
//!   samples = 100 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: upper limit of u
//!   u_min = -1 [unit of u], fixed: lower limit of u
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on u = 0 (status AFTER).
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
//!       so their Bernstein coefficients, linear in z, bound them. If these are within the
//!       limits, u stay there at every sample to rest, where plant and state are as they are
//!       known.
//! late extend: a step without such a plan raises N to the soonest that has one (status LATE;
//!       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
//!       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
//!       stays, and u is clipped; states may leave their bounds then.
//! u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
//!       deadline where it lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 100 from any state, whatever the poles, and |u| is
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

/// Run-time parameters of [`Paced`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct PacedParams {
    /// upper limit of u \[unit of u\], > u_min, infinity allowed.
    pub u_max: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Paced {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest, as planned now.
    last: u32,
    /// input of the last sample.
    u1: f64,
    /// upper limit of u.
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
impl Paced {
    /// Weight of x1 in the law.
    const S1_1: f64 = 10000.0;
    /// Weight of x2 in the law.
    const S1_2: f64 = -50.0;
    /// Weight of x2 in the law.
    const S2_2: f64 = 100.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -1200000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = 6000.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -6000.0;
    /// Weight of u1 in the law.
    const W3_3: f64 = -12.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: PacedParams) -> Result<Self, Error> {
        if !((params.u_max > -1.0) && (params.u_max >= 0.0)) {
            return Err(Error::Param);
        }
        let u_max = params.u_max;
        Ok(Self {
            start: 0,
            last: 100,
            u1: 0.0,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 100;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f64; 2]) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite() && x[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];

        // The deadline that keeps the limits.
        let mut last_now = self.last;
        let mut late = 0_u32;
        if elapsed < self.last {
            let to_rest = self.last.saturating_sub(elapsed);
            let ahead = to_rest;
            let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2);
            let flat2 = Self::S2_2 * x2;
            let flat3 = self.u1;
            let mut below = ahead.saturating_sub(1).saturating_sub(ahead / 16);
            if ahead > 3 {
                if below < 3 {
                    below = 3;
                }
            } else {
                below = ahead.saturating_sub(1);
            }
            let mut low = below;
            let mut top = 1073741825_u32;
            let mut kept = 0_u32;
            let mut tried = ahead;
            let mut part = 0.9999999999968848;
            for _ in 0..64 {
                let least = -part;
                let most = self.u_max * part;
                let mut fits = 0_u32;
                if tried > 3 {
                    let m = tried as f64;
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
                    let b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
                    let b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
                    let b2_l = length * length;
                    let b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
                    let b3_l = b2_l * length;
                    let b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
                    let b4_l = b3_l * length;
                    let b4_c = 30.0 * w3 * b4_l;
                    let b1 = b0_c + (0.125 * b1_c);
                    let b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
                    let s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
                    let b3 = s1 + (0.017857142857142856 * b3_c);
                    let s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
                    let s3 = s2 + (0.07142857142857142 * b3_c);
                    let b4 = s3 + (0.014285714285714285 * b4_c);
                    let s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
                    let s5 = s4 + (0.17857142857142858 * b3_c);
                    let b5 = s5 + (0.07142857142857142 * b4_c);
                    let s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
                    let s7 = s6 + (0.35714285714285715 * b3_c);
                    let b6 = s7 + (0.21428571428571427 * b4_c);
                    let s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
                    let b7 = s8 + (0.5 * b4_c);
                    let b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
                    let end29 = (72.0 * w1) + (120.0 * w2);
                    let end30 = 24.0 * w1;
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
                        && (least <= b8)
                        && (b8 <= most)
                        && (least <= end29)
                        && (end29 <= most)
                        && (least <= end30)
                        && (end30 <= most)
                    {
                        fits = 1;
                    }
                } else {
                    let end0 = ((-flat1) - (3.0 * flat2)) - (2.0 * flat3);
                    let end1 = flat1 + (2.0 * flat2) + flat3;
                    if (least <= end0) && (end0 <= most) && (least <= end1) && (end1 <= most) {
                        fits = 1;
                    }
                }
                if fits == 1 {
                    kept = tried;
                    top = tried;
                } else if tried > 3 {
                    low = tried;
                } else {
                    low = 3;
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
                part = 0.9999999999937695;
            }
            if (kept > 0) && (elapsed < 2147483648) {
                last_now = elapsed + kept;
            }
            if (kept == 0) && (ahead > 0) {
                late = 2;
            }
        }
        if last_now > self.last {
            late = 1;
        }
        let left = last_now.saturating_sub(elapsed);
        let m0 = if (left as f64) < 3.0 {
            3.0
        } else {
            left as f64
        };
        let v: f64;

        // The exact law in samples.
        let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2);
        let z2 = Self::W2_2 * x2;
        let z3 = Self::W3_3 * self.u1;
        let m0f1 = m0 + 3.0;
        let m0f2 = m0f1 * (m0 + 2.0);
        v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0))) + self.u1;
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f64;
        if elapsed < last_now {
            if v > self.u_max {
                u_now = self.u_max;
            } else if v < -1.0 {
                u_now = -1.0;
            } else {
                u_now = v;
            }
        } else {
            u_now = 0.0;
        }
        self.u1 = u_now;
        self.last = last_now;
        let status = if elapsed < last_now {
            if (v > self.u_max) || (v < -1.0) {
                Status::Saturated
            } else if late == 2 {
                Status::Infeasible
            } else if late == 1 {
                Status::Late
            } else {
                Status::Ok
            }
        } else {
            Status::After
        };
        Ok(Control { u: u_now, status })
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. Estimates and inputs under way are kept.
    ///
    /// # Errors
    /// `Param`: the number of samples is out of its range.
    #[inline]
    pub fn arm_for(&mut self, k: u32, samples: u32) -> Result<(), Error> {
        if !((samples > 2) && (samples < 2147483649)) {
            return Err(Error::Param);
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
    pub fn soonest(&self, x: &[f64; 2]) -> Result<u32, Error> {
        if !(x[0].is_finite() && x[1].is_finite()) {
            return Err(Error::Input);
        }
        let x1 = x[0];
        let x2 = x[1];
        let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2);
        let flat2 = Self::S2_2 * x2;
        let flat3 = self.u1;
        let mut low = 3_u32;
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = 4_u32;
        for _ in 0..64 {
            let least: f64 = -0.9999999999937695;
            let most = 0.9999999999937695 * self.u_max;
            let mut fits = 0_u32;
            let m = tried as f64;
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
            let b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
            let b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
            let b2_l = length * length;
            let b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
            let b3_l = b2_l * length;
            let b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
            let b4_l = b3_l * length;
            let b4_c = 30.0 * w3 * b4_l;
            let b1 = b0_c + (0.125 * b1_c);
            let b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
            let s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
            let b3 = s1 + (0.017857142857142856 * b3_c);
            let s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
            let s3 = s2 + (0.07142857142857142 * b3_c);
            let b4 = s3 + (0.014285714285714285 * b4_c);
            let s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
            let s5 = s4 + (0.17857142857142858 * b3_c);
            let b5 = s5 + (0.07142857142857142 * b4_c);
            let s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
            let s7 = s6 + (0.35714285714285715 * b3_c);
            let b6 = s7 + (0.21428571428571427 * b4_c);
            let s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
            let b7 = s8 + (0.5 * b4_c);
            let b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
            let end29 = (72.0 * w1) + (120.0 * w2);
            let end30 = 24.0 * w1;
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
                && (least <= b8)
                && (b8 <= most)
                && (least <= end29)
                && (end29 <= most)
                && (least <= end30)
                && (end30 <= most)
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

    /// The drive applied `u` in place of the u that the last call of `step` gave.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn applied(&mut self, u: f64) -> Result<(), Error> {
        if !u.is_finite() {
            return Err(Error::Input);
        }
        self.u1 = u;
        Ok(())
    }
}
