//! Units of the variables of an FMU.

use super::variables::Variable;
use crate::parameter::Parameter;
use crate::request::{Spec, chain_unit};

/// A unit that is a power of s.
pub(super) struct Unit {
    pub(super) name: String,
    pub(super) exponent: i64,
}

impl Unit {
    /// The units of all variables, each once.
    pub(super) fn all(variables: &[Variable]) -> Vec<Self> {
        let exponents = variables.iter().filter_map(|v| v.exponent);
        let units = crate::collect::map(exponents.map(|e| (-e, unit_name(e))));
        units.into_iter().map(|(e, name)| Self { name, exponent: -e }).collect()
    }
}

pub(super) fn unit_name(exponent: i64) -> String {
    match exponent {
        1 => "s".to_owned(),
        -1 => "1/s".to_owned(),
        0 => "1".to_owned(),
        exponent => format!("s^{exponent}"),
    }
}

/// The power of s of a parameter's unit.
pub(super) fn exponent(parameter: Parameter, n: usize) -> Option<i64> {
    let order = |i: usize| i64::try_from(i).ok();
    match parameter {
        Parameter::Tau | Parameter::StartTime | Parameter::Eps | Parameter::SampleTime => Some(1),
        Parameter::A | Parameter::Rate(_) => Some(-1),
        Parameter::M | Parameter::Start | Parameter::Samples | Parameter::Deadbeat => Some(0),
        Parameter::Gain(i) => Some(order(i)? - 1 - order(n)?),
        Parameter::UMax | Parameter::UMin | Parameter::Named(_) => None,
    }
}

/// The unit of a state of a chain, or of its highest rate, in brackets.
pub(super) fn chain_units(spec: &Spec, place: usize) -> String {
    format!(" [{}]", chain_unit(spec.units.as_deref().unwrap_or("unit"), place))
}
