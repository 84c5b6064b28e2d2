//! The laws of a plant with several outputs, each of which knows the whole plant.

use super::super::law::{Law, fixed, gains_of};
use super::super::{Reader, items};
use crate::diagnostic::counted;
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::model::Coupled;
use crate::parameter::{Name, Parameter};
use crate::request::Feedback;
use crate::syntax::Node;

/// Stems of the names that a law uses for parts of a plant, the last of them for those of a mechanical one. A parameter
/// with such a name is a part that does not exist.
const STEMS: [&str; 5] = ["xi", "x", "inertia", "inverse_inertia", "bias"];

impl Reader<'_> {
    /// An expression for each output: sums of gains are read as such, as are those of one chain.
    pub(in super::super) fn laws(
        &mut self,
        node: &Node,
        known: &[Parameter],
        coupled: &Coupled,
    ) -> Law {
        let (given, m) = (items(node), coupled.outputs.len());
        let mut law = Law::open();
        if given.len() != m {
            let message = format!(
                "{} of pi0 for {}",
                counted(&given.len(), "expression"),
                counted(&m, "output")
            );
            let help = "give one for each output, in their order: xi1_2 is xi_1 of output 2";
            self.wrong("pi0", Some(node.place), message, help.to_owned());
            return law;
        }
        let names = coupled.names_of_law();
        let laws: Vec<_> =
            given.iter().map(|item| self.law_of(item, known, (&names, coupled))).collect();
        let Some(laws) = laws.into_iter().collect::<Option<Vec<_>>>() else { return law };
        let mut next = 1;
        let of_output = |(law, order): (&Expression, usize)| {
            let states = next..next + order;
            next += order;
            gains_of(law, states)
        };
        let gains: Option<Vec<_>> = laws.iter().zip(coupled.orders()).map(of_output).collect();
        match gains {
            Some(gains) => {
                let rows = gains.into_iter().map(fixed);
                law.own_gains = rows.map(|row| row.into_values().collect()).collect();
                let first = (1..).map(Parameter::Gain).zip(law.own_gains.iter().flatten().cloned());
                law.gains = first.take(coupled.orders()[0]).collect();
            }
            None => {
                law.feedback = Feedback::Expression(laws[0].clone());
                law.laws = laws;
            }
        }
        law
    }

    /// Returns true if a law does not use an input of the plant, itself or in an intermediate value, as it follows from
    /// the law; else records a diagnostic.
    pub(in super::super) fn gives_inputs(
        &mut self,
        node: &Node,
        law: &Expression,
        inputs: &[(Name, Variable)],
    ) -> bool {
        let parameters = law.parameters();
        let is_used = |(name, input): &&(Name, Variable)| {
            parameters.contains(&Parameter::Named(*name)) || law.contains(*input)
        };
        let Some((input, _)) = inputs.iter().find(is_used) else { return true };
        let message = format!("`{input}` is an input of the plant, which follows from pi0");
        let help = "pi0 is an expression in the states, those in stretched time and t; a parameter needs another name";
        self.found.push("bad-expression", "pi0", Some(node.place), message, help);
        false
    }

    fn law_of(
        &mut self,
        node: &Node,
        known: &[Parameter],
        (names, coupled): (&[(Name, Expression)], &Coupled),
    ) -> Option<Expression> {
        // While it is read each name is a state of its own.
        let parts = (1..).zip(names).map(|(j, (name, _))| (*name, Variable::State(j)));
        // All outputs share the mapping.
        let highest = coupled.orders().into_iter().max().unwrap_or(0);
        let derivatives = (1..=highest).map(Variable::R);
        let derivatives = derivatives.filter_map(|r| Some((Name::new(&r.to_string())?, r)));
        let own: Vec<_> = parts.chain(derivatives).collect();
        let scope = Scope { subject: Subject::Law, n: 0, known, own: &own };
        let law = resolve(node, scope, &mut self.found)?;
        let part = |e: &Expression| match e.variable()? {
            Variable::State(j) => names.get(j - 1).map(|(_, part)| part.clone()),
            _ => None,
        };
        let law = law.substitute(&part);
        let controls = (coupled.states.len() + 1..).map(Variable::State);
        let inputs: Vec<_> = coupled.inputs.iter().copied().zip(controls).collect();
        if !self.gives_inputs(node, &law, &inputs) {
            return None;
        }
        if let Some(absent) = law.parameters().into_iter().find(is_of_plant) {
            let message = format!("`{}` is no part of the plant", absent.spelling());
            let all: Vec<_> = names.iter().map(|(name, _)| name.text()).collect();
            let help = format!("its parts are {}; a parameter needs another name", all.join(", "));
            self.found.push("bad-expression", "pi0", Some(node.place), message, help);
            return None;
        }
        if let Some(beyond) = law.parameters().into_iter().find(is_derivative) {
            let orders = coupled.order_text();
            let message = format!("`{}` does not exist for {orders}", beyond.spelling());
            let help = format!("the indices are 1..={highest}");
            self.found.push("bad-expression", "pi0", Some(node.place), message, help);
            return None;
        }
        Some(law)
    }
}

/// Returns true if a parameter has the name of a derivative of mu.
fn is_derivative(parameter: &Parameter) -> bool {
    let text = parameter.spelling();
    let index = text.strip_prefix("r_").and_then(|index| index.parse::<usize>().ok());
    index.is_some_and(|k| text == Variable::R(k).to_string())
}

/// Returns true if the name of a parameter is a stem of the parts of a plant, followed by numbers alone.
fn is_of_plant(parameter: &Parameter) -> bool {
    let text = parameter.spelling();
    let numbers =
        |rest: &str| rest.contains('_') && rest.bytes().all(|b| b.is_ascii_digit() || b == b'_');
    STEMS.iter().any(|stem| text.strip_prefix(stem).is_some_and(numbers))
}
