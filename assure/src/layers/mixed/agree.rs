//! Programs around a controller, run beside the interpreter.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result, anyhow};
use ptc_codegen::code::Status;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::calls::{Calls, Line};
use super::fault;
use crate::harness::cpp::STRICT_CPP;
use crate::harness::{STRICT, rustc};

/// The first call of the controller in `home` that gives other bits than the interpreter, if any.
pub(super) fn differs(
    home: &Path,
    (spec, calls): (&Spec, &Calls),
    (language, python): (Language, &Path),
    wanted: &[Line],
) -> Result<Option<String>> {
    let name = spec.name();
    let (end, compiler) = match language {
        Language::C => {
            let mut gcc = Command::new("gcc");
            gcc.args(STRICT).arg(home.join(format!("{name}.c")));
            ("c", Some(gcc))
        }
        Language::Cpp => {
            let mut gcc = Command::new("g++");
            gcc.args(STRICT_CPP);
            ("cpp", Some(gcc))
        }
        Language::Rust => ("rs", Some(rustc())),
        _ => ("py", None),
    };
    let (main, binary) = (home.join(format!("main.{end}")), home.join("calls"));
    fs::write(&main, calls.program(spec, language))?;
    let mut run = match compiler {
        None => {
            let mut run = Command::new(python);
            run.args(["-B", "-W", "error"]).arg(&main);
            run
        }
        Some(mut compile) => {
            compile.arg(&main).arg("-o").arg(&binary);
            compile.args((end != "rs").then_some("-lm"));
            if let Some(fault) = fault(&mut compile)? {
                return Ok(Some(fault));
            }
            Command::new(&binary)
        }
    };
    let output = run.output()?;
    if !output.status.success() {
        return Ok(Some(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let text = String::from_utf8(output.stdout)?;
    let found = text.lines().map(line).collect::<Result<Vec<_>>>()?;
    if found.len() != wanted.len() {
        return Ok(Some(format!("{} lines, {} expected", found.len(), wanted.len())));
    }
    let pairs = found.iter().zip(wanted).enumerate();
    let differing = pairs.into_iter().find(|(_, (found, wanted))| found != wanted);
    Ok(differing.map(|(index, (found, wanted))| {
        let given = index.checked_sub(1).map(|call| &calls.all[call]);
        format!("call {index}: {found:x?}, the interpreter {wanted:x?}, of {given:?}")
    }))
}

/// A line of such a program.
fn line(text: &str) -> Result<Line> {
    let mut words = text.split(' ');
    let status = status(words.next().unwrap_or_default())?;
    let (mut u, mut axes) = (Vec::new(), Vec::new());
    for word in words {
        match word.strip_prefix("0x") {
            Some(bits) => u.push(u64::from_str_radix(bits, 16)?),
            None => axes.push(self::status(word)?),
        }
    }
    Ok((status, u, axes))
}

/// A status by its number, or by its name as Rust prints it.
fn status(word: &str) -> Result<i64> {
    if let Ok(number) = word.parse() {
        return Ok(number);
    }
    let name = word.strip_prefix("Ok(").or_else(|| word.strip_prefix("Err(")).unwrap_or(word);
    let name = name.trim_end_matches(')');
    let all = [
        Status::Ok,
        Status::Hold,
        Status::Saturated,
        Status::After,
        Status::Gated,
        Status::Late,
        Status::Infeasible,
        Status::Param,
        Status::Input,
        Status::Range,
        Status::Soon,
    ];
    let found = all.into_iter().find(|status| status.name() == name);
    let found = found.ok_or_else(|| anyhow!("no status {word:?}")).context("a line of calls")?;
    Ok(i64::from(found.number()))
}
