//! `tick` and `axis`: the gains at one time, for several axes that share one deadline, and u from them.

use super::Builder;
use super::body::{GAIN, INPUT_GAIN};
use crate::code::{
    AXIS, Access, Bounds, Ending, Expr, Finish, Function, Operator, Owner, Shape, Statement,
    Status, Test, Variable,
};
use crate::controller::plan::Routine;
use crate::internal::fault;
use crate::parameter::Parameter;
use crate::program::Value;
use crate::request;

impl Builder<'_> {
    /// Returns the values that `tick` computes and `axis` reads.
    pub(super) fn gains(&self) -> Vec<Variable> {
        let n = self.spec.n;
        if self.program.gains.is_empty() {
            return Vec::new();
        }
        let (of, rate) = match self.spec.references() {
            0 => ("x", String::new()),
            _ => ("e", format!(" + r[{n}], e[i] = x[i] - r[i]")),
        };
        let program = self.program;
        let shape = |values: &[Value]| match values.len() {
            1 => Shape::Real,
            several => Shape::Reals(several),
        };
        let last = n - 1;
        let (first, last_gain) = match program.gains.len() > n {
            true => (format!("{n}*axis"), format!("{n}*axis + {last}")),
            false => ("0".to_owned(), last.to_string()),
        };
        let sum = format!("gain[{first}] {of}[0] + ... + gain[{last_gain}] {of}[{last}]{rate}");
        let about = match program.divisors.is_empty() {
            true => format!("u = {sum}"),
            false => format!("u input_gain = {sum}"),
        };
        let mut gains = vec![Variable::new(GAIN, Shape::Reals(program.gains.len()), about)];
        if !program.divisors.is_empty() {
            gains.push(Variable::new(INPUT_GAIN, shape(&program.divisors), "g"));
        }
        if !program.bounds.is_empty() {
            let of_each = Shape::Reals(program.bounds.len());
            let about = match program.lower.is_empty() {
                true => "bound of |u| of each axis",
                false => "upper limit of u of each axis",
            };
            gains.push(Variable::new("u_max", of_each, about));
            if !program.lower.is_empty() {
                gains.push(Variable::new("u_min", of_each, "lower limit of u of each axis"));
            }
        }
        for (parameter, _) in self.run_time_limits() {
            let about = self.spec.meaning(parameter);
            gains.push(Variable::new(parameter.key(), Shape::Real, about));
        }
        gains
    }

    /// Returns true if `axis` has to be given the number of its axis.
    fn numbers_axes(&self) -> bool {
        self.spec.axes.as_ref().is_some_and(request::Axes::differ)
    }

    /// The limits of u of an axis: `own` of a name where each has its own.
    pub(super) fn limits_of_axis(&self, own: impl Fn(String) -> Expr) -> Bounds {
        let named = |name: &str| Some(own(name.to_owned()));
        let program = self.program;
        match (program.bounds.is_empty(), program.lower.is_empty()) {
            (true, _) => self.bounds(),
            (false, true) => Bounds::symmetric(named("u_max")),
            (false, false) => Bounds::between(named("u_min"), named("u_max")),
        }
    }

    /// The limits of u that are fields, which all axes share.
    fn run_time_limits(&self) -> impl Iterator<Item = (Parameter, Value)> {
        let all =
            [(Parameter::UMax, self.limits.u_max), (Parameter::UMin, self.limits.u_min.value())];
        let shared = self.program.bounds.is_empty();
        let of = all.into_iter().filter_map(|(parameter, limit)| Some((parameter, limit?)));
        of.filter(move |(_, limit)| shared && !self.plan.is_literal(*limit))
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
        values.extend(self.run_time_limits().map(|(_, limit)| self.field(limit)));
        let tracks = Test::Less(late.clone(), self.field(self.limits.hold_from));
        let give = |status| Finish::give(values.clone(), status);
        Function {
            name: "tick",
            about: match self.spec.axes {
                Some(_) => "The gains at time t [s] for all axes, from which step computes u of each.",
                None => "The gains at time t [s], for several axes that share one deadline: tick once, then axis for each. The result of tick and axis may differ from that of step in the last bits.",
            }
            .to_owned(),
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
        let Some(axis) = self.program.axis else { fault("gains without an axis") };
        let mut inputs = self.inputs_of_axis(axis);
        if let Some(axes) = self.spec.axes.as_ref().filter(|axes| axes.differ()) {
            // Whatever is trusted, no element beyond the gains is read.
            let count = Expr::Count(u32::try_from(axes.count).unwrap_or(u32::MAX));
            inputs.first.insert(0, Test::CountLess(Expr::local(AXIS), count));
        }
        let mut statements = self.locals(&inputs.local);
        statements.extend(inputs.required());
        let body = self.body(Routine::Axis, &inputs.local);
        statements.extend(body.statements);
        let Some(u) = body.roots.first() else { fault("an axis without u") };
        statements.push(Statement::Let("v".to_owned(), Shape::Real, u.clone()));
        let v = || Expr::local("v");
        let limit = &self.limits_of_axis(|name| Expr::OfAxis(name, 1, 0));
        let (give, fail) = (Finish::Give(vec![v()], Ending::OfGains), Finish::Fail(Status::Range));
        let finish = if self.guarded() && inputs.waiting.is_empty() {
            Finish::choose(Test::Finite(v()), Self::clipped_at(give, limit), fail)
        } else if self.guarded() {
            inputs.behind(Self::within(limit), give, Self::outside(limit))
        } else {
            let nothing = Expr::binary(Operator::Sub, v(), v());
            Finish::choose(Test::NotNumber(nothing), fail, Self::clipped_at(give, limit))
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
            arguments: self
                .numbers_axes()
                .then(|| Variable::new(AXIS, Shape::Count, "number of the axis, from 0"))
                .into_iter()
                .chain([self.array("x", "state: x1, its rate, ...")])
                .chain(self.reference())
                .collect(),
            callbacks: Vec::new(),
            results: vec![Variable::new("u", Shape::Real, "input of the plant")],
            failures: match self.guarded() || self.numbers_axes() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body: statements,
            finish,
            guarded: self.guarded(),
        }
    }
}
