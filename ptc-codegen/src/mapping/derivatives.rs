//! The derivatives r_k of a mapping that the user wrote down, as expressions.

use super::custom::{Custom, Form};
use crate::expression::effort::completed;
use crate::expression::{Expression, Variable, normal};

impl Custom {
    /// r_1, ..., r_n: in the time-to-go T where kappa has a closed form, else in stretched time t =
    /// kappa(Dt). `None` if they take too much effort.
    pub fn r(&self, n: usize) -> Option<Vec<Expression>> {
        let (found, enough) = completed(|| match &self.form {
            Form::Kappa(kappa) => {
                let to_go = Variable::TimeToGo;
                let first = normal::normal(&Expression::from(to_go).mul(kappa.rate.clone()));
                // D = r_1 d/dDt, and T falls as Dt grows.
                let next = |r: &Expression| Some(first.clone().mul(derivative(r, to_go)?).neg());
                successive(n, first.clone(), &next)
            }
            Form::Complement(complement) => {
                let t = Variable::SinceStart;
                let first = normal::normal(&derivative(complement, t)?.neg());
                successive(n, first, &|r| derivative(r, t))
            }
        });
        found.filter(|_| enough)
    }
}

fn derivative(e: &Expression, by: Variable) -> Option<Expression> {
    e.differentiable()?;
    Some(e.derivative(by))
}

/// The first of them, and what `next` makes of each.
fn successive(
    n: usize,
    first: Expression,
    next: &dyn Fn(&Expression) -> Option<Expression>,
) -> Option<Vec<Expression>> {
    let mut all = vec![first];
    while all.len() < n {
        let r = normal::normal(&next(all.last()?)?);
        all.push(r.is_kept().then_some(r)?);
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Subject;
    use crate::expression::testing::{evaluate, mu};

    /// r_k in either form are the derivatives of mu itself at t = kappa(Dt).
    #[test]
    fn they_are_the_derivatives_of_mu() {
        let at = 0.6;
        for text in [
            "tau*t/(1 + t)",
            "tau*(1 - exp(-a*t))",
            "tau*tanh(a*t)",
            "tau*a*t/sqrt(1 + (a*t)^2)",
            "2*tau/pi*atan(a*t)",
            "tau*(1 - exp(-a*t)*(1 + t/3))",
            "tau*(1 - (exp(-t) + exp(-2*t))/2)",
        ] {
            let given = mu(text);
            let custom = Custom::new(Subject::Mu, given.clone()).expect(text);
            // tau is 2 there.
            let place = if custom.is_iterated() { at } else { 2.0 - evaluate(&given, at) };
            let mut derivative = given;
            for (k, r) in (1..).zip(custom.r(5).expect(text)) {
                derivative = derivative.derivative(Variable::SinceStart);
                let (found, wanted) = (evaluate(&r, place), evaluate(&derivative, at));
                // Some tens of roundings in sums whose terms are a few times the result.
                assert!((found - wanted).abs() < 1e-12 * wanted.abs().max(1.0), "{text} {k}: {r}");
            }
        }
    }

    #[test]
    fn what_is_too_large_is_left() {
        let custom = Custom::new(Subject::Mu, mu("tau*tanh(sinh(sinh(t)))")).expect("a mapping");
        assert_eq!(custom.r(3).map(|r| r.len()), Some(3));
        assert_eq!(custom.r(16), None);
    }
}
