//! The keys of a deadline that may change.

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::BigRational;
use crate::expression::constant::real;
use crate::linear::Disturbance;
use crate::parameter::{Fixed, Parameter};
use crate::request::read::{Reader, shown};
use crate::request::{Clock, Flight, Late, Reference, Sampled, Spec, What};
use crate::syntax::Node;

/// Roundings over a limit at which a plan is worth nothing.
const MOST_SLACK: f64 = 0.01;

impl Reader<'_> {
    /// Reads the changes that are possible while the controller runs, if any are.
    pub(super) fn flight(
        &mut self,
        spec: &mut Spec,
        disturbance: Option<&Disturbance>,
    ) -> Option<Flight> {
        let given = |key: &&str| self.keys.contains_key(*key);
        let key = ["late", "pace", "in_flight"].into_iter().find(given);
        let alone = ["state_max", "reserve"].into_iter().find(given);
        let in_flight = self.choice("in_flight", &[("true", true), ("false", false)]);
        let laws = [Late::Clip, Late::Extend, Late::Refuse].map(|late| (late.name(), late));
        let late = self.choice("late", &laws);
        let pace = self.choice("pace", &[("deadline", false), ("soonest", true)]);
        let soonest = pace == Some(true);
        if soonest && late.is_some_and(|late| late != Late::Extend) {
            let place = self.keys.get("pace").map(|node| node.place);
            let message = "`pace` = soonest beside another `late` than extend".to_owned();
            let help = "a deadline that each sample plans anew is put off too: leave `late` out";
            self.wrong("pace", place, message, help.to_owned());
        }
        let late = late.unwrap_or(if soonest { Late::Extend } else { Late::Clip });
        if in_flight != Some(true) && late == Late::Clip {
            if let Some(key) = alone {
                let place = self.keys.get(key).map(|node| node.place);
                let message = format!("`{key}` without a deadline that is planned");
                let help = "give `late` = extend or refuse beside it, or `in_flight` = true, which gives the function `soonest`";
                self.wrong(key, place, message, help.to_owned());
            }
            return None;
        }
        let key = key.unwrap_or("in_flight");
        if spec.what == What::Observer {
            return None;
        }
        let planned = if late == Late::Clip { alone } else { Some(key) };
        if let Some(key) = planned.filter(|_| spec.model.is_some() || spec.coupled.is_some()) {
            let place = self.keys.get(key).map(|node| node.place);
            let message = format!("`{key}` beside a model, or a plant with several inputs");
            let help = "deadlines are planned for chains, one or `axes` of them; `in_flight` = true lets this one change, without a plan";
            self.wrong(key, place, message, help.to_owned());
            return None;
        }
        if let Some(own) = disturbance.filter(|own| own.moves()) {
            let place = self.keys.get(key).map(|node| node.place);
            let message = format!("`{key}` beside disturbance = {own}");
            let help = "a deadline in flight is planned for what is added to u now: give disturbance = constant";
            self.wrong(key, place, message, help.to_owned());
            return None;
        }
        if let Some(Reference::Known(_)) = spec.reference {
            let place = self.keys.get(key).map(|node| node.place);
            let message = format!("`{key}` beside a reference in t, which counts from the start");
            let help = "give each call the reference: reference = input".to_owned();
            self.wrong(key, place, message, help);
        }
        let state_max = self.state_max(spec);
        let reserve = self.reserve();
        Some(Flight { late, soonest, state_max, reserve })
    }

    /// Refuses a plan of deadlines where the law has none.
    pub(super) fn plans(&mut self, spec: &Spec, sampled: &Sampled) {
        let Some(flight) = &sampled.flight else { return };
        let keys = ["late", "pace", "state_max", "reserve"];
        let key = keys.into_iter().find(|key| self.keys.contains_key(key));
        let key = key.filter(|key| *key != "late" || flight.late != Late::Clip);
        let (Some(key), true) = (key, self.found.is_empty()) else { return };
        let read = Spec { clock: Clock::Samples(Box::new(sampled.clone())), ..spec.clone() };
        if let Some((message, help)) = unplanned(&read, sampled) {
            let place = self.keys.get(key).map(|node| node.place);
            self.wrong(key, place, format!("`{key}` {message}"), help.to_owned());
        }
    }

    /// Bounds of the states, those of the first axis where each has its own; on failure, records a diagnostic.
    fn state_max(&mut self, spec: &mut Spec) -> Vec<Fixed> {
        let Some(node) = self.keys.get("state_max").copied() else { return Vec::new() };
        let n = spec.n;
        let Some(axes) = spec.axes.as_mut().filter(|_| !self.each("state_max").is_empty()) else {
            return self.bounds_of_states(n, self.first("state_max", node));
        };
        let rows = self.for_axes("state_max", axes.count).iter();
        axes.state_max = rows.map(|row| self.bounds_of_states(n, row)).collect();
        axes.state_max.first().cloned().unwrap_or_default()
    }

    fn bounds_of_states(&mut self, n: usize, node: &Node) -> Vec<Fixed> {
        let legal = |node: &Node| {
            let value = real(node)?;
            let positive = value.number().is_none_or(BigRational::is_positive);
            (positive && value != Fixed::MinusInfinite).then_some(value)
        };
        let all = self.one_or_each_of(("state_max", node), Some(n), legal, "> 0, or inf");
        match all.as_slice() {
            [one] if n > 1 => vec![one.clone(); n],
            _ => all,
        }
    }

    /// The part of each limit that plans leave free; on failure, records a diagnostic.
    fn reserve(&mut self) -> BigRational {
        let Some(node) = self.keys.get("reserve").copied() else { return BigRational::zero() };
        let value = real(node).as_ref().and_then(Fixed::number).cloned();
        let legal = value.filter(|part| !part.is_negative() && *part < BigRational::one());
        if legal.is_none() {
            let message = format!("reserve = {} is not a part of the limits", shown(&node.value));
            let help = "give a number from 0 up to, and not including, 1".to_owned();
            self.wrong("reserve", Some(node.place), message, help);
        }
        legal.unwrap_or_default()
    }
}

/// Returns the reason why no deadline is planned, and the likely fix.
fn unplanned(spec: &Spec, sampled: &Sampled) -> Option<(&'static str, &'static str)> {
    let is_open = |p: Parameter| !spec.fixed.contains_key(&p);
    if sampled.linear.is_some() && spec.schedule().is_none() {
        return Some((
            "beside A and B and a law of poles",
            "give `poles` = \"least-energy\", whose deadlines are planned; `in_flight` = true lets any deadline change, without a plan",
        ));
    }
    if spec.reference.is_some() {
        return Some((
            "beside a reference: the u that it will need is not known",
            "`in_flight` = true lets the deadline change, without a plan",
        ));
    }
    if is_open(Parameter::SampleTime) || is_open(Parameter::Eps) {
        return Some((
            "with a sample_time or an eps that is left to run time",
            "give `sample_time` and `eps` numbers: the bounds of u are made when the code is generated",
        ));
    }
    if spec.designs().iter().all(is_unlimited) {
        return Some(("without a limit", "give `u_max`, or `state_max` of a state"));
    }
    let Some(horizons) = sampled.horizons(spec) else {
        if sampled.linear.is_some() {
            return Some((
                "beside gains that are held at eps, which are not stable",
                "give a shorter eps",
            ));
        }
        return Some((
            "beside a law whose u has no closed form to its end",
            "take poles = \"least-energy\", or poles that are consecutive multiples of -a from the order of the loop on, and a shorter eps",
        ));
    };
    let slack = horizons.iter().map(|horizon| horizon.slack).fold(0.0, f64::max);
    let rounding = slack * spec.precision.epsilon();
    if !rounding.to_f64().is_some_and(|rounding| rounding < MOST_SLACK) {
        return Some((
            "at this order and precision: rounding takes more than 1 % of the limits",
            "take precision = f64, or a lower order or weight",
        ));
    }
    None
}

/// Returns true if neither u nor a state of a chain has a limit.
fn is_unlimited(spec: &Spec) -> bool {
    let flight = spec.sampled().and_then(|own| own.flight.as_ref());
    spec.fixed.get(&Parameter::UMax) == Some(&Fixed::Infinite)
        && spec.fixed.get(&Parameter::UMin).is_none_or(|least| *least == Fixed::MinusInfinite)
        && (0..spec.n).all(|i| flight.is_none_or(|own| own.state_max(i).is_none()))
}
