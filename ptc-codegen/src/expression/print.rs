//! The spelling of an expression, which reads back as the same expression.

use std::fmt;

use num_traits::Signed;

use super::{Expression, Variable};

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SinceStart | Self::Time => f.write_str("t"),
            Self::StretchedTime => f.write_str("t_kappa"),
            Self::Elapsed => f.write_str("dt"),
            Self::TimeToGo => f.write_str("T"),
            Self::Control => f.write_str("u"),
            Self::State(j) => write!(f, "x{j}"),
            Self::Xi(j) => write!(f, "xi{j}"),
            Self::StateAtStart(j) => write!(f, "x{j}_0"),
            Self::XiAtStart(j) => write!(f, "xi{j}_0"),
        }
    }
}

/// How tightly the outermost operation binds.
fn binding(expression: &Expression) -> u8 {
    match expression {
        Expression::Add(..) | Expression::Sub(..) => 1,
        Expression::Mul(..) | Expression::Div(..) => 2,
        Expression::Neg(_) => 3,
        Expression::Number(number) if !number.is_integer() => 2,
        Expression::Number(number) if number.is_negative() => 3,
        Expression::Power(..) => 4,
        _ => 5,
    }
}

/// An operand, in brackets where it binds less than `least`.
struct Operand<'a>(&'a Expression, u8);

impl fmt::Display for Operand<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if binding(self.0) < self.1 { write!(f, "({})", self.0) } else { write!(f, "{}", self.0) }
    }
}

fn list(items: &[&Expression]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

impl Expression {
    /// The arguments of a min of several, which is the min of the first ones and the last.
    fn least_of(&self) -> Vec<&Self> {
        let Self::Min(a, b) = self else { return vec![self] };
        let mut all = a.least_of();
        all.push(b);
        all
    }

    /// The arguments of a max of several.
    fn greatest_of(&self) -> Vec<&Self> {
        let Self::Max(a, b) = self else { return vec![self] };
        let mut all = a.greatest_of();
        all.push(b);
        all
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Pi => f.write_str("pi"),
            Self::Parameter(parameter) => f.write_str(&parameter.spelling()),
            Self::Variable(variable) => write!(f, "{variable}"),
            Self::Neg(a) => write!(f, "-{}", Operand(a, 3)),
            Self::Add(a, b) => write!(f, "{} + {}", Operand(a, 1), Operand(b, 2)),
            Self::Sub(a, b) => write!(f, "{} - {}", Operand(a, 1), Operand(b, 2)),
            Self::Mul(a, b) => write!(f, "{}*{}", Operand(a, 2), Operand(b, 3)),
            Self::Div(a, b) => write!(f, "{}/{}", Operand(a, 2), Operand(b, 3)),
            Self::Power(a, b) => write!(f, "{}^{}", Operand(a, 5), Operand(b, 5)),
            Self::Min(..) => write!(f, "min({})", list(&self.least_of())),
            Self::Max(..) => write!(f, "max({})", list(&self.greatest_of())),
            Self::Call(function, a) => write!(f, "{}({a})", function.name()),
        }
    }
}
