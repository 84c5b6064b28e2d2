//! The formula of a law in samples, in the flat coordinates of its loop.

use std::ops::{Add, Div, Mul, Sub};

use super::controller::Builder;
use super::coordinates::Coordinates;
use super::falling::FallingPowers;
use super::rows::deadbeat;
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Shape, Statement};
use crate::internal::fault;
use crate::linear::dot;
use crate::parameter::Parameter;

/// Flat coordinates z = S x of a loop, by its states.
pub(super) struct Flat {
    of: Coordinates,
    /// The states, and the inputs under way.
    states: Vec<Expr>,
}

impl Flat {
    /// The number of coordinates.
    pub(super) fn order(&self) -> usize {
        self.of.drift.len()
    }

    /// The factor of state `j` in a sum of coordinates, each times its factor.
    fn column(&self, factors: &[BigRational], j: usize) -> BigRational {
        dot(factors.iter().enumerate().map(|(i, factor)| (factor, self.of.s.at(i, j))))
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
    pub(super) fn flat(&mut self) -> Flat {
        let of = Coordinates::of(self.spec.n, self.sampled, self.fixed(Parameter::SampleTime));
        let Some(of) = of else { fault("a plant is not controllable") };
        let states = self.states_of_loop(of.powers.len());
        Flat { of, states }
    }

    /// The states of the loop: those of the plant, and the inputs under way as they act, with what is added to them.
    pub(super) fn states_of_loop(&mut self, count: usize) -> Vec<Expr> {
        (0..count)
            .map(|j| match j.checked_sub(self.spec.n) {
                None => self.coordinate(j + 1),
                Some(i) => {
                    let under_way = Expr::field(format!("u{}", i + 1)).add(self.offset_of(i + 1));
                    under_way.sub(self.rate(i + 1))
                }
            })
            .collect()
    }

    /// Returns statements of the flat coordinates, each times its row, and the law of `rows` with as many samples to go as `now`
    /// counts.
    pub(super) fn formula(
        &mut self,
        flat: &Flat,
        rows: &[Expr],
        [z, weight, falling]: [&str; 3],
        now: &Now,
    ) -> (Vec<Statement>, Expr) {
        let mut statements = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            let numbers = (0..flat.states.len())
                .map(|j| row.clone().mul(Expr::Number(flat.of.s.at(i, j).clone())));
            let value = self.combine(flat, &format!("{weight}{}", i + 1), numbers.collect());
            statements.push(Statement::Let(
                self.named(&format!("{z}{}", i + 1)),
                Shape::Real,
                value,
            ));
        }
        let own = (1..=rows.len()).map(|i| Expr::local(self.named(&format!("{z}{i}"))));
        let factors = (0..rows.len()).map(|i| {
            let beyond = i64::from(now.shift) - i64::try_from(i).unwrap_or(0);
            now.left.clone().add(Expr::integer(beyond))
        });
        let (own, factors): (Vec<_>, Vec<_>) = (own.collect(), factors.collect());
        let sum = match self.multiplies(&self.samples(), rows.len()) {
            true => {
                let name = self.named(falling);
                let powers = FallingPowers::new(&name, factors, &mut statements);
                powers.numerator(own).div(powers.last())
            }
            false => own
                .into_iter()
                .zip(factors)
                .fold(Expr::integer(0), |sum, (own, factor)| sum.add(own).div(factor)),
        };
        let drifts: Vec<_> = flat.of.drift.iter().map(|a| -a).collect();
        let drifts = (0..flat.states.len()).map(|j| Expr::Number(flat.column(&drifts, j)));
        let drifts = drifts.collect();
        let drifts = self.combine(flat, "c", drifts);
        (statements, sum.add(drifts))
    }

    /// Coordinate `i`, from 0.
    pub(super) fn flat_coordinate(&mut self, flat: &Flat, i: usize) -> Expr {
        self.flat_coordinate_times(&integer(1), flat, i)
    }

    /// The same times a number.
    pub(super) fn flat_coordinate_times(
        &mut self,
        factor: &BigRational,
        flat: &Flat,
        i: usize,
    ) -> Expr {
        let row = flat.of.s.rows()[i].iter().map(|own| Expr::Number(own * factor)).collect();
        self.combine(flat, &format!("s{}", i + 1), row)
    }

    /// Deadbeat: the drift is in its gains.
    pub(super) fn deadbeat(&mut self, flat: &Flat) -> Expr {
        let gains = deadbeat(flat.order());
        let dead: Vec<_> = gains.iter().zip(&flat.of.drift).map(|(b, a)| b - a).collect();
        let dead = (0..flat.states.len()).map(|j| Expr::Number(flat.column(&dead, j))).collect();
        self.combine(flat, "b", dead)
    }

    /// The sum of the states, each times its number.
    fn combine(&mut self, flat: &Flat, name: &str, numbers: Vec<Expr>) -> Expr {
        let used = numbers.into_iter().enumerate().filter(|(_, number)| !number.is_zero());
        let terms: Vec<_> = used
            .map(|(j, number)| {
                let value = number.mul(self.period(-flat.of.powers[j]));
                let name = self.named(&format!("{name}_{}", j + 1));
                let about = match j.checked_sub(self.spec.n) {
                    None => format!("weight of x{} in the law", j + 1),
                    Some(i) => format!("weight of u{} in the law", i + 1),
                };
                let weight = self.keep(&name, &about, value);
                weight.mul(flat.states[j].clone())
            })
            .collect();
        Expr::sum(terms)
    }
}
