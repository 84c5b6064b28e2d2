//! Cost of builds, in processor seconds: the command, a crate that uses the macro, and the controllers that are
//! added to it.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::{Deserialize, Serialize};

use crate::failure::{Failure, Result, While};
use crate::tools::{run, scratch, workspace};

/// Number of rebuilds, of which the cheapest counts.
const REBUILDS: usize = 5;

/// Processor seconds.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Builds {
    /// The command from nothing, as the README's first line builds it.
    pub(crate) command: f64,
    /// The same with the feature `lab`.
    pub(crate) lab: f64,
    /// The tests from nothing, built and run, as the README's second line does.
    pub(crate) tests: f64,
    /// A crate with one controller, which takes `ptc` of the last commit from git, from nothing.
    pub(crate) user: f64,
    /// The same by the path of a checkout, which cargo prepares for changes.
    pub(crate) by_path: f64,
    /// The same crate rebuilt after a change, without a controller.
    pub(crate) none: f64,
    /// With one controller.
    pub(crate) one: f64,
    /// With twenty controllers.
    pub(crate) twenty: f64,
}

/// Builds all of them in folders of their own.
pub(crate) fn measure() -> Result<Builds> {
    let command = from_nothing(&["--package", "ptc-codegen"])?;
    let lab = from_nothing(&["--package", "ptc-codegen", "--release", "--features", "lab"])?;
    let tests = processor_seconds(workspace(), &scratch("tests")?, &["test", "--workspace"])?;
    let folder = crate_with("by_path", &format!("path = {:?}", workspace()))?;
    let by_path = of_controllers(&folder, 1, 0)?;
    let address = format!("file://{}", workspace().display());
    let folder = crate_with("user", &format!("git = {address:?}"))?;
    let user = of_controllers(&folder, 1, 0)?;
    let least = |controllers| -> Result<f64> {
        let mut least = f64::INFINITY;
        for round in 1..=REBUILDS {
            least = least.min(of_controllers(&folder, controllers, round)?);
        }
        Ok(least)
    };
    Ok(Builds {
        command,
        lab,
        tests,
        user,
        by_path,
        none: least(0)?,
        one: least(1)?,
        twenty: least(20)?,
    })
}

/// The folder of an empty crate that takes `ptc` from a source, with all that it needs fetched.
fn crate_with(name: &str, source: &str) -> Result<PathBuf> {
    let folder = scratch(name)?;
    std::fs::create_dir_all(folder.join("src"))?;
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nptc = {{ {source} }}\n\n[workspace]\n"
    );
    std::fs::write(folder.join("Cargo.toml"), manifest)?;
    std::fs::write(folder.join("src/lib.rs"), "")?;
    // The versions that the workspace uses, which are here already.
    std::fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
    run(Command::new(cargo()).args(["fetch", "--quiet"]).current_dir(&folder))?;
    Ok(folder)
}

/// `cargo build` of the workspace, with nothing built before.
fn from_nothing(words: &[&str]) -> Result<f64> {
    let target = scratch("build")?;
    processor_seconds(workspace(), &target, &[&["build"], words].concat())
}

/// `cargo build` with that many controllers.
fn of_controllers(folder: &Path, controllers: usize, round: usize) -> Result<f64> {
    let families = ["exp", "rational", "tan", "tanh", "algebraic"];
    let mut source = format!("pub const ROUND: usize = {round};\n");
    for index in 0..controllers {
        let (family, n) = (families[index % families.len()], 2 + index / families.len());
        let gains: Vec<_> = (1..=n).map(|gain| gain.to_string()).collect();
        let _ = writeln!(
            source,
            "ptc::ptc_controller!(n = {n}, mu = {family}(a = 1.5), name = loop{index}, tau = 2, gains = [{}], allow = growth);",
            gains.join(", ")
        );
    }
    std::fs::write(folder.join("src/lib.rs"), source).while_doing("src/lib.rs")?;
    processor_seconds(folder, &folder.join("target"), &["build", "--offline"])
}

/// The cargo that runs this program.
fn cargo() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// User and system time of cargo with all that it starts.
fn processor_seconds(folder: &Path, target: &Path, words: &[&str]) -> Result<f64> {
    // `times` prints a line of the shell itself, and one of what it has waited for.
    let script = "\"$0\" \"$@\" --quiet || exit 1; times";
    let mut command = Command::new("sh");
    command.args(["-c", script]).arg(cargo()).args(words).current_dir(folder);
    let told = run(command.env("CARGO_TARGET_DIR", target))?;
    let seconds = |text: &str| {
        let (minutes, seconds) = text.strip_suffix('s')?.split_once('m')?;
        Some(60.0 * minutes.parse::<f64>().ok()? + seconds.parse::<f64>().ok()?)
    };
    let line = told.lines().last().unwrap_or_default();
    let sum: Option<f64> = line.split_whitespace().map(seconds).sum();
    sum.ok_or_else(|| Failure::new(format!("`times` of sh printed `{line}`")))
}
