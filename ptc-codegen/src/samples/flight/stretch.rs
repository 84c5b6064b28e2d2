//! Statements of the signals of a chain, as Bernstein coefficients, from the samples to go that are tried.

use std::ops::{Add, Div, Mul, Sub};

use super::super::predicted::weighted;
use super::bounds::{Limits, TRIED};
use crate::code::{Expr, Shape, Statement, Test};
use crate::linear::{Curve, Stretch};

/// Letters of the signals: u and the states with limits.
const LETTERS: [&str; 5] = ["b", "s", "v", "a", "j"];

/// Local values of one chain.
pub(super) struct Writer {
    /// The output or axis, where there are several.
    output: Option<usize>,
    /// The statements that set them.
    pub(super) body: Vec<Statement>,
}

impl Writer {
    pub(super) fn new(output: Option<usize>) -> Self {
        Self { output, body: Vec::new() }
    }

    /// Sets a value, and returns it.
    fn set(&mut self, name: &str, value: Expr) -> Expr {
        let name = match self.output {
            Some(output) => format!("{name}_{output}"),
            None => name.to_owned(),
        };
        self.body.push(Statement::Let(name.clone(), Shape::Real, value));
        Expr::local(name)
    }

    /// Names a value of a signal at the end.
    pub(super) fn end(&mut self, value: Expr) -> Expr {
        self.set(&format!("end{}", self.body.len()), value)
    }

    /// Tests that the limits are kept from a stretch on.
    pub(super) fn within(
        &mut self,
        stretch: &Stretch,
        flat: &[Expr],
        limits: &Limits,
    ) -> Vec<Test> {
        let m = self.set("m", Expr::local(TRIED).real());
        let weights = self.weights(stretch, flat, &m);
        let mut tests = Vec::new();
        let length = m.sub(Expr::integer(i64::from(stretch.above) + 1));
        let length = self.set("length", length);
        for (curve, letter) in stretch.curves.iter().zip(LETTERS.iter().cycle()) {
            for value in self.coefficients(curve, &weights, &length, letter) {
                tests.extend(limits.admit(curve.signal, &value));
            }
        }
        for bound in &stretch.behind {
            let value = weighted(&bound.row, &|i| weights[i].clone());
            tests.extend(limits.admit_bound(bound, value, &mut |value| self.end(value)));
        }
        tests
    }

    /// The factors w of the falling powers that give the coordinates.
    fn weights(&mut self, stretch: &Stretch, flat: &[Expr], m: &Expr) -> Vec<Expr> {
        let course = &stretch.course;
        let order = flat.len();
        // The falling powers of the samples that the law counts.
        let mut powers: Vec<Expr> = Vec::new();
        for q in 0..i64::from(course.exponent(order - 1)) {
            let factor = m.clone().add(Expr::integer(course.shift() - q));
            let value = match powers.last() {
                Some(last) => last.clone().mul(factor),
                None => factor,
            };
            powers.push(self.set(&format!("power{}", q + 1), value));
        }
        let power = |count: usize| match count.checked_sub(1) {
            Some(index) => powers[index].clone(),
            None => Expr::integer(1),
        };
        let scaled: Vec<_> = (0..order)
            .map(|i| match i {
                0 => flat[0].clone(),
                i => self.set(&format!("scaled{}", i + 1), flat[i].clone().mul(power(i))),
            })
            .collect();
        (0..order)
            .map(|j| {
                let sum = weighted(&stretch.amplitudes.rows()[j], &|i| scaled[i].clone());
                let exponent = usize::try_from(course.exponent(j)).unwrap_or(usize::MAX);
                self.set(&format!("w{}", j + 1), sum.div(power(exponent)))
            })
            .collect()
    }

    /// The Bernstein coefficients of a signal.
    fn coefficients(
        &mut self,
        curve: &Curve,
        weights: &[Expr],
        length: &Expr,
        letter: &str,
    ) -> Vec<Expr> {
        let mut scale = Expr::integer(1);
        let mut powers = Vec::new();
        let last = curve.powers.len() - 1;
        for (q, factors) in curve.powers.iter().enumerate() {
            let value = weighted(factors, &|i| weights[i].clone()).mul(scale.clone());
            powers.push(self.set(&format!("{letter}{q}_c"), value));
            if q < last {
                let next = scale.mul(length.clone());
                scale = match q {
                    0 => next,
                    q => self.set(&format!("{letter}{}_l", q + 1), next),
                };
            }
        }
        let mut all = vec![powers[0].clone()];
        for (i, row) in curve.bernstein.iter().enumerate().skip(1) {
            let value = weighted(row, &|i| powers[i].clone());
            all.push(self.set(&format!("{letter}{i}"), value));
        }
        all
    }
}
