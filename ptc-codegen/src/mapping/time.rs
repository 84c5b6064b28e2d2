//! The time mapping of a controller, and the forms in which it is computed.

use super::{Custom, Form, Kappa};
use crate::algebra::BigRational;
use crate::expression::decaying::decaying;
use crate::expression::normal::complement;
use crate::expression::{Expression, Function, Node, Subject, Variable, family_form, solve};
use crate::family::Family;
use crate::parameter::Parameter;

/// The time mapping of a controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TimeMapping {
    /// One of the families.
    Family {
        /// The family.
        family: Family,
        /// Number of rates of `exp_sum`; 0 for the other families.
        rates: usize,
    },
    /// A mapping that the user wrote down.
    Custom(Box<Custom>),
}

impl TimeMapping {
    /// Its own parameters, beside tau.
    pub fn parameters(&self) -> Vec<Parameter> {
        match self {
            Self::Family { family: Family::ExpSum, rates } => {
                (1..=*rates).map(Parameter::Rate).collect()
            }
            Self::Family { family: Family::Power, .. } => vec![Parameter::A, Parameter::M],
            Self::Family { family: Family::Soft, .. } => vec![Parameter::A, Parameter::Start],
            Self::Family { .. } => vec![Parameter::A],
            Self::Custom(_) => Vec::new(),
        }
    }

    /// The form in which it is computed.
    #[cfg(feature = "lab")]
    pub(crate) fn form(&self) -> Form {
        match self {
            Self::Family { family, .. } => match self.complement() {
                Some(complement) if family.is_iterated() => Form::Complement(complement),
                _ => Form::Kappa(Kappa::of(*family)),
            },
            Self::Custom(custom) => custom.form.clone(),
        }
    }

    /// tau - mu(t), t the stretched time since the start; `None` if only kappa is known in closed
    /// form.
    pub fn complement(&self) -> Option<Expression> {
        match self {
            Self::Family { family: Family::ExpSum, rates } => {
                let decay = |i| {
                    let phase =
                        Expression::from(Parameter::Rate(i)).mul(Variable::SinceStart.into());
                    Expression::call(Function::Exp, phase.neg())
                };
                let sum = (1..=*rates).map(decay).reduce(Expression::add)?;
                let share = Expression::from(BigRational::new(1.into(), (*rates).into()));
                Some(Expression::from(Parameter::Tau).mul(share).mul(sum))
            }
            Self::Family { family, .. } => {
                form(*family, Subject::Mu).map(|mu| decaying(&complement(&mu)))
            }
            Self::Custom(custom) if custom.subject == Subject::Mu => {
                Some(decaying(&complement(&custom.given)))
            }
            Self::Custom(custom) => match &custom.form {
                Form::Kappa(kappa) => {
                    solve(&kappa.form, Variable::TimeToGo, Variable::SinceStart.into())
                        .map(|complement| decaying(&complement))
                }
                Form::Complement(form) => Some(form.clone()),
            },
        }
    }
}

impl Kappa {
    /// Returns the mapping of a family in the time-to-go, on its own parameters; tau - T for `exp_sum`, which has none.
    pub(crate) fn of(family: Family) -> Self {
        let elapsed = Expression::from(Parameter::Tau).sub(Variable::TimeToGo.into());
        Self::new(&form(family, Subject::Family).unwrap_or(elapsed))
    }
}

/// A form of a family on its own parameters.
pub(crate) fn form(family: Family, subject: Subject) -> Option<Expression> {
    let own = |e: &Expression| match e.node() {
        Node::Parameter(Parameter::Named(name)) => match name.text() {
            "a" => Some(Parameter::A.into()),
            "m" => Some(Parameter::M.into()),
            "start" => Some(Parameter::Start.into()),
            _ => None,
        },
        _ => None,
    };
    family_form(family.info(), subject).map(|form| form.substitute(&own))
}
