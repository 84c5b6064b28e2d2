//! Keys of the table `[plant]`.

use super::KeyInfo;

/// The keys of the table `[plant]` that are no symbols.
pub static PLANT_KEYS: [KeyInfo; 7] = [
    KeyInfo {
        key: "f",
        meaning: "drift f of the plant xn' = f + g*u; default: that of the controller",
        legal: "an expression in x1..xn, u and t",
        example: "-0.4*x2 + 0.1*sin(3*t)",
    },
    KeyInfo {
        key: "g",
        meaning: "true input gain of the plant; default: that of the controller",
        legal: "an expression in x1..xn and t",
        example: "0.8",
    },
    KeyInfo {
        key: "dynamics",
        meaning: "with a model, the rates of the plant that differ from those of the model",
        legal: "an expression for each of these states, in the states, the input and t",
        example: "{ w = \"(k*i - b*w - load)/J\" }",
    },
    KeyInfo {
        key: "states",
        meaning: "names of the states of a plant that has others than the law; its rates are `dynamics`, or A and B, and A, B, C under [plant] are then its own",
        legal: "names, at least as many as states of the law and at most 16",
        example: "motor,load,motor_speed,load_speed",
    },
    KeyInfo {
        key: "added",
        meaning: "what is added to A x + B u of a plant with `states`: friction, loads",
        legal: "an expression for some of the states, in the states, u and t",
        example: "{ load_speed = \"-coulomb*sign(load_speed)\" }",
    },
    KeyInfo {
        key: "outputs",
        meaning: "outputs of a plant with `states`: x1..xn of the law, in place of C",
        legal: "an expression in the states and t for each",
        example: "motor, motor_speed",
    },
    KeyInfo {
        key: "resonance",
        meaning: "one resonance that the law does not know: motor and load, joined by a spring",
        legal: "frequency_hz > 0, damping >= 0 (ratio) and inertia_ratio > 0 (load over motor), each a number or [lower, upper]; measured: \"motor\" or \"load\"; f: the side on which f acts, \"load\" if not given",
        example: "{ frequency_hz = [30, 60], damping = 0.02, inertia_ratio = 3, measured = \"motor\" }",
    },
];
