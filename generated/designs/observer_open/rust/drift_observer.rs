//! Prescribed-time observer drift_observer: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60
//! Version 0.1.0, design 3d13f742d37b.
//!
//! Plant: x1' = x2, ..., x3' = (u + d), d an unknown ramp; u held from sample to sample.
//! Goal: the estimates of the state and of d are exact up to rounding from sample 60 after the
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
//! k counts samples and may wrap; arm again within 2^32 - 60 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
//!       tick k.
//! From sample 60 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
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

/// Run-time parameters of [`DriftObserver`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DriftObserverParams {
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct DriftObserver {
    /// tick at which it was armed.
    start: u32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of x3.
    x3_hat: f64,
    /// estimate of d.
    d_hat: f64,
    /// estimate of d_rate.
    d_rate_hat: f64,
    /// prediction of x2 from x3.
    phi1_2: f64,
    /// prediction of x2 from d.
    phi1_3: f64,
    /// prediction of x2 from d_rate.
    phi1_4: f64,
    /// weight in the observer's gain l2.
    q2_1: f64,
    /// weight in the observer's gain l2.
    q2_2: f64,
    /// weight in the observer's gain l2.
    q2_3: f64,
    /// weight in the observer's gain l3.
    q3_1: f64,
    /// weight in the observer's gain l3.
    q3_2: f64,
    /// weight in the observer's gain l4.
    q4_1: f64,
    /// gain of the observer at its end.
    e3_2: f64,
    /// gain of the observer at its end.
    e3_3: f64,
    /// gain of the observer at its end.
    e3_4: f64,
    /// gain of the observer at its end.
    e2_2: f64,
    /// gain of the observer at its end.
    e2_4: f64,
    /// gain of the observer at its end.
    e1_2: f64,
    /// gain of the observer at its end.
    e1_3: f64,
    /// gain of the observer at its end.
    e1_4: f64,
    /// gain of the observer at its end.
    e0_2: f64,
    /// gain of the observer at its end.
    e0_3: f64,
    /// gain of the observer at its end.
    e0_4: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl DriftObserver {
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 60;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = -840.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = 480.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = -120.0;
    /// Weight in the observer's gain l1.
    const Q1_4: f64 = 16.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: DriftObserverParams) -> Result<Self, Error> {
        if !((1e-150 <= params.h) && (params.h <= 1e150)) {
            return Err(Error::Param);
        }
        let phi1_2 = params.h;
        let phi1_3 = 0.5 * (params.h * params.h);
        let phi1_4 = 0.16666666666666666 * (params.h * params.h * params.h);
        let q2_1 = 908.0 * (1.0 / params.h);
        let q2_2 = (-432.0) * (1.0 / params.h);
        let q2_3 = 72.0 * (1.0 / params.h);
        let q3_1 = (-336.0) * (1.0 / (params.h * params.h));
        let q3_2 = 96.0 * (1.0 / (params.h * params.h));
        let q4_1 = 24.0 * (1.0 / (params.h * params.h * params.h));
        let e3_2 = 1.8333333333333333 * (1.0 / params.h);
        let e3_3 = 2.0 * (1.0 / (params.h * params.h));
        let e3_4 = 1.0 / (params.h * params.h * params.h);
        let e2_2 = 1.1666666666666667 * (1.0 / params.h);
        let e2_4 = -(1.0 / (params.h * params.h * params.h));
        let e1_2 = 0.8148148148148148 * (1.0 / params.h);
        let e1_3 = (-0.2222222222222222) * (1.0 / (params.h * params.h));
        let s1 = 1.0 / (params.h * params.h * params.h);
        let e1_4 = 0.4444444444444444 * s1;
        let e0_2 = 0.4777777777777778 * (1.0 / params.h);
        let e0_3 = 0.26666666666666666 * (1.0 / (params.h * params.h));
        let s2 = 1.0 / (params.h * params.h * params.h);
        let e0_4 = (-0.06666666666666667) * s2;
        if !(phi1_3.is_finite()
            && phi1_4.is_finite()
            && q2_1.is_finite()
            && q2_2.is_finite()
            && q2_3.is_finite()
            && q3_1.is_finite()
            && q3_2.is_finite()
            && q4_1.is_finite()
            && e3_2.is_finite()
            && e3_3.is_finite()
            && e3_4.is_finite()
            && e2_2.is_finite()
            && e2_4.is_finite()
            && e1_2.is_finite()
            && e1_3.is_finite()
            && e1_4.is_finite()
            && e0_2.is_finite()
            && e0_3.is_finite()
            && e0_4.is_finite()
            && (params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            seen: 0,
            x2_hat: 0.0,
            x3_hat: 0.0,
            d_hat: 0.0,
            d_rate_hat: 0.0,
            phi1_2,
            phi1_3,
            phi1_4,
            q2_1,
            q2_2,
            q2_3,
            q3_1,
            q3_2,
            q4_1,
            e3_2,
            e3_3,
            e3_4,
            e2_2,
            e2_4,
            e1_2,
            e1_3,
            e1_4,
            e0_2,
            e0_3,
            e0_4,
        })
    }

    /// Starts a round of 60 samples at tick `k`. The estimates are kept. Estimates too large to
    /// compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x2_hat).abs() + (self.x3_hat).abs() + (self.d_hat).abs();
        let size = s1 + (self.d_rate_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x2_hat = 0.0;
            self.x3_hat = 0.0;
            self.d_hat = 0.0;
            self.d_rate_hat = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 60 on: the
    /// round is over.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: an estimate is not finite.
    /// Nothing has changed.
    #[inline]
    pub fn update(&mut self, k: u32, y: &[f64; 2], u: f64) -> Result<Status, Error> {
        if !(y[0].is_finite() && y[1].is_finite() && u.is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x2_hat + (self.phi1_2 * self.x3_hat);
        let s2 = s1 + (self.phi1_3 * self.d_hat);
        let p1 = s2 + (self.phi1_4 * self.d_rate_hat) + (self.phi1_3 * u);
        let s3 = self.x3_hat + (self.phi1_2 * self.d_hat);
        let p2 = s3 + (self.phi1_3 * self.d_rate_hat) + (self.phi1_2 * u);
        let p3 = self.d_hat + (self.phi1_2 * self.d_rate_hat);
        let p4 = self.d_rate_hat;

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
        let l3: f64;
        let l4: f64;
        if o0 > 10.0 {
            let o0f2 = o0 * (o0 - 1.0);
            let o0f3 = o0f2 * (o0 - 2.0);
            let r0 = 1.0 / (o0f3 * (o0 - 3.0));
            let s4 = Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2);
            l1 = (s4 + (Self::Q1_4 * o0f3)) * r0;
            l2 = (self.q2_1 + (self.q2_2 * o0) + (self.q2_3 * o0f2)) * r0;
            l3 = (self.q3_1 + (self.q3_2 * o0)) * r0;
            l4 = self.q4_1 * r0;
        } else if left_o == 10 {
            l1 = 1.0;
            l2 = self.e0_2;
            l3 = self.e0_3;
            l4 = self.e0_4;
        } else if left_o == 9 {
            l1 = 1.0;
            l2 = self.e1_2;
            l3 = self.e1_3;
            l4 = self.e1_4;
        } else if left_o == 8 {
            l1 = 1.0;
            l2 = self.e2_2;
            l3 = 0.0;
            l4 = self.e2_4;
        } else {
            l1 = 1.0;
            l2 = self.e3_2;
            l3 = self.e3_3;
            l4 = self.e3_4;
        }
        let x2 = base + (l1 * miss);
        let x3 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);
        let d_rate = p4 + (l4 * miss);
        if !(x2.is_finite() && x3.is_finite() && d.is_finite() && d_rate.is_finite()) {
            return Err(Error::Range);
        }
        self.x2_hat = x2;
        self.x3_hat = x3;
        self.d_hat = d;
        self.d_rate_hat = d_rate;
        self.seen = 1;
        if left_o == 0 {
            Ok(Status::Hold)
        } else {
            Ok(Status::Ok)
        }
    }

    /// The estimates of x2, ... at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 2] {
        [self.x2_hat, self.x3_hat]
    }

    /// The estimate of the ramp that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
