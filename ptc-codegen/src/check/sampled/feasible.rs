//! Feasible deadlines: the largest states that come to rest within the limits, and the soonest deadline for the
//! states at the start, of one chain or of all axes together.

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
pub(crate) fn feasible(spec: &Spec) -> Vec<String> {
    let designs = spec.designs();
    let Some(chains) = designs.iter().map(Limited::new).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    if let [one] = chains.as_slice() {
        return one.largest().into_iter().chain(soonest(&chains, "the limits")).collect();
    }
    let of_axis =
        |(axis, own): (usize, &Limited<'_>)| Some(format!("axis {axis}: {}", own.largest()?));
    let mut all: Vec<_> = (1..).zip(&chains).filter_map(of_axis).collect();
    if let Some(together) = soonest(&chains, "the limits of all axes") {
        let alone = |own: &Limited<'_>| own.tau(earliest(std::slice::from_ref(own))?);
        let alone: Vec<_> = chains.iter().filter_map(alone).collect();
        all.push(format!("{together}; of each axis alone {}", alone.join(", ")));
    }
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
}

/// Bounds of the states at the start, if some of them is not 0.
fn start(spec: &Spec) -> Option<Vec<f64>> {
    let bounds = &spec.promises.x0_max;
    let most: Vec<f64> = bounds.iter().filter_map(|own| own.number()?.to_f64()).collect();
    (most.len() == spec.n && most.iter().any(|own| *own != 0.0)).then_some(most)
}

/// The fewest samples to go in which all chains keep their limits from every state of the box of the start.
fn earliest(chains: &[Limited<'_>]) -> Option<u32> {
    let most = start(chains.first()?.spec)?;
    let rest = chains.iter().map(|chain| chain.horizon.rest()).max()?;
    search(rest, &|left| chains.iter().all(|chain| chain.keeps(&most, left)))
}

/// The soonest deadline from every state of the box of the start, of chains that come to rest together.
fn soonest(chains: &[Limited<'_>], limits: &str) -> Option<String> {
    let (first, found) = (chains.first()?, earliest(chains)?);
    let (most, tau) = (start(first.spec)?, first.tau(found)?);
    let given = first.samples().map(|own| own.saturating_sub(first.spare));
    let kept = given.is_none_or(|left| chains.iter().all(|chain| chain.keeps(&most, left)));
    Some(match (kept, first.flight().map(|own| own.late)) {
        (true, _) => {
            format!("the soonest tau found that keeps {limits} from all of x0_max is {tau}")
        }
        (false, _) if given.is_some_and(|left| left > found) => format!(
            "tau does not keep {limits} from all of x0_max, and the soonest one found that does is {tau}"
        ),
        (false, Some(Late::Extend)) => format!(
            "tau is too soon for {limits} from a part of x0_max: the deadline is put off then; {tau} keeps them from all of it"
        ),
        (false, _) => format!(
            "tau is too soon for {limits} from a part of x0_max: the soonest one found is {tau}"
        ),
    })
}

/// Returns the fewest samples to go found by doubling and halving, as the controller searches them.
fn search(rest: u32, keep: &dyn Fn(u32) -> bool) -> Option<u32> {
    let mut low = rest;
    let mut top = low.max(1);
    while top <= low || !keep(top) {
        low = low.max(top);
        top = top.checked_mul(2).filter(|top| *top <= LONGEST)?;
    }
    while top - low > 1 {
        let middle = low + (top - low) / 2;
        match keep(middle) {
            true => top = middle,
            false => low = middle,
        }
    }
    Some(top)
}
