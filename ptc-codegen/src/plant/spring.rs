//! The rates of a plant of the law with a spring before or beside it.

use num_traits::Zero;

use super::Plant;
use crate::algebra::BigRational;
use crate::expression::{Expression, Variable};
use crate::linear::{self, Joint, Linear, Side, Twist};
use crate::request::Spec;

/// The sides that a design names.
#[derive(Clone, Copy)]
pub(super) struct Sides {
    /// The side that the sensors see.
    pub(super) measured: Side,
    /// The side on which f acts.
    pub(super) forced: Side,
}

/// The spring between the two inertias, whose states follow the n states of the law.
pub(super) struct Spring {
    n: usize,
    equations: linear::Spring<Expression>,
}

impl Spring {
    pub(super) fn new(n: usize, joint: Joint<Expression>) -> Self {
        Self { n, equations: linear::Spring::new(joint) }
    }

    fn twist(&self) -> Twist<Expression> {
        let [angle, rate] = [1, 2].map(|k| Expression::from(Variable::State(self.n + k)));
        Twist { angle, rate }
    }

    /// The acceleration of a side by an input of the motor and by the spring.
    fn moved(&self, side: Side, input: Expression) -> Expression {
        self.equations.moved(side, input, self.equations.pull(self.twist()))
    }

    /// The rates of a chain with the spring.
    pub(super) fn beside(&self, plant: &Plant, spec: &Spec, sides: Sides) -> Vec<Expression> {
        let (n, Sides { measured, forced }) = (self.n, sides);
        let own = || spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let gain = plant.g.clone().unwrap_or_else(own);
        let input = gain.mul(Variable::Control.into());
        let f = match measured == forced {
            true => plant.f.clone(),
            false => self.across(&plant.f, forced),
        };
        let mut last = self.moved(measured, input.clone());
        let mut drive = self.equations.driven(input);
        if f != Expression::integer(0) {
            let own = self.equations.forced(forced, f);
            if measured == forced {
                last = last.add(own.clone());
            }
            drive = drive.add(if forced == Side::Load { own.neg() } else { own });
        }
        let next = (2..=n).map(|j| Variable::State(j).into());
        next.chain([last]).chain(self.equations.rates(self.twist(), drive)).collect()
    }

    /// An expression of the states of the side that is not measured, in those of the plant.
    fn across(&self, f: &Expression, side: Side) -> Expression {
        let n = self.n;
        let moved = |j: usize, of: fn(usize) -> Variable| {
            let twist = [n - 1, n].iter().position(|own| *own == j)?;
            let (x, d): (Expression, Expression) = (of(j).into(), of(n + 1 + twist).into());
            Some(if side == Side::Load { x.sub(d) } else { x.add(d) })
        };
        f.substitute(&|e| match e.variable()? {
            Variable::State(j) => moved(j, Variable::State),
            Variable::StateAtStart(j) => moved(j, Variable::StateAtStart),
            _ => None,
        })
    }

    /// The rates of a linear plant whose input acts through the spring.
    pub(super) fn before(&self, plant: &Linear, measured: Side) -> Vec<Expression> {
        let acts = self.moved(measured, Variable::Control.into());
        let drive = self.equations.driven(Variable::Control.into());
        let zero = Expression::integer(0);
        let row = |(row, b): (&Vec<BigRational>, &BigRational)| {
            let states = (1..).zip(row).map(|(j, a)| (a, Variable::State(j).into()));
            let terms = states.chain([(b, acts.clone())]).filter(|(a, _)| !a.is_zero());
            let terms = terms.map(|(a, x): (_, Expression)| Expression::from(a.clone()).mul(x));
            terms.reduce(Expression::add).unwrap_or(zero.clone())
        };
        let own = plant.a.iter().zip(&plant.b).map(row);
        own.chain(self.equations.rates(self.twist(), drive)).collect()
    }
}
