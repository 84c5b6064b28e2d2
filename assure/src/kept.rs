//! What layers found that passed, kept in cargo's folder, so that a run of hours can be resumed.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, bail};
use serde_json::{Value, json};

use crate::context::{Context, workspace};
use crate::harness::command::text;
use crate::report::Entry;

/// The entries of one commit, examined in one way.
#[derive(Debug)]
pub struct Kept {
    folder: PathBuf,
    /// The commit and the words of the run; none where files differ from the commit.
    run: Option<String>,
}

impl Kept {
    /// Those of the commit of the workspace, of this seed, time and size.
    pub fn new(context: &Context) -> Self {
        let git = |words: &[&str]| text(Command::new("git").args(words).current_dir(workspace()));
        let clean = git(&["status", "--porcelain", "--", ":!assurance/REPORT.md"])
            .is_ok_and(|told| told.is_empty());
        let commit = git(&["rev-parse", "HEAD"]).ok().filter(|_| clean);
        let day =
            if context.brief { format!(" --brief, day {}", context.day) } else { String::new() };
        let run = |commit: String| {
            format!(
                "{} --seed {} --seconds {}{day}",
                commit.trim(),
                context.seed,
                context.time.as_secs_f64()
            )
        };
        Self { folder: context.target().join("assure/kept"), run: commit.map(run) }
    }

    /// Whether anything can be kept.
    ///
    /// # Errors
    /// Files differ from the commit, or there is none.
    pub fn resumes(&self) -> Result<()> {
        if self.run.is_none() {
            bail!("--resume goes by the commit: commit the changes, or leave it out");
        }
        Ok(())
    }

    fn file(&self, layer: &str) -> PathBuf {
        self.folder.join(format!("{layer}.json"))
    }

    /// What the layer `name` found, if it passed in such a run.
    pub fn entry(&self, name: &str) -> Option<Entry> {
        let kept: Value = serde_json::from_str(&fs::read_to_string(self.file(name)).ok()?).ok()?;
        let text = |key: &str| kept[key].as_str().map(str::to_owned);
        (text("run") == self.run && self.run.is_some()).then_some(())?;
        Some(Entry { word: text("word")?, summary: text("summary")?, details: text("details")? })
    }

    /// Keeps what the layer `name` found.
    ///
    /// # Errors
    /// A folder or a file that cannot be written.
    pub fn keep(&self, name: &str, entry: &Entry) -> Result<()> {
        let Some(run) = &self.run else { return Ok(()) };
        let Entry { word, summary, details } = entry;
        let kept = json!({ "run": run, "word": word, "summary": summary, "details": details });
        fs::create_dir_all(&self.folder)?;
        // Whole or not at all, however it ends.
        let part = self.folder.join(format!("{name}.part"));
        fs::write(&part, kept.to_string())?;
        Ok(fs::rename(part, self.file(name))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_of_another_run_is_not_taken() {
        let folder = std::env::temp_dir().join(format!("ptc-assure-kept-{}", std::process::id()));
        let of = |run: &str| Kept { folder: folder.clone(), run: Some(run.to_owned()) };
        let entry = Entry {
            word: "passed".to_owned(),
            summary: "3 of 3".to_owned(),
            details: String::new(),
        };
        of("a --seed 1").keep("eva", &entry).expect("a file");
        assert_eq!(of("a --seed 1").entry("eva"), Some(entry.clone()));
        assert_eq!(of("a --seed 2").entry("eva"), None);
        assert_eq!(of("a --seed 1").entry("rules"), None);
        let changed = Kept { folder: folder.clone(), run: None };
        changed.keep("rules", &entry).expect("nothing to do");
        assert_eq!((changed.entry("eva"), changed.entry("rules")), (None, None));
        fs::remove_dir_all(folder).expect("the folder");
    }
}
