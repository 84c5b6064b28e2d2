//! The head of an emitted file: how to make it again, and the mathematics in it.

use std::collections::BTreeSet;

use super::measured::Measured;
use super::{Controller, Language};
use crate::algebra::{self, Poly, Symbol};
use crate::expansion::{self, Expanded};
use crate::expression::Subject;
use crate::law::Form as LawForm;
use crate::mapping::{Custom, FamilyInfo, Form, Mapping};
use crate::program::{Stage, cost};
use crate::spec::{Feedback, Guard, Precision, Spec, TimeMapping, What};

/// Order up to which the head shows the closed forms in full; beyond it they fill pages.
const SHOWN: usize = 6;

/// Lines of the head, without comment signs.
pub(super) fn lines(controller: &Controller<'_>, language: Language) -> Vec<String> {
    let spec = controller.spec();
    let lang = language.name();
    let associated = spec.what == What::Associated;
    let kind = if associated { "Infinite-time system of" } else { "Prescribed-time controller" };
    let (name, n, mapping_name) = (spec.name(), spec.n, spec.mapping_name());
    let mut lines = vec![
        format!("{kind} {name}: order n = {n}, mapping {mapping_name}."),
        String::new(),
        "DO NOT EDIT. Made by:".to_owned(),
        format!("  ptc-codegen emit --lang {lang} {}", spec.command()),
        format!("Version {}.", env!("CARGO_PKG_VERSION")),
        String::new(),
    ];
    if associated {
        lines.push("xi_i' = xi_(i+1), xi_n' = mu'(t)^n f + pi0(xi, t), in stretched time t; the plant's state is".to_owned());
        lines.push(
            "x = BB_n[mu] xi, and f its own f(x, u, t). On it pi0 is designed and simulated."
                .to_owned(),
        );
        lines.push(format!("  pi0 = {}", pi0(spec)));
        lines.extend(parameters(controller));
        lines.extend(mapping(controller));
        return lines.into_iter().flat_map(|line| wrap(&line)).collect();
    }
    lines.push(
        "It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...)."
            .to_owned(),
    );
    lines.extend(parameters(controller));
    lines.extend(mapping(controller));
    lines.extend(law(controller));
    lines.extend(behaviour(controller));
    lines.extend(checks(controller));
    lines.extend(count(controller));
    if !controller.measured.is_empty() {
        lines.push("The most that one step took, measured over its self-test:".to_owned());
        lines.extend(controller.measured.iter().map(Measured::told));
    }
    lines.into_iter().flat_map(|line| wrap(&line)).collect()
}

fn parameters(controller: &Controller<'_>) -> Vec<String> {
    let mut lines = vec![String::new(), "Parameters:".to_owned()];
    let mut last = "";
    for parameter in controller.spec().parameters() {
        let key = parameter.key();
        let about = format!(
            "{} [{}], {}",
            parameter.meaning(),
            parameter.unit(),
            controller.spec().domain(parameter).text()
        );
        match controller.spec().fixed.get(&parameter) {
            Some(value) => {
                let index = parameter.index().map(|i| format!("[{i}]")).unwrap_or_default();
                lines.push(format!("  {key}{index} = {value}, fixed: {about}"));
            }
            None if key == last => {}
            None => lines.push(format!("  {key}: {about}")),
        }
        last = key;
    }
    lines
}

fn mapping(controller: &Controller<'_>) -> Vec<String> {
    let spec = controller.spec();
    let head = [
        String::new(),
        "Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):"
            .to_owned(),
    ];
    let own = match &spec.time_mapping {
        TimeMapping::Family { family, rates } => {
            closed_forms(spec, family.info(), &family.mapping(*rates))
        }
        TimeMapping::Custom(custom) => as_given(custom, spec.expanded.as_ref()),
    };
    head.into_iter().chain(own).collect()
}

/// What is told of a mapping that the user wrote down.
fn as_given(custom: &Custom, expanded: Option<&Expanded>) -> Vec<String> {
    let mut lines = Vec::new();
    let given = if custom.subject == Subject::Mu { "mu(t) " } else { "kappa(dt)" };
    lines.push(format!("  {given} = {}", custom.given));
    match &custom.form {
        Form::Complement(form) => {
            lines.push(format!("  tau - mu(t) = {form}, t the stretched time since t0"));
            lines
                .push("  kappa = the root t of tau - mu(t) = T, by a bounded iteration".to_owned());
        }
        Form::Kappa(kappa) => {
            lines.push(format!("  kappa = {}", kappa.form));
            lines.push(format!("  r_1 = T*({})", kappa.rate));
        }
    }
    match expanded {
        Some(Expanded::Custom { engine, r }) => {
            lines.push(format!(
                "Derivatives r_k = mu^(k)(kappa(Dt)), as the engine {engine} expands them:"
            ));
            let told = r.iter().take(SHOWN).enumerate();
            lines.extend(told.map(|(index, r)| format!("  r_{} = {r}", index + 1)));
        }
        _ => lines.push("r_k and BB_n come from its Taylor series at each tick.".to_owned()),
    }
    lines
}

/// The closed forms of a family.
fn closed_forms(spec: &Spec, info: &FamilyInfo, ring: &Mapping) -> Vec<String> {
    let shown = spec.n.min(SHOWN);
    let mut lines = vec![
        format!("  mu(t)     = {}", info.mu),
        format!("  kappa(Dt) = {}", info.kappa),
        format!("  atoms: {}", info.atoms),
        "Derivatives r_k = mu^(k)(kappa(Dt)):".to_owned(),
        format!("  r_k = {}", info.r),
    ];
    let forms = spec.closed_forms();
    let r = forms.map_or_else(|| expansion::r(ring, shown), |forms| forms.r[..shown].to_vec());
    for (index, r) in r.iter().enumerate() {
        lines.push(format!("  r_{} = {}", index + 1, algebra::text(r)));
    }
    lines
        .push("Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:".to_owned());
    let table = match forms {
        Some(forms) => forms.bell[..=shown].to_vec(),
        None if info.family.is_iterated() => expansion::bell::bell_table(shown),
        None => expansion::table(ring, shown),
    };
    for (i, row) in table.iter().enumerate() {
        let columns = if i == shown { &row[..i] } else { &row[..] };
        for (j, entry) in columns.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
            lines.push(format!("  B_{{{i},{j}}} = {}", algebra::text(entry)));
        }
    }
    if shown < spec.n {
        lines.push(format!(
            "  (to order {shown}; all of them: ptc-codegen show matrix --n {} --mu {})",
            spec.n, info.name
        ));
    }
    lines
}

/// The law pi0 in words.
fn pi0(spec: &Spec) -> String {
    match &spec.feedback {
        Feedback::Linear => "-(k_1 xi_1 + ... + k_n xi_n)".to_owned(),
        Feedback::Expression(law) => law.to_string(),
        Feedback::Extern => "a function of yours, called with xi and t_kappa".to_owned(),
    }
}

fn law(controller: &Controller<'_>) -> Vec<String> {
    let spec = controller.spec();
    let pi0 = pi0(spec);
    let gain = spec.input_gain.as_ref().map_or("1".to_owned(), ToString::to_string);
    let mut lines = vec![
        String::new(),
        "Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)".to_owned(),
        format!("  pi0 = {pi0}"),
        format!("  g   = {gain}"),
    ];
    if spec.feedback == Feedback::Linear {
        lines.push("  u = (sum_j gain_j x_j)/g".to_owned());
    }
    match &controller.law.form {
        LawForm::Rows { base_inverse, rows } => {
            let base = base_inverse.map(|s| format!("{}^(n+1-j) ", s.text())).unwrap_or_default();
            lines.push(format!("  gain_j = {base}row_j"));
            lines.push(format!("  K_i = k_i/({})^(n+1-i)", algebra::text(&controller.law.rate)));
            for (j, row) in rows.iter().take(SHOWN).enumerate() {
                lines.push(format!("  row_{} = {}", j + 1, algebra::text(row)));
            }
            lines.extend(definitions(*base_inverse, rows));
            if rows.len() > SHOWN {
                lines.push(format!(
                    "  (the first {SHOWN}; all of them: ptc-codegen show law --n {} --mu {})",
                    spec.n,
                    spec.mapping_name()
                ));
            }
        }
        LawForm::Series => {
            lines.push("  gain_j = r_1^-(n+1-j) row_j, k_(n+1) = 1".to_owned());
            lines.push(
                "  row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1)".to_owned(),
            );
            lines.push("  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l".to_owned());
        }
        LawForm::State => {
            lines
                .push("  xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j".to_owned());
            lines.push("  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l".to_owned());
        }
    }
    lines
}

/// What the quantities in the rows mean, where they are no atoms.
fn definitions(base_inverse: Option<Symbol>, rows: &[Poly]) -> Vec<String> {
    let used: BTreeSet<Symbol> = rows.iter().flat_map(Poly::symbols).chain(base_inverse).collect();
    let told = |s: Symbol| Some(format!("  {} = {}", s.text(), s.definition()?));
    used.into_iter().filter_map(told).collect()
}

fn behaviour(controller: &Controller<'_>) -> Vec<String> {
    let spec = controller.spec();
    let guard = match spec.guard {
        Guard::Full => "full: every input and pointer is checked.",
        Guard::Result => {
            "result: one test on u catches non-finite x and t; pointers and t >= t0 are trusted."
        }
        Guard::None => "none: pointers, finite x and t, and t >= t0 are trusted.",
    };
    let precision = match spec.precision {
        Precision::F64 => "f64 (IEEE 754 binary64)",
        Precision::F32 => "f32 (IEEE 754 binary32)",
    };
    vec![
        String::new(),
        "From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid."
            .to_owned(),
        "|u| <= u_max always (status SATURATED where u was clipped).".to_owned(),
        format!("Guard {guard}"),
        format!(
            "Precision {precision}. Equal bits everywhere need no fused multiply-add (-ffp-contract=off)."
        ),
    ]
}

/// What the checks say of the design. What they could not check is a condition for the user.
fn checks(controller: &Controller<'_>) -> Vec<String> {
    let mut lines =
        vec![String::new(), "Checks of the design (ptc-codegen check tells more):".to_owned()];
    for outcome in &controller.report.outcomes {
        let verdict = outcome.verdict.text();
        lines.push(format!("  {}: {verdict}: {}.", outcome.name, outcome.summary));
    }
    lines
}

fn count(controller: &Controller<'_>) -> Vec<String> {
    let program = controller.program;
    let step = cost::count(program, &[program.step], Stage::Tick);
    let loops = if controller.spec().is_iterated() { ", one round of the iteration" } else { "" };
    let cycles: Vec<_> = cost::WEIGHTS
        .iter()
        .map(|w| format!("{} about {} cycles", w.target, step.cycles(w)))
        .collect();
    vec![
        String::new(),
        format!(
            "Operations of one step: {} + - or comparison, {} *, {} /, {} sqrt, {} calls{loops}.",
            step.add, step.mul, step.div, step.sqrt, step.calls
        ),
        format!("Latencies added up: {}.", cycles.join(", ")),
    ]
}

/// A long line broken at spaces, continued with an indent.
fn wrap(line: &str) -> Vec<String> {
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
