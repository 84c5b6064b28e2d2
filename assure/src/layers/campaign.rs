//! A verification campaign in shards, driven by Dask.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Result, ensure};

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::runtime;
use crate::layer::{Finding, Layer};
use crate::tool::PYTHON;

pub(super) const LAYER: Layer = Layer {
    name: "campaign",
    claim: "A campaign of `verify` in shards on a Dask cluster of two workers gives the verdict and \
            the bytes of one run.",
    tools: &[PYTHON],
    run,
};

/// Its objective holds; a smaller sigma makes it one that fails.
const DESIGN: &str = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[plant]\nf = \"gust\"\n\
                      gust = [-0.1, 0.1]\n[disturbance]\ngust = \"any\"\n[verify]\n\
                      x1 = [0.1, 1]\nx2 = [-1, 1]\ntau = 1\nscenarios = 600\nsearch = 100\n\
                      [[objective]]\nbound = \"state\"\nsigma = 40\n";

const SHARDS: &str = "6";

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("dask"), &["dask[distributed]"])?;
    let command = generator()?;
    let folder = context.scratch("campaign");
    fs::write(folder.join("loop.toml"), DESIGN)?;
    let asked = ["verify", "loop.toml", "--out", "one.parquet"];
    let one = text(Command::new(&command).args(asked).current_dir(&folder))?;
    let driven = |design: &str, out: &str| -> Result<(bool, String)> {
        let script = workspace().join("examples/dask_campaign.py");
        let output = Command::new(&python)
            .arg(script)
            .args([design, "--shards", SHARDS, "--out", out, "--command"])
            .arg(&command)
            .current_dir(&folder)
            .output()?;
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        let failed = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.code().is_some_and(|code| code < 2), "{told}{failed}");
        Ok((output.status.success(), told))
    };
    let (holds, told) = driven("loop.toml", "many.parquet")?;
    let mut finding = Finding::default();
    let (on, verdict) = told.split_once('\n').unwrap_or_default();
    if !holds || verdict != one {
        finding.failures.push(format!("one run says\n{one}\nand the campaign\n{told}"));
    }
    if on != format!("{SHARDS} shards on 2 workers") {
        finding.failures.push(format!("not on two workers: {on}"));
    }
    if !same(&folder, "one.parquet", "many.parquet")? {
        finding.failures.push("the merged shards are not the bytes of one run".to_owned());
    }
    fs::write(folder.join("wrong.toml"), DESIGN.replace("sigma = 40", "sigma = 2"))?;
    let (holds, told) = driven("wrong.toml", "wrong.parquet")?;
    let caught = told.lines().find(|line| line.contains("fails")).map(str::to_owned);
    finding.seed("an objective that the loop does not keep", caught.filter(|_| !holds));
    let mut other = Command::new(&command);
    let other = other.args(["verify", "loop.toml", "--seed", "1", "--out", "other.parquet"]);
    succeed(other.current_dir(&folder))?;
    let differs = !same(&folder, "one.parquet", "other.parquet")?;
    finding.seed("another seed", differs.then(|| "the bytes differ".to_owned()));
    finding.summary = format!("600 scenarios as {on}: the verdict and the bytes of one run");
    Ok(finding)
}

fn same(folder: &Path, one: &str, other: &str) -> Result<bool> {
    Ok(fs::read(folder.join(one))? == fs::read(folder.join(other))?)
}
