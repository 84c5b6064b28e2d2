//! The head of an emitted file: how to make it again, what it does and on which conditions.

use super::declared::{declared, meaning};
use super::{Controller, Language, axes, formulas, plant};
use crate::check::Verdict;
use crate::check::examine::{Report, held_period};
use crate::controller::measured::Measured;
use crate::diagnostic::digits;
use crate::expression::Function;
use crate::model::Model;
use crate::parameter::{Fixed, Name, Parameter, Precision};
use crate::program::{Op, Stage, cost};
use crate::request::{After, Feedback, Guard, Reference, Spec, What};

/// Lines of the head, without comment signs.
pub(in crate::emit) fn lines(controller: &Controller<'_>, language: Language) -> Vec<String> {
    let spec = controller.spec();
    let lang = language.name();
    let associated = spec.what == What::Associated;
    let kind = if associated { "Infinite-time system of" } else { "Prescribed-time controller" };
    let (name, mapping_name) = (spec.name(), spec.mapping_name());
    let order = match &spec.coupled {
        Some(coupled) => coupled.order_text(),
        None => format!("order n = {}", spec.n),
    };
    let mut lines = vec![
        format!("{kind} {name}: {order}, mapping {mapping_name}."),
        String::new(),
        "DO NOT EDIT. Made by:".to_owned(),
    ];
    // A command is one line, to be copied.
    let command = format!("  ptc-codegen emit --lang {lang} {}", spec.command());
    let mut rest = vec![format!("Version {}.", env!("CARGO_PKG_VERSION")), String::new()];
    if associated {
        rest.push("xi_i' = xi_(i+1), xi_n' = mu'(t - t0)^n f + pi0(xi, t), in stretched time t. x = BB_n[mu] xi is the state of the plant, and f its f(x, u, t). Use it to design and simulate pi0.".to_owned());
        rest.push(format!("  pi0 = {}", formulas::pi0(spec)));
        rest.extend(parameters(controller, language));
        rest.extend(formulas::mapping(controller));
    } else {
        rest.extend(purpose(spec));
        rest.extend(axes::lines(spec));
        rest.extend(sample_period(controller));
        rest.extend(parameters(controller, language));
        rest.extend(formulas::mapping(controller));
        rest.extend(formulas::law(controller));
        rest.extend(behaviour(controller, language));
        rest.extend(checks(controller.report));
        rest.extend(count(controller));
        if !controller.measured.is_empty() {
            rest.push(
                "Measured, most instructions of one call of step over the self-test, library functions included:"
                    .to_owned(),
            );
            rest.extend(controller.measured.iter().map(Measured::told));
        }
    }
    lines.push(command);
    lines.extend(rest.into_iter().flat_map(|line| wrap(&line)));
    lines
}

/// The plant and what becomes of it.
fn purpose(spec: &Spec) -> Vec<String> {
    if let Some(coupled) = &spec.coupled {
        let inputs = Name::listed(&coupled.inputs);
        let plant = format!("the inputs {inputs}: {}", coupled.lines().join(", "));
        let at = match followed(spec) {
            "0" => "is 0".to_owned(),
            others => format!("is at {others}"),
        };
        return of_equations(&plant, &format!("every output with its derivatives {at}"));
    }
    if let Some(model) = &spec.model {
        return of_model(spec, model);
    }
    let n = spec.n;
    let input = if spec.input_gain.is_some() { "g u" } else { "u" };
    let chain = plant::chain(n, &format!("f + {input}"));
    vec![
        format!("Plant: {chain}. {}", plant::units(spec, input)),
        format!(
            "Goal: {} at the deadline t0 + tau from any state at t0, up to the error that the hold at eps, sampling, f and clipping leave. The checks below say what is known of this design.",
            goal(spec)
        ),
        match spec.drift {
            None => "f is not part of the law: cancel its known terms before the call.",
            Some(_) => {
                "The law cancels its own f(x, t). What differs from it is not part of the law."
            }
        }
        .to_owned(),
    ]
}

/// Where the state of a chain is at the deadline.
fn goal(spec: &Spec) -> &'static str {
    match &spec.reference {
        None => "x = 0",
        Some(Reference::Known(_)) => "x = (r, r', ...) of the reference r(t)",
        Some(Reference::Input) => "x = (r, r', ...) of the reference that each call is given",
    }
}

/// Where an output and its derivatives are at the deadline.
fn followed(spec: &Spec) -> &'static str {
    match &spec.reference {
        None => "0",
        Some(Reference::Known(_)) => "those of the reference r(t)",
        Some(Reference::Input) => "those of the reference that each call is given",
    }
}

/// The plant that is known by a model, and what becomes of it.
fn of_model(spec: &Spec, model: &Model) -> Vec<String> {
    let chain = match spec.n {
        1 => "the output".to_owned(),
        2 => "the output and its rate".to_owned(),
        n => format!("the output and its first {} derivatives", n - 1),
    };
    let at = followed(spec);
    let plant = format!("the input {}: {}", model.input, model.lines().join(", "));
    of_equations(&plant, &format!("{chain}, x, are {at}"))
}

/// A plant that is known by its equations, what is brought to where, and what the law leaves.
fn of_equations(plant: &str, goal: &str) -> Vec<String> {
    vec![
        format!("Plant, with {plant}. Time in s."),
        format!(
            "Goal: {goal} at the deadline t0 + tau from any state at t0, up to the error that the hold at eps, sampling, what differs from the model and clipping leave. The checks below say what is known of this design."
        ),
        "The law takes the plant to be the model. What differs from it is not part of the law."
            .to_owned(),
    ]
}

/// A design whose sample period no check has judged says so, loudly.
fn sample_period(controller: &Controller<'_>) -> Vec<String> {
    let (spec, outcomes) = (controller.spec(), &controller.report.outcomes);
    let open = outcomes.iter().any(|o| o.name == "sampling" && o.verdict == Verdict::NotChecked);
    if !open {
        return Vec::new();
    }
    let head = match spec.promises.sample_time {
        None => "SAMPLE PERIOD NOT GIVEN:",
        Some(_) => "SAMPLE PERIOD NOT CHECKED:",
    };
    let eps = spec.fixed.get(&Parameter::Eps);
    let period = match spec.coupled {
        Some(_) => None,
        None => held_period(spec, controller.report.expanded.as_ref()),
    };
    let text = match (eps, period) {
        (Some(eps), Some(Some(period))) => format!(
            "{head} with the gains held at eps = {eps} s, the loop with f = 0 and a zero-order hold is stable only for sample periods below {} s.",
            digits(period)
        ),
        (Some(eps), Some(None)) => format!(
            "{head} with the gains held at eps = {eps} s, NO SAMPLE PERIOD was found for which the loop with f = 0 and a zero-order hold is stable."
        ),
        _ if spec.feedback == Feedback::Linear && spec.coupled.is_none() => format!(
            "{head} the held gains grow as eps falls, and the loop is stable only for sample periods below a limit that depends on eps and the gains. ptc-codegen check finds it once tau, eps, the gains and --sample-time are given."
        ),
        _ => format!(
            "{head} the gain held at eps limits the sample period for which the loop is stable. {}",
            match spec.coupled {
                Some(_) => "Run the emitted step with a model of the plant, sampled.",
                None => "Simulate the sampled loop: ptc-codegen simulate --sample-time.",
            }
        ),
    };
    vec![String::new(), text]
}

fn parameters(controller: &Controller<'_>, language: Language) -> Vec<String> {
    let spec = controller.spec();
    let mut lines = vec![String::new(), "Parameters:".to_owned()];
    for parameter in spec.parameters() {
        let Some(value) = spec.fixed.get(&parameter) else { continue };
        if axes::have_own(spec, parameter) {
            continue;
        }
        let meaning = match parameter {
            Parameter::Gain(i) => format!("gain of xi_{i}"),
            _ => meaning(spec, parameter),
        };
        let unit = match parameter {
            Parameter::Named(_) => String::new(),
            _ => format!(" [{}]", spec.unit(parameter)),
        };
        lines.push(format!("  {} = {value}{unit}, fixed: {meaning}", parameter.symbol()));
    }
    let greatest = controller.report.greatest.as_ref();
    for parameter in declared(spec, language.element()) {
        let most = greatest.filter(|(bounded, _)| bounded.key() == parameter.name);
        let most = most.map(|(_, most)| format!(", at most {most}")).unwrap_or_default();
        lines.push(format!("  {}: {}{most}", parameter.name, parameter.about));
    }
    lines
}

fn behaviour(controller: &Controller<'_>, language: Language) -> Vec<String> {
    let spec = controller.spec();
    let held = match spec.feedback {
        Feedback::Linear => "the gains of T = eps are held",
        Feedback::Expression(_) | Feedback::Extern => "T is held at eps in the law",
    };
    let mut lines = vec![String::new()];
    lines.push(match spec.after {
        After::Hold => {
            format!("From t0 + tau - eps on, and after the deadline, {held} (status HOLD).")
        }
        After::Zero => format!(
            "From t0 + tau - eps on, {held} (status HOLD). From t0 + tau on, u = 0 (status AFTER)."
        ),
        After::Extern => format!(
            "From t0 + tau - eps on, {held} (status HOLD). From t0 + tau on, u is the result of the user-defined function after (status AFTER)."
        ),
    });
    lines.push(match spec.fixed.get(&Parameter::UMax) {
        Some(Fixed::Infinite) => "u is not clipped.".to_owned(),
        _ => "|u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the deadline."
            .to_owned(),
    });
    let [given, any] = match spec.references() {
        0 => ["t and x", "t or x"],
        _ => ["t, x and r", "t, x or r"],
    };
    let pointers = language == Language::C;
    lines.push(match (spec.guard, pointers) {
        (Guard::Full, true) => format!("Guard full: {given} are finite, t >= t0 and no pointer is NULL, or the call is refused (status E_INPUT)."),
        (Guard::Full, false) => {
            format!("Guard full: {given} are finite and t >= t0, or the call is refused (INPUT).")
        }
        (Guard::Result, true) => format!("Guard result: {any} that is not finite is refused by one test on u (status E_RANGE). t >= t0 and valid pointers are the responsibility of the caller."),
        (Guard::Result, false) => format!("Guard result: {any} that is not finite is refused by one test on u (RANGE). t >= t0 is the responsibility of the caller."),
        (Guard::None, true) => format!("Guard none: finite {given}, t >= t0 and valid pointers are the responsibility of the caller."),
        (Guard::None, false) => {
            format!("Guard none: finite {given} and t >= t0 are the responsibility of the caller.")
        }
    });
    let precision = match spec.precision {
        Precision::F64 => "f64 (IEEE 754 binary64)",
        Precision::F32 => "f32 (IEEE 754 binary32)",
    };
    let library = controller.program.values.iter().any(|value| match value.op {
        Op::Call(function, _) => {
            !matches!(function, Function::Abs | Function::Sign | Function::Sqrt)
        }
        Op::Pow(..) => true,
        _ => false,
    });
    let library = if library { " and with the same mathematical library" } else { "" };
    let (fused, machine) = match spec.fma {
        true => (
            ", with fused multiply-adds: a processor without them calls the library for each",
            "whose compiler fuses nothing more",
        ),
        false => ("", "without fused multiply-add"),
    };
    lines.push(format!(
        "Precision {precision}{fused}. Results are bit for bit the same on every IEEE 754 machine {machine} (gcc, clang: -ffp-contract=off){library}."
    ));
    lines
}

/// The verdicts of the checks. What they could not check is a condition for the user.
pub(super) fn checks(report: &Report) -> Vec<String> {
    let mut lines =
        vec![String::new(), "Checks of the design (details: ptc-codegen check):".to_owned()];
    for outcome in &report.outcomes {
        // A design that is emitted in spite of a failed check says so loudly.
        let verdict = match outcome.verdict {
            Verdict::Unsound | Verdict::Refuted => {
                format!("{}, ALLOWED BY THE DESIGN", outcome.verdict.text().to_uppercase())
            }
            verdict => verdict.text().to_owned(),
        };
        lines.push(format!("  {}: {verdict}: {}.", outcome.name, outcome.summary));
    }
    lines
}

fn count(controller: &Controller<'_>) -> Vec<String> {
    let (spec, program) = (controller.spec(), controller.program);
    let step = match &spec.axes {
        Some(axes) if spec.coupled.is_none() => cost::of_axes(program, axes.count),
        _ => cost::count(program, &program.controls(), Stage::Tick),
    };
    let several = |count: usize, one: &str, many: &str| match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        count => Some(format!("{count} {many}")),
    };
    let parts = [
        several(step.add, "addition or comparison", "additions or comparisons"),
        several(step.mul, "multiplication", "multiplications"),
        several(step.fused, "fused multiply-add", "fused multiply-adds"),
        several(step.div, "division", "divisions"),
        several(step.sqrt, "square root", "square roots"),
        several(step.calls, "function call", "function calls"),
    ];
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    let rounds = program.values.iter().find_map(|value| match &value.op {
        Op::Root(root) => Some(root.rounds),
        _ => None,
    });
    let rounds = rounds.map(|rounds| {
        format!(" One round of the iteration is counted; it takes at most {rounds}.")
    });
    vec![
        String::new(),
        format!(
            "Operations of one step, without input checks and clipping: {}.{}",
            parts.join(", "),
            rounds.unwrap_or_default()
        ),
    ]
}

/// A long line broken at spaces, continued with an indent.
pub(super) fn wrap(line: &str) -> Vec<String> {
    const WIDTH: usize = 92;
    let mut lines = Vec::new();
    let mut rest = line.to_owned();
    while rest.len() > WIDTH {
        let indent = rest.len() - rest.trim_start().len();
        let Some(cut) = rest[..WIDTH].rfind(' ').filter(|cut| *cut > indent) else { break };
        lines.push(rest[..cut].to_owned());
        rest = format!("      {}", rest[cut..].trim_start());
    }
    lines.push(rest);
    lines
}

#[cfg(test)]
mod tests {
    use super::wrap;

    #[test]
    fn wrapping_keeps_every_word() {
        let line = format!("  r_9 = {}", "123*a^4*T - ".repeat(40));
        let wrapped = wrap(&line);
        assert!(wrapped.iter().all(|l| l.len() <= 92));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&wrapped.join(" ")), words(&line));
        assert_eq!(wrap(&"x".repeat(200)).len(), 1);
    }
}
