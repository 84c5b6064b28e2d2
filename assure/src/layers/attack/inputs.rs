//! Inputs drawn by a grammar, each within 4 s and 500 MB: no input hangs, panics or ends without a
//! word.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result};

use super::world::World;
use crate::harness::random::Random;
use crate::layer::Finding;

/// Processor seconds of one command: of a release build, and of a debug build. What reaches the limit of work takes 1 to
/// 2.4 s, the latter beside other programs.
const SECONDS: [u64; 2] = [4, 20];
/// Address space of one command, KB.
const MEMORY: u64 = 500_000;
/// Time for which inputs are drawn.
const TIME: Duration = Duration::from_secs(600);
const BRIEF: Duration = Duration::from_secs(30);
/// The design file under way; that of failure N is kept as `failedN.toml`.
const DRAWN: &str = "drawn.toml";
/// Number of failures that end it.
const ENOUGH: usize = 5;
/// Characters beyond which an expression is not drawn on; a word of a command has 128 KB.
const LONG: usize = 20_000;
/// The command under limits: the first word is the program, the others are its arguments.
const LIMITED: &str = "ulimit -v \"$1\"; ulimit -t \"$2\"; shift 2; exec \"$@\"";

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let World { command, seed, brief, .. } = world;
    let folder = &world.folder("inputs")?;
    let release = command.components().any(|part| part.as_os_str() == "release");
    let seconds = SECONDS[usize::from(!release)];
    let mut random = Random(*seed);
    let (mut drawn, mut accepted, mut failed) = (0, 0, 0);
    let began = Instant::now();
    while began.elapsed() < if *brief { BRIEF } else { TIME } && failed < ENOUGH {
        let words = command_line(&mut random, folder, drawn)?;
        let output = limited(command, &words, folder, seconds)?;
        drawn += 1;
        accepted += usize::from(output.status.success());
        if let Some(fault) = fault(&output) {
            failed += 1;
            finding.failures.push(format!("{fault}\n{words:?}"));
            let file = folder.join(DRAWN);
            if file.is_file() {
                fs::copy(file, folder.join(format!("failed{failed}.toml")))?;
            }
        }
    }
    for (script, defect) in DEFECTS {
        let words = ["-c", script].map(str::to_owned);
        let output = limited(Path::new("/bin/sh"), &words, folder, 1)?;
        finding.seed(defect, fault(&output));
    }
    Ok(format!("{drawn} inputs drawn by grammar, {accepted} of them accepted, {failed} failures"))
}

/// Programs in place of the command, each with a defect that must be seen.
const DEFECTS: [(&str, &str); 5] = [
    ("exit 0", "an end without output"),
    ("echo \"thread 'main' panicked at x\" >&2; exit 101", "a panic"),
    ("while :; do :; done", "a command that does not end"),
    ("x=x; while :; do x=$x$x; done", "a command that takes all memory"),
    ("printf 'error: \\033[31m\\n' >&2; exit 2", "an escape sequence in a message"),
];

fn limited(command: &Path, words: &[String], folder: &Path, seconds: u64) -> Result<Output> {
    limited_to((MEMORY, seconds), command, words, folder)
}

/// The end of a command within so many KB of address space and seconds of the processor.
pub(super) fn limited_to(
    (memory, seconds): (u64, u64),
    command: &Path,
    words: &[String],
    folder: &Path,
) -> Result<Output> {
    let mut shell = Command::new("sh");
    shell.args(["-c", LIMITED, "sh", &memory.to_string(), &seconds.to_string()]);
    shell.arg(command).args(words).current_dir(folder).stdin(Stdio::null());
    shell.output().context("a shell runs")
}

/// Returns the fault in the exit of a command; `None` if it is documented.
fn fault(output: &Output) -> Option<String> {
    let stderr = String::from_utf8_lossy(&output.stderr);
    let hidden = |c: char| c.is_control() && c != '\n';
    match output.status.code() {
        _ if stderr.contains("panicked") => Some(format!("a panic: {stderr}")),
        _ if stderr.contains(hidden) => Some(format!("a control character: {stderr:?}")),
        None => Some(format!("beyond its limits: {}", output.status)),
        Some(0) if output.stdout.is_empty() => Some("no output".to_owned()),
        // 1 and 3 are verdicts, which are printed.
        Some(0 | 1 | 3) => None,
        Some(2) if stderr.is_empty() => Some("refused without a message".to_owned()),
        Some(2) if !output.stdout.is_empty() => Some("refused with output".to_owned()),
        Some(2) => None,
        Some(code) => Some(format!("exit code {code}: {stderr}")),
    }
}

fn of<'a>(random: &mut Random, choices: &[&'a str]) -> &'a str {
    choices[usize::try_from(random.below(choices.len() as u64)).unwrap_or(0)]
}

/// The words of the command line with this index, by flags or with a design file of the same keys.
fn command_line(random: &mut Random, folder: &Path, index: usize) -> Result<Vec<String>> {
    let mut words: Vec<String> = match random.below(3) {
        0 => vec!["check".to_owned()],
        _ => {
            let language = of(random, &["c", "rust", "cpp", "python", "st"]);
            let mut words = ["emit", "--lang", language, "-o", "-"].map(str::to_owned).to_vec();
            if language == "c" && index.is_multiple_of(2) {
                words.push("--selftest".to_owned());
            }
            words
        }
    };
    let mut keys = keys(random);
    keys.retain(|(_, value)| value.len() < 100_000);
    if random.below(3) > 0 {
        words
            .extend(keys.iter().map(|(key, value)| format!("--{}={value}", key.replace('_', "-"))));
        return Ok(words);
    }
    let mut text = String::new();
    for (key, value) in &keys {
        let quoted = value.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n");
        let repeat = if random.below(40) == 0 { 5000 } else { 1 };
        text.push_str(&format!("{key} = \"{quoted}\"\n").repeat(repeat));
    }
    if random.below(8) == 0 {
        let brackets = ["[", "]", "\"", "[[objective]]\n", "\u{0}", "a.", "#"];
        text.push_str(&of(random, &brackets).repeat(count(random)));
    }
    let file = folder.join(DRAWN);
    fs::write(&file, text)?;
    words.push(file.display().to_string());
    Ok(words)
}

/// A small count, now and then a very large one.
fn count(random: &mut Random) -> usize {
    let most = [3, 30, 300, 20_000][usize::try_from(random.below(4)).unwrap_or(0)];
    usize::try_from(1 + random.below(most)).unwrap_or(1)
}

fn keys(random: &mut Random) -> Vec<(&'static str, String)> {
    let n = if random.below(6) == 0 { number(random) } else { (1 + random.below(16)).to_string() };
    let mut keys = vec![("n", n), ("allow", "membership,growth".to_owned())];
    match random.below(4) {
        0 => keys.push(("kappa", expression(random, "dt", 5))),
        1 => keys.push(("mu", of(random, &["exp", "tanh", "power(m=2)", "exp_sum(3)"]).to_owned())),
        _ => keys.push(("mu", expression(random, "t", 5))),
    }
    match random.below(5) {
        0 => keys.push(("pi0", expression(random, "xi1", 5))),
        1 => keys.push(("gains", vec![number(random); count(random).min(5000)].join(","))),
        _ => {}
    }
    if random.below(4) == 0 {
        keys.push(("g", expression(random, "x1", 5)));
    }
    for key in ["tau", "t0", "eps", "u_max", "name", "precision", "poles", "sample_time"] {
        if random.below(12) == 0 {
            keys.push((key, number(random)));
        }
    }
    keys
}

/// A number, or text in place of one.
fn number(random: &mut Random) -> String {
    match random.below(9) {
        0 => format!("1e{}", of(random, &["8", "300", "400", "401", "-400", "999999999999"])),
        1 => of(random, &["7", "0."]).to_owned() + &"9".repeat(count(random)),
        2 => {
            of(random, &["inf", "nan", "0", "-0", "", "\u{1b}[31m", "\u{202e}", "'", "`id`", "\n"])
                .to_owned()
        }
        3 => of(random, &["exp", "if", "stdint", "a b", "i", "2i", "t0"]).to_owned(),
        _ => format!("{:.3}", random.between(0.1, 9.0)),
    }
}

/// An expression in `name`: operations, or one form in itself many times.
fn expression(random: &mut Random, name: &str, depth: u32) -> String {
    let inner = |random: &mut Random| expression(random, name, depth.saturating_sub(1));
    if depth == 0 {
        return match random.below(6) {
            0 => number(random),
            1 => of(random, &["a", "tau", "pi", "b"]).to_owned(),
            _ => name.to_owned(),
        };
    }
    match random.below(9) {
        0 => {
            let forms = [
                "(E+K)^3",
                "1/(K+E)",
                "sin(E)",
                "cosh(E)",
                "atanh(E/2)",
                "sqrt(1+E^2)",
                "ln(1+E)",
                "(E)^(E)",
                "exp(E)",
                "min(E,K)",
                "abs(E-K)",
                "(E)",
                "-E",
                "mean(E,E)",
                "tan(E)",
            ];
            let form = of(random, &forms);
            let twice = form.matches('E').count() > 1;
            let times = if twice { 1 + random.below(9) } else { 1 + random.below(110) };
            (1..=times).fold(inner(random), |e, k| match e.len() {
                LONG.. => e,
                _ => form.replace('K', &k.to_string()).replace('E', &e),
            })
        }
        1 => {
            let (sign, of_k) = (of(random, &["+", "*", "/", "-", "^"]), inner(random));
            let times = count(random).min(LONG / of_k.len().max(10));
            (1..=times).map(|k| format!("({of_k}+{k})")).collect::<Vec<_>>().join(sign)
        }
        2 => format!("({})^{}", inner(random), number(random)),
        3 => format!("{}({})", of(random, &["exp", "ln", "tanh", "atan", "sinh"]), inner(random)),
        4 => format!("tau*(1 - exp(-{}))", inner(random)),
        5 => format!("{}/({})", inner(random), inner(random)),
        _ => format!("({}){}({})", inner(random), of(random, &["+", "-", "*"]), inner(random)),
    }
}
