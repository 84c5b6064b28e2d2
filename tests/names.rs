//! A name that is taken for a controller gives source that compiles, whatever it means elsewhere.

mod support;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::Language;
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;
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

/// The design of these keys; none where it is refused.
fn spec_of(given: &[(&str, &str)]) -> Option<Spec> {
    let entry = |(key, text): &(&str, &str)| {
        let value = parse(key, text, &mut |_| Place(0)).ok()?;
        Some(Entry { key: (*key).to_owned(), place: Place(0), value })
    };
    read(&given.iter().map(entry).collect::<Option<Vec<_>>>()?).ok()
}

/// The compilers that refuse a controller of this name; none where the name is not taken at all.
fn refusals(name: &str) -> Vec<String> {
    let Some(spec) = spec_of(&[("n", "9"), ("mu", "exp_sum"), ("name", name)]) else {
        return Vec::new();
    };
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

/// Emitted files whose identifiers are tried as names: loops, an iteration, functions and a state
/// of the user's, and a gain of the input.
const SOURCES: [&str; 7] = [
    "rust/ptc_exp_sum2.rs",
    "rust/ptc_power2_by_root.rs",
    "rust/ptc_tanh3_extern.rs",
    "rust/ptc_own_law1_latched.rs",
    "python/ptc_exp_sum2.py",
    "python/ptc_tanh3_extern.py",
    "python/ptc_own_law1_latched.py",
];

/// The identifiers in the code of the emitted files, and those of the same type name.
fn identifiers() -> BTreeSet<String> {
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("generated");
    let mut found = BTreeSet::new();
    for source in SOURCES {
        let text = fs::read_to_string(generated.join(source)).expect("an emitted file");
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        for word in code.flat_map(|l| l.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))) {
            if word.starts_with(|c: char| c.is_ascii_alphabetic()) {
                found.insert(word.to_owned());
                found.insert(word.to_lowercase());
            }
        }
    }
    found
}

/// Compiles every module, and finds a name of the module that one of its functions hides.
const PYTHON: &str = r#"
import ast, pathlib, sys
for path in sorted(pathlib.Path(sys.argv[1]).glob("*.py")):
    text = path.read_text()
    try:
        compile(text, path.name, "exec")
        tree = ast.parse(text)
    except SyntaxError as error:
        print(path.name, error)
        continue
    own = [n.name for n in tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))]
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            own += [alias.asname or alias.name for alias in node.names]
        if isinstance(node, ast.Assign):
            own += [target.id for target in node.targets]
    twice = {name for name in own if own.count(name) > 1}
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef):
            fields = [n.target.id for n in node.body if isinstance(n, ast.AnnAssign)]
            twice |= {name for name in fields if fields.count(name) > 1}
        if isinstance(node, ast.FunctionDef):
            names = {a.arg for a in node.args.args}
            names |= {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
            twice |= names & set(own)
    if twice:
        print(path.name, "means two things:", *sorted(twice))
"#;

#[test]
fn internal_identifiers_as_names_compile_in_rust_and_python() {
    let folder = folder("names_internal");
    let mut library = String::new();
    let mut taken = [0, 0];
    for name in identifiers() {
        let mapping = format!("tau*{name}*t/(1 + {name}*t)");
        let by_name = spec_of(&[("n", "2"), ("mu", "exp_sum"), ("name", &name)]);
        let by_parameter = spec_of(&[("n", "2"), ("mu", &mapping), ("name", "host")]);
        for (index, spec) in [by_name, by_parameter].into_iter().enumerate() {
            let Some(spec) = spec else { continue };
            taken[index] += 1;
            let module = format!("{}_{name}", ["controller", "parameter"][index]);
            if let Ok(files) = ptc_codegen::generate(&spec, Language::Rust) {
                fs::write(folder.join(format!("{module}.rs")), &files[0].text).expect("a file");
                writeln!(library, "#[path = \"{module}.rs\"]\npub mod {module};").expect("text");
            }
            if let Ok(files) = ptc_codegen::generate(&spec, Language::Python) {
                fs::write(folder.join(format!("{module}.py")), &files[0].text).expect("a file");
            }
        }
    }
    assert!(taken.iter().all(|count| *count > 30), "{taken:?} names are taken");
    fs::write(folder.join("lib.rs"), format!("#![allow(non_snake_case)]\n{library}"))
        .expect("a file");
    let mut rust = rustc();
    rust.args(["--crate-type=lib", "--crate-name=named", "--emit=metadata"]);
    rust.arg(folder.join("lib.rs")).arg("-o").arg(folder.join("named.rmeta"));
    let output = rust.output().expect("a compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new("python3").args(["-c", PYTHON]).arg(&folder).output();
    let output = output.expect("python3");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
}
