//! Structured Text: parsed by blark, its parse tree run by an interpreter, compared with C. Its
//! PLCopen XML: validated.

mod grammar;
mod plcopen;
mod words;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;

use super::comparison::{Side, compare, controllers};
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::in_samples::of_inputs;
use crate::harness::program::driver;
use crate::harness::runtime;
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "st",
    claim: "blark and a second, strict grammar parse emitted Structured Text, an interpreter of its parse tree \
            with strict types gives the bits of C where no library is called, and its PLCopen XML is valid.",
    tools: &[GCC, PYTHON],
    run,
};

/// Files that are no Structured Text.
const REFUSED: [Defect; 3] = [
    ("END_FUNCTION_BLOCK", "", "a function block without an end"),
    ("u := LREAL#0.0;", "u = LREAL#0.0;", "an assignment written as a comparison"),
    (" THEN", " {", "a brace of C"),
];

/// Files that a vendor may take, and iec2c does not.
const STRICT: [Defect; 5] = [
    ("END_STRUCT;", "END_STRUCT", "a declaration without its semicolon"),
    ("LREAL#0.0", "LREAL#1.7976931348623157E+308", "a literal beyond the range of a float"),
    ("x : ptc_exp2_vector2", "x : ARRAY[1..2] OF LREAL", "an input of a type without a name"),
    ("VAR_TEMP\n", "VAR_TEMP\n    built2 : ptc_exp2_fields;\n", "a structure among temporaries"),
    ("ABS(", "FABS(", "a function that nobody declares"),
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
    strictly(context, &mut finding)?;
    plcopen::validate(context, &mut finding)?;
    Ok(finding)
}

/// Holds the files of all controllers that compute all of their law against the strict grammar.
fn strictly(context: &Context, finding: &mut Finding) -> Result<()> {
    let mut count = 0;
    for spec in &[controllers(context), context.in_samples(), of_inputs()].concat() {
        let Ok(files) = ptc_codegen::generate(spec, Language::StructuredText) else { continue };
        // Functions of the user's are in another file.
        let others = ["pi0", "after"].map(|law| format!("{}_{law}", spec.name()));
        for file in &files {
            count += 1;
            if let Err(wrong) = grammar::parse(&file.text, &others) {
                finding.failures.push(format!("{}: {wrong}", file.name));
            }
        }
    }
    finding.notes.push(format!(
        "{count} files were parsed by the strict grammar of src/layers/st/grammar.rs."
    ));
    for defect in STRICT {
        let folder = context.scratch("st_strict");
        let files = with_defect(&folder, &context.example(), Language::StructuredText, defect)?;
        let said = files.iter().map(std::fs::read_to_string).collect::<Result<Vec<_>, _>>()?;
        let said = said.iter().find_map(|text| grammar::parse(text, &[]).err());
        finding.seed(defect.2, said.map(|_| "the strict grammar".to_owned()));
    }
    Ok(())
}

/// Returns the messages of blark on files that it does not take.
fn parsed(python: &Path, files: &[PathBuf]) -> Result<Option<String>> {
    let mut command = Command::new(python);
    let output =
        command.arg(driver("structured_text_calls.py")).arg("--parse").args(files).output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(text))
}
