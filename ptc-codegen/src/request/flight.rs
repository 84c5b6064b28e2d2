//! Changes while a controller runs: its duration with a clock in time, and in samples its deadline, with its answer to one
//! that limits do not allow.

use num_traits::{ToPrimitive, Zero};

use super::{Sampled, Spec};
use crate::algebra::BigRational;
use crate::limits::GAINS;
use crate::linear::{Horizon, Plan, Signal, TabledPlan, node_from, power_of_period};
use crate::parameter::{Fixed, Parameter};

/// A controller whose deadline may change while it runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flight {
    /// Its answer to a deadline that is too soon.
    pub late: Late,
    /// True if each sample plans the soonest deadline; otherwise the deadline is never moved forward.
    pub soonest: bool,
    /// Bounds of abs(x_i), infinite where a state has none; empty without.
    pub state_max: Vec<Fixed>,
    /// Part of each limit that plans leave free.
    pub reserve: BigRational,
}

/// The answer to a deadline that is too soon for the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Late {
    /// u is clipped.
    Clip,
    /// The deadline is put off to the soonest one.
    Extend,
    /// `arm_for` refuses it.
    Refuse,
}

impl Late {
    /// Returns its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Clip => "clip",
            Self::Extend => "extend",
            Self::Refuse => "refuse",
        }
    }
}

/// Times tau to which the table of gains of a linear plant reaches, so that a deadline can be put off.
const REACH: u32 = 4;

impl Flight {
    /// Returns true if deadlines are planned of a linear plant, which takes a table of bounds.
    pub(crate) fn plans(&self) -> bool {
        self.late != Late::Clip || !self.state_max.is_empty() || !self.reserve.is_zero()
    }

    /// The samples to go for which a table has gains, of a design with so many.
    pub(crate) fn reach(&self, samples: u32) -> u32 {
        let most = u32::try_from(GAINS.most).unwrap_or(u32::MAX);
        match self.plans() {
            true => node_from(samples.saturating_mul(REACH).min(most)),
            false => samples,
        }
    }

    /// Returns true if a step may put its deadline off.
    pub fn replans(&self) -> bool {
        self.late == Late::Extend
    }

    /// The bound of state `i`, from 0, where it has one.
    pub(crate) fn state_max(&self, i: usize) -> Option<&BigRational> {
        self.state_max.get(i).and_then(Fixed::number)
    }
}

impl Spec {
    /// Returns true if `arm_for` gives a controller with a clock in time another duration: where tau has one value, as in
    /// the checks of a run, nothing depends on it.
    pub fn changes_duration(&self) -> bool {
        self.in_flight && !self.fixed.contains_key(&Parameter::Tau)
    }

    /// Returns true if the controller may change its deadline by itself: it puts it off, or plans the soonest one.
    pub fn changes_deadline(&self) -> bool {
        let flight = self.sampled().and_then(|sampled| sampled.flight.as_ref());
        flight.is_some_and(|own| own.replans() || own.soonest)
    }
}

impl Spec {
    /// Returns true if the plant is one chain of integrators, whose x1 counts from a target.
    pub(crate) fn is_one_chain(&self) -> bool {
        let linear = self.sampled().is_some_and(|own| own.linear.is_some());
        !linear && self.axes.is_none() && !self.has_model()
    }
}

impl Sampled {
    /// Returns the bounds of each chain, of which there are several where there are axes; `None` where one has none.
    pub(crate) fn horizons(&self, spec: &Spec) -> Option<Vec<Horizon>> {
        let of_axis = |own: Spec| own.sampled()?.horizon(&own);
        match &spec.axes {
            Some(_) => spec.designs().into_iter().map(of_axis).collect(),
            None => Some(vec![self.horizon(spec)?]),
        }
    }

    /// Returns the bounds from which a deadline is known to keep the limits; `None` for plants that are not one chain
    /// and have no table of gains, with a reference, whose future decides u, and for laws whose u has no closed form to
    /// its end.
    pub(crate) fn horizon(&self, spec: &Spec) -> Option<Horizon> {
        if self.linear.is_some() && spec.reference.is_none() {
            return self.horizon_of_table(spec);
        }
        if !spec.is_one_chain() || spec.reference.is_some() {
            return None;
        }
        let state_max = |i| self.flight.as_ref().and_then(|own| own.state_max(i));
        let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
        let exponents = self.exponents.as_ref().filter(|own| own.consecutive)?;
        let h = number(Parameter::SampleTime)?;
        let planned = self.planned(spec.n, Some(h))?;
        let (s, drift) = planned.pair.flat()?;
        let order = u32::try_from(drift.len()).ok()?;
        let least = exponents.least.to_integer().to_u32().filter(|least| *least >= order)?;
        let back = s.inverse()?;
        let limited = (0..spec.n).filter(|i| state_max(*i).is_some());
        let states = limited.map(|i| {
            let unit = power_of_period(h, planned.pair.powers[i]);
            (i, back.rows()[i].iter().map(|own| own * &unit).collect())
        });
        Horizon::new(&Plan {
            drift: &drift,
            least,
            end: self.end.map(|end| (end.samples, order + end.law.weight)),
            held: number(Parameter::Eps)? / h,
            states: states.collect(),
        })
    }

    /// The same of a linear plant with a table of gains, where its deadlines are planned.
    fn horizon_of_table(&self, spec: &Spec) -> Option<Horizon> {
        let flight = self.flight.as_ref().filter(|flight| flight.plans())?;
        let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
        let h = number(Parameter::SampleTime)?;
        let planned = self.planned(spec.n, Some(h))?;
        let limited = |p: Parameter| match spec.fixed.get(&p) {
            Some(limit) => limit.number().is_some(),
            None => p == Parameter::UMax || spec.u_min,
        };
        let input = [Parameter::UMax, Parameter::UMin].into_iter().any(limited);
        let states = (0..spec.n).filter(|i| flight.state_max(*i).is_some()).map(Signal::State);
        Horizon::tabled(&TabledPlan {
            phi: &planned.pair.phi,
            gamma: &planned.pair.gamma,
            schedule: spec.schedule()?,
            held: (number(Parameter::Eps)? / h).ceil().to_u32()?,
            signals: input.then_some(Signal::Input).into_iter().chain(states).collect(),
            precision: spec.precision,
        })
    }

    /// The flat coordinates of each unit state, and of each unit input under way; of a linear plant with a table of gains
    /// the state from which the next input acts.
    pub(crate) fn unit_coordinates(&self, spec: &Spec) -> Option<Vec<Vec<f64>>> {
        let h = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number)?;
        let planned = self.planned(spec.n, Some(h))?;
        let s = match spec.schedule() {
            Some(_) => planned.reach,
            None => planned.pair.flat()?.0.times(&planned.reach),
        };
        let column = |j: usize| {
            let unit = power_of_period(h, -planned.powers[j]);
            s.rows().iter().map(|row| (&row[j] * &unit).to_f64()).collect()
        };
        (0..planned.powers.len()).map(column).collect()
    }
}
