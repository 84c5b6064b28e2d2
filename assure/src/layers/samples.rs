//! The controller in samples in the loop with the exact chain, in long arithmetic.

use std::path::Path;
use std::process::{Command, Output};

use anyhow::{Result, ensure};

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::runtime;
use crate::layer::{Finding, Layer, Table};
use crate::tool::PYTHON;

pub(super) const LAYER: Layer = Layer {
    name: "samples",
    claim: "Emitted C with a clock in samples, in the loop with the exact chain in 120 digits, is at \
            rest at sample N, and an observer alone has the state at sample N_o: orders 1 to 4, \
            delays, N = n + 2 too, observers, unknown forces, references. The figures of \
            docs/time.md and docs/benchmarks/samples.md are those of this machine.",
    tools: &[PYTHON],
    run,
};

const TIME: &str = include_str!("../../../docs/time.md");

const PAGE: &str = include_str!("../../../docs/benchmarks/samples.md");

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("samples"), &["mpmath>=1.3", "gmpy2"])?;
    let command = generator()?;
    let mut finding = Finding::default();
    // With the plant whose input gain is off by 1e-6, which has to be seen.
    let all = vec![
        ("rest", PAGE, Some("a plant with an input gain off by 1e-6")),
        ("alone", PAGE, Some("an observer of a plant with an input gain off by 1e-6")),
        ("follow", PAGE, Some("a plant that follows with an input gain off by 1e-6")),
        ("stage", PAGE, None),
        ("energy", PAGE, None),
        ("table", TIME, None),
    ];
    let due = context.in_turn(all);
    let names: Vec<_> = due.iter().map(|(what, ..)| *what).collect();
    for (what, page, seed) in due {
        let output = measured(&python, &command, &[what])?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        if !output.status.success() {
            finding.failures.push(format!("more is left than claimed:\n{printed}"));
        }
        finding.failures.extend(missing(&printed, page).map(|row| format!("{what} gives {row}")));
        match what {
            "rest" => finding.tables.push(rows("What is left of the state at sample N", &printed)),
            "alone" => {
                finding
                    .tables
                    .push(rows("What an observer alone is off by at sample N_o", &printed));
            }
            _ => {}
        }
        if let Some(seed) = seed {
            let wrong = measured(&python, &command, &[what, "--gain", "1.000001"])?;
            let left = String::from_utf8_lossy(&wrong.stdout).lines().next().map(str::to_owned);
            finding.seed(seed, left.filter(|_| !wrong.status.success()));
        }
    }
    let count = |table: &Table| -> usize {
        table.rows.iter().filter_map(|row| row[1].parse::<usize>().ok()).sum()
    };
    let loops: usize = finding.tables.iter().map(count).sum();
    finding.summary = format!(
        "{}: {loops} loops end at rest, or with the state in the observer, as far as doubles go",
        names.join(", ")
    );
    Ok(finding)
}

/// Returns the output of the script; exit code 1 means that more is left than is claimed.
fn measured(python: &Path, command: &Path, words: &[&str]) -> Result<Output> {
    let (what, options) = words.split_at(1);
    let output = Command::new(python)
        .arg(workspace().join("tools/samples.py"))
        .args(what)
        .arg(command)
        .args(options)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()?;
    let errors = String::from_utf8_lossy(&output.stderr);
    let is_plain = errors.lines().all(|line| line.starts_with("note: "));
    ensure!(is_plain, "{words:?}: {errors}");
    Ok(output)
}

/// The printed rows that `page` does not show.
fn missing<'a>(printed: &'a str, page: &'a str) -> impl Iterator<Item = &'a str> {
    printed.lines().filter(|row| !page.lines().any(|line| line.trim() == *row))
}

fn rows(title: &str, printed: &str) -> Table {
    let cells = |row: &str| row.trim_matches(['|', ' ']).split(" | ").map(str::to_owned).collect();
    Table {
        title: title.to_owned(),
        head: vec!["loops", "number", "in parts of the largest state"],
        rows: printed.lines().map(cells).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_table_row_is_reported() {
        let row = PAGE.lines().find(|line| line.starts_with("| observer, N = 20 |"));
        let row = row.expect("a row of `rest`");
        assert_eq!(missing(row, PAGE).next(), None);
        let other = row.replace("20 | 18", "20 | 17");
        assert_eq!(missing(&other, PAGE).collect::<Vec<_>>(), [other.as_str()]);
        assert_eq!(rows("rest", row).rows[0][1], "18");
    }
}
