//! Statements of one report, and of a run of the same design, that cannot both be true.

use serde_json::Value;

use super::one::{Answers, totals, worst};

/// Rounding in numbers that are printed, and what a bound may be exceeded by.
const ROUNDING: f64 = 1e-9;

/// Returns true if a check has one of the verdicts.
fn is(checks: &Value, name: &str, verdicts: &[&str]) -> bool {
    let own = checks.as_array().into_iter().flatten().find(|check| check["name"] == name);
    own.is_some_and(|own| verdicts.iter().any(|verdict| own["verdict"] == *verdict))
}

/// The checks with a verdict.
fn named(checks: &Value, verdicts: &[&str]) -> Vec<String> {
    let all = checks.as_array().into_iter().flatten();
    let with = all.filter(|check| verdicts.iter().any(|verdict| check["verdict"] == *verdict));
    with.filter_map(|check| check["name"].as_str().map(str::to_owned)).collect()
}

/// The summary, the notes and the fix of a check.
fn words(checks: &Value, name: &str) -> String {
    let own = checks.as_array().into_iter().flatten().find(|check| check["name"] == name);
    own.map(|own| format!("{} {} {}", own["summary"], own["details"], own["fix"]))
        .unwrap_or_default()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

/// The first index at which a number exceeds its bound.
fn exceeds(values: &[f64], bounds: &[f64]) -> Option<usize> {
    let above = |(value, bound): (&f64, &f64)| *value > bound * (1.0 + ROUNDING) + 1e-300;
    values.iter().zip(bounds).position(above)
}

/// Each contradiction in the answers about one design.
pub(super) fn faults(answers: &Answers) -> Vec<String> {
    let report = &answers.report;
    let checks = &report["checks"];
    let mut found = of_acceptance(report, answers.exit);
    let looped = words(checks, "loop");
    let sound = is(checks, "loop", &["sound"]);
    let fails = ["unsound", "refuted"];
    // With a clock in time growth speaks of the law without a guard.
    let in_samples =
        report["command"].as_str().is_some_and(|line| line.contains("--clock samples"));
    if in_samples && sound && is(checks, "growth", &fails) {
        found.push("growth refuses what loop proves".to_owned());
    }
    let growth = words(checks, "growth");
    let is_stable = looped.contains("the loop is stable") || growth.contains("the loop is stable");
    let gains = numbers(&report["stability"]["gain"]);
    if is_stable
        && gains.first().zip(gains.last()).is_some_and(|(low, high)| *low > 1.0 || *high < 1.0)
    {
        found.push("the loop is stable, and its margins exclude the nominal gain".to_owned());
    }
    if looped.contains("never clipped") && looped.contains("may reach its limit") {
        found.push("loop says that u is clipped and that it is not".to_owned());
    }
    if let Some(worst) = worst(report) {
        let last = totals(worst);
        if let (true, Some(index)) = (sound, exceeds(&last, &answers.error)) {
            found.push(format!("loop is sound, and its bound of x{} exceeds `error`", index + 1));
        }
        let way = numbers(&worst["x"]);
        if exceeds(&last, &way).is_some() {
            found.push(format!(
                "x at the deadline, {last:?}, exceeds its bound on the way, {way:?}"
            ));
        }
        if looped.contains("never clipped")
            && worst["u"].as_f64().is_some_and(|u| u > answers.u_max)
        {
            found.push(format!(
                "|u| may be {}, and is never clipped at {}",
                worst["u"], answers.u_max
            ));
        }
        let is_clipped = !looped.contains("never clipped");
        for (verdict, wrong, beside) in [(0, "fails", "above"), (1, "holds, proved", "below")] {
            let own = answers.verdicts.get(verdict).filter(|own| own.starts_with(wrong));
            if let Some(own) = own.filter(|_| !is_clipped && answers.is_within) {
                found.push(format!(
                    "verify says `{own}` of an error just {beside} the worst case of loop"
                ));
            }
        }
        found.extend(of_run(answers, worst, looped.contains("never clipped")));
    }
    found.iter().map(|fault| format!("contradiction: {fault}")).collect()
}

/// Lists where acceptance, the list of undecided checks and the exit code do not follow from the verdicts.
fn of_acceptance(report: &Value, exit: i32) -> Vec<String> {
    let checks = &report["checks"];
    let refused = !named(checks, &["unsound", "refuted"]).is_empty();
    let undecided = named(checks, &["undecided"]);
    let told: Vec<_> =
        report["undecided"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let mut found = Vec::new();
    if report["accepted"] != Value::Bool(!refused) {
        found.push(format!("accepted is {}, and a check refuses: {refused}", report["accepted"]));
    }
    if told != undecided {
        found.push(format!("{undecided:?} are undecided, and the report lists {told:?}"));
    }
    let due = if refused {
        1
    } else if undecided.is_empty() {
        0
    } else {
        3
    };
    if exit != due {
        found.push(format!("exit code {exit} in place of {due}"));
    }
    found
}

/// Lists the places where a run from within x0_max exceeds the bounds of `loop`.
fn of_run(answers: &Answers, worst: &Value, is_never_clipped: bool) -> Vec<String> {
    let mut found = Vec::new();
    let Some(last) = answers.run.last().filter(|_| answers.is_within) else { return found };
    if is_never_clipped && answers.run.iter().any(|row| row.status.contains("SATURATED")) {
        found.push("u is never clipped, and a run clips it".to_owned());
    }
    let bounds = totals(worst);
    let ends = numbers(&worst["samples"])
        .first()
        .is_none_or(|samples| *samples + 1.0 <= answers.run.len() as f64);
    let sizes = |x: &[f64]| x.iter().map(|x| x.abs()).collect::<Vec<_>>();
    // A clipped run has no bound.
    if !is_never_clipped || !ends {
        return found;
    }
    if let Some(index) = exceeds(&sizes(&last.x), &bounds) {
        found.push(format!(
            "a run ends at x{} = {:e}, beyond {:e}",
            index + 1,
            last.x[index],
            bounds[index]
        ));
    }
    let u = answers.run.iter().flat_map(|row| &row.u).fold(0.0f64, |most, u| most.max(u.abs()));
    if worst["u"].as_f64().is_some_and(|bound| exceeds(&[u], &[bound]).is_some()) {
        found.push(format!("a run has |u| = {u:e}, beyond {}", worst["u"]));
    }
    found
}
