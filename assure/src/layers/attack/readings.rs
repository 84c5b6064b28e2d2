//! Wild and lost readings of an observer with a gate.

use std::fs;
use std::process::Command;

use anyhow::{Context as _, Result, ensure};

use super::world::World;
use crate::context::workspace;
use crate::layer::Finding;

/// The bound of the innovation that the page has, and one that lets every number pass.
const BOUNDS: [&str; 2] = ["1e-4", "1e300"];

/// The largest |x1| at the deadline, and 2 s later, with a gate.
const MOST: f64 = 1e-6;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let [gated, believing] = BOUNDS.map(|bound| measured(world, bound));
    let gated = gated?;
    let page = fs::read_to_string(workspace().join("docs/benchmarks/samples.md"))?;
    let lacking = gated.lines().filter(|row| !page.contains(row));
    finding.failures.extend(lacking.map(|row| format!("docs/benchmarks/samples.md lacks {row}")));
    finding.failures.extend(faults(&gated));
    finding.seed("a gate that believes every reading", faults(&believing?).into_iter().next());
    Ok(format!("{} loops with and without a wild or lost reading", gated.lines().count() - 2))
}

/// The table of `tools/gate.py` for a bound of the innovation.
fn measured(world: &World, bound: &str) -> Result<String> {
    let script = workspace().join("tools/gate.py");
    let output = Command::new("python3").arg(script).arg(&world.command).arg(bound).output()?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Ok(String::from_utf8(output.stdout).context("UTF-8")?.trim_end().to_owned())
}

/// Returns the rows of loops with a gate in which a reading has an effect, or is not counted as gated.
fn faults(table: &str) -> Vec<String> {
    let rows = table.lines().skip(2).filter(|row| row.contains("| yes |"));
    let is_kept = |row: &&str| {
        let cells: Vec<_> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [reading, _, deadline, later, saturated, gated, refused] = cells[..] else {
            return false;
        };
        let near = |size: &str| size.parse::<f64>().is_ok_and(|size| size <= MOST);
        let told = if reading == "none" { "0" } else { "1" };
        near(deadline) && near(later) && (saturated, gated, refused) == ("0", told, "0")
    };
    rows.filter(|row| !is_kept(row)).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gated_rows_must_stay_small_and_accepted() {
        let head = "| reading | gate |\n| --- | --- |\n";
        let row = |cells: &str| faults(&format!("{head}{cells}")).len();
        assert_eq!(row("| NaN | yes | 3.3e-07 | 3.1e-07 | 0 | 1 | 0 |"), 0);
        assert_eq!(row("| NaN | no | 3.3 | 3.1 | 9 | 0 | 7 |"), 0);
        assert_eq!(row("| NaN | yes | 3.3e-01 | 3.1e-07 | 0 | 1 | 0 |"), 1);
        assert_eq!(row("| NaN | yes | 3.3e-07 | 3.1e-07 | 0 | 0 | 1 |"), 1);
        assert_eq!(row("| none | yes | nan | 3.1e-07 | 0 | 0 | 0 |"), 1);
    }
}
