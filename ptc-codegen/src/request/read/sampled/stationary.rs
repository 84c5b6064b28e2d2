//! The gains of a stationary observer, from the noise of the design.

use crate::algebra::{BigRational, integer};
use crate::linear::{Disturbance, Linear, Matrix, Noisy, Pair};
use crate::parameter::{Fixed, Parameter};
use crate::request::read::Reader;
use crate::request::read::promises::finite_positive;
use crate::request::{Promises, Spec, Stationary, exact_one_or_each};

/// The name of such an observer.
pub(super) const STATIONARY: &str = "stationary";

/// The key of what the disturbance does.
const WALK: &str = "disturbance_walk";

/// The plant of an observer: a chain from its last measured state on, or a linear plant.
#[derive(Clone, Copy)]
pub(super) struct Observed<'a> {
    pub(super) linear: Option<&'a Linear>,
    /// Constant input gain of a chain.
    pub(super) gain: &'a BigRational,
    /// Values that are measured.
    pub(super) measured: usize,
    pub(super) disturbance: Option<&'a Disturbance>,
}

impl Reader<'_> {
    /// The stationary observer of a plant; `None` for a mistake, which is noted.
    pub(super) fn stationary(&mut self, spec: &Spec, plant: Observed<'_>) -> Option<Stationary> {
        let Some(disturbance) = plant.disturbance else {
            let message = "a stationary observer without a disturbance".to_owned();
            let help = "it weighs the noise of what is measured against a force that is not known: give disturbance = constant and `disturbance_walk`";
            self.refuse(message, help);
            return None;
        };
        let Some(node) = self.keys.get(WALK).copied() else {
            let message = "`disturbance_walk` is missing".to_owned();
            let help = "give how far the unknown disturbance drifts in a second, as a standard deviation in the unit of u".to_owned();
            self.found.push("missing-key", WALK, None, message, help);
            return None;
        };
        let Some(walk) = finite_positive(node) else {
            let message = format!("{WALK} = {} is not a finite number > 0", node.value);
            self.wrong(WALK, Some(node.place), message, "a size in the unit of u".to_owned());
            return None;
        };
        let Some(h) = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number) else {
            let message = "a stationary observer without `sample_time`".to_owned();
            self.refuse(message, "its gains are computed when the code is generated: give it");
            return None;
        };
        let all = plant.linear.map_or(1, |linear| linear.c.len());
        let first = if plant.linear.is_some() { 0 } else { plant.measured - 1 };
        let noise: Vec<_> = (first..first + all).map(|l| variance(&spec.promises, l)).collect();
        if let Some(exact) = noise.iter().position(|variance| *variance == BigRational::default()) {
            let message =
                format!("a stationary observer, and measurement {} is exact", first + exact + 1);
            self.refuse(message, "give `sensor_step`, `noise` or `noise_rms` of it: the gains weigh it against the disturbance");
            return None;
        }
        let gains = gains(spec.n, plant, disturbance, h, (walk.number()?, noise));
        if gains.is_none() {
            let message = "no stationary observer of this plant".to_owned();
            self.refuse(message, "a mode is not observed well enough: give `observer_poles`");
        }
        Some(Stationary { walk, gains: gains? })
    }

    /// Refuses a walk that no gain depends on.
    pub(super) fn has_no_walk(&mut self) {
        let Some(node) = self.keys.get(WALK).copied() else { return };
        let message = format!("`{WALK}` without a stationary observer");
        let help = "give observer = stationary, or after_observer = stationary behind a round, or leave it out";
        self.wrong(WALK, Some(node.place), message, help.to_owned());
    }

    fn refuse(&mut self, message: String, help: &str) {
        let key =
            ["observer", "after_observer"].into_iter().find(|key| self.keys.contains_key(key));
        let key = key.unwrap_or("observer");
        let place = self.keys.get(key).map(|node| node.place);
        self.wrong(key, place, message, help.to_owned());
    }
}

/// The gains for the standard deviation of the disturbance after a second, and the variance of each measured value.
fn gains(
    n: usize,
    plant: Observed<'_>,
    disturbance: &Disturbance,
    h: &BigRational,
    (walk, noise): (&BigRational, Vec<BigRational>),
) -> Option<Vec<Vec<BigRational>>> {
    let whole = integer(1);
    let pair = match plant.linear {
        Some(linear) => Pair::linear_with(disturbance, linear, h, &whole)?,
        None => {
            let estimated = n + 1 - plant.measured;
            Pair::chain_with(disturbance, estimated, plant.gain, &whole, Some(h))?
        }
    };
    let (phi, order) = (pair.in_units(h), pair.order());
    let rows = match plant.linear {
        Some(linear) => linear.c.clone(),
        None => vec![vec![whole]],
    };
    let c = Matrix::new(rows.len(), order, |l, j| rows[l].get(j).cloned().unwrap_or_default());
    let mut drift = vec![BigRational::default(); order];
    if let Some(last) = drift.last_mut() {
        *last = walk * walk * h;
    }
    let gains = Noisy { phi: phi.clone(), c, walk: drift, noise }.gains()?;
    // A linear plant is corrected in the prediction of its next sample.
    let gains = if plant.linear.is_some() { phi.times(&gains) } else { gains };
    Some(gains.rows().iter().map(|row| row.iter().map(short).collect()).collect())
}

/// The variance of a measured value: that of its noise, and of the steps of its sensor as if an error within them were
/// as likely as any other.
fn variance(promises: &Promises, l: usize) -> BigRational {
    let of = |all: &[Fixed]| exact_one_or_each(all, l).map(|size| size * size).unwrap_or_default();
    of(&promises.noise) / integer(3)
        + of(&promises.noise_rms)
        + of(&promises.sensor_step) / integer(12)
}

/// The nearest double, which is short where the exact fraction is long.
fn short(number: &BigRational) -> BigRational {
    BigRational::from_float(super::double(number)).unwrap_or_default()
}
