//! Units of a chain, where the design names that of x1.

use super::Spec;
use crate::algebra::integer;
use crate::parameter::Parameter;

/// The same where that of x_1 is `unit`.
pub(crate) fn chain_unit(unit: &str, place: usize) -> String {
    match place {
        0 | 1 => unit.to_owned(),
        2 => format!("{unit}/s"),
        place => format!("{unit}/s^{}", place - 1),
    }
}

impl Spec {
    /// Unit of x_1, ..., x_n and of f + g u, which is the (n+1)-th: U, U/s, U/s^2, ...
    pub fn chain_unit(&self, place: usize) -> String {
        chain_unit(self.units.as_deref().unwrap_or("U"), place)
    }

    /// Unit of a parameter.
    pub fn unit(&self, parameter: Parameter) -> String {
        match (parameter, self.input_unit()) {
            (Parameter::UMax | Parameter::UMin, Some(unit)) => unit,
            (parameter, _) => parameter.unit_for(self.loop_order()),
        }
    }

    /// Meaning of a parameter in a few words.
    pub fn meaning(&self, parameter: Parameter) -> &'static str {
        match parameter {
            Parameter::UMax if self.u_min => Parameter::UPPER_LIMIT,
            Parameter::Samples if self.keep().is_some() => {
                "samples N in which a state outside returns"
            }
            parameter => parameter.meaning(),
        }
    }

    /// Unit of u, where that of x1 is given and no gain is between them.
    pub fn input_unit(&self) -> Option<String> {
        let one = self.input_gain.is_none()
            && self.sampled().is_none_or(|sampled| sampled.gain == integer(1));
        (self.units.is_some() && one).then(|| self.chain_unit(self.n + 1))
    }
}
