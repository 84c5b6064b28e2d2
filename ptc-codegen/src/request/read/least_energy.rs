//! Poles of least energy, by name: `least-energy`, `least-energy(weight=2)`.

use super::{Reader, shown, whole};
use crate::algebra::BigRational;
use crate::expression::constant::real;
use crate::parameter::Fixed;
use crate::request::LeastEnergy;
use crate::syntax::{Argument, Node, Operator, Value};

/// Returns true if a value names the poles of least energy, whatever its arguments are.
pub(super) fn is_least_energy(node: &Node) -> bool {
    arguments(node).is_some()
}

/// The arguments of the name.
fn arguments(node: &Node) -> Option<&[Argument]> {
    let Value::Binary(Operator::Sub, least, energy) = &node.value else { return None };
    let is_least = matches!(&least.value, Value::Word(word) if word == "least");
    match &energy.value {
        Value::Word(word) if is_least && word == "energy" => Some(&[]),
        Value::Call(word, arguments) if is_least && word == "energy" => Some(arguments),
        _ => None,
    }
}

impl Reader<'_> {
    /// Returns the law that a value names; `None` for a mistake, which is noted.
    pub(super) fn named_law(&mut self, key: &'static str, node: &Node) -> Option<LeastEnergy> {
        let (is_weight, value) = match arguments(node)? {
            [] => return Some(LeastEnergy { weight: 0 }),
            [Argument { name: None, value }] => (true, value),
            [Argument { name: Some((name, _)), value }] => (name == "weight", value),
            [_, second, ..] => (false, &second.value),
        };
        let most = LeastEnergy::MAX_WEIGHT;
        let weight = real(value).filter(|_| is_weight);
        let weight = weight.as_ref().and_then(Fixed::number);
        let weight = weight.and_then(|weight| whole(weight, most as usize));
        let Some(weight) = weight.and_then(|weight| u32::try_from(weight).ok()) else {
            let message = format!("{} is not the weight of least energy", shown(&value.value));
            let help =
                format!("{key} = least-energy(weight=W), with an integer W from 0 to {most}");
            self.wrong(key, Some(value.place), message, help);
            return None;
        };
        Some(LeastEnergy { weight })
    }

    /// Returns the poles of least energy of a loop of order `n`.
    pub(super) fn least_energy(
        &mut self,
        key: &'static str,
        n: usize,
        node: &Node,
    ) -> Option<Vec<(BigRational, BigRational)>> {
        let law = self.named_law(key, node)?;
        let Some(a) = &self.rate else {
            if self.mapping_is_read {
                let message = "least energy has poles for mu = exp with a number for a".to_owned();
                let help = "give mu = exp(a=1), or the poles as numbers".to_owned();
                self.wrong(key, Some(node.place), message, help);
            }
            return None;
        };
        Some(law.poles(n, a).into_iter().map(|pole| (pole.re, pole.im)).collect())
    }
}
