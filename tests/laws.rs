//! Controllers with laws and mappings of the user's own: C, Rust and the interpreter give the same
//! bits and statuses, for latched states, input gains, functions of the user's, and after the
//! deadline.

mod support;

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ptc_codegen::emit::Language;
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program, passes};
use ptc_codegen::spec::{After, Feedback, Parameter, Precision, Spec};
use support::program::real;
use support::random::Random;
use support::specs::{rounded, spec};
use support::{STRICT, c_compiler, folder, in_pairs, run, rustc, write};

const RECORDS: usize = 400;

/// Only functions that every library rounds alike, so that bits can be compared.
fn specs() -> Vec<Spec> {
    let kinds: [&[(&str, &str)]; 12] = [
        &[
            ("n", "1"),
            ("mu", "exp(a=1)"),
            ("pi0", "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2"),
            ("g", "1"),
        ],
        &[
            ("n", "2"),
            ("mu", "rational"),
            ("pi0", "-k1*xi1 - k2*xi2*abs(xi2) - sign(xi1)"),
            ("g", "2 + x1*x1/(1 + x1*x1)"),
        ],
        &[("n", "3"), ("mu", "tanh"), ("pi0", "extern"), ("after", "zero")],
        &[
            ("n", "2"),
            ("mu", "algebraic"),
            ("pi0", "max(min(-xi1 - xi2, 3), x1_0 - t0 - dt)"),
            ("after", "extern"),
        ],
        &[("n", "3"), ("kappa", "dt/(a*(tau - dt))"), ("g", "x1"), ("guard", "result")],
        &[("n", "4"), ("kappa", "dt/(a*(tau - dt)) + (dt/tau)^3"), ("guard", "none")],
        &[("n", "3"), ("mu", "tau*(1 - exp(-a*t))"), ("g", "-0.5"), ("precision", "f32")],
        &[
            ("n", "2"),
            ("mu", "mean(rational(a=1), rational(a=b))"),
            ("pi0", "-xi1 - 2*xi2*xi1_0"),
            ("precision", "f32"),
            ("after", "zero"),
        ],
        &[
            ("n", "2"),
            ("mu", "power(m=2)"),
            ("pi0", "extern"),
            ("after", "extern"),
            ("precision", "f32"),
        ],
        &[("n", "2"), ("mu", "exp"), ("g", "gain"), ("after", "zero"), ("u_max", "inf")],
        &[("n", "1"), ("mu", "tau*a*t/sqrt(1 + (a*t)^2)"), ("u_max", "inf")],
        &[
            ("n", "2"),
            ("mu", "exp"),
            ("tau", "2"),
            ("t0", "0"),
            ("eps", "0.01"),
            ("u_max", "5"),
            ("poles", "-4,-5"),
            ("params.a", "1"),
            ("g", "2"),
        ],
    ];
    kinds
        .iter()
        .enumerate()
        .map(|(index, keys)| {
            let name = format!("law{index}_of_mine");
            let mut keys = keys.to_vec();
            keys.push(("name", &name));
            spec(&keys)
        })
        .collect()
}

/// Whether a spec iterates with logarithms, whose last bit depends on the library.
fn calls_a_library(spec: &Spec) -> bool {
    spec.is_iterated()
}

/// One call: parameters, the latched state, time and state.
#[derive(Clone, Debug)]
struct Record {
    parameters: Vec<f64>,
    x0: Vec<f64>,
    t: f64,
    x: Vec<f64>,
}

fn records(spec: &Spec, random: &mut Random) -> Vec<Record> {
    let round = |value| rounded(value, spec.precision);
    let mut records = Vec::new();
    for _ in 0..RECORDS {
        let tau = if spec.fixed.contains_key(&Parameter::Tau) { 2.0 } else { 3.0 };
        let t0 = if spec.fixed.contains_key(&Parameter::StartTime) { 0.0 } else { 1.5 };
        let mut value = |p: Parameter| match p {
            Parameter::Tau => tau,
            Parameter::StartTime => t0,
            Parameter::Eps => 0.01,
            Parameter::UMax => 50.0,
            _ => random.between(0.5, 2.5),
        };
        let parameters: Vec<_> = spec.run_time_parameters().map(|p| round(value(p))).collect();
        let state = |random: &mut Random| match random.below(20) {
            0 => 0.0,
            1 => f64::NAN,
            _ => round(random.sign() * random.magnitude(1e-2, 10.0)),
        };
        let finite = |x: f64| if x.is_nan() { 1.0 } else { x };
        let x0: Vec<_> = (0..spec.n).map(|_| finite(state(random))).collect();
        let trusting = spec.guard == ptc_codegen::spec::Guard::None;
        let x = (0..spec.n)
            .map(|_| {
                let x = state(random);
                if trusting { finite(x) } else { x }
            })
            .collect();
        let t = round(
            t0 + tau
                * match random.below(6) {
                    0 => 1.0,
                    1 => 1.0 + random.magnitude(1e-3, 1e3),
                    2 => 1.0 - random.magnitude(1e-6, 1e-2),
                    3 => 0.0,
                    _ => random.between(0.0, 1.0),
                },
        );
        records.push(Record { parameters, x0, t, x });
    }
    records
}

/// Status and u: `-1` for what `init` refuses.
type Outcome = (i32, u64);

const LAW: [f64; 2] = [-1.5, 0.125];

/// The law that stands for a user's: -1.5 (xi_1 + ... + xi_n) + t/8.
fn user_law(arguments: &[f64], precision: Precision) -> f64 {
    let settle = |x| rounded(x, precision);
    let (time, xi) = arguments.split_last().expect("time comes last");
    let sum = xi.iter().fold(0.0, |sum, xi| settle(sum + settle(LAW[0] * xi)));
    settle(sum + settle(LAW[1] * time))
}

fn interpreted(program: &Program, spec: &Spec, record: &Record) -> Outcome {
    let parameter = |p: Parameter| {
        let at = spec.run_time_parameters().position(|own| own == p);
        at.map_or(0.0, |at| record.parameters[at])
    };
    let input = |input| match input {
        Input::Parameter(p) => parameter(p),
        Input::StartTime if spec.fixed.contains_key(&Parameter::StartTime) => 0.0,
        Input::StartTime => parameter(Parameter::StartTime),
        Input::Time => record.t,
        Input::State(j) => record.x[j - 1],
        Input::StateAtStart(j) => record.x0[j - 1],
        Input::Gain(_) | Input::Drift => f64::NAN,
    };
    if spec.guard == ptc_codegen::spec::Guard::Full && record.x.iter().any(|x| x.is_nan()) {
        return (-2, 0);
    }
    let law = |arguments: &[f64]| user_law(arguments, spec.precision);
    let mut interpreter = Interpreter::new(program, &input).with_law(&law);
    let mut u = interpreter.value(program.step);
    let limits = program.limits;
    let over = limits.past.is_some_and(|past| interpreter.value(past) >= 0.0);
    if over {
        u = if spec.after == After::Extern { -record.x[0] } else { 0.0 };
    }
    if spec.guard == ptc_codegen::spec::Guard::Result && record.x.iter().any(|x| x.is_nan()) {
        return (-3, 0);
    }
    let held = interpreter.value(limits.late) >= interpreter.value(limits.hold_from);
    match limits.u_max.map(|limit| interpreter.value(limit)) {
        Some(limit) if u > limit => (2, limit.to_bits()),
        Some(limit) if u < -limit => (2, (-limit).to_bits()),
        _ if !u.is_finite() => (-3, 0),
        _ => (if over { 3 } else { i32::from(held) }, u.to_bits()),
    }
}

/// Names and array lengths of the fields of the parameters, in order.
fn fields(spec: &Spec) -> Vec<(String, Option<usize>)> {
    spec.run_time_parameters().map(|p| (p.key().to_owned(), p.index())).collect()
}

fn in_c(folder: &Path, spec: &Spec) -> PathBuf {
    let (name, n) = (spec.name(), spec.n);
    let real = if spec.precision == Precision::F32 { "float" } else { "double" };
    let mut set = String::new();
    for (at, (field, index)) in fields(spec).iter().enumerate() {
        let index = index.map(|i| format!("[{i}]")).unwrap_or_default();
        let _ = writeln!(set, "        params.{field}{index} = (REAL)v[{at}];");
    }
    let count = fields(spec).len();
    let latch = if spec.latches() { ", x0" } else { "" };
    let mut externs = String::new();
    if spec.feedback == Feedback::Extern {
        externs.push_str(", law");
    }
    if spec.after == After::Extern {
        externs.push_str(", after");
    }
    if !externs.is_empty() {
        externs.push_str(", &context");
    }
    let text = format!(
        "#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n#include \"{name}.h\"\n\
         typedef {real} REAL;\n\
         REAL law(void *context, const REAL xi[{n}], REAL t);\n\
         REAL after(void *context, const REAL x[{n}], REAL t);\n\
         REAL law(void *context, const REAL xi[{n}], REAL t) {{\n    REAL sum = (REAL)0;\n    *(int *)context += 1;\n\
         \x20   for (int i = 0; i < {n}; i++) {{ sum = sum + (REAL)-1.5 * xi[i]; }}\n\
         \x20   return sum + (REAL)0.125 * t;\n}}\n\
         REAL after(void *context, const REAL x[{n}], REAL t) {{ *(int *)context += 1; (void)t; return -x[0]; }}\n\
         int main(void) {{\n    double v[{count} + 2 * {n} + 1];\n    int context = 0;\n\
         \x20   while (fread(v, sizeof v, 1, stdin) == 1) {{\n\
         \x20       {name} self;\n        {name}_params params;\n        REAL x0[{n}], x[{n}];\n\
         \x20       REAL u = (REAL)12345;\n        int32_t status;\n        double out;\n\
         \x20       memset(&params, 0, sizeof params);\n{set}\
         \x20       for (int i = 0; i < {n}; i++) {{\n\
         \x20           x0[i] = (REAL)v[{count} + i];\n            x[i] = (REAL)v[{count} + {n} + 1 + i];\n        }}\n\
         \x20       (void)x0;\n        (void)context;\n\
         \x20       status = {name}_init(&self, &params{latch});\n\
         \x20       if (status == 0) {{ status = {name}_step(&self, (REAL)v[{count} + {n}], x{externs}, &u); }}\n\
         \x20       else {{ u = (REAL)0; }}\n\
         \x20       out = (double)u;\n        fwrite(&status, sizeof status, 1, stdout);\n\
         \x20       fwrite(&out, sizeof out, 1, stdout);\n    }}\n    return 0;\n}}\n"
    );
    let files = write(folder, spec, Language::C);
    let main = folder.join("main.c");
    fs::write(&main, text).expect("a driver");
    let path = folder.join("in_c");
    run(c_compiler()
        .args(STRICT)
        .arg("-I")
        .arg(folder)
        .arg(&main)
        .args(files.iter().filter(|file| file.extension().is_some_and(|e| e == "c")))
        .arg("-o")
        .arg(&path)
        .arg("-lm"));
    path
}

fn in_rust(folder: &Path, spec: &Spec) -> PathBuf {
    let (name, type_name, n) = (spec.name(), spec.type_name(), spec.n);
    let real = real(spec.precision);
    let mut set: Vec<String> = Vec::new();
    let all = fields(spec);
    for (at, (field, index)) in all.iter().enumerate() {
        match index {
            None => set.push(format!("{field}: v[{at}] as {real}")),
            Some(0) => {
                let items: Vec<_> = (at..at + all.iter().filter(|(f, _)| f == field).count())
                    .map(|at| format!("v[{at}] as {real}"))
                    .collect();
                set.push(format!("{field}: [{}]", items.join(", ")));
            }
            Some(_) => {}
        }
    }
    let count = all.len();
    let latch = if spec.latches() { ", &x0" } else { "" };
    let mut externs = String::new();
    if spec.feedback == Feedback::Extern {
        let _ = write!(
            externs,
            ", |xi: &[{real}; {n}], t: {real}| xi.iter().fold(0.0, |s, xi| s + -1.5 * xi) + 0.125 * t"
        );
    }
    if spec.after == After::Extern {
        let _ = write!(externs, ", |x: &[{real}; {n}], _t: {real}| -x[0]");
    }
    let text = format!(
        "#[allow(dead_code)]\nmod {name};\nuse std::io::{{Read, Write}};\n\
         fn main() {{\n    let mut bytes = Vec::new();\n\
         \x20   std::io::stdin().read_to_end(&mut bytes).expect(\"records\");\n\
         \x20   let numbers: Vec<f64> = bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().expect(\"8\"))).collect();\n\
         \x20   let mut out = Vec::new();\n\
         \x20   for v in numbers.chunks_exact({count} + 2 * {n} + 1) {{\n\
         \x20       let x0: [{real}; {n}] = std::array::from_fn(|i| v[{count} + i] as {real});\n\
         \x20       let x: [{real}; {n}] = std::array::from_fn(|i| v[{count} + {n} + 1 + i] as {real});\n\
         \x20       let _ = x0;\n\
         \x20       let params = {name}::{type_name}Params {{ {} }};\n\
         \x20       let (status, u) = match {name}::{type_name}::new(params{latch}) {{\n\
         \x20           Err(_) => (-1i32, 0.0),\n\
         \x20           Ok(built) => match built.step(v[{count} + {n}] as {real}, &x{externs}) {{\n\
         \x20               Ok(c) => (match c.status {{ {name}::Status::Ok => 0, {name}::Status::Hold => 1, {name}::Status::Saturated => 2, {name}::Status::After => 3 }}, c.u),\n\
         \x20               Err({name}::Error::Param) => (-1, 0.0),\n\
         \x20               Err({name}::Error::Input) => (-2, 0.0),\n\
         \x20               Err({name}::Error::Range) => (-3, 0.0),\n\
         \x20           }},\n        }};\n\
         \x20       out.extend(status.to_le_bytes());\n        out.extend((u as f64).to_le_bytes());\n    }}\n\
         \x20   std::io::stdout().write_all(&out).expect(\"outcomes\");\n}}\n",
        set.join(", ")
    );
    write(folder, spec, Language::Rust);
    let main = folder.join("main.rs");
    fs::write(&main, text).expect("a driver");
    let path = folder.join("in_rust");
    run(rustc().args(["-O", "-Aunused"]).arg(&main).arg("-o").arg(&path));
    path
}

fn outcomes(program: &Path, records: &[Record]) -> Vec<Outcome> {
    let numbers = records.iter().flat_map(|r| {
        r.parameters.iter().chain(&r.x0).chain([&r.t]).chain(&r.x).copied().collect::<Vec<_>>()
    });
    let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program");
    let mut stdin = child.stdin.take().expect("its input");
    let writer = std::thread::spawn(move || stdin.write_all(&bytes).expect("records"));
    let output = child.wait_with_output().expect("its output");
    writer.join().expect("all records");
    assert!(output.status.success());
    let outcome = |bytes: &[u8]| {
        let status = i32::from_le_bytes(bytes[..4].try_into().expect("four bytes"));
        (status, u64::from_le_bytes(bytes[4..].try_into().expect("eight bytes")))
    };
    output.stdout.chunks_exact(12).map(outcome).collect()
}

#[test]
fn languages_agree_on_laws_of_the_user() {
    let specs = specs();
    let home = folder("laws");
    let indexed: Vec<_> = specs.iter().enumerate().collect();
    let seen = in_pairs(&indexed, |(index, spec)| {
        let folder = home.join(index.to_string());
        fs::create_dir_all(&folder).expect("a folder");
        let records = records(spec, &mut Random(*index as u64));
        let (c, rust) = (in_c(&folder, spec), in_rust(&folder, spec));
        let (c, rust) = (outcomes(&c, &records), outcomes(&rust, &records));
        let program = passes::optimise(lower(spec, &Law::of(spec)), &mut |_, _| {});
        for ((record, c), rust) in records.iter().zip(&c).zip(&rust) {
            if calls_a_library(spec) {
                assert_eq!(c.0, rust.0, "{spec:?}\n{record:?}");
                let (a, b) = (f64::from_bits(c.1), f64::from_bits(rust.1));
                assert!((a - b).abs() <= 1e-12 * a.abs(), "{a} {b}");
                continue;
            }
            assert_eq!(c, rust, "C and Rust: {spec:?}\n{record:?}");
            let wanted = interpreted(&program, spec, record);
            assert_eq!(*c, wanted, "C and the interpreter: {spec:?}\n{record:?}");
        }
        c.iter().map(|(status, _)| *status).collect::<std::collections::BTreeSet<_>>()
    });
    let seen: std::collections::BTreeSet<_> = seen.into_iter().flatten().collect();
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [-3, -2, 0, 1, 2, 3], "every status but -1");
}
