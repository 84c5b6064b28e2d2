//! The run-time parameters as the emitted code declares them, with meaning, unit and domain.

use crate::code::{Shape, Variable};
use crate::expression::Expression;
use crate::parameter::Parameter;
use crate::request::Spec;

/// Syntax of an array element, counted from 0, in a language.
pub(super) type Element = fn(&str, usize) -> String;

/// As most languages do.
pub(super) fn element(name: &str, index: usize) -> String {
    format!("{name}[{index}]")
}

/// The run-time parameters in the order of the emitted struct, arrays taken together.
pub(super) fn declared(spec: &Spec, element: Element) -> Vec<Variable> {
    let parameters: Vec<_> = spec.run_time_parameters().collect();
    let declare = |group: &[Parameter]| {
        let first = *group.first()?;
        let (meaning, domain) = (meaning(spec, first), domain(spec, first));
        let unit = spec.unit(first);
        let about = match first {
            Parameter::Gain(_) | Parameter::Rate(_) => {
                format!("{meaning}, {domain}; {}", elements(spec, group, element))
            }
            Parameter::Named(_) => format!("{meaning}, {domain}"),
            Parameter::M => format!("{meaning} [1], {domain}"),
            _ => format!("{meaning} [{unit}], {domain}"),
        };
        let shape = first.index().map_or(Shape::Real, |_| Shape::Reals(group.len()));
        Some(Variable::new(first.key(), shape, about))
    };
    parameters.chunk_by(|a, b| a.key() == b.key()).filter_map(declare).collect()
}

/// Returns the meaning of a parameter in this controller.
pub(super) fn meaning(spec: &Spec, parameter: Parameter) -> String {
    match parameter {
        Parameter::Gain(_) => format!("gains of pi0 = {}", linear(spec.n)),
        Parameter::Named(_) => {
            let uses = |e: &Expression| e.parameters().contains(&parameter);
            let custom = spec.custom();
            let of = [
                (custom.map_or("mu", |c| c.subject.key()), custom.map(|c| &c.given)),
                ("pi0", spec.laws().find(|law| uses(law))),
                ("f", spec.drift.as_ref().filter(|_| spec.model.is_none())),
                ("g", spec.input_gain.as_ref().filter(|_| spec.model.is_none())),
                ("reference", spec.known_references().flat_map(|all| &all[..1]).find(|r| uses(r))),
            ];
            let keys = of.into_iter().filter(|(_, e)| e.is_some_and(uses)).map(|(key, _)| key);
            let of_axes = spec.axes.iter().flat_map(|axes| &axes.input_gains).any(uses);
            let of_axes = of_axes && !spec.input_gain.as_ref().is_some_and(uses);
            let of_coupled = spec.coupled.iter().flat_map(|coupled| coupled.expressions());
            let of_model = spec.model.iter().flat_map(|m| &m.dynamics).chain(of_coupled).any(uses);
            let model = of_model.then_some("the model").or(of_axes.then_some("g"));
            format!("parameter of {}", keys.chain(model).collect::<Vec<_>>().join(" and "))
        }
        _ => spec.meaning(parameter).to_owned(),
    }
}

/// The legal values of a parameter in words.
pub(super) fn domain(spec: &Spec, parameter: Parameter) -> String {
    spec.legal(parameter)
}

/// The linear law of order `n`.
pub(super) fn linear(n: usize) -> String {
    match n {
        1 => "-k_1 xi_1".to_owned(),
        2 => "-(k_1 xi_1 + k_2 xi_2)".to_owned(),
        _ => format!("-(k_1 xi_1 + ... + k_{n} xi_{n})"),
    }
}

/// Lists the parameter and unit of each array element. Of more than three, only the first and the last are shown.
fn elements(spec: &Spec, group: &[Parameter], element: Element) -> String {
    let one = |parameter: &Parameter| {
        let element = element(parameter.key(), parameter.index().unwrap_or(0));
        format!("{element} is {} [{}]", parameter.symbol(), parameter.unit_for(spec.n))
    };
    match group {
        [first, _, _, .., last] if group.len() > 3 => {
            format!("{}, ..., {}", one(first), one(last))
        }
        all => all.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}
