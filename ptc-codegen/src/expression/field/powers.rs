//! Exponentials, powers and roots as kernels.

use num_traits::{One, Signed, ToPrimitive};

use super::super::ratio::{Ratio, content};
use super::super::{Expression, Function, Node, Variable};
use super::{Field, Kernel};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};
use crate::limits::{EXPANDED, MULTIPLE, POWER, ROOT};
use crate::parameter::Parameter;

impl Field {
    /// e^(sum of c_i m_i) is the product of (e^(m_i/q_i))^p_i with c_i = p_i/q_i, so that powers
    /// of one exponential cancel and divide as powers of a symbol.
    pub(super) fn exponential(&mut self, argument: &Expression) -> Option<Ratio> {
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

    pub(super) fn raised(&mut self, base: &Expression, exponent: &Expression) -> Option<Ratio> {
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
    pub(in crate::expression) fn root(&mut self, base: Ratio, p: i32, q: i32) -> Option<Ratio> {
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
}

/// Returns true if a positive whole power is multiplied out; otherwise it is a kernel, over and under a fraction bar.
pub(super) fn is_expanded(base: &Ratio, power: i32) -> bool {
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
