//! The verdicts of the command, attacked with designs of known truth.

use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result};
use serde_json::Value;

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::command::text;
use crate::harness::runtime;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{GCC, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "verdicts",
    claim: "Of random designs and objectives just above and just below the true supremum, which \
            mpmath, NumPy and SciPy compute, `verify` proves none that fails and fails none that \
            holds; `check` is right just inside and outside of what it decides, the bounds of `loop` are \
            the worst case of loops run sample by sample, `simulate` ends \
            where the plant does, and what `design` chooses meets its objectives. Emitted C whose \
            `init` takes parameters of any size gives u its digits.",
    tools: &[PYTHON, GCC],
    run,
};

const PACKAGES: [&str; 4] = ["mpmath>=1.3", "gmpy2", "numpy>=1.26", "scipy>=1.11"];

/// Numbers of draws: objectives on each side of the truth, the greatest order, designs for `check` and for its `loop`,
/// runs of `simulate`, and wishes for `design`. Then suprema that are computed by another route, and sets of parameters
/// of each emitted controller.
struct Size {
    each_way: usize,
    order: usize,
    checks: usize,
    loops: usize,
    simulate: usize,
    design: usize,
    attained: usize,
    digits: usize,
}

const FULL: Size = Size {
    each_way: 500,
    order: 8,
    checks: 600,
    loops: 1000,
    simulate: 100,
    design: 20,
    attained: 40,
    digits: 40,
};
const BRIEF: Size = Size {
    each_way: 20,
    order: 4,
    checks: 30,
    loops: 30,
    simulate: 8,
    design: 2,
    attained: 4,
    digits: 3,
};
/// Enough to meet a truth that is wrong by 3 %, where what is drawn is off by 1 % to 5 %.
const SEED: Size = Size {
    each_way: 12,
    order: 2,
    checks: 60,
    loops: 12,
    simulate: 4,
    design: 0,
    attained: 0,
    digits: 2,
};

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("verdicts"), &PACKAGES)?;
    let attack = Attack { python: &python, command: &generator()?, context };
    let found = attack.run("true", if context.brief { &BRIEF } else { &FULL }, 1.0)?;
    let mut finding = Finding::default();
    finding.failures.extend(faults(&found));
    tables(&found, &mut finding);
    let seeds = context.in_turn(vec![(1.03, "falsely proved"), (0.97, "falsely failed")]);
    for (scale, proved) in seeds {
        let wrong = attack.run(&format!("scaled by {scale}"), &SEED, scale)?;
        let told = faults(&wrong);
        let kinds = [
            (proved, "suprema"),
            ("its condition", "edges of checks"),
            ("loop:", "worst cases of loops"),
            ("is off", "states"),
            ("lost digits", "controls"),
        ];
        for (kind, what) in kinds {
            let caught = told.iter().find(|fault| fault.contains(kind));
            let first_line = caught.and_then(|fault| fault.lines().next()).map(str::to_owned);
            finding.seed(&format!("true {what}, scaled by {scale}"), first_line);
        }
    }
    Ok(finding)
}

/// The campaign in Python.
struct Attack<'a> {
    python: &'a Path,
    command: &'a Path,
    context: &'a Context,
}

impl Attack<'_> {
    /// Returns the findings with the truth multiplied by `scale`.
    fn run(&self, name: &str, size: &Size, scale: f64) -> Result<Value> {
        let mut run = Command::new(self.python);
        run.arg(workspace().join("assure/verdicts/main.py"))
            .arg(self.command)
            .arg(self.context.scratch(&format!("verdicts/{name}")));
        let numbers = [
            ("--each-way", size.each_way),
            ("--order", size.order),
            ("--checks", size.checks),
            ("--loops", size.loops),
            ("--simulate", size.simulate),
            ("--design", size.design),
            ("--attained", size.attained),
            ("--digits", size.digits),
        ];
        for (flag, number) in numbers {
            run.arg(flag).arg(number.to_string());
        }
        run.arg("--seed").arg(self.context.seed.to_string()).arg("--scale").arg(scale.to_string());
        let told = text(run.env("PYTHONDONTWRITEBYTECODE", "1"))?;
        serde_json::from_str(&told).context("the campaign prints one object")
    }
}

/// Each false verdict, with the design that shows it.
fn faults(found: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    for result in list(&found["verify"]["false"]) {
        for fault in list(&result["faults"]) {
            let (kind, number) = (&fault[0], &fault[1]);
            let kind = kind.as_str().unwrap_or_default();
            faults.push(format!("{kind}: {number}, of {}\n{}", result["name"], shown(result)));
        }
    }
    for result in list(&found["checks"]["false"]) {
        let holds = if result["holds"] == Value::Bool(true) { "holds" } else { "does not hold" };
        let text = |key: &str| result[key].as_str().unwrap_or_default();
        let (check, verdict) = (text("check"), text("verdict"));
        let (words, shown) = (&result["words"], shown(result));
        faults.push(format!("{check} is {verdict}, but its condition {holds}: {words}\n{shown}"));
    }
    for result in list(&found["checks"]["unconfirmed"]) {
        faults.push(format!("two computations of the truth differ: {}", result["words"]));
    }
    for result in list(&found["loops"]["false"]) {
        faults.push(format!("loop: {} of {}\n{}", result["why"], result["name"], shown(result)));
    }
    for result in list(&found["simulate"]["false"]) {
        let error = result["error"].as_f64().unwrap_or(f64::INFINITY);
        faults.push(format!(
            "simulate is off by {error:.1e} of what is allowed, or ends early, with exit code 0: {} {}\n{}",
            result["name"],
            result["words"],
            shown(result)
        ));
    }
    for result in list(&found["design"]["false"]) {
        let (name, most) = (&result["name"], &result["most"]);
        faults.push(format!(
            "design chose what reaches {most} of a bound: {name}\n{}",
            shown(result)
        ));
    }
    for result in list(&found["digits"]["false"]) {
        let name = result["name"].as_str().unwrap_or_default();
        faults.push(format!("u has lost digits: {name}\n{}", shown(result)));
    }
    let missed = found["attained"]["miss"].as_f64().unwrap_or(0.0);
    if missed > 1e-6 {
        faults.push(format!("the two routes to the truth differ by {missed:.1e}"));
    }
    faults
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// The design of a result, and what the command printed of it.
fn shown(result: &Value) -> String {
    let text = |key: &str| result[key].as_str().unwrap_or_default();
    format!("{}{}", text("design"), text("printed"))
}

fn tables(found: &Value, finding: &mut Finding) {
    let (verify, checks, simulate) = (&found["verify"], &found["checks"], &found["simulate"]);
    finding.summary = format!(
        "{} objectives above and {} below the truth, {} designs of `check`, {} runs of `simulate`",
        verify["above"], verify["below"], checks["designs"], simulate["designs"]
    );
    let counted = |title: &str, counts: &Value| {
        let counts = counts.as_object().into_iter().flatten();
        let row = |(verdict, count): (&String, &Value)| {
            let (verdict, truth) = verdict.split_once(", ").unwrap_or((verdict, ""));
            [title, verdict, truth, &count.to_string()].map(str::to_owned).to_vec()
        };
        counts.map(row).collect::<Vec<_>>()
    };
    let mut rows = counted("verify", &verify["verdicts"]);
    for (check, counts) in checks["verdicts"].as_object().into_iter().flatten() {
        rows.extend(counted(check, counts));
    }
    rows.extend(counted("loop", &found["loops"]["verdicts"]));
    finding.tables.push(Table {
        title: "Verdicts, and the truth".to_owned(),
        head: vec!["of", "verdict", "truth", "objectives or designs"],
        rows,
    });
    let proved = verify["proved_with_room"].as_object().into_iter().flatten();
    let rows =
        proved.map(|(n, counts)| vec![n.clone(), counts[0].to_string(), counts[1].to_string()]);
    finding.tables.push(Table {
        title: "Objectives with 5 % of room".to_owned(),
        head: vec!["n", "proved", "of"],
        rows: rows.collect(),
    });
    let kinds = simulate["kinds"].as_object().into_iter().flatten();
    let number =
        |value: &Value| value.as_f64().map_or("-".to_owned(), |value| format!("{value:.1e}"));
    let rows = kinds.map(|(kind, of)| {
        let [runs, finished] = [&of["runs"], &of["finished"]].map(Value::to_string);
        vec![kind.clone(), runs, finished, number(&of["error"]), number(&of["tolerance"])]
    });
    finding.tables.push(Table {
        title: "Runs of `simulate`".to_owned(),
        head: vec!["kind", "runs", "finished", "greatest error", "allowed"],
        rows: rows.collect(),
    });
    let design = &found["design"];
    finding.notes.push(format!(
        "`design` made a choice for {} of {} wishes, which reaches at most {} of a bound.",
        design["chosen"],
        design["wishes"],
        number(&design["most"])
    ));
    let digits = &found["digits"];
    finding.notes.push(format!(
        "Of {} sets of parameters of any size `init` took {}; {} calls of `step` gave u its digits or, \
         {} times, no u.",
        digits["accepted"].as_u64().unwrap_or(0) + digits["refused"].as_u64().unwrap_or(0),
        digits["accepted"],
        digits["calls"],
        digits["range"]
    ));
    finding.notes.push(format!(
        "{} objectives that fail by 1 % or 5 % were held by sampling, which claims a probability; \
         {} routes by SciPy to the truth differ from it by at most {}.",
        verify["held"],
        found["attained"]["runs"],
        number(&found["attained"]["miss"])
    ));
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn each_kind_of_fault_is_named() {
        let clean = json!({
            "verify": { "false": [] }, "checks": { "false": [], "unconfirmed": [] },
            "loops": { "false": [] },
            "simulate": { "false": [] }, "design": { "false": [] }, "attained": { "miss": 1e-9 },
            "digits": { "false": [] },
        });
        assert_eq!(faults(&clean), Vec::<String>::new());
        let wrong = json!({
            "verify": { "false": [{ "name": "verify3", "faults": [["falsely proved", 2], ["exit code", 0]] }] },
            "checks": {
                "false": [{ "check": "growth", "verdict": "sound", "holds": false, "words": ["--n", "1"] }],
                "unconfirmed": [{ "words": [] }],
            },
            "loops": { "false": [{ "name": "sampled2", "why": ["sound with a room of -0.01"] }] },
            "simulate": { "false": [{ "name": "simulate4", "error": 30.0, "words": [] }] },
            "design": { "false": [{ "name": "design5", "most": 1.01 }] },
            "attained": { "miss": 1e-3 },
            "digits": { "false": [{ "name": "exp, n = 2, f32", "printed": "tau = 1" }] },
        });
        let told = faults(&wrong);
        let kinds = [
            "falsely proved: 2",
            "exit code: 0",
            "growth is sound, but its condition does not hold",
            "two computations",
            "loop: [\"sound with a room of -0.01\"] of \"sampled2\"",
            "simulate is off by 3.0e1",
            "design chose what reaches 1.01",
            "u has lost digits: exp, n = 2, f32",
            "two routes",
        ];
        assert_eq!(told.len(), kinds.len());
        kinds.iter().zip(&told).for_each(|(kind, told)| assert!(told.contains(kind), "{told}"));
    }

    #[test]
    fn page_shows_the_numbers_of_a_full_run() {
        let page = include_str!("../../../docs/checks/soundness.md");
        let Size { each_way, checks, loops, simulate, design, attained, order, digits } = FULL;
        let numbers = [
            format!("until {each_way} objectives above and {each_way} below"),
            format!("n = 1..{order} "),
            format!("for `check`: {checks} designs"),
            format!("for `loop`: {loops} designs"),
            format!("for `simulate`: {simulate} runs"),
            format!("for `design`: {design} wishes"),
            format!("for the truth itself: {attained} suprema"),
            format!("for the emitted C: {digits} sets of parameters"),
            // Two draws of six are for growth, one for each other check.
            format!("| {} designs in over 50 spellings", checks / 3),
            format!("| {} mappings that stop rising", checks / 6),
        ];
        numbers.iter().for_each(|number| assert!(page.contains(number), "{number}"));
    }
}
