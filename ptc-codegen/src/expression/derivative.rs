//! Derivatives.

use super::effort::keep;
use super::function::Symbolic;
use super::{Expression, Found, Function, Node, Variable};
use crate::limits::{HEIGHT, SIZE};

impl Expression {
    /// Takes the effort of a derivative, which makes a few operations of each; `None` if it is not
    /// left.
    pub(crate) fn differentiable(&self) -> Option<()> {
        keep(self.nodes())
    }

    /// Returns true if a derivative is small enough to be kept: the recursion depth of a walk equals its height.
    pub(crate) fn is_kept(&self) -> bool {
        SIZE.admits(self.nodes()) && HEIGHT.admits(self.height())
    }

    /// Returns true for min, max, or a function with a kink.
    pub(crate) fn is_kink(&self) -> bool {
        match self.node() {
            Node::Min(..) | Node::Max(..) => true,
            Node::Call(function, _) => function.row().has_kink,
            _ => false,
        }
    }

    /// The derivative with respect to `wrt`. At a kink (of abs, sign, min, max) it is that of one
    /// side or their mean: whether there is a kink is for the caller to ask.
    pub fn derivative(&self, wrt: Variable) -> Self {
        self.along(&|variable| Self::integer(i64::from(variable == wrt)))
    }

    /// The derivative along a curve on which each variable has the rate that `rate` gives. What occurs
    /// often is differentiated once, and derivatives of derivatives share what they have in common.
    pub(crate) fn along(&self, rate: &dyn Fn(Variable) -> Self) -> Self {
        self.along_with(rate, &mut Found::default())
    }

    fn along_with(&self, rate: &dyn Fn(Variable) -> Self, found: &mut Found<Self>) -> Self {
        if let Some(known) = found.get(self) {
            return known.clone();
        }
        let own = match self.variable() {
            Some(variable) => rate(variable),
            None => self.slope(&mut |e| e.along_with(rate, found)),
        };
        found.insert(self.clone(), own.clone());
        own
    }

    /// The derivative from those of the operands.
    fn slope(&self, d: &mut dyn FnMut(&Self) -> Self) -> Self {
        let two = || Self::integer(2);
        match self.node() {
            Node::Number(_) | Node::Pi | Node::Parameter(_) | Node::Variable(_) => Self::integer(0),
            Node::Neg(a) => d(a).neg(),
            Node::Add(a, b) => d(a).add(d(b)),
            Node::Sub(a, b) => d(a).sub(d(b)),
            Node::Mul(a, b) => d(a).mul(b.clone()).add(a.clone().mul(d(b))),
            Node::Div(a, b) => {
                let (da, db) = (d(a), d(b));
                let (a, b) = (a.clone(), b.clone());
                if db.is(0) {
                    return da.div_or_zero(b);
                }
                let numerator = da.mul(b.clone()).sub(a.mul(db));
                numerator.div_or_zero(b.power(two()))
            }
            Node::Power(a, b) => {
                let (da, db) = (d(a), d(b));
                let (a, b) = (a.clone(), b.clone());
                let of_base = if da.is(0) {
                    Self::integer(0)
                } else {
                    let less = b.clone().sub(Self::integer(1));
                    b.clone().mul(a.clone().power(less)).mul(da)
                };
                let of_exponent = if db.is(0) {
                    Self::integer(0)
                } else {
                    self.clone().mul(Self::call(Function::Ln, a)).mul(db)
                };
                of_base.add(of_exponent)
            }
            Node::Min(a, b) => Self::of_the_chosen(a, b, d(a), d(b), false),
            Node::Max(a, b) => Self::of_the_chosen(a, b, d(a), d(b), true),
            Node::Call(function, a) => {
                if let (Function::Atan, Node::Div(over, under)) = (function, a.node()) {
                    // The slope of atan(p/q), without the pole of p/q where q is 0.
                    let (p, q) = (over.clone(), under.clone());
                    let turn = d(over).mul(q.clone()).sub(p.clone().mul(d(under)));
                    return turn.div_or_zero(p.power(two()).add(q.power(two())));
                }
                let inner = d(a);
                if inner.is(0) { inner } else { function.slope(&mut Symbolic, a).mul(inner) }
            }
        }
    }

    fn div_or_zero(self, by: Self) -> Self {
        if self.is(0) { self } else { self.div(by) }
    }

    /// da (1 +- sign(a - b))/2 + db (1 -+ sign(a - b))/2, the derivative of the greater or smaller
    /// one. Each derivative occurs in it once: twice in each of many would double it each time.
    fn of_the_chosen(a: &Self, b: &Self, da: Self, db: Self, greater: bool) -> Self {
        if da == db {
            return da;
        }
        let half = || Self::integer(1).div(Self::integer(2));
        let which = Self::call(Function::Sign, a.clone().sub(b.clone()));
        let above = Self::integer(1).add(which.clone()).mul(half());
        let below = Self::integer(1).sub(which).mul(half());
        if greater { da.mul(above).add(db.mul(below)) } else { da.mul(below).add(db.mul(above)) }
    }
}

#[cfg(test)]
mod tests {
    use crate::expression::Variable::SinceStart;
    use crate::expression::testing::{evaluate, mu};

    #[test]
    fn derivatives_match_finite_differences() {
        for text in [
            "tau*t^3 - 2/t + sqrt(t)/(1 + t)",
            "exp(-a*t)*sin(t) + cos(2*t)^2 - tan(t/4)",
            "ln(1 + t^2) + atan(3*t) - t^(1/3) + 2^t + t^t",
            "atan((1 + t)/t) - atan(1/t)*t",
            "sinh(t)/cosh(t/2) + tanh(t) + atanh(t/8) - 3",
            "min(t, 2*t^2) + max(t, 3) + abs(t - 5)*sign(t - 7)",
        ] {
            let e = mu(text);
            let derived = e.derivative(SinceStart);
            for t in [0.3, 0.9, 1.7, 2.5] {
                let h = 1e-5;
                let slope = (evaluate(&e, t + h) - evaluate(&e, t - h)) / (2.0 * h);
                let got = evaluate(&derived, t);
                assert!((got - slope).abs() < 1e-7 * (1.0 + slope.abs()), "{text} at {t}");
            }
        }
    }

    #[test]
    fn constants_drop_out_of_the_derivative() {
        assert_eq!(mu("tau*a").derivative(SinceStart).to_string(), "0");
        assert_eq!(mu("(a*t + 1)/tau").derivative(SinceStart).to_string(), "a/tau");
    }
}
