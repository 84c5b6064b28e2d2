//! The key `in_flight` with a clock in time: a duration that changes.

use super::Reader;
use crate::parameter::Parameter;
use crate::request::Spec;

impl Reader<'_> {
    /// Reads whether the duration changes in flight.
    pub(super) fn duration(&mut self, spec: &mut Spec) {
        let asked = self.choice("in_flight", &[("true", true), ("false", false)]);
        if asked != Some(true) {
            return;
        }
        if spec.fixed.contains_key(&Parameter::Tau) && !self.runs {
            let place = self.keys.get("in_flight").map(|node| node.place);
            let message = "`in_flight` = true beside a tau that is fixed in the code".to_owned();
            let help = "leave `tau` out of the design: `init` takes it at run time, and `arm_for` changes it; `simulate` and `verify` are given it beside the design";
            self.wrong("in_flight", place, message, help.to_owned());
        }
        spec.in_flight = true;
    }
}
