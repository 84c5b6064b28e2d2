//! Diagnostics of a model whose output is not a chain.

use super::super::{Reader, items};
use crate::diagnostic::{Place, shorten_expression};
use crate::model::Ill;
use crate::model::coupled::IllCoupled;
use crate::parameter::Name;
use crate::syntax::Node;

impl Reader<'_> {
    /// `output` is the key of the output, and where it was written.
    pub(super) fn ill_model(
        &mut self,
        ill: &Ill,
        (states, inputs): (&[Name], &[Name]),
        rates: &[&Node],
        (key, output): (&'static str, Option<Place>),
    ) {
        let names: Vec<_> = inputs.iter().map(|name| format!("`{name}`")).collect();
        let (key, place, message, help) = match ill {
            Ill::NotAffine(index, input, slope) => (
                "dynamics",
                rates.get(*index).map(|node| node.place),
                format!("{}' is not affine in the input {}: its slope is {}", states[*index], names[*input], shorten_expression(slope)),
                "write it as f + g*input with f and g of the states; a curved actuator is inverted outside, or is a state with dynamics of its own".to_owned(),
            ),
            Ill::Kink(text) => (
                key,
                output,
                format!("{} has a kink, abs, sign, min or max, and has to be differentiated", shorten_expression(text)),
                "take a smooth function in its place: tanh(w/small) for sign(w)".to_owned(),
            ),
            Ill::Open(text) => (
                key,
                output,
                format!("the relative degree is not decided: is {} = 0 for all states?", shorten_expression(text)),
                "write the model with fewer functions, or fix parameters under [params]".to_owned(),
            ),
            Ill::Unreached => (
                key,
                output,
                match names.as_slice() {
                    [one] => format!("the input {one} does not reach the output"),
                    several => format!("none of the inputs {} reaches the output", several.join(", ")),
                },
                "take an output that it moves, or give the states between them their dynamics".to_owned(),
            ),
            Ill::TooLarge(order) => (
                key,
                output,
                format!("derivative {order} of the output is larger than an expression may be"),
                "take an output with a lower relative degree, or a simpler model".to_owned(),
            ),
        };
        self.found.push("bad-model", key, place, message, help);
    }

    /// The same of several outputs, which were written at these places.
    pub(super) fn ill_coupled(
        &mut self,
        ill: &IllCoupled,
        names: (&[Name], &[Name]),
        rates: &[&Node],
        (key, outputs): (&'static str, &Node),
    ) {
        let (message, help) = match ill {
            IllCoupled::One(index, ill) => {
                let node = index.and_then(|index| items(outputs).get(index)).unwrap_or(outputs);
                return self.ill_model(ill, names, rates, (key, Some(node.place)));
            }
            IllCoupled::Open(determinant) => (
                format!(
                    "whether the inputs decouple the outputs is not decided: is {} = 0 for all states?",
                    shorten_expression(determinant)
                ),
                "write the model with fewer functions, or fix parameters under [params]",
            ),
            IllCoupled::Singular(matrix) if key == "inertia" => (
                format!(
                    "the inertia {} is singular for all states: no motion follows from the inputs",
                    shorten_expression(matrix)
                ),
                "check its entries: an inertia is symmetric and positive definite",
            ),
            IllCoupled::Singular(matrix) => (
                format!(
                    "no static decoupling exists: the matrix {}, by which the inputs move the last derivatives of the outputs, is singular for all states",
                    shorten_expression(matrix)
                ),
                "take outputs that the inputs move one by one, or add an integrator before the input that acts first: a state whose rate is the new input",
            ),
        };
        self.found.push("bad-model", key, Some(outputs.place), message, help);
    }
}
