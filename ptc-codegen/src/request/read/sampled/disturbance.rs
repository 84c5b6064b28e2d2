//! The disturbance that an observer estimates: a constant, a ramp, or a sine of a known frequency.

use num_traits::Signed;

use crate::diagnostic::near_miss;
use crate::expression::constant::real;
use crate::keys::KeyInfo;
use crate::linear::Disturbance;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::request::read::values::suggestion;
use crate::request::read::{Reader, shown};
use crate::syntax::{Argument, Node, Value};

const KEY: &str = "disturbance";

impl Reader<'_> {
    /// The disturbance, if there is one; an error for a mistake, which is noted: no observer is known then.
    pub(super) fn disturbance(&mut self, spec: &Spec) -> Result<Option<Disturbance>, ()> {
        let Some(node) = self.keys.get(KEY).copied() else { return Ok(None) };
        let frequency = match &node.value {
            Value::Word(word) if word == "none" => return Ok(None),
            Value::Word(word) if word == "constant" => return Ok(Some(Disturbance::Constant)),
            Value::Word(word) if word == "ramp" => return Ok(Some(Disturbance::Ramp)),
            Value::Call(word, arguments) if word == "sine" => of_sine(arguments),
            _ => None,
        };
        let omega = frequency.and_then(real);
        let omega = omega.as_ref().and_then(Fixed::number).filter(|omega| omega.is_positive());
        let Some(omega) = omega else {
            let message =
                format!("disturbance = {} is not one that is estimated", shown(&node.value));
            let meant = near_miss(&node.value.to_string(), ["constant", "ramp", "none"]);
            let legal = KeyInfo::find(KEY).map_or("", |info| info.legal);
            let help = suggestion(meant, &format!("legal: {legal}"));
            self.wrong(KEY, Some(node.place), message, help);
            return Err(());
        };
        self.sampled_sine(spec, node, Disturbance::Sine(omega.clone())).map(Some).ok_or(())
    }

    /// A sine that its samples tell from a slower one.
    fn sampled_sine(&mut self, spec: &Spec, node: &Node, sine: Disturbance) -> Option<Disturbance> {
        let Some(h) = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number) else {
            if !self.keys.contains_key("sample_time") {
                let message = format!("disturbance = {sine} without `sample_time`");
                let help = "what it does within a sample is computed when the code is generated: give the period in s";
                self.wrong(KEY, Some(node.place), message, help.to_owned());
            }
            return None;
        };
        match sine.longest_period().filter(|longest| h >= longest) {
            Some(_) => {
                let message =
                    format!("disturbance = {sine} has fewer than two samples in a period");
                let help = "take a shorter sample_time; samples that far apart show a slower sine";
                self.wrong(KEY, Some(node.place), message, help.to_owned());
                None
            }
            None => Some(sine),
        }
    }
}

/// The frequency among the arguments of a sine.
fn of_sine(arguments: &[Argument]) -> Option<&Node> {
    match arguments {
        [Argument { name: None, value }] => Some(value),
        [Argument { name: Some((name, _)), value }] => (name == "omega").then_some(value),
        _ => None,
    }
}
