//! Rust: `no_std`, no allocation, no panic, no unsafe code.

use askama::Template;

use super::plan::{Field, Function, Plan};
use super::print::{self, RootText, Syntax};
use super::{Controller, Declared, File, Language, declared, header, indented, tidy};
use crate::program::number;
use crate::spec::{Domain, Fixed, Guard, Parameter, Precision, Spec};

/// The file of a controller, which stands alone.
pub(super) fn file(controller: &Controller<'_>) -> File {
    let name = controller.spec.name();
    let real = real(controller.spec);
    let items = Items::new(controller, "").render().unwrap_or_default();
    let calls = |function: &str| items.contains(&format!("math::{function}("));
    let functions = ["sqrt", "exp", "ln", "pow"].into_iter().filter(|f| calls(f));
    let head = header::lines(controller, Language::Rust);
    let module = Module {
        head: &head.iter().map(|line| format!("//! {line}\n")).collect::<String>(),
        real,
        functions: functions.map(|f| MathFunction::new(f, controller.spec.precision)).collect(),
        items: &items,
    };
    File { name: format!("{name}.rs"), text: tidy(&module.render().unwrap_or_default()) }
}

/// The items alone, on the types of the facade crate.
pub(super) fn items(controller: &Controller<'_>) -> String {
    tidy(&Items::new(controller, "::ptc::").render().unwrap_or_default())
}

fn real(spec: &Spec) -> &'static str {
    match spec.precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    }
}

/// A function of the file's own `math` module: its signature, the method of `std` and the
/// function of `libm`.
struct MathFunction {
    signature: String,
    method: String,
    libm: String,
}

impl MathFunction {
    fn new(function: &str, precision: Precision) -> Self {
        let real = if precision == Precision::F32 { "f32" } else { "f64" };
        let suffix = if precision == Precision::F32 { "f" } else { "" };
        let libm = if function == "ln" { "log" } else { function };
        if function == "pow" {
            return Self {
                signature: format!("pow(a: {real}, b: {real}) -> {real}"),
                method: "a.powf(b)".to_owned(),
                libm: format!("libm::pow{suffix}(a, b)"),
            };
        }
        Self {
            signature: format!("{function}(a: {real}) -> {real}"),
            method: format!("a.{function}()"),
            libm: format!("libm::{libm}{suffix}(a)"),
        }
    }
}

impl Items {
    /// `runtime` is the path of the types that the items stand on.
    fn new(controller: &Controller<'_>, runtime: &'static str) -> Self {
        let Controller { spec, program, .. } = *controller;
        let plan = Plan::new(program);
        let syntax = Rust { spec, runtime };
        let body = |function| print::print(&plan, function, &syntax);
        let inner = "        ";
        let (init, arm) = (body(Function::Init), body(Function::Arm));
        let (step, tick, axis) = (body(Function::Step), body(Function::Tick), body(Function::Axis));
        let set = |roots: &[String], armed: bool| -> Vec<(String, String)> {
            let fields = plan.fields.iter().filter(|f| f.armed == armed);
            fields.zip(roots).map(|(f, root)| (f.name.clone(), root.clone())).collect()
        };
        let finite = plan.fields.iter().filter(|f| !f.armed && !controller.is_given(f.value));
        let states_finite: Vec<_> = (1..=spec.n).map(|j| format!("x{j}.is_finite()")).collect();
        let u_max = program.limits.u_max;
        let limit =
            u_max.map(|value| match spec.fixed.get(&Parameter::UMax).and_then(Fixed::number) {
                Some(_) => syntax.fixed(Parameter::UMax),
                None => format!("self.{}", plan.name(value).unwrap_or_default()),
            });
        let locals = spec.run_time_parameters().map(|p| {
            let index = p.index().map(|i| format!("[{i}]")).unwrap_or_default();
            format!("let {} = params.{}{index};", local_name(p), p.key())
        });
        let list =
            |name: &str| (1..=spec.n).map(|j| format!("{name}{j}")).collect::<Vec<_>>().join(", ");
        Self {
            type_name: spec.type_name(),
            runtime,
            real: real(spec),
            n: spec.n,
            parameters: declared(spec),
            locals: indented(&locals.collect::<Vec<_>>(), inner),
            domain: domain(spec, &syntax),
            init: indented(&init.lines, inner),
            init_fields: set(&init.roots, false),
            arm_fields: set(&arm.roots, true),
            finite: finite.map(|f| f.name.clone()).collect(),
            start: if spec.fixed.contains_key(&Parameter::StartTime) {
                syntax.fixed(Parameter::StartTime)
            } else {
                "t0".to_owned()
            },
            arm: indented(&arm.lines, inner),
            states: format!("let [{}] = *x;", list("x")),
            gains_in: format!("let [{}] = self.gain;", list("gain")),
            states_finite,
            step: indented(&step.lines, inner),
            step_u: step.roots.first().cloned().unwrap_or_default(),
            tick: indented(&tick.lines, inner),
            tick_gains: tick.roots,
            axis: indented(&axis.lines, inner),
            axis_u: axis.roots.first().cloned().unwrap_or_default(),
            run_time_limit: limit.as_ref().is_some_and(|l| l.starts_with("self")),
            limit,
            guard: spec.guard,
            fields: plan.fields,
        }
    }
}

/// Name of a parameter in `new`.
fn local_name(parameter: Parameter) -> String {
    super::c::local_name(parameter)
}

/// The tests of the run-time parameters' domains.
fn domain(spec: &Spec, syntax: &Rust<'_>) -> Vec<String> {
    let mut tests = Vec::new();
    for parameter in spec.run_time_parameters() {
        let name = local_name(parameter);
        let finite = format!("{name}.is_finite()");
        let positive = format!("{name} > 0.0");
        match parameter.domain() {
            Domain::Finite => tests.push(finite),
            Domain::Positive => tests.extend([finite, positive]),
            Domain::PositiveOrInfinite => tests.push(positive),
            Domain::BelowTau => {
                let tau = match spec.fixed.get(&Parameter::Tau) {
                    Some(_) => syntax.fixed(Parameter::Tau),
                    None => "tau".to_owned(),
                };
                tests.extend([positive, format!("{name} < {tau}")]);
            }
        }
    }
    if spec.fixed.contains_key(&Parameter::Eps) && !spec.fixed.contains_key(&Parameter::Tau) {
        tests.push(format!("{} < tau", syntax.fixed(Parameter::Eps)));
    }
    tests
}

struct Rust<'a> {
    spec: &'a Spec,
    runtime: &'static str,
}

impl Rust<'_> {
    /// A fixed parameter as a literal.
    fn fixed(&self, parameter: Parameter) -> String {
        let number = self.spec.fixed.get(&parameter).and_then(Fixed::number);
        let value = number.map_or(0.0, |number| number::round(number, self.spec.precision));
        number::literal(value, self.spec.precision)
    }
}

impl Syntax for Rust<'_> {
    fn literal(&self, text: &str) -> String {
        text.to_owned()
    }

    fn field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = if function == "log" { "ln" } else { function };
        let path = match self.runtime {
            "" => "math".to_owned(),
            runtime => format!("{runtime}math::{}", real(self.spec)),
        };
        format!("{path}::{function}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        let name = a.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if name { format!("{a}.abs()") } else { format!("({a}).abs()") }
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("if {a} < {b} {{ {b} }} else {{ {a} }}")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("let {name} = {expression};")
    }

    fn hold(&self, name: &str, time_to_go: &str, eps: &str) -> Vec<String> {
        let runtime = self.runtime;
        vec![
            format!("let mut {name} = {time_to_go};"),
            format!("let mut status = {runtime}Status::Ok;"),
            format!("if {name} <= {eps} {{"),
            format!("    {name} = {eps};"),
            format!("    status = {runtime}Status::Hold;"),
            "}".to_owned(),
        ]
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let y = root.unknown;
        let mut lines = vec![
            format!("let mut {y} = {};", root.start),
            format!("let mut {y}_low = {};", root.low),
            format!("let mut {y}_high = {};", root.high),
            format!("for _ in 0..{} {{", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    let {y}_next = {};", root.next),
            format!("    let {y}_size = {};", root.size),
            format!("    if {} > {} {{", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    } else {".to_owned(),
            format!("        {y}_high = {y};"),
            "    }".to_owned(),
            format!("    if {y}_next >= {y}_low && {y}_next <= {y}_high {{"),
            format!("        {y} = {y}_next;"),
            "    } else {".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    }".to_owned(),
            format!("    if {y}_size <= {} {{", root.tolerance),
            "        break;".to_owned(),
            "    }".to_owned(),
            "}".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "module.rs.txt", escape = "none")]
struct Module<'a> {
    head: &'a str,
    real: &'static str,
    functions: Vec<MathFunction>,
    items: &'a str,
}

#[derive(Template)]
#[template(path = "items.rs.txt", escape = "none")]
struct Items {
    type_name: String,
    runtime: &'static str,
    real: &'static str,
    n: usize,
    parameters: Vec<Declared>,
    fields: Vec<Field>,
    locals: String,
    domain: Vec<String>,
    init: String,
    init_fields: Vec<(String, String)>,
    arm_fields: Vec<(String, String)>,
    finite: Vec<String>,
    start: String,
    arm: String,
    states: String,
    gains_in: String,
    states_finite: Vec<String>,
    step: String,
    step_u: String,
    tick: String,
    tick_gains: Vec<String>,
    axis: String,
    axis_u: String,
    limit: Option<String>,
    run_time_limit: bool,
    guard: Guard,
}
