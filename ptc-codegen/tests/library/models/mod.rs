//! Controllers of a plant that is known by a model, or by f and g: against formulas by hand, and in
//! closed loop with the emitted C.

mod by_hand;
mod closed_loop;
mod coupled;
mod divisors;
pub(crate) mod in_c;
mod mistakes;
#[cfg(feature = "lab")]
mod plants;
mod sampled;
#[cfg(feature = "lab")]
mod simulated;
use crate::support;
#[cfg(feature = "lab")]
mod verified;
mod zeros;

use support::{example, spec};

/// The magnet of examples/levitation.toml at numbers that hold it at z0.
const LEVITATION: &str = "static const levitation_params params = { .tau = 0.5, .t0 = 0.0, .u_max = INFINITY, \
     .L = 0.02, .R = 1.5, .i0 = 0.8, .z0 = 0.01 };";
/// The other controllers, whose models have numbers.
const FIXED: &str = "{ .t0 = 0.0 };";

/// The static parameters of a controller whose model is fixed.
fn fixed(name: &str, further: &str) -> String {
    format!("static const {name}_params params = {}", FIXED.replace(" }", &format!("{further} }}")))
}
