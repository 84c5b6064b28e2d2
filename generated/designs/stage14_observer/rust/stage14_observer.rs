//! Prescribed-time observer stage14_observer: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage14 --what observer --clock samples --measured=x1 --observer-poles=-4,-5+i,-5-i --observer-samples=12
//! Version 0.1.0, design d1ea1cd2ee5c.
//!
//! Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
//! Goal: the estimates of the state are exact up to rounding from sample 12 after the start
//!       on, from any state and at any sample period, as long as the measurement is exact, u
//!       is what was applied and nothing else acts on the plant.
//! Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
//!       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
//!       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
//!       deadbeat takes over.
//!
//! Parameters:
//!   h [s]: sample period
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - 12 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
//!       tick k.
//! From sample 12 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
//!       gains of the observer are then held below deadbeat.
//! Guard full: what is measured and u are finite, or the call is refused (INPUT).
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

/// Run-time parameters of [`Stage14Observer`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage14ObserverParams {
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage14Observer {
    /// tick at which it was armed.
    start: u32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// prediction of x1 from x2.
    phi1_2: f64,
    /// prediction of x1 from x3.
    phi1_3: f64,
    /// prediction from u.
    gamma1: f64,
    /// weight in the observer's gain l2.
    q2_1: f64,
    /// weight in the observer's gain l2.
    q2_2: f64,
    /// weight in the observer's gain l3.
    q3_1: f64,
    /// gain of the observer at its end.
    e2_2: f64,
    /// gain of the observer at its end.
    e2_3: f64,
    /// gain of the observer at its end.
    e1_2: f64,
    /// gain of the observer at its end.
    e1_3: f64,
    /// gain of the observer at its end.
    e0_2: f64,
    /// gain of the observer at its end.
    e0_3: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage14Observer {
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 12;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 104.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -53.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 11.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage14ObserverParams) -> Result<Self, Error> {
        if !((1e-150 <= params.h) && (params.h <= 1e150)) {
            return Err(Error::Param);
        }
        let phi1_2 = params.h;
        let phi1_3 = 0.5 * (params.h * params.h);
        let gamma1 = 0.16666666666666666 * (params.h * params.h * params.h);
        let q2_1 = (-92.0) * (1.0 / params.h);
        let q2_2 = 31.0 * (1.0 / params.h);
        let q3_1 = 20.0 * (1.0 / (params.h * params.h));
        let e2_2 = 1.5 * (1.0 / params.h);
        let e2_3 = 1.0 / (params.h * params.h);
        let e1_2 = 0.9166666666666666 * (1.0 / params.h);
        let e1_3 = (-0.16666666666666666) * (1.0 / (params.h * params.h));
        let e0_2 = 0.4880952380952381 * (1.0 / params.h);
        let e0_3 = 0.16666666666666666 * (1.0 / (params.h * params.h));
        if !(phi1_3.is_finite()
            && gamma1.is_finite()
            && q2_1.is_finite()
            && q2_2.is_finite()
            && q3_1.is_finite()
            && e2_2.is_finite()
            && e2_3.is_finite()
            && e1_2.is_finite()
            && e1_3.is_finite()
            && e0_2.is_finite()
            && e0_3.is_finite()
            && (params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            phi1_2,
            phi1_3,
            gamma1,
            q2_1,
            q2_2,
            q3_1,
            e2_2,
            e2_3,
            e1_2,
            e1_3,
            e0_2,
            e0_3,
        })
    }

    /// Starts a round of 12 samples at tick `k`. The estimates are kept. Estimates too large to
    /// compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.x3_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.x3_hat = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 12 on: the
    /// round is over.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: an estimate is not finite.
    /// Nothing has changed.
    #[inline]
    pub fn update(&mut self, k: u32, y: &[f64; 1], u: f64) -> Result<Status, Error> {
        if !(y[0].is_finite() && u.is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
        let p1 = s1 + (self.phi1_3 * self.x3_hat) + (self.gamma1 * u);
        let s2 = self.x2_hat + (self.phi1_2 * self.x3_hat);
        let p2 = s2 + (self.phi1_3 * u);
        let p3 = self.x3_hat + (self.phi1_2 * u);

        // Correct by what is measured.
        let base: f64;
        let miss: f64;
        if self.seen == 0 {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1: f64;
        let l2: f64;
        let l3: f64;
        if o0 > 7.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
            l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
            l3 = self.q3_1 * r0;
        } else if left_o == 7 {
            l1 = 1.0;
            l2 = self.e0_2;
            l3 = self.e0_3;
        } else if left_o == 6 {
            l1 = 1.0;
            l2 = self.e1_2;
            l3 = self.e1_3;
        } else {
            l1 = 1.0;
            l2 = self.e2_2;
            l3 = self.e2_3;
        }
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let x3 = p3 + (l3 * miss);
        if !(x1.is_finite() && x2.is_finite() && x3.is_finite()) {
            return Err(Error::Range);
        }
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.x3_hat = x3;
        self.seen = 1;
        if left_o == 0 {
            Ok(Status::Hold)
        } else {
            Ok(Status::Ok)
        }
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }
}
