//! Every bit of sampled bytes of a part and of the head of rows under way, flipped.

use std::fs;

use anyhow::{Context as _, Result};

use super::world::{FILE, JOURNAL, LONG, ROWS, World};
use crate::harness::random::Random;
use crate::layer::Finding;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("damage")?;
    let mut random = Random(world.seed);
    let count = if world.brief { 6 } else { 100 };
    let mut flips = 0;
    let mut examine =
        |file: &str, whole: &[u8], end: usize, arguments: &[&str]| -> Result<Vec<String>> {
            let path = folder.join(file);
            let mut reads = |damaged: &[u8]| -> Result<bool> {
                flips += 1;
                fs::write(&path, damaged)?;
                let end = world.run(&folder, arguments)?;
                let told = String::from_utf8_lossy(&end.stderr);
                let refused = end.status.code() == Some(2) && told.contains(file);
                Ok(!refused || fs::read(&path)? != damaged)
            };
            accepted(&mut random, whole, end, count, &mut reads)
        };
    let merge = ["verify", FILE, "--merge", "part.parquet"];
    let part = examine("part.parquet", &world.rows, world.rows.len(), &merge)?;
    let mut first = world.under_way(&folder)?;
    first.kill()?;
    first.wait()?;
    let journal = fs::read(folder.join(JOURNAL))?;
    // A record is run again: `power` damages those.
    let rows = examine(JOURNAL, &journal, head(&journal)?, &LONG)?;
    finding.failures.extend(part.iter().chain(&rows).map(|bit| format!("{bit} was not reported")));
    fs::remove_file(folder.join(JOURNAL))?;
    // The reader of before, which knew a file by its ends.
    let magic = |bytes: &[u8]| Ok(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    let silent =
        accepted(&mut random, &world.rows, world.rows.len(), 4, &mut |bytes| magic(bytes))?;
    finding.seed("a reader without a checksum", silent.first().cloned());
    Ok(format!(
        "{flips} flipped bits of a part and of the head of rows under way ({ROWS}, {JOURNAL}), each reported by name"
    ))
}

/// The flipped bits of sampled bytes below `end` with which `reads` takes the file.
fn accepted(
    random: &mut Random,
    whole: &[u8],
    end: usize,
    count: usize,
    reads: &mut dyn FnMut(&[u8]) -> Result<bool>,
) -> Result<Vec<String>> {
    let mut taken = Vec::new();
    for _ in 0..count {
        let byte = usize::try_from(random.below(end as u64)).context("an index")?;
        for bit in 0..8 {
            let mut damaged = whole.to_vec();
            damaged[byte] ^= 1 << bit;
            if reads(&damaged)? {
                taken.push(format!("bit {bit} of byte {byte}"));
            }
        }
    }
    Ok(taken)
}

/// Bytes before the first record of a journal: the owner, and a header that says how long its campaign is.
pub(super) fn head(journal: &[u8]) -> Result<usize> {
    let first: Vec<_> = journal.split_inclusive(|byte| *byte == b'\n').take(4).collect();
    let design = String::from_utf8_lossy(first.last().context("a header")?).into_owned();
    let length = design.trim().strip_suffix(" bytes").and_then(|line| line.rsplit(' ').next());
    let length: usize = length.context("a length")?.parse()?;
    Ok(first.concat().len() + length + "\n".len() + 64 + "\n".len())
}
