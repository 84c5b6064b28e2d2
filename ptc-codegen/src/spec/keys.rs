//! The keys of a spec: one table that feeds the reader, the help, the docs and the diagnostics.

/// A key of a spec.
#[derive(Clone, Copy, Debug)]
pub struct KeyInfo {
    /// Name, in the macro; the flag on the command line is `--` with `-` for `_`.
    pub key: &'static str,
    /// Meaning.
    pub meaning: &'static str,
    /// What is legal.
    pub legal: &'static str,
    /// An example of the value as it is written on the command line.
    pub example: &'static str,
}

/// All keys, in the order in which they are told.
pub static KEYS: [KeyInfo; 10] = [
    KeyInfo {
        key: "n",
        meaning: "order of the chain of integrators",
        legal: "an integer 1..=16",
        example: "3",
    },
    KeyInfo {
        key: "mu",
        meaning: "time mapping, with its parameters where they are fixed",
        legal: "a family: exp, rational, power, tan, tanh, algebraic, exp_sum",
        example: "exp(a=1)",
    },
    KeyInfo {
        key: "name",
        meaning: "name of the controller: prefix of every emitted symbol, stem of the files",
        legal: "an identifier of at most 48 letters, digits and _, no word of C or Rust",
        example: "roll",
    },
    KeyInfo {
        key: "precision",
        meaning: "floating-point type",
        legal: "f64 or f32",
        example: "f32",
    },
    KeyInfo {
        key: "guard",
        meaning: "run-time checks of the inputs",
        legal: "full, result or none",
        example: "none",
    },
    KeyInfo {
        key: "gains",
        meaning: "gains k_1..k_n of the law pi0 = -sum k_i xi_i",
        legal: "n finite numbers",
        example: "120,74,15",
    },
    KeyInfo {
        key: "tau",
        meaning: "prescribed settling time in s",
        legal: "a number > 0",
        example: "2",
    },
    KeyInfo { key: "t0", meaning: "start time in s", legal: "a finite number", example: "0" },
    KeyInfo {
        key: "eps",
        meaning: "time-to-go in s at which the gains are held",
        legal: "a number > 0 and < tau",
        example: "1e-3",
    },
    KeyInfo {
        key: "u_max",
        meaning: "bound of |u|; inf leaves the clipping out",
        legal: "a number > 0, or inf",
        example: "5",
    },
];

impl KeyInfo {
    /// The key called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        KEYS.iter().find(|info| info.key == name)
    }
}
