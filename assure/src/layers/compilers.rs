//! Warnings and static analysis of two compilers, and the header as C++17.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;

use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::{STRICT, empty, in_pairs, write};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{CLANG, GCC, GXX};

pub(super) const LAYER: Layer = Layer {
    name: "compilers",
    claim: "gcc and clang compile every emitted C file without a warning under strict flags, gcc's \
            static analyser finds nothing, and every header is C++17.",
    tools: &[GCC, CLANG, GXX],
    run,
};

/// The passes over each file: compiler, further flags, and whether it reads the header.
const PASSES: [(&str, &str, &[&str], bool); 4] = [
    ("gcc", "gcc, strict", &["-Wcast-align", "-Wstrict-prototypes", "-Wmissing-prototypes"], false),
    ("gcc", "gcc -fanalyzer", &["-fanalyzer"], false),
    ("clang", "clang, strict", &["-Wmissing-prototypes", "-Wimplicit-float-conversion"], false),
    ("g++", "g++ -std=c++17, header", &[], true),
];

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("compilers");
    let specs = [
        context.goldens(),
        context.families(context.order(6)),
        context.systems(),
        context.random(40),
    ]
    .concat();
    let indexed: Vec<_> = specs.iter().enumerate().collect();
    let told = in_pairs(&indexed, |(index, spec)| {
        let folder = empty(&folder.join(index.to_string()));
        let files = write(&folder, spec, Language::C);
        PASSES.map(|pass| compile(pass, &files))
    });
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for (index, (_, title, flags, _)) in PASSES.iter().enumerate() {
        let found: Vec<_> = told.iter().filter_map(|one| one[index].clone()).collect();
        rows.push(vec![
            (*title).to_owned(),
            flags.join(" "),
            specs.len().to_string(),
            found.len().to_string(),
        ]);
        finding.failures.extend(found);
    }
    finding.summary = format!(
        "{} controllers, {} passes, {} with a warning",
        specs.len(),
        PASSES.len(),
        finding.failures.len()
    );
    let head = vec!["pass", "beside the strict flags", "controllers", "with a warning"];
    finding.tables.push(Table { title: "Passes".to_owned(), head, rows });
    finding.notes.push(format!("The strict flags: `{}`.", STRICT.join(" ")));
    seeded(context, &folder, &mut finding)?;
    Ok(finding)
}

/// The output of a pass for the files of a controller, if any.
fn compile(
    (program, _, flags, header): (&str, &str, &[&str], bool),
    files: &[PathBuf],
) -> Option<String> {
    let wanted = if header { "h" } else { "c" };
    let file = files.iter().find(|file| file.extension().is_some_and(|e| e == wanted))?;
    let mut command = Command::new(program);
    let cpp =
        ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-x", "c++"];
    if header {
        command.args(cpp);
    } else {
        command.args(STRICT);
    }
    command.args(flags).arg("-c").arg(file);
    if !header {
        // A compiler that fails removes its output, also a device where it may.
        command.arg("-o").arg(file.with_extension("o"));
    }
    let output = command.output().ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    (!output.status.success()).then_some(text)
}

/// Defects, and the pass that must see each.
const DEFECTS: [(Defect, usize); 4] = [
    (("const double past = ", "const float past = ", "a time narrowed to float"), 0),
    (("if (u != NULL) {", "if (u == NULL) {", "the check for NULL turned round"), 1),
    (
        (
            "const double past = ",
            "double t_copy = t; const double past = ",
            "a value that nothing uses",
        ),
        2,
    ),
    (
        (
            "typedef struct ptc_exp2_params {",
            "typedef struct ptc_exp2_params { int class;",
            "a C++ keyword in the header",
        ),
        3,
    ),
];

fn seeded(context: &Context, folder: &Path, finding: &mut Finding) -> Result<()> {
    for (index, (defect, pass)) in DEFECTS.into_iter().enumerate() {
        let folder = folder.join(format!("seeded{index}"));
        let files = with_defect(&folder, &context.example(), Language::C, defect)?;
        let told = compile(PASSES[pass], &files);
        finding.seed(defect.2, told.map(|_| PASSES[pass].1.to_owned()));
    }
    Ok(())
}
