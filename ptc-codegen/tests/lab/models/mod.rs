//! Controllers of a plant that is known by a model, or by f and g: against formulas by hand, and in
//! closed loop with the emitted C.

mod by_hand;
mod closed_loop;
mod coupled;
mod divisors;
mod forms;
pub(crate) mod in_c;
mod in_samples;
#[cfg(feature = "lab")]
mod intermediates;
mod laws;
#[cfg(feature = "lab")]
mod long_chains;
mod mistakes;
#[cfg(feature = "lab")]
mod plants;
mod sampled;
mod selftest;
#[cfg(feature = "lab")]
mod simulated;
use crate::support;
#[cfg(feature = "lab")]
mod verified;
mod zeros;

use support::{example, folder_with, run_in, spec};

/// Verdict and summary of the check called `name`, for a design in a folder of the test.
fn checked(name: &str, test: &str, design: &str) -> (String, String) {
    let folder = folder_with(test, "design.toml", design);
    let (_, json, stderr) = run_in(&folder, &["check", "design.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
    let all = found["checks"].as_array().expect("checks");
    let own = all.iter().find(|check| check["name"] == name).expect("an outcome");
    let word = |key: &str| own[key].as_str().expect("text").to_owned();
    (word("verdict"), word("summary"))
}

/// The magnet of examples/levitation.toml at numbers that hold it at z0.
const LEVITATION: &str = "static const levitation_params params = { .tau = 0.5, .t0 = 0.0, .u_max = INFINITY, \
     .L = 0.02, .R = 1.5, .i0 = 0.8, .z0 = 0.01 };";
/// The other controllers, whose models have numbers.
const FIXED: &str = "{ .t0 = 0.0 };";

/// The static parameters of a controller whose model is fixed.
fn fixed(name: &str, further: &str) -> String {
    format!("static const {name}_params params = {}", FIXED.replace(" }", &format!("{further} }}")))
}
