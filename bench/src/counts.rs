//! `counts`: instructions a call, code and stack of every controller, in C and in Rust.

use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::c::{self, Size};
use crate::callgrind::{self, Profile};
use crate::calls::{c_driver, rust_driver};
use crate::case::{Case, GUARDS, Key, ORDERS, PRECISIONS, VARIANTS};
use crate::failure::{Failure, Result, While};
use crate::tools::{parallel, run, scratch};

/// Measurements of one controller.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Count {
    pub(crate) key: Key,
    /// Mean instructions of a call, mathematical library included.
    pub(crate) step: f64,
    pub(crate) tick: f64,
    pub(crate) axis: f64,
    /// Bytes of code of `step`.
    pub(crate) text: u64,
    /// Bytes of stack of `step`; C only.
    pub(crate) stack: Option<u64>,
}

/// The cases of one precision.
pub(crate) fn cases(precision: Precision, orders: &[usize], guards: &[Guard]) -> Vec<Case> {
    let mut cases = Vec::new();
    for variant in VARIANTS {
        for n in orders {
            cases.extend(guards.iter().map(|guard| Case::new(variant, *n, precision, *guard)));
        }
    }
    cases
}

/// Measures everything.
pub(crate) fn measure() -> Result<Vec<Count>> {
    callgrind::available()?;
    let mut counts = in_c("counts-c", &ORDERS, &GUARDS)?;
    counts.extend(in_rust("counts-rust", &ORDERS, &GUARDS)?);
    Ok(counts)
}

/// Measures the C of both precisions.
pub(crate) fn in_c(name: &str, orders: &[usize], guards: &[Guard]) -> Result<Vec<Count>> {
    let root = scratch(name)?;
    let mut built = Vec::new();
    for precision in PRECISIONS {
        let cases = cases(precision, orders, guards);
        let folder = root.join(crate::case::precision_name(precision));
        std::fs::create_dir_all(&folder)?;
        let sizes = c::compile(&cases, &folder)?;
        let program = c::link(&c_driver(&cases), &cases, &[], &folder)?;
        works(&program)?;
        built.push((cases, sizes, program));
    }
    let counts = parallel(&built, |(cases, sizes, program)| {
        let profile = callgrind::profile(program, &[], &program.with_extension("callgrind"))?;
        let count = |(case, size): (&Case, &Size)| {
            count(case.key("c"), case, &profile, size.text, Some(size.stack))
        };
        cases.iter().zip(sizes).map(count).collect::<Result<Vec<_>>>()
    })?;
    Ok(counts.into_iter().flatten().collect())
}

/// Measures the Rust of both precisions.
fn in_rust(name: &str, orders: &[usize], guards: &[Guard]) -> Result<Vec<Count>> {
    let root = scratch(name)?;
    // One crate a precision and guard: they compile side by side.
    let mut crates = Vec::new();
    for precision in PRECISIONS {
        for guard in guards {
            crates.push(cases(precision, orders, &[*guard]));
        }
    }
    let counts = parallel(&crates, |cases| {
        let first = cases.first().ok_or_else(|| Failure::new("no case"))?;
        let guard = crate::case::guard_name(first.spec.guard);
        let folder = root.join(format!("{}-{guard}", first.real()));
        let program = rust_program(cases, &folder)?;
        works(&program)?;
        let profile = callgrind::profile(&program, &[], &program.with_extension("callgrind"))?;
        let sizes = c::symbol_sizes(&program)?;
        let count = |case: &Case| {
            let text = c::size_of_step(&sizes, &case.name());
            count(case.key("rust"), case, &profile, text, None)
        };
        cases.iter().map(count).collect::<Result<Vec<_>>>()
    })?;
    Ok(counts.into_iter().flatten().collect())
}

fn rust_program(cases: &[Case], folder: &Path) -> Result<PathBuf> {
    std::fs::create_dir_all(folder)?;
    for case in cases {
        for file in case.files(Language::Rust)? {
            std::fs::write(folder.join(&file.name), &file.text).while_doing(&file.name)?;
        }
    }
    std::fs::write(folder.join("driver.rs"), rust_driver(cases))?;
    let program = folder.join("driver");
    let mut rustc = Command::new("rustc");
    // A unit for each module, so that the compiler does not merge controllers that are alike.
    rustc.current_dir(folder).args(["--edition=2024", "-Copt-level=3", "-Ccodegen-units=512"]);
    run(rustc.args(["-Awarnings", "driver.rs", "-o"]).arg(&program))?;
    Ok(program)
}

/// The drivers name each controller that failed: its counts would be those of an error.
pub(crate) fn works(program: &Path) -> Result<()> {
    let failed = run(&mut Command::new(program))?;
    if failed.is_empty() {
        return Ok(());
    }
    Err(Failure::new(format!("calls of these controllers failed: {}", failed.replace('\n', " "))))
}

fn count(key: Key, case: &Case, profile: &Profile, text: u64, stack: Option<u64>) -> Result<Count> {
    let name = case.name();
    let mean = |function: &str| profile.of(&format!("{name}_{function}")).map(|cost| cost.mean());
    Ok(Count { key, step: mean("step")?, tick: mean("tick")?, axis: mean("axis")?, text, stack })
}
