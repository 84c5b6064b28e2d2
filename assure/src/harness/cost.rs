//! What one step costs on a machine: instructions under QEMU over the self-test, which takes every
//! branch, and the compiler's word for stack and code.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, anyhow, ensure};
use ptc_codegen::emit::Language;
use ptc_codegen::emit::measured::Measured;
use ptc_codegen::spec::{Spec, What};

use super::machine::Machine;
use super::{empty, write};

/// The flags of the measured code.
const FLAGS: [&str; 3] = ["-std=c99", "-O2", "-ffp-contract=off"];

/// The plugin that counts, compiled into `folder`.
pub fn plugin(folder: &Path) -> Result<PathBuf> {
    let path = folder.join("count.so");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("device/count.c");
    succeed(Command::new("gcc").args(["-shared", "-fPIC", "-O2", "-o"]).arg(&path).arg(source))?;
    Ok(path)
}

/// Writes controller and self-test of `spec` to `folder`: the sources, controller first.
pub fn sources(folder: &Path, spec: &Spec) -> Result<[PathBuf; 2]> {
    ensure!(spec.what == What::Controller, "the infinite-time system has no step to measure");
    write(&empty(folder), spec, Language::C);
    let files = ptc_codegen::generate_selftest(spec)
        .map_err(|found| anyhow!("{}", found.first().map_or("", |one| &one.message)))?;
    for file in files {
        fs::write(folder.join(file.name), file.text)?;
    }
    let name = spec.name();
    Ok([folder.join(format!("{name}.c")), folder.join(format!("{name}_selftest.c"))])
}

/// What a step of the controller in `sources` costs on `machine`.
pub fn measure(
    machine: Machine,
    plugin: &Path,
    spec: &Spec,
    sources: &[PathBuf; 2],
) -> Result<Measured> {
    let folder = sources[0].parent().context("a folder of the source")?;
    let step = format!("{}_step", spec.name());
    let object = folder.join(format!("{}.o", machine.stem()));
    let compile = machine
        .c_compiler()
        .args(FLAGS)
        .args(["-fstack-usage", "-ffunction-sections", "-c"])
        .arg(&sources[0])
        .arg("-o")
        .arg(&object)
        .output()?;
    ensure!(compile.status.success(), "{}", String::from_utf8_lossy(&compile.stderr));
    let main = folder.join("main.c");
    let name = spec.name();
    let text = format!(
        "#include \"{name}_selftest.h\"\n\nint main(void)\n{{\n    return ({name}_selftest() == 0U) ? 0 : 1;\n}}\n"
    );
    fs::write(&main, text)?;
    let program = folder.join(machine.stem());
    let mut compiler = machine.c_compiler();
    compiler.args(FLAGS).args([&object, &sources[1], &main]).args(machine.link_arguments());
    succeed(compiler.arg("-lm").arg("-o").arg(&program))?;
    let begin = symbol(machine, &program, &step)?.0;
    let arguments = ["-plugin".to_owned(), format!("{},begin={begin}", plugin.display())];
    let arguments = arguments.each_ref().map(String::as_str);
    let told = succeed(machine.command(&program, &arguments).current_dir(folder))?;
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
    let told = succeed(Command::new(machine.nm()).args(["-S", "--radix=d"]).arg(file))?;
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

/// Runs a command that must succeed; its output, that of errors included.
fn succeed(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("{command:?}"))?;
    let told =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    ensure!(output.status.success(), "{command:?}: {}\n{}", output.status, told[1]);
    Ok(told.concat())
}
