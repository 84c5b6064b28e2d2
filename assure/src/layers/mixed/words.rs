//! Numbers and lists of them in the words of a language.

use ptc_codegen::code::Shape;
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Precision;

/// Syntax of numbers and of lists of them in a language.
pub(super) struct Words {
    /// Type of a number.
    pub(super) real: &'static str,
    suffix: &'static str,
    nan: &'static str,
    infinity: &'static str,
    ends: [&'static str; 2],
}

impl Words {
    pub(super) fn of(language: Language, precision: Precision) -> Self {
        let single = precision == Precision::F32;
        let of_c = |ends| Self {
            real: if single { "float" } else { "double" },
            suffix: if single { "f" } else { "" },
            nan: "NAN",
            infinity: "INFINITY",
            ends,
        };
        match (language, single) {
            (Language::C, _) => of_c(["{", "}"]),
            (Language::Cpp, _) => of_c(["{{", "}}"]),
            (Language::Python, _) => {
                Self { real: "", suffix: "", nan: "nan", infinity: "inf", ends: ["[", "]"] }
            }
            (_, true) => Self {
                real: "f32",
                suffix: "",
                nan: "f32::NAN",
                infinity: "f32::INFINITY",
                ends: ["[", "]"],
            },
            (_, false) => Self {
                real: "f64",
                nan: "f64::NAN",
                infinity: "f64::INFINITY",
                ..Self::of(language, Precision::F32)
            },
        }
    }

    fn number(&self, value: f64) -> String {
        match value {
            value if value.is_nan() => self.nan.to_owned(),
            f64::INFINITY => self.infinity.to_owned(),
            value => format!("{value:?}{}", self.suffix),
        }
    }

    pub(super) fn list(&self, values: &[String]) -> String {
        let [open, close] = self.ends;
        format!("{open}{}{close}", values.join(", "))
    }

    /// A value of a shape.
    pub(super) fn value(&self, shape: Shape, values: &[f64]) -> String {
        let numbers: Vec<_> = values.iter().map(|value| self.number(*value)).collect();
        match shape {
            Shape::Count => format!("{}", values[0]),
            Shape::Lists(_, length) => {
                let rows: Vec<_> = numbers.chunks(length).map(|row| self.list(row)).collect();
                self.list(&rows)
            }
            Shape::Reals(_) => self.list(&numbers),
            _ => numbers.concat(),
        }
    }
}
