//! The time mapping: a family with its parameters, or an expression.

use super::{Reader, count, shown, suggestion};
use crate::diagnostic::{near_miss, shorten};
use crate::expression::constant::real;
use crate::expression::{Expression, Function, Scope, Subject, resolve};
use crate::family::{FAMILIES, Family, FamilyInfo};
use crate::limits::EXPANSION;
use crate::mapping::{Custom, TimeMapping};
use crate::parameter::{Fixed, Parameter};
use crate::request::MAX_RATES;
use crate::syntax::{Argument, Node, Value};

/// A mapping with the values of its own parameters as far as they are fixed.
type Read = (TimeMapping, Vec<(Parameter, Fixed)>);

/// Returns true if abs, sign, min or max is applied to an expression that depends on time.
fn has_kink(expression: &Expression) -> bool {
    let of_time = Expression::varies;
    expression.any(&|e| e.is_kink() && of_time(e))
}

impl Reader<'_> {
    pub(super) fn time_mapping(&mut self, n: usize) -> Option<Read> {
        match self.only_one(&["mu", "kappa"]) {
            Some(("kappa", node)) => self.custom(Subject::Kappa, n, node),
            Some((_, node)) => self.mu(n, node),
            None => {
                self.missing("mu");
                None
            }
        }
    }

    fn custom(&mut self, subject: Subject, n: usize, node: &Node) -> Option<Read> {
        let scope = Scope { subject, n, known: &[Parameter::Tau], own: &[] };
        let given = resolve(node, scope, &mut self.found)?;
        if has_kink(&given) {
            let name = if subject == Subject::Mu { "t" } else { "dt" };
            let message =
                format!("{} has a kink: abs, sign, min or max of `{name}`", subject.key());
            let help =
                "a mapping is as often differentiable as the order of the plant: leave them out";
            self.found.push("bad-expression", subject.key(), Some(node.place), message, help);
            return None;
        }
        let coefficients = given.size().saturating_mul(n * (n + 1) / 2);
        if !EXPANSION.admits(coefficients) {
            let message = EXPANSION.exceeded(subject.key(), coefficients);
            self.found.push("too-large", subject.key(), Some(node.place), message, EXPANSION.fix);
            return None;
        }
        match Custom::new(subject, given) {
            Ok(custom) => Some((TimeMapping::Custom(Box::new(custom)), Vec::new())),
            Err((message, help)) => {
                self.found.push("bad-expression", subject.key(), Some(node.place), message, help);
                None
            }
        }
    }

    fn mu(&mut self, n: usize, node: &Node) -> Option<Read> {
        let (name, arguments): (&str, &[Argument]) = match &node.value {
            Value::Word(name) => (name, &[]),
            Value::Call(name, arguments) => (name, arguments),
            _ => return self.custom(Subject::Mu, n, node),
        };
        let Some(info) = FAMILIES.iter().find(|info| info.name == name) else {
            let functions = ["mean", "min", "max"];
            let is_function =
                Function::ALL.iter().any(|(f, _)| *f == name) || functions.contains(&name);
            if is_function && !arguments.is_empty() || ["t", "tau"].contains(&name) {
                return self.custom(Subject::Mu, n, node);
            }
            let names = FAMILIES.iter().map(|info| info.name);
            let meant = near_miss(name, names.clone());
            let all = names.collect::<Vec<_>>().join(", ");
            self.found.push(
                "unknown-family",
                "mu",
                Some(node.place),
                format!("unknown mapping `{}`", shorten(name)),
                suggestion(meant, &format!("the families are {all}; or give an expression in t")),
            );
            return None;
        };
        // A function that has the name of a family: tanh(t).
        if let [Argument { name: None, value }] = arguments
            && Function::ALL.iter().any(|(f, _)| *f == name)
            && !matches!(value.value, Value::Number(_))
        {
            return self.custom(Subject::Mu, n, node);
        }
        if info.family == Family::ExpSum {
            return self.rates(node, arguments);
        }
        if computed(info, arguments) {
            return self.custom(Subject::Mu, n, node);
        }
        let fixed = arguments.iter().filter_map(|a| self.own_parameter(info, a)).collect();
        self.reject_twice(arguments);
        Some((TimeMapping::Family { family: info.family, rates: 0 }, fixed))
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
        let legal = [Parameter::A, Parameter::M, Parameter::Start].into_iter();
        let own = |p: &Parameter| p.key() == name && names.contains(&p.key());
        let Some(parameter) = legal.into_iter().find(own) else {
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
    fn rates(&mut self, node: &Node, arguments: &[Argument]) -> Option<Read> {
        let mu =
            |rates, fixed| Some((TimeMapping::Family { family: Family::ExpSum, rates }, fixed));
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

/// Returns true if a parameter of a family is computed from others, as in `exp(a=2*b)`, and the mapping thus is an
/// expression.
fn computed(info: &FamilyInfo, arguments: &[Argument]) -> bool {
    let own = |argument: &Argument| {
        argument.name.as_ref().is_some_and(|(name, _)| info.parameters.contains(&name.as_str()))
    };
    let expression = |argument: &Argument| {
        let value = &argument.value.value;
        matches!(value, Value::Word(_) | Value::Call(..) | Value::Negative(_) | Value::Binary(..))
            && real(&argument.value).is_none()
    };
    arguments.iter().all(own) && arguments.iter().any(expression)
}
