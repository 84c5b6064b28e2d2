//! Devices, pipes, links and files of others as outputs.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context as _, Result, bail, ensure};

use super::world::{FILE, JOURNAL, VERIFY, World, names};
use crate::layer::Finding;

const SIMULATE: [&str; 6] = ["simulate", FILE, "--x0=1", "--plant=d=0", "--at=0,0.5", "-o"];

/// Writes the CSV to the path; where that is a pipe, somebody reads it.
type Writer<'a> = dyn Fn(&Path) -> Result<()> + 'a;

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let folder = world.folder("outputs")?;
    let printed = world.run(&folder, &[&SIMULATE[..], &["-"]].concat())?;
    ensure!(printed.status.success(), "{}", String::from_utf8_lossy(&printed.stderr));
    let csv = printed.stdout;
    let ours = |path: &Path| {
        let path = path.to_str().context("a path of text")?;
        let end = world.run(&folder, &[&SIMULATE[..], &[path]].concat())?;
        ensure!(end.status.success(), "{path}: {}", String::from_utf8_lossy(&end.stderr));
        Ok(())
    };
    finding.failures.extend(replaced(&folder, &csv, &ours)?);
    // The writer of before: a new file that takes the place of whatever is there.
    let renaming = |path: &Path| {
        fs::write(folder.join("new"), &csv)?;
        Ok(fs::rename(folder.join("new"), path)?)
    };
    let caught = replaced(&world.folder("replaced")?, &csv, &renaming)?;
    finding.seed("a writer that replaces what is there", caught.first().cloned());
    let with = |first: &[&'static str], more: &[&'static str]| [first, more].concat();
    let collisions = [
        with(&SIMULATE, &[FILE]),
        with(&SIMULATE, &["run.svg", "--plot", "run.svg"]),
        with(&["verify", FILE], &["--worst", FILE]),
        with(&["verify", FILE], &["--out", "b", "--worst", "b"]),
        with(&["verify", FILE], &["--out", "b", "--worst", "b.chunks"]),
        with(&["design", FILE], &["-o", FILE]),
    ];
    for arguments in &collisions {
        let folder = world.folder("collisions")?;
        let end = world.run(&folder, arguments)?;
        let kept = names(&folder)? == [FILE]
            && fs::read_to_string(folder.join(FILE))? == super::world::DESIGN;
        if end.status.code() != Some(2) || !kept {
            finding.failures.push(format!("{arguments:?}: {}", end.status));
        }
    }
    finding.failures.extend(foreign(world)?);
    Ok(format!(
        "devices, pipes and links written through, {} collisions refused, folders of others kept",
        collisions.len()
    ))
}

/// Lists the files that `write` has replaced or left unwritten, of each kind of file.
fn replaced(folder: &Path, csv: &[u8], write: &Writer<'_>) -> Result<Vec<String>> {
    let mut wrong = Vec::new();
    let path = |name: &str| folder.join(name);
    succeed(Command::new("ln").args(["-s", "/dev/null"]).arg(path("null")))?;
    succeed(Command::new("ln").args(["-s", "file"]).arg(path("link")))?;
    succeed(Command::new("mkfifo").arg(path("pipe")))?;
    fs::write(path("file"), "old")?;
    succeed(Command::new("chmod").arg("640").arg(path("file")))?;
    for name in ["null", "link"] {
        write(&path(name))?;
        if !path(name).symlink_metadata()?.is_symlink() {
            wrong.push(format!("the link {name} was replaced"));
        }
    }
    if fs::read(path("file"))? != csv {
        wrong.push("the file of a link was not written".to_owned());
    }
    let mode = Command::new("stat").args(["-c", "%a"]).arg(path("file")).output()?.stdout;
    if mode != b"640\n" {
        wrong.push(format!("the mode became {}", String::from_utf8_lossy(&mode)));
    }
    // A reader that nobody writes to ends by itself: killed, `timeout` would leave it behind.
    let reader = Command::new("timeout")
        .args(["20", "cat"])
        .arg(path("pipe"))
        .stdout(Stdio::piped())
        .spawn()?;
    write(&path("pipe"))?;
    let still = Command::new("test").arg("-p").arg(path("pipe")).status()?.success();
    if !still {
        wrong.push("the pipe was replaced".to_owned());
    }
    if reader.wait_with_output()?.stdout != csv {
        wrong.push("the reader of the pipe did not get what was written".to_owned());
    }
    Ok(wrong)
}

/// Returns the loss in a folder that has the name of the rows under way.
fn foreign(world: &World) -> Result<Option<String>> {
    let folder = world.folder("foreign")?;
    fs::create_dir(folder.join(JOURNAL))?;
    fs::write(folder.join(JOURNAL).join("mine"), "precious")?;
    let end = world.run(&folder, &VERIFY)?;
    let told = String::from_utf8_lossy(&end.stderr);
    let kept = fs::read(folder.join(JOURNAL).join("mine")).is_ok_and(|there| there == b"precious");
    let refused = end.status.code() == Some(2) && told.contains(JOURNAL);
    Ok((!kept || !refused).then(|| format!("a folder called {JOURNAL}: {}, {told}", end.status)))
}

fn succeed(command: &mut Command) -> Result<()> {
    match command.status()?.success() {
        true => Ok(()),
        false => bail!("{command:?}"),
    }
}
