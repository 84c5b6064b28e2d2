//! The equations of a spring between two inertias.

use num_traits::Zero;

use super::Plant;
use crate::algebra::BigRational;
use crate::expression::{Expression, Variable};
use crate::linear::Linear;
use crate::request::{Side, Spec};

/// The spring between the two inertias, beside a chain of order n.
pub(super) struct Spring {
    n: usize,
    /// r, 1 + r, and the acceleration s that the spring causes by its twist.
    ratio: Expression,
    whole: Expression,
    pull: Expression,
}

impl Spring {
    pub(super) fn new(n: usize, [frequency, damping, ratio]: [Expression; 3]) -> Self {
        let two = || Expression::integer(2);
        let [twist, rate] = [1, 2].map(|k| Expression::from(Variable::State(n + k)));
        let omega = two().mul(Expression::pi()).mul(frequency);
        let damped = two().mul(damping).mul(omega.clone()).mul(rate);
        let pull = damped.add(omega.clone().mul(omega).mul(twist));
        let whole = Expression::integer(1).add(ratio.clone());
        Self { n, ratio, whole, pull }
    }

    /// Returns the term that the spring adds to the rate of the measured side.
    fn on(&self, side: Side) -> Expression {
        match side {
            Side::Motor => self.ratio.clone().div(self.whole.clone()).neg().mul(self.pull.clone()),
            Side::Load => self.pull.clone().div(self.whole.clone()),
        }
    }

    /// The rates of the spring's states, whose twist `drive` moves.
    fn twisted(&self, drive: Expression) -> [Expression; 2] {
        [Variable::State(self.n + 2).into(), drive.sub(self.pull.clone())]
    }

    /// The rates of a chain with the spring.
    pub(super) fn beside(
        &self,
        plant: &Plant,
        spec: &Spec,
        (measured, forced): (Side, Side),
    ) -> Vec<Expression> {
        let n = self.n;
        let own = || spec.input_gain.clone().unwrap_or(Expression::integer(1));
        let gain = plant.g.clone().unwrap_or_else(own);
        let input = self.whole.clone().mul(gain.mul(Variable::Control.into()));
        let f = match measured == forced {
            true => plant.f.clone(),
            false => self.across(&plant.f, forced),
        };
        let is_driven = f != Expression::integer(0);
        // Acceleration by f of the inertia on which it acts, and of the twist.
        let (own, twist) = match forced {
            Side::Motor => (self.whole.clone().mul(f.clone()), self.whole.clone().mul(f)),
            Side::Load => {
                let own = self.whole.clone().div(self.ratio.clone()).mul(f);
                (own.clone(), own.neg())
            }
        };
        let mut last = self.on(measured);
        if measured == Side::Motor {
            last = input.clone().add(last);
        }
        if is_driven && measured == forced {
            last = last.add(own);
        }
        let drive = if is_driven { input.add(twist) } else { input };
        let next = (2..=n).map(|j| Variable::State(j).into());
        next.chain([last]).chain(self.twisted(drive)).collect()
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
        let input = self.whole.clone().mul(Variable::Control.into());
        let acts = match measured {
            Side::Motor => input.clone().add(self.on(measured)),
            Side::Load => self.on(measured),
        };
        let zero = Expression::integer(0);
        let row = |(row, b): (&Vec<BigRational>, &BigRational)| {
            let states = (1..).zip(row).map(|(j, a)| (a, Variable::State(j).into()));
            let terms = states.chain([(b, acts.clone())]).filter(|(a, _)| !a.is_zero());
            let terms = terms.map(|(a, x): (_, Expression)| Expression::from(a.clone()).mul(x));
            terms.reduce(Expression::add).unwrap_or(zero.clone())
        };
        let own = plant.a.iter().zip(&plant.b).map(row);
        own.chain(self.twisted(input)).collect()
    }
}
