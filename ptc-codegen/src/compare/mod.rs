//! The controllers that engineers use in place of a design, in the loop of its campaign.
//!
//! [`Nominal`] is the plant as the design knows it. A regulator has the bandwidth that the rule in `tuning` gives;
//! a [`Rival`] follows a profile or a finite horizon with it. [`Comparison`] runs them and the emitted controller in
//! the same scenarios of `verify`, and keeps the worst of each figure.

mod column;
mod comparison;
mod entrant;
mod figures;
mod margins;
mod nominal;
mod operations;
mod profile;
mod regulator;
mod riccati;
mod rival;
mod soonest;
mod table;
mod target;
mod tuning;

pub use column::{COLUMNS, Column};
pub use comparison::{Comparison, Row, Scenes};
pub use entrant::{Contestant, Entrant, Entrants, Omitted, follower};
pub use figures::{AFTER, Figures, Record, SETTLED, measured, recorded};
pub use nominal::Nominal;
pub use operations::Operations;
pub use rival::{Law, Rival};
pub use soonest::{Soonest, soonest};
pub use tuning::MODULUS;
