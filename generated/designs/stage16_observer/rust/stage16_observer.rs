//! Prescribed-time observer stage16_observer: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1
//! Version 0.1.0, design 76c16d95e916.
//!
//! Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
//!       sample to sample, one sample late, y = C x.
//! Goal: the estimates of the state and of d are exact up to rounding from sample 20 after the
//!       start on, from any state and at any sample period, as long as the measurement is
//!       exact, u is what was applied and nothing else acts on the plant.
//! Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
//!       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
//!       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
//!       the end deadbeat takes over.
//!
//! Parameters:
//!   h = 1e-3 [s], fixed: sample period
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - 20 samples.
//! u is the input of tick k - 1 as it was applied, after clipping: it acts from tick k to tick
//!       k + 1, and the observer keeps it until then.
//! From sample 20 on the status is HOLD; from there on the observer has the poles
//!       after_observer.
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

/// Run-time parameters of [`Stage16Observer`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage16ObserverParams {}

/// Prescribed-time observer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage16Observer {
    /// tick at which it was armed.
    start: u32,
    /// input of 2 samples ago.
    u1: f64,
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
impl Stage16Observer {
    /// Prediction from u.
    const GAMMA1: f64 = 0.00010816330676811052;
    /// Prediction from u.
    const GAMMA2: f64 = 0.30941358230147875;
    /// Prediction from u.
    const GAMMA3: f64 = 0.37459048481653323;
    /// Samples of the round of the observer.
    const OBSERVER_SAMPLES: u32 = 20;
    /// Weight in the observer's gain l1_1.
    const Q1_1_1: f64 = -8.0;
    /// Weight in the observer's gain l1_1.
    const Q1_1_2: f64 = 8.0;
    /// Weight in the observer's gain l1_2.
    const Q1_2_1: f64 = 12007.013438558752;
    /// Weight in the observer's gain l1_2.
    const Q1_2_2: f64 = -4.007472019404232;
    /// Weight in the observer's gain l1_4.
    const Q1_4_1: f64 = 359.9910335767149;
    /// Weight in the observer's gain l2_2.
    const Q2_2_1: f64 = -18.578489051610646;
    /// Weight in the observer's gain l2_2.
    const Q2_2_2: f64 = 9.913794744612098;
    /// Weight in the observer's gain l2_3.
    const Q2_3_1: f64 = -12.0;
    /// Weight in the observer's gain l2_3.
    const Q2_3_2: f64 = 12.0;
    /// Weight in the observer's gain l2_4.
    const Q2_4_1: f64 = 79.8275894892242;
    /// Gain of the observer at its end.
    const E0_1_1: f64 = 0.9995008164815138;
    /// Gain of the observer at its end.
    const E0_1_2: f64 = -0.4960345371406728;
    /// Gain of the observer at its end.
    const E0_1_3: f64 = 0.005627803367048088;
    /// Gain of the observer at its end.
    const E0_2_1: f64 = 0.0014420897963740578;
    /// Gain of the observer at its end.
    const E0_2_2: f64 = 2.2101945239792857;
    /// Gain of the observer at its end.
    const E0_2_3: f64 = 1.0319275340206813;
    /// Gain of the observer at its end.
    const E0_2_4: f64 = 1.3304598248204031;
    /// Gain of the observer at its end.
    const E1_1_1: f64 = 1.9995008164815138;
    /// Gain of the observer at its end.
    const E1_1_2: f64 = 999.2535286720462;
    /// Gain of the observer at its end.
    const E1_1_3: f64 = 0.005627803367048088;
    /// Gain of the observer at its end.
    const E1_1_4: f64 = 29.999252798059576;
    /// Gain of the observer at its end.
    const E1_2_1: f64 = 0.0014420897963740578;
    /// Gain of the observer at its end.
    const E1_2_2: f64 = 2.4788577332214805;
    /// Gain of the observer at its end.
    const E1_2_3: f64 = 1.5319275340206813;
    /// Gain of the observer at its end.
    const E1_2_4: f64 = 2.6609196496408063;
    /// Prediction of x1 from x2.
    const PHI1_2: f64 = 0.000996505559752715;
    /// Prediction of x1 from x3.
    const PHI1_3: f64 = 0.0006188271646029575;
    /// Prediction of x1 from d.
    const PHI1_4: f64 = 0.00010816330676811052;
    /// Prediction of x2 from x2.
    const PHI2_2: f64 = 0.9902193397510792;
    /// Prediction of x2 from x3.
    const PHI2_3: f64 = 1.1234620408672982;
    /// Prediction of x2 from d.
    const PHI2_4: f64 = 0.30941358230147875;
    /// Prediction of x3 from x2.
    const PHI3_2: f64 = -0.011234620408672982;
    /// Prediction of x3 from x3.
    const PHI3_3: f64 = 0.5412090107511158;
    /// Prediction of x3 from d.
    const PHI3_4: f64 = 0.37459048481653323;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage16ObserverParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
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

    /// Starts a round of 20 samples at tick `k`. Estimates and inputs under way are kept. Estimates
    /// too large to compute with begin anew.
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

    /// The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and
    /// u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows
    /// in the estimates from the next tick on. Call it once for each tick, before the law, which
    /// takes its estimates. Status Hold from sample 20 on: the round is over.
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

        // The estimates; at first what y shows.
        let x1: f64;
        let x2: f64;
        let x3: f64;
        let d: f64;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            x3 = y[1];
            d = 0.0;
        } else {
            x1 = self.x1_next + (Self::GAMMA1 * self.u1);
            x2 = self.x2_next + (Self::GAMMA2 * self.u1);
            x3 = self.x3_next + (Self::GAMMA3 * self.u1);
            d = self.d_next;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let miss2 = y[1] - x3;
        let off1 = miss1;
        let off2 = miss2;
        let left_o = Self::OBSERVER_SAMPLES.saturating_sub(elapsed);
        let o0 = left_o as f64;
        let l1_1: f64;
        let l1_2: f64;
        let l1_3: f64;
        let l1_4: f64;
        let l2_1: f64;
        let l2_2: f64;
        let l2_3: f64;
        let l2_4: f64;
        if left_o == 0 {
            l1_1 = 0.17200400622757925;
            l1_2 = 7.693835124666324;
            l1_3 = 0.005627803367048088;
            l1_4 = 0.23319622641969587;
            l2_1 = 0.0014420897963740578;
            l2_2 = 1.2843129003368876;
            l2_3 = -0.2598303207324358;
            l2_4 = 0.028634005234458536;
        } else if o0 > 8.0 {
            let r0 = 1.0 / (o0 * (o0 - 1.0));
            let s1 = (Self::Q1_1_1 + (Self::Q1_1_2 * o0)) * r0;
            l1_1 = s1 - 0.0004991835184862197;
            let s2 = (Self::Q1_2_1 + (Self::Q1_2_2 * o0)) * r0;
            l1_2 = s2 + 0.004899465284856127;
            l1_3 = 0.005627803367048088;
            l1_4 = Self::Q1_4_1 * r0;
            l2_1 = 0.0014420897963740578;
            let s3 = (Self::Q2_2_1 + (Self::Q2_2_2 * o0)) * r0;
            l2_2 = s3 + 1.1153817526860825;
            let s4 = (Self::Q2_3_1 + (Self::Q2_3_2 * o0)) * r0;
            l2_3 = s4 - 0.46807246597931873;
            l2_4 = Self::Q2_4_1 * r0;
        } else if left_o == 8 {
            l1_1 = Self::E0_1_1;
            l1_2 = Self::E0_1_2;
            l1_3 = Self::E0_1_3;
            l1_4 = 0.0;
            l2_1 = Self::E0_2_1;
            l2_2 = Self::E0_2_2;
            l2_3 = Self::E0_2_3;
            l2_4 = Self::E0_2_4;
        } else {
            l1_1 = Self::E1_1_1;
            l1_2 = Self::E1_1_2;
            l1_3 = Self::E1_1_3;
            l1_4 = Self::E1_1_4;
            l2_1 = Self::E1_2_1;
            l2_2 = Self::E1_2_2;
            l2_3 = Self::E1_2_3;
            l2_4 = Self::E1_2_4;
        }
        let s5 = x1 + (Self::PHI1_2 * x2) + (Self::PHI1_3 * x3);
        let x1_on = s5 + (Self::PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
        let s6 = (Self::PHI2_2 * x2) + (Self::PHI2_3 * x3);
        let x2_on = s6 + (Self::PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
        let s7 = (Self::PHI3_2 * x2) + (Self::PHI3_3 * x3);
        let x3_on = s7 + (Self::PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
        let d_on = d + (l1_4 * off1) + (l2_4 * off2);
        if !(x1.is_finite()
            && x1_on.is_finite()
            && x2.is_finite()
            && x2_on.is_finite()
            && x3.is_finite()
            && x3_on.is_finite()
            && d.is_finite()
            && d_on.is_finite())
        {
            return Err(Error::Range);
        }
        self.u1 = u;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.x3_hat = x3;
        self.x3_next = x3_on;
        self.d_hat = d;
        self.d_next = d_on;
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

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
