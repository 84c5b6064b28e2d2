//! `init`, `arm` and `arm_for`: parameters, start time and duration to fields.

use super::body::{Body, body};
use super::given::Given;
use super::{Builder, Field};
use crate::algebra::BigRational;
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Start, Statement, Status, Test, Variable,
    limits_in_order, parameter_name,
};
use crate::controller::is_derived;
use crate::controller::plan::Routine;
use crate::expression::Function as Math;
use crate::internal::fault;
use crate::parameter::{Domain, Fixed, Parameter};
use crate::program::digits::{self, Condition};
use crate::request::What;

impl Builder<'_> {
    /// Parameters to fields, without the call of `arm`.
    pub(super) fn init(&self) -> Vec<Statement> {
        let mut statements = Vec::new();
        for parameter in self.spec.run_time_parameters() {
            let key = parameter.key().to_owned();
            let given = match parameter.index() {
                Some(index) => Expr::ParameterElement(key, index),
                None => Expr::Parameter(key),
            };
            statements.push(Statement::Let(parameter_name(parameter), Shape::Real, given));
        }
        let domain = self.domain();
        if !domain.is_empty() {
            statements.push(Statement::Require(Test::All(domain), Status::Param));
        }
        let [checks, _] = digits::checks(self.spec, self.program);
        statements.extend(self.checked_fields(Routine::Init, &checks, Vec::new()));
        let unset =
            |field: &Field| Statement::Set(Place::Field(field.name.clone()), Expr::integer(0));
        statements.extend(self.plan.set_by(Routine::ArmFor).map(unset));
        statements
    }

    /// The fields of `routine`, where the `checks` and `tests` hold.
    fn checked_fields(
        &self,
        routine: Routine,
        checks: &[Condition],
        mut tests: Vec<Test>,
    ) -> Vec<Statement> {
        let values: Vec<_> = checks.iter().flat_map(Condition::values).collect();
        let mut body = body(&self.plan, routine, Given { further: &values, ..Given::default() });
        let mut checked = body.roots.split_off(body.roots.len() - values.len()).into_iter();
        let kept = |check: &Condition| self.kept(check, &mut checked, &mut body.statements);
        tests.extend(checks.iter().map(kept));
        self.fields(routine, body, tests)
    }

    /// The statements of `body`, the tests of what is derived, and the fields.
    fn fields(&self, routine: Routine, body: Body, mut tests: Vec<Test>) -> Vec<Statement> {
        let mut statements = body.statements;
        let mut set = Vec::new();
        for (field, value) in self.plan.set_by(routine).zip(body.roots) {
            let mut value = value;
            if is_derived(self.program, field) {
                if !matches!(value, Expr::Local(_)) {
                    let name = field.name.clone();
                    statements.push(Statement::Let(name.clone(), Shape::Real, value));
                    value = Expr::local(name);
                }
                tests.push(Test::Finite(value.clone()));
            }
            set.push(Statement::Set(Place::Field(field.name.clone()), value));
        }
        if !tests.is_empty() {
            statements.push(Statement::Require(Test::All(tests), Status::Param));
        }
        statements.extend(set);
        statements
    }

    /// The test of a product; `values` are those it looks at. Where it may be 0 its size is a statement
    /// of its own, so that the test stays one comparison.
    fn kept(
        &self,
        check: &Condition,
        values: &mut impl Iterator<Item = Expr>,
        statements: &mut Vec<Statement>,
    ) -> Test {
        let mut values = values.take(check.values().len());
        let value = values.next().unwrap_or_else(|| fault("a condition on nothing"));
        let least = || self.number(digits::least(self.spec.precision));
        let size = |value: Expr| Expr::Call(Math::Abs, Box::new(value));
        match check {
            Condition::Finite(_) => Test::Finite(value),
            Condition::Above(_) => Test::AtMost(least(), value),
            Condition::Below(_) => Test::AtMost(value, -least()),
            Condition::Kept(..) => {
                let name = match &value {
                    Expr::Local(name) => format!("size_{name}"),
                    _ => format!("size{}", statements.len()),
                };
                let unless_zero = |rest, factor| {
                    Expr::choose(Test::AtMost(size(factor), Expr::integer(0)), least(), rest)
                };
                let kept = values.fold(size(value), unless_zero);
                statements.push(Statement::Let(name.clone(), Shape::Real, kept));
                Test::AtMost(least(), Expr::local(name))
            }
        }
    }

    /// A number of the precision.
    fn number(&self, value: f64) -> Expr {
        match BigRational::from_float(value) {
            Some(exact) => Expr::Number(exact),
            None => fault(format!("{value} is not a bound")),
        }
    }

    /// Returns the end of `init`.
    pub(super) fn start(&self) -> Start {
        let tau = self.program.in_flight.then(|| self.parameter(Parameter::Tau));
        let time = self.parameter(Parameter::StartTime);
        Start { time, duration: tau, state: self.latched() }
    }

    /// The state that is latched.
    fn latched(&self) -> Option<Variable> {
        self.spec.latches().then(|| self.array("x0", "state at the start"))
    }

    pub(super) fn arm(&self) -> Function {
        let mut statements = vec![Statement::Require(Test::All(self.legal_start()), Status::Param)];
        statements.extend(self.checked_fields(Routine::Arm, &[], self.finite_deadline()));
        let tau = if self.program.in_flight { ", with the tau last used" } else { "" };
        self.starts("arm", format!("Starts again at t0 [s]{tau}"), None, statements)
    }

    /// `arm_for`, where the duration changes in flight.
    pub(super) fn arm_for(&self) -> Option<Function> {
        if !self.program.in_flight {
            return None;
        }
        let given = [self.legal_start(), self.legal_duration()].concat();
        let mut statements = vec![Statement::Require(Test::All(given), Status::Param)];
        let [_, checks] = digits::checks(self.spec, self.program);
        let fields = self.checked_fields(Routine::ArmFor, &checks, self.finite_deadline());
        statements.extend(fields);
        let about =
            "Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau";
        let tau = Variable::new("tau", Shape::Real, "duration, s");
        Some(self.starts("arm_for", about.to_owned(), Some(tau), statements))
    }

    /// Tests of the arguments of `arm`.
    fn legal_start(&self) -> Vec<Test> {
        let mut given = vec![Test::Finite(Expr::local("t0"))];
        if self.spec.latches() {
            let state = |j| Test::Finite(Expr::Element("x0".to_owned(), j));
            given.extend((0..self.spec.states()).map(state));
        }
        given
    }

    /// Tests of the duration that `arm_for` is given: those of `init`.
    fn legal_duration(&self) -> Vec<Test> {
        let mut tests = self.domain_of(Parameter::Tau);
        if self.spec.what == What::Controller {
            tests.push(Test::Less(self.field(self.limits.eps), Expr::local("tau")));
        }
        tests
    }

    fn finite_deadline(&self) -> Vec<Test> {
        match self.spec.what {
            What::Associated => Vec::new(),
            _ => vec![Test::Finite(Expr::local("deadline"))],
        }
    }

    /// A function that starts at t0.
    fn starts(
        &self,
        name: &'static str,
        about: String,
        duration: Option<Variable>,
        body: Vec<Statement>,
    ) -> Function {
        let latching = if self.spec.latches() { ", latching the state x0" } else { "" };
        let time = Variable::new("t0", Shape::Real, "start time, s");
        Function {
            name,
            about: format!("{about}{latching}."),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: std::iter::once(time).chain(duration).chain(self.latched()).collect(),
            callbacks: Vec::new(),
            results: Vec::new(),
            failures: vec![Status::Param],
            body,
            finish: Finish::done(),
            guarded: true,
        }
    }

    /// A parameter in `init`: its number where it is fixed, else its local value.
    fn parameter(&self, parameter: Parameter) -> Expr {
        match self.spec.fixed.get(&parameter).and_then(Fixed::number) {
            Some(number) => Expr::Number(number.clone()),
            None => Expr::local(parameter_name(parameter)),
        }
    }

    /// The tests of the run-time parameters' domains.
    fn domain(&self) -> Vec<Test> {
        let spec = self.spec;
        let parameters = spec.run_time_parameters();
        let mut tests: Vec<_> =
            parameters.flat_map(|parameter| self.domain_of(parameter)).collect();
        if let Some((parameter, greatest)) = self.greatest
            && let Some(number) = greatest.number()
        {
            let value = Expr::local(parameter_name(*parameter));
            tests.push(Test::AtMost(value, Expr::Number(number.clone())));
        }
        // eps below tau: both may be fixed, and then the spec has been checked.
        let of_time = [Parameter::Eps, Parameter::Tau];
        let open = of_time.iter().any(|parameter| !spec.fixed.contains_key(parameter));
        if spec.what == What::Controller && open {
            let [eps, tau] = of_time.map(|parameter| self.parameter(parameter));
            tests.push(Test::Less(eps, tau));
        }
        if spec.what == What::Controller {
            tests.extend(limits_in_order(spec, &|parameter| self.parameter(parameter)));
        }
        tests
    }

    /// The tests of the domain of one of them, of its local value alone.
    fn domain_of(&self, parameter: Parameter) -> Vec<Test> {
        let spec = self.spec;
        let value = || Expr::local(parameter_name(parameter));
        let (least, greatest) = spec.ends(parameter).unwrap_or((0.0, f64::MAX));
        let above = || Test::AtMost(self.number(least), value());
        match spec.domain(parameter) {
            Domain::Finite => vec![Test::Finite(value())],
            Domain::Positive => {
                vec![Test::Finite(value()), above(), Test::AtMost(value(), self.number(greatest))]
            }
            Domain::PositiveOrInfinite => vec![Test::Less(Expr::integer(0), value())],
            Domain::BelowUMax | Domain::AboveUMin => Vec::new(),
            Domain::BelowTau => vec![above()],
            Domain::Within => {
                let Some((least, greatest)) = spec.bounds.get(&parameter) else {
                    return Vec::new();
                };
                let number = |bound: &Fixed| bound.number().cloned().map(Expr::Number);
                let least = number(least).map(|least| Test::AtMost(least, value()));
                let most = number(greatest).map(|most| Test::AtMost(value(), most));
                least.into_iter().chain(most).collect()
            }
        }
    }
}
