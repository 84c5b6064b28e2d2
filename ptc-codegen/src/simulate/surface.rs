//! The surface on which a kink lies: its slopes, by differences, and the kinks that share it.

use super::method::State;
use super::switching::Piecewise;

/// A surface at a point of it.
pub(super) struct Surface {
    /// True for each kink that lies on it.
    pub(super) members: Vec<bool>,
    /// True for each kink that faces the way of the first.
    pub(super) along: Vec<bool>,
    /// Slope of the distance by each state.
    slopes: State,
    /// Slope of the distance by the variable of the integration.
    slope: f64,
    distance: f64,
}

/// Cosine of the angle within which two surfaces count as one.
const SAME: f64 = 1e-7;

/// Distance, in the scale of the state, within which they are at the same place. Close to the deadline
/// u passes from one limit to the other within 1e-6 of that scale.
const NEAR: f64 = 1e-11;

impl Surface {
    /// The surface of a kink.
    pub(super) fn of(system: &mut dyn Piecewise, kink: usize, s: f64, state: &State) -> Self {
        let order = system.order();
        let mut rates = State::zeros();
        system.rates(s, state, &mut rates);
        let scale: Vec<_> = (0..order).map(|i| scale(state[i], rates[i])).collect();
        let mut here = Vec::new();
        system.distances(s, state, &mut here);
        let kinks = here.len();
        // A column for each state, and one for the variable, each in its scale.
        let mut columns: Vec<Vec<f64>> = Vec::with_capacity(order + 1);
        for i in 0..=order {
            let mut side = |sign: f64| {
                let (mut at, mut moved) = (s, *state);
                match scale.get(i) {
                    Some(scale) => moved[i] += sign * STEP * scale,
                    None => at += sign * STEP,
                }
                let mut values = Vec::with_capacity(kinks);
                system.distances(at, &moved, &mut values);
                values
            };
            let (up, down) = (side(1.0), side(-1.0));
            columns
                .push(up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * STEP)).collect());
        }
        let of = |kink: usize| columns.iter().map(move |column| column[kink]);
        let size = |kink: usize| of(kink).map(|slope| slope * slope).sum::<f64>().sqrt();
        let cosine = |other: usize| {
            let product: f64 = of(kink).zip(of(other)).map(|(a, b)| a * b).sum();
            product / (size(kink) * size(other))
        };
        let cosines: Vec<_> =
            (0..kinks).map(|other| if other == kink { 1.0 } else { cosine(other) }).collect();
        let near = |other: usize| here[other].abs() <= NEAR * size(other);
        let members = (0..kinks)
            .map(|other| other == kink || (1.0 - cosines[other].abs() <= SAME && near(other)))
            .collect();
        let mut slopes = State::zeros();
        for (i, slope) in of(kink).take(order).enumerate() {
            slopes[i] = slope / scale[i];
        }
        Self {
            members,
            along: cosines.iter().map(|cosine| *cosine >= 0.0).collect(),
            slopes,
            slope: columns[order][kink],
            distance: here[kink],
        }
    }

    /// Rate of the distance.
    pub(super) fn speed(&self, rates: &State) -> f64 {
        self.slope + self.slopes.dot(rates)
    }

    /// Returns the possible rounding of a rate of the distance.
    pub(super) fn noise(&self, rates: &State) -> f64 {
        1e-9 * (self.slope.abs() + self.slopes.abs().dot(&rates.abs()))
    }

    /// Moves a state onto it, along a component.
    pub(super) fn project(&self, state: &mut State, along: usize) {
        let off = self.distance / self.slopes[along];
        if off.is_finite() {
            state[along] -= off;
        }
    }

    /// The component by which two sides are most apart in the rate of the distance.
    pub(super) fn pivot(&self, [here, there]: [&State; 2], order: usize) -> usize {
        let apart = |i: usize| (self.slopes[i] * (here[i] - there[i])).abs();
        (0..order).max_by(|a, b| apart(*a).total_cmp(&apart(*b))).unwrap_or(0)
    }
}

/// Step of a difference, in the scale of a state.
const STEP: f64 = 1e-5;

/// Scale of a component at a point.
fn scale(value: f64, rate: f64) -> f64 {
    let scale = value.abs() + rate.abs();
    if scale > 0.0 { scale } else { 1e-3 }
}

/// Rate of the distance from a kink without the rate of a component, its slope by this component, and the
/// distance, between the rates of two sides.
pub(super) fn tangent(
    system: &mut dyn Piecewise,
    (kink, last): (usize, usize),
    (s, state): (f64, &State),
    (rates, beyond): (&State, &State),
) -> (f64, f64, f64) {
    let mut values = Vec::new();
    let mut distance = |system: &mut dyn Piecewise, s: f64, state: &State| {
        values.clear();
        system.distances(s, state, &mut values);
        values[kink]
    };
    let mut ahead = *rates;
    ahead[last] = 0.0;
    let along = distance(system, s + STEP, &(state + ahead * STEP))
        - distance(system, s - STEP, &(state - ahead * STEP));
    let step = STEP * scale(state[last], rates[last].abs() + beyond[last].abs());
    let (mut up, mut down) = (*state, *state);
    up[last] += step;
    down[last] -= step;
    let across = (distance(system, s, &up) - distance(system, s, &down)) / (up[last] - down[last]);
    (along / (2.0 * STEP), across, distance(system, s, state))
}
