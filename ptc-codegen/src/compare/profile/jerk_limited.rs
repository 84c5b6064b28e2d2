//! Profiles of constant jerk in segments, by Ruckig.

use rsruckig::prelude::{
    DataArrayOrVec, InputParameter, Ruckig, RuckigErrorHandler, ThrowErrorHandler, Trajectory,
};

/// Halvings of the factor with which the limits are met in time.
const HALVINGS: usize = 60;

/// Largest power of 2 of this factor, up and down.
const FACTORS: f64 = 10.0;

/// Part of the time in which jerk builds the acceleration up.
const RAMP: f64 = 1.0 / 15.0;

/// A profile.
#[derive(Clone, Debug)]
pub(crate) struct JerkLimited {
    /// `None` where it stays at 0.
    trajectory: Option<Trajectory<1>>,
    order: usize,
}

/// Limits of speed, acceleration and jerk; infinite for none.
#[derive(Clone, Copy, Debug)]
struct Limits([f64; 3]);

impl JerkLimited {
    /// Returns the profile from (x, v) or (x, v, a) to rest in `length` seconds; `None` where there is none.
    ///
    /// The limits are those with which a motion from rest accelerates, coasts and brakes for a third of the time each,
    /// times a factor with which this one takes just this time.
    pub(super) fn new(x: &[f64], length: f64) -> Option<Self> {
        let order = x.len();
        let distance: f64 = x
            .iter()
            .zip([1.0, length / 2.0, length * length / 12.0])
            .map(|(own, time)| own.abs() * time)
            .sum();
        if distance == 0.0 {
            return Some(Self { trajectory: None, order });
        }
        let speed = 1.5 * distance / length;
        let acceleration = speed / ((1.0 / 3.0 - RAMP) * length);
        let jerk = acceleration / (RAMP * length);
        let with = |factor: f64| {
            let limits = Limits([speed, acceleration, jerk].map(|own| factor * own));
            planned(x, limits).filter(|own| own.get_duration() <= length)
        };
        let (mut slow, mut fast) = (-FACTORS, FACTORS);
        let mut found = with(fast.exp2())?;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (slow + fast);
            match with(middle.exp2()) {
                Some(own) => (fast, found) = (middle, own),
                None => slow = middle,
            }
        }
        Some(Self { trajectory: Some(found), order })
    }

    /// Returns the shortest profile from (x, v) or (x, v, a) to rest with a limit of the next derivative alone; `None`
    /// where there is none.
    pub(super) fn soonest(x: &[f64], limit: f64) -> Option<Self> {
        if x.iter().all(|own| *own == 0.0) {
            return Some(Self { trajectory: None, order: x.len() });
        }
        let mut limits = [f64::INFINITY; 3];
        *limits.get_mut(x.len() - 1)? = limit;
        Some(Self { trajectory: Some(planned(x, Limits(limits))?), order: x.len() })
    }

    /// Its length in s.
    pub(super) fn length(&self) -> f64 {
        self.trajectory.as_ref().map_or(0.0, Trajectory::get_duration)
    }

    /// x, v and a where the order is 3, and the next derivative, at `t` >= 0.
    pub(super) fn at(&self, t: f64) -> ([f64; 3], f64) {
        let Some(own) = self.trajectory.as_ref().filter(|own| t < own.get_duration()) else {
            return ([0.0; 3], 0.0);
        };
        let mut all = [0.0; 4].map(|own| DataArrayOrVec::Stack([own]));
        let [x, v, a, j] = &mut all;
        own.at_time(t, &mut Some(x), &mut Some(v), &mut Some(a), &mut Some(j), &mut None);
        let [x, v, a, j] = all.map(|own| own[0]);
        if self.order == 2 { ([x, v, 0.0], a) } else { ([x, v, a], j) }
    }
}

/// Returns the shortest time from (x, v) or (x, v, a) to rest with a limit of the next derivative alone; `None` where
/// there is none.
pub(crate) fn duration(x: &[f64], limit: f64) -> Option<f64> {
    JerkLimited::soonest(x, limit).map(|own| own.length())
}

fn planned(x: &[f64], Limits(limits): Limits) -> Option<Trajectory<1>> {
    let one = |value: f64| DataArrayOrVec::Stack([value]);
    let mut input = InputParameter::<1>::new(None);
    input.current_position = one(x[0]);
    input.current_velocity = one(x[1]);
    input.current_acceleration = one(x.get(2).copied().unwrap_or(0.0));
    [input.max_velocity, input.max_acceleration, input.max_jerk] = limits.map(one);
    let mut trajectory = Trajectory::new(None);
    calculated::<ThrowErrorHandler>(&input, &mut trajectory)?;
    trajectory.get_duration().is_finite().then_some(trajectory)
}

fn calculated<E: RuckigErrorHandler>(
    input: &InputParameter<1>,
    trajectory: &mut Trajectory<1>,
) -> Option<()> {
    // The period is of no use for a whole trajectory.
    Ruckig::<1, E>::new(None, 1.0).calculate(input, trajectory).ok().map(|_| ())
}
