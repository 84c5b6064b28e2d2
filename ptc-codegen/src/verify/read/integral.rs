//! Integrals in an objective: `integral(e)` is a state of the run that begins at 0 with the rate e.

use super::Reader;
use super::objective::{in_names, in_states};
use crate::diagnostic::counted;
use crate::expression::{Expression, INTEGRAL, Scope, Subject, Variable, resolve};
use crate::parameter::Name;
use crate::request::MAX_ORDER;
use crate::syntax::{Argument, Node, Value};

/// An integral over the run.
#[derive(Clone, Debug)]
pub(super) struct Integral {
    /// Name that replaces it where it is written.
    pub(super) name: Name,
    /// Integrand in the words of the user, in which the names of others may be.
    written: Expression,
    /// The same of the plant as it is.
    integrand: Expression,
}

impl Reader<'_> {
    /// The integrands of the campaign, each of the plant and the integrals before it.
    pub(super) fn integrands(&self) -> Vec<Expression> {
        self.integrals.iter().map(|integral| integral.integrand.clone()).collect()
    }

    /// The integrals that have been read, as variables behind those of the plant.
    pub(super) fn accumulated(&self) -> impl Iterator<Item = (Name, Variable)> {
        let behind = self.spec.variables();
        (behind + 1..).zip(&self.integrals).map(|(j, own)| (own.name, Variable::State(j)))
    }

    /// A text in which every integral stands with what it is of.
    pub(super) fn spelt(&self, text: String) -> String {
        // The name of a later one may begin with that of an earlier one, and not the other way round.
        self.integrals.iter().rev().fold(text, |text, own| {
            text.replace(own.name.text(), &format!("{INTEGRAL}({})", own.written))
        })
    }

    /// The same text with a name in place of each integral, from the inside out.
    pub(super) fn lifted(&mut self, index: usize, node: &Node) -> Option<Node> {
        let one = |reader: &mut Self, node: &Node| reader.lifted(index, node);
        let value = match &node.value {
            Value::Call(name, arguments) if name == INTEGRAL => {
                Value::Word(self.integral(index, node, arguments)?.text().to_owned())
            }
            Value::Call(name, arguments) => {
                let each = arguments.iter().map(|argument| {
                    let value = one(self, &argument.value)?;
                    Some(Argument { value, ..argument.clone() })
                });
                Value::Call(name.clone(), each.collect::<Option<_>>()?)
            }
            Value::Negative(a) => Value::Negative(one(self, a)?.into()),
            Value::Binary(operator, a, b) => {
                Value::Binary(*operator, one(self, a)?.into(), one(self, b)?.into())
            }
            _ => return Some(node.clone()),
        };
        Some(Node { value, ..node.clone() })
    }

    /// The name of an integral, a new one where its integrand is.
    fn integral(&mut self, index: usize, node: &Node, arguments: &[Argument]) -> Option<Name> {
        let key = format!("objective[{index}].h");
        let [Argument { name: None, value }] = arguments else {
            let message = format!("`{INTEGRAL}` takes one argument, without a name");
            let help = "write integral(u^2): over time, from t0 to the instant that is looked at";
            self.found.push("bad-expression", key, Some(node.place), message, help);
            return None;
        };
        let value = self.lifted(index, value)?;
        let known = self.known();
        let names = self.names();
        let scope =
            Scope { subject: Subject::Objective, n: self.order(), known: &known, own: &names };
        let read = resolve(&value, scope, &mut self.found)?;
        let read = self.of_several(&key, &value, read)?;
        let integrand = in_states(&read, self.spec);
        if let Some(own) = self.integrals.iter().find(|own| own.integrand == integrand) {
            return Some(own.name);
        }
        let states = self.spec.states();
        if states + self.integrals.len() >= MAX_ORDER {
            let message = format!(
                "the objectives have more than {} of a plant with {}",
                counted(&self.integrals.len(), "integral"),
                counted(&states, "state")
            );
            let help = format!(
                "states and different integrals together are at most {MAX_ORDER}: verify some of the objectives in a campaign of their own"
            );
            self.found.push("bad-expression", key, Some(node.place), message, help);
            return None;
        }
        let name = Name::new(&format!("ptc_integral{}", self.integrals.len() + 1))?;
        let written = in_names(&read, &names);
        self.integrals.push(Integral { name, written, integrand });
        Some(name)
    }
}
