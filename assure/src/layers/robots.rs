//! Robots: what is emitted for them against Pinocchio, and their loops in MuJoCo.

use std::path::Path;
use std::process::Command;

use anyhow::Result;

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::runtime;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{GCC, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "robots",
    claim: "Torques, mass matrices and Jacobians of published robots are Pinocchio's, with rotors and friction, and \
            so are the torques of their controllers. In MuJoCo emitted C brings arms to rest at the deadline, behind \
            encoders and a sample of delay, with masses, payloads, rotors and friction that it knows or not.",
    tools: &[GCC, PYTHON],
    run,
};

const PACKAGES: [&str; 4] = ["pin>=4.1", "mujoco>=4", "example-robot-data>=6", "numpy>=1.26"];

/// A script of `tools/`, with the heads of its table.
struct Script<'a> {
    python: &'a Path,
    command: &'a Path,
    name: &'static str,
    title: &'static str,
    head: &'static [&'static str],
}

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("robots"), &PACKAGES)?;
    let command = generator()?;
    let pinocchio = Script {
        python: &python,
        command: &command,
        name: "robots.py",
        title: "Largest relative differences from Pinocchio",
        head: &[
            "robot",
            "joints",
            "inverse dynamics",
            "mass matrix",
            "Jacobian",
            "controller",
            "drives",
        ],
    };
    let mujoco = Script {
        name: "robots_mujoco.py",
        title: "Errors at the deadline in MuJoCo, and largest torques",
        head: &["robot", "it has", "joints, rad", "N m", "state, rad", "N m"],
        ..pinocchio
    };
    let states = if context.brief { "100" } else { "1000" };
    let arms = if context.brief { "panda" } else { "panda,ur5" };
    let mut finding = Finding::default();
    let robots = pinocchio.examine(&["--states", states], &mut finding)?;
    let loops = mujoco.examine(&["--robots", arms], &mut finding)?;
    finding.summary = format!("{robots} robots against Pinocchio, {loops} loops in MuJoCo");
    // The law and the functions take another gravity than the files that they are held against.
    let lighter = "--more=--gravity=0,0,-9.7";
    for (script, words) in
        [(&pinocchio, ["--states", "1", lighter]), (&mujoco, ["--robots", "panda", lighter])]
    {
        let (_, wrong) = script.run(&words)?;
        let wrong = wrong.and_then(|told| told.lines().next().map(str::to_owned));
        finding.seed(&format!("{}: gravity of 9.7 m/s^2", script.title), wrong);
    }
    Ok(finding)
}

impl Script<'_> {
    /// Runs it. Returns its rows, and what it found beyond its bounds.
    fn run(&self, words: &[&str]) -> Result<(Vec<Vec<String>>, Option<String>)> {
        let mut run = Command::new(self.python);
        run.arg(workspace().join("tools").join(self.name)).arg("--command").arg(self.command);
        let output = run.args(words).env("PYTHONDONTWRITEBYTECODE", "1").output()?;
        let printed = String::from_utf8_lossy(&output.stdout);
        let told = String::from_utf8_lossy(&output.stderr).trim().to_owned();
        let rows = printed.lines().filter_map(|line| {
            let cells = line.strip_prefix('|')?.strip_suffix('|')?.split('|');
            Some(cells.map(|cell| cell.trim().to_owned()).collect::<Vec<_>>())
        });
        // Behind each head is a line of dashes.
        let is_data = |row: &Vec<String>| row[0] != "---" && row[0] != self.head[0];
        Ok((rows.filter(is_data).collect(), (!output.status.success()).then_some(told)))
    }

    /// Runs it into the finding. Returns the number of its rows.
    fn examine(&self, words: &[&str], finding: &mut Finding) -> Result<usize> {
        let (rows, wrong) = self.run(words)?;
        let count = rows.len();
        finding.failures.extend(wrong.map(|told| format!("{}: {told}", self.name)));
        if count == 0 {
            finding.failures.push(format!("{} printed no table", self.name));
        }
        let (title, head) = (self.title.to_owned(), self.head.to_vec());
        finding.tables.push(Table { title, head, rows });
        Ok(count)
    }
}
