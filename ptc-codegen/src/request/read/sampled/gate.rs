//! The gate of an observer: which readings it believes.

use num_traits::ToPrimitive;

use crate::expression::constant::real;
use crate::parameter::Fixed;
use crate::request::read::promises::finite_positive;
use crate::request::read::{Reader, shown};
use crate::request::{Gate, Guard, Sampled, Spec};

/// The keys of a gate.
const KEYS: [&str; 3] = ["innovation_max", "measurement_max", "coast"];

/// Most consecutive samples that an observer predicts alone.
const MAX_COAST: u32 = 65_535;

impl Reader<'_> {
    /// The gate of the observer of `sampled`.
    pub(super) fn gate(&mut self, spec: &Spec, sampled: &Sampled) -> Gate {
        let Some(key) = KEYS.into_iter().find(|key| self.keys.contains_key(key)) else {
            return Gate::default();
        };
        let legal = "finite and > 0";
        let mut bounds =
            |key| self.one_or_each(key, Some(sampled.measured), finite_positive, legal);
        let (innovation, range) = (bounds("innovation_max"), bounds("measurement_max"));
        let coast = self.coast();
        let place = self.keys.get(key).map(|node| node.place);
        if sampled.linear.is_none() && sampled.measured > 1 {
            let message = format!("`{key}` beside {} measured states", sampled.measured);
            let help = "the observer of a chain predicts the last one alone: measure x1 alone, or give the chain as A, B and C, whose observer predicts every measured value";
            self.wrong(key, place, message, help.to_owned());
        }
        if spec.guard == Guard::None {
            let message = format!("`{key}` with guard = none");
            let help = "a gate examines each reading: take guard = full".to_owned();
            self.wrong(key, place, message, help);
        }
        if !innovation.is_empty() && coast == Some(0) {
            let message = "`innovation_max` without `coast`".to_owned();
            let help = "give the number of consecutive samples for which the observer may predict alone, as in coast = 5";
            let place = self.keys.get("innovation_max").map(|node| node.place);
            self.wrong("innovation_max", place, message, help.to_owned());
        }
        Gate { innovation, range, coast: coast.unwrap_or_default() }
    }

    /// Consecutive samples on prediction alone; on failure, records a diagnostic.
    fn coast(&mut self) -> Option<u32> {
        let Some(node) = self.keys.get("coast").copied() else { return Some(0) };
        let value = real(node).as_ref().and_then(Fixed::number).cloned();
        let whole = value.filter(|value| value.is_integer()).and_then(|value| value.to_u32());
        let legal = whole.filter(|count| *count <= MAX_COAST);
        if legal.is_none() {
            let message = format!("coast = {} is not a number of samples", shown(&node.value));
            let help = format!("give an integer 0..={MAX_COAST}");
            self.wrong("coast", Some(node.place), message, help);
        }
        legal
    }
}
