//! The arithmetic of expressions, which folds numbers and drops neutral elements; nothing else moves.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, integer};
use crate::limits::{BITS, FOLDED};
use crate::parameter::Parameter;

/// About the bits of a power of a number.
pub(crate) fn power_bits(base: &BigRational, exponent: i32) -> usize {
    let bits = base.numer().bits().max(base.denom().bits());
    usize::try_from(bits * u64::from(exponent.unsigned_abs())).unwrap_or(usize::MAX)
}

/// Returns true if a sum or a product of two numbers is folded. Beyond twice the bits of a number of a spec, it stays
/// as it was written.
fn folds(a: &BigRational, b: &BigRational) -> bool {
    BITS.admits((power_bits(a, 1) + power_bits(b, 1)) / 2)
}

impl From<BigRational> for Expression {
    fn from(number: BigRational) -> Self {
        Node::Number(number).into()
    }
}

impl From<Variable> for Expression {
    fn from(variable: Variable) -> Self {
        Node::Variable(variable).into()
    }
}

impl From<Parameter> for Expression {
    fn from(parameter: Parameter) -> Self {
        Node::Parameter(parameter).into()
    }
}

#[allow(clippy::should_implement_trait)]
impl Expression {
    /// An integer.
    pub fn integer(value: i64) -> Self {
        integer(value).into()
    }

    /// The circle constant.
    pub fn pi() -> Self {
        Node::Pi.into()
    }

    /// The number, where it is one.
    pub fn number(&self) -> Option<&BigRational> {
        match self.node() {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The variable, where it is one.
    pub fn variable(&self) -> Option<Variable> {
        match self.node() {
            Node::Variable(variable) => Some(*variable),
            _ => None,
        }
    }

    /// The parameter, where it is one.
    pub fn parameter(&self) -> Option<Parameter> {
        match self.node() {
            Node::Parameter(parameter) => Some(*parameter),
            _ => None,
        }
    }

    /// The exact value where it is a number that is an integer of a small size.
    pub fn small_integer(&self) -> Option<i32> {
        self.number().filter(|n| n.is_integer()).and_then(ToPrimitive::to_i32)
    }

    pub(super) fn is(&self, value: i64) -> bool {
        self.number().is_some_and(|n| *n == integer(value))
    }

    /// -a.
    pub fn neg(self) -> Self {
        match self.node() {
            Node::Number(number) => Self::from(-number),
            Node::Neg(inner) => inner.clone(),
            _ => Node::Neg(self).into(),
        }
    }

    /// a + b.
    pub fn add(self, other: Self) -> Self {
        match (self.node(), other.node()) {
            (Node::Number(a), Node::Number(b)) if folds(a, b) => Self::from(a + b),
            _ if self.is(0) => other,
            _ if other.is(0) => self,
            (_, Node::Neg(b)) => self.sub(b.clone()),
            _ => Node::Add(self, other).into(),
        }
    }

    /// a - b.
    pub fn sub(self, other: Self) -> Self {
        match (self.node(), other.node()) {
            (Node::Number(a), Node::Number(b)) if folds(a, b) => Self::from(a - b),
            _ if other.is(0) => self,
            _ if self.is(0) => other.neg(),
            (_, Node::Neg(b)) => self.add(b.clone()),
            _ => Node::Sub(self, other).into(),
        }
    }

    /// a * b.
    pub fn mul(self, other: Self) -> Self {
        match (self.node(), other.node()) {
            (Node::Number(a), Node::Number(b)) if folds(a, b) => Self::from(a * b),
            _ if self.is(1) => other,
            _ if other.is(1) => self,
            _ if self.is(0) || other.is(0) => Self::from(BigRational::zero()),
            _ if self.is(-1) => other.neg(),
            _ if other.is(-1) => self.neg(),
            _ => Node::Mul(self, other).into(),
        }
    }

    /// a / b; a division by the number 0 stays, for the reader of the spec to refuse.
    pub fn div(self, other: Self) -> Self {
        match (self.node(), other.node()) {
            (Node::Number(a), Node::Number(b)) if !b.is_zero() && folds(a, b) => Self::from(a / b),
            _ if other.is(1) => self,
            _ if other.is(-1) => self.neg(),
            _ => Node::Div(self, other).into(),
        }
    }

    /// a ^ b.
    pub fn power(self, exponent: Self) -> Self {
        match (self.node(), exponent.small_integer()) {
            (_, Some(0)) => Self::from(BigRational::one()),
            (_, Some(1)) => self,
            (Node::Number(a), Some(k))
                if FOLDED.admits(k.unsigned_abs() as usize)
                    && !(a.is_zero() && k < 0)
                    && BITS.admits(power_bits(a, k) / 2) =>
            {
                Self::from(a.pow(k))
            }
            _ => Node::Power(self, exponent).into(),
        }
    }

    /// The smaller one.
    pub fn min(self, other: Self) -> Self {
        Node::Min(self, other).into()
    }

    /// The greater one.
    pub fn max(self, other: Self) -> Self {
        Node::Max(self, other).into()
    }

    /// A function of one number.
    pub fn call(function: Function, a: Self) -> Self {
        match (function, a.node()) {
            (Function::Abs, Node::Number(a)) => return Self::from(a.abs()),
            (Function::Sign, Node::Number(a)) => return Self::from(a.signum()),
            _ => {}
        }
        let known = function.row().known.iter().find(|[at, _]| a.is(*at));
        known.map_or_else(|| Node::Call(function, a.clone()).into(), |[_, b]| Self::integer(*b))
    }
}
