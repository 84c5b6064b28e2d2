//! Results of layers that passed, kept in cargo's target folder, so that a run of hours can be resumed.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, ensure};
use serde_json::{Value, json};

use crate::context::{Context, workspace};
use crate::harness::command::text;
use crate::layer::PASSED;
use crate::report::Entry;

/// The results of one commit, examined in one way.
#[derive(Debug, PartialEq, Eq)]
pub struct Kept {
    folder: PathBuf,
    /// The commit and the options of the run; none where files differ from the commit.
    run: Option<String>,
}

impl Kept {
    /// Opens the results of the present commit of the workspace, with the options of `context`.
    pub fn new(context: &Context) -> Self {
        let git = |words: &[&str]| text(Command::new("git").args(words).current_dir(workspace()));
        let changed = git(&["status", "--porcelain", "--", ".", ":!assurance/REPORT.md"]);
        let clean = changed.is_ok_and(|changed| changed.is_empty());
        let commit = git(&["rev-parse", "HEAD"]).ok().filter(|_| clean);
        let (seed, seconds) = (context.seed, context.time.as_secs_f64());
        let brief = context.brief;
        let run = |commit: String| format!("{} {seed} {seconds} {brief}", commit.trim());
        Self { folder: context.target().join("assure/kept"), run: commit.map(run) }
    }

    /// Checks that there is a commit to go by.
    ///
    /// # Errors
    /// Files differ from the commit, or there is none.
    pub fn resumes(&self) -> Result<()> {
        ensure!(
            self.run.is_some(),
            "--resume needs a commit without changes: commit them, or leave --resume out"
        );
        Ok(())
    }

    fn file(&self, layer: &str) -> PathBuf {
        self.folder.join(format!("{layer}.json"))
    }

    /// The result of the layer `name`, if it passed in such a run.
    pub fn entry(&self, name: &str) -> Option<Entry> {
        let kept: Value = serde_json::from_str(&fs::read_to_string(self.file(name)).ok()?).ok()?;
        let field = |key: &str| kept[key].as_str().map(str::to_owned);
        let of_this_run = self.run.is_some() && field("run") == self.run;
        let entry =
            || Some(Entry { word: PASSED, summary: field("summary")?, details: field("details")? });
        of_this_run.then(entry)?
    }

    /// Keeps the result of the layer `name`, which passed.
    ///
    /// # Errors
    /// A folder or a file that cannot be written.
    pub fn keep(&self, name: &str, Entry { summary, details, .. }: &Entry) -> Result<()> {
        let Some(run) = &self.run else { return Ok(()) };
        let kept = json!({ "run": run, "summary": summary, "details": details });
        fs::create_dir_all(&self.folder)?;
        // A run that is killed leaves a whole file or none.
        let part = self.folder.join(format!("{name}.part"));
        fs::write(&part, kept.to_string())?;
        Ok(fs::rename(part, self.file(name))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harness::empty;

    #[test]
    fn entries_of_other_runs_are_ignored() {
        let name = format!("ptc-assure-kept-{}", std::process::id());
        let folder = empty(&std::env::temp_dir().join(name));
        let of = |run: &str| Kept { folder: folder.clone(), run: Some(run.to_owned()) };
        let entry = Entry { word: PASSED, summary: "3 of 3".to_owned(), details: String::new() };
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
