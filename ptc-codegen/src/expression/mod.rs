//! Mathematical expressions in which users give mappings, laws and input gains.
//!
//! [`resolve`] makes one of a parsed value: names become variables, functions and parameters. What
//! is known by then is folded, exactly.

mod compact;
pub(crate) mod decaying;
mod derivative;
pub(crate) mod effort;
pub(crate) mod enclosure;
pub(crate) mod existence;
mod field;
pub(crate) mod interval;
pub(crate) mod leading;
mod names;
pub(crate) mod normal;
mod print;
mod pythagoras;
pub(crate) mod range;
mod ratio;
mod resolve;
pub(crate) mod sign;
mod solve;
#[cfg(test)]
pub(crate) mod testing;

pub use names::Subject;
pub use resolve::{Scope, family_form, resolve};
pub use solve::solve;

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::{BigRational, integer};
use crate::limits::BITS;
use crate::parameter::Parameter;

/// What varies while the controller runs, beside its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// Stretched time since the start, kappa(Dt): the `t` of a mapping mu(t).
    SinceStart,
    /// Stretched time kappa(Dt) + t0: `t_kappa`, and the `t` of a law pi0(xi, t).
    StretchedTime,
    /// Time t.
    Time,
    /// Elapsed time Dt = t - t0: `dt`.
    Elapsed,
    /// Time-to-go T = tau - Dt.
    TimeToGo,
    /// Control u.
    Control,
    /// State `x_j` of the plant, from 1.
    State(usize),
    /// State `xi_j` of the infinite-time system, from 1.
    Xi(usize),
    /// `x_j` latched at t0.
    StateAtStart(usize),
    /// `xi_j` latched at t0.
    XiAtStart(usize),
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// |a|.
    Abs,
    /// 1 for a > 0, -1 for a < 0, else a.
    Sign,
    /// Square root.
    Sqrt,
    /// e^a.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Inverse hyperbolic tangent.
    Atanh,
}

impl Function {
    /// All functions of one number, by the names that users write.
    pub const ALL: [(&'static str, Self); 13] = [
        ("abs", Self::Abs),
        ("sign", Self::Sign),
        ("sqrt", Self::Sqrt),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("atan", Self::Atan),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("atanh", Self::Atanh),
    ];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        // The table is in the order of the enum; a test holds it there.
        Self::ALL[self as usize].0
    }
}

/// An expression. Its height is bounded by the parser, so that walking it may recurse.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Expression {
    /// An exact number.
    Number(BigRational),
    /// The circle constant.
    Pi,
    /// A parameter: run-time, or fixed.
    Parameter(Parameter),
    /// What time and state decide.
    Variable(Variable),
    /// -a.
    Neg(Box<Self>),
    /// a + b.
    Add(Box<Self>, Box<Self>),
    /// a - b.
    Sub(Box<Self>, Box<Self>),
    /// a * b.
    Mul(Box<Self>, Box<Self>),
    /// a / b.
    Div(Box<Self>, Box<Self>),
    /// a ^ b.
    Power(Box<Self>, Box<Self>),
    /// The smaller one.
    Min(Box<Self>, Box<Self>),
    /// The greater one.
    Max(Box<Self>, Box<Self>),
    /// A function of one number.
    Call(Function, Box<Self>),
}

/// About the bits of a power of a number.
pub(crate) fn power_bits(base: &BigRational, exponent: i32) -> usize {
    let bits = base.numer().bits().max(base.denom().bits());
    usize::try_from(bits * u64::from(exponent.unsigned_abs())).unwrap_or(usize::MAX)
}

/// Whether a sum or a product of two numbers is one that is folded: beyond twice the bits that a
/// number of a spec has, it stands as it was written.
fn folds(a: &BigRational, b: &BigRational) -> bool {
    BITS.admits((power_bits(a, 1) + power_bits(b, 1)) / 2)
}

impl From<Variable> for Expression {
    fn from(variable: Variable) -> Self {
        Self::Variable(variable)
    }
}

impl From<Parameter> for Expression {
    fn from(parameter: Parameter) -> Self {
        Self::Parameter(parameter)
    }
}

/// The arithmetic of expressions folds numbers and drops neutral elements; nothing else moves.
#[allow(clippy::should_implement_trait)]
impl Expression {
    /// An integer.
    pub fn integer(value: i64) -> Self {
        Self::Number(integer(value))
    }

    /// The number, where it is one.
    pub fn number(&self) -> Option<&BigRational> {
        match self {
            Self::Number(number) => Some(number),
            _ => None,
        }
    }

    /// The exact value where it is a number that is an integer of a small size.
    pub fn small_integer(&self) -> Option<i32> {
        self.number().filter(|n| n.is_integer()).and_then(ToPrimitive::to_i32)
    }

    fn is(&self, value: i64) -> bool {
        self.number().is_some_and(|n| *n == integer(value))
    }

    /// -a.
    pub fn neg(self) -> Self {
        match self {
            Self::Number(number) => Self::Number(-number),
            Self::Neg(inner) => *inner,
            other => Self::Neg(Box::new(other)),
        }
    }

    /// a + b.
    pub fn add(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) if folds(&a, &b) => Self::Number(a + b),
            (a, b) if a.is(0) => b,
            (a, b) if b.is(0) => a,
            (a, Self::Neg(b)) => a.sub(*b),
            (a, b) => Self::Add(Box::new(a), Box::new(b)),
        }
    }

    /// a - b.
    pub fn sub(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) if folds(&a, &b) => Self::Number(a - b),
            (a, b) if b.is(0) => a,
            (a, b) if a.is(0) => b.neg(),
            (a, Self::Neg(b)) => a.add(*b),
            (a, b) => Self::Sub(Box::new(a), Box::new(b)),
        }
    }

    /// a * b.
    pub fn mul(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) if folds(&a, &b) => Self::Number(a * b),
            (a, b) if a.is(1) => b,
            (a, b) if b.is(1) => a,
            (a, b) if a.is(0) || b.is(0) => Self::Number(BigRational::zero()),
            (a, b) if a.is(-1) => b.neg(),
            (a, b) if b.is(-1) => a.neg(),
            (a, b) => Self::Mul(Box::new(a), Box::new(b)),
        }
    }

    /// a / b; a division by the number 0 stays, for the reader of the spec to refuse.
    pub fn div(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) if !b.is_zero() && folds(&a, &b) => {
                Self::Number(a / b)
            }
            (a, b) if b.is(1) => a,
            (a, b) if b.is(-1) => a.neg(),
            (a, b) => Self::Div(Box::new(a), Box::new(b)),
        }
    }

    /// a ^ b.
    pub fn power(self, exponent: Self) -> Self {
        match (self, exponent.small_integer()) {
            (_, Some(0)) => Self::Number(BigRational::one()),
            (a, Some(1)) => a,
            (Self::Number(a), Some(k @ -64..=64))
                if !(a.is_zero() && k < 0) && BITS.admits(power_bits(&a, k) / 2) =>
            {
                Self::Number(a.pow(k))
            }
            (a, _) => Self::Power(Box::new(a), Box::new(exponent)),
        }
    }

    /// A function of one number.
    pub fn call(function: Function, argument: Self) -> Self {
        match (function, argument) {
            (Function::Abs, Self::Number(a)) => Self::Number(a.abs()),
            (Function::Sign, Self::Number(a)) => Self::Number(a.signum()),
            (Function::Exp | Function::Cos | Function::Cosh, a) if a.is(0) => Self::integer(1),
            (Function::Ln, a) if a.is(1) => Self::integer(0),
            (Function::Sqrt, a) if a.is(0) || a.is(1) => a,
            (
                Function::Sin
                | Function::Tan
                | Function::Atan
                | Function::Sinh
                | Function::Tanh
                | Function::Atanh,
                a,
            ) if a.is(0) => a,
            (function, a) => Self::Call(function, Box::new(a)),
        }
    }

    /// Its operands, from the left.
    pub fn operands(&self) -> impl Iterator<Item = &Self> {
        let (first, second): (Option<&Self>, Option<&Self>) = match self {
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Variable(_) => (None, None),
            Self::Neg(a) | Self::Call(_, a) => (Some(a), None),
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Power(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same expression with `to` in place of the leaves for which it gives something.
    pub fn substitute(&self, to: &dyn Fn(&Self) -> Option<Self>) -> Self {
        if let Some(new) = to(self) {
            return new;
        }
        let inner = |e: &Self| e.substitute(to);
        match self {
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Variable(_) => self.clone(),
            Self::Neg(a) => inner(a).neg(),
            Self::Call(function, a) => Self::call(*function, inner(a)),
            Self::Add(a, b) => inner(a).add(inner(b)),
            Self::Sub(a, b) => inner(a).sub(inner(b)),
            Self::Mul(a, b) => inner(a).mul(inner(b)),
            Self::Div(a, b) => inner(a).div(inner(b)),
            Self::Power(a, b) => inner(a).power(inner(b)),
            Self::Min(a, b) => Self::Min(Box::new(inner(a)), Box::new(inner(b))),
            Self::Max(a, b) => Self::Max(Box::new(inner(a)), Box::new(inner(b))),
        }
    }

    /// Whether `wanted` holds for it or anything in it.
    pub fn any(&self, wanted: &dyn Fn(&Self) -> bool) -> bool {
        wanted(self) || self.operands().any(|e| e.any(wanted))
    }

    /// Whether `variable` occurs in it.
    pub fn contains(&self, variable: Variable) -> bool {
        self.any(&|e| *e == Self::Variable(variable))
    }

    /// Its parameters, in their own order, each once.
    pub fn parameters(&self) -> std::collections::BTreeSet<Parameter> {
        let mut found = std::collections::BTreeSet::new();
        self.parameters_into(&mut found);
        found
    }

    fn parameters_into(&self, found: &mut std::collections::BTreeSet<Parameter>) {
        if let Self::Parameter(parameter) = self {
            found.insert(*parameter);
        }
        self.operands().for_each(|operand| operand.parameters_into(found));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_functions_is_in_the_order_of_the_enum() {
        for (name, function) in Function::ALL {
            assert_eq!(function.name(), name);
        }
    }
}
