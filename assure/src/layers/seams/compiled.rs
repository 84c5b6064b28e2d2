//! The emitted C, compiled and run on the samples of a run of `simulate`: the bits of u are those of the run.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result};

use super::design::Design;
use super::one::Row;
use crate::harness::c_compiler;
use crate::harness::command::{succeed, text};

/// Samples that are compared.
const SAMPLES: usize = 40;

/// A program that calls `step` with each sample and prints its status and its inputs.
fn driver(design: &Design, rows: &[Row], in_samples: bool) -> String {
    let name = &design.name;
    let width = rows[0].given.len();
    let inputs = rows[0].u.len();
    let real = if design.gives("precision") { "float" } else { "double" };
    let mut text = format!(
        "#include <stdio.h>\n#include <string.h>\n#include \"{name}.h\"\n\
         static const double rows[][{}] = {{\n",
        width + 1
    );
    for row in rows {
        let cells: Vec<_> =
            std::iter::once(&row.t).chain(&row.given).map(|cell| format!("{cell:e}")).collect();
        let _ = writeln!(text, "    {{{}}},", cells.join(", "));
    }
    let each = if design.has_several_inputs() { ", each" } else { "" };
    let time = if in_samples { "(uint32_t)k".to_owned() } else { format!("({real})rows[k][0]") };
    let _ = write!(
        text,
        "}};\nint main(void)\n{{\n    {name} c;\n    {name}_params p;\n    memset(&p, 0, sizeof p);\n    \
         if ({name}_init(&c, &p) != PTC_OK) return 1;\n    \
         for (unsigned k = 0; k < {}U; k++) {{\n        {real} y[{width}], u[{inputs}];\n        \
         ptc_status each[{inputs}];\n        (void)each;\n        \
         for (int i = 0; i < {width}; i++) y[i] = ({real})rows[k][i + 1];\n        \
         const void *given = y;\n        void *out = u;\n        \
         printf(\"%d\", (int){name}_step(&c, {time}, given, out{each}));\n        \
         for (int i = 0; i < {inputs}; i++) printf(\" %.17g\", (double)u[i]);\n        \
         printf(\"\\n\");\n    }}\n    return 0;\n}}\n",
        rows.len()
    );
    text
}

/// Returns the first difference between u of the emitted C and of the run, if any.
pub(super) fn differences(folder: &Path, design: &Design, run: &[Row]) -> Result<Vec<String>> {
    let rows = &run[..run.len().min(SAMPLES)];
    if rows.is_empty() {
        return Ok(vec!["simulate has no samples".to_owned()]);
    }
    let in_samples = design.gives("clock");
    let own = folder.join("c");
    fs::write(own.join("driver.c"), driver(design, rows, in_samples))?;
    let program = own.join("driver");
    let mut compile = c_compiler();
    compile.current_dir(&own).args(["-O1", "-ffp-contract=off", "driver.c"]);
    compile.arg(format!("{}.c", design.name)).args(["-lm", "-o"]).arg(&program);
    succeed(&mut compile)?;
    let printed = text(&mut Command::new(&program)).context("the emitted C, which init accepts")?;
    let given = |line: &str| line.split(' ').skip(1).filter_map(|cell| cell.parse().ok()).collect();
    let computed: Vec<Vec<f64>> = printed.lines().map(given).collect();
    // The acting input was computed `delay` samples before.
    let acting = rows.iter().skip(design.delay());
    let differs = |(u, row): (&Vec<f64>, &Row)| {
        u.len() != row.u.len()
            || u.iter().zip(&row.u).any(|(a, b)| a != b && !(a.is_nan() && b.is_nan()))
    };
    let first = computed.iter().zip(acting).find(|(u, row)| differs((u, row)));
    let told = |(u, row): (&Vec<f64>, &Row)| {
        format!("at t = {} the emitted C gives u = {u:?}, simulate {:?}", row.t, row.u)
    };
    Ok(first.map(told).into_iter().collect())
}

/// C with its last constant that is not a whole number changed in the last place.
pub(super) fn with_other_constant(text: &str) -> String {
    let body = text.rfind("_step(").unwrap_or(0);
    let is_digit = |c: char| c.is_ascii_digit();
    let found = text[body..].match_indices('.').find(|(at, _)| {
        let (before, behind) = text[body..].split_at(*at);
        before.ends_with(is_digit) && behind[1..].starts_with(|c: char| ('1'..='9').contains(&c))
    });
    let Some((at, _)) = found else { return text.to_owned() };
    let at = body + at + 1;
    let digit = if text[at..].starts_with('9') { "8" } else { "9" };
    format!("{}{digit}{}", &text[..at], &text[at + 1..])
}
