//! Controllers in C: emitted, compiled each on its own, called by one driver.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::emit::Language;

use crate::case::Case;
use crate::failure::{Result, While};
use crate::tools::{parallel, run};

/// The flags of every compilation.
pub(crate) const FLAGS: [&str; 2] = ["-std=c99", "-O2"];

/// Size of a compiled controller.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Size {
    /// Code of `step` and of the loops that it calls, in bytes.
    pub(crate) text: u64,
    /// Stack of `step` without its callees, in bytes.
    pub(crate) stack: u64,
}

/// Emits and compiles `cases` in `folder`.
pub(crate) fn compile(cases: &[Case], folder: &Path) -> Result<Vec<Size>> {
    compile_with(cases, &[], folder)
}

/// The same with `flags` beside [`FLAGS`].
pub(crate) fn compile_with(cases: &[Case], flags: &[&str], folder: &Path) -> Result<Vec<Size>> {
    parallel(cases, |case| {
        for file in case.files(Language::C)? {
            std::fs::write(folder.join(&file.name), &file.text).while_doing(&file.name)?;
        }
        let name = case.name();
        let mut gcc = Command::new("gcc");
        gcc.current_dir(folder).args(FLAGS).args(flags).arg("-fstack-usage");
        run(gcc.args(["-c", &format!("{name}.c"), "-o", &format!("{name}.o")]))?;
        let step = format!("{name}_step");
        let usage = std::fs::read_to_string(folder.join(format!("{name}.su")))?;
        let stack = usage.lines().filter_map(|line| {
            let mut columns = line.split('\t');
            let function = columns.next()?.rsplit(':').next()?;
            let bytes = columns.next()?.parse().ok()?;
            (function == step).then_some(bytes)
        });
        let sizes = symbol_sizes(&folder.join(format!("{name}.o")))?;
        Ok(Size { text: size_of_step(&sizes, &name), stack: stack.max().unwrap_or(0) })
    })
}

/// Sizes of the defined symbols of an object or a binary.
pub(crate) fn symbol_sizes(file: &Path) -> Result<BTreeMap<String, u64>> {
    let listing = run(Command::new("nm").args(["-S", "--defined-only"]).arg(file))?;
    let entry = |line: &str| {
        let columns: Vec<_> = line.split_whitespace().collect();
        let [_, size, kind, name] = columns[..] else { return None };
        let code = matches!(kind, "t" | "T" | "W");
        Some((name.to_owned(), u64::from_str_radix(size, 16).ok()?)).filter(|_| code)
    };
    Ok(listing.lines().filter_map(entry).collect())
}

/// The size of the `step` of `controller` with the parts that the compiler split off, such as
/// `step.cold`, and with the loops `row_sums` that it calls, whose name Rust mangles.
pub(crate) fn size_of_step(sizes: &BTreeMap<String, u64>, controller: &str) -> u64 {
    let step = format!("{controller}_step");
    let part = |name: &str| {
        name.strip_prefix(&step).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            || name.split_once(controller).is_some_and(|(_, rest)| rest.contains("row_sums"))
    };
    sizes.iter().filter(|(name, _)| part(name)).map(|(_, size)| size).sum()
}

/// Compiles `driver` and links it with the controllers of `cases` and with `more` objects.
pub(crate) fn link(
    driver: &str,
    cases: &[Case],
    more: &[PathBuf],
    folder: &Path,
) -> Result<PathBuf> {
    std::fs::write(folder.join("driver.c"), driver)?;
    let program = folder.join("driver");
    let mut gcc = Command::new("gcc");
    gcc.current_dir(folder).args(["-std=c99", "-O1", "-ffp-contract=off", "driver.c"]);
    gcc.args(cases.iter().map(|case| format!("{}.o", case.name()))).args(more);
    run(gcc.arg("-o").arg(&program).args(["-Wl,-z,now", "-lm"]))?;
    Ok(program)
}

/// `{ .tau = 8.0, .k = { 1.0, 2.0 } }`.
pub(crate) fn parameters(fields: &[(&str, Vec<String>)]) -> String {
    let mut text = String::from("{");
    for (index, (field, values)) in fields.iter().enumerate() {
        let comma = if index == 0 { " " } else { ", " };
        let value = match &values[..] {
            [value] if !Case::is_array(field) => value.clone(),
            _ => format!("{{ {} }}", values.join(", ")),
        };
        let _ = write!(text, "{comma}.{field} = {value}");
    }
    text + " }"
}

/// Literals that give the same values in C and in Rust.
pub(crate) fn digits(values: &[f64]) -> Vec<String> {
    values.iter().map(|value| format!("{value:?}")).collect()
}

/// The literals, separated by commas.
pub(crate) fn list(values: &[f64]) -> String {
    digits(values).join(", ")
}
