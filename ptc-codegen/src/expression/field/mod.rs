//! Expressions as fractions of Laurent polynomials in *kernels*: names, calls and roots.

mod calls;
mod powers;

use super::compact::Measure;
use super::effort::{FORMED, spend};
use super::ratio::Ratio;
use super::{Expression, Found, Function, Node};
use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};
use crate::limits::{KERNELS, SIZE, TERMS};
use powers::is_expanded;

/// Meaning of one symbol.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kernel {
    /// A name, or a call, min or max with normal operands.
    Atom(Expression),
    /// e to a fraction.
    Exp(Ratio),
    /// A fraction to the power of an expression without sign: 1/2 for a square root.
    Root(Ratio, Expression),
}

/// A sum of fractions over different denominators. It stands for their sum without a common
/// denominator, which would multiply quantities that leave the range of numbers.
pub(super) type Terms = Vec<Ratio>;

/// The kernels met so far, in the order in which they were met.
#[derive(Debug, Default)]
pub(super) struct Field {
    kernels: Vec<Kernel>,
    /// Cost of writing out each of them.
    measures: Vec<Measure>,
    /// The normal forms of the expressions met so far.
    found: Found<Terms>,
}

impl Field {
    /// A field in which pi and the parameters of `expression` come first, in their own order.
    pub(super) fn of(expression: &Expression) -> Self {
        let pi = expression.any(&|e| *e == Expression::pi()).then_some(Expression::pi());
        let parameters = expression.parameters().into_iter().map(Expression::from);
        let mut field = Self::default();
        // The first operation fails if it is not left.
        let _ = spend(FORMED);
        for name in pi.into_iter().chain(parameters) {
            // The one for which there is no room is found missing when it is looked for.
            let _ = field.symbol(Kernel::Atom(name));
        }
        field
    }

    /// The kernel of a symbol that this field gave.
    pub(super) fn kernel(&self, symbol: Symbol) -> Option<&Kernel> {
        self.kernels.get(usize::from(symbol.index).checked_sub(1)?)
    }

    /// Returns the cost of writing out a kernel of this field.
    pub(super) fn measure(&self, symbol: Symbol) -> Measure {
        let index = usize::from(symbol.index).checked_sub(1);
        index.and_then(|index| self.measures.get(index).copied()).unwrap_or_default()
    }

    /// The symbol of a kernel; `None` if it is too large, or one too many.
    pub(super) fn symbol(&mut self, kernel: Kernel) -> Option<Symbol> {
        // Kernels within kernels begin alike: only those of one size are compared.
        let measure = self.measure_of(&kernel);
        spend(self.kernels.len().saturating_add(measure.labour))?;
        let same =
            |index: &usize| self.measures[*index] == measure && self.kernels[*index] == kernel;
        let index = match (0..self.kernels.len()).find(same) {
            Some(index) => index,
            None if !KERNELS.admits(self.kernels.len() + 1) => return None,
            None => {
                if !SIZE.admits(measure.size) {
                    return None;
                }
                self.measures.push(measure);
                self.kernels.push(kernel);
                self.kernels.len() - 1
            }
        };
        Some(Symbol::indexed(Kind::Kernel, index + 1))
    }

    fn power_of(&mut self, kernel: Kernel, exponent: i32) -> Option<Ratio> {
        let symbol = self.symbol(kernel)?;
        Some(Ratio::of(Poly::term(integer(1), Monomial::power(symbol, exponent))))
    }

    fn atom(&mut self, expression: Expression) -> Option<Ratio> {
        match expression.number() {
            Some(number) => Some(Ratio::number(number.clone())),
            None => self.power_of(Kernel::Atom(expression), 1),
        }
    }

    /// The sum as one fraction.
    pub(super) fn combined(terms: &Terms) -> Option<Ratio> {
        terms.iter().try_fold(Ratio::number(integer(0)), |sum, term| sum.plus(term))
    }

    /// The normal form of an expression; `None` if it grows beyond the bounds.
    pub(super) fn terms(&mut self, expression: &Expression) -> Option<Terms> {
        spend(1)?;
        if let Some(known) = self.found.get(expression) {
            spend(known.len())?;
            return Some(known.clone());
        }
        let terms = match expression.node() {
            Node::Number(number) => vec![Ratio::number(number.clone()).bounded()?],
            Node::Pi | Node::Parameter(_) | Node::Variable(_) => {
                vec![self.atom(expression.clone())?]
            }
            Node::Neg(a) => self.terms(a)?.iter().map(Ratio::neg).collect(),
            Node::Add(a, b) => sum(self.terms(a)?, self.terms(b)?)?,
            Node::Sub(a, b) => {
                let negative = self.terms(b)?.iter().map(Ratio::neg).collect();
                sum(self.terms(a)?, negative)?
            }
            Node::Mul(a, b) => product(&self.terms(a)?, &self.terms(b)?)?,
            Node::Div(a, b) => {
                let under = self.inverse(b)?;
                product(&self.terms(a)?, &vec![under])?
            }
            Node::Power(a, b) => vec![self.raised(a, b)?],
            Node::Min(a, b) => {
                let least = self.normal(a)?.min(self.normal(b)?);
                vec![self.atom(least)?]
            }
            Node::Max(a, b) => {
                let most = self.normal(a)?.max(self.normal(b)?);
                vec![self.atom(most)?]
            }
            Node::Call(Function::Exp, a) => vec![self.exponential(a)?],
            Node::Call(Function::Sqrt, a) => {
                let base = self.fraction(a)?;
                vec![self.root(base, 1, 2)?]
            }
            Node::Call(function, a) => vec![self.call(*function, a)?],
        };
        let terms = terms.into_iter().map(|term| self.with_unit_squares(term));
        let terms: Terms = terms.collect::<Option<_>>()?;
        if expression.height() > 0 {
            self.found.insert(expression.clone(), terms.clone());
        }
        Some(terms)
    }

    /// 1 over an expression, each factor of it by itself: multiplied out, none would cancel alone.
    fn inverse(&mut self, expression: &Expression) -> Option<Ratio> {
        match expression.node() {
            Node::Mul(a, b) => self.inverse(a)?.times(&self.inverse(b)?),
            Node::Power(a, exponent) => match exponent.small_integer() {
                Some(k) if k > 0 && is_expanded(&self.fraction(a)?, k) => self.inverse(a)?.pow(k),
                _ => self.fraction(expression)?.pow(-1),
            },
            _ => self.fraction(expression)?.pow(-1),
        }
    }

    /// The expression as one fraction.
    pub(super) fn fraction(&mut self, expression: &Expression) -> Option<Ratio> {
        Self::combined(&self.terms(expression)?)
    }

    fn normal(&mut self, expression: &Expression) -> Option<Expression> {
        let terms = self.terms(expression)?;
        self.shortest(&terms)
    }
}

/// Sum, fractions over the same denominator added.
pub(super) fn sum(mut left: Terms, right: Terms) -> Option<Terms> {
    spend((1 + left.len()) * (left.len() + right.len()))?;
    if !TERMS.admits(left.len()) {
        return None;
    }
    for term in right {
        match left.iter_mut().find(|own| own.den == term.den) {
            Some(own) => *own = own.plus(&term)?,
            None => left.push(term),
        }
    }
    left.retain(|term| !term.num.is_zero());
    // A numerator that cancels leaves a smaller denominator, which another term may have.
    let again = (1..left.len()).any(|i| left[..i].iter().any(|l| l.den == left[i].den));
    if again { sum(Vec::new(), left) } else { Some(left) }
}

fn product(left: &Terms, right: &Terms) -> Option<Terms> {
    let mut result = Vec::new();
    for a in left {
        for b in right {
            result = sum(result, vec![a.times(b)?])?;
        }
    }
    Some(result)
}
