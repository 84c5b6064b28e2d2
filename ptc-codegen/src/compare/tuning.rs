//! The rule by which the bandwidth of a regulator is chosen.

use super::margins::Loop;
use super::nominal::Nominal;
use super::regulator::Regulator;

/// Modulus margin that a loop keeps.
pub const MODULUS: f64 = 0.5;

/// Bandwidths that are tried, in rad per sample.
const LEAST: f64 = 1.0 / 256.0;
const MOST: f64 = 1.0;

/// Bandwidths that are tried for each power of 2 between them, and halvings behind the last good one.
const EACH: u32 = 2;
const HALVINGS: u32 = 12;

/// A regulator with the bandwidth in rad/s that was chosen for it.
#[derive(Clone, Debug)]
pub(super) struct Tuned<R> {
    /// The regulator.
    pub regulator: R,
    /// Its bandwidth in rad/s.
    pub bandwidth: f64,
}

/// Returns the regulator with the largest bandwidth up to which the sampled loop with its delay keeps the modulus margin;
/// with `given` rad/s where they are given. `None` if no bandwidth keeps it.
pub(super) fn tuned<R: Regulator>(
    nominal: &Nominal,
    given: Option<f64>,
    make: &dyn Fn(&Nominal, f64) -> Option<R>,
) -> Option<Tuned<R>> {
    if let Some(bandwidth) = given {
        return Some(Tuned { regulator: make(nominal, bandwidth)?, bandwidth });
    }
    let tried = |rate: f64| {
        let bandwidth = rate / nominal.h;
        let regulator = make(nominal, bandwidth)?;
        let keeps = Loop::new(nominal, &regulator).modulus() >= MODULUS;
        keeps.then_some(Tuned { regulator, bandwidth })
    };
    let factor = f64::from(EACH).recip().exp2();
    let mut good = LEAST;
    let mut found = tried(good)?;
    let mut bad = loop {
        let next = good * factor;
        match tried(next) {
            Some(own) if next <= MOST => (good, found) = (next, own),
            _ => break next,
        }
    };
    for _ in 0..HALVINGS {
        let middle = (good * bad).sqrt();
        match tried(middle) {
            Some(own) => (good, found) = (middle, own),
            None => bad = middle,
        }
    }
    Some(found)
}
