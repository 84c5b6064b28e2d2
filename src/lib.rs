//! Prescribed-time controllers: a chain of integrators is brought to rest at a time you choose.
//!
//! The plant is `x1' = x2, ..., xn' = f + g u`, g = 1 unless given: x1 in any unit, xi in unit/s^(i-1), g u in unit/s^n.
//! [`ptc_controller!`] writes a controller for one order n and one mapping of time, specialised when
//! your crate is compiled; this crate holds the types that all such controllers share. Nothing
//! allocates, nothing panics, and no `std` is needed.
//!
//! The law is Theorem 1 of A. Shakouri and N. Assadian, *A Framework for Prescribed-Time Control
//! Design via Time-Scale Transformation*; unless you give another, with g = 1 and a linear law in
//! stretched time: u = kappa'^n (pi0 - b_n^T x), pi0 = -k^T BB_n x. Choose the gains k so that the roots of
//! s^n + k_n s^(n-1) + ... + k_1 lie left of -n rho, where rho is the decay rate of the mapping
//! (a for `exp` and `soft`, 2a for `tanh`, the least rate for `exp_sum`, else 0): then u vanishes at the
//! deadline. The macro refuses fixed gains that do not. `docs/checks` in the repository documents the
//! other checks, `docs/expressions.md` user-defined mappings and laws.
//!
//! ```
//! use ptc::{Controller, Status};
//!
//! ptc::ptc_controller!(n = 3, mu = exp);
//!
//! # fn main() -> Result<(), ptc::Error> {
//! let mut controller = PtcExp3::new(PtcExp3Params {
//!     tau: 2.0,             // at rest 2 s after the start
//!     t0: 0.0,              // the start
//!     eps: 1e-3,            // gains are held for the last millisecond
//!     u_max: f64::INFINITY, // no clipping
//!     a: 1.0,               // rate of stretched time
//!     k: [120.0, 74.0, 15.0], // poles -4, -5, -6 in stretched time
//! })?;
//! let control = controller.step(0.5, &[1.0, 0.0, 0.0])?;
//! assert_eq!(control.status, Status::Ok);
//! controller.arm(10.0)?; // the same manoeuvre again, from t = 10 s
//! # Ok(())
//! # }
//! ```
//!
//! # Features
//!
//! Where a controller calls a mathematical function, it comes from one of
//!
//! - `std` (default): the standard library;
//! - `libm`: the crate `libm`, for targets without `std`. It wins where both are on.
//!
//! | family | calls |
//! | --- | --- |
//! | `exp`, `rational`, `tan`, `tanh`, `soft`, `power` with an integer `m` fixed | nothing: compiles without either feature |
//! | `algebraic`, `power` with half an odd integer `m` fixed | `sqrt`, which every library rounds alike |
//! | `power` otherwise | `pow` |
//! | `exp_sum` | `exp`, `ln` |

#![no_std]
#![forbid(unsafe_code)]

/// The code of the first page is compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../docs/start.md")]
struct Start;

/// So is that of the page on expressions.
#[cfg(doctest)]
#[doc = include_str!("../docs/expressions.md")]
struct Expressions;

/// And that of the pages on the two clocks.
#[cfg(doctest)]
#[doc = include_str!("../docs/time.md")]
struct Time;

#[cfg(doctest)]
#[doc = include_str!("../docs/samples.md")]
struct Samples;

#[cfg(all(feature = "std", not(feature = "libm")))]
extern crate std;

mod control;
mod controller;
mod error;
#[doc(hidden)]
pub mod math;

pub use control::{Axes, Control, Status};
pub use controller::Controller;
pub use error::Error;

/// Writes a prescribed-time controller: its type, its parameters and its methods.
///
/// The arguments are `key = value`, separated by commas, in any order.
///
/// | key | meaning | value | default |
/// | --- | --- | --- | --- |
/// | `n` | order of the chain of integrators | an integer 1..=16 | must be given, but beside a model |
/// | `axes` | number of chains with one deadline that each call gives u for | an integer 1..=16 | one chain |
/// | `limits` | limits of u of each axis, in place of `u_max` and `u_min` | for each axis a number > 0, the bound of \|u\|, or a pair `[lower, upper]` | `u_max` for all |
/// | `mu` | mapping of time, with its parameters where they are fixed | `exp`, `rational`, `power`, `tan`, `tanh`, `algebraic`, `exp_sum`, `soft`; `exp(a = 1)`, `power(m = 2)`, `exp_sum(3)` for three run-time rates, `exp_sum(rates = [0.5, 1.5])`; or an expression in stretched time: `tau*(1 - exp(-a*t))` | this or `kappa` must be given |
/// | `kappa` | the same mapping by its inverse, in place of `mu` | an expression in the elapsed time: `-ln(1 - dt/tau)/a` | `mu` |
/// | `name` | name of the controller | an identifier of at most 48 letters, digits and `_`; made CamelCase | `ptc_<family><n>` |
/// | `units` | unit of x1, from which the docs give those of x2..xn and u | a word of at most 16 letters, `rad` | any |
/// | `what` | what is generated | `controller`; `associated`: the infinite-time system on which pi0 is designed; `observer`: the observer in samples alone; `filter`: bounds of the states under any controller | `controller` |
/// | `clock` | what a call is given | `time`: t; `samples`: the number of the sample, for the exact law in samples | `time` |
/// | `precision` | floating-point type | `f64` or `f32` | `f64` |
/// | `fma` | products and sums as fused multiply-adds, with one rounding; fast where the target has them | `true` or `false` | `false` |
/// | `latency` | polynomials as trees: shorter chains of operations, a few more of them | `true` or `false` | `false` |
/// | `guard` | run-time checks of the inputs of `step` | `full`; `result`: one test on u catches x and t that are not finite; `none` | `full` |
/// | `gains` | gains k_1..k_n of the law pi0 = -sum k_i xi_i, k_i in s^(i-1-n) | a list of n finite numbers: `[120, 74, 15]`; with `axes` also a list of them for each axis | run time |
/// | `poles` | poles of the loop in stretched time, in place of `gains` | `least-energy`, `least-energy(weight = W)`, or n numbers, complex ones in pairs: `[-4, -3+2*i, -3-2*i]`; with `axes` also a list of them for each axis | |
/// | `pi0` | law of the infinite-time system, in place of `gains` | an expression in `xi1`..`xin`, `t` and latched `x1_0`, `xi1_0`; or `extern`: `step` takes a closure of xi and stretched time | the linear law |
/// | `g` | input gain of the plant | an expression in `x1`..`xn` and `t`; where it is 0, `step` gives `Error::Range`; with `axes` an expression in parameters, or one for each axis | 1 |
/// | `f` | known part of the plant, cancelled | an expression in `x1`..`xn` and `t`; a finite number with `clock = samples` | 0 |
/// | `reference` | what x1, or the output of a model, follows in place of 0; with `clock = time` | an expression in `t`; or `input`: `step` takes r and its n derivatives behind x | 0 |
/// | `states` | names of the states of a model of the plant, from which x1..xn, f and g follow | a list of names: `[angle, speed]` | |
/// | `input` | name of the input of the model | a name | |
/// | `output` | output of the model that is brought to 0: x1 | an expression in the states | |
/// | `dynamics` | rate of each state of the model | an expression for each state, affine in the input: a list in their order, or in a design file `{ state = "rate" }` | |
/// | `let` | intermediate values of the model, which later ones and its expressions use | `{ name = "expression" }` | |
/// | `inputs` | names of the inputs of a model with several | a list of names | |
/// | `outputs` | outputs of a model with several inputs, which are brought to 0 | an expression in the states for each input, at most 3 | |
/// | `inertia` | matrix M(q) of a mechanical model M q'' + bias = u, whose states are q and then q' | a row for each input, of an expression in q for each input | |
/// | `bias` | what the inputs of a mechanical model balance at q'' = 0: gravity, friction, Coriolis forces | an expression in q and q' for each input | |
/// | `A` | matrix of a linear plant x' = A x + B u, y = C x in place of a chain; with `clock = samples` | n rows of n finite numbers, n <= 8 | |
/// | `B` | what the input of the linear plant moves | n finite numbers | |
/// | `C` | what is measured of the linear plant, in place of `measured` | n finite numbers, or rows of them | all states |
/// | `tau` | prescribed settling time in s | a number > 0 | run time |
/// | `t0` | start time in s | a finite number | run time |
/// | `eps` | time-to-go in s at which the gains are held | a number > 0 and < tau | run time |
/// | `u_max` | bound of \|u\|, or beside `u_min` the upper limit of u | a number > 0, beside `u_min` any above it; `inf` leaves the clipping out | run time |
/// | `u_min` | lower limit of u | a number < `u_max`, `-inf`; or `runtime`: a run-time parameter | -`u_max` |
/// | `after` | what follows the deadline | `hold`: the gains stay; `zero`: u = 0; `extern`: `step` takes a closure of x and t | `hold` |
/// | `sample_time` | sample period of the loop in s; sets the default of `eps` | a number > 0 | |
/// | `error` | wanted bound of \|x_i\| at the deadline; sets `eps` | a number > 0, or one for each state, with `x0_max`; with several outputs in samples also a list for each | |
/// | `noise` | bounds of the noise of each measured state | a number >= 0, or one for each state | |
/// | `noise_rms` | standard deviations of random noise of each measured state | a number >= 0, or one for each state | |
/// | `g_error` | least and greatest true input gain, in parts of `g` | two numbers > 0, the smaller one first | |
/// | `jitter` | how early or late a sample may be, in s | a number >= 0 and < sample_time/2 | |
/// | `margin_gain` | gain margin of a chosen eps: stable from 1/margin_gain to margin_gain times the input gain, as far as error allows | a number >= 1 | 2 |
/// | `margin_delay` | delay margin of a chosen eps, in samples beyond `delay`, as far as error allows | an integer 0..=16 | 1 |
/// | `sensor_step` | steps in which each state is measured | a number >= 0, or one for each state | |
/// | `u_step` | step of the actuator | a number >= 0 | |
/// | `delay` | samples between a measurement and the input that follows from it | a number from 0 to 16; with clock = time an integer | |
/// | `delay_law` | law of a delay: the plant predicted over it, or the order raised by its samples; with `clock = samples` | `predict` or `extend` | by the number of poles |
/// | `deadbeat` | samples to go at which deadbeat takes over; with `clock = samples` | an integer of at least the order of the loop | |
/// | `poles_end` | poles of the law that takes over towards the end; with `clock = samples` | `least-energy`, `least-energy(weight = W)` or a list of them | none, or as soft as the law |
/// | `end_samples` | samples to go from which on these are the poles | an integer of at least the order of the loop | from the poles |
/// | `gain_bytes` | most bytes of the table of gains of least energy of a linear plant | an integer from 1 to 16777216 | what the law needs |
/// | `late` | what becomes of a deadline that is too soon for the limits; with `clock = samples` | `clip`: u is clipped; `extend`: it is put off; `refuse`: `arm_for` refuses it | `clip` |
/// | `pace` | deadline: kept as it was asked for, or planned as soon as the limits allow at every sample | `deadline` or `soonest` | `deadline` |
/// | `state_max` | bounds of the states that a planned deadline keeps | a number > 0 or `inf`, or one for each state | `inf` |
/// | `reserve` | part of each limit that a planned deadline leaves free | a number from 0 up to, not including, 1 | 0 |
/// | `in_flight` | whether the deadline may change while it runs: with `clock = samples` target and estimates too, with `clock = time` tau, which the design leaves out | `true` or `false` | `false`, `true` beside `late` |
/// | `measured` | states that are measured, an observer gives the others; with `clock = samples` | `x1`, or `[x1, x2]` and so on without a gap | all |
/// | `disturbance` | what is added to u and not known; with `clock = samples` | `constant`, `ramp` or `sine(omega=W)`: it is estimated and cancelled; `none` | `none` |
/// | `observer` | law of the gains of the observer; with `clock = samples` | `prescribed`: a round; `stationary`: a Kalman filter | `prescribed` |
/// | `disturbance_walk` | drift of the unknown disturbance in a second, as a standard deviation; of a stationary observer | a number > 0 | |
/// | `observer_poles` | poles of the observer in stretched time; with `clock = samples` | one for each state that is estimated | |
/// | `observer_samples` | samples after which the estimates are exact; with `clock = samples` | an integer | half of all; none with `what = observer` |
/// | `observer_eps` | time-to-go in s at which the gains of the observer are held; with `clock = samples` | a number > 0 | |
/// | `after_observer` | poles of the observer in 1/s once the estimates are exact; with `clock = samples` | one for each state that is estimated, with real parts < 0; or `stationary` | the last gains stay |
/// | `innovation_max` | bound of \|y - predicted y\| beyond which the observer predicts alone; with `coast` | a number > 0, or one for each measured value | |
/// | `measurement_max` | range of the sensor: a larger reading counts as lost; with an observer | a number > 0, or one for each measured value | |
/// | `coast` | consecutive samples that the observer predicts alone; with `clock = samples` | an integer 0..=65535 | 0 |
/// | `keep_below` | upper bounds of x1, x2, ... that a filter keeps; with `what = filter` | a number or `inf` for each, the last ones may be left out | `inf` |
/// | `keep_above` | lower bounds of x1, x2, ... that a filter keeps | a number or `-inf` for each, the last ones may be left out | `-inf` |
/// | `keep_poles` | poles in 1/s with which the states approach these bounds | n numbers < 0 | |
/// | `keep_tolerance` | distance beyond its bounds at which a state counts as within them | a number > 0 for each, the last ones may be left out | 2^-30 of the greater bound, in f32 2^-12 |
/// | `urdf` | file of a robot, which is the plant; only the command reads it, and the macro refuses it | a path, relative to the design file | |
/// | `base` | link of a robot that does not move | the name of a link | the root of the file |
/// | `tip` | links at the ends of a robot | the name of a link, or a list | all that the base carries |
/// | `gravity` | acceleration of gravity in the axes of a robot's base, m/s^2 | three numbers | `0,0,-9.81` |
/// | `payload` | what the tip of a robot carries: mass, kg, and centre in the frame of the tip, m | 4 numbers, or 10 with its inertia about the centre, kg m^2 | none |
/// | `rotor` | inertia of the rotors of a robot behind their gears, kg m^2, or kg of joints that slide | a number >= 0 for all joints, or one for each | 0 |
/// | `damping` | viscous friction of the joints of a robot, N m s/rad or N s/m | a number >= 0 for all joints, or one for each | `damping` of `<dynamics>` in the file |
/// | `friction` | dry friction of the joints of a robot, N m or N | a number >= 0 for all joints, or one for each | `friction` of `<dynamics>` in the file |
/// | `friction_width` | velocity v0 that smooths the sign of dry friction, v/sqrt(v^2 + v0^2), rad/s or m/s | a number >= 1e-6 for all joints, or one for each | 0.01 |
/// | `x0_max` | bounds of \|x_i\| at the start | n numbers > 0; with several outputs in samples also a list for each | |
/// | `x_max` | bounds of \|x_i\| at all times | n numbers > 0 | |
/// | `allow` | checks that may fail | `membership`, `growth`, `sampling`, `deadline`, `loop`, `envelope`, `zeros` | none |
///
/// Every other name in an expression is a parameter: a field of the parameters, or fixed by
/// `params.a = 1`, or bounded by `params.a = [0.5, 2]`.
///
///
/// `file = "roll.toml"` reads a design file, from the folder of `Cargo.toml` on. It holds the same
/// keys as TOML, with text in quotes and parameters under `[params]`; keys beside `file` stand for
/// those in it, `params.tau = 2` for one of a table. The crate is built again when it changes.
///
/// What is left to run time is a field of the parameters; what is given here is folded into the
/// code and is none.
///
/// # What it expands to
///
/// `ptc_controller!(n = 3, mu = exp)` gives
///
/// ```
/// # mod shape {
/// # use ptc::{Control, Controller, Error};
/// pub struct PtcExp3Params {
///     pub tau: f64,
///     pub t0: f64,
///     pub eps: f64,
///     pub u_max: f64,
///     pub a: f64,      // `m` follows under `power`, `start` under `soft`; `rates: [f64; N]` in its place under `exp_sum`
///     pub k: [f64; 3],
/// }
///
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// pub struct PtcExp3 { /* coefficients, formed once by `new` */ }
///
/// impl PtcExp3 {
///     /// `Error::Param`: a parameter is outside its domain.
///     pub fn new(params: PtcExp3Params) -> Result<Self, Error>
/// # { unimplemented!() }
///     /// Starts again at `t0`. `Error::Param`: `t0` is not finite.
///     pub fn arm(&mut self, t0: f64) -> Result<(), Error>
/// # { unimplemented!() }
///     /// u for the state `x` at time `t`.
///     pub fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control, Error>
/// # { unimplemented!() }
///     /// The gains at time `t`, for several axes that share a deadline.
///     pub fn tick(&self, t: f64) -> Result<PtcExp3Gains, Error>
/// # { unimplemented!() }
/// }
///
/// pub struct PtcExp3Gains { /* `gain: [f64; 3]` and what else `axis` needs */ }
///
/// impl PtcExp3Gains {
///     /// u of one axis with state `x`. It rounds otherwise than `step` does.
///     pub fn axis(&self, x: &[f64; 3]) -> Result<Control, Error>
/// # { unimplemented!() }
/// }
///
/// impl Controller<3> for PtcExp3 { /* the same */
/// # type Real = f64;
/// # fn arm(&mut self, t0: f64) -> Result<(), Error> { unimplemented!() }
/// # fn step(&self, t: f64, x: &[f64; 3]) -> Result<Control, Error> { unimplemented!() }
/// }
/// # }
/// ```
///
/// With `axes = 6` `step` takes `x: &[[f64; 3]; 6]` and gives [`Axes<6>`](Axes): u and a status for each
/// axis, and one for all.
///
/// # Examples
///
/// Every parameter fixed but the settling time, the start and the bound, in single precision:
///
/// ```
/// ptc::ptc_controller!(
///     n = 2,
///     mu = exp(a = 1),
///     name = roll_axis,
///     precision = f32,
///     gains = [6, 5],
///     eps = 1e-2,
/// );
///
/// # fn main() -> Result<(), ptc::Error> {
/// let roll = RollAxis::new(RollAxisParams { tau: 1.0, t0: 0.0, u_max: 20.0 })?;
/// let u: f32 = roll.step(0.0, &[1.0, 0.0])?.u;
/// # assert!((u + 6.0).abs() < 1e-5);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
///
/// Every mistake in the arguments is a compile error at the token that is wrong; all of them are
/// told at once, with what is legal.
///
/// ```compile_fail
/// ptc::ptc_controller!(n = 3, mu = exponential); // did you mean `exp`?
/// ```
pub use ptc_macros::ptc_controller;
