//! Projects built as a user builds them, and run: on this machine and under QEMU.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use ptc_codegen::request::Spec;

use super::command::{emit, generator};
use crate::context::Context;
use crate::harness::command::{succeed, text};
use crate::harness::in_pairs;
use crate::harness::specs::{calls_a_library, spec};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ARM_GCC, GCC, NEWLIB, QEMU_ARM, RUSTC, ShownBy, Source, Tool};

pub(super) const CMAKE: Tool = Tool {
    name: "cmake",
    shown_by: ShownBy::Command(&["cmake", "--version"]),
    source: Source::Apt(&["cmake", "make"]),
};

const RUST_ARM: Tool = Tool {
    name: "Rust for thumbv7em-none-eabihf",
    shown_by: ShownBy::Command(&[
        "sh",
        "-c",
        "test -d \"$(rustc --print sysroot)/lib/rustlib/thumbv7em-none-eabihf/lib\"",
    ]),
    source: Source::Rustup(&["target", "add", "thumbv7em-none-eabihf"]),
};

pub(super) const LAYER: Layer = Layer {
    name: "projects",
    claim: "The projects build as they are written; their closed loops arrive at the deadline, on a \
            Cortex-M4F as on this machine.",
    tools: &[GCC, CMAKE, ARM_GCC, NEWLIB, QEMU_ARM, RUSTC, RUST_ARM],
    run,
};

/// The designs: the default, all fixed in single precision, functions and states that are latched; in
/// samples all open, an observer of a chain in single precision, and one of another plant; axes with either clock.
fn designs() -> Vec<Spec> {
    vec![
        spec(&[("n", "2"), ("mu", "exp"), ("name", "stage")]),
        spec(&[
            ("n", "3"),
            ("mu", "tan(a=2)"),
            ("name", "turret"),
            ("precision", "f32"),
            ("gains", "360,222,39"),
            ("tau", "2"),
            ("t0", "1"),
            ("eps", "0.1"),
            ("u_max", "inf"),
        ]),
        spec(&[("n", "4"), ("mu", "tanh"), ("name", "boom"), ("after", "zero")]),
        spec(&[("n", "2"), ("mu", "exp_sum"), ("name", "sluice")]),
        spec(&[("n", "2"), ("mu", "exp(a=1)"), ("name", "lift"), ("pi0", "-12*xi1-7*xi2+0*xi1_0")]),
        spec(&[("n", "3"), ("mu", "exp"), ("name", "gantry"), ("clock", "samples")]),
        spec(&[
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("name", "slide"),
            ("clock", "samples"),
            ("precision", "f32"),
            ("sample_time", "1e-3"),
            ("tau", "0.8"),
            ("delay", "1"),
            ("poles", "-4,-5,-6"),
            ("measured", "x1"),
            ("observer_poles", "-4,-5,-6"),
            ("disturbance", "constant"),
            ("u_max", "6"),
            ("after", "zero"),
        ]),
        spec(&[
            ("A", "[[0,1,0],[0,-2,5],[0,-1,-40]]"),
            ("B", "[0,0,40]"),
            ("C", "[1,0,0]"),
            ("mu", "exp(a=1)"),
            ("name", "motor"),
            ("clock", "samples"),
            ("sample_time", "1e-3"),
            ("tau", "0.4"),
            ("poles", "-5,-6,-7"),
            ("observer_poles", "-4,-5,-6"),
        ]),
        spec(&[
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("name", "portal"),
            ("axes", "3"),
            ("poles", "[[-4,-5],[-5,-6],[-6,-7]]"),
            ("g", "[1,-2,0.5]"),
            ("sample_time", "1e-3"),
        ]),
        spec(&[
            ("n", "3"),
            ("mu", "exp"),
            ("name", "hexapod"),
            ("axes", "2"),
            ("clock", "samples"),
            ("g", "[0.5,2]"),
        ]),
    ]
}

/// A way to build and run a project: its kind, and what it prints from the folder of the project.
struct Way {
    kind: &'static str,
    run: fn(&Path) -> Result<String>,
}

const WAYS: [Way; 3] = [
    Way { kind: "cmake", run: cmake },
    Way { kind: "cortex-m", run: cortex_m },
    Way { kind: "rust-embedded", run: rust_embedded },
];

/// Configures, builds, tests and installs the library, and builds another project that finds it.
fn cmake(folder: &Path) -> Result<String> {
    let name = fs::read_dir(folder.join("src"))?.next().context("a source")??.path();
    let name = name.file_stem().and_then(|stem| stem.to_str()).context("a name")?.to_owned();
    let cmake =
        |arguments: &[&str]| succeed(Command::new("cmake").args(arguments).current_dir(folder));
    cmake(&["-B", "build", "-DCMAKE_BUILD_TYPE=Release"])?;
    cmake(&["--build", "build"])?;
    let test = ["--test-dir", "build", "--output-on-failure"];
    let tested = text(Command::new("ctest").args(test).current_dir(folder))?;
    ensure!(tested.contains("100% tests passed"), "{tested}");
    cmake(&["--install", "build", "--prefix", "installed"])?;
    let user = folder.join("user");
    fs::create_dir_all(&user)?;
    fs::write(
        user.join("CMakeLists.txt"),
        format!(
            "cmake_minimum_required(VERSION 3.15)\nproject(user LANGUAGES C)\n\
             find_package({name} 1.0 REQUIRED)\nadd_executable(user ../example/main.c)\n\
             target_link_libraries(user PRIVATE {name}::{name})\n"
        ),
    )?;
    let prefix = format!("-DCMAKE_PREFIX_PATH={}", folder.join("installed").display());
    cmake(&["-S", "user", "-B", "user/build", &prefix])?;
    cmake(&["--build", "user/build"])?;
    text(&mut Command::new(folder.join("user/build/user")))
}

fn cortex_m(folder: &Path) -> Result<String> {
    succeed(Command::new("make").current_dir(folder))?;
    text(Command::new("timeout").args(["60", "make", "--silent", "run"]).current_dir(folder))
}

fn rust_embedded(folder: &Path) -> Result<String> {
    let cargo = |words: &[&str]| {
        let mut command = Command::new("timeout");
        command.arg("600").arg("cargo").args(words).current_dir(folder);
        // One for all projects, as their crates are the same.
        let target = folder.parent().map(|parent| parent.join("rust-target"));
        command.env("CARGO_TARGET_DIR", target.unwrap_or_default());
        command
    };
    text(&mut cargo(&["run", "--quiet", "--release"]))
}

/// The last line of a run, where it says that the state has arrived.
fn arrived(printed: &str) -> Option<&str> {
    printed.lines().last().filter(|line| line.starts_with("arrived: |x| = "))
}

/// The rows of the table as numbers: C and Rust print exponents differently.
fn rows(printed: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split_whitespace().map_while(|word| word.parse().ok()).collect();
    printed.lines().map(row).filter(|row: &Vec<f64>| row.len() > 2).collect()
}

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("projects");
    let generator = generator()?;
    let mut finding = Finding::default();
    let designs = designs();
    let mut table = Vec::new();
    let mut built = 0;
    let crates = crates(&folder, &generator, &designs[0])?;
    for spec in &designs {
        let mut reference: Option<Vec<Vec<f64>>> = None;
        for way in WAYS {
            let named = format!("{}, {}", spec.name(), way.kind);
            if way.kind == "rust-embedded" && !crates {
                table.push(vec![
                    named,
                    "NOT RUN: its crates cannot be had".to_owned(),
                    String::new(),
                ]);
                continue;
            }
            let home = project(&folder, &generator, way.kind, spec)?;
            let printed = match (way.run)(&home) {
                Ok(printed) => printed,
                Err(error) => {
                    finding.failures.push(format!("{named}: {error:#}"));
                    continue;
                }
            };
            built += 1;
            let own = rows(&printed);
            let Some(line) = arrived(&printed) else {
                finding.failures.push(format!("{named} does not arrive:\n{printed}"));
                continue;
            };
            let first = reference.get_or_insert_with(|| own.clone());
            let same = if own == *first { "the same" } else { "not the same" };
            if own != *first && !calls_a_library(spec) {
                finding.failures.push(format!("{named} prints another table than this machine"));
            }
            table.push(vec![named, line.to_owned(), same.to_owned()]);
        }
    }
    finding.summary = format!("{built} projects built and run, {} faults", finding.failures.len());
    finding.tables.push(Table {
        title: "What the projects print last".to_owned(),
        head: vec!["project", "last line", "table printed on this machine"],
        rows: table,
    });
    finding.notes.push(
        "The default design is the first, `stage`. Firmware runs under QEMU on the machine \
         mps2-an386; the CMake library is installed, and run from a project that finds it there. \
         Arduino's tools cannot be had here: the library's files and properties are checked, and the \
         sketch is compiled by g++ against a header in place of Arduino's and run, in \
         `ptc-codegen/tests/command/projects`."
            .to_owned(),
    );
    seed(context, &folder, &generator, crates, &mut finding)?;
    Ok(finding)
}

/// The folder of a new project.
fn project(folder: &Path, generator: &Path, kind: &str, spec: &Spec) -> Result<PathBuf> {
    let home = folder.join(format!("{}_{kind}", spec.name()));
    let _ = fs::remove_dir_all(&home);
    emit(generator, &format!("--project {kind}"), spec, &home)?;
    Ok(home)
}

/// Returns true if the crates of the firmware in Rust can be fetched.
fn crates(folder: &Path, generator: &Path, spec: &Spec) -> Result<bool> {
    let home = project(folder, generator, "rust-embedded", spec)?;
    Ok(succeed(Command::new("cargo").arg("fetch").current_dir(&home)).is_ok())
}

/// A defect: the kind of project, the file, what is replaced in it, by what, and what it is.
const DEFECTS: [[&str; 5]; 6] = [
    [
        "cortex-m",
        "src/stage.c",
        "built.c1 = c1;",
        "built.c1 = -c1;",
        "a wrong sign in the C controller",
    ],
    [
        "rust-embedded",
        "src/stage.rs",
        "let c1 = -",
        "let c1 = ",
        "a wrong sign in the Rust controller",
    ],
    [
        "cortex-m",
        "src/startup.c",
        "*coprocessors |= 0xFu << 20;",
        "",
        "start-up code without the FPU",
    ],
    ["cortex-m", "linker.ld", "KEEP(*(.vectors))", "", "no vectors in front of the code"],
    ["cmake", "src/stage.c", "built.c2 = c2;", "built.c2 = 0.0;", "a gain left out of the library"],
    ["rust-embedded", "memory.x", "0x20000000", "0x60000000", "RAM where the machine has none"],
];

fn seed(
    context: &Context,
    folder: &Path,
    generator: &Path,
    crates: bool,
    finding: &mut Finding,
) -> Result<()> {
    let spec = spec(&[("n", "2"), ("mu", "exp"), ("name", "stage")]);
    let there = DEFECTS.into_iter().filter(|[kind, ..]| crates || *kind != "rust-embedded");
    let there = context.in_turn(there.collect());
    let caught = in_pairs(&there, |[kind, file, good, bad, _]| -> Result<Option<String>> {
        let name = format!("seeded_{kind}_{}", file.replace('/', "_"));
        let home = folder.join(name);
        let _ = fs::remove_dir_all(&home);
        emit(generator, &format!("--project {kind}"), &spec, &home)?;
        let path = home.join(file);
        let text = fs::read_to_string(&path)?;
        ensure!(text.contains(good), "{kind}, {file}: no text `{good}` to put the defect in");
        fs::write(&path, text.replacen(good, bad, 1))?;
        let way = WAYS.iter().find(|way| way.kind == *kind).context("a way")?;
        Ok(match (way.run)(&home) {
            Ok(printed) if arrived(&printed).is_some() => None,
            Ok(printed) => Some(printed.lines().last().unwrap_or_default().to_owned()),
            Err(error) => {
                let told = format!("{error:#}");
                let late = told.lines().find(|line| line.trim_start().starts_with("late: "));
                Some(late.unwrap_or("it does not run to its end").trim_start().to_owned())
            }
        })
    });
    for ([.., defect], caught) in there.iter().zip(caught) {
        finding.seed(defect, caught?);
    }
    Ok(())
}
