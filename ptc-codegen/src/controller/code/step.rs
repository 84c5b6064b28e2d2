//! `step`: u at a time and a state; and `rate`, that of the infinite-time system.

use super::Builder;
use crate::code::{
    Access, Bounds, Expr, Finish, Function, Operator, Owner, Place, Shape, Statement, Status, Test,
    Variable,
};
use crate::controller::plan::Routine;
use crate::internal::fault;
use crate::parameter::Name;
use crate::program::Least;
use crate::request::{After, Guard};

impl Builder<'_> {
    pub(super) fn step(&self) -> Function {
        let inputs = self.inputs_of_step();
        let mut statements = self.locals(&inputs.local);
        statements.extend(inputs.required());
        let body = self.body(Routine::Step, &inputs.local);
        statements.extend(body.statements);
        let [law, late, past @ ..] = body.roots.as_slice() else { fault("a step without a law") };
        let past = past.first();
        let zero = || Expr::integer(0);
        let t = || Expr::local("t");
        let mut v = match past {
            None => law.clone(),
            Some(past) => {
                let over = Test::AtMost(zero(), past.clone());
                match self.spec.after {
                    After::Extern => {
                        // The user's function is called where it is needed alone.
                        let next = Expr::Callback("after", "x".to_owned(), Box::new(t()));
                        let set =
                            |value| vec![Statement::Set(Place::Local("applied".to_owned()), value)];
                        statements.push(Statement::Variable("applied".to_owned(), Shape::Real));
                        statements.push(Statement::If(over, set(next), set(law.clone())));
                        Expr::local("applied")
                    }
                    After::Hold | After::Zero => Expr::choose(over, zero(), law.clone()),
                }
            }
        };
        if self.spec.guard == Guard::Result {
            // t itself may cancel in u.
            let unknown = Expr::binary(Operator::Sub, t(), t());
            v = Expr::binary(Operator::Add, v, unknown);
        }
        statements.push(Statement::Let("v".to_owned(), Shape::Real, v));
        let give = |status| Finish::give(vec![Expr::local("v")], status);
        let held = match past {
            Some(past) => Finish::choose(
                Test::AtMost(zero(), past.clone()),
                give(Status::After),
                give(Status::Hold),
            ),
            None => give(Status::Hold),
        };
        let range = Finish::Fail(Status::Range);
        let finite = || Test::Finite(Expr::local("v"));
        let ahead = Test::Less(late.clone(), self.field(self.limits.hold_from));
        let finish = if self.guarded() && inputs.waiting.is_empty() {
            let legal = Finish::choose(ahead, give(Status::Ok), held);
            Finish::choose(finite(), self.clipped(legal), range)
        } else if self.guarded() {
            let hot = self.within_bounds().into_iter().chain([ahead]);
            let rest = Finish::choose(finite(), self.clipped(held), range);
            inputs.behind(hot.collect(), give(Status::Ok), rest)
        } else {
            let about =
                "Time-to-go, or no number where v is not finite: one comparison detects tracking.";
            statements.push(Statement::Note(about.to_owned()));
            let v = || Expr::local("v");
            let nothing = Expr::binary(Operator::Sub, v(), v());
            let margin = Expr::binary(Operator::Sub, nothing, late.clone());
            statements.push(Statement::Let("margin".to_owned(), Shape::Real, margin));
            let margin = Expr::local("margin");
            let tracks = Test::Less(self.field(self.limits.eps), margin.clone());
            let overflow = || Test::NotNumber(margin.clone());
            let other = Finish::choose(overflow(), range.clone(), held);
            let within = Finish::choose(tracks, give(Status::Ok), other);
            // Examined where v is beyond a limit, which costs nothing elsewhere.
            Self::limited(within, &self.bounds(), |clips| {
                Finish::choose(overflow(), range.clone(), clips)
            })
        };
        Function {
            name: "step",
            about: match (&self.spec.model, self.reference()) {
                (None, None) => "u at time t [s] and state x = (x1, x1', ...).".to_owned(),
                (None, Some(_)) => {
                    "u at time t [s], state x = (x1, x1', ...) and reference r = (r, r', ...)."
                        .to_owned()
                }
                (Some(model), None) => {
                    format!("u at time t [s] and state x = ({}).", Name::listed(&model.states))
                }
                (Some(model), Some(_)) => format!(
                    "u at time t [s], state x = ({}) and reference r = (r, r', ...) of the output.",
                    Name::listed(&model.states)
                ),
            },
            owner: Owner::Controller,
            access: Access::Read,
            arguments: [
                Variable::new("t", Shape::Real, "time, s"),
                match &self.spec.model {
                    None => self.array("x", "state: x1, its rate, ..."),
                    Some(model) => {
                        self.array("x", &format!("state: {}", Name::listed(&model.states)))
                    }
                },
            ]
            .into_iter()
            .chain(self.reference())
            .collect(),
            callbacks: self.callbacks(),
            results: vec![Variable::new("u", Shape::Real, "input of the plant")],
            failures: self.failures(),
            body: statements,
            finish,
            guarded: self.guarded(),
        }
    }

    /// The end of a call that gives `v`, where v is within its limits.
    pub(super) fn clipped(&self, within: Finish) -> Finish {
        Self::clipped_at(within, &self.bounds())
    }

    /// The same with these limits.
    pub(super) fn clipped_at(within: Finish, limits: &Bounds) -> Finish {
        Self::limited(within, limits, |clips| clips)
    }

    /// The end of a call whose `v` is not finite or beyond one of these limits.
    pub(super) fn outside(limits: &Bounds) -> Finish {
        let v = Expr::local("v");
        let ends: Vec<_> = limits.beyond(&v).collect();
        let clips = |limit| Finish::give(vec![limit], Status::Saturated);
        let beyond = ends.into_iter().rev().fold(None, |rest, (test, limit)| match rest {
            Some(rest) => Some(Finish::choose(test, clips(limit), rest)),
            None => Some(clips(limit)),
        });
        let range = Finish::Fail(Status::Range);
        match beyond {
            Some(beyond) => Finish::choose(Test::Finite(v), beyond, range),
            None => range,
        }
    }

    /// The end `within`, or the result of `beyond` where a limit is exceeded.
    fn limited(within: Finish, limits: &Bounds, beyond: impl Fn(Finish) -> Finish) -> Finish {
        let tests: Vec<_> = limits.beyond(&Expr::local("v")).collect();
        tests.into_iter().rev().fold(within, |rest, (test, limit)| {
            let clips = Finish::give(vec![limit], Status::Saturated);
            Finish::choose(test, beyond(clips), rest)
        })
    }

    /// The limits of u that all inputs share.
    pub(super) fn bounds(&self) -> Bounds {
        let most = self.limits.u_max.map(|limit| self.field(limit));
        match self.limits.u_min {
            Least::Opposite => Bounds::symmetric(most),
            least => Bounds::between(least.value().map(|limit| self.field(limit)), most),
        }
    }

    /// The statuses with which a function fails that gives u.
    pub(super) fn failures(&self) -> Vec<Status> {
        match self.guarded() {
            true => vec![Status::Input, Status::Range],
            false => vec![Status::Range],
        }
    }
}
