//! Words of the languages that differ from the name of a function.

use super::Function;

/// Notation of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Words {
    /// LaTeX before and after the argument, for `show`.
    #[cfg_attr(not(feature = "cli"), allow(dead_code))]
    pub(crate) latex: [&'static str; 2],
    /// True if Structured Text has it.
    pub(crate) structured_text: bool,
    /// True if Frama-C has a contract of the function of the C library.
    pub(crate) contract: bool,
}

const fn call(latex: &'static str) -> Words {
    fenced(latex, ")")
}

const fn fenced(before: &'static str, after: &'static str) -> Words {
    Words { latex: [before, after], structured_text: true, contract: true }
}

/// A function of the libraries of general languages alone.
const fn general(latex: &'static str) -> Words {
    Words { structured_text: false, contract: false, ..call(latex) }
}

impl Function {
    /// The words for it.
    pub(crate) fn words(self) -> Words {
        match self {
            Self::Abs => fenced("\\left|", "\\right|"),
            Self::Sign => call("\\operatorname{sgn}("),
            Self::Sqrt => fenced("\\sqrt{", "}"),
            Self::Exp => fenced("e^{", "}"),
            Self::Ln => call("\\ln("),
            Self::Sin => call("\\sin("),
            Self::Cos => call("\\cos("),
            Self::Tan => call("\\tan("),
            Self::Atan => call("\\arctan("),
            Self::Sinh => general("\\sinh("),
            Self::Cosh => general("\\cosh("),
            Self::Tanh => general("\\tanh("),
            Self::Atanh => general("\\operatorname{artanh}("),
            Self::Asin => call("\\arcsin("),
            Self::Acos => call("\\arccos("),
            Self::Cbrt => Words { latex: ["\\sqrt[3]{", "}"], ..general("") },
        }
    }
}
