//! Changes while a controller runs: its duration with a clock in time, and in samples its deadline, with its answer to one
//! that limits do not allow.

use num_traits::ToPrimitive;

use super::{Sampled, Spec};
use crate::algebra::BigRational;
use crate::linear::{Horizon, Plan, power_of_period};
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

impl Flight {
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

    /// Returns the bounds from which a deadline is known to keep the limits; `None` for plants that are not one chain,
    /// with a reference, whose future decides u, and for laws whose u has no closed form to its end.
    pub(crate) fn horizon(&self, spec: &Spec) -> Option<Horizon> {
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

    /// The flat coordinates of each unit state, and of each unit input under way.
    pub(crate) fn unit_coordinates(&self, spec: &Spec) -> Option<Vec<Vec<f64>>> {
        let h = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number)?;
        let planned = self.planned(spec.n, Some(h))?;
        let (s, _) = planned.pair.flat()?;
        let s = s.times(&planned.reach);
        let column = |j: usize| {
            let unit = power_of_period(h, -planned.powers[j]);
            s.rows().iter().map(|row| (&row[j] * &unit).to_f64()).collect()
        };
        (0..planned.powers.len()).map(column).collect()
    }
}
