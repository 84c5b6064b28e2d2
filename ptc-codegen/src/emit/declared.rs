//! The run-time parameters as the emitted code declares them, with meaning, unit and domain.

use super::Language;
use crate::expression::Expression;
use crate::parameter::Parameter;
use crate::request::{Feedback, Spec};

/// A parameter as an emitted struct declares it.
pub(super) struct Declared {
    pub(super) name: &'static str,
    /// Length of an array; none for a scalar.
    pub(super) length: Option<usize>,
    /// Meaning, unit and domain, for a comment.
    pub(super) about: String,
    /// The same as a sentence of rustdoc, which takes brackets for links.
    pub(super) doc: String,
}

/// The run-time parameters in the order of the emitted struct, arrays taken together.
pub(super) fn declared(spec: &Spec, language: Language) -> Vec<Declared> {
    let parameters: Vec<_> = spec.run_time_parameters().collect();
    let declare = |group: &[Parameter]| {
        let first = *group.first()?;
        let (meaning, domain) = (meaning(spec, first), domain(spec, first));
        let unit = first.unit_for(spec.n);
        let (about, doc) = match first {
            Parameter::Gain(_) | Parameter::Rate(_) => {
                let (text, doc) = elements(spec, group, language);
                (format!("{meaning}, {domain}; {text}"), format!("{meaning}, {domain}; {doc}"))
            }
            Parameter::Named(_) => {
                let text = format!("{meaning}, {domain}");
                (text.clone(), text)
            }
            Parameter::M => {
                (format!("{meaning} [1], {domain}"), format!("{meaning}, dimensionless; {domain}"))
            }
            Parameter::UMax => (
                format!("{meaning} [{unit}], {domain}"),
                format!("{meaning}, in the {unit}; {domain}"),
            ),
            _ => {
                (format!("{meaning} [{unit}], {domain}"), format!("{meaning}, in {unit}; {domain}"))
            }
        };
        let length = first.index().map(|_| group.len());
        Some(Declared { name: first.key(), length, about, doc: format!("{}.", capital(&doc)) })
    };
    parameters.chunk_by(|a, b| a.key() == b.key()).filter_map(declare).collect()
}

/// What a parameter means in this controller.
pub(super) fn meaning(spec: &Spec, parameter: Parameter) -> String {
    match parameter {
        Parameter::Gain(_) => format!("gains of pi0 = {}", linear(spec.n)),
        Parameter::Named(_) => {
            let law = match &spec.feedback {
                Feedback::Expression(law) => Some(law),
                Feedback::Linear | Feedback::Extern => None,
            };
            let custom = spec.custom();
            let of = [
                (custom.map_or("mu", |c| c.subject.key()), custom.map(|c| &c.given)),
                ("pi0", law),
                ("g", spec.input_gain.as_ref()),
            ];
            let uses = |e: &Expression| e.parameters().contains(&parameter);
            let keys = of.into_iter().filter(|(_, e)| e.is_some_and(uses)).map(|(key, _)| key);
            format!("parameter of {}", keys.collect::<Vec<_>>().join(" and "))
        }
        _ => parameter.meaning().to_owned(),
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

/// Which element of an array is which parameter, in which unit: as text and as rustdoc. Where there
/// are more than three, the first and the last show the rule.
fn elements(spec: &Spec, group: &[Parameter], language: Language) -> (String, String) {
    let one = |parameter: &Parameter, doc: bool| {
        let index = parameter.index().unwrap_or(0);
        let element = language.element(parameter.key(), index);
        let (symbol, unit) = (parameter.symbol(), parameter.unit_for(spec.n));
        match doc {
            true => format!("`{element}` is {symbol} in {unit}"),
            false => format!("{element} is {symbol} [{unit}]"),
        }
    };
    let list = |doc: bool| match group {
        [first, _, _, .., last] if group.len() > 3 => {
            format!("{}, ..., {}", one(first, doc), one(last, doc))
        }
        all => all.iter().map(|p| one(p, doc)).collect::<Vec<_>>().join(", "),
    };
    (list(false), list(true))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect()
}

impl Language {
    /// Element `index`, counted from 0, of an array.
    fn element(self, name: &str, index: usize) -> String {
        match self {
            Self::Matlab => format!("{name}({})", index + 1),
            Self::StructuredText => format!("{name}[{}]", index + 1),
            _ => format!("{name}[{index}]"),
        }
    }
}
