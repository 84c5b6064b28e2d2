//! The tests that a deadline keeps all limits, from the flat coordinates and the samples to go.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::super::controller::Builder;
use super::super::predicted::weighted;
use crate::algebra::integer;
use crate::code::{Expr, Place, Shape, Statement, Test};
use crate::expression::Function;
use crate::linear::{Bound, Curve, Horizon, Signal, Stretch};

/// The samples to go that are tried.
pub(super) const TRIED: &str = "tried";

/// 1 if the limits are kept.
pub(super) const FITS: &str = "fits";

/// The limits of the signals, as statements have set them.
pub(super) struct Limits {
    /// Lower and upper limit of the law.
    input: [Option<Expr>; 2],
    /// The smaller of their distances from 0.
    within: Option<Expr>,
    /// The bounds of the states.
    states: Vec<Option<Expr>>,
}

impl Limits {
    /// Tests that a value of a signal is within its limits.
    fn admit(&self, signal: Signal, value: &Expr) -> Vec<Test> {
        let [least, most] = match signal {
            Signal::Input => self.input.clone(),
            Signal::State(i) => {
                let most = self.states[i].clone();
                [most.clone().map(Neg::neg), most]
            }
        };
        let least = least.map(|least| Test::AtMost(least, value.clone()));
        let most = most.map(|most| Test::AtMost(value.clone(), most));
        least.into_iter().chain(most).collect()
    }

    /// Tests that the size of a sum is within a share of the limits of its signal.
    fn admit_size(&self, bound: &Bound, value: Expr) -> Vec<Test> {
        let limit = match bound.signal {
            Signal::Input => self.within.clone(),
            Signal::State(i) => self.states[i].clone(),
        };
        let size = || Expr::Call(Function::Abs, Box::new(value.clone()));
        let share = |limit: Expr| Expr::Number(bound.share.clone()).mul(limit);
        limit.map(|limit| Test::AtMost(size(), share(limit))).into_iter().collect()
    }
}

impl Builder<'_> {
    /// Statements that set the limits, a part of those of the design: what roundings and the reserve leave.
    pub(super) fn plan_limits(
        &mut self,
        horizon: &Horizon,
        part: &Expr,
        held: bool,
    ) -> (Vec<Statement>, Limits) {
        let offset = self.offset();
        let bounds = self.limits();
        let mut body = Vec::new();
        let mut named = |name: &str, value: Expr| {
            body.push(Statement::Let(name.to_owned(), Shape::Real, value));
            Expr::local(name)
        };
        let scaled = |limit: &Expr| limit.clone().mul(part.clone()).add(offset.clone());
        let least = bounds.least.as_ref().map(|limit| named("least", scaled(limit)));
        let most = bounds.most.as_ref().map(|limit| named("most", scaled(limit)));
        let within = match (least.clone(), most.clone()) {
            _ if !sizes(horizon, held) => None,
            (Some(least), Some(most)) => {
                let below = least.neg();
                let test = Test::Less(below.clone(), most.clone());
                Some(named("within", Expr::choose(test, below, most)))
            }
            (least, most) => most.or_else(|| least.map(Neg::neg)),
        };
        let states = (0..self.spec.n).map(|i| {
            let bound = self.flight().and_then(|flight| flight.state_max(i)).cloned();
            bound.map(|bound| {
                named(&format!("most{}", i + 1), Expr::Number(bound).mul(part.clone()))
            })
        });
        let states = states.collect();
        (body, Limits { input: [least, most], within, states })
    }

    /// Statements that set `fits` for so many samples to go; `held` if they may be those of held gains.
    pub(super) fn fits(
        &mut self,
        horizon: &Horizon,
        flat: &[Expr],
        limits: &Limits,
        held: bool,
    ) -> Vec<Statement> {
        let tried = || Expr::local(TRIED);
        let mut all = match held {
            true => {
                let row = |bound: &Bound| {
                    limits.admit_size(bound, weighted(&bound.row, &|i| flat[i].clone()))
                };
                settle(horizon.held.iter().flat_map(row).collect())
            }
            false => Vec::new(),
        };
        for stretch in horizon.stretches.iter().rev() {
            let own = within(stretch, flat, limits);
            all = match all.is_empty() {
                true => own,
                false => {
                    let above = Test::CountLess(Expr::Count(stretch.above), tried());
                    vec![Statement::If(above, own, all)]
                }
            };
        }
        all.insert(0, Statement::Begin(FITS.to_owned(), Shape::Count, Expr::Count(0)));
        all
    }
}

/// Returns true if u is bounded by its size.
fn sizes(horizon: &Horizon, held: bool) -> bool {
    let behind = horizon.stretches.iter().flat_map(|stretch| &stretch.behind);
    let by_size = behind.filter(|bound| bound.share != integer(1));
    let of_held = horizon.held.iter().filter(|_| held);
    by_size.chain(of_held).any(|bound| bound.signal == Signal::Input)
}

/// The statement that sets `fits` where all tests hold.
fn settle(tests: Vec<Test>) -> Vec<Statement> {
    let set = Statement::Set(Place::Local(FITS.to_owned()), Expr::Count(1));
    vec![Statement::If(Test::All(tests), vec![set], Vec::new())]
}

/// Statements that set `fits` where the limits are kept from a stretch on.
fn within(stretch: &Stretch, flat: &[Expr], limits: &Limits) -> Vec<Statement> {
    let mut body = vec![Statement::Let("m".to_owned(), Shape::Real, Expr::local(TRIED).real())];
    let weights = weights(stretch, flat, &mut body);
    let mut tests = Vec::new();
    let length = Expr::local("m").sub(Expr::integer(i64::from(stretch.above) + 1));
    body.push(Statement::Let("length".to_owned(), Shape::Real, length));
    for (curve, letter) in stretch.curves.iter().zip(["b", "s", "v", "a", "j"].iter().cycle()) {
        for value in coefficients(curve, &weights, letter, &mut body) {
            tests.extend(limits.admit(curve.signal, &value));
        }
    }
    for bound in &stretch.behind {
        let value = weighted(&bound.row, &|i| weights[i].clone());
        // A value of the signal itself has two limits.
        if bound.share == integer(1) {
            let name = format!("end{}", body.len());
            body.push(Statement::Let(name.clone(), Shape::Real, value));
            tests.extend(limits.admit(bound.signal, &Expr::local(name)));
        } else {
            tests.extend(limits.admit_size(bound, value));
        }
    }
    body.extend(settle(tests));
    body
}

/// The factors w of the falling powers that give the coordinates, with the statements that set them.
fn weights(stretch: &Stretch, flat: &[Expr], body: &mut Vec<Statement>) -> Vec<Expr> {
    let course = &stretch.course;
    let order = flat.len();
    let set = |body: &mut Vec<Statement>, name: String, value: Expr| {
        body.push(Statement::Let(name.clone(), Shape::Real, value));
        Expr::local(name)
    };
    // The falling powers of the samples that the law counts.
    let mut powers: Vec<Expr> = Vec::new();
    for q in 0..i64::from(course.exponent(order - 1)) {
        let factor = Expr::local("m").add(Expr::integer(course.shift() - q));
        let value = match powers.last() {
            Some(last) => last.clone().mul(factor),
            None => factor,
        };
        powers.push(set(body, format!("power{}", q + 1), value));
    }
    let power = |count: usize| match count.checked_sub(1) {
        Some(index) => powers[index].clone(),
        None => Expr::integer(1),
    };
    let scaled: Vec<_> = (0..order)
        .map(|i| match i {
            0 => flat[0].clone(),
            i => set(body, format!("scaled{}", i + 1), flat[i].clone().mul(power(i))),
        })
        .collect();
    (0..order)
        .map(|j| {
            let sum = weighted(&stretch.amplitudes.rows()[j], &|i| scaled[i].clone());
            let exponent = usize::try_from(course.exponent(j)).unwrap_or(usize::MAX);
            set(body, format!("w{}", j + 1), sum.div(power(exponent)))
        })
        .collect()
}

/// The Bernstein coefficients of a signal, with the statements that set them.
fn coefficients(
    curve: &Curve,
    weights: &[Expr],
    letter: &str,
    body: &mut Vec<Statement>,
) -> Vec<Expr> {
    let mut scale = Expr::integer(1);
    let mut powers = Vec::new();
    let last = curve.powers.len() - 1;
    for (q, factors) in curve.powers.iter().enumerate() {
        let name = format!("{letter}{q}_c");
        let value = weighted(factors, &|i| weights[i].clone()).mul(scale.clone());
        body.push(Statement::Let(name.clone(), Shape::Real, value));
        powers.push(Expr::local(name));
        if q < last {
            let next = scale.mul(Expr::local("length"));
            scale = match q {
                0 => next,
                q => {
                    let name = format!("{letter}{}_l", q + 1);
                    body.push(Statement::Let(name.clone(), Shape::Real, next));
                    Expr::local(name)
                }
            };
        }
    }
    let mut all = vec![powers[0].clone()];
    for (i, row) in curve.bernstein.iter().enumerate().skip(1) {
        let name = format!("{letter}{i}");
        body.push(Statement::Let(name.clone(), Shape::Real, weighted(row, &|i| powers[i].clone())));
        all.push(Expr::local(name));
    }
    all
}
