//! Why an objective is not seen to hold over a cell, in words.

use num_traits::ToPrimitive;

use super::form::Part;
use crate::algebra::BigRational;
use crate::diagnostic::{digits, digits_up};
use crate::expression::enclosure::Range;

/// Why an objective is not seen to hold over a cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Why {
    /// What is bounded may reach the one number, and its bound may be the other.
    Exceeded(&'static str, f64, f64),
    /// An expression may have no value.
    MayNotExist(String),
    /// Nothing is known of an expression, or no bound of it.
    Unknown(String),
    /// The box has x0 = 0, from where f alone moves x.
    AtRest,
    /// The loop is not enclosed there.
    NotEnclosed,
}

impl Why {
    /// In words, with the place.
    pub(super) fn at(&self, share: &[BigRational; 2], tau: &[BigRational; 2]) -> String {
        let number = |value: &BigRational| digits(value.to_f64().unwrap_or(f64::NAN));
        let place = format!("at T/tau = {}, tau = {}", number(&share[0]), number(&tau[0]));
        match self {
            Self::Exceeded(what, value, bound) => format!(
                "no room is left {place}: {what} may reach {}, and the bound is {}",
                digits_up(*value),
                digits(*bound)
            ),
            Self::MayNotExist(what) => format!("{what} may have no value {place}"),
            Self::Unknown(what) => format!("{what} {place}"),
            Self::AtRest => {
                "from x0 = 0, which the box holds, f moves x and no bound is left".into()
            }
            Self::NotEnclosed => format!("the loop is not enclosed {place}"),
        }
    }
}

pub(super) fn unknown(part: &Part) -> Why {
    Why::Unknown(format!("no bound is found of {}", part.spelt))
}

pub(super) fn below(what: &'static str, value: Range, bound: Range) -> Result<(), Why> {
    let why = Why::Exceeded(what, value.high(), bound.low());
    if value.is_below(&bound) { Ok(()) } else { Err(why) }
}

/// The same of two squares.
pub(super) fn squares(what: &'static str, value: Range, bound: Range) -> Result<(), Why> {
    let why = Why::Exceeded(what, value.high().sqrt(), bound.low().max(0.0).sqrt());
    if value.is_below(&bound) { Ok(()) } else { Err(why) }
}
