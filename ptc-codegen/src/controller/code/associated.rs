//! The functions of the associated system: its right-hand side, and the ways to the plant and back.

use super::{Builder, Routine};
use crate::code::{
    Access, Expr, Finish, Function, Owner, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::program::Input;

impl Builder<'_> {
    /// `rate`, and `state`, `control`, `time` and `start`.
    pub(super) fn associated(&self) -> Vec<Function> {
        vec![self.rate(), self.state(), self.control(), self.time(), self.start_of_plant()]
    }

    /// xi_i' = xi_{i+1}, xi_n' = mu'^n f + pi0(xi, t).
    fn rate(&self) -> Function {
        let states = self.arrays();
        let mut statements = self.locals(&states);
        let drift = [Test::Finite(Expr::local("f"))];
        statements.push(self.legal([self.legal_time(), drift.to_vec()].concat(), &states));
        let body = self.body(Routine::Step, &states);
        statements.extend(body.statements);
        let Some(law) = body.roots.first() else { fault("a rate without a law") };
        statements.push(Statement::Let("v".to_owned(), Shape::Real, law.clone()));
        let mut rates: Vec<_> = (2..=self.spec.n).map(|j| Expr::local(format!("x{j}"))).collect();
        rates.push(Expr::local("v"));
        Function {
            arguments: [
                self.arguments(),
                vec![Variable::new("f", Shape::Real, "the plant's own f, 0 for none")],
            ]
            .concat(),
            results: vec![self.array("xi_dot", "derivatives of the state")],
            finish: Finish::choose(
                Test::Finite(Expr::local("v")),
                Finish::give(rates, Status::Ok),
                Finish::Fail(Status::Range),
            ),
            body: statements,
            ..self.function(
                "rate",
                "xi_dot of the infinite-time system at its time t [s], from its state xi and the plant's own f (0 for none).",
            )
        }
    }

    /// x = BB_n\[mu\] xi.
    fn state(&self) -> Function {
        let states = self.arrays();
        Function {
            callbacks: Vec::new(),
            arguments: self.arguments(),
            results: vec![self.array("x", "state of the plant: x1, its rate, ...")],
            ..self.given(
                (Routine::Plant, self.legal_time(), &states),
                "state",
                "State x of the plant where the infinite-time system has the state xi at its time t [s].",
            )
        }
    }

    /// u of the plant there.
    fn control(&self) -> Function {
        let states = self.arrays();
        Function {
            arguments: self.arguments(),
            results: vec![Variable::new("u", Shape::Real, "input of the plant")],
            ..self.given(
                (Routine::Control, self.legal_time(), &states),
                "control",
                "Input u of the plant, before it is clipped, where the infinite-time system has the state xi at its time t [s].",
            )
        }
    }

    /// t0 + mu(t - t0).
    fn time(&self) -> Function {
        Function {
            callbacks: Vec::new(),
            arguments: vec![Variable::new("t", Shape::Real, "time of the infinite-time system, s")],
            results: vec![Variable::new("plant_time", Shape::Real, "time of the plant, s")],
            ..self.given(
                (Routine::Time, self.legal_time(), &[]),
                "time",
                "Time of the plant [s] at the time t [s] of the infinite-time system.",
            )
        }
    }

    /// xi(t0) = BB_n\[kappa\](0) x(t0).
    fn start_of_plant(&self) -> Function {
        let states: Vec<_> = (1..=self.spec.n).map(Input::StateAtStart).collect();
        Function {
            callbacks: Vec::new(),
            arguments: vec![self.array("x0", "state of the plant at the start")],
            results: vec![self.array("xi", "state of the infinite-time system")],
            ..self.given(
                (Routine::Start, Vec::new(), &states),
                "start",
                "State xi of the infinite-time system at the start, from the state x0 of the plant there.",
            )
        }
    }

    /// Returns a function of the results of `routine` where `first` holds and the states are finite, if all of them are
    /// finite.
    fn given(
        &self,
        (routine, first, states): (Routine, Vec<Test>, &[Input]),
        name: &'static str,
        about: &str,
    ) -> Function {
        let body = self.body(routine, states);
        let mut statements = self.locals(states);
        statements.push(self.legal(first, states));
        statements.extend(body.statements);
        let mut results = Vec::with_capacity(body.roots.len());
        for (index, root) in (1..).zip(body.roots) {
            let result = format!("result{index}");
            statements.push(Statement::Let(result.clone(), Shape::Real, root));
            results.push(Expr::local(result));
        }
        let finite = results.iter().cloned().map(Test::Finite).collect();
        Function {
            finish: Finish::choose(
                Test::All(finite),
                Finish::give(results, Status::Ok),
                Finish::Fail(Status::Range),
            ),
            body: statements,
            ..self.function(name, about)
        }
    }

    /// Requires that `first` holds and the states are finite.
    fn legal(&self, first: Vec<Test>, states: &[Input]) -> Statement {
        let finite = states.iter().map(|state| Test::Finite(self.local(*state)));
        Statement::Require(Test::All(first.into_iter().chain(finite).collect()), Status::Input)
    }

    fn arguments(&self) -> Vec<Variable> {
        vec![
            Variable::new("t", Shape::Real, "time of the infinite-time system, s"),
            self.array("xi", "its state"),
        ]
    }

    fn function(&self, name: &'static str, about: &str) -> Function {
        Function {
            name,
            about: about.to_owned(),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: Vec::new(),
            callbacks: self.callbacks(),
            results: Vec::new(),
            failures: vec![Status::Input, Status::Range],
            body: Vec::new(),
            finish: Finish::Fail(Status::Range),
            guarded: true,
        }
    }
}
