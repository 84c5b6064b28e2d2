//! ACSL in comments: contracts for the header, and the cases that Eva has to look at apart.

mod samples;

pub(super) use samples::{changed, notes as in_samples};

use super::Controller;
use super::c::Notes;
use crate::code::Code;
use crate::controller::plan::Plan;
use crate::parameter::{Domain, Fixed, Parameter, Precision};
use crate::program::{Input, Op, number};
use crate::request::{After, Guard, Spec, What};

/// The contracts of a controller, and its case splits.
pub(super) fn notes(controller: &Controller<'_>, program: &Code) -> Notes {
    let spec = controller.spec();
    let (name, n) = (spec.name(), spec.states());
    let state = |array: &str| Pointer { name: array.to_owned(), count: Some(n), out: false };
    let one = |name: &str, out| Pointer { name: name.to_owned(), count: None, out };
    let full = spec.guard == Guard::Full || spec.what == What::Associated;
    let built = format!(
        "ensures \\result == PTC_OK || \\result == PTC_E_PARAM;\n\
         ensures \\result == PTC_OK ==> {name}_set(self);"
    );
    let x0: Vec<_> = spec.latches().then(|| state("x0")).into_iter().collect();
    let mut init = vec![one("self", true)];
    if !program.parameters.is_empty() {
        init.push(one("params", false));
    }
    init.extend(state_if(&x0));
    let mut arm = vec![one("self", true)];
    arm.extend(state_if(&x0));
    // arm reads what init has set.
    let mut arm_requires = requires(&arm, true);
    arm_requires.push(format!("requires self == \\null || {name}_set(self);"));
    let starts = [
        ("init", comment(&requires(&init, true), "*self", &built)),
        ("arm", comment(&arm_requires, "*self", &built)),
    ];
    let result = |name: &str| Pointer { out: true, ..state(name) };
    let of = |given: Option<&str>, result: Pointer| {
        associated(&name, given.map(&state).into_iter().chain([result]))
    };
    let calls = match spec.what {
        What::Associated => vec![
            ("rate", of(Some("xi"), result("xi_dot"))),
            ("state", of(Some("xi"), result("x"))),
            ("control", of(Some("xi"), one("u", true))),
            ("time", of(None, one("plant_time", true))),
            ("start", of(Some("x0"), result("xi"))),
        ],
        _ => vec![
            ("step", step(spec, full, &state("x"))),
            ("tick", tick(&name, n, full)),
            ("axis", axis(spec, full, &state("x"))),
        ],
    };
    let contracts = starts.into_iter().chain(calls);
    Notes {
        predicates: predicates(controller, program),
        contracts: contracts.collect(),
        // The tests of sizes leave a state for each set of gains that are 0.
        before_tests: Some("/*@ slevel merge; */"),
        behind: Some(split_root),
    }
}

/// Pointer argument of a function.
struct Pointer {
    name: String,
    /// Length of an array; none for a single object.
    count: Option<usize>,
    /// True if the function writes to it.
    out: bool,
}

fn state_if(arrays: &[Pointer]) -> impl Iterator<Item = Pointer> + '_ {
    arrays.iter().map(|p| Pointer { name: p.name.clone(), count: p.count, out: p.out })
}

impl Pointer {
    fn place(&self) -> String {
        match self.count {
            Some(count) => format!("{} + (0 .. {})", self.name, count - 1),
            None => self.name.clone(),
        }
    }
}

/// Returns the preconditions on pointers; with `nullable` any of them may be NULL.
fn requires(pointers: &[Pointer], nullable: bool) -> Vec<String> {
    let either =
        |name: &str| if nullable { format!("{name} == \\null || ") } else { String::new() };
    let one = |p: &Pointer| {
        let valid = if p.out { "\\valid" } else { "\\valid_read" };
        format!("requires {}{valid}({});", either(&p.name), p.place())
    };
    pointers.iter().map(one).collect()
}

fn comment(requires: &[String], assigns: &str, ensures: &str) -> String {
    let lines = requires
        .iter()
        .cloned()
        .chain([format!("assigns {assigns};")])
        .chain(ensures.lines().map(str::to_owned));
    let lines: Vec<_> = lines.collect();
    format!("/*@ {}\n */", lines.join("\n    "))
}

/// Legal parameters, and a controller that `init` and `arm` have set.
fn predicates(controller: &Controller<'_>, program: &Code) -> String {
    let spec = controller.spec();
    let name = spec.name();
    let mut text = String::new();
    let mut legal: Vec<_> = spec.run_time_parameters().flat_map(|p| domain(spec, p)).collect();
    let given = |p: Parameter| match spec.fixed.get(&p) {
        Some(fixed) => real(fixed, spec),
        None => place("p->", p),
    };
    if spec.what == What::Controller && !legal.is_empty() {
        legal.push(format!("{} < {}", given(Parameter::Eps), given(Parameter::Tau)));
    }
    if !legal.is_empty() {
        text.push_str(&format!(
            "/*@ predicate {name}_legal({name}_params *p) =\n      {};\n */\n",
            legal.join("\n      && ")
        ));
    }
    let seen = program.fields.iter().filter(|field| is_seen(controller, &field.name));
    let set: Vec<_> = seen.map(|field| format!("\\is_finite(c->{})", field.name)).collect();
    let set = if set.is_empty() { "\\true".to_owned() } else { set.join("\n      && ") };
    text.push_str(&format!("/*@ predicate {name}_set({name} *c) =\n      {set};\n */"));
    text
}

/// Returns true if Eva sees that a field is finite: `init` or `arm` has called `isfinite` on the variable stored in it.
fn is_seen(controller: &Controller<'_>, name: &str) -> bool {
    let plan = Plan::new(controller.spec(), controller.program);
    let Some(field) = plan.fields.iter().find(|field| field.name == name) else { return false };
    let tested = |p| matches!(controller.spec().domain(p), Domain::Finite | Domain::Positive);
    match controller.program.get(field.value).op {
        Op::Input(Input::Parameter(parameter)) => tested(parameter),
        _ => matches!(name, "t0" | "deadline"),
    }
}

/// The domain of a run-time parameter; bounds are reals, so that nothing is rounded twice.
fn domain(spec: &Spec, parameter: Parameter) -> Vec<String> {
    let place = place("p->", parameter);
    let finite = format!("\\is_finite({place})");
    match spec.domain(parameter) {
        Domain::Finite => vec![finite],
        Domain::Positive | Domain::BelowTau => {
            let (least, greatest) = spec.ends(parameter).unwrap_or((0.0, f64::INFINITY));
            let [least, greatest] =
                [least, greatest].map(|end| number::literal(end, Precision::F64));
            vec![finite, format!("{least} <= {place}"), format!("{place} <= {greatest}")]
        }
        Domain::PositiveOrInfinite => vec![format!("{place} > 0.0")],
        Domain::BelowUMax | Domain::AboveUMin => {
            let limit = |parameter| match spec.fixed.get(&parameter) {
                Some(Fixed::Number { value, .. }) => {
                    number::literal(number::round(value, spec.precision), Precision::F64)
                }
                Some(Fixed::Infinite) => "\\plus_infinity".to_owned(),
                Some(Fixed::MinusInfinite) => "\\minus_infinity".to_owned(),
                None => self::place("p->", parameter),
            };
            let (least, most) = (limit(Parameter::UMin), limit(Parameter::UMax));
            let mut tests = vec![format!("{least} < {most}")];
            if spec.after == After::Zero {
                tests.extend([format!("{least} <= 0.0"), format!("0.0 <= {most}")]);
            }
            tests
        }
        Domain::Within => {
            let bounds = spec.bounds.get(&parameter);
            let (least, greatest) = match bounds {
                Some((least, greatest)) => (real(least, spec), real(greatest, spec)),
                None => return vec![finite],
            };
            vec![finite, format!("{least} <= {place}"), format!("{place} <= {greatest}")]
        }
    }
}

/// A parameter as a member of the struct that `owner` leads to.
pub(super) fn place(owner: &str, parameter: Parameter) -> String {
    match parameter.index() {
        Some(index) => format!("{owner}{}[{index}]", parameter.key()),
        None => format!("{owner}{}", parameter.key()),
    }
}

/// A fixed number as ACSL writes a real.
fn real(value: &Fixed, spec: &Spec) -> String {
    let rounded = value.number().map_or(f64::INFINITY, |n| number::round(n, spec.precision));
    number::literal(rounded, Precision::F64)
}

/// Statuses that u can have, and what a negative one means.
const OF_U: &str = "ensures -3 <= \\result <= 3;";

fn step(spec: &Spec, full: bool, x: &Pointer) -> String {
    let name = spec.name();
    let pointers = [
        Pointer { name: "self".to_owned(), count: None, out: false },
        Pointer { name: x.name.clone(), count: x.count, out: false },
        Pointer { name: "u".to_owned(), count: None, out: true },
    ];
    let pointers: Vec<_> = pointers.into_iter().chain(reference(spec)).collect();
    let mut conditions = requires(&pointers, full);
    let set = if full { "self == \\null || " } else { "" };
    conditions.push(format!("requires {set}{name}_set(self);"));
    conditions.extend(trusted(spec, true));
    comment(&conditions, "*u", OF_U)
}

/// Returns the preconditions, besides those on pointers, of a guard that does not check its inputs.
fn trusted(spec: &Spec, time: bool) -> Vec<String> {
    if spec.guard != Guard::None {
        return Vec::new();
    }
    let time = time.then(|| "requires \\is_finite(t);".to_owned());
    let finite = |array: &str, count: usize| -> Vec<_> {
        (0..count).map(|j| format!("requires \\is_finite({array}[{j}]);")).collect()
    };
    let given = [finite("x", spec.states()), finite("r", spec.references())];
    time.into_iter().chain(given.concat()).collect()
}

/// The reference, where each call is given it.
fn reference(spec: &Spec) -> Option<Pointer> {
    let count = Some(spec.references()).filter(|count| *count > 0);
    count.map(|_| Pointer { name: "r".to_owned(), count, out: false })
}

/// The contract of a function of the associated system, which writes the last of `pointers`.
fn associated(name: &str, pointers: impl Iterator<Item = Pointer>) -> String {
    let own = Pointer { name: "self".to_owned(), count: None, out: false };
    let pointers: Vec<_> = std::iter::once(own).chain(pointers).collect();
    let mut conditions = requires(&pointers, true);
    conditions.push(format!("requires self == \\null || {name}_set(self);"));
    let written = pointers.last().map(|pointer| match pointer.count {
        Some(count) => format!("{}[0 .. {}]", pointer.name, count - 1),
        None => format!("*{}", pointer.name),
    });
    let ensures =
        "ensures \\result == PTC_OK || \\result == PTC_E_INPUT || \\result == PTC_E_RANGE;";
    comment(&conditions, &written.unwrap_or_default(), ensures)
}

fn tick(name: &str, n: usize, full: bool) -> String {
    let pointers = [
        Pointer { name: "self".to_owned(), count: None, out: false },
        Pointer { name: "gains".to_owned(), count: None, out: true },
    ];
    let mut conditions = requires(&pointers, full);
    let set = if full { "self == \\null || " } else { "" };
    conditions.push(format!("requires {set}{name}_set(self);"));
    let refused = if full { " || \\result == PTC_E_INPUT" } else { "" };
    let ensures = format!(
        "ensures \\result == PTC_OK || \\result == PTC_HOLD{refused};\n\
         ensures \\result >= 0 ==> \\initialized(&gains->gain[0 .. {}]);",
        n - 1
    );
    comment(&conditions, "*gains", &ensures)
}

fn axis(spec: &Spec, full: bool, x: &Pointer) -> String {
    let pointers = [
        Pointer { name: "gains".to_owned(), count: None, out: false },
        Pointer { name: x.name.clone(), count: x.count, out: false },
        Pointer { name: "u".to_owned(), count: None, out: true },
    ];
    let pointers: Vec<_> = pointers.into_iter().chain(reference(spec)).collect();
    let mut conditions = requires(&pointers, full);
    conditions.extend(trusted(spec, false));
    comment(&conditions, "*u", OF_U)
}

/// Cases of the root of an iteration, and tolerances in each: how far the iteration went is not
/// seen, so that the root may lie anywhere in its bracket; in a narrow case of it nothing that is
/// computed from the root can vanish.
const ROOT_CASES: u32 = 16;
const ROOT_CASE: u32 = 16;

/// Splits the values of the root `y` into narrow cases, in units of the iteration's tolerance.
fn split_root(y: &str, tolerance: &str, real: &str) -> Vec<String> {
    let edge = |k: u32| format!("({real})({}.0 * {tolerance})", ROOT_CASE * k);
    let merge = "/*@ slevel merge; */".to_owned();
    let cases = (1..=ROOT_CASES).map(|k| format!("/*@ split {y} <= {}; */", edge(k)));
    std::iter::once(merge).chain(cases).collect()
}
