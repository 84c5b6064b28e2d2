//! Cost of one step on a machine: instructions under QEMU over the self-test, which takes every branch, and stack and
//! code as the compiler reports them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, anyhow, ensure};
use ptc_codegen::controller::measured::Measured;
use ptc_codegen::request::Spec;

use super::command::{succeed, text};
use super::machine::Machine;
use super::selftest::main_program;

/// The flags of the measured code.
const FLAGS: [&str; 3] = ["-std=c99", "-O2", "-ffp-contract=off"];

/// The plugin that counts, compiled into `folder`.
pub fn plugin(folder: &Path) -> Result<PathBuf> {
    let path = folder.join("count.so");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("device/count.c");
    succeed(Command::new("gcc").args(["-shared", "-fPIC", "-O2", "-o"]).arg(&path).arg(source))?;
    Ok(path)
}

/// Measures the cost of a step of the controller in `sources` on `machine`.
pub fn measure(
    machine: Machine,
    plugin: &Path,
    spec: &Spec,
    sources: &[PathBuf; 2],
) -> Result<Measured> {
    let folder = sources[0].parent().context("a folder of the source")?;
    let step = format!("{}_step", spec.name());
    let object = folder.join(format!("{}.o", machine.stem()));
    let mut compiler = machine.c_compiler();
    compiler.args(FLAGS).args(["-fstack-usage", "-ffunction-sections", "-c"]).arg(&sources[0]);
    succeed(compiler.arg("-o").arg(&object))?;
    let main = main_program(folder, spec)?;
    let program = folder.join(machine.stem());
    let mut compiler = machine.c_compiler();
    compiler.args(FLAGS).args([&object, &sources[1], &main]).args(machine.link_arguments());
    succeed(compiler.arg("-lm").arg("-o").arg(&program))?;
    let begin = symbol(machine, &program, &step)?.0;
    let arguments = ["-plugin".to_owned(), format!("{},begin={begin}", plugin.display())];
    let arguments = arguments.each_ref().map(String::as_str);
    // The plugin prints to the standard error.
    let run = succeed(machine.command(&program, &arguments).current_dir(folder))?;
    let told = String::from_utf8_lossy(&run.stderr);
    let field = |key: &str| {
        let text = told.split_whitespace().find_map(|word| word.strip_prefix(key));
        text.and_then(|text| text.parse::<u64>().ok()).with_context(|| format!("{key} in `{told}`"))
    };
    ensure!(field("calls=")? > 0, "no call of {step} was seen");
    Ok(Measured {
        target: machine.name().to_owned(),
        instructions: field("most=")?,
        stack: stack(&object.with_extension("su"), &step)?,
        code: symbol(machine, &object, &step)?.1,
        command: spec.command(),
    })
}

/// Address and size of a function in an object or a program.
fn symbol(machine: Machine, file: &Path, name: &str) -> Result<(u64, u64)> {
    let told = text(Command::new(machine.nm()).args(["-S", "--radix=d"]).arg(file))?;
    let line = told.lines().find(|line| line.split_whitespace().nth(3) == Some(name));
    let line = line.with_context(|| format!("no function {name} in {}", file.display()))?;
    let mut numbers = line.split_whitespace().map(str::parse::<u64>);
    match (numbers.next(), numbers.next()) {
        (Some(Ok(address)), Some(Ok(size))) => Ok((address, size)),
        _ => Err(anyhow!("`{line}` names no address and size")),
    }
}

/// Bytes of stack of a function, as -fstack-usage has them.
fn stack(file: &Path, name: &str) -> Result<u64> {
    let text = fs::read_to_string(file).with_context(|| file.display().to_string())?;
    let line = text.lines().find(|line| {
        line.split('\t').next().is_some_and(|place| place.ends_with(&format!(":{name}")))
    });
    let bytes = line.and_then(|line| line.split('\t').nth(1)).and_then(|bytes| bytes.parse().ok());
    bytes.with_context(|| format!("no stack of {name} in {}", file.display()))
}
