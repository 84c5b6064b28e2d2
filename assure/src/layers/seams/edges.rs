//! Bounds that are met exactly are neither promises nor failures; just above the truth they hold, just below they fail.

use std::fs;
use std::process::Command;

use anyhow::{Result, ensure};
use serde_json::Value;

use super::one::World;
use crate::harness::empty;
use crate::harness::random::Random;

/// Relative distance of a bound from the truth, on either side.
const ROOM: f64 = 1e-4;

/// A design of known truth.
struct Edge {
    /// The design up to its objectives.
    design: String,
    /// Each objective with the place of its bound, `#`, and the bound as an exact expression.
    objectives: Vec<(&'static str, String)>,
    /// The command that judges it.
    command: &'static str,
}

/// A number with three digits behind the point, so that its text is its value.
fn short(random: &mut Random, low: f64, high: f64) -> f64 {
    (random.between(low, high) * 1000.0).round() / 1000.0
}

/// x1 = x0 ((p + 1) s^p - p s^(p + 1)) with s = T/tau: u is largest at t0, and x2 is least at s = (p - 1)/p.
fn in_time(random: &mut Random) -> Edge {
    let (x1, tau, p) = (short(random, 0.2, 2.0), short(random, 0.3, 4.0), 3 + random.below(5));
    let q = p + 1;
    Edge {
        design: format!(
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-{p}, -{q}]\ntau = {tau}\n[plant]\nf = 0\n[verify]\n\
             x1 = [0, {x1}]\nx2 = 0\nscenarios = 20\nsearch = 20\n"
        ),
        objectives: vec![
            (
                "[[objective]]\nbound = \"input\"\nupsilon = \"#\"\n",
                format!("{p}*{q}*{x1}/{tau}^2"),
            ),
            (
                "[[objective]]\nbound = \"within\"\nh = \"x2\"\nlow = \"-#\"\n",
                format!("{q}*(({p} - 1)/{p})^({p} - 1)*{x1}/{tau}"),
            ),
        ],
        command: "verify",
    }
}

/// A chain of order 1 in samples under u = -p x/((M + p - 1) h), M samples to go, held from 5 on: |u| is largest at the
/// start.
fn in_samples(random: &mut Random) -> Edge {
    let (x1, p, count) = (short(random, 0.2, 2.0), 1 + random.below(3), 20 + random.below(40));
    let tau = count as f64 * 0.01;
    Edge {
        design: format!(
            "n = 1\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-{p}]\nsample_time = 0.01\neps = 0.05\n\
             [params]\ntau = {tau:.2}\nu_max = inf\n[verify]\nx1 = [0, {x1}]\nscenarios = 20\nsearch = 20\n"
        ),
        objectives: vec![(
            "[[objective]]\nbound = \"input\"\nupsilon = \"#\"\n",
            format!("{p}*{x1}/({tau:.2} + ({p} - 1)*0.01)"),
        )],
        command: "verify",
    }
}

/// The same with p = 1 and gains held from m samples to go: x at the deadline is x0 m/N (1 - 1/m)^m.
fn held(random: &mut Random) -> Edge {
    let (x1, m, count) = (short(random, 0.2, 2.0), 3 + random.below(9), 20 + random.below(40));
    let tau = count as f64 * 0.01;
    let eps = m as f64 * 0.01;
    Edge {
        design: format!(
            "n = 1\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-1]\nsample_time = 0.01\nx0_max = [{x1}]\n\
             error = [\"#\"]\n[params]\neps = {eps:.2}\ntau = {tau:.2}\nu_max = inf\n"
        ),
        objectives: vec![("", format!("{x1}*{m}/{count}*(1 - 1/{m})^{m}"))],
        command: "check",
    }
}

/// The design with every bound at a part of the truth.
fn text(edge: &Edge, part: f64) -> String {
    let mut text = edge.design.clone();
    for (objective, truth) in &edge.objectives {
        let bound = if part == 1.0 { truth.clone() } else { format!("{part}*{truth}") };
        text = if objective.is_empty() {
            text.replace('#', &bound)
        } else {
            text + &objective.replace('#', &bound)
        };
    }
    text
}

/// Verdict on a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Said {
    Holds,
    Fails,
    Neither,
}

fn said(world: &World<'_>, edge: &Edge, text: &str) -> Result<Vec<Said>> {
    let folder = empty(&world.folder.join("edge"));
    fs::write(folder.join("d.toml"), text)?;
    let json: &[&str] = if edge.command == "check" { &["--format", "json"] } else { &[] };
    let mut command = Command::new(world.command);
    let output =
        command.arg(edge.command).arg("d.toml").args(json).current_dir(&folder).output()?;
    let out = String::from_utf8_lossy(&output.stdout);
    let told = String::from_utf8_lossy(&output.stderr);
    ensure!(matches!(output.status.code(), Some(0 | 1 | 3)), "{out}{told}{text}");
    if edge.command == "check" {
        let report: Value = serde_json::from_str(&out)?;
        let checks = report["checks"].as_array().into_iter().flatten();
        let looped = checks.filter(|check| check["name"] == "loop").map(|check| {
            match check["verdict"].as_str() {
                Some("sound") => Said::Holds,
                Some("unsound" | "refuted") => Said::Fails,
                _ => Said::Neither,
            }
        });
        return Ok(looped.collect());
    }
    let verdict = |line: &str| {
        let (_, verdict) = line.strip_prefix("objective ")?.split_once(": ")?;
        Some(match verdict {
            _ if verdict.starts_with("holds") => Said::Holds,
            _ if verdict.starts_with("fails") => Said::Fails,
            _ => Said::Neither,
        })
    };
    Ok(out.lines().filter_map(verdict).collect())
}

/// Draws designs of known truth, multiplied by `scale`: their number, and what their verdicts are wrong about.
pub(super) fn faults(
    world: &World<'_>,
    seed: u64,
    count: usize,
    scale: f64,
) -> Result<(usize, Vec<String>)> {
    let mut random = Random(seed);
    let mut found = Vec::new();
    let mut judged = 0;
    for index in 0..count {
        let edge = [in_time, in_samples, held][index % 3](&mut random);
        for (part, due) in
            [(1.0, Said::Neither), (1.0 + ROOM, Said::Holds), (1.0 - ROOM, Said::Fails)]
        {
            let text = text(&edge, part * scale);
            let all = said(world, &edge, &text)?;
            ensure!(all.len() == edge.objectives.len(), "{all:?} of\n{text}");
            judged += all.len();
            let wrong = |said: &&Said| **said != due;
            found.extend(all.iter().find(wrong).map(|said| {
                format!("edge: {said:?}, not {due:?}, at {part} of the truth\n{text}")
            }));
        }
    }
    Ok((judged, found))
}
