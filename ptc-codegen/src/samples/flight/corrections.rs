//! Corrections between two samples: of the target, of the estimated state and disturbance, of the applied input.

use std::ops::{Mul, Sub};

use super::super::controller::Builder;
use crate::algebra::BigRational;
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::linear::{Matrix, Pair};

/// A function that corrects the controller: its name, argument and statements.
struct Correction {
    name: &'static str,
    about: &'static str,
    argument: Variable,
    body: Vec<Statement>,
}

impl Builder<'_> {
    /// The state for which the next input is computed: the argument that holds what of it is not estimated, and
    /// statements that set it.
    pub(super) fn state_of_now(&mut self) -> (Option<Variable>, Vec<Statement>) {
        if !self.designs.is_empty() {
            let body = self.finite(self.states_of_axes()).into_iter();
            let argument = self.argument_of_axes();
            return (Some(argument), body.chain(self.chains_of_axes()).collect());
        }
        if self.sampled.linear.is_some() {
            return self.state_of_plant();
        }
        let real = Shape::Real;
        let measured = self.sampled.measured;
        let observes = self.sampled.observes();
        let direct = if observes { measured - 1 } else { measured };
        let given = if observes { "y" } else { "x" };
        let argument =
            (direct > 0).then(|| Variable::new(given, Shape::Reals(measured), self.given()));
        let elements = (0..direct).map(|l| Expr::Element(given.to_owned(), l));
        let mut body: Vec<_> =
            self.finite(elements.clone()).filter(|_| direct > 0).into_iter().collect();
        body.extend(
            elements.zip(1..).map(|(value, j)| Statement::Let(format!("x{j}"), real, value)),
        );
        if observes {
            let pair = self.pair_of_chain();
            body.extend(self.prediction(&pair));
            for (name, i) in self.estimated().into_iter().zip(1..) {
                body.push(Statement::Let(name, real, Expr::local(format!("p{i}"))));
            }
        }
        (argument, body)
    }

    /// The same of a linear plant, all of whose states are estimated, if any are.
    fn state_of_plant(&mut self) -> (Option<Variable>, Vec<Statement>) {
        let real = Shape::Real;
        if !self.sampled.observes() {
            let measured = self.sampled.measured;
            let given = if self.sampled.measures_states() { "x" } else { "y" };
            let elements = (0..measured).map(|l| Expr::Element(given.to_owned(), l));
            let mut body: Vec<_> = self.finite(elements).into_iter().collect();
            let states = self.states(given).into_iter().zip(1..);
            body.extend(states.map(|(value, j)| Statement::Let(format!("x{j}"), real, value)));
            let argument = Variable::new(given, Shape::Reals(measured), self.given());
            return (Some(argument), body);
        }
        let Some(plant) = self.sampled.linear.clone() else { fault("no linear plant") };
        let predicted = self.predicted_now(&plant).into_iter();
        let body = predicted.map(|(name, value)| Statement::Let(name, real, value));
        (None, body.collect())
    }

    /// `move`, `assume`, `assume_disturbance` and `applied`, as far as they have a meaning.
    pub(super) fn corrections(&mut self) -> Vec<Function> {
        let mut functions = Vec::new();
        if self.sampled.observes() {
            functions.extend(self.moves());
            functions.push(self.assumes());
            functions.extend(self.assumes_disturbance());
        }
        if self.remembered() > 0 {
            functions.push(self.applied());
        }
        functions
    }

    fn correction(&self, correction: Correction) -> Function {
        let Correction { name, about, argument, body } = correction;
        Function {
            name,
            about: about.to_owned(),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: vec![argument],
            callbacks: Vec::new(),
            results: Vec::new(),
            failures: vec![Status::Input],
            body,
            finish: Finish::done(),
            guarded: self.guarded(),
        }
    }

    /// The target of a chain whose x1 is estimated moves.
    fn moves(&self) -> Option<Function> {
        let own = self.sampled.linear.is_none() && self.sampled.first_estimated() == 1;
        own.then(|| {
            let moved = Expr::field("x1_hat").sub(Expr::local("dx"));
            let body = vec![
                Statement::Let("moved".to_owned(), Shape::Real, moved),
                require([Expr::local("moved")]),
                set("x1_hat", Expr::local("moved")),
            ];
            self.correction(Correction {
                name: "move",
                about: "The target moves by `dx`: from now on y is measured from the new one, and so are the estimates.",
                argument: Variable::new("dx", Shape::Real, "new target less the old one"),
                body,
            })
        })
    }

    /// The state at the tick of the next call is known.
    fn assumes(&mut self) -> Function {
        let known = self.sampled.first_estimated();
        let count = self.spec.n + 1 - known;
        let given = |i: usize| Expr::Element("xhat".to_owned(), i);
        let mut body = Vec::new();
        let mut kept = Vec::new();
        match self.sampled.linear.clone() {
            Some(plant) => {
                let pair = self.sampled_plant(&plant);
                for i in 0..count {
                    let next = given(i).sub(self.moved(&pair, i, &Expr::integer(0)));
                    let name = format!("x{}_next", i + 1);
                    body.push(Statement::Let(format!("n{}", i + 1), Shape::Real, next));
                    kept.push((name, format!("n{}", i + 1)));
                    kept.push((format!("x{}_hat", i + 1), String::new()));
                }
            }
            None => {
                let pair = self.pair_of_chain();
                body.extend(self.before(&pair, count, &given));
                kept.extend(
                    (0..count).map(|i| (format!("x{}_hat", known + i), format!("n{}", i + 1))),
                );
            }
        }
        let values = kept.iter().filter(|(_, value)| !value.is_empty());
        body.push(require(values.map(|(_, value)| Expr::local(value))));
        for (i, (field, value)) in kept.iter().enumerate() {
            let value = match value.as_str() {
                "" => given(i / 2),
                value => Expr::local(value),
            };
            body.push(set(field, value));
        }
        body.push(set("seen", Expr::Count(1)));
        self.correction(Correction {
            name: "assume",
            about: "The estimates at the tick of the next call are known: it corrects them by what is measured then.",
            argument: Variable::new("xhat", Shape::Reals(count), "estimates"),
            body,
        })
    }

    /// Statements that set n1, ...: the estimates of a sample ago that are predicted to be these now.
    fn before(
        &mut self,
        pair: &Pair,
        count: usize,
        given: &dyn Fn(usize) -> Expr,
    ) -> Vec<Statement> {
        let Some(back) = pair.phi.inverse() else { fault("a chain has no past") };
        let force = self.force();
        let mut body = Vec::new();
        for i in 0..count {
            let value = given(i).sub(self.moved(pair, i, &force));
            body.push(Statement::Let(format!("g{}", i + 1), Shape::Real, value));
        }
        let value = |j: usize| match j < count {
            true => Expr::local(format!("g{}", j + 1)),
            false => Expr::field("d_hat"),
        };
        for i in 0..count {
            let sum = self.past(&back, pair, i, &value);
            body.push(Statement::Let(format!("n{}", i + 1), Shape::Real, sum));
        }
        body
    }

    /// Row `i` of the way back over a sample.
    fn past(
        &mut self,
        back: &Matrix,
        pair: &Pair,
        i: usize,
        value: &dyn Fn(usize) -> Expr,
    ) -> Expr {
        let mut terms = Vec::new();
        for j in 0..pair.order() {
            let number = back.at(i, j);
            if *number == BigRational::default() {
                continue;
            }
            let unit = self.period(pair.powers[i] - pair.powers[j]);
            let name = format!("back{}_{}", i + 1, j + 1);
            let factor = Expr::Number(number.clone()).mul(unit);
            terms.push(self.keep(&name, "a state of a sample ago", factor).mul(value(j)));
        }
        Expr::sum(terms)
    }

    fn assumes_disturbance(&self) -> Option<Function> {
        self.sampled.disturbance.as_ref().map(|_| {
            let mut body = vec![require([Expr::local("d")]), set("d_hat", Expr::local("d"))];
            if self.sampled.linear.is_some() {
                body.push(set("d_next", Expr::local("d")));
            }
            self.correction(Correction {
                name: "assume_disturbance",
                about: "The constant that is added to u is known.",
                argument: Variable::new("d", Shape::Real, "estimate"),
                body,
            })
        })
    }

    fn applied(&self) -> Function {
        let body = vec![require([Expr::local("u")]), set("u1", Expr::local("u"))];
        self.correction(Correction {
            name: "applied",
            about: "The drive applied `u` in place of the u that the last call of `step` gave.",
            argument: Variable::new("u", Shape::Real, "input as it was applied"),
            body,
        })
    }
}

fn set(field: &str, value: Expr) -> Statement {
    Statement::Set(Place::Field(field.to_owned()), value)
}

/// Requires that values are finite.
fn require(values: impl IntoIterator<Item = Expr>) -> Statement {
    let tests = values.into_iter().map(Test::Finite).collect();
    Statement::Require(Test::All(tests), Status::Input)
}
