//! Several processes on one output.

use std::fs;

use anyhow::Result;

use super::world::{JOURNAL, LONG, VERIFY, World};
use crate::layer::Finding;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    finding.failures.extend(second(world, false)?);
    // What there was before the lock: the second process does not see the rows of the first.
    finding.seed("a second process that finds no lock", second(world, true)?);
    for count in [2, 4] {
        let folder = world.folder("owners")?;
        let all = (0..count).map(|_| world.start(&folder, &VERIFY)).collect::<Result<Vec<_>>>()?;
        let mut done = 0;
        for child in all {
            let end = child.wait_with_output()?;
            let told = String::from_utf8_lossy(&end.stderr);
            if end.status.code() == Some(2) && told.contains("is in use by another run") {
                continue;
            }
            done += 1;
            if end.status.code() != world.code || end.stdout != world.verdict {
                finding.failures.push(format!("of {count} processes one: {}, {told}", end.status));
            }
        }
        let rows = fs::read(folder.join(super::world::ROWS)).unwrap_or_default();
        if done == 0 || rows != world.rows {
            finding
                .failures
                .push(format!("{count} processes, {done} of which ran, left other rows"));
        }
    }
    Ok("2 and 4 processes on one output: one has it, the others name it and change nothing"
        .to_owned())
}

/// Returns the fault of a process that finds a campaign under way, whose journal may have been taken away.
fn second(world: &World, taken: bool) -> Result<Option<String>> {
    let folder = world.folder("second")?;
    let mut first = world.under_way(&folder)?;
    if taken {
        fs::remove_file(folder.join(JOURNAL))?;
    }
    let arguments = if taken { &VERIFY[..] } else { &LONG[..] };
    let end = world.run(&folder, arguments)?;
    first.kill()?;
    first.wait()?;
    let told = String::from_utf8_lossy(&end.stderr);
    let owner = format!("process {}", first.id());
    let refused = end.status.code() == Some(2) && told.contains(&owner) && told.contains(JOURNAL);
    Ok((!refused).then(|| format!("a second process ran beside the first: {}, {told}", end.status)))
}
