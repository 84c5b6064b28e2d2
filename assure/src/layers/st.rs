//! Structured Text: parsed by blark, its parse tree run by an interpreter, compared with C. Its
//! PLCopen XML: validated.

mod plcopen;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;

use super::comparison::{Side, compare};
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::program::driver;
use crate::harness::runtime;
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "st",
    claim: "blark parses emitted Structured Text, an interpreter of its parse tree with strict types \
            gives the bits of C where no library is called, and its PLCopen XML is valid.",
    tools: &[GCC, PYTHON],
    run,
};

/// Files that are no Structured Text.
const REFUSED: [Defect; 3] = [
    ("END_FUNCTION_BLOCK", "", "a function block without an end"),
    ("u := LREAL#0.0;", "u = LREAL#0.0;", "an assignment written as a comparison"),
    (" THEN", " {", "a brace of C"),
];

/// An interpreter with what reads Structured Text, and with NumPy.
pub(super) fn python(context: &Context) -> Result<PathBuf> {
    runtime::python(&context.shared("blark"), &["numpy>=1.26", "blark==0.8.3"])
}

fn run(context: &Context) -> Result<Finding> {
    let python = python(context)?;
    let side = Side {
        language: Language::StructuredText,
        run: &|folder, homes, records| {
            let mut command = Command::new(&python);
            command.arg(driver("structured_text_calls.py"));
            runtime::outcomes(&mut command, folder, homes, records)
        },
        has_axis: false,
        defect: (
            "- self.correction;",
            ";",
            "what the rounding of the deadline left out is forgotten",
        ),
    };
    let mut finding = compare(context, &side)?;
    finding.notes.push(
        "No runtime of a programmable controller is at hand: what a vendor's compiler makes of the file, \
         and the arithmetic of its target, are not examined."
            .to_owned(),
    );
    for (index, defect) in REFUSED.into_iter().enumerate() {
        let folder = context.scratch(&format!("st_refused{index}"));
        let files = with_defect(&folder, &context.example(), Language::StructuredText, defect)?;
        let said = parsed(&python, &files)?;
        finding.seed(defect.2, said.map(|_| "blark".to_owned()));
    }
    plcopen::validate(context, &mut finding)?;
    Ok(finding)
}

/// What blark says of files that it does not take.
fn parsed(python: &Path, files: &[PathBuf]) -> Result<Option<String>> {
    let mut command = Command::new(python);
    let output =
        command.arg(driver("structured_text_calls.py")).arg("--parse").args(files).output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(text))
}
