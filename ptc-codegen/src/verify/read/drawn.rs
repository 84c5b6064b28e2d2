//! Parameters of the controller that are uncertain: the start time, and those of mapping and law.

use super::{Given, Interval, Reader, to_f64};
use crate::check::examine::{greatest, legal};
use crate::keys::verify::KEYS;
use crate::parameter::Parameter;
use crate::plant::TABLE;

impl Reader<'_> {
    /// The parameters that may be intervals: what `init` and `arm` are given beside tau, eps and the limits of u, which
    /// have a meaning of their own. With a clock in samples all is computed from them beforehand.
    pub(super) fn may_be_drawn(&self) -> Vec<Parameter> {
        let spec = self.spec;
        let others = [Parameter::Tau, Parameter::Eps];
        let mut all = spec.parameters();
        all.retain(|p| spec.sampled().is_none() && !others.contains(p) && !p.is_limit());
        all
    }

    /// Returns the drawn parameters: intervals of [verify], and the bounds that the design has for others.
    pub(super) fn drawn(&mut self, given: &Given<'_>) -> Vec<(Parameter, Interval)> {
        let legal = self.may_be_drawn();
        let mut drawn = Vec::new();
        if let (Some((place, _)), Some(_)) = (given.get("t0"), self.spec.sampled()) {
            let message = "t0 has no meaning for a clock in samples".to_owned();
            let help = "leave it out: the controller is armed at the start of each run";
            self.wrong("verify.t0", Some(*place), message, help);
        }
        for parameter in &legal {
            let name = parameter.spelling();
            if let Some(interval) = self.interval("verify", &name, given)
                && self.is_open(*parameter, interval, given)
                && self.admits(*parameter, interval, given)
            {
                drawn.push((*parameter, interval));
            }
        }
        let bounds = self.spec.bounds.iter().filter(|(symbol, _)| {
            let own = legal.contains(symbol) || self.spec.has_model();
            own && !given.contains_key(symbol.spelling().as_str())
        });
        drawn.extend(
            bounds.filter_map(|(p, (low, high))| Some((*p, (to_f64(low)?, to_f64(high)?)))),
        );
        drawn
    }

    /// Checks that the controller takes a parameter at run time, or holds the one value that [verify] gives: a value
    /// that is compiled in has no interval.
    pub(super) fn is_open(
        &mut self,
        parameter: Parameter,
        ends: Interval,
        given: &Given<'_>,
    ) -> bool {
        let Some(fixed) = self.spec.fixed.get(&parameter) else { return true };
        if to_f64(fixed).is_some_and(|value| ends == (value, value)) {
            return true;
        }
        let name = parameter.spelling();
        let (low, high) = ends;
        let interval = if low == high { format!("{low}") } else { format!("[{low}, {high}]") };
        let message = format!(
            "`{name}` = {fixed} is compiled into the controller, and {interval} under [verify]"
        );
        let open = match parameter {
            Parameter::Gain(_) => "leave `gains` and `poles` out of the design, and give each gain under [verify]: the controller then takes them at run time".to_owned(),
            Parameter::A | Parameter::M | Parameter::Start | Parameter::Rate(_) => {
                format!("leave {name} out of `mu`: the controller then takes it at run time")
            }
            _ => format!("leave `{name}` out of [params]: the controller then takes it at run time"),
        };
        let moves = self.plant.expressions().any(|e| e.parameters().contains(&parameter));
        let help = match (moves, self.spec.has_model()) {
            (false, _) => open,
            (true, true) => {
                format!("{open}; `{name}` = {interval} under [{TABLE}] is of the plant alone")
            }
            (true, false) => format!(
                "{open}; for another value in the plant alone write true_{name} in its f or g, and true_{name} = {interval} under [{TABLE}]"
            ),
        };
        let place = given.get(name.as_str()).map(|(_, node)| node.place);
        self.found.push("conflict", format!("verify.{name}"), place, message, help);
        false
    }

    /// Checks that an interval of [verify] is within the domain of its parameter.
    fn admits(&mut self, parameter: Parameter, ends: Interval, given: &Given<'_>) -> bool {
        let name = parameter.spelling();
        let key = format!("verify.{name}");
        let place = given.get(name.as_str()).map(|(_, node)| node.place);
        if self.plant.fixed.contains_key(&parameter) || self.plant.bounds.contains_key(&parameter) {
            let message = format!("`{name}` has its value under [{TABLE}] too");
            let help = "give the interval in one of the two: under [plant] it is of the plant alone, and of the controller under [verify]";
            self.found.push("conflict", key, place, message, help);
            return false;
        }
        let spec = self.spec;
        let most = greatest(spec).filter(|(own, _)| *own == parameter);
        let most = most.and_then(|(_, most)| to_f64(&most));
        let within = |value: f64| {
            let bounds = spec.bounds.get(&parameter);
            let bounds = bounds.and_then(|(low, high)| Some((to_f64(low)?, to_f64(high)?)));
            let own = bounds.map_or(spec.keeps_digits(parameter, value), |(low, high)| {
                (low..=high).contains(&value)
            });
            own && most.is_none_or(|most| value <= most)
        };
        if within(ends.0) && within(ends.1) {
            return true;
        }
        let message = format!("{name} ({}) leaves its domain", parameter.meaning());
        self.wrong(&key, place, message, &format!("{name} is {}", legal(spec, parameter)));
        false
    }

    /// The names of states and parameters that are keys of [verify], before those that it always has.
    pub(super) fn quantities(&self) -> Vec<String> {
        let states = self.spec.state_names();
        let fixed = |name: &String| KEYS.iter().any(|info| info.key == name);
        let own = self.may_be_drawn().into_iter().map(Parameter::spelling);
        states.into_iter().chain(own.filter(|name| !fixed(name))).collect()
    }
}
