//! Expected outcome of a call: status, u and the error of another u.

use astro_float_num::BigFloat;

use super::FIRST_BITS;
use super::long::{Arithmetic, nearest};
use crate::code;

/// Outcome of a call, by the names and numbers of the emitted C.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// A deadline that is too soon.
    Soon = -4,
    /// u is not finite.
    Range = -3,
    /// Time or state is not finite, or t before t0.
    Input = -2,
    /// A parameter is outside its domain.
    Param = -1,
    /// Tracking.
    Ok = 0,
    /// Time-to-go is held at eps.
    Hold = 1,
    /// u is clipped.
    Saturated = 2,
    /// The deadline is over, and another law than the controller's gives u.
    After = 3,
    /// A reading was not believed.
    Gated = 4,
    /// The deadline was put off.
    Late = 5,
    /// The bounds of a filter cannot be kept.
    Infeasible = 6,
}

impl From<code::Status> for Status {
    fn from(status: code::Status) -> Self {
        match status {
            code::Status::Ok => Self::Ok,
            code::Status::Hold => Self::Hold,
            code::Status::Saturated => Self::Saturated,
            code::Status::After => Self::After,
            code::Status::Gated => Self::Gated,
            code::Status::Late => Self::Late,
            code::Status::Infeasible => Self::Infeasible,
            code::Status::Param => Self::Param,
            code::Status::Input => Self::Input,
            code::Status::Range => Self::Range,
            code::Status::Soon => Self::Soon,
        }
    }
}

impl Status {
    /// Its name in C.
    pub fn c_name(self) -> &'static str {
        match self {
            Self::Soon => "PTC_E_SOON",
            Self::Range => "PTC_E_RANGE",
            Self::Input => "PTC_E_INPUT",
            Self::Param => "PTC_E_PARAM",
            Self::Ok => "PTC_OK",
            Self::Hold => "PTC_HOLD",
            Self::Saturated => "PTC_SATURATED",
            Self::After => "PTC_AFTER",
            Self::Gated => "PTC_GATED",
            Self::Late => "PTC_LATE",
            Self::Infeasible => "PTC_INFEASIBLE",
        }
    }

    /// Its number in C.
    pub fn code(self) -> i32 {
        self as i32
    }
}

/// u before it is clipped, known far beyond the precision of any controller.
#[derive(Clone, Debug)]
pub struct Control {
    pub(super) value: BigFloat,
    pub(super) scale: BigFloat,
}

impl Control {
    /// The double nearest to u.
    pub fn u(&self) -> f64 {
        nearest(&self.value)
    }

    /// The sum of the absolute values of the terms of u, by which errors are measured.
    pub fn scale(&self) -> f64 {
        nearest(&self.scale)
    }

    /// |u - reference|/scale of a u that is a decimal number, to as many digits as it has.
    pub fn error_of_text(&self, u: &str) -> Option<f64> {
        let (mantissa, exponent) = u.split_once('e').unwrap_or((u, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: crate::algebra::BigInt = format!("{whole}{part}").parse().ok()?;
        let places: i32 = exponent.parse::<i32>().ok()? - i32::try_from(part.len()).ok()?;
        let ten = num_traits::pow(crate::algebra::integer(10), usize::try_from(places.abs()).ok()?);
        let exact = crate::algebra::integer(1) * digits;
        let exact = if places < 0 { exact / ten } else { exact * ten };
        let arithmetic = Arithmetic::new(2 * FIRST_BITS)?;
        Some(self.scaled(&arithmetic.exact(&exact), &arithmetic))
    }

    /// |u - reference|/scale.
    pub fn error(&self, u: f64) -> f64 {
        match Arithmetic::new(2 * FIRST_BITS) {
            Some(arithmetic) => self.scaled(&arithmetic.double(u), &arithmetic),
            None => f64::NAN,
        }
    }

    fn scaled(&self, u: &BigFloat, arithmetic: &Arithmetic) -> f64 {
        let off = arithmetic.sub(u, &self.value).abs();
        if off.is_zero() { 0.0 } else { nearest(&arithmetic.div(&off, &self.scale)) }
    }
}

/// Expected outcome of a call.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The status.
    pub status: Status,
    /// u as it is returned; 0 for a negative status.
    pub u: f64,
    /// The law's own u, where the law was asked.
    pub control: Option<Control>,
    /// Time-to-go before it is held, s.
    pub time_to_go: f64,
}

impl Outcome {
    pub(super) fn refused(status: Status) -> Self {
        Self { status, u: 0.0, control: None, time_to_go: f64::NAN }
    }
}
