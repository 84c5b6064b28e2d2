//! Cost of a step on microcontrollers, and a check that it does not rise.

use std::fs;

use anyhow::{Context as _, Result, anyhow};
use ptc_codegen::controller::measured::{HEAD, Measured};
use ptc_codegen::request::Spec;

use super::seeded::put_in;
use crate::context::{Context, workspace};
use crate::harness::cost::{measure, plugin};
use crate::harness::machine::Machine;
use crate::harness::net::examples_in_samples;
use crate::harness::selftest::sources;
use crate::harness::{empty, in_pairs};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ARM_GCC, GCC, NEWLIB, QEMU_ARM};

pub(super) const LAYER: Layer = Layer {
    name: "cost",
    claim: "A step takes no more instructions, stack and code on Cortex-M0 and M4F than \
            assurance/costs.tsv says, within 2 %.",
    tools: &[GCC, ARM_GCC, NEWLIB, QEMU_ARM],
    run,
};

const MACHINES: [Machine; 2] = [Machine::CortexM0, Machine::CortexM4f];

/// Set to write assurance/costs.tsv anew in place of comparing with it.
const UPDATE: &str = "UPDATE_COSTS";

/// The costs of `specs`, each on each machine.
///
/// # Errors
/// Fails if a cost cannot be measured or a tool fails.
pub fn costs(context: &Context, specs: &[Spec]) -> Result<Vec<Measured>> {
    let folder = context.scratch("cost");
    let plugin = plugin(&folder)?;
    let indexed: Vec<_> = specs.iter().enumerate().collect();
    let each = in_pairs(&indexed, |(index, spec)| -> Result<Vec<Measured>> {
        let sources = sources(&empty(&folder.join(index.to_string())), spec)?;
        MACHINES.iter().map(|machine| measure(*machine, &plugin, spec, &sources)).collect()
    });
    let mut all = Vec::new();
    for (spec, costs) in specs.iter().zip(each) {
        all.extend(costs.with_context(|| spec.command())?);
    }
    Ok(all)
}

/// A table of costs.
pub fn table(costs: &[Measured]) -> String {
    let lines = costs.iter().map(|cost| cost.line() + "\n");
    std::iter::once(format!("{HEAD}\n")).chain(lines).collect()
}

fn run(context: &Context) -> Result<Finding> {
    let mut specs = context.families(context.order(3));
    specs.extend(examples_in_samples());
    let measured = costs(context, &specs)?;
    let path = workspace().join("assurance/costs.tsv");
    if std::env::var_os(UPDATE).is_some() {
        fs::create_dir_all(path.parent().context("a folder")?)?;
        fs::write(&path, table(&measured))?;
    }
    let refresh = format!("write it with `{UPDATE}=1 cargo assure cost`");
    let text =
        fs::read_to_string(&path).with_context(|| format!("{}: {refresh}", path.display()))?;
    let kept = Measured::table(&text).map_err(|wrong| anyhow!("{}: {wrong}", path.display()))?;
    let mut finding = Finding { failures: risen(&measured, &kept), ..Finding::default() };
    finding.summary = format!(
        "{} steps measured, {} above assurance/costs.tsv",
        measured.len(),
        finding.failures.len()
    );
    let row = |cost: &Measured| {
        let numbers = [cost.instructions, cost.stack, cost.code].map(|n| n.to_string());
        [vec![format!("`{}`", cost.command), cost.target.clone()], numbers.to_vec()].concat()
    };
    finding.tables.push(Table {
        title: "Most instructions of a step, its stack and its code in bytes".to_owned(),
        head: vec!["controller", "machine", "instructions", "stack", "code"],
        rows: measured.iter().map(row).collect(),
    });
    finding.notes.push(
        "Instructions are counted under QEMU from the entry of `step` to its return, arithmetic and \
         functions of the compiler's libraries included; the most over all calls of the self-test, \
         which takes every branch. Arithmetic in software takes a number of instructions that \
         depends on the numbers: there the count is the most that was seen, no bound. Stack is that \
         of `step` itself, by -fstack-usage. gcc -O2."
            .to_owned(),
    );
    seeded(context, &kept, &mut finding)?;
    Ok(finding)
}

/// Lists the costs that exceed the kept ones, and those that the table lacks.
fn risen(measured: &[Measured], kept: &[Measured]) -> Vec<String> {
    let mut told = Vec::new();
    for cost in measured {
        let same = |kept: &&Measured| kept.target == cost.target && kept.command == cost.command;
        let Some(kept) = kept.iter().find(same) else {
            told.push(format!("{} on {}: not in the table", cost.command, cost.target));
            continue;
        };
        for (what, now, then) in [
            ("instructions", cost.instructions, kept.instructions),
            ("bytes of stack", cost.stack, kept.stack),
            ("bytes of code", cost.code, kept.code),
        ] {
            if 50 * now > 51 * then {
                told.push(format!("{} on {}: {now} {what}, was {then}", cost.command, cost.target));
            }
        }
    }
    told
}

/// A step with more arithmetic and the same u.
fn seeded(context: &Context, kept: &[Measured], finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("cost_seeded");
    let plugin = plugin(&folder)?;
    let spec = context.families(2).into_iter().find(|spec| spec.n == 2);
    let spec = spec.context("a controller of order 2")?;
    let sources = sources(&empty(&folder.join("controller")), &spec)?;
    let slower = "const double inv_T = (-1.0) / (late * ((x[0] * 0.0) + 1.0));";
    let defect =
        ("const double inv_T = (-1.0) / late;", slower, "a product and a sum more in step");
    put_in(&sources, defect)?;
    let measured = measure(Machine::CortexM4f, &plugin, &spec, &sources)?;
    finding.seed(defect.2, risen(&[measured], kept).first().cloned());
    Ok(())
}
