//! The functions of the deadline: `arm_for`, `soonest` and `deadline`.

use super::super::controller::Builder;
use super::bounds::{TRIED, all_fit, fits};
use super::search::{KEPT, Search};
use super::{LAST, ROUND, longest, rest};
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::request::{Late, MAX_SAMPLES};

impl Builder<'_> {
    /// `arm_for`: another deadline from now on.
    pub(super) fn arm_for(&mut self, start: &Expr) -> Function {
        let refuses = self.flight().is_some_and(|flight| flight.late == Late::Refuse);
        let samples = || Expr::local("samples");
        let least = self.least_deadline();
        let most = self.spec.schedule().map_or(MAX_SAMPLES, |schedule| schedule.samples);
        let legal = vec![
            Test::CountLess(Expr::Count(least - 1), samples()),
            Test::CountLess(samples(), Expr::Count(most.saturating_add(1))),
        ];
        let mut body = vec![Statement::Require(Test::All(legal), Status::Param)];
        let mut arguments = vec![
            Variable::new("k", Shape::Count, "tick"),
            Variable::new("samples", Shape::Count, "samples from tick `k` to rest"),
        ];
        let mut failures = vec![Status::Param];
        if refuses {
            let (given, statements) = self.state_of_now();
            arguments.extend(given);
            body.extend(statements);
            body.extend(self.required_plan());
            failures.extend([Status::Input, Status::Soon]);
        }
        let set = |name: &str, value| Statement::Set(Place::Field(name.to_owned()), value);
        if self.counts_round() {
            body.push(Self::elapsed(start));
            let left = Expr::field(ROUND).count_left(Expr::local("elapsed"));
            body.push(set(ROUND, left));
        }
        body.push(set("start", Expr::local("k")));
        body.push(set(LAST, samples()));
        let refusal = match refuses {
            true => " A deadline before which a limit could be exceeded is refused (E_SOON).",
            false => "",
        };
        let kept = match self.remembered() > 0 {
            true => " Estimates and inputs under way are kept.",
            false => "",
        };
        Function {
            name: "arm_for",
            about: format!(
                "Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, {least} to {most} samples.{kept}{refusal}"
            ),
            owner: Owner::Controller,
            access: Access::Change,
            arguments,
            callbacks: Vec::new(),
            results: Vec::new(),
            failures,
            body,
            finish: Finish::done(),
            guarded: self.guarded(),
        }
    }

    /// The fewest samples to a deadline in flight: those in which every law can bring its loop to rest.
    fn least_deadline(&mut self) -> u32 {
        let each = self.of_each_law(|own| {
            let order = u32::try_from(own.spec.loop_order()).unwrap_or(u32::MAX);
            order.saturating_add(own.spare())
        });
        each.into_iter().max().unwrap_or_default()
    }

    /// Statements that refuse a deadline of `samples` which might exceed a limit.
    fn required_plan(&mut self) -> Vec<Statement> {
        let spare = self.spare();
        let (mut body, chains) = self.planned_chains();
        let [_, part] = self.parts(&chains);
        let (limits_set, limits) = self.plan_limits(&chains, &part, false);
        body.extend(limits_set);
        let tried = Expr::local("samples").count_left(Expr::Count(spare));
        body.push(Statement::Let(TRIED.to_owned(), Shape::Count, tried));
        let longest = longest(&chains, self.spec.precision);
        let mut tests = vec![
            Test::CountLess(Expr::Count(rest(&chains)), Expr::local(TRIED)),
            Test::CountLess(Expr::local(TRIED), Expr::Count(longest + 1)),
        ];
        if self.spec.schedule().is_some() {
            // The table has no others.
            body.push(Statement::Require(Test::All(std::mem::take(&mut tests)), Status::Soon));
        }
        body.extend(fits(&chains, &limits, false));
        tests.push(all_fit(&chains));
        body.push(Statement::Require(Test::All(tests), Status::Soon));
        body
    }

    /// `soonest`, where deadlines can be planned.
    pub(super) fn soonest(&mut self) -> Option<Function> {
        let (coordinates, chains) = self.chains().filter(|(_, chains)| !chains.is_empty())?;
        let (arguments, mut body) = self.state_of_now();
        body.extend(coordinates);
        let search = Search {
            first: Expr::Count(rest(&chains) + 1),
            below: Expr::Count(rest(&chains)),
            held: false,
            keeps_first: false,
        };
        body.extend(self.search(&chains, search));
        let finite = chains.into_iter().flat_map(|chain| chain.flat).map(Test::Finite).collect();
        let samples = Expr::local(KEPT).count_add(Expr::Count(self.spare()));
        let found = Test::CountLess(Expr::Count(0), Expr::local(KEPT));
        let soon = Finish::choose(
            found,
            Finish::give(vec![samples], Status::Ok),
            Finish::Fail(Status::Soon),
        );
        let from = match (self.designs, self.sampled.observes()) {
            ([], true) => "the estimates as they are predicted for the next tick",
            ([], false) => "the state x",
            _ => "the state x of each, all of which come to rest at one sample",
        };
        let law = if self.designs.is_empty() { "law" } else { "law of each axis" };
        Some(Function {
            name: "soonest",
            about: format!(
                "The fewest samples found, from the next call of `step` on, with which the {law} keeps u and the states within their limits at every sample to rest, from {from}, for sure. Give them to `arm_for`."
            ),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: arguments.into_iter().collect(),
            callbacks: Vec::new(),
            results: vec![Variable::new("samples", Shape::Count, "samples to rest")],
            failures: vec![Status::Input, Status::Range, Status::Soon],
            body,
            finish: Finish::choose(Test::All(finite), soon, Finish::Fail(Status::Range)),
            guarded: self.guarded(),
        })
    }

    /// `deadline`: the tick at which the loop is to be at rest.
    pub(super) fn deadline(&self, start: &Expr) -> Function {
        // The sum wraps as ticks do.
        let back = Expr::Count(0).count_sub(Expr::field(LAST));
        Function {
            name: "deadline",
            about: "The tick at which the loop is to be at rest.".to_owned(),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: Vec::new(),
            callbacks: Vec::new(),
            results: vec![Variable::new("k", Shape::Count, "tick")],
            failures: Vec::new(),
            body: Vec::new(),
            finish: Finish::give(vec![start.clone().count_sub(back)], Status::Ok),
            guarded: self.guarded(),
        }
    }
}
