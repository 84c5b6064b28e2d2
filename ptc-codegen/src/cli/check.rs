//! `check`: what every check says of a design.

#[cfg(feature = "lab")]
mod picture;

use std::fmt::Write;
#[cfg(feature = "lab")]
use std::path::PathBuf;

use crate::accepted::Accepted;
use crate::check::examine::{Report, examine_expanded};
use crate::check::resolved::{Choice, follows, lines};
use crate::check::sampled::{Bound, Cost, Gating, Margins, Worst, margins};
use clap::Args;
use serde_json::json;

use super::doubts::unknown;
use super::flags::{Design, EngineFlag, ListFormat, SpecFlags};
use super::progress::checking;
use super::report::{Failure, note};
use super::write;

pub(crate) const EXAMPLES: &str = "\
Checks with missing values are skipped, and the report names these values. An undecided check that
--allow does not name does not refuse the design, but the exit code is 3.

The fingerprint names the design with all that was chosen; verdicts, reports and emitted files of
one controller show the same.

JSON: {\"name\":\"...\",\"command\":\"...\",\"fingerprint\":\"...\",\"chosen\":[...],\"follows\":[...],
\"accepted\":true,\"verdict\":\"accepted; not looked at: overflow (envelope)\",\"undecided\":[],
\"not_looked_at\":[\"overflow (envelope)\"],\"checks\":[{\"name\":\"growth\",\"verdict\":\"sound\",
\"summary\":\"...\",\"details\":[...],\"fix\":null},...]};
`verdict` of a check is sound, unsound, refuted, undecided or not checked.

Examples:
  ptc-codegen check roll.toml
  ptc-codegen check roll.toml --sample-time 1e-3 --format json
  ptc-codegen check roll.toml --margins
  ptc-codegen check encoder.toml --plot feasible.svg
  ptc-codegen check --n 2 --mu \"exp(a=1)\" --poles=-4,-5";

/// What is asked of a check.
#[derive(Debug, Args)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) design: Design,
    #[command(flatten)]
    pub(crate) spec: SpecFlags,
    #[command(flatten)]
    pub(crate) engine: EngineFlag,
    /// Also find which true input gains, delays and jitter the sound loop tolerates (tries the check
    /// `loop` some 60 times)
    #[arg(long)]
    pub(crate) margins: bool,
    /// Draw from which x1 and x2 the limits of u and of the states allow which deadline, with a clock
    /// in samples: .svg, .png or .pdf
    #[cfg(feature = "lab")]
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: ListFormat,
}

/// Runs `check`.
pub(crate) fn check(request: &Check) -> Result<(), Failure> {
    #[cfg(feature = "lab")]
    let plot = picture::Plot::of(request.design.design.as_deref(), request.plot.as_deref())?;
    let source = request.spec.0.with_design(request.design.design.as_deref())?;
    let given = source.parse();
    let (mut spec, plant) = given.read_with_plant()?;
    if let Some(doubt) = plant.as_ref().and_then(|plant| unknown(&spec, plant)) {
        note(&doubt);
    }
    let expanded = request.engine.engine.prepare(&mut spec)?;
    let report = checking(|| examine_expanded(&spec, expanded));
    let refused = report.refusals().next().is_some();
    #[cfg(feature = "lab")]
    if let Some(plot) = plot {
        note(plot.write(&report.spec)?.trim_end());
    }
    let margins =
        request.margins.then(|| checking(|| margins(&report.spec, report.expanded.as_ref())));
    write::to_stdout(&match request.format {
        ListFormat::Text => text(&report, margins.as_ref()),
        ListFormat::Json => json(&report, margins.as_ref(), refused),
    })?;
    if refused {
        return Err(Failure::refused(Vec::new()));
    }
    // No check looks at coefficients that overflow.
    let undecided = report.undecided().next().is_some();
    if let Err(found) = Accepted::of(report) {
        return given.finish(None, found);
    }
    if undecided { Err(Failure::undecided(Vec::new())) } else { Ok(()) }
}

/// Prints a report, with the margins of the sound loop if they are asked for.
fn text(report: &Report, margins: Option<&Option<Margins>>) -> String {
    let spec = &report.spec;
    let order = match &spec.coupled {
        Some(coupled) => coupled.order_text(),
        None => format!("order n = {}", spec.n),
    };
    let mut out = format!("{}: {order}, {}\n", spec.name(), spec.command());
    let _ = writeln!(out, "\ndesign      {}", spec.fingerprint());
    for line in lines(&report.choices, spec) {
        let _ = writeln!(out, "            - {line}");
    }
    for outcome in &report.outcomes {
        let verdict = outcome.verdict.text();
        let _ = writeln!(out, "\n{:<11} {verdict}: {}", outcome.name, outcome.summary);
        for detail in &outcome.details {
            let _ = writeln!(out, "            - {detail}");
        }
        if let Some(fix) = &outcome.fix {
            let _ = writeln!(out, "            fix: {fix}");
        }
    }
    let _ = writeln!(out, "\nmargins     {}", report.margins());
    match margins {
        Some(Some(margins)) => {
            let _ = writeln!(out, "            {margins}");
        }
        Some(None) => out.push_str("            none of the bounds: `loop` is not sound\n"),
        None => {}
    }
    let _ = writeln!(out, "\n{}", report.verdict());
    out
}

/// The check of the sampled loop.
const LOOP: &str = "loop";

/// The worst case of each state at the deadline, by cause, and of x and u on the way. `total` is the bound, `final` what
/// signals reach; by `from_reference`, `from_g`, `from_jitter` and `from_rounding` the true one may be more.
fn worst_case(worst: &Worst) -> serde_json::Value {
    let each = |part: &dyn Fn(&Bound) -> f64| worst.states.iter().map(part).collect::<Vec<_>>();
    json!({
        "samples": worst.samples,
        "total": each(&|bound| bound.total()),
        "final": each(&|bound| bound.attained()),
        "from_x0": each(&|bound| bound.of_start()),
        "from_noise": each(&|bound| bound.noise.iter().sum()),
        "from_noise_of": worst.states.iter().map(|bound| &bound.noise).collect::<Vec<_>>(),
        "from_u_step": each(&|bound| bound.actuator),
        "from_f": each(&|bound| bound.of_force()),
        "from_g": each(&|bound| bound.gain),
        "from_reference": each(&|bound| bound.reference),
        "from_jitter": each(&|bound| bound.jitter),
        "from_rounding": each(&|bound| bound.rounding),
        "rms": each(&|bound| bound.rms),
        "u_rms": worst.way.as_ref().map(|way| way.u_rms),
        "u": worst.way.as_ref().map(|way| way.u),
        "x": worst.way.as_ref().map(|way| &way.x),
        "between": worst.way.as_ref().map(|way| way.between),
        "after": worst.after.as_ref().map(|after| json!({ "x": after.x, "u": after.u, "between": after.between })),
        "gate": worst.gating.as_ref().map(gate),
    })
}

/// Converts the results on the gate of an observer to JSON.
fn gate(found: &Gating) -> serde_json::Value {
    let cost = |cost: &Option<Cost>| {
        cost.as_ref()
            .map(|cost| json!({ "x": cost.x, "u": cost.u, "innovations": cost.innovations }))
    };
    json!({
        "readings": found.readings,
        "innovations": found.innovations,
        "lost": cost(&found.lost),
        "wild": cost(&found.wild),
    })
}

/// A value that was chosen.
pub(crate) fn chosen(choice: &Choice) -> serde_json::Value {
    json!({ "key": choice.key, "value": choice.value, "reason": choice.reason })
}

fn json(report: &Report, margins: Option<&Option<Margins>>, refused: bool) -> String {
    let checks: Vec<_> = report
        .outcomes
        .iter()
        .map(|outcome| {
            let mut entry = json!({
                "name": outcome.name,
                "verdict": outcome.verdict.text(),
                "summary": outcome.summary,
                "details": outcome.details,
                "fix": outcome.fix,
            });
            if let (LOOP, Some(worst)) = (outcome.name, &report.worst) {
                entry["worst"] = worst_case(worst);
            }
            entry
        })
        .collect();
    let mut design = json!({
        "name": report.spec.name(),
        "command": report.spec.command(),
        "fingerprint": report.spec.fingerprint(),
        "chosen": report.choices.iter().map(chosen).collect::<Vec<_>>(),
        "follows": follows(&report.spec).iter().map(chosen).collect::<Vec<_>>(),
        "accepted": !refused,
        "verdict": report.verdict(),
        "undecided": report.undecided().map(|outcome| outcome.name).collect::<Vec<_>>(),
        "not_looked_at": report.unseen(),
        "checks": checks,
    });
    design["stability"] = match report.stability() {
        Ok(stable) => json!({
            "gain": stable.gain,
            "delay": stable.delay,
            "resonance": stable.resonance.as_ref().map(|found| json!({
                "examined_hz": found.examined,
                "unstable_hz": found.unstable,
            })),
        }),
        Err(_) => serde_json::Value::Null,
    };
    if let Some(margins) = margins {
        let tried = |margins: &Margins| {
            let [jitter, periods] = margins.jitter;
            json!({
                "gain": margins.gain,
                "delay": margins.delay,
                "jitter": jitter,
                "jitter_periods": periods,
            })
        };
        design["margins"] = margins.as_ref().map_or(serde_json::Value::Null, tried);
    }
    format!("{design}\n")
}
