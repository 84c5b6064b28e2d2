//! The soonest deadline that any controller can meet: the time of the bang-bang input.

use super::nominal::Nominal;
use super::profile;
use crate::program::range::Range;

/// The soonest time to rest, or why it is not known.
pub type Soonest = Result<f64, &'static str>;

/// Returns the shortest time in s from the state `x` to rest, with the inputs within `limits` from the delay on.
///
/// # Errors
/// Why it is not known.
pub fn soonest(nominal: &Nominal, limits: Range, x: &[f64]) -> Soonest {
    if !nominal.is_chain {
        return Err("only computed for a chain of order 2 or 3");
    }
    if !(limits.least.is_finite() && limits.most.is_finite()) {
        return Err("u has no limits: give `u_max`");
    }
    if !(limits.least < 0.0 && limits.most > 0.0) {
        return Err("u = 0 is not inside the limits");
    }
    if x.iter().all(|own| *own == 0.0) {
        return Ok(0.0);
    }
    let gain = nominal.rates.1[nominal.order() - 1];
    let late = nominal.delay as f64 * nominal.h;
    let rates = [gain * limits.least, gain * limits.most];
    let (least, most) = (rates[0].min(rates[1]), rates[0].max(rates[1]));
    let found = match *x {
        [x, v] => second([x + late * v, v], least, most),
        [x, v, a] if least == -most => {
            let moved = [x + late * v + 0.5 * late * late * a, v + late * a, a];
            profile::duration(&moved, most)
        }
        _ => return Err("only computed for order 3 with limits -u_max and u_max"),
    };
    found.map(|time| time + late).ok_or("no bang-bang input was found")
}

/// Time of the bang-bang acceleration from (x, v) to rest: first one limit, then the other.
fn second([x, v]: [f64; 2], least: f64, most: f64) -> Option<f64> {
    let with = |first: f64, last: f64| {
        // Speed at the change: from x + (w^2 - v^2)/(2 first) - w^2/(2 last) = 0.
        let square = last * (v * v - 2.0 * first * x) / (last - first);
        let speed = -last.signum() * square.max(0.0).sqrt();
        let times = [(speed - v) / first, -speed / last];
        // Rounding moves a start off the curve of the second limit.
        let negligible = -1e-12 * (times[0].abs() + times[1].abs());
        (square >= -1e-12 * v * v && times[0] >= negligible).then(|| times[0].max(0.0) + times[1])
    };
    [with(least, most), with(most, least)].into_iter().flatten().min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::{profile, second};

    /// From rest the time is 2 sqrt(x/a); braking alone takes v/a; with unequal limits the parts are those of the areas.
    #[test]
    fn times_of_known_motions() {
        let near = |found: Option<f64>, time: f64| {
            assert!((found.expect("a time") - time).abs() < 1e-12, "{found:?} {time}");
        };
        near(second([0.5, 0.0], -2.0, 2.0), 1.0);
        near(second([-0.5, 0.0], -2.0, 2.0), 1.0);
        near(second([-1.0, 2.0], -2.0, 2.0), 1.0);
        near(second([1.0, -2.0], -2.0, 2.0), 1.0);
        // Accelerated with 1 for 2/sqrt(3) s to 2/sqrt(3) m/s, and braked with 2 in half of it: 1 m.
        near(second([-1.0, 0.0], -2.0, 1.0), 1.5 * 2.0 / 3f64.sqrt());
        // At (0, v): stop in v/a, and come back.
        near(second([0.0, 1.0], -1.0, 1.0), 1.0 + 2f64.sqrt());
    }

    /// The profile of a follower has this length.
    #[test]
    fn profile_is_as_long_as_bang_bang() {
        for (i, j) in (-4..=4).flat_map(|i| (-4..=4).map(move |j| (i, j))) {
            let x = [0.25 * f64::from(i), 0.5 * f64::from(j)];
            let (known, planned) = (second(x, -2.0, 2.0), profile::duration(&x, 2.0));
            let (known, planned) = (known.expect("a time"), planned.expect("a profile"));
            assert!((known - planned).abs() < 1e-9, "{x:?}: {known} {planned}");
        }
    }
}
