//! The parameters of a request, fixed and left to run time.

use super::{Clock, Feedback, Spec, What};
use crate::collect::{listed, set};
use crate::expression::Expression;
use crate::parameter::Parameter;

impl Spec {
    /// Every parameter of the controller, fixed or not, in the order in which it is emitted.
    pub fn parameters(&self) -> Vec<Parameter> {
        if let Clock::Samples(sampled) = &self.clock {
            return match self.what {
                What::Observer => vec![Parameter::SampleTime, Parameter::A],
                What::Controller | What::Associated | What::Filter => {
                    let named = self.named_parameters();
                    sampled.parameters(self).into_iter().chain(named).collect()
                }
            };
        }
        let mut all = vec![Parameter::Tau, Parameter::StartTime];
        if self.what == What::Controller {
            all.extend([Parameter::Eps, Parameter::UMax]);
            all.extend(self.u_min.then_some(Parameter::UMin));
        }
        all.extend(self.time_mapping.parameters());
        if self.feedback == Feedback::Linear {
            all.extend((1..=self.n).map(Parameter::Gain));
        }
        all.extend(self.named_parameters());
        all
    }

    /// The user's parameters that occur in its expressions.
    fn named_parameters(&self) -> impl Iterator<Item = Parameter> {
        let named = set(self.expressions().flat_map(Expression::parameters));
        listed(named.into_iter().filter(|p| matches!(p, Parameter::Named(_))))
    }

    /// The parameters that are left to run time.
    pub fn run_time_parameters(&self) -> impl Iterator<Item = Parameter> {
        listed(self.parameters().into_iter().filter(|p| !self.fixed.contains_key(p)))
    }
}
