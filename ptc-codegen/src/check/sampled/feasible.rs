//! What a deadline allows: the largest states that come to rest within the limits, and the soonest deadline for the
//! states at the start.

use num_traits::ToPrimitive;

use crate::diagnostic::{digits_down, digits_up};
use crate::linear::{Horizon, Signal};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Flight, Late, Sampled, Spec};

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

/// Sentences about the deadlines that the limits allow, for exact sensors and no other force; none where the law has no
/// bounds in closed form, or u has no limit.
pub(super) fn feasible(spec: &Spec) -> Vec<String> {
    let Some(loop_of) = Limited::new(spec) else { return Vec::new() };
    let mut all: Vec<_> = loop_of.largest().into_iter().collect();
    all.extend(loop_of.soonest());
    all
}

impl<'a> Limited<'a> {
    fn new(spec: &'a Spec) -> Option<Self> {
        let sampled = spec.sampled()?;
        if spec.axes.is_some() || spec.has_model() || spec.reference.is_some() {
            return None;
        }
        let (horizon, mut units) = (sampled.horizon(spec)?, sampled.unit_coordinates(spec)?);
        units.truncate(spec.n);
        let spare = if sampled.predicts() { sampled.delay.inputs() } else { 0 };
        let own = Self { spec, sampled, horizon, units, spare: u32::try_from(spare).ok()? };
        own.limits(Signal::Input).is_some().then_some(own)
    }

    /// The lower and the upper limit of a signal; `None` without any.
    fn limits(&self, signal: Signal) -> Option<[f64; 2]> {
        let number = |p: Parameter| self.spec.fixed.get(&p)?.number()?.to_f64();
        match signal {
            Signal::Input => {
                let most = number(Parameter::UMax);
                let least = match self.spec.u_min {
                    true => number(Parameter::UMin),
                    false => most.map(|most| -most),
                };
                (least.is_some() || most.is_some())
                    .then(|| [least.unwrap_or(f64::NEG_INFINITY), most.unwrap_or(f64::INFINITY)])
            }
            Signal::State(i) => {
                let most = self.flight()?.state_max(i)?.to_f64()?;
                Some([-most, most])
            }
        }
    }

    fn flight(&self) -> Option<&Flight> {
        self.sampled.flight.as_ref()
    }

    /// What each unit state adds to the values that limits have to admit, with so many samples to go.
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
            let parts = values.iter().filter(|(_, value)| *value != 0.0).map(|(signal, value)| {
                let [least, most] =
                    self.limits(*signal).unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                most.min(-least) / value.abs()
            });
            parts.fold(f64::INFINITY, f64::min)
        };
        let all = self.values(left);
        let shown =
            (1..).zip(&all).map(|(i, values)| format!("|x{i}| <= {}", digits_down(part(values))));
        let shown: Vec<_> = shown.collect();
        let period = self.spec.fixed.get(&Parameter::SampleTime)?.number()?.to_f64()?;
        Some(format!(
            "at tau = {} the limits allow, of each state alone, {}",
            digits_up(f64::from(left + self.spare) * period),
            shown.join(", ")
        ))
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
            let [least, most] =
                self.limits(all[0][row].0).unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            size <= most && -size >= least
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
        let samples = found + self.spare;
        let period = self.spec.fixed.get(&Parameter::SampleTime)?.number()?.to_f64()?;
        let tau = digits_up(f64::from(samples) * period);
        let is_kept = self.samples().is_none_or(|own| {
            own >= samples
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
