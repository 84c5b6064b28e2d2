//! `tick` and `axis`: the gains at one time, for several axes that share one deadline, and u from them;
//! and the `step` of all axes.

use super::Builder;
use super::body::{INPUT_GAIN, body};
use crate::code::{
    AXIS, Access, Axes, Ending, Expr, Finish, Function, Operator, Owner, Shape, Statement, Status,
    Test, Variable,
};
use crate::controller::plan::Routine;
use crate::expression::Function::Abs;
use crate::internal::fault;
use crate::program::{Input, Value, number};
use crate::request;

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
        let program = self.controller.program;
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
        let mut gains = vec![Variable::new("gain", Shape::Reals(program.gains.len()), about)];
        if !program.divisors.is_empty() {
            gains.push(Variable::new(INPUT_GAIN, shape(&program.divisors), "g"));
        }
        if !program.bounds.is_empty() {
            let of_each = Shape::Reals(program.bounds.len());
            gains.push(Variable::new("u_max", of_each, "bound of |u| of each axis"));
        } else if self.run_time_limit() {
            gains.push(Variable::new("u_max", Shape::Real, "bound of |u|"));
        }
        gains
    }

    /// Whether `axis` has to know which axis it is.
    fn numbers_axes(&self) -> bool {
        self.spec.axes.as_ref().is_some_and(request::Axes::differ)
    }

    /// `step` of all axes.
    pub(super) fn all_axes(&self, count: usize) -> Function {
        let axis = self.axis();
        let rows = axis.arguments.into_iter().filter_map(|argument| match argument.shape {
            Shape::Reals(length) => Some(Variable {
                shape: Shape::Lists(count, length),
                about: format!("for each axis its {}", argument.about),
                ..argument
            }),
            _ => None,
        });
        let time = Variable::new("t", Shape::Real, "time, s");
        Function {
            name: "step",
            about: match self.reference() {
                None => format!(
                    "u of {count} axes at time t [s], from the state x = (x1, x1', ...) of each."
                ),
                Some(_) => format!(
                    "u of {count} axes at time t [s], from the state x = (x1, x1', ...) and the reference r = (r, r', ...) of each."
                ),
            } + " Its status is that of the first axis that fails, and then every u is 0; else SATURATED where an axis is.",
            owner: Owner::Controller,
            access: Access::Read,
            arguments: std::iter::once(time).chain(rows).collect(),
            callbacks: Vec::new(),
            results: vec![
                Variable::new("u", Shape::Reals(count), "inputs of the plants"),
                Variable::new("axes", Shape::Statuses(count), "status of each axis"),
            ],
            failures: axis.failures,
            body: Vec::new(),
            finish: Finish::Axes(Box::new(self.of_all_axes(count))),
            guarded: self.guarded(),
        }
    }

    /// What [`Builder::axis`] does, for all axes at once.
    fn of_all_axes(&self, count: usize) -> Axes {
        let Some(axis) = self.controller.program.axis else { fault("gains without an axis") };
        let inputs = self.inputs_of_axis(axis);
        let parts = &self.controller.program.parts;
        let mut body = body(&self.plan, Routine::Axis, (&[], false), &[], parts);
        let Some(value) = body.roots.pop() else { fault("an axis without u") };
        let limit = self.limit_of_axis();
        // One test for both, that v is finite and that it is within a bound which may be infinite.
        let greatest = Expr::Number(number::finite(self.spec.precision.greatest()));
        let shared = limit.clone().filter(|limit| matches!(limit, Expr::Field(_)));
        let bound = shared.map(|limit| {
            let less = Test::Less(limit.clone(), greatest.clone());
            Expr::choose(less, limit, greatest)
        });
        let size = || Expr::Call(Abs, Box::new(Expr::local("v")));
        let within = match bound {
            Some(_) => vec![Test::AtMost(size(), Expr::local("bound"))],
            None => Self::within(limit.clone()),
        };
        let finite = |input: &Input| Test::Finite(self.element(*input));
        let first: Vec<_> = inputs.local.iter().map(finite).collect();
        let legal: Vec<_> = first.iter().cloned().chain(inputs.waiting).collect();
        let clipped = self.clipped_at(Finish::Fail(Status::Range), limit);
        Axes {
            count,
            body: body.statements,
            value,
            bound,
            legal: Test::All(first.into_iter().chain(within).collect()),
            otherwise: match legal.is_empty() {
                true => clipped,
                false => Finish::choose(Test::All(legal), clipped, Finish::Fail(Status::Input)),
            },
        }
    }

    /// The bound of |u| of an axis, if there is one.
    fn limit_of_axis(&self) -> Option<Expr> {
        match self.controller.program.bounds.is_empty() {
            false => Some(Expr::OfAxis("u_max".to_owned(), 1, 0)),
            true => self.limits.u_max.map(|limit| self.field(limit)),
        }
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
        let shared = self.controller.program.bounds.is_empty() && self.run_time_limit();
        if let Some(limit) = self.limits.u_max.filter(|_| shared) {
            values.push(self.field(limit));
        }
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
        let Some(axis) = self.controller.program.axis else { fault("gains without an axis") };
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
        let limit = self.limit_of_axis();
        let (give, fail) = (Finish::Give(vec![v()], Ending::OfGains), Finish::Fail(Status::Range));
        let finish = if self.guarded() && inputs.waiting.is_empty() {
            self.clipped_at(Finish::choose(Test::Finite(v()), give, fail), limit)
        } else if self.guarded() {
            let hot = Self::within(limit.clone());
            inputs.behind(hot, give, self.clipped_at(fail, limit))
        } else {
            let nothing = Expr::binary(Operator::Sub, v(), v());
            self.clipped_at(Finish::choose(Test::NotNumber(nothing), fail, give), limit)
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
