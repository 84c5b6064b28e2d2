//! A mapping that the user wrote down, in the form in which it is computed.

use std::collections::BTreeSet;

use crate::expression::decaying::decaying;
use crate::expression::effort::{bounded, completed};
use crate::expression::leading::{Decay, Limit};
use crate::expression::vanishing::vanishing;
use crate::expression::{
    Expression, Function, Node, Subject, Variable, leading, normal, solve, unravel,
};
use crate::limits::EFFORT;
use crate::parameter::Parameter;

/// A mapping given as mu(t) or as kappa(dt).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Custom {
    /// Mapping that was given, mu or kappa.
    pub subject: Subject,
    /// The expression as it was given.
    pub given: Expression,
    /// The parameters in it.
    pub parameters: BTreeSet<Parameter>,
    /// The form in which it is computed.
    pub form: Form,
}

/// The form in which a mapping is computed, which keeps its digits up to the deadline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// The complement tau - mu(t), t the stretched time since the start, where no closed form of kappa is found: its
    /// digits are those of the time-to-go where mu is near tau.
    Complement(Expression),
    /// The form kappa.
    Kappa(Kappa),
}

/// A mapping by kappa, in the time-to-go T.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kappa {
    /// kappa.
    pub form: Expression,
    /// r_1/T = 1/(T kappa'): the rate at which T decays in stretched time.
    pub rate: Expression,
}

impl Form {
    /// The form of a mu; `None` if it takes too much effort.
    fn of_mu(mu: &Expression) -> Option<Self> {
        let complement = normal::complement(mu);
        complement.differentiable()?;
        let (t, to_go) = (Variable::SinceStart, Expression::from(Variable::TimeToGo));
        // In mu itself what cancels in the result is rational, so that normal forms take it out.
        let elapsed = || Expression::from(Parameter::Tau).sub(to_go.clone());
        let kappa = solve(&complement, t, to_go.clone()).or_else(|| unravel(mu, t, elapsed()));
        match kappa {
            Some(kappa) => Self::of_kappa(&kappa),
            None => {
                let complement = decaying(&complement);
                complement.differentiable()?;
                Some(Self::Complement(complement))
            }
        }
    }

    /// The same form, in which every sum that is 0 at the deadline keeps its digits there.
    pub(crate) fn kept(&self) -> Self {
        let in_time_to_go = |e: &Expression| vanishing(e, Variable::TimeToGo);
        match self {
            Self::Complement(form) => Self::Complement(vanishing(form, Variable::SinceStart)),
            Self::Kappa(kappa) => Self::Kappa(Kappa {
                form: in_time_to_go(&kappa.form),
                rate: in_time_to_go(&kappa.rate),
            }),
        }
    }

    fn of_kappa(kappa: &Expression) -> Option<Self> {
        let form = Kappa::form_of(kappa);
        form.differentiable()?;
        Some(Self::Kappa(Kappa::with_form(form)))
    }
}

impl Kappa {
    /// The mapping by `kappa`, an expression in the time-to-go.
    pub fn new(kappa: &Expression) -> Self {
        Self::with_form(Self::form_of(kappa))
    }

    fn form_of(kappa: &Expression) -> Expression {
        // A cotangent in place of a tangent's inverse: the tangent has a pole at the start.
        let without_tan = kappa.substitute(&|e| match e.node() {
            Node::Call(Function::Tan, angle) => {
                let part = |function| Expression::call(function, angle.clone());
                Some(part(Function::Sin).div(part(Function::Cos)))
            }
            _ => None,
        });
        normal::normal(&without_tan)
    }

    fn with_form(form: Expression) -> Self {
        let time_to_go = Expression::from(Variable::TimeToGo);
        // kappa' is the derivative with respect to elapsed time: T falls as time goes on.
        let slope = form.derivative(Variable::TimeToGo).neg();
        let rate = Expression::integer(1).div(time_to_go.mul(slope));
        Self { rate: normal::normal(&rate), form }
    }
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
        let (form, enough) = completed(|| match subject {
            Subject::Mu => Form::of_mu(&given),
            _ => {
                let elapsed = Expression::from(Parameter::Tau).sub(Variable::TimeToGo.into());
                let in_time_to_go =
                    |e: &Expression| (*e == variable.into()).then(|| elapsed.clone());
                Form::of_kappa(&given.substitute(&in_time_to_go))
            }
        });
        match form.filter(|_| enough) {
            Some(form) => Ok(Self { subject, parameters: given.parameters(), given, form }),
            None => {
                let (size, most) = (given.size(), EFFORT.most);
                let message = format!(
                    "{}, {size} operations and operands, takes more than {most} steps to simplify",
                    subject.key()
                );
                Err((message, EFFORT.fix.to_owned()))
            }
        }
    }

    /// Returns the decay of time-to-go and the first `order` derivatives of mu, once parameters are replaced as `fixed`
    /// says; `None` if that is not found. The rate is -lim (ln mu')'.
    pub(crate) fn decay(
        &self,
        order: usize,
        fixed: &dyn Fn(&Expression) -> Option<Expression>,
    ) -> Option<Decay> {
        let oscillates = |form: &Expression, v, limit: fn(&Expression, Variable) -> _| {
            form.any(&|e| {
                let Node::Call(Function::Sin | Function::Cos | Function::Tan, a) = e.node() else {
                    return false;
                };
                a.contains(v) && !matches!(limit(a, v), Some(Limit::Finite(_)))
            })
        };
        bounded(|| match &self.form {
            Form::Complement(form) => {
                let (mut falling, t) = (form.substitute(fixed), Variable::SinceStart);
                let decay = leading::decay(&falling, t)?;
                // Without oscillations a function falls at the rate at which its derivative does.
                if oscillates(&falling, t, leading::limit) {
                    for _ in 0..order {
                        falling.differentiable()?;
                        falling = normal::normal(&falling.derivative(t));
                        leading::decay(&falling, t).filter(|d| d.rate == decay.rate)?;
                    }
                }
                Some(decay)
            }
            Form::Kappa(kappa) => {
                let (kappa, to_go) = (kappa.form.substitute(fixed), Variable::TimeToGo);
                let steady = !oscillates(&kappa, to_go, leading::limit_at_zero);
                steady.then(|| leading::decay_of_inverse(&kappa, to_go))?
            }
        })
    }

    /// Returns true if stretched time is the root of an equation, found by an iteration.
    pub fn is_iterated(&self) -> bool {
        matches!(self.form, Form::Complement(_))
    }
}
