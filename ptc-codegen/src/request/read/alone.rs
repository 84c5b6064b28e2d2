//! An observer alone: what it must be given, and what a law alone has a meaning for.

use num_traits::Zero;

use super::{Reader, shown, whole};
use crate::algebra::BigRational;
use crate::expression::constant::real;
use crate::parameter::{Fixed, Parameter};
use crate::request::{After, Clock, DelayLaw, Promises, Spec};

/// The keys of a law, and what stands for each with an observer.
const OF_LAW: [(&str, &str); 17] = [
    ("tau", "the estimates are exact from sample `observer_samples` on"),
    ("eps", "`observer_eps` holds the gains of an observer"),
    ("u_max", "the observer is given u as it was applied"),
    ("u_min", "the observer is given u as it was applied"),
    ("after", "`after_observer` says what follows sample `observer_samples`"),
    ("deadbeat", "an observer takes it from its poles"),
    ("delay_law", "an observer keeps the inputs under way for any law"),
    ("poles_end", "an observer ends in deadbeat or by `observer_eps`"),
    ("end_samples", "an observer ends in deadbeat or by `observer_eps`"),
    ("gain_bytes", "an observer has no gains of least energy"),
    ("in_flight", "an observer alone has no deadline"),
    ("late", "an observer alone has no deadline"),
    ("pace", "an observer alone has no deadline"),
    ("state_max", "an observer alone moves no state"),
    ("reserve", "an observer alone has no limits"),
    ("error", "no check judges an observer alone"),
    ("reference", "an observer estimates the state itself"),
];

impl Reader<'_> {
    /// The end of the round of an observer alone, which has no deadline to take half of.
    pub(super) fn samples_alone(
        &mut self,
        spec: &Spec,
        estimates: usize,
        most: u32,
    ) -> Option<u32> {
        let legal = format!("an integer {estimates}..={most}");
        let Some(node) = self.keys.get("observer_samples").copied() else {
            let half = |all: &BigRational| (all / BigRational::from_integer(2.into())).floor();
            let all = spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
            let help = match all.map(half).filter(|half| !half.is_zero()) {
                Some(half) => format!("give {legal}; that of the controller takes {half}"),
                None => format!("give {legal}: the sample from which the estimates are exact"),
            };
            let message = "`observer_samples` is missing".to_owned();
            self.found.push("missing-key", "observer_samples", None, message, help);
            return None;
        };
        let value = real(node).as_ref().and_then(Fixed::number).cloned();
        match value.and_then(|value| whole(&value, most as usize)) {
            Some(count) if count >= estimates => u32::try_from(count).ok(),
            _ => {
                let message = format!("observer_samples = {}", shown(&node.value));
                self.wrong("observer_samples", Some(node.place), message, format!("give {legal}"));
                None
            }
        }
    }

    /// Refuses an observer of what is measured.
    pub(super) fn nothing_to_estimate(&mut self) {
        let key = if self.keys.contains_key("C") { "C" } else { "measured" };
        let place = self.keys.get(key).or(self.keys.get("what")).map(|node| node.place);
        let message = "every state is measured: there is nothing to observe".to_owned();
        let help = "name what is measured, measured = x1 or C of a linear plant, or estimate a force: disturbance = constant";
        self.wrong(key, place, message, help.to_owned());
    }

    /// Leaves in a spec what its observer is made of. What the design of a controller says of its
    /// law has been read, and has no part in it; where there is no law, it is a mistake.
    pub(super) fn observer_alone(&mut self, spec: &mut Spec) {
        let has_law = ["poles", "gains", "pi0"].iter().any(|key| self.keys.contains_key(key));
        for (key, help) in OF_LAW {
            if let Some(node) = self.keys.get(key).copied().filter(|_| !has_law) {
                let message = format!("`{key}` is of a law, and an observer alone has none");
                let help = format!(
                    "leave it out: {help}; beside `poles` or `gains` it may stay in the design of a controller"
                );
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
        spec.fixed.retain(|parameter, _| matches!(parameter, Parameter::SampleTime | Parameter::A));
        if let Clock::Samples(sampled) = &mut spec.clock {
            (sampled.end, sampled.delay_law) = (None, DelayLaw::Extend);
            sampled.flight = None;
        }
        spec.u_min = false;
        spec.poles.clear();
        spec.written.remove("poles");
        spec.after = After::Hold;
        spec.reference = None;
        let promises = std::mem::take(&mut spec.promises);
        spec.promises = Promises {
            sample_time: promises.sample_time,
            noise: promises.noise,
            noise_rms: promises.noise_rms,
            sensor_step: promises.sensor_step,
            delay: promises.delay,
            ..Promises::default()
        };
    }
}
