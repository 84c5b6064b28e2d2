//! A mapping that the user wrote down, in the form in which it is computed.

use crate::expression::{Expression, Subject, Variable, leading, normal, solve};
use crate::spec::Parameter;

/// A mapping given as mu(t) or as kappa(dt).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Custom {
    /// Which of the two was given.
    pub subject: Subject,
    /// The expression as it was given.
    pub given: Expression,
    /// mu: the complement tau - mu(t), which keeps its digits where mu is near tau; kappa: the
    /// same in the time-to-go T.
    pub form: Expression,
    /// mu: stretched time as an expression in T, where there is a closed form.
    pub inverse: Option<Expression>,
}

impl Custom {
    /// The mapping that `given` stands for.
    ///
    /// # Errors
    /// What is wrong, and the likely fix.
    pub fn new(subject: Subject, given: Expression) -> Result<Self, (String, String)> {
        let (variable, name) = match subject {
            Subject::Mu => (Variable::SinceStart, "t"),
            _ => (Variable::Elapsed, "dt"),
        };
        if !given.contains(variable) {
            let message = format!("{} does not depend on `{name}`", subject.key());
            return Err((message, format!("give an expression in {name}, tau and parameters")));
        }
        let tau = Expression::from(Parameter::Tau);
        let elapsed = tau.clone().sub(Variable::TimeToGo.into());
        let form = match subject {
            Subject::Mu => normal::complement(&given),
            _ => normal::normal(
                &given.substitute(&|e| (*e == variable.into()).then(|| elapsed.clone())),
            ),
        };
        let inverse = match subject {
            Subject::Mu => {
                let inverse = solve(&form, variable, Variable::TimeToGo.into());
                inverse.map(|inverse| normal::normal(&inverse))
            }
            _ => None,
        };
        Ok(Self { subject, given, form, inverse })
    }

    /// The rate at which the derivative of mu falls, -lim (ln mu')'; none where it is not found.
    pub fn decay_rate(&self) -> Option<Expression> {
        match self.subject {
            Subject::Mu => leading::decay_rate(&self.form, Variable::SinceStart),
            _ => leading::decay_rate_of_inverse(&self.form, Variable::TimeToGo),
        }
    }

    /// Whether stretched time is the root of an equation, found by an iteration.
    pub fn is_iterated(&self) -> bool {
        self.subject == Subject::Mu && self.inverse.is_none()
    }
}
