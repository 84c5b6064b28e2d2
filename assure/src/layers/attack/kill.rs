//! Kills at random instants, each followed by the same command.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::Result;

use super::world::{FILE, JOURNAL, ROWS, VERIFY, World, names};
use crate::harness::random::Random;
use crate::layer::Finding;

const SIGNALS: [&str; 4] = ["-KILL", "-TERM", "-INT", "-HUP"];

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("kills")?;
    let mut random = Random(world.seed);
    let count = if world.brief { 20 } else { 100 };
    let mut resumed = 0;
    for index in 0..count {
        let signal = SIGNALS[index % SIGNALS.len()];
        let mut child = world.start(&folder, &VERIFY)?;
        std::thread::sleep(world.time.mul_f64(random.between(0.0, 1.0)));
        // It may have ended by itself already.
        Command::new("kill").args([signal, &child.id().to_string()]).output()?;
        child.wait()?;
        let told = |what: String| format!("kill {index} by {signal}: {what}");
        finding.failures.extend(left(world, &folder, signal)?.map(told));
        resumed += usize::from(folder.join(JOURNAL).exists());
        let end = world.run(&folder, &VERIFY)?;
        finding.failures.extend(world.differs(&folder, &end).map(told));
        let kept = names(&folder)?;
        if kept != [ROWS, FILE] {
            finding.failures.push(told(format!("{kept:?} after the resume")));
        }
        fs::remove_file(folder.join(ROWS))?;
    }
    if resumed == 0 {
        finding.failures.push("no kill met a campaign under way".to_owned());
    }
    // What two writers of one file once left: the first half of the rows under a verdict that holds.
    let end = world.run(&folder, &VERIFY)?;
    fs::write(folder.join(ROWS), &world.rows[..world.rows.len() / 2])?;
    let caught = world.differs(&folder, &end);
    finding.seed("rows cut off under the verdict of the whole", caught);
    // What a writer in place leaves when it is killed.
    let caught = left(world, &folder, "-TERM")?;
    finding.seed("rows half written after a kill", caught);
    Ok(format!("{count} kills at random instants, each resumed to the result of one run"))
}

/// Returns a file that a kill left and that is not of the tool or not whole. A temporary file, which SIGKILL alone can
/// leave, is removed by the next run.
fn left(world: &World, folder: &Path, signal: &str) -> Result<Option<String>> {
    for name in names(folder)? {
        let path = folder.join(&name);
        match name.as_str() {
            FILE | JOURNAL => {}
            ROWS if fs::read(&path)? == world.rows => {}
            ROWS => return Ok(Some("the file of the rows is half there".to_owned())),
            _ if signal == "-KILL" && name.starts_with(".ptc-") => {}
            _ => return Ok(Some(format!("it left {name}"))),
        }
    }
    Ok(None)
}
