//! Environment of every attack: the command, a campaign, and its undisturbed results.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, ensure};

use crate::context::Context;
use crate::harness::empty;
use crate::layers::command::generator;

/// A campaign of four chunks and a search, all of it quick.
pub(super) const DESIGN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\neps = 1e-3\n[params]\n\
                                 tau = 1\n[plant]\nf = \"-d*x1\"\nd = [0, 0.5]\n[verify]\n\
                                 x1 = [-1, 1]\nscenarios = 200\nsearch = 4\n[[objective]]\n\
                                 bound = \"attractive\"\nerror = 1e-2\n";

/// The file of the design.
pub(super) const FILE: &str = "stage.toml";

/// The file of the rows.
pub(super) const ROWS: &str = "rows.parquet";

/// The file of the rows under way.
pub(super) const JOURNAL: &str = "rows.parquet.chunks";

/// The campaign with its rows.
pub(super) const VERIFY: [&str; 4] = ["verify", FILE, "--out", ROWS];

/// Time that a process may take to get anywhere.
const PATIENCE: Duration = Duration::from_secs(120);

/// The command, where it works, and what it gives there.
pub(super) struct World {
    pub(super) command: PathBuf,
    scratch: PathBuf,
    pub(super) seed: u64,
    pub(super) brief: bool,
    /// The end of one run.
    pub(super) code: Option<i32>,
    /// Its output.
    pub(super) verdict: Vec<u8>,
    /// Its rows.
    pub(super) rows: Vec<u8>,
    /// Its duration.
    pub(super) time: Duration,
}

impl World {
    pub(super) fn new(context: &Context) -> Result<Self> {
        let mut world = Self {
            command: generator()?,
            scratch: context.scratch("attack"),
            seed: context.seed,
            brief: context.brief,
            code: None,
            verdict: Vec::new(),
            rows: Vec::new(),
            time: Duration::ZERO,
        };
        let folder = world.folder("undisturbed")?;
        let began = Instant::now();
        let one = world.run(&folder, &VERIFY)?;
        world.time = began.elapsed();
        ensure!(one.status.success(), "{}", String::from_utf8_lossy(&one.stderr));
        (world.code, world.verdict) = (one.status.code(), one.stdout);
        world.rows = fs::read(folder.join(ROWS))?;
        Ok(world)
    }

    /// An empty folder with the design.
    pub(super) fn folder(&self, name: &str) -> Result<PathBuf> {
        let folder = empty(&self.scratch.join(name));
        fs::write(folder.join(FILE), DESIGN)?;
        Ok(folder)
    }

    fn start_with(&self, folder: &Path, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.command);
        command.args(arguments).current_dir(folder).stdin(Stdio::null());
        command
    }

    /// Runs the command to its end.
    pub(super) fn run(&self, folder: &Path, arguments: &[&str]) -> Result<Output> {
        self.start_with(folder, arguments).output().context("the command runs")
    }

    /// Starts the command.
    pub(super) fn start(&self, folder: &Path, arguments: &[&str]) -> Result<Child> {
        let mut command = self.start_with(folder, arguments);
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        child.context("the command starts")
    }

    /// Starts a campaign too long to end by itself and waits until it has kept several records of rows.
    pub(super) fn under_way(&self, folder: &Path) -> Result<Child> {
        self.under_way_with(folder, &LONG)
    }

    /// The same of any campaign that is long enough for that.
    pub(super) fn under_way_with(&self, folder: &Path, arguments: &[&str]) -> Result<Child> {
        let mut child = self.start(folder, arguments)?;
        let size = || fs::metadata(folder.join(JOURNAL)).map_or(0, |there| there.len());
        let began = Instant::now();
        while size() < 100_000 {
            ensure!(began.elapsed() < PATIENCE, "no row is kept");
            ensure!(child.try_wait()?.is_none(), "the campaign ended early");
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(child)
    }

    /// Returns the difference of an output from that of one run, if any.
    pub(super) fn differs(&self, folder: &Path, end: &Output) -> Option<String> {
        let told = || String::from_utf8_lossy(&end.stderr).into_owned();
        if end.status.code() != self.code {
            return Some(format!("{}, {}", end.status, told()));
        }
        if end.stdout != self.verdict {
            return Some("another verdict".to_owned());
        }
        match fs::read(folder.join(ROWS)) {
            Ok(rows) if rows == self.rows => None,
            Ok(rows) => Some(format!(
                "{} bytes of rows that are not the {} of one run",
                rows.len(),
                self.rows.len()
            )),
            Err(error) => Some(format!("no rows: {error}")),
        }
    }
}

/// The campaign that does not end by itself.
pub(super) const LONG: [&str; 5] = ["verify", FILE, "--out", ROWS, "--scenarios=1000000"];

/// The names in a folder, in order.
pub(super) fn names(folder: &Path) -> Result<Vec<String>> {
    let entries = fs::read_dir(folder)?;
    let name = |entry: std::io::Result<fs::DirEntry>| {
        Ok(entry?.file_name().to_string_lossy().into_owned())
    };
    let mut names = entries.map(name).collect::<Result<Vec<_>>>()?;
    names.sort();
    Ok(names)
}
