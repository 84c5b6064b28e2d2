//! Keys of the tables `[[event]]`, of `simulate` and `verify`.

use super::{KeyInfo, SWITCH};

/// The keys of an event of a run.
pub static EVENT_KEYS: [KeyInfo; 6] = [
    KeyInfo {
        key: "at",
        meaning: "when it happens: the next sample from this time after t0 on, in s",
        legal: "a number >= 0; in `verify` also [lower, upper], as all numbers of an event",
        example: "0.4",
    },
    KeyInfo {
        key: "tau",
        meaning: "time from there to a new deadline, in s; with in_flight or late",
        legal: "a number > 0, or [lower, upper]",
        example: "0.6",
    },
    KeyInfo {
        key: "move",
        meaning: "how far the target of x1 moves, which the observer is told",
        legal: "a number, or [lower, upper]; with axes a list of them",
        example: "0.05",
    },
    KeyInfo {
        key: "kick",
        meaning: "a force that is added to u, for the time `for`",
        legal: "a number, or [lower, upper]; with axes a list of them",
        example: "2",
    },
    KeyInfo {
        key: "for",
        meaning: "how long the kick lasts, in s",
        legal: "a number > 0, or [lower, upper]",
        example: "0.01",
    },
    KeyInfo {
        key: "arm",
        meaning: "whether the controller is armed again, with tau of the design",
        legal: SWITCH,
        example: "true",
    },
];
