//! C99: a header and a source file.

use askama::Template;

use super::plan::{Field, Function, Plan};
use super::print::{self, RootText, Syntax};
use super::{Controller, Declared, File, Language, declared, header, indented, tidy};
use crate::program::number;
use crate::spec::{Domain, Fixed, Guard, Parameter, Precision, Spec};

/// The header and the source of a controller.
pub(super) fn files(controller: &Controller<'_>) -> Vec<File> {
    let spec = controller.spec;
    let name = spec.name();
    let plan = Plan::new(controller.program);
    let real = match spec.precision {
        Precision::F32 => "float",
        Precision::F64 => "double",
    };
    let head = header::lines(controller, Language::C);
    let head = head.iter().map(|line| format!(" * {line}\n")).collect::<String>();
    let declarations = Header {
        name: &name,
        guard_macro: format!("{}_H", name.to_uppercase()),
        real,
        n: spec.n,
        head: &head,
        parameters: &declared(spec),
        fields: &plan.fields,
    };
    let definitions = source(controller, &plan, &name, real);
    [(format!("{name}.h"), declarations.render()), (format!("{name}.c"), definitions.render())]
        .into_iter()
        .map(|(name, text)| File { name, text: tidy(&text.unwrap_or_default()) })
        .collect()
}

fn source<'a>(
    controller: &Controller<'a>,
    plan: &'a Plan<'a>,
    name: &'a str,
    real: &'static str,
) -> Source<'a> {
    let spec = controller.spec;
    let syntax = C { spec, real, owner: "self" };
    let built = C { spec, real, owner: "built" };
    let body = |function, syntax: &C<'_>| print::print(plan, function, syntax);
    let depth = |levels: usize| "    ".repeat(levels);
    let full = spec.guard == Guard::Full;
    let inner = depth(if full { 3 } else { 1 });
    let tick_indent = depth(if full { 2 } else { 1 });
    let init = body(Function::Init, &built);
    let arm = body(Function::Arm, &syntax);
    let step = body(Function::Step, &syntax);
    let tick = body(Function::Tick, &syntax);
    let axis = body(Function::Axis, &syntax);
    let assign = |roots: &[String], armed: bool, owner: &str| {
        let fields = plan.fields.iter().filter(|f| f.armed == armed);
        let one = |(field, root): (&Field, &String)| format!("{owner}.{} = {root};", field.name);
        fields.zip(roots).map(one).collect::<Vec<_>>()
    };
    let finite = |armed: bool, owner: &str| {
        let fields =
            plan.fields.iter().filter(|f| f.armed == armed && !controller.is_given(f.value));
        let tests: Vec<_> = fields.map(|f| format!("isfinite({owner}.{})", f.name)).collect();
        if tests.is_empty() { "1".to_owned() } else { tests.join(&format!("\n{}&& ", depth(4))) }
    };
    let locals = spec.run_time_parameters().map(|p| {
        let index = p.index().map(|i| format!("[{i}]")).unwrap_or_default();
        format!("const {real} {} = params->{}{index};", local_name(p), p.key())
    });
    let start = if spec.fixed.contains_key(&Parameter::StartTime) {
        syntax.fixed(Parameter::StartTime)
    } else {
        "t0".to_owned()
    };
    let arm_assignments: Vec<_> = assign(&arm.roots, true, "self")
        .into_iter()
        .map(|line| line.replacen("self.", "self->", 1))
        .collect();
    let states =
        (1..=spec.n).map(|j| format!("const {real} x{j} = x[{}];", j - 1)).collect::<Vec<_>>();
    let gains_in = (1..=spec.n)
        .map(|j| format!("const {real} gain{j} = gains->gain[{}];", j - 1))
        .collect::<Vec<_>>();
    let gains_out: Vec<_> = tick
        .roots
        .iter()
        .enumerate()
        .map(|(j, root)| format!("gains->gain[{j}] = {root};"))
        .collect();
    let u_max = controller.program.limits.u_max;
    let limit = u_max.map(|value| match spec.fixed.get(&Parameter::UMax).and_then(Fixed::number) {
        Some(number) => {
            syntax.literal(&number::literal(number::round(number, spec.precision), spec.precision))
        }
        None => format!("self->{}", plan.name(value).unwrap_or_default()),
    });
    let run_time_limit = limit.as_ref().is_some_and(|limit| limit.starts_with("self"));
    let finite_states: Vec<_> = (1..=spec.n).map(|j| format!("isfinite(x{j})")).collect();
    Source {
        name,
        real,
        n: spec.n,
        zero: syntax.literal("0.0"),
        parameters: indented(&locals.collect::<Vec<_>>(), &depth(2)),
        domain: domain(spec, &syntax).join(&format!("\n{}&& ", depth(3))),
        init: indented(&init.lines, &depth(3)),
        init_assign: indented(&assign(&init.roots, false, "built"), &depth(3)),
        init_finite: finite(false, "built"),
        start,
        arm: indented(&arm.lines, &depth(2)),
        arm_assign: indented(&arm_assignments, &depth(3)),
        arm_finite: plan
            .fields
            .iter()
            .filter(|f| f.armed)
            .zip(&arm.roots)
            .find(|(f, _)| f.name == "deadline")
            .map_or_else(String::new, |(_, root)| root.clone()),
        states: indented(&states, &depth(if full { 2 } else { 1 })),
        states_finite: finite_states.join(&format!("\n{}&& ", depth(3))),
        step: indented(&step.lines, &inner),
        step_u: step.roots.first().cloned().unwrap_or_default(),
        tick: indented(&tick.lines, &tick_indent),
        tick_gains: indented(&gains_out, &tick_indent),
        tick_indent,
        axis_gains: indented(&gains_in, &inner),
        axis: indented(&axis.lines, &inner),
        axis_u: axis.roots.first().cloned().unwrap_or_default(),
        axis_limit: limit.as_ref().map(|l| l.replace("self->", "gains->")),
        limit,
        run_time_limit,
        guard: spec.guard,
        indent: inner,
    }
}

impl Controller<'_> {
    /// Whether a value is a parameter as it was given, which its domain has been checked for.
    pub(super) fn is_given(&self, value: crate::program::Value) -> bool {
        matches!(self.program.get(value).op, crate::program::Op::Input(_))
    }
}

/// Name of a parameter in `init`.
pub(super) fn local_name(parameter: Parameter) -> String {
    match parameter {
        Parameter::Gain(i) => format!("k{i}"),
        Parameter::Rate(i) => format!("a{i}"),
        parameter => parameter.key().to_owned(),
    }
}

/// The tests of the run-time parameters' domains.
fn domain(spec: &Spec, syntax: &C<'_>) -> Vec<String> {
    let zero = syntax.literal("0.0");
    let mut tests = Vec::new();
    for parameter in spec.run_time_parameters() {
        let name = local_name(parameter);
        let finite = format!("isfinite({name})");
        let positive = format!("({name} > {zero})");
        match parameter.domain() {
            Domain::Finite => tests.push(finite),
            Domain::Positive => tests.extend([finite, positive]),
            Domain::PositiveOrInfinite => tests.push(positive),
            Domain::BelowTau => {
                let tau = match spec.fixed.get(&Parameter::Tau) {
                    Some(_) => syntax.fixed(Parameter::Tau),
                    None => "tau".to_owned(),
                };
                tests.extend([positive, format!("({name} < {tau})")]);
            }
        }
    }
    // An eps that is fixed still has to lie below a tau that is not.
    if spec.fixed.contains_key(&Parameter::Eps) && !spec.fixed.contains_key(&Parameter::Tau) {
        tests.push(format!("({} < tau)", syntax.fixed(Parameter::Eps)));
    }
    tests
}

struct C<'a> {
    spec: &'a Spec,
    real: &'static str,
    owner: &'static str,
}

impl C<'_> {
    /// A fixed parameter as a literal.
    fn fixed(&self, parameter: Parameter) -> String {
        let number = self.spec.fixed.get(&parameter).and_then(Fixed::number);
        let value = number.map_or(0.0, |number| number::round(number, self.spec.precision));
        let text = self.literal(&number::literal(value.abs(), self.spec.precision));
        if value < 0.0 { format!("-{text}") } else { text }
    }
}

impl Syntax for C<'_> {
    fn literal(&self, text: &str) -> String {
        match self.spec.precision {
            Precision::F32 => format!("{text}f"),
            Precision::F64 => text.to_owned(),
        }
    }

    fn field(&self, name: &str) -> String {
        format!("{}->{name}", self.owner)
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let suffix = if self.spec.precision == Precision::F32 { "f" } else { "" };
        format!("{function}{suffix}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        self.call("fabs", &[a.to_owned()])
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("({a} < {b}) ? {b} : {a}")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("const {} {name} = {expression};", self.real)
    }

    fn hold(&self, name: &str, time_to_go: &str, eps: &str) -> Vec<String> {
        vec![
            format!("{} {name} = {time_to_go};", self.real),
            format!("if ({name} <= {eps}) {{"),
            format!("    {name} = {eps};"),
            "    status = PTC_HOLD;".to_owned(),
            "}".to_owned(),
        ]
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let (real, y) = (self.real, root.unknown);
        let mut lines = vec![
            format!("{real} {y} = {};", root.start),
            format!("{real} {y}_low = {};", root.low),
            format!("{real} {y}_high = {};", root.high),
            format!("for (uint32_t round = 0U; round < {}U; round++) {{", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    const {real} {y}_next = {};", root.next),
            format!("    const {real} {y}_size = {};", root.size),
            format!("    if ({} > {}) {{", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    } else {".to_owned(),
            format!("        {y}_high = {y};"),
            "    }".to_owned(),
            format!("    if (({y}_next >= {y}_low) && ({y}_next <= {y}_high)) {{"),
            format!("        {y} = {y}_next;"),
            "    } else {".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    }".to_owned(),
            format!("    if ({y}_size <= {}) {{", root.tolerance),
            "        break;".to_owned(),
            "    }".to_owned(),
            "}".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.h.txt", escape = "none")]
struct Header<'a> {
    name: &'a str,
    guard_macro: String,
    real: &'static str,
    n: usize,
    head: &'a str,
    parameters: &'a [Declared],
    fields: &'a [Field],
}

#[derive(Template)]
#[template(path = "controller.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    real: &'static str,
    n: usize,
    zero: String,
    parameters: String,
    domain: String,
    init: String,
    init_assign: String,
    init_finite: String,
    start: String,
    arm: String,
    arm_assign: String,
    arm_finite: String,
    states: String,
    states_finite: String,
    step: String,
    step_u: String,
    tick: String,
    tick_gains: String,
    tick_indent: String,
    axis_gains: String,
    axis: String,
    axis_u: String,
    limit: Option<String>,
    axis_limit: Option<String>,
    run_time_limit: bool,
    guard: Guard,
    indent: String,
}
