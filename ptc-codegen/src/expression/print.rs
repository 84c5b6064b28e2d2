//! The spelling of an expression, which reads back as the same expression; of one that is longer than
//! a text may be, what it has in place of it.

use std::fmt;

use num_traits::Signed;

use super::{Expression, Node, Variable};
use crate::limits::TEXT;

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SinceStart | Self::Time => f.write_str("t"),
            Self::StretchedTime => f.write_str("t_kappa"),
            Self::Elapsed => f.write_str("dt"),
            Self::TimeToGo => f.write_str("T"),
            Self::KappaRate => f.write_str("kappa_rate"),
            Self::R(k) => write!(f, "r_{k}"),
            Self::Control => f.write_str("u"),
            Self::State(j) => write!(f, "x{j}"),
            Self::Xi(j) => write!(f, "xi{j}"),
            Self::StateAtStart(j) => write!(f, "x{j}_0"),
            Self::XiAtStart(j) => write!(f, "xi{j}_0"),
        }
    }
}

/// Returns the precedence of the outermost operation.
fn binding(expression: &Expression) -> u8 {
    match expression.node() {
        Node::Add(..) | Node::Sub(..) => 1,
        Node::Mul(..) | Node::Div(..) => 2,
        Node::Neg(_) => 3,
        Node::Number(number) if !number.is_integer() => 2,
        Node::Number(number) if number.is_negative() => 3,
        Node::Power(..) => 4,
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
    /// Returns true if it is short enough to be written out.
    pub fn is_written(&self) -> bool {
        TEXT.admits(self.size())
    }

    /// The arguments of a min of several, which is the min of the first ones and the last.
    fn least_of(&self) -> Vec<&Self> {
        let Node::Min(a, b) = self.node() else { return vec![self] };
        let mut all = a.least_of();
        all.push(b);
        all
    }

    /// The arguments of a max of several.
    fn greatest_of(&self) -> Vec<&Self> {
        let Node::Max(a, b) = self.node() else { return vec![self] };
        let mut all = a.greatest_of();
        all.push(b);
        all
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.is_written() {
            return write!(f, "({} operations, too long to be written out)", self.nodes());
        }
        match self.node() {
            Node::Number(number) => write!(f, "{number}"),
            Node::Pi => f.write_str("pi"),
            Node::Parameter(parameter) => f.write_str(&parameter.spelling()),
            Node::Variable(variable) => write!(f, "{variable}"),
            Node::Neg(a) => write!(f, "-{}", Operand(a, 3)),
            Node::Add(a, b) => write!(f, "{} + {}", Operand(a, 1), Operand(b, 2)),
            Node::Sub(a, b) => write!(f, "{} - {}", Operand(a, 1), Operand(b, 2)),
            Node::Mul(a, b) => write!(f, "{}*{}", Operand(a, 2), Operand(b, 3)),
            Node::Div(a, b) => write!(f, "{}/{}", Operand(a, 2), Operand(b, 3)),
            Node::Power(a, b) => write!(f, "{}^{}", Operand(a, 5), Operand(b, 5)),
            Node::Min(..) => write!(f, "min({})", list(&self.least_of())),
            Node::Max(..) => write!(f, "max({})", list(&self.greatest_of())),
            Node::Call(function, a) => write!(f, "{}({a})", function.name()),
        }
    }
}
