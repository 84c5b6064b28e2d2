//! A name that is taken for a controller gives source that compiles, whatever it means elsewhere.

mod support;

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::Language;
use ptc_codegen::spec::{Entry, parse, read};
use support::{STRICT, c_compiler, folder, in_pairs, rustc, write};

/// Names that C, Rust or the emitted code itself use for something of their own.
const MEANINGFUL: [&str; 48] = [
    "a",
    "axis",
    "built",
    "control",
    "controller",
    "copy",
    "core",
    "deadline",
    "debug",
    "double_t",
    "err",
    "error",
    "exp",
    "exp2",
    "f64",
    "fabs",
    "gain",
    "gains",
    "hold",
    "inf",
    "isfinite",
    "j1",
    "k",
    "math",
    "nan",
    "ok",
    "option",
    "params",
    "ptc_controller",
    "result",
    "round",
    "row1",
    "signgam",
    "size_t",
    "some",
    "sqrt",
    "status",
    "std",
    "step",
    "t",
    "t0",
    "tan",
    "tick",
    "u",
    "uint32_t",
    "v",
    "x",
    "x1",
];

/// The compilers that refuse a controller of this name; none where the name is not taken at all.
fn refusals(name: &str) -> Vec<String> {
    let given = [("n", "9"), ("mu", "exp_sum"), ("name", name)];
    let entry = |(key, text): &(&str, &str)| {
        let value = parse(key, text, &mut |_| Place(0)).expect("a value");
        Entry { key: (*key).to_owned(), place: Place(0), value }
    };
    let Ok(spec) = read(&given.iter().map(entry).collect::<Vec<_>>()) else { return Vec::new() };
    let folder = folder(&format!("name_{name}"));
    write(&folder, &spec, Language::C);
    write(&folder, &spec, Language::Rust);
    let source = |extension| folder.join(name).with_extension(extension);
    let mut c = c_compiler();
    c.args(STRICT).arg("-c").arg(source("c")).arg("-o").arg(source("o"));
    let mut rust = rustc();
    rust.args(["--crate-type=lib", "--crate-name=named", "--emit=metadata"]);
    rust.arg(source("rs")).arg("-o").arg(source("rmeta"));
    let mut commands = vec![c, rust];
    // C++ refuses its own words, which C and Rust take for a name.
    if let Ok(files) = ptc_codegen::generate(&spec, Language::Cpp) {
        let header = folder.join(&files[0].name);
        std::fs::write(&header, &files[0].text).expect("a header");
        let mut cpp = cpp_compiler();
        cpp.args(STRICT_CPP).args(["-fsyntax-only", "-x", "c++"]).arg(header);
        commands.push(cpp);
    }
    let outputs: Vec<_> =
        commands.iter_mut().map(|compiler| compiler.output().expect("a compiler")).collect();
    let refused = outputs.iter().filter(|output| !output.status.success());
    let first = |output: &std::process::Output| {
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = told.lines().find(|line| line.contains("error")).map(str::to_owned);
        format!("{name}: {}", line.unwrap_or(told))
    };
    refused.map(first).collect()
}

#[test]
fn a_name_that_is_taken_compiles() {
    let refused: Vec<_> = in_pairs(&MEANINGFUL, |name| refusals(name)).concat();
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}
