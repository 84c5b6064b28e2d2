//! The limits of an input as expressions.

use super::{Expr, Test};
use crate::expression::Function;
use crate::parameter::{Fixed, Parameter};
use crate::program::number::finite;
use crate::request::{After, Limits, Spec};

/// The limits between which an input is held.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Lower limit, if there is one.
    pub least: Option<Expr>,
    /// Upper limit, if there is one.
    pub most: Option<Expr>,
    /// True if the lower one is the opposite of the upper one.
    is_symmetric: bool,
}

/// Tests that the lower limit of u is below the upper one, where `init` has to check it; `value` returns an open
/// parameter.
pub fn limits_in_order(spec: &Spec, value: &dyn Fn(Parameter) -> Expr) -> Vec<Test> {
    if !spec.u_min || !spec.has_open_limit() {
        return Vec::new();
    }
    let greatest = || Expr::Number(finite(spec.precision.greatest()));
    let fixed = |parameter| spec.fixed.get(&parameter);
    let number = |parameter| match fixed(parameter).and_then(Fixed::number) {
        Some(number) => Expr::Number(number.clone()),
        None => value(parameter),
    };
    let (least, most) = (Parameter::UMin, Parameter::UMax);
    let mut tests = vec![match (fixed(least), fixed(most)) {
        (_, Some(Fixed::Infinite)) => Test::AtMost(number(least), greatest()),
        (Some(Fixed::MinusInfinite), _) => {
            Test::AtMost(Expr::Neg(Box::new(greatest())), number(most))
        }
        _ => Test::Less(number(least), number(most)),
    }];
    if spec.after == After::Zero {
        let zero = || Expr::integer(0);
        let open = |parameter: &Parameter| fixed(*parameter).is_none();
        tests.extend(open(&least).then(|| Test::AtMost(value(least), zero())));
        tests.extend(open(&most).then(|| Test::AtMost(zero(), value(most))));
    }
    tests
}

impl Bounds {
    /// |u| <= `most`, if it is given.
    pub fn symmetric(most: Option<Expr>) -> Self {
        let least = most.clone().map(|most| Expr::Neg(Box::new(most)));
        Self { least, most, is_symmetric: true }
    }

    /// Returns true if the lower limit is the opposite of the upper one.
    pub fn is_symmetric(&self) -> bool {
        self.is_symmetric
    }

    /// From `least` to `most`.
    pub fn between(least: Option<Expr>, most: Option<Expr>) -> Self {
        Self { least, most, is_symmetric: false }
    }

    /// Returns the bounds for fixed limits.
    pub fn of(limits: Limits<'_>) -> Self {
        let number = |fixed: &Fixed| fixed.number().cloned().map(Expr::Number);
        match limits.least {
            Some(least) => Self::between(number(least), number(limits.most)),
            None => Self::symmetric(number(limits.most)),
        }
    }

    /// The bound of |u|, where it is one.
    pub fn of_size(&self) -> Option<&Expr> {
        self.most.as_ref().filter(|_| self.is_symmetric)
    }

    /// Tests that a finite value is within the limits.
    pub fn hold(&self, v: &Expr) -> Vec<Test> {
        if let Some(most) = self.of_size() {
            return vec![Test::AtMost(
                Expr::Call(Function::Abs, Box::new(v.clone())),
                most.clone(),
            )];
        }
        let above = self.least.clone().map(|least| Test::AtMost(least, v.clone()));
        let below = self.most.clone().map(|most| Test::AtMost(v.clone(), most));
        above.into_iter().chain(below).collect()
    }

    /// The limits that a value may be beyond, the upper one first: the test of it, and the limit.
    pub fn beyond(&self, v: &Expr) -> impl Iterator<Item = (Test, Expr)> {
        let above = self.most.clone().map(|most| (Test::Less(most.clone(), v.clone()), most));
        let below = self.least.clone().map(|least| (Test::Less(v.clone(), least.clone()), least));
        [above, below].into_iter().flatten()
    }
}
