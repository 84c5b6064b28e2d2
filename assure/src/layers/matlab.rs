//! MATLAB functions, run by GNU Octave and compared with C.

use std::path::Path;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;

use super::comparison::{Side, compare};
use crate::context::Context;
use crate::harness::program::{Outcome, Record, driver};
use crate::harness::runtime::{self, Home};
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, OCTAVE};

pub(super) const LAYER: Layer = Layer {
    name: "matlab",
    claim: "Emitted MATLAB functions run in GNU Octave and give the bits of C where no library is \
            called; parameters outside their domain raise their error.",
    tools: &[GCC, OCTAVE],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let side = Side {
        language: Language::Matlab,
        run: &outcomes,
        has_axis: true,
        defect: (
            "- self.correction;",
            ";",
            "what the rounding of the deadline left out is forgotten",
        ),
    };
    compare(context, &side)
}

fn outcomes(
    folder: &Path,
    homes: &[Home<'_>],
    records: &[Vec<Record>],
) -> Result<Vec<Vec<Outcome>>> {
    let mut octave = Command::new("octave-cli");
    octave.args(["-q", "--no-init-file", "--no-history"]).arg(driver("octave.m"));
    runtime::outcomes(&mut octave, folder, homes, records)
}
