//! Groups of the keys, in which help and the file of every key list them.

use super::KeyInfo;

/// Keys of one subject. The two lists are disjoint, and every key is in one group.
#[derive(Debug)]
pub struct Group {
    /// Heading.
    pub title: &'static str,
    /// Keys that most designs need.
    common: &'static [&'static str],
    /// Keys that few designs need: `--help` omits their flags.
    rare: &'static [&'static str],
}

/// All groups, in the order in which they are listed.
pub static GROUPS: [Group; 7] = [
    Group {
        title: "Code",
        common: &["name", "precision"],
        rare: &["units", "what", "guard", "fma", "latency"],
    },
    Group {
        title: "Plant",
        common: &["n", "axes", "g", "f", "reference"],
        rare: &[
            "states", "input", "output", "dynamics", "let", "inputs", "outputs", "inertia", "bias",
            "A", "B", "C",
        ],
    },
    Group {
        title: "Law",
        common: &["mu", "clock", "poles", "gains", "tau", "eps", "u_max"],
        rare: &[
            "kappa",
            "pi0",
            "t0",
            "u_min",
            "limits",
            "after",
            "delay_law",
            "poles_end",
            "end_samples",
            "gain_bytes",
            "deadbeat",
            "late",
            "pace",
            "state_max",
            "reserve",
            "in_flight",
            "keep_below",
            "keep_above",
            "keep_poles",
            "keep_tolerance",
        ],
    },
    Group {
        title: "Loop",
        common: &["sample_time", "delay", "sensor_step", "noise"],
        rare: &["noise_rms", "u_step", "g_error", "jitter"],
    },
    Group {
        title: "Observer",
        common: &["measured", "disturbance", "observer_poles", "observer_samples"],
        rare: &[
            "observer",
            "disturbance_walk",
            "observer_eps",
            "after_observer",
            "innovation_max",
            "measurement_max",
            "coast",
        ],
    },
    Group {
        title: "Robot",
        common: &["urdf"],
        rare: &[
            "base",
            "tip",
            "gravity",
            "payload",
            "rotor",
            "damping",
            "friction",
            "friction_width",
        ],
    },
    Group {
        title: "Checks",
        common: &["x0_max", "error", "allow"],
        rare: &["x_max", "margin_gain", "margin_delay"],
    },
];

impl Group {
    /// Returns its keys, the common ones first.
    pub fn keys(&self) -> impl Iterator<Item = &'static KeyInfo> {
        self.common.iter().chain(self.rare).filter_map(|key| KeyInfo::find(key))
    }

    /// Returns true if few designs need `key`.
    pub fn is_rare(&self, key: &KeyInfo) -> bool {
        self.rare.contains(&key.key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::KEYS;

    #[test]
    fn groups_list_every_key_once() {
        let mut grouped: Vec<_> = GROUPS.iter().flat_map(Group::keys).map(|key| key.key).collect();
        let listed = GROUPS.iter().map(|group| group.common.len() + group.rare.len());
        assert_eq!(listed.sum::<usize>(), grouped.len(), "a name of a group is not a key");
        let mut keys: Vec<_> = KEYS.iter().map(|key| key.key).collect();
        grouped.sort_unstable();
        keys.sort_unstable();
        assert_eq!(grouped, keys);
    }
}
