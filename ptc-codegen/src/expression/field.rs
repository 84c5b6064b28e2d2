//! Expressions as fractions of Laurent polynomials in *kernels*: names, calls and roots.

use num_traits::{One, Signed, ToPrimitive};

use super::compact::{Measure, is_negative, negative};
use super::effort::spend;
use super::ratio::{Ratio, content};
use super::{Expression, Found, Function, Node, Variable};
use crate::algebra::{BigRational, Kind, Monomial, Poly, Symbol, integer};
use crate::limits::{EXPANDED, KERNELS, MULTIPLE, POWER, ROOT, SIZE, TERMS};
use crate::parameter::Parameter;

/// What one symbol stands for.
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
    /// What each of them is written out.
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

    /// What a kernel of this field is written out.
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

    /// e^(sum of c_i m_i) is the product of (e^(m_i/q_i))^p_i with c_i = p_i/q_i, so that powers
    /// of one exponential cancel and divide as powers of a symbol.
    fn exponential(&mut self, argument: &Expression) -> Option<Ratio> {
        let mut result = Ratio::number(integer(1));
        for term in self.terms(argument)? {
            let parts: Vec<Ratio> = if term.den.is_empty() {
                term.num.terms().map(|(m, c)| Ratio::of(Poly::term(c.clone(), m.clone()))).collect()
            } else {
                vec![term]
            };
            for part in parts {
                let Some((_, c)) = part.num.terms().next() else { continue };
                let whole =
                    c.numer().to_i32().filter(|p| MULTIPLE.admits(p.unsigned_abs() as usize));
                let times = whole.unwrap_or(if c.is_negative() { -1 } else { 1 });
                let unit = part.scaled(&integer(i64::from(times)).recip());
                result = result.times(&self.power_of(Kernel::Exp(unit), times)?)?;
            }
        }
        Some(result)
    }

    fn raised(&mut self, base: &Expression, exponent: &Expression) -> Option<Ratio> {
        if let Node::Call(Function::Exp, a) = base.node() {
            return self.exponential(&a.clone().mul(exponent.clone()));
        }
        let base = self.fraction(base)?;
        if base == Ratio::number(integer(1)) {
            return Some(base);
        }
        let exponent_ratio = self.fraction(exponent)?;
        if let Some(number) = exponent_ratio.as_number() {
            let (p, q) = (number.numer().to_i32()?, number.denom().to_i32()?);
            return self.root(base, p, q);
        }
        // A whole part of the exponent is a power of its own: what it has in common then cancels.
        let whole = exponent_ratio.num.coefficient(&Monomial::one()).trunc();
        if let Some(k) = whole.to_i32().filter(|k| *k != 0 && exponent_ratio.den.is_empty()) {
            let rest = exponent_ratio.plus(&Ratio::number(-whole))?;
            return self.root(base.clone(), k, 1)?.times(&self.symbolic(base, rest)?);
        }
        self.symbolic(base, exponent_ratio)
    }

    fn symbolic(&mut self, base: Ratio, exponent_ratio: Ratio) -> Option<Ratio> {
        let negative = exponent_ratio.num.terms().next().is_some_and(|(_, c)| c.is_negative());
        let (sign, size) = if negative { (-1, exponent_ratio.neg()) } else { (1, exponent_ratio) };
        let size = self.shortest(&vec![size])?;
        self.power_of(Kernel::Root(base, size), sign)
    }

    /// base^(p/q), in lowest terms.
    pub(super) fn root(&mut self, base: Ratio, p: i32, q: i32) -> Option<Ratio> {
        // (x^(1/2))^(p/q) with q | p is a whole power of x: what is squared again is known.
        if let Some((monomial, c)) = base.num.single_term()
            && let ([(symbol, e)], true, true) =
                (monomial.factors(), base.den.is_empty(), c.is_one())
            && let Some(Kernel::Root(inner, index)) = self.kernel(*symbol)
            && let Some(index) = index.number()
            && let Some(times) = e.checked_mul(p)
        {
            let exponent = index * integer(i64::from(times)) / integer(i64::from(q));
            let inner = inner.clone();
            return self.root(inner, exponent.numer().to_i32()?, exponent.denom().to_i32()?);
        }
        if q == 1 {
            if u64::from(p.unsigned_abs()) > POWER.most || (p > 0 && !is_expanded(&base, p)) {
                return self.power_of(Kernel::Root(base, Expression::integer(1)), p);
            }
            return base.pow(p);
        }
        if let Some(number) = base.as_number()
            && let Some(root) = exact_root(&number, q)
        {
            return Ratio::number(root).pow(p);
        }
        let (outer, base) = self.taken_out(base, q)?;
        let index = Expression::from(BigRational::new(1.into(), q.into()));
        outer.pow(p)?.times(&self.power_of(Kernel::Root(base, index), p)?)
    }

    /// The q-th root of what is a q-th power and positive in any case, and the rest.
    fn taken_out(&self, mut base: Ratio, q: i32) -> Option<(Ratio, Ratio)> {
        if base.num.is_zero() {
            return None;
        }
        let (_, common) = content(&base.num);
        let positive = |symbol: Symbol| match self.kernel(symbol) {
            Some(Kernel::Exp(_)) => true,
            Some(Kernel::Atom(atom)) => {
                [Expression::pi(), Parameter::Tau.into(), Variable::TimeToGo.into()].contains(atom)
            }
            _ => false,
        };
        let whole = common.restrict(|s| positive(s) && common.exponent(s) % q == 0);
        base.num = base.num.shifted(&whole.pow(-1));
        let roots = whole.factors().iter().map(|(s, e)| (*s, e / q)).collect();
        Some((Ratio::of(Poly::term(integer(1), Monomial::from_sorted(roots))), base))
    }

    fn call(&mut self, function: Function, argument: &Expression) -> Option<Ratio> {
        use Function as F;
        let terms = self.terms(argument)?;
        let argument = self.shortest(&terms)?;
        let (function, sign, argument, inverted) = match function {
            F::Sin | F::Cos | F::Tan => self.quarter_turned(function, argument, &terms)?,
            _ => (function, 1, argument, false),
        };
        let odd = !matches!(function, F::Abs | F::Cos | F::Cosh | F::Ln | F::Exp | F::Sqrt);
        let even = matches!(function, F::Abs | F::Cos | F::Cosh);
        let (sign, argument) = match is_negative(&argument) {
            true if odd => (-sign, negative(argument)),
            true if even => (sign, negative(argument)),
            _ => (sign, argument),
        };
        let value = self.atom(Expression::call(function, argument))?.scaled(&integer(sign));
        if inverted { value.pow(-1) } else { Some(value) }
    }

    /// What a function of an angle is where the angle has pi/2 or pi in it: the function, its
    /// sign, the rest of the angle, and whether the reciprocal is meant. What vanishes with the
    /// rest then has all its digits.
    fn quarter_turned(
        &mut self,
        function: Function,
        argument: Expression,
        terms: &Terms,
    ) -> Option<(Function, i64, Expression, bool)> {
        use Function as F;
        let pi = self.symbol(Kernel::Atom(Expression::pi()))?;
        let half = BigRational::new(1.into(), 2.into());
        let monomial = Monomial::power(pi, 1);
        let turn = Self::combined(terms)
            .filter(|r| r.den.is_empty())
            .and_then(|r| r.num.terms().find(|(m, _)| **m == monomial).map(|(_, c)| c / &half));
        let quarters = turn.filter(BigRational::is_integer).and_then(|q| q.to_i64());
        let Some(quarters) = quarters.filter(|q| *q != 0) else {
            return Some((function, 1, argument, false));
        };
        let constant = Ratio::of(Poly::term(-half * integer(quarters), monomial));
        let rest = sum(terms.clone(), vec![constant])?;
        let rest = self.shortest(&rest)?;
        Some(match (function, quarters.rem_euclid(4)) {
            (F::Tan, 0 | 2) => (F::Tan, 1, rest, false),
            (F::Tan, _) => (F::Tan, -1, rest, true),
            (f, 0) => (f, 1, rest, false),
            (f, 2) => (f, -1, rest, false),
            (F::Sin, 1) => (F::Cos, 1, rest, false),
            (F::Sin, _) => (F::Cos, -1, rest, false),
            (_, 1) => (F::Sin, -1, rest, false),
            _ => (F::Sin, 1, rest, false),
        })
    }
}

/// Whether a positive whole power is multiplied out; one that is not is a kernel, over and under a fraction bar.
fn is_expanded(base: &Ratio, power: i32) -> bool {
    let power = power.unsigned_abs();
    let products = base.num.len().pow(2) * (power as usize);
    u64::from(power) <= POWER.most && (base.num.len() <= 1 || EXPANDED.admits(products))
}

/// The q-th root of a positive number, where it is a rational one.
fn exact_root(number: &BigRational, q: i32) -> Option<BigRational> {
    let q = u32::try_from(q).ok()?;
    if !number.is_positive() || !ROOT.admits(q as usize) {
        return None;
    }
    let root = BigRational::new(number.numer().nth_root(q), number.denom().nth_root(q));
    (root.pow(i32::try_from(q).ok()?) == *number).then_some(root)
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
