//! The closed loop of a design with its plant, run before it is built.
//!
//! Theorem 1 is an equivalence: the plant under the controller over \[t0, t0 + tau) is the associated
//! infinite-time system over \[t0, inf), [th:1-4] and [th:1-7]. [`Continuous`] integrates the one and
//! maps back, so that nothing runs into a singularity; [`Direct`] integrates the other with the
//! emitted program in the loop; [`Sampled`] is the loop as it will run, with a zero-order hold,
//! noise, quantisation and delay.
//!
//! Both of the first step in sigma = -ln(T/tau), the stretched time of `exp` with a = 1: whatever the
//! mapping, an output T/tau is met exactly and the deadline is never passed.

mod along;
mod around;
mod between;
mod choice;
mod continuous;
mod control;
mod controller;
mod crossing;
mod direct;
pub mod event;
mod event_queue;
mod failure;
mod frame;
mod held;
mod inputs;
mod integrals;
#[cfg(feature = "lab")]
pub mod kept;
pub mod lanes;
mod linear;
mod mechanics;
mod method;
mod mode;
mod outputs;
mod pass;
mod pieces;
mod plant;
mod pole;
mod process;
pub mod record;
mod sampled;
#[cfg(feature = "lab")]
mod script;
mod side;
mod smooth;
mod solver;
mod surface;
mod switching;
mod terms;
mod tracking;
mod values;

pub(crate) use along::Along;
pub use around::Loop;
#[cfg(feature = "lab")]
pub(crate) use around::SAME;
pub use continuous::Continuous;
pub use control::Control;
pub use controller::Controller;
pub use direct::Direct;
pub use event::{Change, Event, Events};
pub use failure::{Cause, Failure};
pub use pieces::{Changes, Piece};
pub use process::Process;
pub use sampled::Sampled;
#[cfg(feature = "lab")]
pub use script::Script;
pub use side::{At, Run, Side};
pub use tracking::{Tracking, tracking_error};
pub use values::Values;

use crate::reference::Status;

/// Time-to-go of a continuous run as parts of tau: even in time, and from 0.01 on even in its logarithm
/// down to 1e-9.
pub fn grid() -> Vec<f64> {
    let even = (0..200).map(|i| f64::from(200 - i) / 200.0);
    let last = (1..=140).map(|i| 10f64.powf(-2.0 - f64::from(i) / 20.0));
    even.filter(|share| *share >= 0.01).chain(last).collect()
}

/// One instant of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<'a> {
    /// Time t in s.
    pub t: f64,
    /// Time-to-go T in s.
    pub time_to_go: f64,
    /// Stretched time since the start, kappa(t - t0), in s; NaN where it is not computed.
    pub stretched: f64,
    /// State x_1..x_n of the plant.
    pub x: &'a [f64],
    /// The measurement; the state itself if the loop is not sampled.
    pub measured: &'a [f64],
    /// The inputs of the plant, as they act on it.
    pub u: &'a [f64],
    /// The integrals that are asked for, from t0 to here.
    pub integrals: &'a [f64],
    /// The status of `step`.
    pub status: Status,
    /// True at the last sample of the sampled loop.
    pub last: bool,
}

/// Accuracy of the integration of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Bound of the error of a step, as a part of each state.
    pub relative: f64,
    /// Bound of the error of a step below which a state counts as nothing, in its units.
    pub absolute: f64,
    /// Most steps of a run.
    pub steps: usize,
}

impl Default for Accuracy {
    /// Returns the accuracy that printed digits need: 1e-12, and no bound from which on a state is not followed.
    fn default() -> Self {
        Self { relative: 1e-12, absolute: 1e-280, steps: 200_000 }
    }
}
