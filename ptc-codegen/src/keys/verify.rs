//! The keys of what is verified, with what they mean.

use super::KeyInfo;

/// A key of the table `[disturbance]`: the symbol of the plant that varies.
pub static DISTURBANCE: KeyInfo = KeyInfo {
    key: "gust",
    meaning: "how an uncertain symbol of [plant] varies within its bounds, by its name",
    legal: "constant, sine, square, random, worst, a list of these, or any",
    example: "any",
};

/// A key x1..xn of the table `[verify]`.
pub static INITIAL_STATE: KeyInfo = KeyInfo {
    key: "x1",
    meaning: "interval of the initial state, one for each of x1..xn, or of the states of a model",
    legal: "[lower, upper] in the unit of x1, or a number",
    example: "-1,1",
};

/// A key of the table `[verify]` that is a parameter of mapping or law.
pub static PARAMETER: KeyInfo = KeyInfo {
    key: "k1",
    meaning: "interval of a parameter of mapping or law, by its name: a, m, start, a1.., k1..kn or one of your own, where the design does not fix it; default: its bounds under [params]",
    legal: "[lower, upper] within its domain, or a number",
    example: "18,22",
};

/// The keys of the table `[verify]` beside states and parameters.
pub static KEYS: [KeyInfo; 7] = [
    KeyInfo {
        key: "tau",
        meaning: "interval of the prescribed settling time; default: the tau of the design",
        legal: "[lower, upper] in s, both > 0, or a number",
        example: "0.5,2",
    },
    KeyInfo {
        key: "t0",
        meaning: "interval of the start time; the t0 of the design, or 0, where it is not given",
        legal: "[lower, upper] in s, or a number",
        example: "0,5",
    },
    KeyInfo {
        key: "scenarios",
        meaning: "number of scenarios to draw; default: 10000",
        legal: "an integer from 1 to 1e12",
        example: "10000",
    },
    KeyInfo {
        key: "seed",
        meaning: "seed of all scenarios; default: 0",
        legal: "an integer from 0 to 2^53",
        example: "7",
    },
    KeyInfo {
        key: "search",
        meaning: "maximum number of runs of the search for the worst case, per objective; default: 2000",
        legal: "an integer from 0 to 1e9",
        example: "2000",
    },
    KeyInfo {
        key: "until",
        meaning: "T/tau at which a run ends; default: 1e-3, or eps/tau if larger; with a sample period 0, the deadline, and negative after it",
        legal: "a number > 0 and < 1; with a sample period one from -100 on",
        example: "1e-3",
    },
    KeyInfo {
        key: "tolerance",
        meaning: "maximum difference of both sides of Theorem 1, relative to the largest value of a run; default: 1e-6",
        legal: "a number > 0",
        example: "1e-6",
    },
];

/// The keys of a table `[[objective]]`.
pub static OBJECTIVE_KEYS: [KeyInfo; 8] = [
    KeyInfo {
        key: "bound",
        meaning: "what is bounded",
        legal: "state, input, attractive or within",
        example: "state",
    },
    KeyInfo {
        key: "sigma",
        meaning: "of state: |x| <= sigma |x0| zeta",
        legal: "a number > 0",
        example: "4",
    },
    KeyInfo {
        key: "zeta",
        meaning: "of state: shape over time; default: 1",
        legal: "an expression in dt, T, t",
        example: "T/tau",
    },
    KeyInfo {
        key: "upsilon",
        meaning: "of input: |u| <= upsilon",
        legal: "an expression in dt, T, t; with several inputs also a list of one for each",
        example: "5*T/tau",
    },
    KeyInfo {
        key: "error",
        meaning: "of attractive: |x| <= error at the end",
        legal: "a number > 0, or a list of one for each state",
        example: "1e-3",
    },
    KeyInfo {
        key: "h",
        meaning: "of within: low <= h <= high",
        legal: "an expression in x1..xn, u, dt, T, t; integral(e) is that of e over time since t0",
        example: "x1 + x2",
    },
    KeyInfo {
        key: "low",
        meaning: "of within: lower bound of h",
        legal: "an expression in dt, T, t",
        example: "-1",
    },
    KeyInfo {
        key: "high",
        meaning: "of within: upper bound of h",
        legal: "an expression in dt, T, t",
        example: "1",
    },
];
