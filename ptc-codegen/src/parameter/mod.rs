//! The parameters of a controller, their names, domains and fixed values.

mod name;
mod reserved;

pub use name::{Name, type_name};
pub(crate) use reserved::{is_reserved, reason};

use std::fmt;

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::{BigInt, BigRational, Kind, Symbol};

/// Floating-point type of the emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// IEEE 754 binary32.
    F32,
    /// IEEE 754 binary64.
    F64,
}

impl Precision {
    /// Its name, as a key's value and in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Returns the number nearest to a double.
    #[inline]
    #[allow(clippy::cast_possible_truncation)]
    pub fn rounded(self, value: f64) -> f64 {
        match self {
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }

    /// Bytes of a number.
    pub fn bytes(self) -> usize {
        match self {
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Returns the test of the emitted C for a finite number.
    #[cfg(feature = "files")]
    pub(crate) fn finite_in_c(self, number: &str) -> String {
        format!("PTC_FINITE_{}({number})", self.name().to_uppercase())
    }

    /// Returns the test of the emitted C for NaN.
    #[cfg(feature = "files")]
    pub(crate) fn nan_in_c(self, number: &str) -> String {
        format!("PTC_NAN_{}({number})", self.name().to_uppercase())
    }

    /// Its greatest finite number.
    pub fn greatest(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::MAX),
            Self::F64 => f64::MAX,
        }
    }

    /// Its least positive number that has all digits.
    pub(crate) fn least_normal(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::MIN_POSITIVE),
            Self::F64 => f64::MIN_POSITIVE,
        }
    }

    /// The distance from 1 to its next number.
    pub(crate) fn epsilon(self) -> f64 {
        match self {
            Self::F32 => f64::from(f32::EPSILON),
            Self::F64 => f64::EPSILON,
        }
    }
}

/// A parameter: left to run time, or fixed when the code is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Parameter {
    /// Prescribed settling time tau.
    Tau,
    /// Start time t0.
    StartTime,
    /// Time-to-go at which the gains are held.
    Eps,
    /// Bound of |u|, or the upper limit of u beside `UMin`.
    UMax,
    /// Lower limit of u, where it is not -u_max.
    UMin,
    /// Rate a of stretched time.
    A,
    /// Exponent m of the power family.
    M,
    /// Rate of stretched time at the start of the soft family, in units of 1/(a tau).
    Start,
    /// Rate a_i of one term of `exp_sum`, from 1.
    Rate(usize),
    /// Gain k_i, from 1.
    Gain(usize),
    /// Samples N from the start to rest.
    Samples,
    /// Sample period h.
    SampleTime,
    /// Samples to go at which deadbeat takes over.
    Deadbeat,
    /// A parameter of the user's own expressions.
    Named(Name),
}

/// The values that a parameter may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Any finite number.
    Finite,
    /// A finite number > 0.
    Positive,
    /// A number > 0, or infinity.
    PositiveOrInfinite,
    /// A number below u_max, or -infinity.
    BelowUMax,
    /// A number above u_min, or infinity.
    AboveUMin,
    /// A number > 0 and < tau.
    BelowTau,
    /// A number within the bounds that the user gave.
    Within,
}

impl Domain {
    /// The domain in words.
    pub fn text(self) -> &'static str {
        match self {
            Self::Finite => "finite",
            Self::Positive => "finite, > 0",
            Self::PositiveOrInfinite => "> 0, infinity allowed",
            Self::BelowUMax => "< u_max, -infinity allowed",
            Self::AboveUMin => "> u_min, infinity allowed",
            Self::BelowTau => "> 0, < tau",
            Self::Within => "within its bounds",
        }
    }

    /// The least and the greatest value in a precision: between them the product and the quotient
    /// of any two of them are normal numbers, so that `step` keeps its digits. None where 0 or
    /// infinity is legal.
    pub fn ends(self, precision: Precision) -> Option<(f64, f64)> {
        match (self, precision) {
            (Self::Positive | Self::BelowTau, Precision::F64) => Some((1e-150, 1e150)),
            (Self::Positive | Self::BelowTau, Precision::F32) => {
                Some((f64::from(1e-18_f32), f64::from(1e18_f32)))
            }
            (
                Self::Finite
                | Self::PositiveOrInfinite
                | Self::BelowUMax
                | Self::AboveUMin
                | Self::Within,
                _,
            ) => None,
        }
    }

    /// Returns true if `value` lies in the domain, as far as it alone decides.
    pub fn admits(self, value: &Fixed) -> bool {
        match (self, value) {
            (Self::PositiveOrInfinite | Self::AboveUMin, Fixed::Infinite) => true,
            (Self::BelowUMax, Fixed::MinusInfinite) => true,
            (_, Fixed::Infinite | Fixed::MinusInfinite) => false,
            (
                Self::Finite | Self::Within | Self::BelowUMax | Self::AboveUMin,
                Fixed::Number { .. },
            ) => true,
            (_, Fixed::Number { value, .. }) => value.is_positive(),
        }
    }
}

impl Parameter {
    /// Key, in the spec, in diagnostics and in the emitted parameters.
    pub fn key(self) -> &'static str {
        match self {
            Self::Tau => "tau",
            Self::StartTime => "t0",
            Self::Eps => "eps",
            Self::UMax => "u_max",
            Self::UMin => "u_min",
            Self::A => "a",
            Self::M => "m",
            Self::Start => "start",
            Self::Rate(_) => "rates",
            Self::Gain(_) => "k",
            Self::Samples => "samples",
            Self::SampleTime => "h",
            Self::Deadbeat => "deadbeat",
            Self::Named(name) => name.text(),
        }
    }

    /// Returns true if it is a limit of u.
    pub fn is_limit(self) -> bool {
        matches!(self, Self::UMax | Self::UMin)
    }

    /// Its name in expressions, with its index: `tau`, `k1`.
    pub fn spelling(self) -> String {
        match self {
            Self::Gain(i) => format!("k{i}"),
            Self::Rate(i) => format!("a{i}"),
            parameter => parameter.key().to_owned(),
        }
    }

    /// Index from 0 in its array; none for a scalar.
    pub fn index(self) -> Option<usize> {
        match self {
            Self::Rate(i) | Self::Gain(i) => Some(i - 1),
            _ => None,
        }
    }

    /// Its symbol in the mathematics: `k_1`.
    pub fn symbol(self) -> String {
        match self {
            Self::Gain(i) => format!("k_{i}"),
            Self::Rate(i) => format!("a_{i}"),
            parameter => parameter.key().to_owned(),
        }
    }

    /// Unit, for every order n.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Tau | Self::StartTime | Self::Eps | Self::SampleTime => "s",
            Self::Samples | Self::Deadbeat => "samples",
            Self::UMax | Self::UMin => "unit of u",
            Self::A | Self::Rate(_) => "1/s",
            Self::M | Self::Start => "1",
            Self::Gain(_) => "1/s^(n+1-i)",
            Self::Named(_) => "as in its expression",
        }
    }

    /// Unit in a controller of order `n`.
    pub fn unit_for(self, n: usize) -> String {
        match self {
            Self::Gain(i) if i == n => "1/s".to_owned(),
            Self::Gain(i) => format!("1/s^{}", n + 1 - i),
            parameter => parameter.unit().to_owned(),
        }
    }

    /// Meaning of `UMax` beside `UMin`.
    pub(crate) const UPPER_LIMIT: &str = "upper limit of u";

    /// Meaning in a few words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Tau => "prescribed settling time",
            Self::StartTime => "start time",
            Self::Eps => "time-to-go at which the gains are held",
            Self::UMax => "bound of |u|",
            Self::UMin => "lower limit of u",
            Self::A => "rate of stretched time",
            Self::M => "exponent of the power mapping",
            Self::Start => "a tau kappa' at the start, of the soft mapping",
            Self::Rate(_) => "rates a_i of stretched time",
            Self::Gain(_) => "gains k_i of pi0 = -sum k_i xi_i",
            Self::Samples => "samples N from the start to rest",
            Self::SampleTime => "sample period",
            Self::Deadbeat => "samples to go at which deadbeat takes over, 0 for a safe default",
            Self::Named(_) => "parameter of an expression of the design",
        }
    }

    /// Legal values.
    pub fn domain(self) -> Domain {
        match self {
            Self::Tau
            | Self::A
            | Self::M
            | Self::Start
            | Self::Rate(_)
            | Self::SampleTime
            | Self::Samples => Domain::Positive,
            Self::StartTime | Self::Deadbeat | Self::Gain(_) | Self::Named(_) => Domain::Finite,
            Self::Eps => Domain::BelowTau,
            Self::UMax => Domain::PositiveOrInfinite,
            Self::UMin => Domain::BelowUMax,
        }
    }

    /// The parameter that a symbol of the closed forms stands for.
    pub fn of_symbol(symbol: Symbol) -> Option<Self> {
        let index = usize::from(symbol.index);
        match symbol.kind {
            Kind::Tau => Some(Self::Tau),
            Kind::A => Some(Self::A),
            Kind::M => Some(Self::M),
            Kind::Rate => Some(Self::Rate(index)),
            Kind::Gain => Some(Self::Gain(index)),
            _ => None,
        }
    }
}

/// A value fixed at generation: exact, and as it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fixed {
    /// A decimal number, taken as exact.
    Number {
        /// Its exact value.
        value: BigRational,
        /// Its spelling.
        text: String,
    },
    /// Infinity.
    Infinite,
    /// -Infinity.
    MinusInfinite,
}

impl Fixed {
    /// The exact value of a finite one.
    pub fn number(&self) -> Option<&BigRational> {
        match self {
            Self::Number { value, .. } => Some(value),
            Self::Infinite | Self::MinusInfinite => None,
        }
    }

    /// Returns true if it is below another one.
    pub(crate) fn is_below(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number { value, .. }, Self::Number { value: other, .. }) => value < other,
            (Self::Infinite, _) | (_, Self::MinusInfinite) => false,
            (Self::MinusInfinite, _) | (_, Self::Infinite) => true,
        }
    }

    /// The value with the other sign.
    pub(crate) fn opposite(&self) -> Self {
        match self {
            Self::Number { value, text } => {
                let text = match text.strip_prefix('-') {
                    Some(text) => text.to_owned(),
                    None => format!("-{text}"),
                };
                Self::Number { value: -value, text }
            }
            Self::Infinite => Self::MinusInfinite,
            Self::MinusInfinite => Self::Infinite,
        }
    }

    /// The number nearest to a finite one in `precision`, up to a second rounding in f32.
    pub(crate) fn rounded(&self, precision: Precision) -> Option<f64> {
        Some(precision.rounded(self.number()?.to_f64()?))
    }

    /// Returns true if the value is a nonzero number that `precision` rounds to zero or infinity.
    pub fn leaves(&self, precision: Precision) -> bool {
        let Some(value) = self.number() else { return false };
        let rounded = precision.rounded(value.to_f64().unwrap_or(f64::INFINITY));
        !rounded.is_finite() || (rounded == 0.0 && !value.is_zero())
    }
}

impl From<i32> for Fixed {
    fn from(value: i32) -> Self {
        let one = BigRational::one();
        Self::Number { value: one * BigInt::from(value), text: value.to_string() }
    }
}

impl fmt::Display for Fixed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { text, .. } => f.write_str(text),
            Self::Infinite => f.write_str("inf"),
            Self::MinusInfinite => f.write_str("-inf"),
        }
    }
}
