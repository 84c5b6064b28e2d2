//! Emitted sources with a defect put in on purpose.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail};
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use crate::harness::{empty, write};

/// A defect: the text of the emitted files that is replaced, by what, and what it is in words.
pub(super) type Defect = (&'static str, &'static str, &'static str);

/// The files of `spec` in `folder`, with the first place of the defect's text replaced.
pub(super) fn with_defect(
    folder: &Path,
    spec: &Spec,
    language: Language,
    defect: Defect,
) -> Result<Vec<PathBuf>> {
    let files = write(&empty(folder), spec, language);
    put_in(&files, defect)?;
    Ok(files)
}

/// Replaces the first place of the defect's text in `files`; an error where there is none.
pub(super) fn put_in(files: &[PathBuf], (good, bad, defect): Defect) -> Result<()> {
    for file in files {
        let text = fs::read_to_string(file).with_context(|| file.display().to_string())?;
        if text.contains(good) {
            fs::write(file, text.replacen(good, bad, 1))?;
            return Ok(());
        }
    }
    bail!("{files:?}: no text `{good}` to put the defect in: {defect}")
}
