//! The parameters: values, bounds, and what must hold between them.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, Zero};

use super::entries::meant;
use super::{FixedValues, Reader, shown, suggestion};
use crate::collect::set;
use crate::diagnostic::{near_miss, shorten};
use crate::expression::Expression;
use crate::expression::constant::real;
use crate::keys::KeyInfo;
use crate::parameter::{Domain, Fixed, Parameter};
use crate::request::{After, Feedback, RUNTIME, Spec};
use crate::syntax::{Node, Value};

/// The parameters that every controller has.
const COMMON: [Parameter; 5] =
    [Parameter::Tau, Parameter::StartTime, Parameter::Eps, Parameter::UMax, Parameter::UMin];

/// The parameters that have a name of their own in expressions, `own` being those of the mapping. A user's parameter may
/// be called `u_min`.
pub(crate) fn known(own: Vec<Parameter>) -> Vec<Parameter> {
    COMMON.into_iter().filter(|common| *common != Parameter::UMin).chain(own).collect()
}

impl Reader<'_> {
    /// Values and bounds of all parameters. Where the spec is not `complete`, an unused name may be
    /// used in what could not be read, and is let pass.
    pub(super) fn parameters(&mut self, spec: &mut Spec, complete: bool) {
        for parameter in COMMON {
            if let Some(node) = self.keys.get(parameter.key()).copied() {
                if parameter == Parameter::Eps && self.holds_nothing(node) {
                    continue;
                }
                if parameter == Parameter::UMin {
                    spec.u_min = true;
                    if matches!(&node.value, Value::Word(word) if word == RUNTIME) {
                        continue;
                    }
                }
                let value = self.parameter(parameter.key(), parameter, node);
                spec.fixed.extend(value.map(|v| (parameter, v)));
            }
        }
        self.eps_below_tau(&spec.fixed);
        self.limits_in_order(spec);
        // What a model has beside the law counts for its zero dynamics.
        let of_coupled = spec.coupled.iter().flat_map(|coupled| coupled.dynamics());
        let beside = spec.model.iter().flat_map(|model| &model.dynamics).chain(of_coupled);
        let used = set(spec.expressions().chain(beside).flat_map(Expression::parameters));
        self.names_are_distinct(spec, &used);
        let own = spec.time_mapping.parameters();
        let legal: Vec<_> = used
            .into_iter()
            .chain(own)
            .filter(|p| !COMMON.contains(p))
            .map(|p| (p.spelling(), p))
            .collect();
        for (name, (place, node)) in std::mem::take(&mut self.params) {
            let Some((_, parameter)) = legal.iter().find(|(known, _)| known == name) else {
                let given = |key: &str| self.keys.contains_key(key);
                // What no design does without is looked for elsewhere, whatever else is wrong.
                let sought = match name {
                    "n" => !given("n"),
                    "mu" | "kappa" => !given("mu") && !given("kappa"),
                    _ => complete && KeyInfo::find(name).is_some(),
                };
                if sought {
                    self.unknown(&format!("params.{name}"), place, name);
                } else if complete {
                    let names = legal.iter().map(|(name, _)| name.as_str());
                    let all = names.clone().collect::<Vec<_>>().join(", ");
                    let all = if all.is_empty() {
                        "no expression of the design has a parameter".to_owned()
                    } else {
                        format!("the parameters of the design are {all}")
                    };
                    let near = near_miss(name, names);
                    let help = suggestion(near.or(meant(name).filter(|key| !given(key))), &all);
                    let message = format!("nothing uses the parameter `{}`", shorten(name));
                    self.found.push(
                        "unused-parameter",
                        format!("params.{name}"),
                        Some(place),
                        message,
                        help,
                    );
                }
                continue;
            };
            self.own_value(spec, name, *parameter, node);
        }
        if let Some(name) = &spec.name
            && legal.iter().any(|(own, _)| name.strip_prefix("p_") == Some(own))
        {
            let place = self.keys.get("name").map(|node| node.place);
            let message = format!("`{name}` is what the code calls a parameter of the design");
            self.wrong("name", place, message, "choose another name".to_owned());
        }
        let nonlinear = spec.feedback != Feedback::Linear && !spec.promises.error.is_empty();
        if nonlinear {
            let place = self.keys.get("error").map(|node| node.place);
            let message = "`error` needs a linear law".to_owned();
            let help = "eps is computed from the gains: give gains or poles, or eps itself";
            self.wrong("error", place, message, help.to_owned());
        }
        if !spec.promises.error.is_empty() && !self.keys.contains_key("x0_max") {
            let place = self.keys.get("error").map(|node| node.place);
            let message = "`error` needs `x0_max`".to_owned();
            let help = "the error at the deadline is bounded from the bounds of |x_i| at the start";
            self.wrong("error", place, message, help.to_owned());
        }
    }

    /// Returns true if eps is the 0 of a clock in samples, which ends in deadbeat.
    fn holds_nothing(&self, node: &Node) -> bool {
        let clock = self.keys.get("clock").map(|node| &node.value);
        matches!(clock, Some(Value::Word(word)) if word == "samples")
            && real(node).and_then(|eps| eps.number().map(Zero::is_zero)) == Some(true)
    }

    /// A parameter of an expression must not have the name of another one of the controller.
    pub(super) fn names_are_distinct(&mut self, spec: &Spec, used: &BTreeSet<Parameter>) {
        let all = spec.parameters();
        for parameter in used.iter().filter(|p| matches!(p, Parameter::Named(_))) {
            let name = parameter.key();
            // Gains that are fixed are no field, so that their key is free.
            let free =
                |p: &Parameter| matches!(p, Parameter::Gain(_)) && spec.fixed.contains_key(p);
            let same = |p: &&Parameter| p.key() == name && p != &parameter && !free(p);
            let Some(other) = all.iter().find(same) else { continue };
            let of = |e: Option<&Expression>| e.is_some_and(|e| e.parameters().contains(parameter));
            let of_law = spec.laws().any(|law| of(Some(law)));
            let key = match spec.custom() {
                Some(custom) if of(Some(&custom.given)) => custom.subject.key(),
                _ if of_law => "pi0",
                _ if spec.model.is_some() => "dynamics",
                _ if spec.coupled.is_some() => match self.keys.contains_key("inertia") {
                    true => "inertia",
                    false => "dynamics",
                },
                _ if of(spec.drift.as_ref()) => "f",
                _ if spec.known_references().any(|all| of(all.first())) => "reference",
                _ => "g",
            };
            let place = self.keys.get(key).map(|node| node.place);
            let message =
                format!("`{name}` is the {} here, not a parameter of {key}", other.meaning());
            self.found.push("bad-expression", key, place, message, "choose another name");
        }
    }

    /// A number, or `[lower, upper]`, for a parameter of the mapping or of an expression.
    fn own_value(&mut self, spec: &mut Spec, name: &str, parameter: Parameter, node: &Node) {
        let key = format!("params.{name}");
        if spec.fixed.contains_key(&parameter) {
            let message = format!("`{name}` is given in `mu` and in `params`");
            self.wrong(&key, Some(node.place), message, "leave one of the two out".to_owned());
            return;
        }
        let domain = spec.domain(parameter);
        let admitted = |node: &Node| real(node).filter(|value| domain.admits(value));
        match &node.value {
            Value::List(items) => {
                if let [least, greatest] = items.as_slice()
                    && let (Some(least), Some(greatest)) = (admitted(least), admitted(greatest))
                    && least.number() < greatest.number()
                {
                    spec.bounds.insert(parameter, (least, greatest));
                    return;
                }
                let message = format!("{key} is not a pair of bounds");
                let help = format!(
                    "bounds are [lower, upper] with least < greatest; {name} is {}",
                    domain.text()
                );
                self.wrong(&key, Some(node.place), message, help);
            }
            _ => match admitted(node) {
                Some(value) => {
                    spec.fixed.insert(parameter, value);
                }
                None => {
                    let message = format!("{key} = {} is outside its domain", shown(&node.value));
                    let help = format!("{name} is {}", domain.text());
                    self.wrong(&key, Some(node.place), message, help);
                }
            },
        }
    }

    /// The value of `parameter`, given under `key`.
    pub(super) fn parameter(
        &mut self,
        key: &str,
        parameter: Parameter,
        node: &Node,
    ) -> Option<Fixed> {
        let domain = match parameter {
            Parameter::UMax if self.keys.contains_key("u_min") => Domain::AboveUMin,
            parameter => parameter.domain(),
        };
        let value = real(node).filter(|value| domain.admits(value));
        if value.is_some() {
            return value;
        }
        if let (Parameter::UMax | Parameter::UMin, Value::List(pair)) = (parameter, &node.value)
            && key != "limits"
        {
            let values: Vec<_> = pair.iter().filter_map(real).collect();
            let help = match values.as_slice() {
                [least, most] if pair.len() == 2 => {
                    format!("limits are two keys: u_min = {least} and u_max = {most}")
                }
                _ => "with `axes` or several inputs `limits` has those of each".to_owned(),
            };
            self.wrong(key, Some(node.place), format!("{key} is one number"), help);
            return None;
        }
        let message = format!("{key} = {} is outside its domain", shown(&node.value));
        let help = match parameter {
            Parameter::UMax if key == "u_max" && domain == Domain::PositiveOrInfinite => {
                format!(
                    "{key} (bound of |u|) is {}; u_min beside it gives the lower limit",
                    domain.text()
                )
            }
            _ => format!("{key} ({}) is {}", parameter.meaning(), domain.text()),
        };
        self.wrong(key, Some(node.place), message, help);
        None
    }

    /// Refuses a lower limit of u that is not below the upper one, as the precision holds them.
    fn limits_in_order(&mut self, spec: &Spec) {
        let [least, most] = [Parameter::UMin, Parameter::UMax].map(|p| spec.fixed.get(&p));
        let rounded = |value: &Fixed| value.rounded(spec.precision);
        if let (Some(least), Some(most)) = (least, most)
            && (!least.is_below(most)
                || (rounded(least).is_some() && rounded(least) == rounded(most)))
        {
            let place = self.keys.get("u_min").map(|node| node.place);
            let message = format!("u_min = {least} is not below u_max = {most}");
            let help = "u is held between u_min and u_max: give the lower limit as u_min";
            self.wrong("u_min", place, message, help.to_owned());
            return;
        }
        let outside = |limit: Option<&Fixed>, above: bool| match limit.and_then(Fixed::number) {
            Some(limit) => {
                if above {
                    limit.is_positive()
                } else {
                    limit.is_negative()
                }
            }
            None => false,
        };
        if spec.u_min && spec.after == After::Zero && (outside(least, true) || outside(most, false))
        {
            let place = self.keys.get("after").map(|node| node.place);
            let message = "after = zero, and u = 0 is outside of u_min and u_max".to_owned();
            let help =
                "leave `after` out to hold the gains after the deadline, or take limits around 0";
            self.wrong("after", place, message, help.to_owned());
        }
    }

    fn eps_below_tau(&mut self, fixed: &FixedValues) {
        let (Some(eps), Some(tau)) = (fixed.get(&Parameter::Eps), fixed.get(&Parameter::Tau))
        else {
            return;
        };
        if eps.number() >= tau.number() {
            let place = self.keys.get("eps").map(|node| node.place);
            let message = format!("eps = {eps} is not below tau = {tau}");
            let help = "the gains would be held from the start: give an eps well below tau";
            self.wrong("eps", place, message, help.to_owned());
        }
    }

    /// Notes fixed values and bounds that the precision does not hold, or with which the emitted
    /// code would not keep its digits.
    pub(super) fn representable(&mut self, spec: &Spec) {
        let name = spec.precision.name();
        let bounds =
            spec.bounds.iter().flat_map(|(p, (least, greatest))| [(p, least), (p, greatest)]);
        for (parameter, value) in spec.fixed.iter().chain(bounds) {
            let shown = parameter.spelling();
            let (message, help) = if value.leaves(spec.precision) {
                let message = format!("{shown} = {value} is not a finite nonzero number in {name}");
                (message, format!("give a value within the range of {name}"))
            } else if let Some(legal) = spec.ends_of_kind(*parameter)
                && value.rounded(spec.precision).is_some_and(|v| !(legal.0..=legal.1).contains(&v))
            {
                let message = match parameter {
                    Parameter::Start => {
                        format!("{shown} = {value} is out of range for n = {} in {name}", spec.n)
                    }
                    _ => {
                        format!("{shown} = {value}: the emitted {name} code would lose digits of u")
                    }
                };
                let legal = Spec { bounds: BTreeMap::new(), ..spec.clone() }.legal(*parameter);
                let help = match parameter {
                    Parameter::M => "; the exponent multiplies the rounding error of T/tau",
                    Parameter::Start => "; 1 is `exp`",
                    _ => "; take other units, of time for example",
                };
                (message, format!("{shown} ({}) is {legal}{help}", parameter.meaning()))
            } else {
                continue;
            };
            let own = format!("params.{}", parameter.key());
            let key = match parameter {
                Parameter::Gain(_) if self.keys.contains_key("poles") => "poles",
                Parameter::Gain(_) => "gains",
                Parameter::Named(_) => &own,
                Parameter::A | Parameter::M | Parameter::Start | Parameter::Rate(_) => "mu",
                _ => parameter.key(),
            };
            let place = self.keys.get(key).map(|node| node.place);
            self.wrong(key, place, message, help);
        }
    }
}
