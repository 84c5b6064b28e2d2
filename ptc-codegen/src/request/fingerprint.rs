//! The fingerprint of a design: a short name of everything that determines its emitted program.

use std::collections::BTreeMap;
use std::iter;

use super::{Clock, Promises, Spec};
use crate::model::Arm;

/// Hexadecimal digits of a fingerprint.
const DIGITS: usize = 12;

/// The one check whose permission the emitted program depends on: it sets the greatest value that `init` accepts.
const GROWTH: &str = "growth";

impl Spec {
    /// The fingerprint: equal for two designs whose emitted programs are the same in every language.
    ///
    /// Hashes the command that gives the design back, without the promises that do not affect the program, and with
    /// lists of numbers by their values.
    pub fn fingerprint(&self) -> String {
        let spec = self.clone().apart();
        let promises = spec.determining();
        let command = Self { promises, written: BTreeMap::new(), ..spec }.command();
        let robot = self.arm().map(Arm::identity);
        let hash = hash(iter::once(command.as_str()).chain(robot.as_deref()));
        let digits = format!("{:032x}", hash ^ (hash >> 64));
        digits[digits.len() - DIGITS..].to_owned()
    }

    /// The promises that change the program. With a clock in time none does; in samples an observer holds its gains
    /// where the measurement is known to be inexact.
    fn determining(&self) -> Promises {
        let own = &self.promises;
        let mut promises = Promises::default();
        promises.allow.extend(own.allow.iter().filter(|name| *name == GROWTH).cloned());
        if let Clock::Samples(sampled) = &self.clock {
            promises.sample_time.clone_from(&own.sample_time);
            promises.delay.clone_from(&own.delay);
            if sampled.observes() {
                promises.noise.clone_from(&own.noise);
                promises.noise_rms.clone_from(&own.noise_rms);
                promises.sensor_step.clone_from(&own.sensor_step);
            }
        }
        promises
    }
}

/// The 128-bit FNV-1a hash of texts, the same on any machine.
pub(crate) fn hash<'a>(texts: impl IntoIterator<Item = &'a str>) -> u128 {
    let step = |hash: u128, byte: &u8| {
        (hash ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b)
    };
    let offset = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    texts.into_iter().fold(offset, |hash, text| text.as_bytes().iter().fold(hash, step))
}

#[cfg(test)]
mod tests {
    use super::hash;

    #[test]
    fn hash_matches_published_values() {
        assert_eq!(hash([""]), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
        assert_eq!(hash(["a"]), 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964);
        assert_eq!(hash(["foo", "bar"]), 0x343e_1662_793c_64bf_6f0d_3597_ba44_6f18);
    }
}
