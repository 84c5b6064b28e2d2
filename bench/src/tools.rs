//! Programs that are run, folders that are used, and the machine it all happens on.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::failure::{Failure, Result, While};

/// Number of compilers or valgrinds that run at a time.
const AT_A_TIME: usize = 2;

/// The root of the workspace.
pub(crate) fn workspace() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// The folder that holds the release binaries, this one among them.
pub(crate) fn binaries() -> Result<PathBuf> {
    let exe = std::env::current_exe()?;
    exe.parent().map(Path::to_owned).ok_or_else(|| Failure::new("the binary lies in no folder"))
}

/// A new, empty folder for the files of one measurement.
pub(crate) fn scratch(name: &str) -> Result<PathBuf> {
    let folder = results()?.join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// The folder that keeps what was measured.
pub(crate) fn results() -> Result<PathBuf> {
    let binaries = binaries()?;
    let folder = binaries.parent().unwrap_or(&binaries).join("ptc-bench");
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Runs `command` to its end and gives its standard output.
pub(crate) fn run(command: &mut Command) -> Result<String> {
    run_with(command, "")
}

/// The same with `input` on its standard input.
pub(crate) fn run_with(command: &mut Command, input: &str) -> Result<String> {
    let program = command.get_program().to_string_lossy().into_owned();
    let child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = match child {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return Err(Failure::missing(&program));
        }
        child => child.while_doing(&program)?,
    };
    let mut stdin = child.stdin.take();
    let output = std::thread::scope(|scope| {
        scope.spawn(|| {
            use std::io::Write;
            // A program that reads less than it is given is detected by its output.
            let _ = stdin.as_mut().map(|pipe| pipe.write_all(input.as_bytes()));
            drop(stdin.take());
        });
        child.wait_with_output()
    })?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let told = String::from_utf8_lossy(&output.stderr);
    let tail = told.lines().rev().take(12).collect::<Vec<_>>();
    let tail = tail.into_iter().rev().collect::<Vec<_>>().join("\n");
    Err(Failure::new(format!("{command:?}: {}\n{tail}", output.status)))
}

/// `job` for each item, a few at a time; the results in the order of the items.
pub(crate) fn parallel<I: Sync, O: Send>(
    items: &[I],
    job: impl Fn(&I) -> Result<O> + Sync,
) -> Result<Vec<O>> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, Result<O>)>> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..AT_A_TIME {
            scope.spawn(|| {
                while let Some((index, item)) = {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    items.get(index).map(|item| (index, item))
                } {
                    let result = job(item);
                    if let Ok(mut done) = done.lock() {
                        done.push((index, result));
                    }
                }
            });
        }
    });
    let mut done = done.into_inner().map_err(|_| Failure::new("a job panicked"))?;
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// One line about each thing that the numbers depend on.
pub(crate) fn machine() -> Vec<String> {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |key: &str| {
        let line = info.lines().find(|line| line.starts_with(key))?;
        line.split_once(':').map(|(_, value)| value.trim().to_owned())
    };
    let cpu = field("model name").unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let cores = info.lines().filter(|line| line.starts_with("processor")).count();
    let first = |program: &str, argument: &str| {
        let text = run(Command::new(program).arg(argument)).unwrap_or_default();
        text.lines().next().unwrap_or("not installed").to_owned()
    };
    let mut lines = vec![format!("{cpu}, {cores} cores")];
    for (program, argument) in [
        ("gcc", "--version"),
        ("rustc", "--version"),
        ("valgrind", "--version"),
        ("getconf", "GNU_LIBC_VERSION"),
    ] {
        lines.push(first(program, argument));
    }
    lines
}
