//! What is told of a model whose output is no chain.

use super::super::Reader;
use crate::model::Ill;
use crate::parameter::Name;
use crate::syntax::Node;

impl Reader<'_> {
    pub(super) fn ill_model(
        &mut self,
        ill: &Ill,
        (states, input): (&[Name], Name),
        rates: &[&Node],
    ) {
        let place = |key: &str| self.keys.get(key).map(|node| node.place);
        let output = place("output");
        let (key, place, message, help) = match ill {
            Ill::NotAffine(index, slope) => (
                "dynamics",
                rates.get(*index).map(|node| node.place),
                format!("{}' is not affine in the input `{input}`: its slope is {slope}", states[*index]),
                "write it as f + g*input with f and g of the states; a curved actuator is inverted outside, or is a state with dynamics of its own".to_owned(),
            ),
            Ill::Kink(text) => (
                "output",
                output,
                format!("{text} has a kink, abs, sign, min or max, and has to be differentiated"),
                "take a smooth function in its place: tanh(w/small) for sign(w)".to_owned(),
            ),
            Ill::Open(text) => (
                "output",
                output,
                format!("the relative degree is not decided: is {text} = 0 for all states?"),
                "write the model with fewer functions, or fix parameters under [params]".to_owned(),
            ),
            Ill::Unreached => (
                "output",
                output,
                format!("the input `{input}` does not reach the output"),
                "take an output that it moves, or give the states between them their dynamics".to_owned(),
            ),
            Ill::TooLarge(order) => (
                "output",
                output,
                format!("derivative {order} of the output is larger than an expression may be"),
                "take an output with a lower relative degree, or a simpler model".to_owned(),
            ),
        };
        self.found.push("bad-model", key, place, message, help);
    }
}
