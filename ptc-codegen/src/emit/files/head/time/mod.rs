//! The head of an emitted file: how to make it again, what it does and on which conditions.

mod behaviour;
mod purpose;

use super::declared::{declared, meaning};
use super::{Controller, Language, axes, flight, formulas};
use crate::check::Verdict;
use crate::check::examine::{Report, held_period};
use crate::controller::measured::Measured;
use crate::diagnostic::digits;
use crate::parameter::Parameter;
use crate::program::{Op, Stage, cost};
use crate::request::{Feedback, Spec, What};
use behaviour::behaviour;
pub(super) use behaviour::limits_of_u;
use purpose::purpose;

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
    let mut rest = vec![version(spec), String::new()];
    if associated {
        rest.push("xi_i' = xi_(i+1), xi_n' = mu'(t - t0)^n f + pi0(xi, t), in stretched time t. x = BB_n[mu] xi is the state of the plant, and f its f(x, u, t). Use it to design and simulate pi0.".to_owned());
        rest.push(format!("  pi0 = {}", formulas::pi0(spec)));
        rest.extend(parameters(controller, language));
        rest.extend(flight::of_duration(spec));
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

/// The version of the generator, and the fingerprint of the design.
pub(super) fn version(spec: &Spec) -> String {
    format!("Version {}, design {}.", env!("CARGO_PKG_VERSION"), spec.fingerprint())
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
