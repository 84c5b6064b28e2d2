//! What the emitted functions consist of, as text that a template only has to place.

use std::fmt;

use super::print::{self, Syntax};
use crate::controller::plan::{Field, Plan, Routine, parameter_name};
use crate::controller::{Controller, is_derived};
use crate::internal::fault;
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::digits::{self, Condition};
use crate::program::{Input, Op, Value, number};
use crate::request::{After, Feedback, Guard, Spec, What};

/// A name and the expression that gives it its value.
pub(super) struct Assignment {
    pub(super) name: String,
    pub(super) value: String,
}

/// A condition on a parameter; as text it is the test.
pub(super) struct Requirement {
    pub(super) test: String,
    /// The parameter's local value.
    local: String,
    /// The parameter's place among the parameters.
    pub(super) parameter: String,
    /// Its legal values, in words.
    pub(super) legal: String,
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.test)
    }
}

/// The conditions on one parameter, for a language that tells which one is wrong.
pub(super) struct Check<'a> {
    pub(super) tests: Vec<&'a str>,
    /// Its local value.
    pub(super) local: &'a str,
    pub(super) parameter: &'a str,
    pub(super) legal: &'a str,
}

/// The parts of all functions of a controller in one language.
pub(super) struct Frame {
    pub(super) n: usize,
    pub(super) guard: Guard,
    pub(super) real: &'static str,
    pub(super) zero: String,
    /// Run-time parameters: local name, and its place in the parameters.
    pub(super) locals: Vec<Assignment>,
    /// Conditions that the run-time parameters must meet.
    pub(super) domain: Vec<Requirement>,
    /// The functions that call one of the mathematical library.
    pub(super) library: Vec<Routine>,
    /// Lines of the function of [`Op::Rows`], where there is one.
    pub(super) functions: Vec<String>,
    pub(super) init: Vec<String>,
    pub(super) init_fields: Vec<Assignment>,
    /// Conditions that what `init` derives must meet: products that keep their digits, and fields
    /// that are finite.
    pub(super) finite: Vec<String>,
    /// The least magnitude of a product, where a function decides whether one keeps its digits.
    pub(super) least_kept: Option<String>,
    /// Start time at which `init` arms.
    pub(super) start: String,
    pub(super) arm: Vec<String>,
    pub(super) arm_fields: Vec<Assignment>,
    /// Conditions on the states x1..xn.
    pub(super) states: Vec<String>,
    pub(super) step: Vec<String>,
    /// u before it is clipped, in one expression, and its parts: the law, and what takes its place
    /// once the deadline is over.
    pub(super) step_u: String,
    pub(super) law_u: String,
    pub(super) next: Option<String>,
    pub(super) tick: Vec<String>,
    pub(super) gains: Vec<String>,
    pub(super) axis: Vec<String>,
    pub(super) axis_u: String,
    pub(super) after: After,
    /// Whether the law is a function of the user's.
    pub(super) extern_law: bool,
    /// Whether the state at the start is latched.
    pub(super) latches: bool,
    /// Whether it is the associated system, in place of the controller.
    pub(super) associated: bool,
    /// Conditions on the latched state, and what `arm` derives from it, which must be finite.
    pub(super) latched: Vec<String>,
    /// The indices of the states that it reads.
    pub(super) latched_states: Vec<usize>,
    pub(super) latched_fields: Vec<String>,
    /// Bound of |u| in `step` and in `axis`; none for infinity.
    pub(super) limit: Option<String>,
    pub(super) axis_limit: Option<String>,
    /// Whether the gains carry u_max.
    pub(super) run_time_limit: bool,
    pub(super) eps: String,
    pub(super) hold_from: String,
    pub(super) fields: Vec<Field>,
}

impl Frame {
    pub(super) fn new(
        controller: &Controller<'_>,
        real: &'static str,
        syntax: &dyn Syntax,
    ) -> Self {
        let (spec, program) = (controller.spec(), controller.program);
        let plan = Plan::new(program, |name| syntax.name(name));
        let body = |function| print::print(&plan, function, syntax);
        let digits = Digits::new(spec, &plan, syntax);
        let (init, arm) = (digits.init, body(Routine::Arm));
        let (step, tick, axis) = (body(Routine::Step), body(Routine::Tick), body(Routine::Axis));
        let assign = |roots: Vec<String>, armed: bool| {
            let fields = plan.fields.iter().filter(|field| field.armed == armed);
            let one =
                |(field, value): (&Field, String)| Assignment { name: field.name.clone(), value };
            fields.zip(roots).map(one).collect()
        };
        let finite = plan.fields.iter().filter(|f| !f.armed && is_derived(program, f));
        let field =
            |value: Value, owner: fn(&dyn Syntax, &str) -> String| match &program.get(value).op {
                Op::Number(number) => {
                    literal(number::round(number, spec.precision), spec.precision, syntax)
                }
                _ => {
                    let name = plan.name(value);
                    owner(syntax, name.unwrap_or_else(|| fault("a limit without a name")))
                }
            };
        let limits = program.limits;
        let local = |parameter: Parameter| Assignment {
            name: local_name(parameter, syntax),
            value: place(parameter, syntax),
        };
        let latches = spec.latches();
        let armed = plan.fields.iter().filter(|field| field.armed).zip(&arm.roots);
        let latched_fields = armed
            .filter(|(field, _)| is_derived(program, field))
            .map(|(_, text)| text.clone())
            .collect();
        let latched_states = (1..=spec.n)
            .filter(|j| program.values.iter().any(|v| v.op == Op::Input(Input::StateAtStart(*j))))
            .collect();
        let functions = program.values.iter().find_map(|definition| match &definition.op {
            Op::Rows { weights, .. } => Some(syntax.rows_function(weights.len())),
            _ => None,
        });
        let zero = syntax.literal("0.0");
        let past = limits.past.and_then(|_| step.roots.last().cloned());
        let next = match spec.after {
            After::Extern => syntax.after(),
            After::Hold | After::Zero => zero.clone(),
        };
        Self {
            n: spec.n,
            guard: spec.guard,
            real,
            zero: zero.clone(),
            locals: spec.run_time_parameters().map(local).collect(),
            domain: domain(controller, syntax),
            library: Routine::ALL.into_iter().filter(|r| plan.calls_library(*r)).collect(),
            functions: functions.unwrap_or_default(),
            init: init.lines,
            init_fields: assign(init.roots, false),
            finite: digits
                .tests
                .into_iter()
                .chain(finite.map(|f| syntax.finite(&syntax.built(&f.name))))
                .collect(),
            least_kept: digits.least_kept,
            start: parameter_text(spec, Parameter::StartTime, syntax),
            arm: arm.lines,
            arm_fields: assign(arm.roots, true),
            states: (1..=spec.n).map(|j| syntax.finite(&format!("x{j}"))).collect(),
            step_u: match &past {
                Some(past) => syntax.select(&format!("{past} >= {zero}"), &next, &step.roots[0]),
                None => step.roots[0].clone(),
            },
            law_u: step.roots[0].clone(),
            next: past.is_some().then_some(next),
            step: step.lines,
            gains: tick.roots[..program.gains.len()].to_vec(),
            tick: tick.lines,
            axis_u: axis.roots.first().cloned().unwrap_or_default(),
            axis: axis.lines,
            after: spec.after,
            extern_law: spec.feedback == Feedback::Extern,
            latches,
            associated: spec.what == What::Associated,
            latched: (1..=if latches { spec.n } else { 0 })
                .map(|j| syntax.finite(&syntax.element("x0", j - 1)))
                .collect(),
            latched_states,
            latched_fields,
            limit: limits.u_max.map(|value| field(value, |syntax, name| syntax.field(name))),
            axis_limit: limits
                .u_max
                .map(|value| field(value, |syntax, name| syntax.gains_field(name))),
            run_time_limit: limits.u_max.is_some_and(|value| !plan.is_literal(value)),
            eps: field(limits.eps, |syntax, name| syntax.field(name)),
            hold_from: field(limits.hold_from, |syntax, name| syntax.field(name)),
            fields: plan.fields,
        }
    }

    /// The conditions of each parameter, in the order of `domain`.
    pub(super) fn checks(&self) -> Vec<Check<'_>> {
        let mut checks: Vec<Check<'_>> = Vec::new();
        for Requirement { test, local, parameter, legal } in &self.domain {
            match checks.last_mut() {
                Some(last) if last.parameter == parameter && last.legal == legal => {
                    last.tests.push(test);
                }
                _ => checks.push(Check { tests: vec![test], local, parameter, legal }),
            }
        }
        checks
    }
}

/// What `init` computes, and its tests of the products that it forms.
struct Digits {
    init: print::Body,
    tests: Vec<String>,
    least_kept: Option<String>,
}

impl Digits {
    fn new(spec: &Spec, plan: &Plan<'_>, syntax: &dyn Syntax) -> Self {
        let checks = digits::checks(spec, plan.program);
        let values: Vec<_> = checks.iter().flat_map(Condition::values).collect();
        let mut init = print::print_with(plan, Routine::Init, &values, syntax);
        let texts = init.roots.split_off(init.roots.len() - values.len());
        let number = |value| literal(value, spec.precision, syntax);
        let least = number(digits::least(spec.precision));
        let large = number(digits::large(spec.precision));
        let mut texts = texts.into_iter();
        let mut test = |check: &Condition| {
            let texts: Vec<_> = texts.by_ref().take(check.values().len()).collect();
            let value = &texts[0];
            match check {
                Condition::Finite(_) => syntax.finite(value),
                Condition::Above(_) => format!("({value} >= {least})"),
                Condition::Below(_) => format!("({value} <= -{least})"),
                Condition::Kept(..) => {
                    let factors = texts[1..].iter().cloned();
                    let all = factors.reduce(|a, b| format!("({a}) * {large} * ({b})"));
                    syntax.kept(value, &all.unwrap_or_default())
                }
            }
        };
        let tests = checks.iter().map(&mut test).collect();
        let kept = checks.iter().any(|check| matches!(check, Condition::Kept(..)));
        Self { init, tests, least_kept: kept.then_some(least) }
    }
}

/// A number as an expression in the language.
pub(super) fn literal(value: f64, precision: Precision, syntax: &dyn Syntax) -> String {
    let text = syntax.literal(&number::literal(value.abs(), precision));
    if value.is_sign_negative() { format!("-{text}") } else { text }
}

/// A parameter in `init`: its literal where it is fixed, else its local name.
pub(super) fn parameter_text(spec: &Spec, parameter: Parameter, syntax: &dyn Syntax) -> String {
    match spec.fixed.get(&parameter).and_then(Fixed::number) {
        Some(number) => literal(number::round(number, spec.precision), spec.precision, syntax),
        None => local_name(parameter, syntax),
    }
}

/// A parameter as a local value in the language.
fn local_name(parameter: Parameter, syntax: &dyn Syntax) -> String {
    syntax.name(&parameter_name(parameter))
}

/// Where a parameter stands among the parameters that `init` is given.
pub(super) fn place(parameter: Parameter, syntax: &dyn Syntax) -> String {
    match parameter.index() {
        Some(index) => syntax.element(parameter.key(), index),
        None => parameter.key().to_owned(),
    }
}

/// The conditions of the run-time parameters' domains.
fn domain(controller: &Controller<'_>, syntax: &dyn Syntax) -> Vec<Requirement> {
    let spec = controller.spec();
    let zero = syntax.literal("0.0");
    let mut tests = Vec::new();
    for parameter in spec.run_time_parameters() {
        let name = local_name(parameter, syntax);
        let (least, greatest) = spec.ends(parameter).unwrap_or((0.0, f64::INFINITY));
        let end = |value| literal(value, spec.precision, syntax);
        let own = match spec.domain(parameter) {
            Domain::Finite => vec![syntax.finite(&name)],
            Domain::Positive => vec![
                syntax.finite(&name),
                format!("({name} >= {})", end(least)),
                format!("({name} <= {})", end(greatest)),
            ],
            Domain::Within => within(spec, parameter, syntax),
            Domain::PositiveOrInfinite => vec![format!("({name} > {zero})")],
            Domain::BelowTau => vec![format!("({name} >= {})", end(least))],
        };
        let legal = spec.legal(parameter);
        let place = place(parameter, syntax);
        let require = |test| Requirement {
            test,
            local: name.clone(),
            parameter: place.clone(),
            legal: legal.clone(),
        };
        tests.extend(own.into_iter().map(require));
    }
    if let Some((parameter, greatest)) = &controller.report.greatest
        && let Some(number) = greatest.number()
    {
        let bound = literal(number::round(number, spec.precision), spec.precision, syntax);
        tests.push(Requirement {
            test: format!("({} <= {bound})", local_name(*parameter, syntax)),
            local: local_name(*parameter, syntax),
            parameter: place(*parameter, syntax),
            legal: format!("at most {greatest}"),
        });
    }
    // eps below tau: both may be fixed, and then the spec has been checked.
    if spec.what == What::Associated {
        return tests;
    }
    let given: Vec<_> = [Parameter::Eps, Parameter::Tau]
        .into_iter()
        .filter(|p| !spec.fixed.contains_key(p))
        .collect();
    if let Some(first) = given.first() {
        let text = |parameter| parameter_text(spec, parameter, syntax);
        let (eps, tau) = (text(Parameter::Eps), text(Parameter::Tau));
        tests.push(Requirement {
            test: format!("({eps} < {tau})"),
            local: local_name(*first, syntax),
            parameter: place(*first, syntax),
            legal: if *first == Parameter::Eps { "> 0, < tau" } else { "finite, > eps" }.to_owned(),
        });
    }
    tests
}

/// The conditions that keep a parameter within the bounds that the user gave.
fn within(spec: &Spec, parameter: Parameter, syntax: &dyn Syntax) -> Vec<String> {
    let Some((least, greatest)) = spec.bounds.get(&parameter) else { return Vec::new() };
    let name = local_name(parameter, syntax);
    let text = |bound: &Fixed| {
        bound.number().map(|n| literal(number::round(n, spec.precision), spec.precision, syntax))
    };
    let least = text(least).map(|bound| format!("({name} >= {bound})"));
    least.into_iter().chain(text(greatest).map(|bound| format!("({name} <= {bound})"))).collect()
}
