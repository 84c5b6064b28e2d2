//! Prescribed-time observer stage41_observer: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01
//! Version 0.1.0, design 5a4b5fc5ddd5.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
//! Goal: the estimates of the state are exact up to rounding from sample 20 after the start
//!       on, from any state and at any sample period, as long as the measurement is exact, u
//!       is what was applied and nothing else acts on the plant.
//! Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
//!       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
//!       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
//!       the end deadbeat takes over.
//!
//! Parameters:
//!   h = 0.01 [s], fixed: sample period
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - 20 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
//!       tick k.
//! From sample 20 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
//!       gains of the observer are then held below deadbeat.
//! Gate: a reading that is not finite or further than 1, 0.75 from its prediction is not
//!       believed, and the estimates are predicted alone (status GATED) for at most 1 sample
//!       in a row. Then the call is refused (E_INPUT) until a reading is believed or arm
//!       starts the estimates anew. The first reading has no prediction.
//! Guard full: what is measured passes this gate, u is finite, or the call is refused (INPUT).
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

/// Run-time parameters of [`Stage41Observer`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage41ObserverParams {}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage41Observer {
    /// tick at which it was armed.
    start: u32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f32,
    /// prediction of x1 without u.
    x1_next: f32,
    /// estimate of x2.
    x2_hat: f32,
    /// prediction of x2 without u.
    x2_next: f32,
    /// estimate of x3.
    x3_hat: f32,
    /// prediction of x3 without u.
    x3_next: f32,
    /// samples for which the estimates may be used, the next one included.
    trust: u32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage41Observer {
    /// Prediction from u.
    const GAMMA1: f32 = 0.00010803832;
    /// Prediction from u.
    const GAMMA2: f32 = 0.030892799;
    /// Prediction from u.
    const GAMMA3: f32 = 0.37459216;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 20;
    /// Weight in the observer's gain l1_1.
    const Q1_1_1: f32 = -8.0;
    /// Weight in the observer's gain l1_1.
    const Q1_1_2: f32 = 8.0;
    /// Weight in the observer's gain l1_2.
    const Q1_2_1: f32 = 1218.3761;
    /// Weight in the observer's gain l1_2.
    const Q1_2_2: f32 = -11.457022;
    /// Weight in the observer's gain l1_3.
    const Q1_3_1: f32 = 90.17191;
    /// Weight in the observer's gain l1_3.
    const Q1_3_2: f32 = -90.17191;
    /// Weight in the observer's gain l2_2.
    const Q2_2_1: f32 = -0.37285107;
    /// Weight in the observer's gain l2_3.
    const Q2_3_1: f32 = 6.0;
    /// Gain of the observer at its end.
    const E0_1_1: f32 = 1.1216538;
    /// Gain of the observer at its end.
    const E0_1_2: f32 = 11.488578;
    /// Gain of the observer at its end.
    const E0_1_3: f32 = -7.5500894;
    /// Gain of the observer at its end.
    const E0_2_2: f32 = 0.05081172;
    /// Gain of the observer at its end.
    const E0_2_3: f32 = 0.5481857;
    /// Gain of the observer at its end.
    const E1_1_1: f32 = 1.9787967;
    /// Gain of the observer at its end.
    const E1_1_2: f32 = 96.46954;
    /// Gain of the observer at its end.
    const E1_1_3: f32 = -17.211365;
    /// Gain of the observer at its end.
    const E1_2_2: f32 = 0.05081172;
    /// Gain of the observer at its end.
    const E1_2_3: f32 = 0.5481857;
    /// Prediction of x1 from x2.
    const PHI1_2: f32 = 0.009942672;
    /// Prediction of x1 from x3.
    const PHI1_3: f32 = 0.000617856;
    /// Prediction of x2 from x2.
    const PHI2_2: f32 = 0.9857608;
    /// Prediction of x2 from x3.
    const PHI2_3: f32 = 0.11206872;
    /// Prediction of x3 from x2.
    const PHI3_2: f32 = -0.11206872;
    /// Prediction of x3 from x3.
    const PHI3_3: f32 = 0.54122156;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage41ObserverParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            x3_hat: 0.0,
            x3_next: 0.0,
            trust: 1,
        })
    }

    /// Starts a round of 20 samples at tick `k`. The estimates are kept. Estimates that have had no
    /// reading for all samples of `coast`, and those too large to compute with, begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_next).abs() + (self.x2_next).abs();
        let size = s1 + (self.x3_next).abs();
        if !((self.trust > 1) && (size <= 1e18)) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.x3_hat = 0.0;
            self.x3_next = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and
    /// u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows
    /// in the estimates from the next tick on. Call it once for each tick, before the law, which
    /// takes its estimates. Status Hold from sample 20 on: the round is over.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: an estimate is not finite.
    /// Nothing has changed.
    #[inline]
    pub fn update(&mut self, k: u32, y: &[f32; 2], u: f32) -> Result<Status, Error> {
        if !u.is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f32;
        let x2: f32;
        let x3: f32;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            x3 = y[1];
        } else {
            x1 = self.x1_next + (Self::GAMMA1 * u);
            x2 = self.x2_next + (Self::GAMMA2 * u);
            x3 = self.x3_next + (Self::GAMMA3 * u);
        }

        // Prediction of the next sample.
        let gap1 = y[0] - x1;
        let gap2 = y[1] - x3;
        let miss1: f32;
        let miss2: f32;
        let trust: u32;
        if y[0].is_finite() && (gap1.abs() <= 1.0) && y[1].is_finite() && (gap2.abs() <= 0.75) {
            miss1 = gap1;
            miss2 = gap2;
            trust = 2;
        } else {
            miss1 = 0.0;
            miss2 = 0.0;
            trust = self.trust.saturating_sub(1);
        }
        if !(trust > 0) {
            return Err(Error::Input);
        }
        let off1 = miss1;
        let off2 = (11.271489 * miss1) + miss2;
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f32;
        let l1_1: f32;
        let l1_2: f32;
        let l1_3: f32;
        let l2_1: f32;
        let l2_2: f32;
        let l2_3: f32;
        if o0 > 7.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            l1_1 = ((Self::Q1_1_1 + (Self::Q1_1_2 * o0)) * r0) - 0.021203334;
            l1_2 = ((Self::Q1_2_1 + (Self::Q1_2_2 * o0)) * r0) - 1.242789;
            l1_3 = ((Self::Q1_3_1 + (Self::Q1_3_2 * o0)) * r0) + 5.3316126;
            l2_1 = 0.0;
            l2_2 = (Self::Q2_2_1 * r0) + 0.112953566;
            l2_3 = (Self::Q2_3_1 * r0) - 0.45181426;
        } else if left_o == 7 {
            l1_1 = Self::E0_1_1;
            l1_2 = Self::E0_1_2;
            l1_3 = Self::E0_1_3;
            l2_1 = 0.0;
            l2_2 = Self::E0_2_2;
            l2_3 = Self::E0_2_3;
        } else {
            l1_1 = Self::E1_1_1;
            l1_2 = Self::E1_1_2;
            l1_3 = Self::E1_1_3;
            l2_1 = 0.0;
            l2_2 = Self::E1_2_2;
            l2_3 = Self::E1_2_3;
        }
        let s1 = x1 + (Self::PHI1_2 * x2) + (Self::PHI1_3 * x3);
        let x1_on = s1 + (l1_1 * off1) + (l2_1 * off2);
        let s2 = (Self::PHI2_2 * x2) + (Self::PHI2_3 * x3) + (l1_2 * off1);
        let x2_on = s2 + (l2_2 * off2);
        let s3 = (Self::PHI3_2 * x2) + (Self::PHI3_3 * x3) + (l1_3 * off1);
        let x3_on = s3 + (l2_3 * off2);
        if !(x1.is_finite()
            && x1_on.is_finite()
            && x2.is_finite()
            && x2_on.is_finite()
            && x3.is_finite()
            && x3_on.is_finite())
        {
            return Err(Error::Range);
        }
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.seen = 1;
        self.trust = trust;
        if trust < 2 {
            Ok(Status::Gated)
        } else if left_o == 0 {
            Ok(Status::Hold)
        } else {
            Ok(Status::Ok)
        }
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f32; 3] {
        [self.x1_hat, self.x2_hat, self.x3_hat]
    }
}
