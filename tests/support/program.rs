//! One controller as a program that reads records and writes outcomes.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ptc_codegen::emit::Language;
use ptc_codegen::spec::{Parameter, Precision, Spec};

use super::{STRICT, c_compiler, in_pairs, run, rustc, write};

/// One call of each function: the run-time parameters in the order of the struct, t and x, all in
/// the precision of the controller.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) parameters: Vec<f64>,
    pub(crate) t: f64,
    pub(crate) x: Vec<f64>,
}

/// What `init`, `step`, and `tick` followed by `axis` gave.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    pub(crate) init: i32,
    pub(crate) step: (i32, f64),
    pub(crate) axis: (i32, f64),
}

impl Outcome {
    /// Everything, u by its bits.
    pub(crate) fn bits(&self) -> (i32, (i32, u64), (i32, u64)) {
        let bits = |(status, u): (i32, f64)| (status, u.to_bits());
        (self.init, bits(self.step), bits(self.axis))
    }
}

/// A compiled controller.
pub(crate) struct Program {
    path: PathBuf,
    /// The argument that picks it, in a program of several.
    argument: Option<String>,
    precision: Precision,
}

impl Program {
    /// Runs the controller on every record.
    pub(crate) fn run(&self, records: &[Record]) -> Vec<Outcome> {
        let input = self.path.with_extension(match &self.argument {
            Some(argument) => format!("{argument}.bin"),
            None => "bin".to_owned(),
        });
        let numbers = records.iter().flat_map(|r| r.parameters.iter().chain([&r.t]).chain(&r.x));
        #[allow(clippy::cast_possible_truncation)]
        let bytes: Vec<u8> = match self.precision {
            Precision::F64 => numbers.flat_map(|number| number.to_le_bytes()).collect(),
            Precision::F32 => numbers.flat_map(|number| (*number as f32).to_le_bytes()).collect(),
        };
        fs::write(&input, bytes).expect("records");
        let mut command = Command::new(&self.path);
        command.args(&self.argument).stdin(File::open(&input).expect("records"));
        let output = run(command.stderr(Stdio::piped()));
        let size = match self.precision {
            Precision::F64 => 8,
            Precision::F32 => 4,
        };
        let outcomes: Vec<_> = output.chunks_exact(12 + 2 * size).map(outcome).collect();
        assert_eq!(outcomes.len(), records.len(), "{command:?}");
        outcomes
    }
}

fn outcome(bytes: &[u8]) -> Outcome {
    let (statuses, numbers) = bytes.split_at(12);
    let status = |at: usize| {
        i32::from_le_bytes(statuses[4 * at..4 * at + 4].try_into().expect("four bytes"))
    };
    let size = numbers.len() / 2;
    let number = |at: usize| match numbers[at * size..(at + 1) * size].try_into() {
        Ok(bytes) => f64::from_le_bytes(bytes),
        Err(_) => f64::from(f32::from_le_bytes(
            numbers[at * size..(at + 1) * size].try_into().expect("four bytes"),
        )),
    };
    Outcome { init: status(0), step: (status(1), number(0)), axis: (status(2), number(1)) }
}

/// The programs of `specs` in C, in `folder`.
pub(crate) fn in_c(folder: &Path, specs: &[Spec]) -> Vec<Program> {
    let driver = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/support/driver.c");
    let numbered: Vec<_> = specs.iter().enumerate().collect();
    in_pairs(&numbered, |(index, spec)| {
        let folder = folder.join(format!("c{index}"));
        fs::create_dir_all(&folder).expect("a folder");
        let files = write(&folder, spec, Language::C);
        let name = spec.name();
        let path = folder.join("program");
        let real = match spec.precision {
            Precision::F64 => "double",
            Precision::F32 => "float",
        };
        let mut command = c_compiler();
        command
            .args(STRICT)
            .arg("-I")
            .arg(&folder)
            .arg(format!("-DHEADER=\"{name}.h\""))
            .arg(format!("-DNAME={name}"))
            .arg(format!("-DN={}", spec.n))
            .arg(format!("-DREAL={real}"))
            .arg(format!("-DPARAMS={}", spec.run_time_parameters().count()))
            .arg(&driver)
            .args(files.iter().filter(|file| file.extension().is_some_and(|e| e == "c")))
            .arg("-o")
            .arg(&path)
            .arg("-lm");
        run(&mut command);
        Program { path, argument: None, precision: spec.precision }
    })
}

/// The programs of `specs` in Rust, in `folder`: one for each family, for a linker takes longer
/// than all of its controllers.
pub(crate) fn in_rust(folder: &Path, specs: &[Spec]) -> Vec<Program> {
    let mut batches: Vec<Vec<usize>> = Vec::new();
    for (index, spec) in specs.iter().enumerate() {
        let same = |batch: &&mut Vec<usize>| specs[batch[0]].family() == spec.family();
        match batches.iter_mut().find(same) {
            Some(batch) => batch.push(index),
            None => batches.push(vec![index]),
        }
    }
    let paths = in_pairs(&batches, |batch| {
        let path = folder.join(format!("rust{}", batch[0]));
        fs::write(path.with_extension("rs"), program(folder, specs, batch)).expect("a program");
        run(rustc()
            .args(["-O", "-Ccodegen-units=1"])
            .arg(path.with_extension("rs"))
            .arg("-o")
            .arg(&path));
        path
    });
    let program = |(index, spec): (usize, &Spec)| {
        let batch = batches.iter().position(|batch| batch.contains(&index)).expect("a batch");
        Program {
            path: paths[batch].clone(),
            argument: Some(index.to_string()),
            precision: spec.precision,
        }
    };
    specs.iter().enumerate().map(program).collect()
}

/// The text of a program of the specs in `batch`.
fn program(folder: &Path, specs: &[Spec], batch: &[usize]) -> String {
    let mut text = include_str!("driver.rs").to_owned();
    let mut arms = String::new();
    for index in batch {
        let spec = &specs[*index];
        let home = folder.join(format!("r{index}"));
        fs::create_dir_all(&home).expect("a folder");
        let file = write(&home, spec, Language::Rust).remove(0);
        let module = format!("c{index}");
        // A program uses less of each module than a crate would offer.
        writeln!(text, "#[allow(dead_code)]\n#[path = {file:?}]\nmod {module};").expect("text");
        let type_name = spec.type_name();
        let real = real(spec.precision);
        let (n, count) = (spec.n, spec.run_time_parameters().count());
        let fields = fields(spec);
        writeln!(
            arms,
            "        Some(\"{index}\") => drive!({module}, {type_name}, {real}, {n}, {count}, \
             |next| {module}::{type_name}Params {{ {fields} }}),"
        )
        .expect("text");
    }
    format!(
        "{text}\nfn main() {{\n    match std::env::args().nth(1).as_deref() {{\n{arms}        \
         _ => panic!(\"no such controller\"),\n    }}\n}}\n"
    )
}

/// The name of a precision, which is that of the type in Rust.
pub(crate) fn real(precision: Precision) -> &'static str {
    match precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    }
}

/// The fields of the parameters, each taking the next number.
fn fields(spec: &Spec) -> String {
    let free: Vec<_> = spec.run_time_parameters().collect();
    let scalar = |p: &&Parameter| p.index().is_none();
    let mut fields: Vec<_> =
        free.iter().filter(scalar).map(|p| format!("{}: next()", p.key())).collect();
    for key in ["rates", "k"] {
        let count = free.iter().filter(|p| p.key() == key).count();
        if count > 0 {
            fields.push(format!("{key}: [{}]", vec!["next()"; count].join(", ")));
        }
    }
    fields.join(", ")
}
