//! The observer for a user-defined law: `update` in place of `step`.
//!
//! A law needs the estimates of sample k before it can give u_k, so `update` is given the input of
//! the sample before, which is known by then: it predicts with the input that acted since, and then
//! corrects. With `delay` d the input of tick k acts from tick k + d on; those under way are kept.

use super::controller::Builder;
use crate::code::{
    Access, Expr, Finish, Function, Owner, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;

impl Builder<'_> {
    pub(super) fn update(&mut self, start: &Expr) -> Function {
        let Some(samples) = self.sampled.observer_samples() else {
            fault("an observer alone without an end of its round")
        };
        let (count, measured) = (Shape::Count, self.sampled.measured);
        let last = Expr::local("u");
        let legal = self.legal("y", measured, vec![last.clone()]);
        let mut body: Vec<_> = legal.into_iter().collect();
        body.push(Self::elapsed(start));
        self.remember_inputs(2);
        body.extend(self.observe(&Expr::Count(samples)));
        let kept = self.keep_estimates();
        let of_kept = |statement: &Statement| match statement {
            Statement::Set(_, value @ Expr::Local(_)) => Some(Test::Finite(value.clone())),
            _ => None,
        };
        let trust = self.keep_trust();
        let numbers = kept.iter().filter(|statement| trust.as_ref() != Some(*statement));
        let finite = numbers.filter_map(of_kept).collect();
        body.push(Statement::Require(Test::All(finite), Status::Range));
        body.extend(self.shift_inputs(&last));
        body.extend(kept);
        let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
        let done = |status| Finish::give(Vec::new(), status);
        let shows = match self.sampled.linear {
            Some(_) => " y of tick `k` shows in the estimates from the next tick on.",
            None => "",
        };
        Function {
            name: "update",
            about: format!(
                "The estimates of tick `k`, which may wrap, from {} at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none.{shows} Call it once for each tick, before the law, which takes its estimates. Status Hold from sample {samples} on: the round is over.",
                self.given()
            ),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: vec![
                Variable::new("k", count, "tick"),
                Variable::new("y", Shape::Reals(measured), self.given()),
                Variable::new("u", Shape::Real, "input of the last tick, as applied"),
            ],
            callbacks: Vec::new(),
            results: Vec::new(),
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            finish: self
                .gated(Vec::new(), Finish::choose(over, done(Status::Hold), done(Status::Ok))),
            guarded: self.guarded(),
        }
    }
}
