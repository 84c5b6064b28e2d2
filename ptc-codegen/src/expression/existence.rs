//! Domain of an expression: the conditions on its parts.
//!
//! An objective whose value does not exist fails. Sampling and proofs take this from one list, made
//! from the expression as it was given: a normal form may exist where the expression does not, as
//! that of sqrt(x)^2 does for x < 0. The reader asks the same list before it drops a part.

use super::enclosure::Interval;
use super::function::Domain;
use super::sign::Sign;
use super::{Expression, Found, Function, Node};

/// Condition on a part of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition {
    NotZero,
    Positive,
    NotNegative,
    /// Greater than -1 and less than 1.
    InsideOne,
    /// From -1 to 1.
    WithinOne,
}

impl Condition {
    /// Returns true if a number meets it; NaN and infinities meet none.
    #[cfg(feature = "lab")]
    pub(crate) fn holds(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::NotZero => value != 0.0,
                Self::Positive => value > 0.0,
                Self::NotNegative => value >= 0.0,
                Self::InsideOne => value.abs() < 1.0,
                Self::WithinOne => value.abs() <= 1.0,
            }
    }

    /// Returns true if every number of an interval meets it.
    pub(crate) fn is_certain(self, values: &Interval) -> bool {
        values.is_within_doubles() && self.is_met(values)
    }

    /// The same of numbers of any size.
    pub(crate) fn is_met(self, values: &Interval) -> bool {
        match self {
            Self::NotZero => !values.has_zero(),
            Self::Positive => values.is_positive(),
            Self::NotNegative => values.is_not_negative(),
            Self::InsideOne => values.is_inside(&Interval::integer(1).both_signs()),
            Self::WithinOne => values.within(Domain::WithinOne).is_some_and(|part| part == *values),
        }
    }

    /// Returns true if every number of a sign meets it.
    pub(crate) fn is_met_by(self, sign: Sign) -> bool {
        match self {
            Self::NotZero => matches!(sign, Sign::Positive | Sign::Negative),
            Self::Positive => sign == Sign::Positive,
            Self::NotNegative => {
                matches!(sign, Sign::Positive | Sign::NotNegative | Sign::Zero)
            }
            Self::InsideOne | Self::WithinOne => sign == Sign::Zero,
        }
    }

    /// Describes the condition in words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::NotZero => "not 0",
            Self::Positive => "> 0",
            Self::NotNegative => ">= 0",
            Self::InsideOne => "within -1 and 1",
            Self::WithinOne => "from -1 to 1",
        }
    }
}

/// The conditions under which `expression` has a value: each part, and what it has to be.
pub(crate) fn needs(expression: &Expression) -> Vec<(Expression, Condition)> {
    let mut found = Vec::new();
    collect(expression, &mut Found::default(), &mut found);
    found
}

fn collect(
    expression: &Expression,
    seen: &mut Found<()>,
    found: &mut Vec<(Expression, Condition)>,
) {
    if seen.insert(expression.clone(), ()).is_some() {
        return;
    }
    use Expression as E;
    let own = match expression.node() {
        Node::Div(_, b) => Some((b.clone(), Condition::NotZero)),
        Node::Power(a, b) => {
            let part = a.clone();
            match (b.small_integer(), b.number()) {
                // e^0 is 1 wherever e has a value.
                (Some(k), _) if k >= 0 => None,
                (Some(_), _) => Some((part, Condition::NotZero)),
                (None, Some(b)) if num_traits::Signed::is_positive(b) => {
                    Some((part, Condition::NotNegative))
                }
                _ => Some((part, Condition::Positive)),
            }
        }
        Node::Call(function, a) => match function.row().domain {
            Domain::Everywhere => None,
            Domain::NotNegative => Some((a.clone(), Condition::NotNegative)),
            Domain::Positive => Some((a.clone(), Condition::Positive)),
            Domain::InsideOne => Some((a.clone(), Condition::InsideOne)),
            Domain::WithinOne => Some((a.clone(), Condition::WithinOne)),
            Domain::OffPoles => Some((E::call(Function::Cos, a.clone()), Condition::NotZero)),
        },
        _ => None,
    };
    expression.operands().for_each(|operand| collect(operand, seen, found));
    let constant = |(part, condition): &(E, Condition)| {
        let number = part.number().map(Interval::exact);
        number.is_some_and(|number| condition.is_certain(&number))
    };
    found.extend(own.filter(|need| !constant(need) && !found.contains(need)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::enclosure::Range;
    use crate::expression::testing::mu;

    fn spelt(text: &str) -> Vec<String> {
        needs(&mu(text)).iter().map(|(part, needed)| format!("{part} {needed:?}")).collect()
    }

    #[test]
    fn every_partial_operation_has_its_condition() {
        for (text, expected) in [
            ("1/t", "t NotZero"),
            ("t/2 + 3*t^2", ""),
            ("t^(-2)", "t NotZero"),
            ("t^0", ""),
            ("t^1.5", "t NotNegative"),
            ("t^(-0.5)", "t Positive"),
            ("t^a", "t Positive"),
            ("2^t", ""),
            ("sqrt(t - 1)", "t - 1 NotNegative"),
            ("sqrt(t - 1)^2", "t - 1 NotNegative"),
            ("ln(t)", "t Positive"),
            ("atanh(t)", "t InsideOne"),
            ("asin(t) + acos(t)", "t WithinOne"),
            ("cbrt(t)", ""),
            ("tan(t)", "cos(t) NotZero"),
            ("max(0, sqrt(t))", "t NotNegative"),
            ("abs(t) + sign(t) + sin(t) + cos(t) + atan(t) + tanh(t)", ""),
            ("exp(t) + sinh(t) + cosh(t) + min(t, 1)", ""),
            ("atan(1/ln(t))", "t Positive, ln(t) NotZero"),
        ] {
            assert_eq!(spelt(text).join(", "), expected, "{text}");
        }
    }

    #[cfg(feature = "lab")]
    #[test]
    fn non_finite_numbers_meet_no_condition() {
        for condition in [
            Condition::NotZero,
            Condition::Positive,
            Condition::NotNegative,
            Condition::InsideOne,
            Condition::WithinOne,
        ] {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(!condition.holds(value), "{condition:?} {value}");
            }
            assert!(condition.holds(0.5) && condition.is_certain(&Range::new(0.5, 0.6).into()));
            assert!(!condition.is_certain(&Interval::WHOLE));
        }
        assert!(!Condition::NotZero.holds(0.0) && !Condition::Positive.holds(0.0));
        assert!(Condition::NotNegative.holds(0.0) && !Condition::InsideOne.holds(-1.0));
        assert!(Condition::WithinOne.holds(-1.0) && !Condition::WithinOne.holds(1.5));
    }
}
