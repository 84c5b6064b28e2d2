//! Prescribed-time observer stage15_observer: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5
//! Version 0.1.0, design fa54d2fef2e7.
//!
//! Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
//!       1.5 samples late.
//! Goal: the estimates of the state and of d are as near as the hold at observer_eps leaves
//!       them from sample 9 after the start on, from any state and at any sample period, as
//!       long as the measurement is exact, u is what was applied and nothing else acts on the
//!       plant.
//! Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
//!       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
//!       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
//!       deadbeat takes over.
//!
//! Parameters:
//!   h [s]: sample period
//!   a = 1.5 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - 9 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acts from 1.5 samples
//!       after tick k - 1 on for one sample, and the observer keeps those under way.
//! From sample 9 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
//!       gains of the observer are then held below deadbeat.
//! Guard full: what is measured and u are finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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

/// Run-time parameters of [`Stage15Observer`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage15ObserverParams {
    /// sample period \[s\], from 1e-18 to 1e18.
    pub h: f32,
}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage15Observer {
    /// tick at which it was armed.
    start: u32,
    /// input of 2 samples ago.
    u1: f32,
    /// input of 3 samples ago.
    u2: f32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f32,
    /// estimate of x2.
    x2_hat: f32,
    /// estimate of d.
    d_hat: f32,
    /// prediction of x1 from x2.
    phi1_2: f32,
    /// prediction of x1 from d.
    phi1_3: f32,
    /// prediction from u.
    gamma1: f32,
    /// prediction from u.
    late_gamma1: f32,
    /// prediction of x2 from d.
    phi2_3: f32,
    /// prediction from u.
    gamma2: f32,
    /// samples to go at which the observer is held.
    hold_o: f32,
    /// weight in the observer's gain l2.
    q2_1: f32,
    /// weight in the observer's gain l2.
    q2_2: f32,
    /// weight in the observer's gain l3.
    q3_1: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage15Observer {
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 9;
    /// 320/9, weight in the observer's gain l1.
    const Q1_1: f32 = 35.555557;
    /// -215/9, weight in the observer's gain l1.
    const Q1_2: f32 = -23.88889;
    /// Weight in the observer's gain l1.
    const Q1_3: f32 = 7.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage15ObserverParams) -> Result<Self, Error> {
        if !((1e-18 <= params.h) && (params.h <= 1e18)) {
            return Err(Error::Param);
        }
        let phi1_2 = params.h;
        let phi1_3 = 0.25 * (params.h * params.h);
        let gamma1 = 0.1875 * (params.h * params.h);
        let late_gamma1 = 0.0625 * (params.h * params.h);
        let phi2_3 = 0.5 * params.h;
        let gamma2 = 0.25 * params.h;
        let hold_o = 0.05 / params.h;
        let q2_1 = (-22.444445) * (1.0 / params.h);
        let q2_2 = 9.888889 * (1.0 / params.h);
        let q3_1 = 3.5555556 * (1.0 / (params.h * params.h));
        if !(phi1_3.is_finite()
            && gamma1.is_finite()
            && late_gamma1.is_finite()
            && phi2_3.is_finite()
            && gamma2.is_finite()
            && hold_o.is_finite()
            && q2_1.is_finite()
            && q2_2.is_finite()
            && q3_1.is_finite()
            && (params.h * params.h >= 1e-30)
            && (1.0 / (params.h * params.h) >= 1e-30)
            && (hold_o >= 3.0))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            d_hat: 0.0,
            phi1_2,
            phi1_3,
            gamma1,
            late_gamma1,
            phi2_3,
            gamma2,
            hold_o,
            q2_1,
            q2_2,
            q3_1,
        })
    }

    /// Starts a round of 9 samples at tick `k`. Estimates and inputs under way are kept. Estimates
    /// too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let size = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e18) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.d_hat = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 9 on: the
    /// round is over.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: an estimate is not finite.
    /// Nothing has changed.
    #[inline]
    pub fn update(&mut self, k: u32, y: &[f32; 1], u: f32) -> Result<Status, Error> {
        if !(y[0].is_finite() && u.is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
        let s2 = self.late_gamma1 * (self.u1 - 19.62);
        let s3 = (self.gamma1 * (self.u2 - 19.62)) + s2;
        let p1 = s1 + (self.phi1_3 * self.d_hat) + s3;
        let s4 = self.gamma2 * (self.u2 - 19.62);
        let s5 = self.x2_hat + (self.phi2_3 * self.d_hat);
        let p2 = s5 + (s4 + (self.gamma2 * (self.u1 - 19.62)));
        let p3 = self.d_hat;

        // Correct by what is measured.
        let base: f32;
        let miss: f32;
        if self.seen == 0 {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = if (left_o as f32) < self.hold_o {
            self.hold_o
        } else {
            left_o as f32
        };
        let l1: f32;
        let l2: f32;
        let l3: f32;
        let o0f2 = o0 * (o0 - 1.0);
        let r0 = 1.0 / (o0f2 * (o0 - 2.0));
        l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
        l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
        l3 = self.q3_1 * r0;
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);
        if !(x1.is_finite() && x2.is_finite() && d.is_finite()) {
            return Err(Error::Range);
        }
        self.u2 = self.u1;
        self.u1 = u;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.d_hat = d;
        self.seen = 1;
        if left_o == 0 {
            Ok(Status::Hold)
        } else {
            Ok(Status::Ok)
        }
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f32; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f32 {
        self.d_hat
    }
}
