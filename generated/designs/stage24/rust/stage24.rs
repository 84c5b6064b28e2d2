//! Prescribed-time controller stage24: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name stage24 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --precision f32 --tau=0.3 --eps=0 --poles=-4,-5 --reference="size*dt^2/(1 + t^2)" --sample-time=0.01
//! Version 0.1.0, design 50bc8ccf34e5.
//!
//! Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
//!       row_j z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for
//!       the mapping exp. The gains of 2 samples to go stay: they are deadbeat.
//! With the reference r = size*dt^2/(1 + t^2), x - x_r is in place of x above, and u = w +
//!       u_r: with them the output y = -2*x1 + x2 is r, and stays so. At sample N x = x_r
//!       where u_r is constant over each sample; else an error of order h^(4-i) is left in
//!       y^(i-1).
//! t counts from the tick at which it was armed, and u_r is that in the middle of the time in
//!       which u acts. To four digits:
//!   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
//!   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
//!   x_r1 = -1.333*r - 0.3333*r^(1)
//!   x_r2 = -1.667*r - 0.6667*r^(1)
//!   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
//!
//! Parameters:
//!   samples = 30 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
//!   size [as in its expression]: parameter of an expression of the design
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample 30 from any state, but for what r does between samples,
//!       whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   loop: not checked: `size` is left to run time.
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

/// Run-time parameters of [`Stage24`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage24Params {
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f32,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub size: f32,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage24 {
    /// tick at which it was armed.
    start: u32,
    /// parameter of an expression of the design.
    p_size: f32,
    /// derived from the parameters.
    c_r4: f32,
    /// bound of |u|.
    u_max: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Stage24 {
    /// 1/100, sample period.
    const H: f32 = 0.01;
    /// Weight of x1 in the law.
    const W1_1: f32 = -137042.42;
    /// Weight of x2 in the law.
    const W1_2: f32 = 69031.28;
    /// Weight of x1 in the law.
    const W2_1: f32 = 1353.4108;
    /// Weight of x2 in the law.
    const W2_2: f32 = -1082.7286;
    /// Weight of x1 in the law.
    const C_1: f32 = -5.658292;
    /// Weight of x2 in the law.
    const C_2: f32 = 4.3266335;
    /// Weight of x1 in the law.
    const B_1: f32 = -6519.427;
    /// Weight of x2 in the law.
    const B_2: f32 = 3185.2085;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 30;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage24Params) -> Result<Self, Error> {
        if !((params.u_max > 0.0) && params.size.is_finite()) {
            return Err(Error::Param);
        }
        let p_size = params.size;
        let c_r4 = 2.0 * p_size;
        let u_max = params.u_max;
        if !c_r4.is_finite() {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            p_size,
            c_r4,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&self, k: u32, x: &[f32; 2]) -> Result<Control<f32>, Error> {
        if !(x[0].is_finite() && x[1].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];

        // The tracking error.
        let t = (elapsed as f32) * Self::H;
        let v_r1 = t * t;
        let v_r2 = 1.0 + v_r1;
        let v_r3 = (self.p_size * v_r1) / v_r2;
        let v_r5 = (self.c_r4 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
        let x_r1 = ((-1.3333334) * v_r3) + ((-0.33333334) * v_r5);
        let x_r2 = ((-1.6666666) * v_r3) + ((-0.6666667) * v_r5);
        let v_r6 = t + 0.005;
        let v_r7 = v_r6 * v_r6;
        let v_r8 = 1.0 + v_r7;
        let v_r9 = v_r8 * v_r8;
        let s1 = (self.c_r4 * v_r6 * (v_r8 - v_r7)) / v_r9;
        let s2 = (v_r9 + (4.0 * v_r7 * v_r7)) - (4.0 * v_r8 * v_r6 * v_r6);
        let s3 = (-0.33333334) * ((self.c_r4 * (s2 - (v_r8 * v_r7))) / (v_r8 * v_r9));
        let u_r0 = ((0.33333334 * ((self.p_size * v_r7) / v_r8)) - s1) + s3;
        let e1 = x1 - x_r1;
        let e2 = x2 - x_r2;
        let v: f32;
        if elapsed < 28 {
            // The exact law in samples.
            let m0 = 33_u32.wrapping_sub(elapsed) as f32;
            let z1 = (Self::W1_1 * e1) + (Self::W1_2 * e2);
            let z2 = (Self::W2_1 * e1) + (Self::W2_2 * e2);
            let s4 = (Self::C_1 * e1) + (Self::C_2 * e2);
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) + s4 + u_r0;
        } else {
            // Deadbeat.
            v = (Self::B_1 * e1) + (Self::B_2 * e2) + u_r0;
        }
        let (u, status) = if v.is_finite() {
            if v > self.u_max {
                (self.u_max, Status::Saturated)
            } else if v < -self.u_max {
                (-self.u_max, Status::Saturated)
            } else if elapsed < Self::SAMPLES {
                (v, Status::Ok)
            } else {
                (v, Status::Hold)
            }
        } else {
            return Err(Error::Range);
        };
        Ok(Control { u, status })
    }
}
