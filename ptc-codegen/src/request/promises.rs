//! Promises of a design beyond the code.

use num_traits::ToPrimitive;

use crate::algebra::BigRational;
use crate::linear::{Delay, Side};
use crate::parameter::Fixed;

/// Promises of the design beyond the code, for the checks at generation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Promises {
    /// Sample period of the loop, s.
    pub sample_time: Option<Fixed>,
    /// Wanted bounds of |x_i| at the deadline, one for all or one each; empty where not given. Those of the chains
    /// of several outputs may stand one after the other, as those at the start may.
    pub error: Vec<Fixed>,
    /// Bounds of the noise of each measured state, or one for all; empty for none.
    pub noise: Vec<Fixed>,
    /// Standard deviations of the random noise of each measured state, or one for all; empty for
    /// none.
    pub noise_rms: Vec<Fixed>,
    /// Steps in which each state is measured, or one for all; empty for none.
    pub sensor_step: Vec<Fixed>,
    /// Step of the actuator.
    pub u_step: Option<Fixed>,
    /// The least and the greatest true input gain in parts of the known one; empty where they are the
    /// same.
    pub g_error: Vec<Fixed>,
    /// Largest deviation of a sample from its time, early or late, s.
    pub jitter: Option<Fixed>,
    /// Factor of the input gain, up and down, that a chosen eps tolerates.
    pub margin_gain: Option<Fixed>,
    /// Samples of added delay that a chosen eps tolerates.
    pub margin_delay: Option<Fixed>,
    /// Delay with which u acts.
    pub delay: Option<Delay>,
    /// Bounds of |x_i| at the start; empty where they are not given.
    pub x0_max: Vec<Fixed>,
    /// Bounds of |x_i| at all times; empty where they are not given.
    pub x_max: Vec<Fixed>,
    /// Checks that may fail.
    pub allow: Vec<String>,
    /// Bounds of the plant's f and g, from the table `[plant]`; `None` for a chain with f = 0 and the controller's own
    /// g.
    pub plant: Option<PlantBounds>,
    /// A resonance of the plant that the law does not know, from the table `[plant]`.
    pub resonance: Option<Resonance>,
}

/// Two inertias joined by a spring with a damper: the least and the greatest value of each quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Resonance {
    /// Frequency of the free resonance, Hz.
    pub frequency: [BigRational; 2],
    /// Damping ratio.
    pub damping: [BigRational; 2],
    /// Inertia of the load over that of the motor.
    pub inertia_ratio: [BigRational; 2],
    /// The side that is measured.
    pub measured: Side,
}

/// Number `j`, from 0, of a list that holds one for all, or one each; of several axes one for each
/// state of an axis.
pub fn one_or_each(values: &[Fixed], j: usize) -> Option<f64> {
    exact_one_or_each(values, j)?.to_f64()
}

/// The same as a fraction.
pub(crate) fn exact_one_or_each(values: &[Fixed], j: usize) -> Option<&BigRational> {
    values.get(j.checked_rem(values.len())?)?.number()
}

/// Bounds of f and g of the plant, for the sampled loop.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(clippy::large_enum_variant)] // One per design.
pub enum PlantBounds {
    /// f is `middle`, and as far from it as both others together; g is a number.
    Bounded {
        /// The middle of f.
        middle: BigRational,
        /// Largest constant deviation of f from the middle.
        constant: BigRational,
        /// Largest further deviation of f, as any signal.
        varying: BigRational,
        /// The least and the greatest true g; `None` for the controller's own.
        gain: Option<[BigRational; 2]>,
    },
    /// Why f or g has no such bounds.
    Unknown(String),
}
