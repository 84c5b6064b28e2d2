//! Answers of every command about one design, and a check that they are about the emitted controller.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail};
use serde_json::Value;

use super::compiled;
use super::design::Design;
use crate::harness::empty;

/// The languages and units of which each design has one.
const LANGUAGES: [&str; 7] = ["rust", "cpp", "python", "matlab", "fmu2", "fmu3", "st"];

/// Digits of a fingerprint.
const DIGITS: usize = 12;

/// A sample of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    pub(super) t: f64,
    pub(super) x: Vec<f64>,
    /// Argument of the controller: measurements, where they are not the states.
    pub(super) given: Vec<f64>,
    pub(super) u: Vec<f64>,
    pub(super) status: String,
}

/// The answers of all commands about one design.
#[derive(Clone, Debug)]
pub(super) struct Answers {
    /// `check --format json`.
    pub(super) report: Value,
    /// The exit code of `check`.
    pub(super) exit: i32,
    /// `error`, where the design gives it for each state.
    pub(super) error: Vec<f64>,
    pub(super) u_max: f64,
    /// True if the run starts within `x0_max`.
    pub(super) is_within: bool,
    /// The run of `simulate`.
    pub(super) run: Vec<Row>,
    /// The fingerprint that each command shows, by its name.
    pub(super) fingerprints: Vec<(String, Option<String>)>,
    /// The verdict of `verify` on each objective.
    pub(super) verdicts: Vec<String>,
    /// Differences between files that have to be the same.
    pub(super) differences: Vec<String>,
}

/// Environment of the commands, and the defects put into their answers on purpose.
pub(super) struct World<'a> {
    pub(super) command: &'a Path,
    pub(super) folder: PathBuf,
}

/// A defect of the seam between two commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Defect {
    /// `verify` chooses another value than the checks.
    OtherValue,
    /// A constant of the emitted C differs from that of the verdict.
    OtherConstant,
}

/// Output of a command, with its standard error behind its standard output.
struct Printed {
    exit: i32,
    out: String,
    all: String,
}

impl World<'_> {
    fn run(&self, folder: &Path, arguments: &[&str]) -> Result<Printed> {
        let output = Command::new(self.command).args(arguments).current_dir(folder).output()?;
        let exit = output.status.code().context("the command was killed")?;
        let out = String::from_utf8_lossy(&output.stdout).into_owned();
        let all = format!("{out}{}", String::from_utf8_lossy(&output.stderr));
        if ![0, 1, 3].contains(&exit) {
            bail!("{arguments:?}: exit code {exit}\n{all}");
        }
        Ok(Printed { exit, out, all })
    }

    /// Asks every command about a design.
    pub(super) fn answers(
        &self,
        index: usize,
        design: &Design,
        defect: Option<Defect>,
    ) -> Result<Answers> {
        let folder = empty(&self.folder.join(&design.name));
        let text = format!("{}{}", design.text(), campaign(design, None));
        fs::write(folder.join("d.toml"), &text)?;
        let checked = self.run(&folder, &["check", "d.toml", "--format", "json"])?;
        let report: Value =
            serde_json::from_str(&checked.out).with_context(|| checked.all.clone())?;
        let mut answers = Answers {
            exit: checked.exit,
            error: own_numbers(design, "error"),
            u_max: own_numbers(design, "u_max").first().copied().unwrap_or(f64::INFINITY),
            is_within: design.gives("x0_max") && design.has_own_states(),
            run: Vec::new(),
            fingerprints: vec![(
                "check".to_owned(),
                report["fingerprint"].as_str().map(str::to_owned),
            )],
            verdicts: Vec::new(),
            differences: Vec::new(),
            report,
        };
        if checked.exit == 1 {
            self.refused(&folder, &mut answers)?;
        } else {
            self.accepted(&folder, (index, design), defect, &mut answers)?;
        }
        let _ = fs::remove_dir_all(folder);
        Ok(answers)
    }

    /// A design that `check` refuses is refused by `emit`.
    fn refused(&self, folder: &Path, answers: &mut Answers) -> Result<()> {
        let emitted = self.run(folder, &["emit", "d.toml", "--lang", "c", "-o", "c"])?;
        if emitted.exit != 1 {
            answers.differences.push(format!("check refuses, and emit ends in {}", emitted.exit));
        }
        Ok(())
    }

    fn accepted(
        &self,
        folder: &Path,
        (index, design): (usize, &Design),
        defect: Option<Defect>,
        answers: &mut Answers,
    ) -> Result<()> {
        let emit = |design: &str, out: &str, more: &[&str]| {
            self.run(folder, &[&["emit", design, "--lang", "c", "-o", out], more].concat())
        };
        emit("d.toml", "c", &["--resolved", "r.toml"])?;
        emit("r.toml", "again", &[])?;
        for file in ["h", "c"].map(|end| format!("{}.{end}", design.name)) {
            let [one, other] = ["c", "again"].map(|at| fs::read(folder.join(at).join(&file)));
            if one? != other? {
                answers.differences.push(format!("{file} of the resolved design differs"));
            }
        }
        let mut named = |name: &str, text: &str| {
            answers.fingerprints.push((name.to_owned(), fingerprint(text)));
        };
        named("the emitted C", &fs::read_to_string(folder.join(format!("c/{}.h", design.name)))?);
        named("the resolved design", &self.run(folder, &["check", "r.toml"])?.all);
        let language = LANGUAGES[index % LANGUAGES.len()];
        if let Some(text) = self.emitted(folder, language)? {
            named(language, &text);
        }
        // Without an eps it is a run-time parameter, and there is no single run to compare.
        let command = answers.report["command"].as_str().unwrap_or_default();
        if !command.contains("--eps=") {
            return Ok(());
        }
        let x0 = design.x0.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let x0 = format!("--x0={x0}");
        let ran = self.run(folder, &["simulate", "d.toml", &x0, "-o", "r.csv"])?;
        named("simulate", &ran.all);
        let judged = match defect {
            Some(Defect::OtherValue) => format!("eps = 0.04\n{}", design.without("eps").text()),
            _ => design.text(),
        };
        let bounds = worst(&answers.report).filter(|_| answers.is_within).map(of_worst);
        fs::write(folder.join("v.toml"), judged + &campaign(design, bounds.as_ref()))?;
        let verified = self.run(folder, &["verify", "v.toml"])?;
        named("verify", &verified.all);
        answers.verdicts = verified.out.lines().filter_map(verdict).collect();
        let csv = fs::read_to_string(folder.join("r.csv"))?;
        answers.run = rows(&csv, design)?;
        if defect == Some(Defect::OtherConstant) {
            let file = folder.join(format!("c/{}.c", design.name));
            let text = fs::read_to_string(&file)?;
            fs::write(&file, compiled::with_other_constant(&text))?;
        }
        // An actuator with steps applies another input than the computed one.
        if !design.gives("u_step") {
            answers.differences.extend(compiled::differences(folder, design, &answers.run)?);
        }
        Ok(())
    }

    /// Returns the output of `emit` in a language; `None` where the language refuses the design.
    fn emitted(&self, folder: &Path, language: &str) -> Result<Option<String>> {
        let out = Command::new(self.command)
            .args(["emit", "d.toml", "--lang", language, "-o", language])
            .current_dir(folder)
            .output()?;
        if !out.status.success() {
            return Ok(None);
        }
        let mut text = String::new();
        for file in fs::read_dir(folder.join(language))? {
            text += &String::from_utf8_lossy(&fs::read(file?.path())?);
        }
        Ok(Some(text))
    }
}

/// The worst case that `check` found of the loop.
pub(super) fn worst(report: &Value) -> Option<&Value> {
    let checks = report["checks"].as_array().into_iter().flatten();
    checks.map(|check| &check["worst"]).find(|worst| worst.is_object())
}

/// The bound of each state at the deadline, of all causes together.
pub(super) fn totals(worst: &Value) -> Vec<f64> {
    worst["total"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

/// Relative distance of an objective from the worst case.
const BESIDE: f64 = 0.02;

/// The least bound that is a number, not rounding alone.
const LEAST: f64 = 1e-9;

/// Errors just above the worst case of each state, and just below what of it is attained.
fn of_worst(worst: &Value) -> [Vec<f64>; 2] {
    let numbers = |key: &str| worst[key].as_array().into_iter().flatten().filter_map(Value::as_f64);
    let above = totals(worst).into_iter().map(|bound| (1.0 + BESIDE) * bound.max(LEAST));
    let attained =
        numbers("from_x0").zip(numbers("from_noise")).map(|(start, noise)| start + noise);
    [above.collect(), attained.map(|bound| (1.0 - BESIDE) * bound).collect()]
}

/// A campaign of few runs. Without bounds its box is not `x0_max`, which has to choose nothing; with them it is, and
/// its objectives are just above and just below the worst case.
fn campaign(design: &Design, bounds: Option<&[Vec<f64>; 2]>) -> String {
    let mut text = "[verify]\n".to_owned();
    let [low, high] = if bounds.is_some() { [1.0, 1.0] } else { [0.5, 0.25] };
    for (state, most) in design.states.iter().zip(&design.x0_max) {
        text += &format!("{state} = [-{}, {}]\n", low * most, high * most);
    }
    text += "scenarios = 2\nsearch = 0\n";
    let attractive =
        |error: &str| format!("[[objective]]\nbound = \"attractive\"\nerror = {error}\n");
    let Some([above, below]) = bounds else { return text + &attractive("100") };
    text += &attractive(&format!("{above:?}"));
    if below.iter().all(|bound| *bound > LEAST) {
        text += &attractive(&format!("{below:?}"));
    }
    text
}

/// The verdict in a line of `verify` about an objective.
fn verdict(line: &str) -> Option<String> {
    line.strip_prefix("objective ")?.split_once(": ").map(|(_, verdict)| verdict.to_owned())
}

/// The numbers of a key.
fn own_numbers(design: &Design, key: &str) -> Vec<f64> {
    let text = design.text_of(key).unwrap_or_default();
    text.trim_matches(['[', ']'])
        .split(',')
        .filter_map(|number| number.trim().parse().ok())
        .collect()
}

/// The first fingerprint behind the word `design`.
fn fingerprint(text: &str) -> Option<String> {
    text.match_indices("design").find_map(|(at, word)| {
        let behind = text[at + word.len()..].trim_start_matches([' ', ':']);
        let digits = behind.get(..DIGITS)?;
        let is_hash = digits.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b));
        is_hash.then(|| digits.to_owned())
    })
}

/// The samples of a table of `simulate`.
fn rows(csv: &str, design: &Design) -> Result<Vec<Row>> {
    let mut lines = csv.lines();
    let head: Vec<_> = lines.next().context("a head")?.split(',').collect();
    let begin = head.iter().position(|name| *name == "t").context("a column t")? + 1;
    let states = design.states.len();
    let first = begin + states + design.hidden;
    let inputs = head[first..].iter().take_while(|name| name.starts_with('u')).count();
    let given = first + inputs;
    let mut all = Vec::new();
    for line in lines {
        let cells: Vec<_> = line.split(',').collect();
        let number = |cell: &&str| cell.parse::<f64>().unwrap_or(f64::NAN);
        let between =
            |low: usize, high: usize| cells[low..high].iter().map(number).collect::<Vec<_>>();
        let measured = head[given..].iter().take_while(|name| name.starts_with('y')).count();
        let x = between(begin, begin + states);
        all.push(Row {
            t: number(&cells[begin - 1]),
            given: if measured > 0 { between(given, given + measured) } else { x.clone() },
            x,
            u: between(first, given),
            status: cells.last().copied().unwrap_or_default().to_owned(),
        });
    }
    Ok(all)
}

/// Lists the commands whose answers are about different controllers.
pub(super) fn faults(answers: &Answers) -> Vec<String> {
    let own = &answers.fingerprints[0].1;
    let other = answers.fingerprints.iter().filter(|(_, found)| found.is_none() || found != own);
    let told = |(name, found): &(String, Option<String>)| {
        let found = found.as_deref().unwrap_or("none");
        format!(
            "one design: {name} shows the fingerprint {found}, check {}",
            own.as_deref().unwrap_or("none")
        )
    };
    let differences =
        answers.differences.iter().map(|difference| format!("one design: {difference}"));
    other.map(told).chain(differences).collect()
}
