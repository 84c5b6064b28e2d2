//! Feasible deadlines: the largest states that come to rest within the limits, and the soonest deadline for the
//! states at the start.

use num_traits::ToPrimitive;

use crate::diagnostic::{digits_down, digits_up};
use crate::linear::{Horizon, Signal};
use crate::parameter::{Fixed, Parameter};
use crate::program::range::Range;
use crate::request::{Flight, Late, Sampled, Spec};
use crate::samples::Ending;

/// Most samples to a deadline that is looked for.
const LONGEST: u32 = 1 << 24;

/// A loop whose u and states have limits.
struct Limited<'a> {
    spec: &'a Spec,
    sampled: &'a Sampled,
    horizon: Horizon,
    /// The coordinates of each unit state.
    units: Vec<Vec<f64>>,
    /// Samples by which the law plans to be at rest early.
    spare: u32,
}

/// Returns sentences about the deadlines that the limits allow, with exact sensors and no other force. Empty if the law has
/// no bounds in closed form, or u no limit.
pub(super) fn feasible(spec: &Spec) -> Vec<String> {
    let Some(loop_of) = Limited::new(spec) else { return Vec::new() };
    let mut all: Vec<_> = loop_of.largest().into_iter().collect();
    all.extend(loop_of.soonest());
    all
}

impl<'a> Limited<'a> {
    fn new(spec: &'a Spec) -> Option<Self> {
        let sampled = spec.sampled()?;
        let (horizon, mut units) = (sampled.horizon(spec)?, sampled.unit_coordinates(spec)?);
        units.truncate(spec.n);
        let spare = Ending::of(spec)?.spare;
        let own = Self { spec, sampled, horizon, units, spare };
        let limits = own.limits(Signal::Input);
        limits.finite().next().is_some().then_some(own)
    }

    fn limits(&self, signal: Signal) -> Range {
        match signal {
            Signal::Input => Range::fixed(self.spec, 0),
            Signal::State(i) => {
                let most = self.flight().and_then(|flight| flight.state_max(i)?.to_f64());
                Range::symmetric(most.unwrap_or(f64::INFINITY))
            }
        }
    }

    fn flight(&self) -> Option<&Flight> {
        self.sampled.flight.as_ref()
    }

    /// Returns the values that limits have to admit, of each unit state, with `left` samples to go.
    fn values(&self, left: u32) -> Vec<Vec<(Signal, f64)>> {
        self.units.iter().map(|z| self.horizon.values(z, left)).collect()
    }

    /// The largest part of each unit state alone, of either sign, from which a deadline is kept.
    fn largest(&self) -> Option<String> {
        let left = self.samples()?.checked_sub(self.spare)?;
        if left <= self.horizon.rest() {
            return None;
        }
        let part = |values: &Vec<(Signal, f64)>| {
            let parts = values
                .iter()
                .filter(|(_, value)| *value != 0.0)
                .map(|(signal, value)| self.limits(*signal).radius() / value.abs());
            parts.fold(f64::INFINITY, f64::min)
        };
        let all = self.values(left);
        let shown =
            (1..).zip(&all).map(|(i, values)| format!("|x{i}| <= {}", digits_down(part(values))));
        let shown: Vec<_> = shown.collect();
        Some(format!(
            "at tau = {} the limits allow, of each state alone, {}",
            self.tau(left)?,
            shown.join(", ")
        ))
    }

    /// Returns the deadline of a law with `left` samples to go, in s.
    fn tau(&self, left: u32) -> Option<String> {
        let period = self.spec.fixed.get(&Parameter::SampleTime)?.number()?.to_f64()?;
        Some(digits_up(f64::from(left + self.spare) * period))
    }

    fn samples(&self) -> Option<u32> {
        self.spec.fixed.get(&Parameter::Samples).and_then(Fixed::number)?.to_u32()
    }

    /// Returns true if the limits are kept from every state of a box.
    fn keeps(&self, most: &[f64], left: u32) -> bool {
        let all = self.values(left);
        let count = all.first().map_or(0, Vec::len);
        (0..count).all(|row| {
            let size: f64 =
                all.iter().zip(most).map(|(values, most)| values[row].1.abs() * most).sum();
            size <= self.limits(all[0][row].0).radius()
        })
    }

    /// The soonest deadline from every state of the box of the start.
    fn soonest(&self) -> Option<String> {
        let bounds = &self.spec.promises.x0_max;
        let most: Vec<f64> = bounds.iter().filter_map(|own| own.number()?.to_f64()).collect();
        if most.len() != self.spec.n || most.iter().all(|own| *own == 0.0) {
            return None;
        }
        let found = self.search(&most)?;
        let tau = self.tau(found)?;
        let is_kept = self.samples().is_none_or(|own| {
            own >= found + self.spare
                || own.checked_sub(self.spare).is_some_and(|left| self.keeps(&most, left))
        });
        Some(match (is_kept, self.flight().map(|own| own.late)) {
            (true, _) => {
                format!("the soonest tau found that keeps the limits from all of x0_max is {tau}")
            }
            (false, Some(Late::Extend)) => format!(
                "tau is too soon for the limits from a part of x0_max: the deadline is put off then; {tau} keeps them from all of it"
            ),
            (false, _) => format!(
                "tau is too soon for the limits from a part of x0_max: the soonest one found is {tau}"
            ),
        })
    }

    /// Returns the fewest samples to go found by doubling and halving, as the controller searches them.
    fn search(&self, most: &[f64]) -> Option<u32> {
        let mut low = self.horizon.rest();
        let mut top = low.max(1);
        while top <= low || !self.keeps(most, top) {
            low = low.max(top);
            top = top.checked_mul(2).filter(|top| *top <= LONGEST)?;
        }
        while top - low > 1 {
            let middle = low + (top - low) / 2;
            match self.keeps(most, middle) {
                true => top = middle,
                false => low = middle,
            }
        }
        Some(top)
    }
}
