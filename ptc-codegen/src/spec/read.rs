//! From keys and values to a [`Spec`]: all mistakes at once, none left for later stages.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use super::{
    Argument, Fixed, Guard, KEYS, KeyInfo, MAX_ORDER, MAX_RATES, Node, Parameter, Precision, Spec,
    Value, reserved::is_reserved, value::shorten,
};
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss};
use crate::mapping::{FAMILIES, Family, FamilyInfo};

/// Largest decimal exponent of a number.
pub(crate) const MAX_EXPONENT: i32 = 400;

/// One key with its value, as a front end found it.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Where the key was written.
    pub place: Place,
    /// Its value.
    pub value: Node,
}

/// Reads a spec.
///
/// # Errors
/// Every mistake in the entries, in their order.
pub fn read(entries: &[Entry]) -> Result<Spec, Vec<Diagnostic>> {
    let mut reader = Reader { found: Diagnostics::default(), keys: BTreeMap::new() };
    for entry in entries {
        reader.admit(entry);
    }
    let spec = reader.spec();
    reader.found.finish(spec)
}

/// What `mu` says: the family, its number of rates, and its parameters as far as they are fixed.
struct Mu {
    family: Family,
    rates: usize,
    fixed: Vec<(Parameter, Fixed)>,
}

struct Reader<'a> {
    found: Diagnostics,
    keys: BTreeMap<&'static str, &'a Node>,
}

impl<'a> Reader<'a> {
    fn admit(&mut self, entry: &'a Entry) {
        let Some(info) = KeyInfo::find(&entry.key) else {
            let names = KEYS.iter().map(|info| info.key);
            let meant = near_miss(&entry.key, names.clone());
            let legal = names.collect::<Vec<_>>().join(", ");
            self.found.push(
                "unknown-key",
                entry.key.clone(),
                Some(entry.place),
                format!("unknown key `{}`", shorten(&entry.key)),
                suggestion(meant, &format!("the keys are {legal}")),
            );
            return;
        };
        if self.keys.insert(info.key, &entry.value).is_some() {
            self.found.push(
                "repeated-key",
                info.key,
                Some(entry.place),
                format!("key `{}` is given twice", info.key),
                "leave one of the two out",
            );
        }
    }

    fn spec(&mut self) -> Option<Spec> {
        let n = self.order();
        let mu = self.mu();
        let name = self.name();
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let guard = self.choice(
            "guard",
            &[("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)],
        );
        let mut fixed = BTreeMap::new();
        for parameter in [Parameter::Tau, Parameter::StartTime, Parameter::Eps, Parameter::UMax] {
            if let Some(node) = self.keys.get(parameter.key()).copied() {
                let value = self.parameter(parameter.key(), parameter, node);
                fixed.extend(value.map(|v| (parameter, v)));
            }
        }
        self.eps_below_tau(&fixed);
        fixed.extend(self.gains(n));
        fixed.extend(mu.iter().flat_map(|mu| mu.fixed.iter().cloned()));
        let precision = precision.unwrap_or(Precision::F64);
        self.representable(&fixed, precision);
        let (n, Mu { family, rates, .. }) = (n?, mu?);
        Some(Spec { n, family, rates, name, precision, guard: guard.unwrap_or(Guard::Full), fixed })
    }

    fn wrong(&mut self, key: &str, place: Option<Place>, message: String, help: String) {
        self.found.push("bad-value", key, place, message, help);
    }

    fn missing(&mut self, key: &'static str) {
        let legal = KeyInfo::find(key).map_or("", |info| info.legal);
        let message = format!("`{key}` is missing");
        self.found.push("missing-key", key, None, message, format!("give {legal}"));
    }

    fn order(&mut self) -> Option<usize> {
        let Some(node) = self.keys.get("n").copied() else {
            self.missing("n");
            return None;
        };
        let n = count(node, MAX_ORDER);
        if n.is_none() {
            let message = format!("n = {} is no order that can be generated", shown(&node.value));
            let help = format!("n is an integer 1..={MAX_ORDER}");
            self.wrong("n", Some(node.place), message, help);
        }
        n
    }

    fn name(&mut self) -> Option<String> {
        let node = self.keys.get("name").copied()?;
        if let Value::Word(word) = &node.value
            && word.len() <= 48
            && !is_reserved(word)
        {
            return Some(word.clone());
        }
        let message = format!("{} cannot name a controller", shown(&node.value));
        let legal = KeyInfo::find("name").map_or("", |info| info.legal);
        self.wrong("name", Some(node.place), message, format!("a name is {legal}"));
        None
    }

    fn choice<T: Copy>(&mut self, key: &'static str, legal: &[(&str, T)]) -> Option<T> {
        let node = self.keys.get(key).copied()?;
        let names = legal.iter().map(|(name, _)| *name);
        let word = match &node.value {
            Value::Word(word) => word.as_str(),
            _ => "",
        };
        if let Some((_, value)) = legal.iter().find(|(name, _)| *name == word) {
            return Some(*value);
        }
        let meant = near_miss(word, names.clone());
        let all = names.collect::<Vec<_>>().join(", ");
        let message = format!("{key} = {} is not one of {all}", shown(&node.value));
        self.wrong(key, Some(node.place), message, suggestion(meant, &format!("legal: {all}")));
        None
    }

    /// The value of `parameter`, given under `key`.
    fn parameter(&mut self, key: &str, parameter: Parameter, node: &Node) -> Option<Fixed> {
        if let Value::Number(value) = &node.value
            && parameter.domain().admits(value)
        {
            return Some(value.clone());
        }
        let message = format!("{key} = {} is outside its domain", shown(&node.value));
        let help = format!("{key} ({}) is {}", parameter.meaning(), parameter.domain().text());
        self.wrong(key, Some(node.place), message, help);
        None
    }

    fn eps_below_tau(&mut self, fixed: &BTreeMap<Parameter, Fixed>) {
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

    fn representable(&mut self, fixed: &BTreeMap<Parameter, Fixed>, precision: Precision) {
        for (parameter, value) in fixed {
            if value.leaves(precision) {
                let key = match parameter {
                    Parameter::Gain(_) => "gains",
                    Parameter::A | Parameter::M | Parameter::Rate(_) => "mu",
                    _ => parameter.key(),
                };
                let place = self.keys.get(key).map(|node| node.place);
                let name = if precision == Precision::F32 { "f32" } else { "f64" };
                let message =
                    format!("{} = {value} is no finite nonzero number in {name}", parameter.key());
                self.wrong(key, place, message, format!("give a value within the range of {name}"));
            }
        }
    }

    /// The gains as far as they are legal, whether or not the order is.
    fn gains(&mut self, n: Option<usize>) -> Vec<(Parameter, Fixed)> {
        let Some(node) = self.keys.get("gains").copied() else { return Vec::new() };
        let single = std::slice::from_ref(node);
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ => single,
        };
        if let Some(n) = n
            && items.len() != n
        {
            let message = format!("{} gains for order n = {n}", items.len());
            let help = format!("give k_1..k_{n}, one for each of xi_1..xi_{n}");
            self.wrong("gains", Some(node.place), message, help);
            return Vec::new();
        }
        let gain = |(index, item): (usize, &Node)| {
            let parameter = Parameter::Gain(index + 1);
            let key = format!("gains[{index}]");
            self.parameter(&key, parameter, item).map(|value| (parameter, value))
        };
        items.iter().enumerate().filter_map(gain).collect()
    }

    fn mu(&mut self) -> Option<Mu> {
        let Some(node) = self.keys.get("mu").copied() else {
            self.missing("mu");
            return None;
        };
        let (name, arguments): (&str, &[Argument]) = match &node.value {
            Value::Word(name) => (name, &[]),
            Value::Call(name, arguments) => (name, arguments),
            _ => ("", &[]),
        };
        let Some(info) = FAMILIES.iter().find(|info| info.name == name) else {
            let names = FAMILIES.iter().map(|info| info.name);
            let meant = near_miss(name, names.clone());
            let all = names.collect::<Vec<_>>().join(", ");
            let shown =
                if name.is_empty() { shown(&node.value) } else { format!("`{}`", shorten(name)) };
            self.found.push(
                "unknown-family",
                "mu",
                Some(node.place),
                format!("{shown} is no known mapping"),
                suggestion(meant, &format!("the families are {all}")),
            );
            return None;
        };
        if info.family == Family::ExpSum {
            return self.rates(node, arguments);
        }
        let fixed = arguments.iter().filter_map(|a| self.own_parameter(info, a)).collect();
        self.reject_twice(arguments);
        Some(Mu { family: info.family, rates: 0, fixed })
    }

    /// `a = 1` or `m = 2` of a family.
    fn own_parameter(
        &mut self,
        info: &FamilyInfo,
        argument: &Argument,
    ) -> Option<(Parameter, Fixed)> {
        let (family, names) = (info.name, info.parameters);
        let Some((name, place)) = &argument.name else {
            let message =
                format!("{} in `{family}(...)` has no name", shown(&argument.value.value));
            let value = shown(&argument.value.value);
            let help = format!("write {family}({}={})", names[0], value.trim_matches('`'));
            self.wrong("mu", Some(argument.value.place), message, help);
            return None;
        };
        let legal = [Parameter::A, Parameter::M].into_iter().filter(|p| names.contains(&p.key()));
        let Some(parameter) = legal.into_iter().find(|p| p.key() == name) else {
            self.found.push(
                "unknown-parameter",
                format!("mu.{name}"),
                Some(*place),
                format!("`{family}` has no parameter `{}`", shorten(name)),
                suggestion(
                    near_miss(name, names.iter().copied()),
                    &format!("its parameters are {}", names.join(", ")),
                ),
            );
            return None;
        };
        self.parameter(&format!("mu.{name}"), parameter, &argument.value).map(|v| (parameter, v))
    }

    fn reject_twice(&mut self, arguments: &[Argument]) {
        let mut seen: Vec<&str> = Vec::new();
        for (name, place) in arguments.iter().filter_map(|a| a.name.as_ref()) {
            if seen.contains(&name.as_str()) {
                let message = format!("parameter `{name}` is given twice");
                self.wrong("mu", Some(*place), message, "leave one of the two out".to_owned());
            }
            seen.push(name);
        }
    }

    /// `exp_sum`, `exp_sum(2)` or `exp_sum(rates=[0.5, 1.5])`.
    fn rates(&mut self, node: &Node, arguments: &[Argument]) -> Option<Mu> {
        let mu = |rates, fixed| Some(Mu { family: Family::ExpSum, rates, fixed });
        match arguments {
            [] => return mu(2, Vec::new()),
            [Argument { name: None, value }] => {
                if let Some(count @ 2..) = count(value, MAX_RATES) {
                    return mu(count, Vec::new());
                }
            }
            [Argument { name: Some((name, _)), value: Node { value: Value::List(items), .. } }]
                if name == "rates" && (2..=MAX_RATES).contains(&items.len()) =>
            {
                let rate = |(index, item): (usize, &Node)| {
                    let parameter = Parameter::Rate(index + 1);
                    let key = format!("mu.rates[{index}]");
                    self.parameter(&key, parameter, item).map(|value| (parameter, value))
                };
                return mu(items.len(), items.iter().enumerate().filter_map(rate).collect());
            }
            _ => {}
        }
        let place = arguments.first().map_or(node.place, |a| a.value.place);
        let message = "the arguments of `exp_sum` are neither a count nor rates".to_owned();
        let help = format!(
            "write exp_sum(2) for two run-time rates, or exp_sum(rates=[0.5,1.5]); 2..={MAX_RATES} rates"
        );
        self.wrong("mu", Some(place), message, help);
        None
    }
}

fn suggestion(meant: Option<&str>, legal: &str) -> String {
    match meant {
        Some(name) => format!("did you mean `{name}`? {legal}"),
        None => legal.to_owned(),
    }
}

/// A positive integer up to `most`.
fn count(node: &Node, most: usize) -> Option<usize> {
    let Value::Number(Fixed::Number { value, .. }) = &node.value else { return None };
    let count = value.is_integer().then(|| value.to_usize()).flatten()?;
    (1..=most).contains(&count).then_some(count)
}

fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => format!("`{}`", shorten(&number.to_string())),
        Value::Word(word) => format!("`{}`", shorten(word)),
        Value::List(items) => format!("a list of {}", items.len()),
        Value::Call(name, _) => format!("`{}(...)`", shorten(name)),
    }
}
