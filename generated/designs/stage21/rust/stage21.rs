//! Prescribed-time controller stage21: order n = 3, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 3 --mu "exp(a=1)" --name stage21 --clock samples --eps=0 --g="2" --reference="size*dt^2/(1 + t^2)" --delay=0.25
//! Version 0.1.0, design 0b4602f00880.
//!
//! Plant: x1' = x2, ..., x3' = g u; u held from sample to sample, 0.25 samples late.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
//!       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
//!       over.
//! With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
//!       where the inputs under way count less the rho of their own samples. At sample N e is
//!       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
//!       e_i.
//! t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
//!       which u acts:
//!   e_i = x_i - r^(i-1), with the reference r = size*dt^2/(1 + t^2)
//!   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
//!   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
//!   r^(3) = 12*size*(4*(1 + t^2)*dt*t^2 + 2*(1 + t^2)*dt^2*t - (1 + t^2)^2*dt - (1 + t^2)^2*t
//!       - 4*dt^2*t^3)/(1 + t^2)^4
//!
//! Parameters:
//!   samples [samples]: samples N from the start to rest
//!   h [s]: sample period
//!   eps = 0 [s], fixed: time-to-go at which the gains are held
//!   u_max [unit of u]: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
//!   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
//!   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
//!   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
//!   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
//!   size [as in its expression]: parameter of an expression of the design
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: at rest at sample N from any state, but for what r does between samples,
//!       whatever the poles, and |u| is bounded.
//!   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
//!   loop: not checked: `samples` is left to run time.
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

/// Run-time parameters of [`Stage21`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage21Params {
    /// samples N from the start to rest \[samples\], at least 4.
    pub samples: u32,
    /// sample period \[s\], from 1e-150 to 1e150.
    pub h: f64,
    /// bound of |u| \[unit of u\], > 0, infinity allowed.
    pub u_max: f64,
    /// gains k_i of pi0 = -sum k_i xi_i \[1/s^4\], finite.
    pub k: [f64; 4],
    /// samples to go at which deadbeat takes over, 0 for a safe default \[samples\], finite.
    pub deadbeat: f64,
    /// parameter of an expression of the design \[as in its expression\], finite.
    pub size: f64,
}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Stage21 {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest.
    samples: u32,
    /// input of the last sample.
    u1: f64,
    /// sample period.
    h: f64,
    /// parameter of an expression of the design.
    p_size: f64,
    /// derived from the parameters.
    c_r3: f64,
    /// derived from the parameters.
    c_r5: f64,
    /// derived from the parameters.
    c_r6: f64,
    /// derived from the parameters.
    c_r12: f64,
    /// samples to go at which deadbeat takes over.
    deadbeat: f64,
    /// weight of x1 in the law.
    w1_1: f64,
    /// weight of x2 in the law.
    w1_2: f64,
    /// weight of x3 in the law.
    w1_3: f64,
    /// weight of u1 in the law.
    w1_4: f64,
    /// weight of x2 in the law.
    w2_2: f64,
    /// weight of x3 in the law.
    w2_3: f64,
    /// weight of u1 in the law.
    w2_4: f64,
    /// weight of x3 in the law.
    w3_3: f64,
    /// weight of u1 in the law.
    w3_4: f64,
    /// weight of u1 in the law.
    w4_4: f64,
    /// weight of x1 in the law.
    b_1: f64,
    /// weight of x2 in the law.
    b_2: f64,
    /// weight of x3 in the law.
    b_3: f64,
    /// bound of |u|.
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
impl Stage21 {
    /// -67/128, weight of u1 in the law.
    const B_4: f64 = -0.5234375;

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: Stage21Params) -> Result<Self, Error> {
        if !((params.samples > 3)
            && (1e-150 <= params.h)
            && (params.h <= 1e150)
            && (params.u_max > 0.0)
            && params.k[0].is_finite()
            && params.k[1].is_finite()
            && params.k[2].is_finite()
            && params.k[3].is_finite()
            && params.deadbeat.is_finite()
            && (params.deadbeat >= 0.0)
            && params.size.is_finite())
        {
            return Err(Error::Param);
        }
        let samples = params.samples;
        let h = params.h;
        let p_size = params.size;
        let c_r3 = 2.0 * p_size;
        let c_r5 = 12.0 * p_size;
        let c_r6 = 0.75 * h;
        let c_r12 = (-0.25) * h;
        let s1 = (params.k[3] - 9.0) + 4.0;
        let s2 = if s1 < 8.0 { 8.0 } else { s1 };
        let deadbeat = if params.deadbeat > 0.0 {
            params.deadbeat
        } else {
            s2
        };
        let s3 = 1.0 / (params.h * params.h * params.h);
        let w1_1 = 0.5 * (-params.k[0]) * s3;
        let w1_2 = (-0.875) * (-params.k[0]) * (1.0 / (params.h * params.h));
        let w1_3 = 0.6822916666666666 * (-params.k[0]) * (1.0 / params.h);
        let w1_4 = (-0.6015625) * (-params.k[0]);
        let s4 = 0.5 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w2_2 = s4 * (1.0 / (params.h * params.h));
        let s5 = (-0.625) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let w2_3 = s5 * (1.0 / params.h);
        let w2_4 = 0.65625 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        let s6 = 0.5 * (((-7.0) - params.k[2]) + (3.0 * params.k[3]));
        let w3_3 = s6 * (1.0 / params.h);
        let w3_4 = (-0.75) * (((-7.0) - params.k[2]) + (3.0 * params.k[3]));
        let w4_4 = 6.0 - params.k[3];
        let b_1 = (-0.5) * (1.0 / (params.h * params.h * params.h));
        let b_2 = (-1.125) * (1.0 / (params.h * params.h));
        let b_3 = (-1.1822916666666667) * (1.0 / params.h);
        let u_max = params.u_max;
        if !(c_r3.is_finite()
            && c_r5.is_finite()
            && c_r6.is_finite()
            && c_r12.is_finite()
            && deadbeat.is_finite()
            && w1_1.is_finite()
            && w1_2.is_finite()
            && w1_3.is_finite()
            && w1_4.is_finite()
            && w2_2.is_finite()
            && w2_3.is_finite()
            && w2_4.is_finite()
            && w3_3.is_finite()
            && w3_4.is_finite()
            && w4_4.is_finite()
            && b_1.is_finite()
            && b_2.is_finite()
            && b_3.is_finite()
            && (params.h * params.h * params.h >= 1e-200)
            && (1.0 / (params.h * params.h * params.h) >= 1e-200))
        {
            return Err(Error::Param);
        }
        Ok(Self {
            start: 0,
            samples,
            u1: 0.0,
            h,
            p_size,
            c_r3,
            c_r5,
            c_r6,
            c_r12,
            deadbeat,
            w1_1,
            w1_2,
            w1_3,
            w1_4,
            w2_2,
            w2_3,
            w2_4,
            w3_3,
            w3_4,
            w4_4,
            b_1,
            b_2,
            b_3,
            u_max,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there. Estimates and inputs under way are kept.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, x: &[f64; 3]) -> Result<Control<f64>, Error> {
        if !(x[0].is_finite() && x[1].is_finite() && x[2].is_finite()) {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);
        let x1 = x[0];
        let x2 = x[1];
        let x3 = x[2];

        // The tracking error.
        let t = (elapsed as f64) * self.h;
        let v_r1 = t * t;
        let v_r2 = 1.0 + v_r1;
        let reference0 = (self.p_size * v_r1) / v_r2;
        let v_r4 = v_r2 * v_r2;
        let reference1 = (self.c_r3 * t * (v_r2 - v_r1)) / v_r4;
        let s1 = ((v_r4 + (4.0 * v_r1 * v_r1)) - (4.0 * v_r2 * t * t)) - (v_r2 * v_r1);
        let reference2 = (self.c_r3 * s1) / (v_r2 * v_r4);
        let v_r7 = t + self.c_r6;
        let v_r8 = v_r7 * v_r7;
        let v_r9 = 1.0 + v_r8;
        let v_r10 = v_r9 * v_r9;
        let v_r11 = v_r10 * v_r7;
        let s2 = ((4.0 * v_r9 * v_r7 * v_r8) + (2.0 * v_r9 * v_r8 * v_r7)) - v_r11;
        let s3 = self.c_r5 * ((s2 - v_r11) - (4.0 * v_r8 * (v_r7 * v_r8)));
        let rho0 = s3 / (v_r10 * v_r10);
        let v_r13 = t + self.c_r12;
        let v_r14 = if v_r13 < 0.0 { 0.0 } else { v_r13 };
        let v_r15 = v_r14 * v_r14;
        let v_r16 = 1.0 + v_r15;
        let v_r17 = v_r16 * v_r16;
        let v_r18 = v_r17 * v_r14;
        let s4 = (4.0 * v_r16 * v_r14 * v_r15) + (2.0 * v_r16 * v_r15 * v_r14);
        let s5 = ((s4 - v_r18) - v_r18) - (4.0 * v_r15 * (v_r14 * v_r15));
        let rho1 = (self.c_r5 * s5) / (v_r17 * v_r17);
        let e1 = x1 - reference0;
        let e2 = x2 - reference1;
        let e3 = x3 - reference2;
        let left = self.samples.saturating_sub(elapsed);
        let m0 = left as f64;
        let v: f64;
        if m0 > self.deadbeat {
            // The exact law in samples.
            let s6 = (self.w1_1 * e1) + (self.w1_2 * e2) + (self.w1_3 * e3);
            let z1 = s6 + (self.w1_4 * (self.u1 - (0.5 * rho1)));
            let s7 = self.w2_4 * (self.u1 - (0.5 * rho1));
            let z2 = (self.w2_2 * e2) + (self.w2_3 * e3) + s7;
            let z3 = (self.w3_3 * e3) + (self.w3_4 * (self.u1 - (0.5 * rho1)));
            let z4 = self.w4_4 * (self.u1 - (0.5 * rho1));
            let m0f2 = m0 * (m0 - 1.0);
            let m0f3 = m0f2 * (m0 - 2.0);
            let s8 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s8 + (self.u1 - (0.5 * rho1)) + (0.5 * rho0);
        } else {
            // Deadbeat.
            let s9 = (self.b_1 * e1) + (self.b_2 * e2) + (self.b_3 * e3);
            v = s9 + (Self::B_4 * (self.u1 - (0.5 * rho1))) + (0.5 * rho0);
        }
        if !v.is_finite() {
            return Err(Error::Range);
        }
        let u_now: f64;
        if v > self.u_max {
            u_now = self.u_max;
        } else if v < -self.u_max {
            u_now = -self.u_max;
        } else {
            u_now = v;
        }
        self.u1 = u_now;
        let status = if (v > self.u_max) || (v < -self.u_max) {
            Status::Saturated
        } else if elapsed < self.samples {
            Status::Ok
        } else {
            Status::Hold
        };
        Ok(Control { u: u_now, status })
    }
}
