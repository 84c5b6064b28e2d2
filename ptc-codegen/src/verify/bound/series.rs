//! Taylor series of an expression whose coefficients are enclosed, by Taylor arithmetic.

use crate::expression::enclosure::Range;
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::function::Slope;
use crate::expression::{Expression, Function, Node, Variable};

/// scale * sum_k terms\[k\] z^k. The scale keeps a common factor out of the terms, so that those of a
/// power of the variable stay single numbers, however wide the variable is.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) scale: Range,
    pub(super) terms: Vec<Range>,
}

/// The series around one point, in one variable.
pub(super) struct Arithmetic<'a> {
    pub(super) variable: Variable,
    pub(super) series: Series,
    pub(super) names: &'a Names,
    pub(super) evaluator: &'a mut Evaluator,
}

pub(super) fn integer(value: usize) -> Range {
    Range::from(f64::from(u32::try_from(value).unwrap_or(u32::MAX)))
}

/// sum_{j in range} weight(j) a_j b_(k-j).
fn convolution(
    (a, b): (&[Range], &[Range]),
    k: usize,
    range: std::ops::RangeInclusive<usize>,
    weight: &dyn Fn(usize) -> Range,
) -> Range {
    let term = |j: usize| weight(j) * (a[j] * b[k - j]);
    range.map(term).sum()
}

fn one(_: usize) -> Range {
    Range::from(1.0)
}

/// The product of two series, as long as the first.
pub(super) fn product(a: &[Range], b: &[Range]) -> Vec<Range> {
    (0..a.len()).map(|k| convolution((a, b), k, 0..=k, &one)).collect()
}

/// Term k of w with w' = a' v: (1/k) sum_j j a_j v_(k-j).
fn next_term(a: &[Range], v: &[Range], k: usize) -> Range {
    convolution((a, v), k, 1..=k, &integer) / integer(k)
}

/// Term k of w with w' v = a': (a_k - (1/k) sum_{j<k} j w_j v_(k-j))/v_0.
fn next_quotient(a: &[Range], w: &[Range], v: &[Range], k: usize) -> Range {
    let sum = convolution((w, v), k, 1..=k - 1, &integer) / integer(k);
    (a[k] - sum) / v[0]
}

impl Series {
    fn constant(value: Range, length: usize) -> Self {
        let mut terms = vec![Range::from(0.0); length];
        terms[0] = Range::from(1.0);
        Self { scale: value, terms }
    }

    /// The terms with the scale in them.
    pub(super) fn plain(&self) -> Vec<Range> {
        self.terms.iter().map(|term| self.scale * *term).collect()
    }

    fn of(terms: Vec<Range>) -> Self {
        Self { scale: Range::from(1.0), terms }
    }

    pub(super) fn neg(self) -> Self {
        Self { scale: -self.scale, ..self }
    }

    fn plus(&self, other: &Self) -> Self {
        let pairs = self.plain().into_iter().zip(other.plain());
        Self::of(pairs.map(|(a, b)| a + b).collect())
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let scale = self.scale * other.scale;
        Self { scale, terms: product(&self.terms, &other.terms) }
    }

    /// Leading term, and the terms divided by it.
    fn leading(&self) -> (Range, Vec<Range>) {
        let first = self.terms[0];
        let mut terms: Vec<_> = self.terms.iter().map(|term| *term / first).collect();
        terms[0] = Range::from(1.0);
        (self.scale * first, terms)
    }

    pub(super) fn reciprocal(&self) -> Self {
        let (leading, terms) = self.leading();
        let terms = power(&terms, Range::from(-1.0));
        Self { scale: Range::from(1.0) / leading, terms }
    }

    fn whole_power(&self, k: u32) -> Self {
        if k == 1 {
            return self.clone();
        }
        let half = self.whole_power(k / 2);
        let square = half.times(&half);
        if k % 2 == 1 { square.times(self) } else { square }
    }
}

/// (1 + a_1 z + ...)^p: k w_k = sum_j (p j - (k - j)) a_j w_(k-j).
pub(super) fn power(a: &[Range], p: Range) -> Vec<Range> {
    let mut terms = vec![Range::from(1.0)];
    for k in 1..a.len() {
        let weight = |j| p * integer(j) - integer(k - j);
        terms.push(convolution((a, &terms), k, 1..=k, &weight) / integer(k));
    }
    terms
}

impl Arithmetic<'_> {
    /// The series of an expression; `None` where it is not smooth, or has no value.
    pub(super) fn series(&mut self, e: &Expression) -> Option<Series> {
        use Expression as E;
        if !e.contains(self.variable) {
            let value = Range::from(&self.evaluator.sound(e, self.names)?);
            return Some(Series::constant(value, self.series.terms.len()));
        }
        Some(match e.node() {
            Node::Variable(_) | Node::Number(_) | Node::Pi | Node::Parameter(_) => {
                self.series.clone()
            }
            Node::Neg(a) => self.series(a)?.neg(),
            Node::Add(a, b) => self.series(a)?.plus(&self.series(b)?),
            Node::Sub(a, b) => self.series(a)?.plus(&self.series(b)?.neg()),
            Node::Mul(a, b) => self.series(a)?.times(&self.series(b)?),
            Node::Div(a, b) => self.series(a)?.times(&self.series(b)?.reciprocal()),
            Node::Power(a, b) if !b.contains(self.variable) => {
                let a = self.series(a)?;
                let whole = b.small_integer().filter(|k| k.unsigned_abs() <= 64 && *k != 0);
                match whole {
                    Some(k) if k > 0 => a.whole_power(k.unsigned_abs()),
                    Some(k) => a.whole_power(k.unsigned_abs()).reciprocal(),
                    None => {
                        let exponent = Range::from(&self.evaluator.sound(b, self.names)?);
                        self.power(&a, exponent)?
                    }
                }
            }
            Node::Power(a, b) => {
                let logarithm = E::call(Function::Ln, a.clone());
                self.series(&E::call(Function::Exp, b.clone().mul(logarithm)))?
            }
            Node::Min(a, b) | Node::Max(a, b) => {
                let (a, b) = (self.series(a)?, self.series(b)?);
                let gap = a.plus(&b.clone().neg()).plain().swap_remove(0);
                let first = match e.node() {
                    Node::Min(..) => gap.is_negative(),
                    _ => gap.is_positive(),
                };
                match gap.has_zero() {
                    true => return None,
                    false if first => a,
                    false => b,
                }
            }
            Node::Call(Function::Sqrt, a) => {
                let a = self.series(a)?;
                self.power(&a, Range::from(0.5))?
            }
            Node::Call(function, a) => {
                let a = self.series(a)?;
                self.function(*function, &a)?
            }
        })
    }

    fn power(&mut self, a: &Series, exponent: Range) -> Option<Series> {
        let (leading, terms) = a.leading();
        let scale = leading
            .is_positive()
            .then(|| self.evaluator.power(&leading.into(), &exponent.into()))??;
        Some(Series { scale: Range::from(&scale), terms: power(&terms, exponent) })
    }

    fn function(&mut self, function: Function, a: &Series) -> Option<Series> {
        if function.row().slope == Slope::Reciprocal {
            let (leading, terms) = a.leading();
            let first =
                leading.is_positive().then(|| self.evaluator.call(function, &leading.into()))??;
            let mut own = vec![Range::from(&first)];
            (1..terms.len()).for_each(|k| own.push(next_quotient(&terms, &own, &terms, k)));
            return Some(Series::of(own));
        }
        if function.row().slope == Slope::ThirdReciprocalSquare {
            let (leading, terms) = a.leading();
            let is_away = !leading.has_zero();
            let scale = is_away.then(|| self.evaluator.call(function, &leading.into()))??;
            let third = Range::from(1.0) / Range::from(3.0);
            return Some(Series { scale: Range::from(&scale), terms: power(&terms, third) });
        }
        let inner = a.plain();
        let at = inner[0];
        let slope = function.row().slope;
        if let Slope::Sign | Slope::Zero = slope {
            let sign = if at.is_positive() {
                Range::from(1.0)
            } else if at.is_negative() {
                Range::from(-1.0)
            } else {
                return None;
            };
            let sign = Series::constant(sign, inner.len());
            return Some(if slope == Slope::Sign { sign.times(a) } else { sign });
        }
        let mut own = vec![Range::from(&self.evaluator.call(function, &at.into())?)];
        let length = 1..inner.len();
        // Term k of 1 + w^2 or 1 - w^2.
        let square = |w: &[Range], k: usize, sign: i8| {
            let square = convolution((w, w), k, 0..=k, &one);
            let unit = Range::from(f64::from(u8::from(k == 0)));
            unit + if sign < 0 { -square } else { square }
        };
        match slope {
            Slope::Own => length.for_each(|k| own.push(next_term(&inner, &own, k))),
            Slope::Partner(partner, sign) => {
                let signs =
                    [sign, partner.row().slope.sign()].map(|sign| Range::from(f64::from(sign)));
                let mut other = vec![Range::from(&self.evaluator.call(partner, &at.into())?)];
                for k in length {
                    let next = next_term(&inner, &other, k) * signs[0];
                    other.push(next_term(&inner, &own, k) * signs[1]);
                    own.push(next);
                }
            }
            Slope::OneAndSquare(sign) => {
                let mut slope = vec![square(&own, 0, sign)];
                for k in length {
                    own.push(next_term(&inner, &slope, k));
                    slope.push(square(&own, k, sign));
                }
            }
            Slope::OverCircle(sign) => {
                let under: Vec<_> = (0..inner.len()).map(|k| square(&inner, k, -1)).collect();
                let root = self.power(&Series::of(under), Range::from(0.5))?.plain();
                let over: Vec<_> =
                    inner.iter().map(|a| *a * Range::from(f64::from(sign))).collect();
                length.for_each(|k| own.push(next_quotient(&over, &own, &root, k)));
            }
            Slope::OverOneAndSquare(sign) => {
                let under: Vec<_> = (0..inner.len()).map(|k| square(&inner, k, sign)).collect();
                // The domain of an inverse; without a sign it is always positive.
                under[0].is_positive().then_some(())?;
                length.for_each(|k| own.push(next_quotient(&inner, &own, &under, k)));
            }
            // Logarithms and roots are series by their leading term.
            Slope::Sign
            | Slope::Zero
            | Slope::Reciprocal
            | Slope::HalfReciprocal
            | Slope::ThirdReciprocalSquare => return None,
        }
        Some(Series::of(own))
    }
}
