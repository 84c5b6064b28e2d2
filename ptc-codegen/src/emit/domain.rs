//! The domains of the run-time parameters, as conditions in a language.

use super::Controller;
use super::frame::literal;
use super::plan::parameter_name;
use super::print::Syntax;
use crate::program::number;
use crate::spec::{Domain, Fixed, Parameter, Spec, What};

/// A condition that run-time parameters must meet.
pub(super) struct Condition {
    /// The parameter to blame where it is not met.
    pub(super) parameter: Parameter,
    /// The condition.
    pub(super) test: String,
    /// What is legal, in words.
    pub(super) legal: String,
}

/// The conditions of the run-time parameters' domains.
pub(super) fn conditions(controller: &Controller<'_>, syntax: &dyn Syntax) -> Vec<Condition> {
    let spec = controller.spec();
    let zero = syntax.literal("0.0");
    let mut all = Vec::new();
    for parameter in spec.run_time_parameters() {
        let name = parameter_name(parameter);
        let positive = format!("({name} > {zero})");
        let tests = match spec.domain(parameter) {
            Domain::Finite => vec![syntax.finite(&name)],
            Domain::Positive => vec![syntax.finite(&name), positive],
            Domain::Within => within(spec, parameter, syntax),
            Domain::PositiveOrInfinite | Domain::BelowTau => vec![positive],
        };
        let legal = match spec.bounds.get(&parameter) {
            Some((least, greatest)) => format!("from {least} to {greatest}"),
            None => spec.domain(parameter).text().to_owned(),
        };
        let condition = |test| Condition { parameter, test, legal: legal.clone() };
        all.extend(tests.into_iter().map(condition));
    }
    if let Some((parameter, greatest)) = &controller.report.greatest
        && let Some(number) = greatest.number()
    {
        let bound = literal(number::round(number, spec.precision), spec.precision, syntax);
        let legal = format!("at most {greatest}, where x and u still go to 0 at the deadline");
        let test = format!("({} <= {bound})", parameter_name(*parameter));
        all.push(Condition { parameter: *parameter, test, legal });
    }
    // eps below tau: both may be fixed, and then the spec has been checked.
    if spec.what == What::Associated {
        return all;
    }
    let fixed = |p| spec.fixed.get(&p);
    if let (Some(_), Some(_)) = (fixed(Parameter::Eps), fixed(Parameter::Tau)) {
        return all;
    }
    let text = |parameter| text(spec, parameter, syntax);
    let test = format!("({} < {})", text(Parameter::Eps), text(Parameter::Tau));
    let (parameter, legal) = match (fixed(Parameter::Eps), fixed(Parameter::Tau)) {
        (Some(eps), _) => (Parameter::Tau, format!("> eps = {eps}")),
        (None, Some(tau)) => (Parameter::Eps, format!("> 0, < tau = {tau}")),
        (None, None) => (Parameter::Eps, Domain::BelowTau.text().to_owned()),
    };
    all.push(Condition { parameter, test, legal });
    all
}

/// A parameter in `init`: its literal where it is fixed, else its local name.
pub(super) fn text(spec: &Spec, parameter: Parameter, syntax: &dyn Syntax) -> String {
    match spec.fixed.get(&parameter).and_then(Fixed::number) {
        Some(number) => literal(number::round(number, spec.precision), spec.precision, syntax),
        None => parameter_name(parameter),
    }
}

/// The conditions that keep a parameter within the bounds that the user gave.
fn within(spec: &Spec, parameter: Parameter, syntax: &dyn Syntax) -> Vec<String> {
    let Some((least, greatest)) = spec.bounds.get(&parameter) else { return Vec::new() };
    let name = parameter_name(parameter);
    let text = |bound: &Fixed| {
        bound.number().map(|n| literal(number::round(n, spec.precision), spec.precision, syntax))
    };
    let least = text(least).map(|bound| format!("({name} >= {bound})"));
    least.into_iter().chain(text(greatest).map(|bound| format!("({name} <= {bound})"))).collect()
}
