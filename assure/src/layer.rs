//! A layer of assurance: a claim about emitted code, the tools that test it, and what they found.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use anyhow::Result;

use crate::context::Context;
use crate::tool::Tool;

/// A layer.
pub struct Layer {
    /// Its word on the command line.
    pub name: &'static str,
    /// Claim about emitted code, as a sentence.
    pub claim: &'static str,
    /// The tools without which it cannot run.
    pub tools: &'static [Tool],
    /// The work. An error is a failure of the layer.
    pub run: fn(&Context) -> Result<Finding>,
}

/// Findings of a layer.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// One line: how much was examined, and with what result.
    pub summary: String,
    /// For the report.
    pub tables: Vec<Table>,
    /// Limits and reasons that a reader must know, for the report.
    pub notes: Vec<String>,
    /// Each of these fails the layer.
    pub failures: Vec<String>,
    /// Defects put in on purpose: a check that cannot fail shows nothing.
    pub seeded: Vec<Seeded>,
}

impl Finding {
    /// Records a defect that was put in on purpose; one that was not caught fails the layer.
    pub fn seed(&mut self, defect: &str, caught: Option<String>) {
        if caught.is_none() {
            self.failures.push(format!("the seeded defect was not caught: {defect}"));
        }
        self.seeded.push(Seeded { defect: defect.to_owned(), caught });
    }
}

/// A defect put in on purpose.
#[derive(Clone, Debug)]
pub struct Seeded {
    /// Defect in the code.
    pub defect: String,
    /// Tool that reported it; `None` if nothing did.
    pub caught: Option<String>,
}

/// A table of the report.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// Title.
    pub title: String,
    /// Heads of the columns.
    pub head: Vec<&'static str>,
    /// Rows, each as long as the head.
    pub rows: Vec<Vec<String>>,
}

/// The error of a layer that found, while it ran, that a tool cannot be had: it is then not run.
#[derive(Debug)]
pub struct Missing(pub String);

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Missing {}

/// The word for a layer that found no fault.
pub const PASSED: &str = "passed";

/// The word for a layer that could not run.
pub const NOT_RUN: &str = "NOT RUN";

/// Outcome of a layer.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It ran and found no fault.
    Passed(Finding),
    /// It ran and found faults, or broke.
    Failed(Finding),
    /// It could not run, for this reason.
    NotRun(String),
}

impl Outcome {
    /// The word for it in reports.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Passed(_) => PASSED,
            Self::Failed(_) => "FAILED",
            Self::NotRun(_) => NOT_RUN,
        }
    }

    /// One line about it.
    pub fn summary(&self) -> &str {
        match self {
            Self::Passed(finding) | Self::Failed(finding) => &finding.summary,
            Self::NotRun(reason) => reason,
        }
    }

    /// Returns the finding, where it ran.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Passed(finding) | Self::Failed(finding) => Some(finding),
            Self::NotRun(_) => None,
        }
    }
}

impl Layer {
    /// Runs the layer, where its tools are there, and takes the time.
    pub fn execute(&self, context: &Context) -> (Outcome, Duration) {
        let began = Instant::now();
        let missing: Vec<_> = self.tools.iter().filter(|tool| !tool.is_there()).collect();
        if !missing.is_empty() {
            let told: Vec<_> = missing.iter().map(|tool| tool.missing()).collect();
            return (Outcome::NotRun(told.join("; ")), began.elapsed());
        }
        let result = catch_unwind(AssertUnwindSafe(|| (self.run)(context)));
        let outcome = match result {
            Ok(Ok(finding)) if finding.failures.is_empty() => Outcome::Passed(finding),
            Ok(Ok(finding)) => Outcome::Failed(finding),
            Ok(Err(error)) => match error.downcast::<Missing>() {
                Ok(missing) => Outcome::NotRun(missing.0),
                Err(error) => broken(format!("{error:#}")),
            },
            Err(panic) => broken(panic_text(panic.as_ref())),
        };
        (outcome, began.elapsed())
    }
}

fn broken(message: String) -> Outcome {
    let summary = message.lines().next().unwrap_or_default().to_owned();
    Outcome::Failed(Finding { summary, failures: vec![message], ..Finding::default() })
}

/// Returns the message of a panic of the harness: a compiler or a program of a controller failed.
fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or(panic.downcast_ref::<&str>().copied()).unwrap_or("a panic without a text").to_owned()
}
