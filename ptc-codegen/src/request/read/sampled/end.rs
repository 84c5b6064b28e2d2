//! The law of least energy that takes over towards the end.

use num_traits::ToPrimitive;

use super::super::least_energy::is_least_energy;
use super::super::{Reader, items, shown, whole};
use crate::algebra::BigRational;
use crate::expression::constant::real;
use crate::parameter::Fixed;
use crate::request::{EndLaw, Exponents, LeastEnergy, MAX_SAMPLES, Spec};
use crate::syntax::Node;

/// Poles of the law that takes over.
const POLES: &str = "poles_end";

/// Samples to go from which on it is the law.
const SAMPLES: &str = "end_samples";

impl Reader<'_> {
    /// The end that a design gives its law.
    pub(super) fn end_law(
        &mut self,
        spec: &Spec,
        delay: usize,
        known: Option<(&BigRational, &Exponents)>,
    ) -> Option<EndLaw> {
        let [poles, samples] = [POLES, SAMPLES].map(|key| self.keys.get(key).copied());
        let (poles, samples) = match (poles, samples) {
            (None, None) => return None,
            (Some(poles), Some(samples)) => (poles, samples),
            (Some(node), None) | (None, Some(node)) => {
                let key = if poles.is_some() { POLES } else { SAMPLES };
                let message = "`poles_end` and `end_samples` belong together".to_owned();
                let help = "give both, poles_end = \"least-energy\" and the samples to go from which on it is the law, or neither".to_owned();
                self.wrong(key, Some(node.place), message, help);
                return None;
            }
        };
        if let Some(node) = self.keys.get("deadbeat").copied() {
            let message = "two ends of the law: `deadbeat` and `poles_end`".to_owned();
            let help = "leave one of them out".to_owned();
            self.wrong("deadbeat", Some(node.place), message, help);
            return None;
        }
        let Some((a, _)) = known else {
            let message = "`poles_end` beside gains that are left to run time".to_owned();
            let help = "give poles or gains, and a number for a".to_owned();
            self.wrong(POLES, Some(poles.place), message, help);
            return None;
        };
        let orders: Vec<_> = spec.designs().iter().map(|own| own.n + delay).collect();
        let law = match is_least_energy(poles) {
            true => self.named_law(POLES, poles),
            false => self.law_of_poles(poles, &orders, a),
        };
        Some(EndLaw { samples: self.end_samples(samples, &orders)?, law: law? })
    }

    fn end_samples(&mut self, node: &Node, orders: &[usize]) -> Option<u32> {
        let least = orders.iter().copied().max().unwrap_or(0);
        let value = real(node);
        let count = value.as_ref().and_then(Fixed::number);
        let count = count.and_then(|value| whole(value, MAX_SAMPLES as usize));
        let count = count.filter(|count| *count >= least).and_then(|count| count.to_u32());
        if count.is_none() {
            let message =
                format!("end_samples = {} is not a number of samples to go", shown(&node.value));
            let help = format!("give an integer of at least {least}, the order of the loop");
            self.wrong(SAMPLES, Some(node.place), message, help);
        }
        count
    }

    /// The law of poles that are given as numbers.
    fn law_of_poles(
        &mut self,
        node: &Node,
        orders: &[usize],
        a: &BigRational,
    ) -> Option<LeastEnergy> {
        let order = *orders.first()?;
        let exponent = |item: &Node| real(item).as_ref().and_then(Fixed::number).map(|p| -p / a);
        let exponents = items(node).iter().map(exponent).collect::<Option<Vec<_>>>();
        let law =
            exponents.filter(|_| orders.iter().all(|own| *own == order)).and_then(|mut all| {
                all.sort();
                let weight = all.first()? - BigRational::from_integer(order.into());
                let law = LeastEnergy { weight: weight.to_integer().to_u32()? };
                law.exponents(order).eq(all).then_some(law)
            });
        if law.is_none() {
            let message = "`poles_end` are not those of least energy".to_owned();
            let wanted = LeastEnergy { weight: 0 }.poles(order, a);
            let wanted: Vec<_> = wanted.iter().map(|pole| pole.re.to_string()).collect();
            let help = format!(
                "give consecutive multiples of -a from -{order} on, such as [{}], or \"least-energy(weight=W)\": the law has to end at rest",
                wanted.join(", ")
            );
            self.wrong(POLES, Some(node.place), message, help);
        }
        law
    }
}
