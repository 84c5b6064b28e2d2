//! Prescribed-time observer stage17_observer: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage17 --what observer --clock samples --disturbance constant --observer-poles=-4,-5 --observer-samples=8 --guard none
//! Version 0.1.0, design da56a9ae4fbe.
//!
//! Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
//! Goal: the estimates of the state and of d are exact up to rounding from sample 8 after the
//!       start on, from any state and at any sample period, as long as the measurement is
//!       exact, u is what was applied and nothing else acts on the plant.
//! Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
//!       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
//!       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
//!       deadbeat takes over.
//!
//! Parameters:
//!   h [s]: sample period
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - 8 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
//!       tick k.
//! From sample 8 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
//!       gains of the observer are then held below deadbeat.
//! Guard none: finite measurements and inputs are the responsibility of the caller.
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: not checked: an observer alone has no law.
//!   sampling: not checked: an observer alone has no law.
//!   deadline: not checked: an observer alone has no law.
//!   loop: not checked: an observer alone has no law.
//!   envelope: not checked: an observer alone has no law.
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

/// Run-time parameters of [`Stage17Observer`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage17ObserverParams {
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage17Observer {
    /// tick at which it was armed.
    start: u32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of d.
    d_hat: f64,
    /// prediction of x2 from d.
    phi1_2: f64,
    /// weight in the observer's gain l2.
    q2_1: f64,
    /// gain of the observer at its end.
    e1_2: f64,
    /// gain of the observer at its end.
    e0_2: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage17Observer {
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 8;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = -20.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = 8.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage17ObserverParams) -> Result<Self, Error> {
        if !((1e-150 <= params.h) && (params.h <= 1e150)) {
            return Err(Error::Param);
        }
        let phi1_2 = params.h;
        let q2_1 = 12.0 * (1.0 / params.h);
        let e1_2 = 1.0 / params.h;
        let e0_2 = 0.3333333333333333 * (1.0 / params.h);
        if !(q2_1.is_finite()
            && e1_2.is_finite()
            && e0_2.is_finite()
            && (params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            seen: 0,
            x2_hat: 0.0,
            d_hat: 0.0,
            phi1_2,
            q2_1,
            e1_2,
            e0_2,
        })
    }

    /// Starts a round of 8 samples at tick `k`. The estimates are kept. Estimates too large to
    /// compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x2_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x2_hat = 0.0;
            self.d_hat = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 8 on: the
    /// round is over.
    ///
    /// # Errors
    /// `Range`: an estimate is not finite. Nothing has changed.
    #[inline]
    pub fn update(&mut self, k: u32, y: &[f64; 2], u: f64) -> Result<Status, Error> {
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x2_hat + (self.phi1_2 * self.d_hat);
        let p1 = s1 + (self.phi1_2 * u);
        let p2 = self.d_hat;

        // Correct by what is measured.
        let base: f64;
        let miss: f64;
        if self.seen == 0 {
            base = y[1];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[1] - p1;
        }
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        if o0 > 6.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            l1 = (Self::Q1_1 + (Self::Q1_2 * o0)) * r0;
            l2 = self.q2_1 * r0;
        } else if left_o == 6 {
            l1 = 1.0;
            l2 = self.e0_2;
        } else {
            l1 = 1.0;
            l2 = self.e1_2;
        }
        let x2 = base + (l1 * miss);
        let d = p2 + (l2 * miss);
        if !(x2.is_finite() && d.is_finite()) {
            return Err(Error::Range);
        }
        self.x2_hat = x2;
        self.d_hat = d;
        self.seen = 1;
        if left_o == 0 {
            Ok(Status::Hold)
        } else {
            Ok(Status::Ok)
        }
    }

    /// The estimates of x2, ... at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 1] {
        [self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
