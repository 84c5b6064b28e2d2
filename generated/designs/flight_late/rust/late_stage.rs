//! Prescribed-time controller late_stage: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
//! Version 0.1.0, design ccd999de2243.
//!
//! Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
//!       sample late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
//!       the rows are those of Theorem 1 for the mapping exp. From 50 samples to go on these
//!       are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
//!       go stay.
//!
//! Parameters:
//!   samples = 800 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   u_max = 6 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates are exact from sample 200 after the start on where the measurement is; with
//!       noise or sensor_step given, or observer_eps, the gains of the observer are then held
//!       below deadbeat.
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
//!       so their Bernstein coefficients, linear in z, bound them. If these are within the
//!       limits, u stay there at every sample to rest, where plant and state are as they are
//!       known.
//! late extend: a step without such a plan raises N to the soonest that has one (status LATE;
//!       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
//!       after the start, N stays, and u is clipped; states may leave their bounds then.
//! reserve: a new deadline leaves 0.1 of each limit free.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
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

/// Run-time parameters of [`LateStage`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct LateStageParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct LateStage {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest, as planned now.
    last: u32,
    /// input of the last sample.
    u1: f64,
    /// input of 2 samples ago.
    u2: f64,
    /// samples of the observer's round left at the start.
    round: u32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// estimate of d.
    d_hat: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl LateStage {
    /// 1/1000, prediction of x1 from x2.
    const PHI1_2: f64 = 0.001;
    /// 1/3000000, prediction of x1 from d.
    const PHI1_3: f64 = 3.3333333333333335e-7;
    /// 1/3000000, prediction from u.
    const GAMMA1: f64 = 3.3333333333333335e-7;
    /// 1/1500, prediction of x2 from d.
    const PHI2_3: f64 = 0.0006666666666666666;
    /// 1/1500, prediction from u.
    const GAMMA2: f64 = 0.0006666666666666666;
    /// Samples to go at which the observer is held.
    const HOLD_O: f64 = 30.0;
    /// Weight in the observer's gain l1.
    const Q1_1: f64 = 120.0;
    /// Weight in the observer's gain l1.
    const Q1_2: f64 = -60.0;
    /// Weight in the observer's gain l1.
    const Q1_3: f64 = 12.0;
    /// Weight in the observer's gain l2.
    const Q2_1: f64 = -108000.0;
    /// Weight in the observer's gain l2.
    const Q2_2: f64 = 36000.0;
    /// Weight in the observer's gain l3.
    const Q3_1: f64 = 36000000.0;
    /// Weight of x1 in the law.
    const S1_1: f64 = 1500000.0;
    /// Weight of x2 in the law.
    const S1_2: f64 = 750.0;
    /// Weight of x2 in the law.
    const S2_2: f64 = 1500.0;
    /// Bound of |u|.
    const U_MAX: f64 = 6.0;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 20.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES: f64 = 50.0;
    /// Weight of x1 in the law.
    const W1_1: f64 = -9000000.0;
    /// Weight of x2 in the law.
    const W1_2: f64 = -4500.0;
    /// Weight of x2 in the law.
    const W2_2: f64 = -6000.0;
    /// Weight of u1 in the law.
    const W2_3: f64 = -4.0;
    /// Weight of x1 in the law.
    const END1_1: f64 = -18000000.0;
    /// Weight of x2 in the law.
    const END1_2: f64 = -9000.0;
    /// Weight of x2 in the law.
    const END2_2: f64 = -9000.0;
    /// Weight of u1 in the law.
    const END2_3: f64 = -6.0;
    /// -1/1000, a state of a sample ago.
    const BACK1_2: f64 = -0.001;
    /// 1/3000000, a state of a sample ago.
    const BACK1_3: f64 = 3.3333333333333335e-7;
    /// -1/1500, a state of a sample ago.
    const BACK2_3: f64 = -0.0006666666666666666;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: LateStageParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            last: 800,
            u1: 0.0,
            u2: 0.0,
            round: 200,
            seen: 0,
            x1_hat: 0.0,
            x2_hat: 0.0,
            d_hat: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 800;
        self.round = 200;
        let size = (self.x1_hat).abs() + (self.x2_hat).abs() + (self.d_hat).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x2_hat = 0.0;
            self.d_hat = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // Predict.
        let s1 = self.x1_hat + (Self::PHI1_2 * self.x2_hat);
        let s2 = s1 + (Self::PHI1_3 * self.d_hat);
        let p1 = s2 + (Self::GAMMA1 * self.u2);
        let s3 = self.x2_hat + (Self::PHI2_3 * self.d_hat);
        let p2 = s3 + (Self::GAMMA2 * self.u2);
        let p3 = self.d_hat;

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
        let left_o = self.round.saturating_sub(elapsed);
        let o0 = if (left_o as f64) < Self::HOLD_O {
            Self::HOLD_O
        } else {
            left_o as f64
        };
        let l1: f64;
        let l2: f64;
        let l3: f64;
        let o0f2 = o0 * (o0 - 1.0);
        let r0 = 1.0 / (o0f2 * (o0 - 2.0));
        l1 = (Self::Q1_1 + (Self::Q1_2 * o0) + (Self::Q1_3 * o0f2)) * r0;
        l2 = (Self::Q2_1 + (Self::Q2_2 * o0)) * r0;
        l3 = Self::Q3_1 * r0;
        let x1 = base + (l1 * miss);
        let x2 = p2 + (l2 * miss);
        let d = p3 + (l3 * miss);

        // The deadline that keeps the limits.
        let mut last_now = self.last;
        let mut late = 0_u32;
        let to_rest = self.last.saturating_sub(elapsed);
        let ahead = to_rest.saturating_sub(1);
        let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2);
        let flat2 = (Self::S2_2 * x2) + (self.u1 + d);
        let mut low = ahead.saturating_sub(1);
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = ahead;
        let mut part = 0.9999999999998739;
        for _ in 0..64 {
            let least = ((-Self::U_MAX) * part) + d;
            let most = (Self::U_MAX * part) + d;
            let within = if -least < most { -least } else { most };
            let mut fits = 0_u32;
            if tried > 50 {
                let m = tried as f64;
                let power1 = m + 1.0;
                let power2 = power1 * m;
                let power3 = power2 * (m - 1.0);
                let scaled2 = flat2 * power1;
                let w1 = ((3.0 * flat1) + scaled2) / power2;
                let w2 = (((-2.0) * flat1) - scaled2) / power3;
                let length = m - 51.0;
                let b0_c = (2.0 * w1) + (300.0 * w2);
                let b1_c = 6.0 * w2 * length;
                let b1 = b0_c + b1_c;
                let end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                let end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                let end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                let end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                let end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                let end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                let end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                if (least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= end11)
                    && (end11 <= most)
                    && (least <= end12)
                    && (end12 <= most)
                    && (least <= end13)
                    && (end13 <= most)
                    && (least <= end14)
                    && (end14 <= most)
                    && (least <= end15)
                    && (end15 <= most)
                    && (least <= end16)
                    && (end16 <= most)
                    && (least <= end17)
                    && (end17 <= most)
                    && (((2.8054298642533926 * w1) + (111.58371040723979 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.583924302196364 * w1) + (85.00144425360725 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((1.9885945165034657 * w1) + (61.86959300518941 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.9380703330283167 * w1) + (105.39729178384643 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.395997187424203 * w1) + (77.20565274199532 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.8712027904432142 * w1) + (99.5000219686458 * w2)).abs() <= 0.9850746268656713 * within)
                {
                    fits = 1;
                }
            } else if tried > 20 {
                let m = tried as f64;
                let power1 = m + 2.0;
                let power2 = power1 * (m + 1.0);
                let power3 = power2 * m;
                let power4 = power3 * (m - 1.0);
                let scaled2 = flat2 * power1;
                let w1 = ((4.0 * flat1) + scaled2) / power3;
                let w2 = (((-3.0) * flat1) - scaled2) / power4;
                let length = m - 21.0;
                let b0_c = (126.0 * w1) + (5040.0 * w2);
                let b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                let b2_l = length * length;
                let b2_c = 12.0 * w2 * b2_l;
                let b1 = b0_c + (0.16666666666666666 * b1_c);
                let s4 = b0_c + (0.3333333333333333 * b1_c);
                let b2 = s4 + (0.06666666666666667 * b2_c);
                let b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                let b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                let s5 = b0_c + (0.8333333333333334 * b1_c);
                let b5 = s5 + (0.6666666666666666 * b2_c);
                let b6 = b0_c + b1_c + b2_c;
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
                    && (((119.99999999999996 * w1) + (4559.999999999999 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((92.75321716019634 * w1) + (2422.754466594877 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((67.8353765546998 * w1) + (1509.7849977027897 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((114.21150278293138 * w1) + (3629.3877551020414 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((84.39364430426792 * w1) + (2085.179889377806 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((108.11363033997543 * w1) + (3196.9332337421392 * w2)).abs() <= 0.9850746268656713 * within)
                {
                    fits = 1;
                }
            } else if ((((-0.025974025974025976) * flat1) - (0.2857142857142857 * flat2)).abs() <= 0.9850746268656713 * within)
                && ((((-0.0012475444042476065) * flat1) - (0.08276232337733669 * flat2)).abs() <= 0.9850746268656713 * within)
                && (((0.0035664936491730252 * flat1) - (0.02768331367963576 * flat2)).abs() <= 0.9850746268656713 * within)
                && ((((-0.012577404043081223) * flat1) - (0.18287834614365228 * flat2)).abs() <= 0.9850746268656713 * within)
                && (((0.000902126332826074 * flat1) - (0.060363489673773814 * flat2)).abs() <= 0.9850746268656713 * within)
                && ((((-0.007827317130259085) * flat1) - (0.14320479414568998 * flat2)).abs() <= 0.9850746268656713 * within)
            {
                fits = 1;
            }
            if fits == 1 {
                kept = tried;
                top = tried;
            } else if tried > 20 {
                low = tried;
            } else {
                low = 20;
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
            part = 0.899999999999773;
        }
        if (ahead < kept) && (elapsed < 2147483648) {
            last_now = (elapsed + kept) + 1;
        }
        if (kept == 0) && (ahead > 0) {
            late = 2;
        }
        if last_now > self.last {
            late = 1;
        }
        let left = last_now.saturating_sub(elapsed);
        let s6 = (left as f64) - 1.0;
        let m0 = if s6 < Self::HOLD { Self::HOLD } else { s6 };
        let v: f64;
        if m0 > Self::END_SAMPLES {
            // The exact law in samples.
            let z1 = (Self::W1_1 * x1) + (Self::W1_2 * x2);
            let z2 = (Self::W2_2 * x2) + (Self::W2_3 * (self.u1 + d));
            let m0f1 = m0 + 1.0;
            v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
        } else {
            // The law of least energy to the end.
            let m1 = if m0 < 2.0 { 2.0 } else { m0 };
            let y1 = (Self::END1_1 * x1) + (Self::END1_2 * x2);
            let y2 = (Self::END2_2 * x2) + (Self::END2_3 * (self.u1 + d));
            let m1f1 = m1 + 2.0;
            v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
        }
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f64;
        if v > Self::U_MAX {
            u_now = Self::U_MAX;
        } else if v < -Self::U_MAX {
            u_now = -Self::U_MAX;
        } else {
            u_now = v;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        self.last = last_now;
        self.x1_hat = x1;
        self.x2_hat = x2;
        self.d_hat = d;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f64) - 1.0 <= Self::HOLD {
            Status::Hold
        } else if late == 2 {
            Status::Infeasible
        } else if late == 1 {
            Status::Late
        } else {
            Status::Ok
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
        let elapsed = k.wrapping_sub(self.start);
        self.round = self.round.saturating_sub(elapsed);
        self.start = k;
        self.last = samples;
        Ok(())
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the estimates as they are
    /// predicted for the next tick, for sure. Give them to `arm_for`.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: a state is too large to
    /// compute with. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn soonest(&self) -> Result<u32, Error> {
        let s1 = self.x1_hat + (Self::PHI1_2 * self.x2_hat);
        let s2 = s1 + (Self::PHI1_3 * self.d_hat);
        let p1 = s2 + (Self::GAMMA1 * self.u2);
        let s3 = self.x2_hat + (Self::PHI2_3 * self.d_hat);
        let p2 = s3 + (Self::GAMMA2 * self.u2);
        let p3 = self.d_hat;
        let x1 = p1;
        let x2 = p2;
        let d = p3;
        let flat1 = (Self::S1_1 * x1) + (Self::S1_2 * x2);
        let flat2 = (Self::S2_2 * x2) + (self.u1 + d);
        let mut low = 20_u32;
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = 21_u32;
        for _ in 0..64 {
            let least = (0.899999999999773 * (-Self::U_MAX)) + d;
            let most = (0.899999999999773 * Self::U_MAX) + d;
            let within = if -least < most { -least } else { most };
            let mut fits = 0_u32;
            if tried > 50 {
                let m = tried as f64;
                let power1 = m + 1.0;
                let power2 = power1 * m;
                let power3 = power2 * (m - 1.0);
                let scaled2 = flat2 * power1;
                let w1 = ((3.0 * flat1) + scaled2) / power2;
                let w2 = (((-2.0) * flat1) - scaled2) / power3;
                let length = m - 51.0;
                let b0_c = (2.0 * w1) + (300.0 * w2);
                let b1_c = 6.0 * w2 * length;
                let b1 = b0_c + b1_c;
                let end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                let end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                let end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                let end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                let end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                let end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                let end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                if (least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= end11)
                    && (end11 <= most)
                    && (least <= end12)
                    && (end12 <= most)
                    && (least <= end13)
                    && (end13 <= most)
                    && (least <= end14)
                    && (end14 <= most)
                    && (least <= end15)
                    && (end15 <= most)
                    && (least <= end16)
                    && (end16 <= most)
                    && (least <= end17)
                    && (end17 <= most)
                    && (((2.8054298642533926 * w1) + (111.58371040723979 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.583924302196364 * w1) + (85.00144425360725 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((1.9885945165034657 * w1) + (61.86959300518941 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.9380703330283167 * w1) + (105.39729178384643 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.395997187424203 * w1) + (77.20565274199532 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((2.8712027904432142 * w1) + (99.5000219686458 * w2)).abs() <= 0.9850746268656713 * within)
                {
                    fits = 1;
                }
            } else {
                let m = tried as f64;
                let power1 = m + 2.0;
                let power2 = power1 * (m + 1.0);
                let power3 = power2 * m;
                let power4 = power3 * (m - 1.0);
                let scaled2 = flat2 * power1;
                let w1 = ((4.0 * flat1) + scaled2) / power3;
                let w2 = (((-3.0) * flat1) - scaled2) / power4;
                let length = m - 21.0;
                let b0_c = (126.0 * w1) + (5040.0 * w2);
                let b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                let b2_l = length * length;
                let b2_c = 12.0 * w2 * b2_l;
                let b1 = b0_c + (0.16666666666666666 * b1_c);
                let s4 = b0_c + (0.3333333333333333 * b1_c);
                let b2 = s4 + (0.06666666666666667 * b2_c);
                let b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                let b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                let s5 = b0_c + (0.8333333333333334 * b1_c);
                let b5 = s5 + (0.6666666666666666 * b2_c);
                let b6 = b0_c + b1_c + b2_c;
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
                    && (((119.99999999999996 * w1) + (4559.999999999999 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((92.75321716019634 * w1) + (2422.754466594877 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((67.8353765546998 * w1) + (1509.7849977027897 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((114.21150278293138 * w1) + (3629.3877551020414 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((84.39364430426792 * w1) + (2085.179889377806 * w2)).abs() <= 0.9850746268656713 * within)
                    && (((108.11363033997543 * w1) + (3196.9332337421392 * w2)).abs() <= 0.9850746268656713 * within)
                {
                    fits = 1;
                }
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
        if flat1.is_finite() && flat2.is_finite() {
            if kept > 0 {
                Ok(kept + 1)
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

    /// The target moves by `dx`: from now on y is measured from the new one, and so are the
    /// estimates.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn r#move(&mut self, dx: f64) -> Result<(), Error> {
        let moved = self.x1_hat - dx;
        if !moved.is_finite() {
            return Err(Error::Input);
        }
        self.x1_hat = moved;
        Ok(())
    }

    /// The estimates at the tick of the next call are known: it corrects them by what is measured
    /// then.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn assume(&mut self, xhat: &[f64; 2]) -> Result<(), Error> {
        let g1 = xhat[0] - (Self::GAMMA1 * self.u2);
        let g2 = xhat[1] - (Self::GAMMA2 * self.u2);
        let n1 = g1 + (Self::BACK1_2 * g2) + (Self::BACK1_3 * self.d_hat);
        let n2 = g2 + (Self::BACK2_3 * self.d_hat);
        if !(n1.is_finite() && n2.is_finite()) {
            return Err(Error::Input);
        }
        self.x1_hat = n1;
        self.x2_hat = n2;
        self.seen = 1;
        Ok(())
    }

    /// The constant that is added to u is known.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn assume_disturbance(&mut self, d: f64) -> Result<(), Error> {
        if !d.is_finite() {
            return Err(Error::Input);
        }
        self.d_hat = d;
        Ok(())
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

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
