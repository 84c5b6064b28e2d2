//! The gains of least energy of a linear plant.

use num_traits::ToPrimitive;

use super::super::least_energy::is_least_energy;
use super::super::{Reader, shown, whole};
use crate::expression::constant::real;
use crate::limits::GAINS;
use crate::linear::{Unscheduled, Weights};
use crate::parameter::{Fixed, Parameter, Precision};
use crate::request::{LeastEnergy, Sampled, Spec};
use crate::syntax::Node;

/// The bytes that the table may take.
const BYTES: &str = "gain_bytes";

/// Greatest weight beside A and B; with a greater one u is 0 for most of the time.
const MOST_WEIGHT: u32 = 100;

impl Reader<'_> {
    /// Gives a linear plant whose poles are those of least energy a table of gains in place of a law of poles.
    pub(super) fn schedule(&mut self, spec: &mut Spec, sampled: &Sampled) {
        let node = self.keys.get("poles").copied().filter(|node| is_least_energy(node));
        let (Some(node), Some(_)) = (node, &sampled.linear) else {
            return self.no_table();
        };
        // Poles that could not be read have been refused.
        if spec.poles.is_empty() {
            return;
        }
        let (Some(law), Some(bytes)) = (self.named_law("poles", node), self.gain_bytes()) else {
            return;
        };
        let end = sampled.end.map(|end| (end.samples, end.law.weight));
        let greatest = end.map_or(law.weight, |(_, weight)| weight.max(law.weight));
        if greatest > MOST_WEIGHT {
            let message = format!("weight = {greatest} beside A and B");
            let help = format!("give a weight of at most {MOST_WEIGHT}");
            return self.wrong("poles", Some(node.place), message, help);
        }
        self.decides_all(spec);
        let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
        let samples = number(Parameter::Samples).and_then(ToPrimitive::to_u32);
        if let Some(samples) = samples.filter(|samples| !GAINS.admits(*samples as usize)) {
            let message =
                GAINS.exceeded("the law of least energy beside A and B", samples as usize);
            return self.wrong("poles", Some(node.place), message, GAINS.fix.to_owned());
        }
        let weights = Weights { law: law.weight, end };
        match sampled.gains(spec, weights, bytes) {
            Some(Ok(schedule)) => spec.follow(schedule),
            Some(Err(reason)) => self.has_no_table(reason, node, spec.precision),
            // A period or a tau that is wrong has been refused by itself.
            None if self.found.is_empty() => {
                let message = "least energy beside A and B without a number for tau".to_owned();
                let help = "fix tau: the gains are computed when the code is generated".to_owned();
                self.wrong("tau", Some(node.place), message, help);
            }
            None => {}
        }
    }

    /// Refuses a law whose gains cannot be computed or kept.
    fn has_no_table(&mut self, reason: Unscheduled, poles: &Node, precision: Precision) {
        match reason {
            Unscheduled::Digits => {
                let message = "the gains of least energy lose all digits".to_owned();
                let help = "modes of A are too far apart for this tau: give a shorter tau, or leave the fastest mode out of the plant".to_owned();
                self.wrong("poles", Some(poles.place), message, help);
            }
            Unscheduled::Numbers(least) => {
                let node = self.keys.get(BYTES).copied();
                let given = node.map(|node| shown(&node.value)).unwrap_or_default();
                let message = format!("{BYTES} = {given} is too little for its table");
                let help = format!(
                    "the coarsest one takes {} bytes; without {BYTES} it takes what the law needs",
                    least * precision.bytes()
                );
                self.wrong(BYTES, node.map(|node| node.place), message, help);
            }
        }
    }

    /// Refuses the bytes of a table where there is none.
    fn no_table(&mut self) {
        if let Some(node) = self.keys.get(BYTES).copied() {
            let message = format!("`{BYTES}` without a table of gains");
            let help = format!(
                "it limits the gains of poles = \"{}\" beside A and B: leave it out",
                LeastEnergy::NAME
            );
            self.wrong(BYTES, Some(node.place), message, help);
        }
    }

    /// Refuses what leaves a part of the table to run time, or ends it otherwise.
    fn decides_all(&mut self, spec: &Spec) {
        // Two ends of the law are refused by themselves.
        let deadbeat = self.keys.get("deadbeat").copied();
        if let Some(node) = deadbeat.filter(|_| !self.keys.contains_key("poles_end")) {
            let message = "`deadbeat` beside the gains of least energy".to_owned();
            let help = "leave it out: the last of these gains are deadbeat".to_owned();
            self.wrong("deadbeat", Some(node.place), message, help);
        }
        if spec.bounds.contains_key(&Parameter::Eps) {
            let place = self.keys.get("eps").map(|node| node.place);
            let message = "eps at run time beside the gains of least energy".to_owned();
            let help = "give one number: the table is made when the code is generated".to_owned();
            self.wrong("eps", place, message, help);
        }
    }

    /// The bytes that the table may take, none where nothing limits it; `None` for a mistake, which is noted.
    #[allow(clippy::option_option)]
    fn gain_bytes(&mut self) -> Option<Option<u32>> {
        let Some(node) = self.keys.get(BYTES).copied() else { return Some(None) };
        let value = real(node);
        let count = value.as_ref().and_then(Fixed::number);
        let count = count.and_then(|value| whole(value, 1 << 24)).filter(|count| *count > 0);
        if count.is_none() {
            let message = format!("{BYTES} = {} is not a number of bytes", shown(&node.value));
            let help = format!("give an integer from 1 to {}", 1 << 24);
            self.wrong(BYTES, Some(node.place), message, help);
        }
        count.map(|count| u32::try_from(count).ok())
    }
}
