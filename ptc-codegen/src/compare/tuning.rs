//! The rule by which the bandwidth of a regulator is chosen.

use super::margins::Loop;
use super::nominal::Nominal;
use super::regulator::Regulator;

/// Modulus margin that a loop keeps.
pub const MODULUS: f64 = 0.5;

/// Part of the modulus margin of the slowest loop that is enough where this is below [`MODULUS`]: an observer leaves a chain
/// of order 3 less than that at any bandwidth.
pub(super) const SHARE: f64 = 0.9;

/// Part of the limit of u that the errors of the sensors may move it by, as a standard deviation.
pub(super) const NOISE: f64 = 0.02;

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

/// Returns the regulator with the largest bandwidth up to which the sampled loop with its delay keeps the modulus margin
/// and the errors of the sensors move u little; with `given` rad/s where they are given. `None` if its gains are not found, or no loop is stable.
pub(super) fn tuned<R: Regulator>(
    nominal: &Nominal,
    given: Option<f64>,
    make: &dyn Fn(&Nominal, f64) -> Option<R>,
) -> Option<Tuned<R>> {
    if let Some(bandwidth) = given {
        return Some(Tuned { regulator: make(nominal, bandwidth)?, bandwidth });
    }
    let at = |rate: f64| {
        let bandwidth = rate / nominal.h;
        make(nominal, bandwidth).map(|regulator| Tuned { regulator, bandwidth })
    };
    let modulus = |own: &Tuned<R>| Loop::new(nominal, &own.regulator).modulus();
    let factor = f64::from(EACH).recip().exp2();
    let all = std::iter::successors(Some(LEAST), |rate| Some(rate * factor));
    let mut rates = all.take_while(|rate| *rate <= MOST);
    // A mode of the plant that decays just as fast leaves the slowest ones without gains.
    let (mut good, mut found) = rates.by_ref().find_map(|rate| Some((rate, at(rate)?)))?;
    let wanted = MODULUS.min(SHARE * modulus(&found));
    if wanted == 0.0 {
        return None;
    }
    let is_calm =
        |own: &Tuned<R>| Loop::new(nominal, &own.regulator).noise() <= NOISE * nominal.limit;
    let tried = |rate: f64| at(rate).filter(|own| modulus(own) >= wanted && is_calm(own));
    let mut bad = good * factor;
    for rate in rates {
        bad = rate;
        match tried(rate) {
            Some(own) => (good, found) = (rate, own),
            None => break,
        }
    }
    for _ in 0..HALVINGS {
        let middle = (good * bad).sqrt();
        match tried(middle) {
            Some(own) => (good, found) = (middle, own),
            None => bad = middle,
        }
    }
    Some(found)
}
