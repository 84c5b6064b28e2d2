//! The heads of files: how to make them again, what the controller does, by which law and on which conditions.

mod axes;
pub mod coupled;
mod end;
mod filter;
mod flight;
mod followed;
mod formulas;
mod observed;
mod plant;
mod precision;
#[cfg(feature = "urdf")]
mod robot;
mod samples;
mod time;

pub(super) use axes::have_own;
pub(super) use formulas::{law, mapping};
pub(super) use plant::{chain, in_samples as plant_in_samples};
#[cfg(feature = "urdf")]
pub(super) use robot::lines as lines_of_robot;
#[cfg(feature = "cli")]
pub(super) use samples::law as law_in_samples;
pub(super) use samples::{formulas as formulas_in_samples, lines as lines_in_samples};
pub(super) use time::lines;

use super::declared;
use super::{Controller, Language};
