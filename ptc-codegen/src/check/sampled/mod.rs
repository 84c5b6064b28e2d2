//! The loop that runs: the emitted law, called once a sample, its output held in between.
//!
//! For a linear law the loop is linear, and the worst that bounded noise, steps of sensors and
//! actuator, delay, the plant's f and the state at the start can do is a finite sum (`worst`), attained by the signs
//! of its terms. The gains are those of the emitted program with its rounding (`gains`, `rounded`),
//! the chain between two samples is exact (`chain`), and what the arithmetic of the sum itself may
//! lose is bounded by where its states are, or with its transitions (`trust`, `transition`).

mod between;
mod cells;
mod chain;
mod compared;
mod emitted;
mod eps;
mod feasible;
mod followed;
mod force;
mod gain;
mod gains;
mod gating;
mod jitter;
mod joined;
mod judge;
mod lost;
#[cfg(feature = "files")]
mod margins;
mod model;
mod moved;
mod outcome;
mod peaks;
#[cfg(feature = "lab")]
mod proved;
mod random;
mod reach;
mod relative;
mod rounded;
mod span;
mod stability;
mod sums;
mod systems;
#[cfg(feature = "files")]
mod trajectory;
mod transition;
mod trust;
mod way;
mod worst;

pub use cells::Worst;
pub(crate) use eps::Candidate;
pub use eps::{Choice, curve};
pub(crate) use feasible::feasible;
pub use feasible::soonest_tau;
#[cfg(feature = "lab")]
pub use feasible::{FeasibleSet, Outline, Unlimited};
pub use gating::{Cost, Gating};
pub(crate) use judge::Loop;
#[cfg(feature = "files")]
pub use margins::{Margins, margins};
pub use outcome::causes;
pub(crate) use outcome::{NAME, outcome};
#[cfg(feature = "lab")]
pub(crate) use proved::proved;
pub use span::Span;
pub use stability::{Damped, Margin, NoMargins, Stability, margin_of, stability};
pub(crate) use stability::{Tolerance, bands, smallest_tolerant, tolerance};
pub use sums::Sum;
#[cfg(feature = "files")]
pub use trajectory::{Trajectory, trajectory};
pub use way::{Afterwards, Way};
pub use worst::Bound;

#[cfg(test)]
mod tests;
