//! Feasible deadlines: the largest states that come to rest within the limits, and the soonest deadline for the
//! states at the start.

#[cfg(feature = "lab")]
mod set;

use num_traits::ToPrimitive;

use crate::diagnostic::{digits_down, digits_up};
use crate::linear::{Horizon, Peak, Signal};
use crate::parameter::{Fixed, Parameter};
use crate::program::range::Range;
use crate::request::{Flight, Late, Sampled, Spec, What};
use crate::samples::Ending;

#[cfg(feature = "lab")]
pub use set::{FeasibleSet, Outline};

/// A loop whose u and states have limits.
struct Limited<'a> {
    spec: &'a Spec,
    sampled: &'a Sampled,
    horizon: Horizon,
    /// The coordinates of each unit state.
    units: Vec<Vec<f64>>,
    /// Samples by which the law plans to be at rest early.
    spare: u32,
    /// Most samples to go that are looked at.
    longest: u32,
    /// Limits of what the law gives, to which the known force is not added.
    input: Range,
}

/// Why nothing is known of the deadlines that the limits of a loop allow, and what to give.
#[cfg_attr(not(feature = "lab"), allow(dead_code, unreachable_pub))]
pub struct Unlimited {
    /// The reason.
    pub why: &'static str,
    /// Suggested remedy.
    pub help: &'static str,
}

/// Returns sentences about the deadlines that the limits allow, with exact sensors and no other force. Empty if the law has
/// no bounds in closed form, or u no limit.
pub(crate) fn feasible(spec: &Spec) -> Vec<String> {
    let designs = spec.designs();
    let Ok(chains) = designs.iter().map(Limited::new).collect::<Result<Vec<_>, _>>() else {
        return Vec::new();
    };
    if let [one] = chains.as_slice() {
        return one.largest().into_iter().chain(soonest(&chains, "the limits")).collect();
    }
    let of_axis =
        |(axis, own): (usize, &Limited<'_>)| Some(format!("axis {axis}: {}", own.largest()?));
    let mut all: Vec<_> = (1..).zip(&chains).filter_map(of_axis).collect();
    if let Some(together) = soonest(&chains, "the limits of all axes") {
        let alone =
            |own: &Limited<'_>| Some(digits_up(own.tau(earliest(std::slice::from_ref(own))?)?));
        let alone: Vec<_> = chains.iter().filter_map(alone).collect();
        all.push(format!("{together}; of each axis alone {}", alone.join(", ")));
    }
    all
}

/// Returns the soonest tau found that keeps the limits of all chains from every state of `x0_max`, in s.
pub fn soonest_tau(spec: &Spec) -> Option<f64> {
    let designs = spec.designs();
    let chains = designs.iter().map(Limited::new).collect::<Result<Vec<_>, _>>().ok()?;
    chains.first()?.tau(earliest(&chains)?)
}

impl<'a> Limited<'a> {
    fn new(spec: &'a Spec) -> Result<Self, Unlimited> {
        let closed_form = Unlimited {
            why: "the law has no bounds in closed form",
            help: "give one chain, without a reference, poles of consecutive integers such as least-energy, and numbers for sample_time and eps",
        };
        if spec.what == What::Filter {
            return Err(Unlimited {
                why: "a filter has no law, so that no deadline is planned",
                help: "leave --plot out: the check `loop` prints whether the bounds can be kept",
            });
        }
        let Some(sampled) = spec.sampled() else {
            return Err(Unlimited {
                why: "which deadlines the limits allow is known of a clock in samples",
                help: "give clock = \"samples\"",
            });
        };
        let (horizon, units, ending) =
            (sampled.horizon(spec), sampled.unit_coordinates(spec), Ending::of(spec));
        let (Some(horizon), Some(mut units), Some(ending)) = (horizon, units, ending) else {
            return Err(closed_form);
        };
        units.truncate(spec.n);
        let Some(force) = force(spec, sampled) else {
            return Err(Unlimited {
                why: "the known force f is left to run time",
                help: "give it a number under [params]",
            });
        };
        let limits = Range::fixed(spec, 0);
        if limits.finite().next().is_none() {
            return Err(Unlimited { why: "u has no limit", help: "give u_max, a number" });
        }
        let input = Range { least: limits.least + force, most: limits.most + force };
        if input.radius() <= 0.0 {
            return Err(Unlimited {
                why: "u at rest, which holds against the known force f, has no room on both sides",
                help: "give limits of u on both sides of -f/g",
            });
        }
        let longest = horizon.longest(spec.precision);
        Ok(Self { spec, sampled, horizon, units, spare: ending.spare, longest, input })
    }

    fn limits(&self, signal: Signal) -> Range {
        match signal {
            Signal::Input => self.input,
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
    fn values(&self, left: u32) -> Vec<Vec<Peak>> {
        self.units.iter().map(|z| self.horizon.values(z, left)).collect()
    }

    /// The largest part of each unit state alone, of either sign, from which a deadline is kept.
    fn largest(&self) -> Option<String> {
        let left = self.samples()?.checked_sub(self.spare)?;
        if left <= self.horizon.rest() {
            return None;
        }
        let all = self.alone(left);
        let shown = (1..).zip(&all).map(|(i, most)| format!("|x{i}| <= {}", digits_down(*most)));
        let shown: Vec<_> = shown.collect();
        Some(format!(
            "at tau = {} the limits allow, of each state alone, {}",
            digits_up(self.tau(left)?),
            shown.join(", ")
        ))
    }

    /// Returns the largest value of each state alone, of either sign, with `left` samples to go.
    fn alone(&self, left: u32) -> Vec<f64> {
        let part = |values: &Vec<Peak>| {
            let parts = values
                .iter()
                .filter(|own| own.value != 0.0)
                .map(|own| self.limits(own.signal).radius() / own.value.abs());
            parts.fold(f64::INFINITY, f64::min)
        };
        self.values(left).iter().map(part).collect()
    }

    /// Returns the deadline of a law with `left` samples to go, in s.
    fn tau(&self, left: u32) -> Option<f64> {
        Some(f64::from(left + self.spare) * self.period()?)
    }

    fn period(&self) -> Option<f64> {
        self.spec.fixed.get(&Parameter::SampleTime)?.number()?.to_f64()
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
                all.iter().zip(most).map(|(values, most)| values[row].value.abs() * most).sum();
            size <= self.limits(all[0][row].signal).radius()
        })
    }

    /// Returns the fewest samples to go with which the limits are kept.
    #[cfg(feature = "lab")]
    fn search(&self, keeps: &mut dyn FnMut(u32) -> bool) -> Option<u32> {
        search(self.horizon.rest(), self.longest, keeps)
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
    let longest = chains.iter().map(|chain| chain.longest).min()?;
    search(rest, longest, &mut |left| chains.iter().all(|chain| chain.keeps(&most, left)))
}

/// The soonest deadline from every state of the box of the start, of chains that come to rest together.
fn soonest(chains: &[Limited<'_>], limits: &str) -> Option<String> {
    let (first, found) = (chains.first()?, earliest(chains)?);
    let (most, tau) = (start(first.spec)?, digits_up(first.tau(found)?));
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

/// Returns the fewest samples to go above `rest` that are found by doubling and halving, as the controller searches them.
fn search(rest: u32, longest: u32, keeps: &mut dyn FnMut(u32) -> bool) -> Option<u32> {
    let mut low = rest;
    let mut top = low + 1;
    while !keeps(top) {
        low = top;
        top = top.checked_mul(2).filter(|top| *top <= longest)?;
    }
    while top - low > 1 {
        let middle = low + (top - low) / 2;
        match keeps(middle) {
            true => top = middle,
            false => low = middle,
        }
    }
    Some(top)
}

/// Returns the known force that the law cancels, in units of u; `None` where it is left to run time.
fn force(spec: &Spec, sampled: &Sampled) -> Option<f64> {
    (spec.known_force()? / &sampled.gain).to_f64()
}
