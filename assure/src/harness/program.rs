//! Controllers as programs that read records and write outcomes, on any machine.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use ptc_codegen::emit::Language;
use ptc_codegen::expression::Node;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::{After, Feedback, Reference, Spec, What};

use super::machine::Machine;
use super::rust::libraries;
use super::{STRICT, empty, in_pairs, run, write};

/// One call of each function: the run-time parameters in the order of the struct, the state at the
/// start where it is latched, t and x, all in the precision of the controller.
#[derive(Clone, Debug)]
pub struct Record {
    /// Run-time parameters.
    pub parameters: Vec<f64>,
    /// State at the start; empty where none is latched.
    pub x0: Vec<f64>,
    /// Time, s.
    pub t: f64,
    /// State x1..xn; behind it the reference and its derivatives, where each call is given them.
    pub x: Vec<f64>,
}

impl Record {
    /// The numbers of a record, in the order in which a program reads them.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        self.parameters.iter().chain(&self.x0).chain([&self.t]).chain(&self.x).copied()
    }
}

/// Results of `init`, `step`, and `tick` followed by `axis`, and of another `step` after `arm` at the same time with x
/// as the state at the start; or after `arm_for`, where there is one, for three quarters of tau. A result without a call is (0, 12345).
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// Status of `init`.
    pub init: i32,
    /// Status and u of `step`.
    pub step: (i32, f64),
    /// Status and u of `axis` after `tick`.
    pub axis: (i32, f64),
    /// Status and u of `step` after `arm`, or the status of `arm` where it refused.
    pub again: (i32, f64),
}

impl Outcome {
    /// Everything, u by its bits.
    pub fn bits(&self) -> (i32, [(i32, u64); 3]) {
        let bits = |(status, u): (i32, f64)| (status, u.to_bits());
        (self.init, [self.step, self.axis, self.again].map(bits))
    }
}

/// A compiled controller: one of those in a program.
pub struct Program {
    path: PathBuf,
    machine: Machine,
    /// Its place among the controllers of the program.
    index: usize,
    controllers: usize,
    precision: Precision,
}

impl Program {
    /// Runs the controller on every record.
    pub fn run(&self, records: &[Record]) -> Vec<Outcome> {
        let folder = empty(&self.path.with_extension(format!("{}.run", self.index)));
        let mut bytes = Vec::new();
        for index in 0..self.controllers {
            let own: &[Record] = if index == self.index { records } else { &[] };
            let count = u32::try_from(own.len()).expect("a number of records");
            bytes.extend(count.to_le_bytes());
            bytes.extend(as_bytes(own, self.precision));
        }
        fs::write(folder.join("records.bin"), bytes).expect("records");
        self.machine.run(&self.path, &folder);
        let output = fs::read(folder.join("outcomes.bin")).expect("outcomes");
        let outcomes = as_outcomes(&output, self.precision);
        assert_eq!(outcomes.len(), records.len(), "{}", self.path.display());
        outcomes
    }

    /// The file of the program.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Records as a program reads them.
pub(super) fn as_bytes(records: &[Record], precision: Precision) -> Vec<u8> {
    let numbers = records.iter().flat_map(Record::numbers);
    match precision {
        Precision::F64 => numbers.flat_map(f64::to_le_bytes).collect(),
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => numbers.flat_map(|number| (number as f32).to_le_bytes()).collect(),
    }
}

/// Outcomes as a program leaves them.
pub(super) fn as_outcomes(bytes: &[u8], precision: Precision) -> Vec<Outcome> {
    bytes.chunks_exact(16 + 3 * size(precision)).map(outcome).collect()
}

fn outcome(bytes: &[u8]) -> Outcome {
    let (statuses, numbers) = bytes.split_at(16);
    let status = |at: usize| {
        i32::from_le_bytes(statuses[4 * at..4 * at + 4].try_into().expect("four bytes"))
    };
    let size = numbers.len() / 3;
    let number = |at: usize| match numbers[at * size..(at + 1) * size].try_into() {
        Ok(bytes) => f64::from_le_bytes(bytes),
        Err(_) => f64::from(f32::from_le_bytes(
            numbers[at * size..(at + 1) * size].try_into().expect("four bytes"),
        )),
    };
    Outcome {
        init: status(0),
        step: (status(1), number(0)),
        axis: (status(2), number(1)),
        again: (status(3), number(2)),
    }
}

/// Bytes of a number.
pub(super) fn size(precision: Precision) -> usize {
    match precision {
        Precision::F64 => 8,
        Precision::F32 => 4,
    }
}

/// Numbers of a record.
pub(super) fn numbers(spec: &Spec) -> usize {
    let latched = if spec.latches() { spec.n } else { 0 };
    spec.run_time_parameters().count() + latched + 1 + spec.given()
}

/// Returns true if `tick` and `axis` are emitted.
pub fn has_gains(spec: &Spec) -> bool {
    spec.feedback == Feedback::Linear
        && spec
            .input_gain
            .as_ref()
            .is_none_or(|g| !g.any(&|e| matches!(e.node(), Node::Variable(_))))
        && spec.drift.is_none()
        && spec.model.is_none()
        && !matches!(spec.reference, Some(Reference::Known(_)))
        && spec.after == After::Hold
        && spec.what == What::Controller
}

/// The name of a precision, which is that of the type in Rust.
pub fn real(precision: Precision) -> &'static str {
    match precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    }
}

/// The programs of `specs` in C for this machine, in `folder`.
pub fn in_c(folder: &Path, specs: &[Spec]) -> Vec<Program> {
    in_c_on(Machine::Host, folder, specs, &STRICT.map(str::to_owned))
}

/// The programs of `specs` in C for `machine`, in `folder`, one for each spec, compiled with
/// `flags`.
pub fn in_c_on(machine: Machine, folder: &Path, specs: &[Spec], flags: &[String]) -> Vec<Program> {
    let numbered: Vec<_> = specs.iter().enumerate().collect();
    in_pairs(&numbered, |(index, spec)| {
        let folder = empty(&folder.join(format!("{}_c{index}", machine.stem())));
        let files = write(&folder, spec, Language::C);
        let sources: Vec<_> =
            files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "c")).collect();
        in_c_from(machine, &folder, spec, &sources, flags)
    })
}

/// The program of `sources`, which are those of `spec` or take their place.
pub fn in_c_from(
    machine: Machine,
    folder: &Path,
    spec: &Spec,
    sources: &[PathBuf],
    flags: &[String],
) -> Program {
    let name = spec.name();
    let mut glue = machine.c_compiler();
    glue.args(flags)
        .args(glue_arguments(folder, spec, &name, &format!("{name}.h")))
        .arg(driver("glue.c"))
        .args(sources)
        .args(main_arguments(folder, &[spec]))
        .args(machine.link_arguments())
        .arg("-lm")
        .arg("-o");
    let path = folder.join("program");
    run(glue.arg(&path));
    Program { path, machine, index: 0, controllers: 1, precision: spec.precision }
}

/// Returns the compiler arguments of the glue for a controller called `name` in the header `header`.
pub(super) fn glue_arguments(folder: &Path, spec: &Spec, name: &str, header: &str) -> Vec<String> {
    let yes = |condition: bool| u8::from(condition);
    let real = if spec.precision == Precision::F32 { "float" } else { "double" };
    vec![
        format!("-I{}", folder.display()),
        format!("-DHEADER=\"{header}\""),
        format!("-DNAME={name}"),
        "-DDRIVE=drive_0".to_owned(),
        format!("-DN={}", spec.n),
        format!("-DREFERENCES={}", spec.references()),
        format!("-DREAL={real}"),
        format!("-DPARAMS={}", spec.run_time_parameters().count()),
        format!("-DLATCHES={}", yes(spec.latches())),
        format!("-DIN_FLIGHT={}", yes(spec.changes_duration())),
        format!("-DLAW={}", yes(spec.feedback == Feedback::Extern)),
        format!("-DAFTER={}", yes(spec.after == After::Extern)),
        format!("-DAXIS={}", yes(has_gains(spec))),
        format!("-DRATE={}", yes(spec.what == What::Associated)),
    ]
}

impl Program {
    /// The program at `path` of one controller on this machine.
    pub(super) fn of_one(path: PathBuf, precision: Precision) -> Self {
        Self { path, machine: Machine::Host, index: 0, controllers: 1, precision }
    }
}

/// The programs of `specs` in Rust for this machine, in `folder`.
pub fn in_rust(folder: &Path, specs: &[Spec]) -> Vec<Program> {
    in_rust_on(Machine::Host, folder, specs)
}

/// The programs of `specs` in Rust for `machine`, in `folder`: one for each family, for a linker
/// takes longer than all of its controllers.
pub fn in_rust_on(machine: Machine, folder: &Path, specs: &[Spec]) -> Vec<Program> {
    let mut batches: Vec<Vec<&Spec>> = Vec::new();
    let mut places = Vec::new();
    for spec in specs {
        let same = |batch: &Vec<&Spec>| {
            batch[0].family() == spec.family() && batch[0].precision == spec.precision
        };
        let batch = batches.iter().position(same).unwrap_or_else(|| {
            batches.push(Vec::new());
            batches.len() - 1
        });
        places.push((batch, batches[batch].len()));
        batches[batch].push(spec);
    }
    let homes: Vec<_> = (0..batches.len())
        .map(|index| empty(&folder.join(format!("{}_rust{index}", machine.stem()))))
        .collect();
    let libraries = libraries(machine, &homes, &batches);
    let work: Vec<_> = batches.iter().zip(&homes).zip(libraries).collect();
    let paths = in_pairs(&work, |((batch, home), library)| {
        let path = home.join("program");
        let mut linker = machine.c_compiler();
        linker.args(["-std=c99", "-O2"]).args(main_arguments(home, batch)).arg(library);
        run(linker.args(machine.link_arguments()).arg("-lm").arg("-o").arg(&path));
        path
    });
    let program = |(spec, (batch, index)): (&Spec, (usize, usize))| Program {
        path: paths[batch].clone(),
        machine,
        index,
        controllers: batches[batch].len(),
        precision: spec.precision,
    };
    specs.iter().zip(places).map(program).collect()
}

/// A file of the driver.
pub(crate) fn driver(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/harness/driver").join(file)
}

/// The arguments that compile the main program over the functions `drive_0`, `drive_1`, ... of
/// `specs`; writes its table to `folder`.
pub(super) fn main_arguments(folder: &Path, specs: &[&Spec]) -> Vec<String> {
    let (mut declarations, mut entries) = (String::new(), String::new());
    for (index, spec) in specs.iter().enumerate() {
        let (numbers, size) = (numbers(spec), size(spec.precision));
        let _ = writeln!(
            declarations,
            "void drive_{index}(const void *record, int32_t status[3], void *u);"
        );
        let _ = writeln!(entries, "    {{ drive_{index}, {numbers}u, {size}u }},");
    }
    let longest = specs.iter().map(|spec| numbers(spec)).max().unwrap_or_default();
    let table = folder.join("table.h");
    let text = format!(
        "{declarations}static const controller table[] = {{\n{entries}}};\n#define LONGEST {longest}\n"
    );
    fs::write(&table, text).expect("a table");
    vec![
        format!("-DTABLE=\"{}\"", table.display()),
        driver("main.c").to_string_lossy().into_owned(),
    ]
}
