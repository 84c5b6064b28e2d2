//! Prescribed-time controller gantry_in_flight: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --axes 3 --mu "exp(a=1)" --name gantry_in_flight --clock samples --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --pace=soonest --state-max="[[inf,1.5],[inf,inf],[inf,0.4]]" --reserve=0.1 --tau=1.5 --eps=0.02 --limits="[[-900,900],[-400,400],[-150,60]]" --poles=least-energy --g="[1/120, 1/45, 1/12]" --sample-time=1e-3
//! Version 0.1.0, design a53c299184a8.
//!
//! Plant: x1' = x2, x2' = g u; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 1 samples to go and z = S x, u h^2 = sum of row_j z_j
//!       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. From
//!       50 samples to go on these are M - 2 and the exponents 3, 4, those of least energy.
//!       The gains of 20 samples to go stay.
//! Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
//!       on time once.
//!   axis 1: u_min = -900, u_max = 900; state_max = inf, 1.5; g = 1/120
//!   axis 2: u_min = -400, u_max = 400; state_max = inf, inf; g = 1/45
//!   axis 3: u_min = -150, u_max = 60; state_max = inf, 0.4; g = 1/12
//!
//! Parameters:
//!   samples = 1500 [samples], fixed: samples N from the start to rest
//!   h = 1e-3 [s], fixed: sample period
//!   eps = 0.02 [s], fixed: time-to-go at which the gains are held
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
//!       so their Bernstein coefficients, linear in z, bound them. If these are within the
//!       limits, u and the states stay there at every sample to rest, where plant and state
//!       are as they are known.
//! Axes: all come to rest at the same sample, and each deadline is tested for every one of
//!       them.
//! late extend: a step without such a plan raises N to the soonest that has one (status LATE;
//!       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
//!       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
//!       stays, and u is clipped; states may leave their bounds then.
//! reserve: a new deadline leaves 0.1 of each limit free.
//! u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
//!       deadline where it lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 1500, not at rest: the gains are held from 20 samples
//!       to go, and |u| is bounded.
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

/// Result of a step of several axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f64> {
    /// Inputs of the plants; 0 where `status` is an error.
    pub u: [R; M],
    /// Status of each axis.
    pub axes: [Result<Status, Error>; M],
    /// The error of the first axis that fails; else `Saturated` where one is, else that of the gains.
    pub status: Result<Status, Error>,
}

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

/// Run-time parameters of [`GantryInFlight`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct GantryInFlightParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct GantryInFlight {
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
impl GantryInFlight {
    /// Weight of x1 in the law.
    const S1_1_1: f64 = 120000000.0;
    /// Weight of x2 in the law.
    const S1_2_1: f64 = -60000.0;
    /// Weight of x2 in the law.
    const S2_2_1: f64 = 120000.0;
    /// Weight of x1 in the law.
    const S1_1_2: f64 = 45000000.0;
    /// Weight of x2 in the law.
    const S1_2_2: f64 = -22500.0;
    /// Weight of x2 in the law.
    const S2_2_2: f64 = 45000.0;
    /// Weight of x1 in the law.
    const S1_1_3: f64 = 12000000.0;
    /// Weight of x2 in the law.
    const S1_2_3: f64 = -6000.0;
    /// Weight of x2 in the law.
    const S2_2_3: f64 = 12000.0;
    /// Lower limit of u.
    const U_MIN_1: f64 = -900.0;
    /// Upper limit of u.
    const U_MAX_1: f64 = 900.0;
    /// Lower limit of u.
    const U_MIN_2: f64 = -400.0;
    /// Upper limit of u.
    const U_MAX_2: f64 = 400.0;
    /// Lower limit of u.
    const U_MIN_3: f64 = -150.0;
    /// Upper limit of u.
    const U_MAX_3: f64 = 60.0;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 20.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_1: f64 = 50.0;
    /// Weight of x1 in the law.
    const W1_1_1: f64 = -720000000.0;
    /// Weight of x2 in the law.
    const W1_2_1: f64 = 360000.0;
    /// Weight of x2 in the law.
    const W2_2_1: f64 = -480000.0;
    /// Weight of x1 in the law.
    const END1_1_1: f64 = -1440000000.0;
    /// Weight of x2 in the law.
    const END1_2_1: f64 = 720000.0;
    /// Weight of x2 in the law.
    const END2_2_1: f64 = -720000.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_2: f64 = 50.0;
    /// Weight of x1 in the law.
    const W1_1_2: f64 = -270000000.0;
    /// Weight of x2 in the law.
    const W1_2_2: f64 = 135000.0;
    /// Weight of x2 in the law.
    const W2_2_2: f64 = -180000.0;
    /// Weight of x1 in the law.
    const END1_1_2: f64 = -540000000.0;
    /// Weight of x2 in the law.
    const END1_2_2: f64 = 270000.0;
    /// Weight of x2 in the law.
    const END2_2_2: f64 = -270000.0;
    /// Samples to go at which the law of the end takes over.
    const END_SAMPLES_3: f64 = 50.0;
    /// Weight of x1 in the law.
    const W1_1_3: f64 = -72000000.0;
    /// Weight of x2 in the law.
    const W1_2_3: f64 = 36000.0;
    /// Weight of x2 in the law.
    const W2_2_3: f64 = -48000.0;
    /// Weight of x1 in the law.
    const END1_1_3: f64 = -144000000.0;
    /// Weight of x2 in the law.
    const END1_2_3: f64 = 72000.0;
    /// Weight of x2 in the law.
    const END2_2_3: f64 = -72000.0;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: GantryInFlightParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            last: 1500,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 1500;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[[f64; 2]; 3]) -> Axes<3, f64> {
        let failed = |error| Axes {
            u: [0.0; 3],
            axes: [Err(error); 3],
            status: Err(error),
        };
        let mut u = [0.0; 3];
        let mut axes = [Ok(Status::Ok); 3];
        let mut status;
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[2][0].is_finite()
            && x[2][1].is_finite())
        {
            return failed(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x1_3 = x[2][0];
        let x2_3 = x[2][1];

        // The deadline that keeps the limits.
        let mut last_now = self.last;
        let mut late = 0_u32;
        let to_rest = self.last.saturating_sub(elapsed);
        let ahead = to_rest;
        let flat1_1 = (Self::S1_1_1 * x1_1) + (Self::S1_2_1 * x2_1);
        let flat2_1 = Self::S2_2_1 * x2_1;
        let flat1_2 = (Self::S1_1_2 * x1_2) + (Self::S1_2_2 * x2_2);
        let flat2_2 = Self::S2_2_2 * x2_2;
        let flat1_3 = (Self::S1_1_3 * x1_3) + (Self::S1_2_3 * x2_3);
        let flat2_3 = Self::S2_2_3 * x2_3;
        let mut below = ahead.saturating_sub(1).saturating_sub(ahead / 16);
        if ahead > 20 {
            if below < 20 {
                below = 20;
            }
        } else {
            below = ahead.saturating_sub(1);
        }
        let mut low = below;
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = ahead;
        let mut part = 0.9999999999998739;
        for _ in 0..64 {
            let least_1 = Self::U_MIN_1 * part;
            let most_1 = Self::U_MAX_1 * part;
            let within_1 = if -least_1 < most_1 { -least_1 } else { most_1 };
            let most2_1 = 1.5 * part;
            let least_2 = Self::U_MIN_2 * part;
            let most_2 = Self::U_MAX_2 * part;
            let within_2 = if -least_2 < most_2 { -least_2 } else { most_2 };
            let least_3 = Self::U_MIN_3 * part;
            let most_3 = Self::U_MAX_3 * part;
            let within_3 = if -least_3 < most_3 { -least_3 } else { most_3 };
            let most2_3 = 0.4 * part;
            let mut fits = 0_u32;
            if tried > 50 {
                let m_1 = tried as f64;
                let power1_1 = m_1 + 1.0;
                let power2_1 = power1_1 * m_1;
                let power3_1 = power2_1 * (m_1 - 1.0);
                let scaled2_1 = flat2_1 * power1_1;
                let w1_1 = ((3.0 * flat1_1) + scaled2_1) / power2_1;
                let w2_1 = (((-2.0) * flat1_1) - scaled2_1) / power3_1;
                let length_1 = m_1 - 51.0;
                let b0_c_1 = (2.0 * w1_1) + (300.0 * w2_1);
                let b1_c_1 = 6.0 * w2_1 * length_1;
                let b1_1 = b0_c_1 + b1_c_1;
                let s0_c_1 = ((-0.00085) * w1_1) - (0.06375 * w2_1);
                let s1_c_1 = (((-1.6666666666666667e-5) * w1_1) - (0.002525 * w2_1)) * length_1;
                let s2_l_1 = length_1 * length_1;
                let s2_c_1 = (-2.5e-5) * w2_1 * s2_l_1;
                let s1_1 = s0_c_1 + (0.16666666666666666 * s1_c_1);
                let s1 = s0_c_1 + (0.3333333333333333 * s1_c_1);
                let s2_1 = s1 + (0.06666666666666667 * s2_c_1);
                let s3_1 = s0_c_1 + (0.5 * s1_c_1) + (0.2 * s2_c_1);
                let s4_1 = s0_c_1 + (0.6666666666666666 * s1_c_1) + (0.4 * s2_c_1);
                let s2 = s0_c_1 + (0.8333333333333334 * s1_c_1);
                let s5_1 = s2 + (0.6666666666666666 * s2_c_1);
                let s6_1 = s0_c_1 + s1_c_1 + s2_c_1;
                let end21_1 = (2.8506787330316743 * w1_1) + (117.44796380090497 * w2_1);
                let end22_1 = (3.0475113122171944 * w1_1) + (145.85746606334843 * w2_1);
                let end23_1 = (2.9906485671191554 * w1_1) + (175.02805429864253 * w2_1);
                let end24_1 = (2.6800904977375564 * w1_1) + (204.95972850678734 * w2_1);
                let end25_1 = (2.1158371040723982 * w1_1) + (235.6524886877828 * w2_1);
                let end26_1 = (1.2978883861236803 * w1_1) + (267.10633484162895 * w2_1);
                let end27_1 = (0.22624434389140272 * w1_1) + (299.3212669683258 * w2_1);
                if (least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (least_1 <= end21_1)
                    && (end21_1 <= most_1)
                    && (least_1 <= end22_1)
                    && (end22_1 <= most_1)
                    && (least_1 <= end23_1)
                    && (end23_1 <= most_1)
                    && (least_1 <= end24_1)
                    && (end24_1 <= most_1)
                    && (least_1 <= end25_1)
                    && (end25_1 <= most_1)
                    && (least_1 <= end26_1)
                    && (end26_1 <= most_1)
                    && (least_1 <= end27_1)
                    && (end27_1 <= most_1)
                    && ((((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)).abs() <= most2_1)
                    && ((((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)).abs() <= most2_1)
                    && ((((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)).abs() <= most2_1)
                    && ((((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)).abs() <= most2_1)
                    && ((((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)).abs() <= most2_1)
                    && ((((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)).abs() <= most2_1)
                    && ((((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)).abs() <= most2_1)
                    && ((((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)).abs() <= most2_1)
                    && (((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && ((((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                {
                    fits = 1;
                }
            } else if tried > 20 {
                let m_1 = tried as f64;
                let power1_1 = m_1 + 2.0;
                let power2_1 = power1_1 * (m_1 + 1.0);
                let power3_1 = power2_1 * m_1;
                let power4_1 = power3_1 * (m_1 - 1.0);
                let scaled2_1 = flat2_1 * power1_1;
                let w1_1 = ((4.0 * flat1_1) + scaled2_1) / power3_1;
                let w2_1 = (((-3.0) * flat1_1) - scaled2_1) / power4_1;
                let length_1 = m_1 - 21.0;
                let b0_c_1 = (126.0 * w1_1) + (5040.0 * w2_1);
                let b1_c_1 = ((6.0 * w1_1) + (492.0 * w2_1)) * length_1;
                let b2_l_1 = length_1 * length_1;
                let b2_c_1 = 12.0 * w2_1 * b2_l_1;
                let b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                let s3 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                let b2_1 = s3 + (0.06666666666666667 * b2_c_1);
                let b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                let b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                let s4 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                let b5_1 = s4 + (0.6666666666666666 * b2_c_1);
                let b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                let s0_c_1 = ((-0.01155) * w1_1) - (0.308 * w2_1);
                let s1_c_1 = (((-0.001075) * w1_1) - (0.044066666666666664 * w2_1)) * length_1;
                let s2_l_1 = length_1 * length_1;
                let s2_c_1 = (((-2.5e-5) * w1_1) - (0.0021 * w2_1)) * s2_l_1;
                let s3_l_1 = s2_l_1 * length_1;
                let s3_c_1 = (-3.3333333333333335e-5) * w2_1 * s3_l_1;
                let s1_1 = s0_c_1 + (0.14285714285714285 * s1_c_1);
                let s5 = s0_c_1 + (0.2857142857142857 * s1_c_1);
                let s2_1 = s5 + (0.047619047619047616 * s2_c_1);
                let s6 = s0_c_1 + (0.42857142857142855 * s1_c_1);
                let s7 = s6 + (0.14285714285714285 * s2_c_1);
                let s3_1 = s7 + (0.02857142857142857 * s3_c_1);
                let s8 = s0_c_1 + (0.5714285714285714 * s1_c_1);
                let s9 = s8 + (0.2857142857142857 * s2_c_1);
                let s4_1 = s9 + (0.11428571428571428 * s3_c_1);
                let s10 = s0_c_1 + (0.7142857142857143 * s1_c_1);
                let s11 = s10 + (0.47619047619047616 * s2_c_1);
                let s5_1 = s11 + (0.2857142857142857 * s3_c_1);
                let s12 = s0_c_1 + (0.8571428571428571 * s1_c_1);
                let s13 = s12 + (0.7142857142857143 * s2_c_1);
                let s6_1 = s13 + (0.5714285714285714 * s3_c_1);
                let s7_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1;
                if (least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (least_1 <= b2_1)
                    && (b2_1 <= most_1)
                    && (least_1 <= b3_1)
                    && (b3_1 <= most_1)
                    && (least_1 <= b4_1)
                    && (b4_1 <= most_1)
                    && (least_1 <= b5_1)
                    && (b5_1 <= most_1)
                    && (least_1 <= b6_1)
                    && (b6_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (-most2_1 <= s7_1)
                    && (s7_1 <= most2_1)
                    && (((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && ((((-0.0105) * w1_1) - (0.266 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                {
                    fits = 1;
                }
            } else if ((((-0.025974025974025976) * flat1_1) - (0.2857142857142857 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && ((((-0.0012475444042476065) * flat1_1) - (0.08276232337733669 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && (((0.0035664936491730252 * flat1_1) - (0.02768331367963576 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && ((((-0.012577404043081223) * flat1_1) - (0.18287834614365228 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && (((0.000902126332826074 * flat1_1) - (0.060363489673773814 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && ((((-0.007827317130259085) * flat1_1) - (0.14320479414568998 * flat2_1)).abs() <= 0.9850746268656713 * within_1)
                && ((8.333333333333334e-6 * flat2_1).abs() <= 0.9850746268656717 * most2_1)
                && ((((-5.753277910884418e-7) * flat1_1) + (4.0025382969610726e-7 * flat2_1)).abs() <= 0.9850746268656717 * most2_1)
                && ((((-5.576228651711587e-7) * flat1_1) - (1.1442500457763455e-6 * flat2_1)).abs() <= 0.9850746268656717 * most2_1)
                && ((((-3.7105751391465685e-7) * flat1_1) + (4.035250463821892e-6 * flat2_1)).abs() <= 0.9850746268656717 * most2_1)
                && ((((-5.857239944571719e-7) * flat1_1) - (2.894321984483652e-7 * flat2_1)).abs() <= 0.9850746268656717 * most2_1)
                && ((((-4.75869214273667e-7) * flat1_1) + (2.5112642459581232e-6 * flat2_1)).abs() <= 0.9850746268656717 * most2_1)
            {
                fits = 1;
            }
            if fits == 1 {
                if tried > 50 {
                    let m_2 = tried as f64;
                    let power1_2 = m_2 + 1.0;
                    let power2_2 = power1_2 * m_2;
                    let power3_2 = power2_2 * (m_2 - 1.0);
                    let scaled2_2 = flat2_2 * power1_2;
                    let w1_2 = ((3.0 * flat1_2) + scaled2_2) / power2_2;
                    let w2_2 = (((-2.0) * flat1_2) - scaled2_2) / power3_2;
                    let length_2 = m_2 - 51.0;
                    let b0_c_2 = (2.0 * w1_2) + (300.0 * w2_2);
                    let b1_c_2 = 6.0 * w2_2 * length_2;
                    let b1_2 = b0_c_2 + b1_c_2;
                    let end11_2 = (2.8506787330316743 * w1_2) + (117.44796380090497 * w2_2);
                    let end12_2 = (3.0475113122171944 * w1_2) + (145.85746606334843 * w2_2);
                    let end13_2 = (2.9906485671191554 * w1_2) + (175.02805429864253 * w2_2);
                    let end14_2 = (2.6800904977375564 * w1_2) + (204.95972850678734 * w2_2);
                    let end15_2 = (2.1158371040723982 * w1_2) + (235.6524886877828 * w2_2);
                    let end16_2 = (1.2978883861236803 * w1_2) + (267.10633484162895 * w2_2);
                    let end17_2 = (0.22624434389140272 * w1_2) + (299.3212669683258 * w2_2);
                    if (least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= end11_2)
                        && (end11_2 <= most_2)
                        && (least_2 <= end12_2)
                        && (end12_2 <= most_2)
                        && (least_2 <= end13_2)
                        && (end13_2 <= most_2)
                        && (least_2 <= end14_2)
                        && (end14_2 <= most_2)
                        && (least_2 <= end15_2)
                        && (end15_2 <= most_2)
                        && (least_2 <= end16_2)
                        && (end16_2 <= most_2)
                        && (least_2 <= end17_2)
                        && (end17_2 <= most_2)
                        && (((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                    {
                        fits = 2;
                    }
                } else if tried > 20 {
                    let m_2 = tried as f64;
                    let power1_2 = m_2 + 2.0;
                    let power2_2 = power1_2 * (m_2 + 1.0);
                    let power3_2 = power2_2 * m_2;
                    let power4_2 = power3_2 * (m_2 - 1.0);
                    let scaled2_2 = flat2_2 * power1_2;
                    let w1_2 = ((4.0 * flat1_2) + scaled2_2) / power3_2;
                    let w2_2 = (((-3.0) * flat1_2) - scaled2_2) / power4_2;
                    let length_2 = m_2 - 21.0;
                    let b0_c_2 = (126.0 * w1_2) + (5040.0 * w2_2);
                    let b1_c_2 = ((6.0 * w1_2) + (492.0 * w2_2)) * length_2;
                    let b2_l_2 = length_2 * length_2;
                    let b2_c_2 = 12.0 * w2_2 * b2_l_2;
                    let b1_2 = b0_c_2 + (0.16666666666666666 * b1_c_2);
                    let s14 = b0_c_2 + (0.3333333333333333 * b1_c_2);
                    let b2_2 = s14 + (0.06666666666666667 * b2_c_2);
                    let b3_2 = b0_c_2 + (0.5 * b1_c_2) + (0.2 * b2_c_2);
                    let b4_2 = b0_c_2 + (0.6666666666666666 * b1_c_2) + (0.4 * b2_c_2);
                    let s15 = b0_c_2 + (0.8333333333333334 * b1_c_2);
                    let b5_2 = s15 + (0.6666666666666666 * b2_c_2);
                    let b6_2 = b0_c_2 + b1_c_2 + b2_c_2;
                    if (least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= b2_2)
                        && (b2_2 <= most_2)
                        && (least_2 <= b3_2)
                        && (b3_2 <= most_2)
                        && (least_2 <= b4_2)
                        && (b4_2 <= most_2)
                        && (least_2 <= b5_2)
                        && (b5_2 <= most_2)
                        && (least_2 <= b6_2)
                        && (b6_2 <= most_2)
                        && (((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                    {
                        fits = 2;
                    }
                } else if ((((-0.025974025974025976) * flat1_2) - (0.2857142857142857 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                    && ((((-0.0012475444042476065) * flat1_2) - (0.08276232337733669 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                    && (((0.0035664936491730252 * flat1_2) - (0.02768331367963576 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                    && ((((-0.012577404043081223) * flat1_2) - (0.18287834614365228 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                    && (((0.000902126332826074 * flat1_2) - (0.060363489673773814 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                    && ((((-0.007827317130259085) * flat1_2) - (0.14320479414568998 * flat2_2)).abs() <= 0.9850746268656713 * within_2)
                {
                    fits = 2;
                }
            }
            if fits == 2 {
                if tried > 50 {
                    let m_3 = tried as f64;
                    let power1_3 = m_3 + 1.0;
                    let power2_3 = power1_3 * m_3;
                    let power3_3 = power2_3 * (m_3 - 1.0);
                    let scaled2_3 = flat2_3 * power1_3;
                    let w1_3 = ((3.0 * flat1_3) + scaled2_3) / power2_3;
                    let w2_3 = (((-2.0) * flat1_3) - scaled2_3) / power3_3;
                    let length_3 = m_3 - 51.0;
                    let b0_c_3 = (2.0 * w1_3) + (300.0 * w2_3);
                    let b1_c_3 = 6.0 * w2_3 * length_3;
                    let b1_3 = b0_c_3 + b1_c_3;
                    let s0_c_3 = ((-0.0085) * w1_3) - (0.6375 * w2_3);
                    let s1_c_3 = (((-0.00016666666666666666) * w1_3) - (0.02525 * w2_3)) * length_3;
                    let s2_l_3 = length_3 * length_3;
                    let s2_c_3 = (-0.00025) * w2_3 * s2_l_3;
                    let s1_3 = s0_c_3 + (0.16666666666666666 * s1_c_3);
                    let s16 = s0_c_3 + (0.3333333333333333 * s1_c_3);
                    let s2_3 = s16 + (0.06666666666666667 * s2_c_3);
                    let s3_3 = s0_c_3 + (0.5 * s1_c_3) + (0.2 * s2_c_3);
                    let s4_3 = s0_c_3 + (0.6666666666666666 * s1_c_3) + (0.4 * s2_c_3);
                    let s17 = s0_c_3 + (0.8333333333333334 * s1_c_3);
                    let s5_3 = s17 + (0.6666666666666666 * s2_c_3);
                    let s6_3 = s0_c_3 + s1_c_3 + s2_c_3;
                    let end21_3 = (2.8506787330316743 * w1_3) + (117.44796380090497 * w2_3);
                    let end22_3 = (3.0475113122171944 * w1_3) + (145.85746606334843 * w2_3);
                    let end23_3 = (2.9906485671191554 * w1_3) + (175.02805429864253 * w2_3);
                    let end24_3 = (2.6800904977375564 * w1_3) + (204.95972850678734 * w2_3);
                    let end25_3 = (2.1158371040723982 * w1_3) + (235.6524886877828 * w2_3);
                    let end26_3 = (1.2978883861236803 * w1_3) + (267.10633484162895 * w2_3);
                    let end27_3 = (0.22624434389140272 * w1_3) + (299.3212669683258 * w2_3);
                    if (least_3 <= b0_c_3)
                        && (b0_c_3 <= most_3)
                        && (least_3 <= b1_3)
                        && (b1_3 <= most_3)
                        && (-most2_3 <= s0_c_3)
                        && (s0_c_3 <= most2_3)
                        && (-most2_3 <= s1_3)
                        && (s1_3 <= most2_3)
                        && (-most2_3 <= s2_3)
                        && (s2_3 <= most2_3)
                        && (-most2_3 <= s3_3)
                        && (s3_3 <= most2_3)
                        && (-most2_3 <= s4_3)
                        && (s4_3 <= most2_3)
                        && (-most2_3 <= s5_3)
                        && (s5_3 <= most2_3)
                        && (-most2_3 <= s6_3)
                        && (s6_3 <= most2_3)
                        && (least_3 <= end21_3)
                        && (end21_3 <= most_3)
                        && (least_3 <= end22_3)
                        && (end22_3 <= most_3)
                        && (least_3 <= end23_3)
                        && (end23_3 <= most_3)
                        && (least_3 <= end24_3)
                        && (end24_3 <= most_3)
                        && (least_3 <= end25_3)
                        && (end25_3 <= most_3)
                        && (least_3 <= end26_3)
                        && (end26_3 <= most_3)
                        && (least_3 <= end27_3)
                        && (end27_3 <= most_3)
                        && ((((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)).abs() <= most2_3)
                        && ((((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)).abs() <= most2_3)
                        && ((((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)).abs() <= most2_3)
                        && ((((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)).abs() <= most2_3)
                        && ((((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)).abs() <= most2_3)
                        && ((((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)).abs() <= most2_3)
                        && ((((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)).abs() <= most2_3)
                        && ((((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)).abs() <= most2_3)
                        && (((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && ((((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                    {
                        fits = 3;
                    }
                } else if tried > 20 {
                    let m_3 = tried as f64;
                    let power1_3 = m_3 + 2.0;
                    let power2_3 = power1_3 * (m_3 + 1.0);
                    let power3_3 = power2_3 * m_3;
                    let power4_3 = power3_3 * (m_3 - 1.0);
                    let scaled2_3 = flat2_3 * power1_3;
                    let w1_3 = ((4.0 * flat1_3) + scaled2_3) / power3_3;
                    let w2_3 = (((-3.0) * flat1_3) - scaled2_3) / power4_3;
                    let length_3 = m_3 - 21.0;
                    let b0_c_3 = (126.0 * w1_3) + (5040.0 * w2_3);
                    let b1_c_3 = ((6.0 * w1_3) + (492.0 * w2_3)) * length_3;
                    let b2_l_3 = length_3 * length_3;
                    let b2_c_3 = 12.0 * w2_3 * b2_l_3;
                    let b1_3 = b0_c_3 + (0.16666666666666666 * b1_c_3);
                    let s18 = b0_c_3 + (0.3333333333333333 * b1_c_3);
                    let b2_3 = s18 + (0.06666666666666667 * b2_c_3);
                    let b3_3 = b0_c_3 + (0.5 * b1_c_3) + (0.2 * b2_c_3);
                    let b4_3 = b0_c_3 + (0.6666666666666666 * b1_c_3) + (0.4 * b2_c_3);
                    let s19 = b0_c_3 + (0.8333333333333334 * b1_c_3);
                    let b5_3 = s19 + (0.6666666666666666 * b2_c_3);
                    let b6_3 = b0_c_3 + b1_c_3 + b2_c_3;
                    let s0_c_3 = ((-0.1155) * w1_3) - (3.08 * w2_3);
                    let s1_c_3 = (((-0.01075) * w1_3) - (0.44066666666666665 * w2_3)) * length_3;
                    let s2_l_3 = length_3 * length_3;
                    let s2_c_3 = (((-0.00025) * w1_3) - (0.021 * w2_3)) * s2_l_3;
                    let s3_l_3 = s2_l_3 * length_3;
                    let s3_c_3 = (-0.0003333333333333333) * w2_3 * s3_l_3;
                    let s1_3 = s0_c_3 + (0.14285714285714285 * s1_c_3);
                    let s20 = s0_c_3 + (0.2857142857142857 * s1_c_3);
                    let s2_3 = s20 + (0.047619047619047616 * s2_c_3);
                    let s21 = s0_c_3 + (0.42857142857142855 * s1_c_3);
                    let s22 = s21 + (0.14285714285714285 * s2_c_3);
                    let s3_3 = s22 + (0.02857142857142857 * s3_c_3);
                    let s23 = s0_c_3 + (0.5714285714285714 * s1_c_3);
                    let s24 = s23 + (0.2857142857142857 * s2_c_3);
                    let s4_3 = s24 + (0.11428571428571428 * s3_c_3);
                    let s25 = s0_c_3 + (0.7142857142857143 * s1_c_3);
                    let s26 = s25 + (0.47619047619047616 * s2_c_3);
                    let s5_3 = s26 + (0.2857142857142857 * s3_c_3);
                    let s27 = s0_c_3 + (0.8571428571428571 * s1_c_3);
                    let s28 = s27 + (0.7142857142857143 * s2_c_3);
                    let s6_3 = s28 + (0.5714285714285714 * s3_c_3);
                    let s7_3 = s0_c_3 + s1_c_3 + s2_c_3 + s3_c_3;
                    if (least_3 <= b0_c_3)
                        && (b0_c_3 <= most_3)
                        && (least_3 <= b1_3)
                        && (b1_3 <= most_3)
                        && (least_3 <= b2_3)
                        && (b2_3 <= most_3)
                        && (least_3 <= b3_3)
                        && (b3_3 <= most_3)
                        && (least_3 <= b4_3)
                        && (b4_3 <= most_3)
                        && (least_3 <= b5_3)
                        && (b5_3 <= most_3)
                        && (least_3 <= b6_3)
                        && (b6_3 <= most_3)
                        && (-most2_3 <= s0_c_3)
                        && (s0_c_3 <= most2_3)
                        && (-most2_3 <= s1_3)
                        && (s1_3 <= most2_3)
                        && (-most2_3 <= s2_3)
                        && (s2_3 <= most2_3)
                        && (-most2_3 <= s3_3)
                        && (s3_3 <= most2_3)
                        && (-most2_3 <= s4_3)
                        && (s4_3 <= most2_3)
                        && (-most2_3 <= s5_3)
                        && (s5_3 <= most2_3)
                        && (-most2_3 <= s6_3)
                        && (s6_3 <= most2_3)
                        && (-most2_3 <= s7_3)
                        && (s7_3 <= most2_3)
                        && (((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && ((((-0.105) * w1_3) - (2.6599999999999997 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                    {
                        fits = 3;
                    }
                } else if ((((-0.025974025974025976) * flat1_3) - (0.2857142857142857 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && ((((-0.0012475444042476065) * flat1_3) - (0.08276232337733669 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && (((0.0035664936491730252 * flat1_3) - (0.02768331367963576 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && ((((-0.012577404043081223) * flat1_3) - (0.18287834614365228 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && (((0.000902126332826074 * flat1_3) - (0.060363489673773814 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && ((((-0.007827317130259085) * flat1_3) - (0.14320479414568998 * flat2_3)).abs() <= 0.9850746268656713 * within_3)
                    && ((8.333333333333333e-5 * flat2_3).abs() <= 0.9850746268656717 * most2_3)
                    && ((((-5.753277910884419e-6) * flat1_3) + (4.002538296961078e-6 * flat2_3)).abs() <= 0.9850746268656717 * most2_3)
                    && ((((-5.576228651711586e-6) * flat1_3) - (1.1442500457763452e-5 * flat2_3)).abs() <= 0.9850746268656717 * most2_3)
                    && ((((-3.7105751391465683e-6) * flat1_3) + (4.035250463821893e-5 * flat2_3)).abs() <= 0.9850746268656717 * most2_3)
                    && ((((-5.857239944571719e-6) * flat1_3) - (2.8943219844836487e-6 * flat2_3)).abs() <= 0.9850746268656717 * most2_3)
                    && ((((-4.75869214273667e-6) * flat1_3) + (2.511264245958124e-5 * flat2_3)).abs() <= 0.9850746268656717 * most2_3)
                {
                    fits = 3;
                }
            }
            if fits == 3 {
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
            let more = (low.saturating_sub(ahead) / 2) + 1;
            if (kept == 0) && (more < half) {
                tried = low + more;
            } else {
                tried = low + half;
            }
            part = 0.899999999999773;
        }
        if (kept > 0) && (elapsed < 2147483648) {
            last_now = elapsed + kept;
        }
        if (kept == 0) && (ahead > 0) {
            late = 2;
        }
        if last_now > self.last {
            late = 1;
        }
        let left = last_now.saturating_sub(elapsed);
        let m0_1 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let law_1: f64;
        let m0_2 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let law_2: f64;
        let m0_3 = if (left as f64) < Self::HOLD {
            Self::HOLD
        } else {
            left as f64
        };
        let law_3: f64;
        if m0_1 > Self::END_SAMPLES_1 {
            // The exact law in samples.
            let z1_1 = (Self::W1_1_1 * x1_1) + (Self::W1_2_1 * x2_1);
            let z2_1 = Self::W2_2_1 * x2_1;
            let m0f_11 = m0_1 + 1.0;
            law_1 = (z1_1 + (z2_1 * m0f_11)) / (m0f_11 * m0_1);
        } else {
            // The law of least energy to the end.
            let m1_1 = if m0_1 < 2.0 { 2.0 } else { m0_1 };
            let y1_1 = (Self::END1_1_1 * x1_1) + (Self::END1_2_1 * x2_1);
            let y2_1 = Self::END2_2_1 * x2_1;
            let m1f_11 = m1_1 + 2.0;
            law_1 = (y1_1 + (y2_1 * m1f_11)) / (m1f_11 * (m1_1 + 1.0));
        }
        if m0_2 > Self::END_SAMPLES_2 {
            // The exact law in samples.
            let z1_2 = (Self::W1_1_2 * x1_2) + (Self::W1_2_2 * x2_2);
            let z2_2 = Self::W2_2_2 * x2_2;
            let m0f_21 = m0_2 + 1.0;
            law_2 = (z1_2 + (z2_2 * m0f_21)) / (m0f_21 * m0_2);
        } else {
            // The law of least energy to the end.
            let m1_2 = if m0_2 < 2.0 { 2.0 } else { m0_2 };
            let y1_2 = (Self::END1_1_2 * x1_2) + (Self::END1_2_2 * x2_2);
            let y2_2 = Self::END2_2_2 * x2_2;
            let m1f_21 = m1_2 + 2.0;
            law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0));
        }
        if m0_3 > Self::END_SAMPLES_3 {
            // The exact law in samples.
            let z1_3 = (Self::W1_1_3 * x1_3) + (Self::W1_2_3 * x2_3);
            let z2_3 = Self::W2_2_3 * x2_3;
            let m0f_31 = m0_3 + 1.0;
            law_3 = (z1_3 + (z2_3 * m0f_31)) / (m0f_31 * m0_3);
        } else {
            // The law of least energy to the end.
            let m1_3 = if m0_3 < 2.0 { 2.0 } else { m0_3 };
            let y1_3 = (Self::END1_1_3 * x1_3) + (Self::END1_2_3 * x2_3);
            let y2_3 = Self::END2_2_3 * x2_3;
            let m1f_31 = m1_3 + 2.0;
            law_3 = (y1_3 + (y2_3 * m1f_31)) / (m1f_31 * (m1_3 + 1.0));
        }
        if (left as f64) > Self::HOLD {
            if late == 2 {
                status = Ok(Status::Infeasible);
            } else if late == 1 {
                status = Ok(Status::Late);
            } else {
                status = Ok(Status::Ok);
            }
        } else {
            status = Ok(Status::Hold);
        }
        if law_1.is_finite() && law_2.is_finite() && law_3.is_finite() {
            u[0] = law_1;
            axes[0] = status;
            u[1] = law_2;
            axes[1] = status;
            u[2] = law_3;
            axes[2] = status;
            if law_1 > 900.0 {
                u[0] = 900.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_1 < -900.0 {
                u[0] = -900.0;
                axes[0] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_2 > 400.0 {
                u[1] = 400.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_2 < -400.0 {
                u[1] = -400.0;
                axes[1] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            if law_3 > 60.0 {
                u[2] = 60.0;
                axes[2] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            } else if law_3 < -150.0 {
                u[2] = -150.0;
                axes[2] = Ok(Status::Saturated);
                status = Ok(Status::Saturated);
            }
            self.last = last_now;
        } else {
            u[0] = 0.0;
            if law_1.is_finite() {
                axes[0] = status;
            } else {
                axes[0] = Err(Error::Range);
            }
            u[1] = 0.0;
            if law_2.is_finite() {
                axes[1] = status;
            } else {
                axes[1] = Err(Error::Range);
            }
            u[2] = 0.0;
            if law_3.is_finite() {
                axes[2] = status;
            } else {
                axes[2] = Err(Error::Range);
            }
            status = Err(Error::Range);
        }
        Axes { u, axes, status }
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 2 to 2147483648 samples.
    ///
    /// # Errors
    /// `Param`: the number of samples is out of its range.
    #[inline]
    pub fn arm_for(&mut self, k: u32, samples: u32) -> Result<(), Error> {
        if !((samples > 1) && (samples < 2147483649)) {
            return Err(Error::Param);
        }
        self.start = k;
        self.last = samples;
        Ok(())
    }

    /// The fewest samples found, from the next call of `step` on, with which the law of each axis
    /// keeps u and the states within their limits at every sample to rest, from the state x of
    /// each, all of which come to rest at one sample, for sure. Give them to `arm_for`.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: a state is too large to
    /// compute with. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn soonest(&self, x: &[[f64; 2]; 3]) -> Result<u32, Error> {
        if !(x[0][0].is_finite()
            && x[0][1].is_finite()
            && x[1][0].is_finite()
            && x[1][1].is_finite()
            && x[2][0].is_finite()
            && x[2][1].is_finite())
        {
            return Err(Error::Input);
        }
        let x1_1 = x[0][0];
        let x2_1 = x[0][1];
        let x1_2 = x[1][0];
        let x2_2 = x[1][1];
        let x1_3 = x[2][0];
        let x2_3 = x[2][1];
        let flat1_1 = (Self::S1_1_1 * x1_1) + (Self::S1_2_1 * x2_1);
        let flat2_1 = Self::S2_2_1 * x2_1;
        let flat1_2 = (Self::S1_1_2 * x1_2) + (Self::S1_2_2 * x2_2);
        let flat2_2 = Self::S2_2_2 * x2_2;
        let flat1_3 = (Self::S1_1_3 * x1_3) + (Self::S1_2_3 * x2_3);
        let flat2_3 = Self::S2_2_3 * x2_3;
        let mut low = 20_u32;
        let mut top = 1073741825_u32;
        let mut kept = 0_u32;
        let mut tried = 21_u32;
        for _ in 0..64 {
            let least_1: f64 = 0.899999999999773 * Self::U_MIN_1;
            let most_1: f64 = 0.899999999999773 * Self::U_MAX_1;
            let within_1 = if -least_1 < most_1 { -least_1 } else { most_1 };
            let most2_1: f64 = 1.3499999999996595;
            let least_2: f64 = 0.899999999999773 * Self::U_MIN_2;
            let most_2: f64 = 0.899999999999773 * Self::U_MAX_2;
            let within_2 = if -least_2 < most_2 { -least_2 } else { most_2 };
            let least_3: f64 = 0.899999999999773 * Self::U_MIN_3;
            let most_3: f64 = 0.899999999999773 * Self::U_MAX_3;
            let within_3 = if -least_3 < most_3 { -least_3 } else { most_3 };
            let most2_3: f64 = 0.35999999999990917;
            let mut fits = 0_u32;
            if tried > 50 {
                let m_1 = tried as f64;
                let power1_1 = m_1 + 1.0;
                let power2_1 = power1_1 * m_1;
                let power3_1 = power2_1 * (m_1 - 1.0);
                let scaled2_1 = flat2_1 * power1_1;
                let w1_1 = ((3.0 * flat1_1) + scaled2_1) / power2_1;
                let w2_1 = (((-2.0) * flat1_1) - scaled2_1) / power3_1;
                let length_1 = m_1 - 51.0;
                let b0_c_1 = (2.0 * w1_1) + (300.0 * w2_1);
                let b1_c_1 = 6.0 * w2_1 * length_1;
                let b1_1 = b0_c_1 + b1_c_1;
                let s0_c_1 = ((-0.00085) * w1_1) - (0.06375 * w2_1);
                let s1_c_1 = (((-1.6666666666666667e-5) * w1_1) - (0.002525 * w2_1)) * length_1;
                let s2_l_1 = length_1 * length_1;
                let s2_c_1 = (-2.5e-5) * w2_1 * s2_l_1;
                let s1_1 = s0_c_1 + (0.16666666666666666 * s1_c_1);
                let s1 = s0_c_1 + (0.3333333333333333 * s1_c_1);
                let s2_1 = s1 + (0.06666666666666667 * s2_c_1);
                let s3_1 = s0_c_1 + (0.5 * s1_c_1) + (0.2 * s2_c_1);
                let s4_1 = s0_c_1 + (0.6666666666666666 * s1_c_1) + (0.4 * s2_c_1);
                let s2 = s0_c_1 + (0.8333333333333334 * s1_c_1);
                let s5_1 = s2 + (0.6666666666666666 * s2_c_1);
                let s6_1 = s0_c_1 + s1_c_1 + s2_c_1;
                let end21_1 = (2.8506787330316743 * w1_1) + (117.44796380090497 * w2_1);
                let end22_1 = (3.0475113122171944 * w1_1) + (145.85746606334843 * w2_1);
                let end23_1 = (2.9906485671191554 * w1_1) + (175.02805429864253 * w2_1);
                let end24_1 = (2.6800904977375564 * w1_1) + (204.95972850678734 * w2_1);
                let end25_1 = (2.1158371040723982 * w1_1) + (235.6524886877828 * w2_1);
                let end26_1 = (1.2978883861236803 * w1_1) + (267.10633484162895 * w2_1);
                let end27_1 = (0.22624434389140272 * w1_1) + (299.3212669683258 * w2_1);
                if (least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (least_1 <= end21_1)
                    && (end21_1 <= most_1)
                    && (least_1 <= end22_1)
                    && (end22_1 <= most_1)
                    && (least_1 <= end23_1)
                    && (end23_1 <= most_1)
                    && (least_1 <= end24_1)
                    && (end24_1 <= most_1)
                    && (least_1 <= end25_1)
                    && (end25_1 <= most_1)
                    && (least_1 <= end26_1)
                    && (end26_1 <= most_1)
                    && (least_1 <= end27_1)
                    && (end27_1 <= most_1)
                    && ((((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)).abs() <= most2_1)
                    && ((((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)).abs() <= most2_1)
                    && ((((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)).abs() <= most2_1)
                    && ((((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)).abs() <= most2_1)
                    && ((((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)).abs() <= most2_1)
                    && ((((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)).abs() <= most2_1)
                    && ((((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)).abs() <= most2_1)
                    && ((((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)).abs() <= most2_1)
                    && (((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && ((((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                {
                    fits = 1;
                }
            } else {
                let m_1 = tried as f64;
                let power1_1 = m_1 + 2.0;
                let power2_1 = power1_1 * (m_1 + 1.0);
                let power3_1 = power2_1 * m_1;
                let power4_1 = power3_1 * (m_1 - 1.0);
                let scaled2_1 = flat2_1 * power1_1;
                let w1_1 = ((4.0 * flat1_1) + scaled2_1) / power3_1;
                let w2_1 = (((-3.0) * flat1_1) - scaled2_1) / power4_1;
                let length_1 = m_1 - 21.0;
                let b0_c_1 = (126.0 * w1_1) + (5040.0 * w2_1);
                let b1_c_1 = ((6.0 * w1_1) + (492.0 * w2_1)) * length_1;
                let b2_l_1 = length_1 * length_1;
                let b2_c_1 = 12.0 * w2_1 * b2_l_1;
                let b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                let s3 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                let b2_1 = s3 + (0.06666666666666667 * b2_c_1);
                let b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                let b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                let s4 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                let b5_1 = s4 + (0.6666666666666666 * b2_c_1);
                let b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                let s0_c_1 = ((-0.01155) * w1_1) - (0.308 * w2_1);
                let s1_c_1 = (((-0.001075) * w1_1) - (0.044066666666666664 * w2_1)) * length_1;
                let s2_l_1 = length_1 * length_1;
                let s2_c_1 = (((-2.5e-5) * w1_1) - (0.0021 * w2_1)) * s2_l_1;
                let s3_l_1 = s2_l_1 * length_1;
                let s3_c_1 = (-3.3333333333333335e-5) * w2_1 * s3_l_1;
                let s1_1 = s0_c_1 + (0.14285714285714285 * s1_c_1);
                let s5 = s0_c_1 + (0.2857142857142857 * s1_c_1);
                let s2_1 = s5 + (0.047619047619047616 * s2_c_1);
                let s6 = s0_c_1 + (0.42857142857142855 * s1_c_1);
                let s7 = s6 + (0.14285714285714285 * s2_c_1);
                let s3_1 = s7 + (0.02857142857142857 * s3_c_1);
                let s8 = s0_c_1 + (0.5714285714285714 * s1_c_1);
                let s9 = s8 + (0.2857142857142857 * s2_c_1);
                let s4_1 = s9 + (0.11428571428571428 * s3_c_1);
                let s10 = s0_c_1 + (0.7142857142857143 * s1_c_1);
                let s11 = s10 + (0.47619047619047616 * s2_c_1);
                let s5_1 = s11 + (0.2857142857142857 * s3_c_1);
                let s12 = s0_c_1 + (0.8571428571428571 * s1_c_1);
                let s13 = s12 + (0.7142857142857143 * s2_c_1);
                let s6_1 = s13 + (0.5714285714285714 * s3_c_1);
                let s7_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1;
                if (least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (least_1 <= b2_1)
                    && (b2_1 <= most_1)
                    && (least_1 <= b3_1)
                    && (b3_1 <= most_1)
                    && (least_1 <= b4_1)
                    && (b4_1 <= most_1)
                    && (least_1 <= b5_1)
                    && (b5_1 <= most_1)
                    && (least_1 <= b6_1)
                    && (b6_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (-most2_1 <= s7_1)
                    && (s7_1 <= most2_1)
                    && (((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && (((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)).abs() <= 0.9850746268656713 * within_1)
                    && ((((-0.0105) * w1_1) - (0.266 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                    && ((((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)).abs() <= 0.9850746268656717 * most2_1)
                {
                    fits = 1;
                }
            }
            if fits == 1 {
                if tried > 50 {
                    let m_2 = tried as f64;
                    let power1_2 = m_2 + 1.0;
                    let power2_2 = power1_2 * m_2;
                    let power3_2 = power2_2 * (m_2 - 1.0);
                    let scaled2_2 = flat2_2 * power1_2;
                    let w1_2 = ((3.0 * flat1_2) + scaled2_2) / power2_2;
                    let w2_2 = (((-2.0) * flat1_2) - scaled2_2) / power3_2;
                    let length_2 = m_2 - 51.0;
                    let b0_c_2 = (2.0 * w1_2) + (300.0 * w2_2);
                    let b1_c_2 = 6.0 * w2_2 * length_2;
                    let b1_2 = b0_c_2 + b1_c_2;
                    let end11_2 = (2.8506787330316743 * w1_2) + (117.44796380090497 * w2_2);
                    let end12_2 = (3.0475113122171944 * w1_2) + (145.85746606334843 * w2_2);
                    let end13_2 = (2.9906485671191554 * w1_2) + (175.02805429864253 * w2_2);
                    let end14_2 = (2.6800904977375564 * w1_2) + (204.95972850678734 * w2_2);
                    let end15_2 = (2.1158371040723982 * w1_2) + (235.6524886877828 * w2_2);
                    let end16_2 = (1.2978883861236803 * w1_2) + (267.10633484162895 * w2_2);
                    let end17_2 = (0.22624434389140272 * w1_2) + (299.3212669683258 * w2_2);
                    if (least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= end11_2)
                        && (end11_2 <= most_2)
                        && (least_2 <= end12_2)
                        && (end12_2 <= most_2)
                        && (least_2 <= end13_2)
                        && (end13_2 <= most_2)
                        && (least_2 <= end14_2)
                        && (end14_2 <= most_2)
                        && (least_2 <= end15_2)
                        && (end15_2 <= most_2)
                        && (least_2 <= end16_2)
                        && (end16_2 <= most_2)
                        && (least_2 <= end17_2)
                        && (end17_2 <= most_2)
                        && (((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                    {
                        fits = 2;
                    }
                } else {
                    let m_2 = tried as f64;
                    let power1_2 = m_2 + 2.0;
                    let power2_2 = power1_2 * (m_2 + 1.0);
                    let power3_2 = power2_2 * m_2;
                    let power4_2 = power3_2 * (m_2 - 1.0);
                    let scaled2_2 = flat2_2 * power1_2;
                    let w1_2 = ((4.0 * flat1_2) + scaled2_2) / power3_2;
                    let w2_2 = (((-3.0) * flat1_2) - scaled2_2) / power4_2;
                    let length_2 = m_2 - 21.0;
                    let b0_c_2 = (126.0 * w1_2) + (5040.0 * w2_2);
                    let b1_c_2 = ((6.0 * w1_2) + (492.0 * w2_2)) * length_2;
                    let b2_l_2 = length_2 * length_2;
                    let b2_c_2 = 12.0 * w2_2 * b2_l_2;
                    let b1_2 = b0_c_2 + (0.16666666666666666 * b1_c_2);
                    let s14 = b0_c_2 + (0.3333333333333333 * b1_c_2);
                    let b2_2 = s14 + (0.06666666666666667 * b2_c_2);
                    let b3_2 = b0_c_2 + (0.5 * b1_c_2) + (0.2 * b2_c_2);
                    let b4_2 = b0_c_2 + (0.6666666666666666 * b1_c_2) + (0.4 * b2_c_2);
                    let s15 = b0_c_2 + (0.8333333333333334 * b1_c_2);
                    let b5_2 = s15 + (0.6666666666666666 * b2_c_2);
                    let b6_2 = b0_c_2 + b1_c_2 + b2_c_2;
                    if (least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= b2_2)
                        && (b2_2 <= most_2)
                        && (least_2 <= b3_2)
                        && (b3_2 <= most_2)
                        && (least_2 <= b4_2)
                        && (b4_2 <= most_2)
                        && (least_2 <= b5_2)
                        && (b5_2 <= most_2)
                        && (least_2 <= b6_2)
                        && (b6_2 <= most_2)
                        && (((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                        && (((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)).abs() <= 0.9850746268656713 * within_2)
                    {
                        fits = 2;
                    }
                }
            }
            if fits == 2 {
                if tried > 50 {
                    let m_3 = tried as f64;
                    let power1_3 = m_3 + 1.0;
                    let power2_3 = power1_3 * m_3;
                    let power3_3 = power2_3 * (m_3 - 1.0);
                    let scaled2_3 = flat2_3 * power1_3;
                    let w1_3 = ((3.0 * flat1_3) + scaled2_3) / power2_3;
                    let w2_3 = (((-2.0) * flat1_3) - scaled2_3) / power3_3;
                    let length_3 = m_3 - 51.0;
                    let b0_c_3 = (2.0 * w1_3) + (300.0 * w2_3);
                    let b1_c_3 = 6.0 * w2_3 * length_3;
                    let b1_3 = b0_c_3 + b1_c_3;
                    let s0_c_3 = ((-0.0085) * w1_3) - (0.6375 * w2_3);
                    let s1_c_3 = (((-0.00016666666666666666) * w1_3) - (0.02525 * w2_3)) * length_3;
                    let s2_l_3 = length_3 * length_3;
                    let s2_c_3 = (-0.00025) * w2_3 * s2_l_3;
                    let s1_3 = s0_c_3 + (0.16666666666666666 * s1_c_3);
                    let s16 = s0_c_3 + (0.3333333333333333 * s1_c_3);
                    let s2_3 = s16 + (0.06666666666666667 * s2_c_3);
                    let s3_3 = s0_c_3 + (0.5 * s1_c_3) + (0.2 * s2_c_3);
                    let s4_3 = s0_c_3 + (0.6666666666666666 * s1_c_3) + (0.4 * s2_c_3);
                    let s17 = s0_c_3 + (0.8333333333333334 * s1_c_3);
                    let s5_3 = s17 + (0.6666666666666666 * s2_c_3);
                    let s6_3 = s0_c_3 + s1_c_3 + s2_c_3;
                    let end21_3 = (2.8506787330316743 * w1_3) + (117.44796380090497 * w2_3);
                    let end22_3 = (3.0475113122171944 * w1_3) + (145.85746606334843 * w2_3);
                    let end23_3 = (2.9906485671191554 * w1_3) + (175.02805429864253 * w2_3);
                    let end24_3 = (2.6800904977375564 * w1_3) + (204.95972850678734 * w2_3);
                    let end25_3 = (2.1158371040723982 * w1_3) + (235.6524886877828 * w2_3);
                    let end26_3 = (1.2978883861236803 * w1_3) + (267.10633484162895 * w2_3);
                    let end27_3 = (0.22624434389140272 * w1_3) + (299.3212669683258 * w2_3);
                    if (least_3 <= b0_c_3)
                        && (b0_c_3 <= most_3)
                        && (least_3 <= b1_3)
                        && (b1_3 <= most_3)
                        && (-most2_3 <= s0_c_3)
                        && (s0_c_3 <= most2_3)
                        && (-most2_3 <= s1_3)
                        && (s1_3 <= most2_3)
                        && (-most2_3 <= s2_3)
                        && (s2_3 <= most2_3)
                        && (-most2_3 <= s3_3)
                        && (s3_3 <= most2_3)
                        && (-most2_3 <= s4_3)
                        && (s4_3 <= most2_3)
                        && (-most2_3 <= s5_3)
                        && (s5_3 <= most2_3)
                        && (-most2_3 <= s6_3)
                        && (s6_3 <= most2_3)
                        && (least_3 <= end21_3)
                        && (end21_3 <= most_3)
                        && (least_3 <= end22_3)
                        && (end22_3 <= most_3)
                        && (least_3 <= end23_3)
                        && (end23_3 <= most_3)
                        && (least_3 <= end24_3)
                        && (end24_3 <= most_3)
                        && (least_3 <= end25_3)
                        && (end25_3 <= most_3)
                        && (least_3 <= end26_3)
                        && (end26_3 <= most_3)
                        && (least_3 <= end27_3)
                        && (end27_3 <= most_3)
                        && ((((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)).abs() <= most2_3)
                        && ((((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)).abs() <= most2_3)
                        && ((((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)).abs() <= most2_3)
                        && ((((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)).abs() <= most2_3)
                        && ((((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)).abs() <= most2_3)
                        && ((((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)).abs() <= most2_3)
                        && ((((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)).abs() <= most2_3)
                        && ((((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)).abs() <= most2_3)
                        && (((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && ((((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                    {
                        fits = 3;
                    }
                } else {
                    let m_3 = tried as f64;
                    let power1_3 = m_3 + 2.0;
                    let power2_3 = power1_3 * (m_3 + 1.0);
                    let power3_3 = power2_3 * m_3;
                    let power4_3 = power3_3 * (m_3 - 1.0);
                    let scaled2_3 = flat2_3 * power1_3;
                    let w1_3 = ((4.0 * flat1_3) + scaled2_3) / power3_3;
                    let w2_3 = (((-3.0) * flat1_3) - scaled2_3) / power4_3;
                    let length_3 = m_3 - 21.0;
                    let b0_c_3 = (126.0 * w1_3) + (5040.0 * w2_3);
                    let b1_c_3 = ((6.0 * w1_3) + (492.0 * w2_3)) * length_3;
                    let b2_l_3 = length_3 * length_3;
                    let b2_c_3 = 12.0 * w2_3 * b2_l_3;
                    let b1_3 = b0_c_3 + (0.16666666666666666 * b1_c_3);
                    let s18 = b0_c_3 + (0.3333333333333333 * b1_c_3);
                    let b2_3 = s18 + (0.06666666666666667 * b2_c_3);
                    let b3_3 = b0_c_3 + (0.5 * b1_c_3) + (0.2 * b2_c_3);
                    let b4_3 = b0_c_3 + (0.6666666666666666 * b1_c_3) + (0.4 * b2_c_3);
                    let s19 = b0_c_3 + (0.8333333333333334 * b1_c_3);
                    let b5_3 = s19 + (0.6666666666666666 * b2_c_3);
                    let b6_3 = b0_c_3 + b1_c_3 + b2_c_3;
                    let s0_c_3 = ((-0.1155) * w1_3) - (3.08 * w2_3);
                    let s1_c_3 = (((-0.01075) * w1_3) - (0.44066666666666665 * w2_3)) * length_3;
                    let s2_l_3 = length_3 * length_3;
                    let s2_c_3 = (((-0.00025) * w1_3) - (0.021 * w2_3)) * s2_l_3;
                    let s3_l_3 = s2_l_3 * length_3;
                    let s3_c_3 = (-0.0003333333333333333) * w2_3 * s3_l_3;
                    let s1_3 = s0_c_3 + (0.14285714285714285 * s1_c_3);
                    let s20 = s0_c_3 + (0.2857142857142857 * s1_c_3);
                    let s2_3 = s20 + (0.047619047619047616 * s2_c_3);
                    let s21 = s0_c_3 + (0.42857142857142855 * s1_c_3);
                    let s22 = s21 + (0.14285714285714285 * s2_c_3);
                    let s3_3 = s22 + (0.02857142857142857 * s3_c_3);
                    let s23 = s0_c_3 + (0.5714285714285714 * s1_c_3);
                    let s24 = s23 + (0.2857142857142857 * s2_c_3);
                    let s4_3 = s24 + (0.11428571428571428 * s3_c_3);
                    let s25 = s0_c_3 + (0.7142857142857143 * s1_c_3);
                    let s26 = s25 + (0.47619047619047616 * s2_c_3);
                    let s5_3 = s26 + (0.2857142857142857 * s3_c_3);
                    let s27 = s0_c_3 + (0.8571428571428571 * s1_c_3);
                    let s28 = s27 + (0.7142857142857143 * s2_c_3);
                    let s6_3 = s28 + (0.5714285714285714 * s3_c_3);
                    let s7_3 = s0_c_3 + s1_c_3 + s2_c_3 + s3_c_3;
                    if (least_3 <= b0_c_3)
                        && (b0_c_3 <= most_3)
                        && (least_3 <= b1_3)
                        && (b1_3 <= most_3)
                        && (least_3 <= b2_3)
                        && (b2_3 <= most_3)
                        && (least_3 <= b3_3)
                        && (b3_3 <= most_3)
                        && (least_3 <= b4_3)
                        && (b4_3 <= most_3)
                        && (least_3 <= b5_3)
                        && (b5_3 <= most_3)
                        && (least_3 <= b6_3)
                        && (b6_3 <= most_3)
                        && (-most2_3 <= s0_c_3)
                        && (s0_c_3 <= most2_3)
                        && (-most2_3 <= s1_3)
                        && (s1_3 <= most2_3)
                        && (-most2_3 <= s2_3)
                        && (s2_3 <= most2_3)
                        && (-most2_3 <= s3_3)
                        && (s3_3 <= most2_3)
                        && (-most2_3 <= s4_3)
                        && (s4_3 <= most2_3)
                        && (-most2_3 <= s5_3)
                        && (s5_3 <= most2_3)
                        && (-most2_3 <= s6_3)
                        && (s6_3 <= most2_3)
                        && (-most2_3 <= s7_3)
                        && (s7_3 <= most2_3)
                        && (((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && (((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)).abs() <= 0.9850746268656713 * within_3)
                        && ((((-0.105) * w1_3) - (2.6599999999999997 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                        && ((((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)).abs() <= 0.9850746268656717 * most2_3)
                    {
                        fits = 3;
                    }
                }
            }
            if fits == 3 {
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
        if flat1_1.is_finite()
            && flat2_1.is_finite()
            && flat1_2.is_finite()
            && flat2_2.is_finite()
            && flat1_3.is_finite()
            && flat2_3.is_finite()
        {
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
