//! Poles of least energy, by name: `least-energy`, `least-energy(weight=2)`.

use num_traits::Zero;

use super::{Reader, shown, whole};
use crate::algebra::{BigRational, integer};
use crate::expression::constant::real;
use crate::parameter::Fixed;
use crate::request::EndLaw;
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
    /// Returns the weight of poles of least energy; `None` for a mistake, which is noted.
    pub(super) fn weight(&mut self, key: &'static str, node: &Node) -> Option<u32> {
        let (name, value) = match arguments(node)? {
            [] => return Some(0),
            [Argument { name, value }] => (name.as_ref().map(|(name, _)| name.as_str()), value),
            [_, second, ..] => (Some("weight"), &second.value),
        };
        let count = real(value)
            .as_ref()
            .and_then(Fixed::number)
            .and_then(|v| whole(v, EndLaw::MAX_WEIGHT as usize));
        let named = name.is_none_or(|name| name == "weight");
        let weight = count.filter(|_| named && arguments(node).is_some_and(|all| all.len() == 1));
        if weight.is_none() {
            let message = format!("{} is not the weight of least energy", shown(&value.value));
            let help = format!(
                "{key} = least-energy(weight=W), with an integer W from 0 to {}",
                EndLaw::MAX_WEIGHT
            );
            self.wrong(key, Some(value.place), message, help);
        }
        weight.and_then(|weight| u32::try_from(weight).ok())
    }

    /// Refuses the name for a law beside A and B, which is that of a flat output. At the end its poles stand for rest.
    pub(super) fn least_energy_of_states(&mut self) {
        let node = self.keys.get("poles").copied().filter(|node| is_least_energy(node));
        if let Some(node) = node {
            let message = "least energy beside A and B".to_owned();
            let help = "give the poles as numbers: they are those of a flat output, whose energy is not that of u".to_owned();
            self.wrong("poles", Some(node.place), message, help);
        }
    }

    /// Returns the poles of least energy of a loop of order `n`: p = n + weight, n + weight + 1, ... times -a.
    pub(super) fn least_energy(
        &mut self,
        key: &'static str,
        n: usize,
        node: &Node,
    ) -> Option<Vec<(BigRational, BigRational)>> {
        let weight = self.weight(key, node)?;
        let Some(a) = self.rate.clone() else {
            if self.mapping_is_read {
                let message = "least energy has poles for mu = exp with a number for a".to_owned();
                let help = "give mu = exp(a=1), or the poles as numbers".to_owned();
                self.wrong(key, Some(node.place), message, help);
            }
            return None;
        };
        let first = integer(i64::from(weight)) + BigRational::from_integer(n.into());
        let pole = |i: i64| (-(&first + integer(i)) * &a, BigRational::zero());
        Some((0..).take(n).map(pole).collect())
    }
}
