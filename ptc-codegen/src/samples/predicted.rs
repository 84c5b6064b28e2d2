//! A linear plant as the controller sees it: its states from y = C x, at once or by an observer.
//!
//! The observer is a predictor, xhat_{k+1} = Phi xhat_k + Gamma u_k + G_k (y_k - C xhat_k): corrected
//! by the current y it would need Phi^-1, which for a mode that decays within a sample is numerically
//! useless.

use std::ops::{Add, Mul, Sub};

use num_traits::Zero;

use super::controller::Builder;
use super::estimates::predicted_from;
use super::gains::{InRound, Named};
use super::observer::Injection;
use crate::algebra::BigRational;
use crate::code::{Expr, Place, Shape, Statement, Test};
use crate::internal::fault;
use crate::linear::{Linear, Matrix, Outputs};

impl Builder<'_> {
    /// The states from the measurements, if these determine all of them.
    pub(super) fn states(&self, given: &str) -> Vec<Expr> {
        let value = |j: usize| Expr::Element(given.to_owned(), j);
        match &self.sampled.linear {
            Some(plant) if !self.sampled.measures_states() => {
                let inverse = Matrix::of(plant.c.clone()).inverse();
                let inverse = inverse.unwrap_or_else(|| fault("C has no inverse"));
                (0..self.spec.n).map(|i| combination(&inverse, i, &value)).collect()
            }
            _ => (0..self.spec.n).map(value).collect(),
        }
    }

    /// The estimates of a linear plant: what was predicted, and the prediction of the next sample.
    /// `unseen` holds at the first measurement.
    pub(super) fn predicted(&mut self, plant: &Linear, end: &Expr, unseen: Test) -> Vec<Statement> {
        let real = Shape::Real;
        let pair = self.sampled_plant(plant);
        let Some(outputs) = Outputs::new(&pair, &plant.c) else {
            fault("a linear plant is not observable")
        };
        let names = self.estimated();
        for name in &names {
            self.remember(&format!("{name}_hat"), &format!("estimate of {name}"));
            self.remember(&format!("{name}_next"), &format!("prediction of {name} without u"));
        }
        let measured = |l: usize| Expr::Element("y".to_owned(), l);
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        let mut body = vec![Statement::Note("The estimates; at first what y shows.".to_owned())];
        body.extend(names.iter().map(|name| Statement::Variable(name.clone(), real)));
        let shown = shown(&plant.c);
        let first = names.iter().enumerate().map(|(i, name)| match i < self.spec.n {
            true => set(name, combination(&shown, i, &measured)),
            false => set(name, Expr::integer(0)),
        });
        let first = first.collect();
        let next = self.predicted_now(plant).into_iter();
        let next = next.map(|(name, value)| set(&name, value)).collect();
        body.push(Statement::If(unseen, first, next));
        body.push(Statement::Note("Prediction of the next sample.".to_owned()));
        let state = |j: usize| Expr::local(names[j].clone());
        let c = Matrix::of(plant.c.clone());
        let count = plant.c.len();
        for l in 0..count {
            let gap = self.before_gate(&format!("{}", l + 1));
            let value = measured(l).sub(combination(&c, l, &state));
            body.push(Statement::Let(gap, real, value));
        }
        let measurements: Vec<_> = (0..count).map(|l| (l, format!("{}", l + 1))).collect();
        body.extend(self.believe(&measurements));
        let miss = |l: usize| Expr::local(format!("miss{}", l + 1));
        let (injections, mixing) = self.injections(&outputs);
        let mixed: Vec<_> = (0..count).map(|i| combination(&mixing, i, &miss)).collect();
        for (mixed, l) in mixed.into_iter().zip(1..) {
            body.push(Statement::Let(format!("off{l}"), real, mixed));
        }
        body.extend(self.gains(&injections, end));
        for (i, name) in names.iter().enumerate() {
            let mut sum = Expr::integer(0);
            for j in 0..names.len() {
                let number = Expr::Number(pair.phi.at(i, j).clone());
                let about = predicted_from(&names, i, j);
                sum = sum.add(
                    self.keep(&format!("phi{}_{}", i + 1, j + 1), &about, number).mul(state(j)),
                );
            }
            for (own, l) in injections.iter().zip(1..) {
                let gain = Expr::local(format!("l{}{}", own.of, i + 1));
                sum = sum.add(gain.mul(Expr::local(format!("off{l}"))));
            }
            body.push(Statement::Let(format!("{name}_on"), real, sum));
        }
        body
    }

    /// The names of the estimates of a linear plant, and what is predicted for now.
    pub(super) fn predicted_now(&mut self, plant: &Linear) -> Vec<(String, Expr)> {
        let pair = self.sampled_plant(plant);
        let each = self.estimated().into_iter().enumerate().map(|(i, name)| {
            let predicted = Expr::field(format!("{name}_next"));
            (name, predicted.add(self.moved(&pair, i, &Expr::integer(0))))
        });
        each.collect()
    }

    /// The gains of all blocks, which end together, and what they are gains of, by the distance of each measured value
    /// from its prediction.
    fn injections(&self, outputs: &Outputs) -> (Vec<Named>, Matrix) {
        let Some(round) = self.round() else {
            let count = outputs.blocks.len();
            let named = (0..count).map(|l| Named {
                of: name_of(l, count),
                round: None,
                lasting: self.stationary().map(|gains| column(gains, l)),
            });
            return (named.collect(), Matrix::identity(count));
        };
        let mut first = 0;
        let mut injections = Vec::new();
        for (i, size) in outputs.blocks.iter().enumerate() {
            let recurrence = self.recurrence(round, first..first + size);
            first += size;
            let injection = Injection::of_block(outputs, i, &recurrence);
            let units = vec![Expr::integer(1); injection.law.len()];
            let round = InRound { injection, units };
            let lasting = match self.stationary() {
                Some(gains) => Some(column(&unmixed(gains, &outputs.mixing), i)),
                None => round.lasting(),
            };
            let of = name_of(i, outputs.blocks.len());
            injections.push(Named { of, round: Some(round), lasting });
        }
        (injections, outputs.mixing.clone())
    }
}

/// The words in the names of the gains for value `l` of so many.
fn name_of(l: usize, count: usize) -> String {
    if count == 1 { String::new() } else { format!("{}_", l + 1) }
}

/// The gains for value `l`.
fn column(gains: &[Vec<BigRational>], l: usize) -> Vec<Expr> {
    gains.iter().map(|row| Expr::Number(row[l].clone())).collect()
}

/// The same gains of mixed values.
fn unmixed(gains: &[Vec<BigRational>], mixing: &Matrix) -> Vec<Vec<BigRational>> {
    let back = mixing.inverse().unwrap_or_else(|| fault("outputs are mixed to fewer"));
    Matrix::of(gains.to_vec()).times(&back).rows().to_vec()
}

/// C^T (C C^T)^-1: the least x that shows y.
fn shown(c: &[Vec<BigRational>]) -> Matrix {
    let c = Matrix::of(c.to_vec());
    let back = c.transpose();
    let inverse = c.times(&back).inverse();
    back.times(&inverse.unwrap_or_else(|| fault("rows of C depend on each other")))
}

/// Row `i` of a matrix times values.
fn combination(matrix: &Matrix, i: usize, value: &dyn Fn(usize) -> Expr) -> Expr {
    weighted(&matrix.rows()[i], value)
}

/// The sum of values with these weights.
pub(super) fn weighted(weights: &[BigRational], value: &dyn Fn(usize) -> Expr) -> Expr {
    let terms = weights
        .iter()
        .enumerate()
        .filter(|(_, weight)| !weight.is_zero())
        .map(|(j, weight)| Expr::Number(weight.clone()).mul(value(j)));
    Expr::sum(terms)
}
