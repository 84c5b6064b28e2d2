//! The formula of a law in samples, in the flat coordinates of its loop.

use std::ops::{Add, Div, Mul, Sub};

use super::controller::Builder;
use super::rows::deadbeat;
use crate::algebra::BigRational;
use crate::code::{Expr, Shape, Statement};
use crate::internal::fault;
use crate::linear::{Matrix, dot};

/// Flat coordinates z = S x of a loop.
pub(super) struct Flat {
    s: Matrix,
    /// Coefficients of z in the rate of the last one.
    drift: Vec<BigRational>,
    /// Powers of the period in the units of the states.
    powers: Vec<i64>,
    /// The states, and the inputs under way.
    states: Vec<Expr>,
}

impl Flat {
    /// The number of coordinates.
    pub(super) fn order(&self) -> usize {
        self.states.len()
    }

    /// The factor of state `j` in a sum of coordinates, each times its factor.
    fn column(&self, factors: &[BigRational], j: usize) -> BigRational {
        dot(factors.iter().enumerate().map(|(i, factor)| (factor, self.s.at(i, j))))
    }
}

/// The samples to go as a formula counts them.
pub(super) struct Now {
    /// Those to sample N.
    pub(super) left: Expr,
    /// More of them, with which the formula ends at rest.
    pub(super) shift: u32,
}

impl Builder<'_> {
    /// The flat coordinates of the plant with its inputs under way.
    pub(super) fn flat(&mut self, order: usize) -> Flat {
        let pair = self.plant().delayed(self.sampled.delay.inputs());
        let Some((s, drift)) = pair.flat() else { fault("a plant is not controllable") };
        let offset = self.offset();
        // The inputs under way as they act, with what is added to them.
        let states = (0..order)
            .map(|j| match j.checked_sub(self.spec.n) {
                None => self.coordinate(j + 1),
                Some(i) => {
                    let under_way = Expr::field(format!("u{}", i + 1)).add(offset.clone());
                    under_way.sub(self.rate(i + 1))
                }
            })
            .collect();
        Flat { s, drift, powers: pair.powers, states }
    }

    /// Returns statements of the flat coordinates, each times its row, and the law of `rows` with as many samples to go as `now`
    /// counts.
    pub(super) fn formula(
        &mut self,
        flat: &Flat,
        rows: &[Expr],
        [z, weight]: [&str; 2],
        now: &Now,
    ) -> (Vec<Statement>, Expr) {
        let order = rows.len();
        let mut statements = Vec::with_capacity(order);
        for (i, row) in rows.iter().enumerate() {
            let numbers =
                (0..order).map(|j| row.clone().mul(Expr::Number(flat.s.at(i, j).clone())));
            let value = self.combine(flat, &format!("{weight}{}", i + 1), numbers.collect());
            statements.push(Statement::Let(
                self.named(&format!("{z}{}", i + 1)),
                Shape::Real,
                value,
            ));
        }
        let horner = (0..order).fold(Expr::integer(0), |sum, i| {
            let own = Expr::local(self.named(&format!("{z}{}", i + 1)));
            let beyond = i64::from(now.shift) - i64::try_from(i).unwrap_or(0);
            sum.add(own).div(now.left.clone().add(Expr::integer(beyond)))
        });
        let drifts: Vec<_> = flat.drift.iter().map(|a| -a).collect();
        let drifts = (0..order).map(|j| Expr::Number(flat.column(&drifts, j))).collect();
        let drifts = self.combine(flat, "c", drifts);
        (statements, horner.add(drifts))
    }

    /// Deadbeat: the drift is in its gains.
    pub(super) fn deadbeat(&mut self, flat: &Flat) -> Expr {
        let order = flat.order();
        let dead: Vec<_> = deadbeat(order).iter().zip(&flat.drift).map(|(b, a)| b - a).collect();
        let dead = (0..order).map(|j| Expr::Number(flat.column(&dead, j))).collect();
        self.combine(flat, "b", dead)
    }

    /// The sum of the states, each times its number.
    fn combine(&mut self, flat: &Flat, name: &str, numbers: Vec<Expr>) -> Expr {
        let used = numbers.into_iter().enumerate().filter(|(_, number)| !number.is_zero());
        let terms: Vec<_> = used
            .map(|(j, number)| {
                let value = number.mul(self.period(-flat.powers[j]));
                let name = self.named(&format!("{name}_{}", j + 1));
                let weight = self.keep(&name, "weight of a state in the law", value);
                weight.mul(flat.states[j].clone())
            })
            .collect();
        Expr::sum(terms)
    }
}
