//! `tick` and `axis`: the gains at one time, for several axes that share one deadline, and u from them.

use super::Builder;
use crate::code::{
    Access, Ending, Expr, Finish, Function, Operator, Owner, Shape, Statement, Status, Test,
    Variable,
};
use crate::controller::plan::Routine;
use crate::internal::fault;

impl Builder<'_> {
    /// What `tick` gives and `axis` knows.
    pub(super) fn gains(&self) -> Vec<Variable> {
        let n = self.spec.n;
        if self.controller.program.gains.is_empty() {
            return Vec::new();
        }
        let (of, rate) = match self.spec.references() {
            0 => ("x", String::new()),
            _ => ("e", format!(" + r[{n}], e[i] = x[i] - r[i]")),
        };
        let about = format!("u = gain[0] {of}[0] + ... + gain[{}] {of}[{}]{rate}", n - 1, n - 1);
        let mut gains = vec![Variable::new("gain", Shape::Reals(n), about)];
        if self.run_time_limit() {
            gains.push(Variable::new("u_max", Shape::Real, "bound of |u|"));
        }
        gains
    }

    /// Whether the bound of |u| is a field.
    fn run_time_limit(&self) -> bool {
        self.limits.u_max.is_some_and(|limit| !self.plan.is_literal(limit))
    }

    pub(super) fn tick(&self) -> Function {
        let mut statements = Vec::new();
        if self.guarded() {
            statements.push(Statement::Require(Test::All(self.legal_time()), Status::Input));
        }
        let body = self.body(Routine::Tick, &[]);
        statements.extend(body.statements);
        let Some((late, gains)) = body.roots.split_last() else { fault("a tick without gains") };
        let mut values = gains.to_vec();
        if let Some(limit) = self.limits.u_max.filter(|_| self.run_time_limit()) {
            values.push(self.field(limit));
        }
        let tracks = Test::Less(late.clone(), self.field(self.limits.hold_from));
        let give = |status| Finish::give(values.clone(), status);
        Function {
            name: "tick",
            about: "The gains at time t [s], for several axes that share one deadline: tick once, then axis for each. The result of tick and axis may differ from that of step in the last bits.".to_owned(),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: vec![Variable::new("t", Shape::Real, "time, s")],
            callbacks: Vec::new(),
            results: vec![Variable::new("gains", Shape::Gains, "feedback gains at one time")],
            failures: if self.guarded() { vec![Status::Input] } else { Vec::new() },
            body: statements,
            finish: Finish::choose(tracks, give(Status::Ok), give(Status::Hold)),
            guarded: self.guarded(),
        }
    }

    pub(super) fn axis(&self) -> Function {
        let Some(axis) = self.controller.program.axis else { fault("gains without an axis") };
        let inputs = self.inputs_of_axis(axis);
        let mut statements = self.locals(&inputs.local);
        statements.extend(inputs.required());
        let body = self.body(Routine::Axis, &inputs.local);
        statements.extend(body.statements);
        let Some(u) = body.roots.first() else { fault("an axis without u") };
        statements.push(Statement::Let("v".to_owned(), Shape::Real, u.clone()));
        let v = || Expr::local("v");
        let (give, fail) = (Finish::Give(vec![v()], Ending::OfGains), Finish::Fail(Status::Range));
        let finish = if self.guarded() && inputs.waiting.is_empty() {
            self.clipped(Finish::choose(Test::Finite(v()), give, fail))
        } else if self.guarded() {
            inputs.behind(self.within_bounds(), give, self.clipped(fail))
        } else {
            let nothing = Expr::binary(Operator::Sub, v(), v());
            self.clipped(Finish::choose(Test::NotNumber(nothing), fail, give))
        };
        Function {
            name: "axis",
            about: match self.reference() {
                None => "u of one axis from its state x = (x1, x1', ...) and the gains.",
                Some(_) => "u of one axis from its state x = (x1, x1', ...), its reference r = (r, r', ...) and the gains.",
            }
            .to_owned(),
            owner: Owner::Gains,
            access: Access::Read,
            arguments: std::iter::once(self.array("x", "state: x1, its rate, ..."))
                .chain(self.reference())
                .collect(),
            callbacks: Vec::new(),
            results: vec![Variable::new("u", Shape::Real, "input of the plant")],
            failures: self.failures(),
            body: statements,
            finish,
            guarded: self.guarded(),
        }
    }
}
