//! A program in C, compiled in a folder that is removed with it.

use std::env;
use std::fs::{self, File as OpenFile};
use std::io;
use std::path::PathBuf;
use std::process::{Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::cli::compiler::compiler;
use crate::cli::output::TemporaryFolder;
use crate::emit::File;
use crate::emit::campaign::{FLAGS, MAIN, flags};

/// Time that a compiler may take.
const LIMIT: Duration = Duration::from_secs(120);

/// Time between two looks at it.
const PAUSE: Duration = Duration::from_millis(5);

/// Lines of its messages that are shown, and characters of each.
const LINES: usize = 5;
const CHARACTERS: usize = 200;

/// A program and its folder.
pub(super) struct Program {
    folder: TemporaryFolder,
    compiler: String,
}

/// Why there is no program, with what the compiler said.
pub(super) struct Wrong {
    pub(super) told: String,
    pub(super) notes: Vec<String>,
}

impl Program {
    /// Compiles the files.
    ///
    /// # Errors
    /// There is no compiler, or it fails.
    pub(super) fn compile(files: &[File]) -> Result<Self, Wrong> {
        let name = compiler();
        let compiler = name.to_string_lossy().into_owned();
        let failed = |what: &str, error: &io::Error| Wrong {
            told: format!("{what} `{compiler}`: {error}"),
            notes: Vec::new(),
        };
        let folder = TemporaryFolder::new(&env::temp_dir())
            .map_err(|error| failed("there is no folder to run", &error))?;
        for file in files {
            let written = folder.write(&file.name, file.text.as_bytes());
            written.map_err(|error| failed("there is no folder to run", &error))?;
        }
        let told = folder.path().join("told");
        let messages =
            OpenFile::create(&told).map_err(|error| failed("there is no folder to run", &error))?;
        let mut command = Command::new(&name);
        command.current_dir(folder.path()).args(flags()).args(["-o", NAME, MAIN, "-lm"]);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(messages);
        let status =
            ended(&mut command).map_err(|error| failed("no C compiler: cannot run", &error))?;
        if !status.success() {
            let said = fs::read(&told).unwrap_or_default();
            let said = String::from_utf8_lossy(&said);
            let lines = said.lines().take(LINES);
            return Err(Wrong {
                told: format!("`{compiler}` fails: {status}"),
                notes: lines.map(|line| line.chars().take(CHARACTERS).collect()).collect(),
            });
        }
        Ok(Self { folder, compiler })
    }

    /// Returns the path of the program.
    pub(super) fn path(&self) -> PathBuf {
        self.folder.path().join(NAME)
    }

    /// How it was made.
    pub(super) fn way(&self) -> String {
        format!("{} {}", self.compiler, FLAGS.join(" "))
    }
}

/// Its name.
const NAME: &str = if cfg!(windows) { "campaign.exe" } else { "campaign" };

/// Runs a command to its end, or ends it where it takes too long.
fn ended(command: &mut Command) -> io::Result<ExitStatus> {
    let mut child = command.spawn()?;
    let began = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        if began.elapsed() >= LIMIT {
            child.kill()?;
            child.wait()?;
            let told = format!("it took longer than {} s", LIMIT.as_secs());
            return Err(io::Error::new(io::ErrorKind::TimedOut, told));
        }
        sleep(PAUSE);
    }
}
