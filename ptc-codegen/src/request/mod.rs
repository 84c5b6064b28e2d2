//! The user's request. Every front end ends in a [`Spec`].

mod axes;
mod command;
mod fingerprint;
mod flight;
mod input_limits;
mod keep;
mod larger;
mod least_energy;
mod legal;
mod needs;
mod observer;
mod parameters;
mod plant;
mod poles;
mod promises;
mod read;
mod reference;
mod sampled;
mod spec;
#[cfg(feature = "simulate")]
mod start;
mod units;

pub use axes::Axes;
#[cfg(feature = "files")]
pub(crate) use fingerprint::hash;
pub use flight::{Flight, Late};
pub use input_limits::Limits;
pub(crate) use input_limits::RUNTIME;
pub(crate) use keep::product_of_rates;
pub use keep::{Edge, Keep};
pub use larger::LargerPlant;
pub(crate) use larger::has_own_states;
pub use least_energy::{EndLaw, LeastEnergy};
pub use observer::{Gate, Lasting, Observer, Round, Stationary};
pub use poles::{Pole, PoleError, gains};
pub(crate) use promises::exact_one_or_each;
pub use promises::{PlantBounds, Promises, Resonance, one_or_each};
#[cfg(feature = "cli")]
pub(crate) use read::asks_for_functions;
pub(crate) use read::derivatives;
#[cfg(feature = "simulate")]
pub use read::read_run;
#[cfg(feature = "urdf")]
pub(crate) use read::values::{LONGEST_NAME, chosen, hyphenated, named};
pub use read::{Entry, read};
pub(crate) use read::{NO_TIP, driven, part_of, payload_of};
pub(crate) use read::{items, known, meant, state_name};
#[cfg(feature = "urdf")]
pub(crate) use read::{robot_of, robot_source};
pub use reference::Reference;
pub use sampled::{DelayLaw, Exact, Exponents, Sampled};
pub use spec::Spec;
#[cfg(feature = "files")]
pub(crate) use units::chain_unit;

use std::sync::Arc;

use crate::expression::Expression;
use crate::linear::Schedule;

/// Largest order that is generated. The expansions are exact for any order; beyond this one the
/// rounding of the law in double precision (growing with n) leaves the accuracy that is promised.
pub const MAX_ORDER: usize = 16;

/// Largest number of samples to a deadline.
pub const MAX_SAMPLES: u32 = 1 << 31;

/// Largest number of rates of `exp_sum`.
pub const MAX_RATES: usize = 16;

/// Run-time checks of the inputs of `step`. A result that is not finite is [`PTC_E_RANGE`](crate::emit) under each of
/// them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Guard {
    /// Every input and pointer is checked.
    Full,
    /// One test on the result catches non-finite x and t; pointers and t < t0 are trusted.
    Result,
    /// Inputs and pointers are trusted.
    None,
}

/// The law pi0(xi, t) of the infinite-time system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Feedback {
    /// pi0 = -(k_1 xi_1 + ... + k_n xi_n).
    Linear,
    /// An expression.
    Expression(Expression),
    /// A function of the user's program.
    Extern,
    /// The gains of least energy of a linear plant, by the samples to go.
    LeastEnergy(Arc<Schedule>),
}

/// Behaviour after the deadline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum After {
    /// The gains stay as they are at time-to-go eps.
    Hold,
    /// u = 0.
    Zero,
    /// A law of the user's program.
    Extern,
}

/// Program to generate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum What {
    /// The controller.
    Controller,
    /// The right-hand side of the associated infinite-time system, on which pi0 is designed.
    Associated,
    /// The observer in samples alone, for a user-defined law.
    Observer,
    /// A filter in samples, which keeps states within bounds under any controller.
    Filter,
}

impl What {
    /// All of them, by the names that users write.
    pub(crate) const NAMES: [(&'static str, Self); 4] = [
        ("controller", Self::Controller),
        ("associated", Self::Associated),
        ("observer", Self::Observer),
        ("filter", Self::Filter),
    ];
}

/// Clock argument of a call of the controller, besides the state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Time t.
    Time,
    /// The number of the sample.
    Samples(Box<Sampled>),
}
