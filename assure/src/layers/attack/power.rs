//! Rows under way after a power cut: zeros, torn records and flipped bits.

use std::fs;
use std::ops::Range;

use anyhow::{Context as _, Result};

use super::world::{FILE, JOURNAL, ROWS, World, names};
use crate::harness::random::Random;
use crate::layer::Finding;

/// A campaign of some hundred records, each quick.
const CAMPAIGN: [&str; 5] = ["verify", FILE, "--out", ROWS, "--scenarios=12000"];

/// Size of the damaged tail: one page of a file system.
const PAGE: usize = 4096;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("power")?;
    let whole = world.run(&folder, &CAMPAIGN)?;
    anyhow::ensure!(whole.status.success(), "{}", String::from_utf8_lossy(&whole.stderr));
    let rows = fs::read(folder.join(ROWS))?;
    fs::remove_file(folder.join(ROWS))?;
    let mut child = world.under_way_with(&folder, &CAMPAIGN)?;
    child.kill()?;
    child.wait()?;
    let kept = fs::read(folder.join(JOURNAL))?;
    let mut random = Random(world.seed);
    let head = super::corruption::head(&kept)?;
    let count = if world.brief { 2 } else { 40 };
    let mut damages = Vec::new();
    for _ in 0..count {
        let mut at = || -> Result<usize> {
            // Not in the last record, which may be half there.
            let whole = kept.len() - head - 2 * PAGE;
            Ok(head + usize::try_from(random.below(whole as u64)).context("an index")?)
        };
        let (first, second, bit) = (at()?, at()?, at()? % 8);
        damages.push(("zeros at the end", zeroed(&kept, first..kept.len() + PAGE)));
        damages.push(("a page of zeros", zeroed(&kept, first..(first + PAGE).min(kept.len()))));
        damages.push(("half a record", kept[..second].to_vec()));
        let mut flipped = kept.clone();
        flipped[first] ^= 1 << bit;
        damages.push(("a flipped bit", flipped));
    }
    let resumed = damages.len();
    for (damage, bytes) in damages {
        fs::write(folder.join(JOURNAL), bytes)?;
        let end = world.run(&folder, &CAMPAIGN)?;
        let told = String::from_utf8_lossy(&end.stderr);
        // What ends within a record was being written when the process was killed.
        let reported = told.contains(JOURNAL) && told.contains("are kept");
        if let Some(wrong) = lost(&end, &whole.stdout, fs::read(folder.join(ROWS)).ok(), &rows) {
            finding.failures.push(format!("{damage}: {wrong}; {told}"));
        }
        if damage != "half a record" && !reported {
            finding.failures.push(format!("{damage} was not reported: {told}"));
        }
        if names(&folder)? != [ROWS, FILE] {
            finding.failures.push(format!("{damage}: {:?} is left", names(&folder)?));
        }
    }
    let end = world.run(&folder, &CAMPAIGN)?;
    let caught = lost(&end, &whole.stdout, Some(zeroed(&rows, rows.len() / 2..rows.len())), &rows);
    finding.seed("zeros that are taken for rows", caught);
    Ok(format!(
        "{resumed} journals with zeros, torn records and flipped bits, each resumed to the result of one run"
    ))
}

fn zeroed(bytes: &[u8], range: Range<usize>) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes.resize(bytes.len().max(range.end), 0);
    bytes[range].fill(0);
    bytes
}

/// Returns the difference between a resumed campaign and one run.
fn lost(
    end: &std::process::Output,
    verdict: &[u8],
    there: Option<Vec<u8>>,
    rows: &[u8],
) -> Option<String> {
    match () {
        () if !end.status.success() => Some(end.status.to_string()),
        () if end.stdout != verdict => Some("another verdict".to_owned()),
        () if there.is_none_or(|there| there != rows) => Some("other rows".to_owned()),
        () => None,
    }
}
