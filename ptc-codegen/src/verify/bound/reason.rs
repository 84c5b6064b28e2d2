//! Why an objective is not seen to hold over a cell, in words.

use num_traits::ToPrimitive;

use super::aim::Aim;
use super::form::Part;
use super::{Place, Proof};
use crate::algebra::BigRational;
use crate::diagnostic::{digits, digits_up};
use crate::expression::enclosure::Range;

/// Why an objective is not seen to hold over a cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Why {
    /// The bounded quantity may reach the first number, and its bound may be the second.
    Exceeded(String, f64, f64),
    /// An expression may have no value.
    MayNotExist(String),
    /// Nothing is known of an expression, or no bound of it.
    Unknown(String),
    /// The box has x0 = 0, from where f alone moves x.
    AtRest,
    /// The loop is not enclosed there.
    NotEnclosed,
}

/// Obstacle to a proof of an objective.
#[derive(Clone, Debug)]
pub(super) struct Gap {
    /// In one line.
    pub(super) why: String,
    /// Place, if a run may show there that the objective fails.
    place: Option<Place>,
}

impl Gap {
    /// Returns the obstacle at the beginning of a cell. A bound by intervals of several parts need not be attained;
    /// then the gap says nothing about the objective.
    pub(super) fn of(
        why: &Why,
        aim: &Aim,
        share: &[BigRational; 2],
        tau: &[BigRational; 2],
    ) -> Self {
        let place = Place::at(share, tau);
        let tells = matches!(why, Why::Exceeded(..) | Why::MayNotExist(_)) && aim.is_close();
        Self { why: why.at(place), place: tells.then_some(place) }
    }

    /// No more cells may be looked at.
    pub(super) fn spent(share: &[BigRational; 2], tau: &[BigRational; 2]) -> Self {
        let Place { share, tau } = Place::at(share, tau);
        let place = format!("T/tau = {}, tau = {}", digits(share), digits(tau));
        let why = format!(
            "the cells that may be looked at are used up at {place}: too little room there"
        );
        // Smaller cells might have proved it.
        Self { why, place: None }
    }
}

impl From<Gap> for Proof {
    fn from(Gap { why, place }: Gap) -> Self {
        match place {
            Some(_) => Self::NoRoom { why, place },
            None => Self::NotProved { why },
        }
    }
}

impl Place {
    /// Returns the beginning of a cell.
    fn at(share: &[BigRational; 2], tau: &[BigRational; 2]) -> Self {
        let [share, tau] = [&share[0], &tau[0]].map(|end| end.to_f64().unwrap_or(f64::NAN));
        Self { share, tau }
    }
}

impl Why {
    /// In words, with the place.
    fn at(&self, Place { share, tau }: Place) -> String {
        let place = format!("at T/tau = {}, tau = {}", digits(share), digits(tau));
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

pub(super) fn below(what: &str, value: Range, bound: Range) -> Result<(), Why> {
    let why = || Why::Exceeded(what.to_owned(), value.high(), bound.low());
    if value.is_below(&bound) { Ok(()) } else { Err(why()) }
}

/// The same of two squares.
pub(super) fn squares(what: &str, value: Range, bound: Range) -> Result<(), Why> {
    let [reached, most] = [value.high().sqrt(), bound.low().max(0.0).sqrt()];
    let why = || Why::Exceeded(what.to_owned(), reached, most);
    if value.is_below(&bound) { Ok(()) } else { Err(why()) }
}
