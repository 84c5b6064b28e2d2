//! What the macro costs a crate that uses it: the cold build of its dependency tree, and the time
//! that controllers add to `cargo build`.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::failure::{Result, While};
use crate::tools::{run, scratch, workspace};

/// Rebuilds of which the fastest is taken.
const REBUILDS: usize = 5;

/// Seconds.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct MacroCost {
    /// From an empty target folder, without a controller.
    pub(crate) cold: f64,
    /// After a change of the crate, without a controller.
    pub(crate) none: f64,
    /// With one controller.
    pub(crate) one: f64,
    /// With twenty controllers.
    pub(crate) twenty: f64,
}

/// Builds a temporary crate.
pub(crate) fn measure() -> Result<MacroCost> {
    let folder = scratch("macro")?;
    std::fs::create_dir_all(folder.join("src"))?;
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nptc = {{ path = {:?} }}\n\n[workspace]\n",
        workspace()
    );
    std::fs::write(folder.join("Cargo.toml"), manifest)?;
    // The versions that the workspace uses, which are here already.
    std::fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))?;
    let cold = build(&folder, 0, 0)?;
    let fastest = |controllers| -> Result<f64> {
        let mut best = f64::INFINITY;
        for round in 1..=REBUILDS {
            best = best.min(build(&folder, controllers, round)?);
        }
        Ok(best)
    };
    Ok(MacroCost { cold, none: fastest(0)?, one: fastest(1)?, twenty: fastest(20)? })
}

/// Seconds of `cargo build` with that many controllers.
fn build(folder: &Path, controllers: usize, round: usize) -> Result<f64> {
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
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(folder).env("CARGO_TARGET_DIR", folder.join("target"));
    let start = Instant::now();
    run(command.args(["build", "--offline"]))?;
    Ok(start.elapsed().as_secs_f64())
}
