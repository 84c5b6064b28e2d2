//! Functions of one number: the only place that knows a particular one.
//!
//! [`table`] has a row a function. Whoever needs a value, a derivative, a domain, an enclosure, a sign or a
//! word of a language asks the row, so that two analyses never differ in what a function is.

mod difference;
mod formula;
mod several;
mod slope;
mod table;
#[cfg(feature = "files")]
mod words;

pub(crate) use difference::{Arguments, difference_of_powers};
pub(crate) use formula::{in_exponentials, in_logarithms};
pub(crate) use several::OF_TWO;
pub(crate) use slope::{Algebra, Slope, Symbolic};
pub(crate) use table::Row;

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// |a|.
    Abs,
    /// 1 for a > 0, -1 for a < 0, else a.
    Sign,
    /// Square root.
    Sqrt,
    /// e^a.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Inverse hyperbolic tangent.
    Atanh,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Cube root, of negative numbers too.
    Cbrt,
}

/// Value of f(-a).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parity {
    /// f(a).
    Even,
    /// -f(a).
    Odd,
}

/// The arguments for which a function has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Domain {
    /// All numbers.
    Everywhere,
    /// a >= 0.
    NotNegative,
    /// a > 0.
    Positive,
    /// -1 < a < 1.
    InsideOne,
    /// -1 <= a <= 1.
    WithinOne,
    /// cos(a) is not 0.
    OffPoles,
}

/// An end of a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    pub(crate) at: i64,
    /// True if the end belongs to the domain.
    pub(crate) closed: bool,
}

impl Edge {
    /// The end as a double.
    #[allow(clippy::cast_precision_loss)]
    pub(crate) fn at(self) -> f64 {
        self.at as f64
    }
}

impl Domain {
    /// The lower and the upper end, `None` if unbounded. Poles are none.
    pub(crate) fn edges(self) -> [Option<Edge>; 2] {
        let at = |at, closed| Some(Edge { at, closed });
        match self {
            Self::Everywhere | Self::OffPoles => [None, None],
            Self::NotNegative => [at(0, true), None],
            Self::Positive => [at(0, false), None],
            Self::InsideOne => [at(-1, false), at(1, false)],
            Self::WithinOne => [at(-1, true), at(1, true)],
        }
    }
}

/// Monotonic pieces of a function: between these places its extremes are at the ends of an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pieces {
    /// It rises, or stays, on its whole domain.
    Rising,
    /// It falls on its whole domain.
    Falling,
    /// It falls up to 0 and rises from there.
    Valley,
    /// It oscillates between -1 and 1, greatest at this many quarter turns, and a whole turn further on.
    Wave(u8),
    /// It rises from pole to pole, which lie at odd quarter turns.
    Branches,
}

/// Sign of a value, from that of the argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Signs {
    /// Always > 0.
    Positive,
    /// Always >= 0.
    NeverNegative,
    /// > 0 but for an argument 0, where it is 0.
    Size,
    /// Sign of the argument.
    Argument,
    /// Sign of the argument less 1, for a positive argument.
    ArgumentLessOne,
    /// Sign of the argument, which is not negative.
    NotNegative,
    /// Sign of the argument within +-pi over this number.
    ArgumentWithin(i64),
    /// > 0 within +-pi over this number.
    PositiveWithin(i64),
}

impl Function {
    /// The row of the table.
    pub(crate) fn row(self) -> &'static Row {
        // The table is in the order of the enum; a test holds it there.
        &table::TABLE[self as usize]
    }

    /// All functions of one number, by the names that users write.
    pub const ALL: [(&'static str, Self); table::TABLE.len()] = table::names();

    /// The name that users write.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The parity of a hyperbolic sine or cosine: of a function that is its own second derivative.
    pub(crate) fn hyperbolic(self) -> Option<Parity> {
        let Slope::Partner(partner, sign) = self.row().slope else { return None };
        let Slope::Partner(_, back) = partner.row().slope else { return None };
        (sign == back).then_some(self.row().parity)?
    }

    /// Returns true where a library computes it with an error, rather than rounding the exact value once.
    pub(crate) fn is_of_library(self) -> bool {
        !self.row().is_exact
    }
}

#[cfg(test)]
mod tests;
