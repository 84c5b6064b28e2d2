//! The notebooks of the examples, and what the Python module shows in one.

use std::fs;
use std::process::Command;

use anyhow::Result;

use super::command::generator;
use super::module;
use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::runtime;
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, PYTHON, RUSTC};

const SCRIPT: &str = include_str!("notebooks.py");

/// Packages of the extra `notebook` of the wheel, and those that run a notebook without a browser.
const PACKAGES: [&str; 7] =
    ["anywidget", "ipykernel", "matplotlib", "nbclient", "numpy>=1.26", "pandas", "tqdm"];

pub(super) const LAYER: Layer = Layer {
    name: "notebooks",
    claim: "The notebooks of the examples run and hold no outputs; pictures from Python are the files of the \
            command, tables have the units of the design, the widget answers, and a package that is missing is named.",
    tools: &[GCC, RUSTC, PYTHON],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("notebooks");
    let generator = generator()?;
    let wheel = module::wheel(context, &folder)?;
    let python = runtime::python(&context.shared("notebooks"), &PACKAGES)?;
    let install = ["-m", "pip", "install", "-q", "--no-deps", "--force-reinstall"];
    succeed(Command::new(&python).args(install).arg(&wheel))?;
    let script = folder.join("notebooks.py");
    fs::write(&script, SCRIPT)?;
    let shown = |more: &[&str]| {
        let mut command = Command::new(&python);
        command.arg(&script).arg(&generator).arg(workspace()).args(more);
        command
    };
    let mut finding = Finding::default();
    match text(&mut shown(&[])) {
        Ok(told) => finding.summary = told.trim().to_owned(),
        Err(wrong) => finding.failures.push(format!("{wrong:#}")),
    }
    for (flag, defect) in [
        ("--defect", "a picture of another run"),
        ("--broken", "a notebook with a cell that raises"),
    ] {
        let output = shown(&[flag]).output()?;
        let told = String::from_utf8_lossy(&output.stderr).lines().next().map(str::to_owned);
        finding.seed(defect, told.filter(|_| !output.status.success()));
    }
    Ok(finding)
}
