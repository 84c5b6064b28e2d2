//! A name that is taken for a controller gives source that compiles, whatever it means elsewhere.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::{File, Language};
use ptc_codegen::generate;
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;

use crate::context::Context;
use crate::harness::cpp::{STRICT_CPP, cpp_compiler};
use crate::harness::{STRICT, c_compiler, rustc};
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, GXX, PYTHON, RUSTC};

pub(super) const LAYER: Layer = Layer {
    name: "names",
    claim: "A controller or a parameter with a name that means something to a language, a library or \
            the emitted code compiles, or is refused with that reason.",
    tools: &[GCC, GXX, RUSTC, PYTHON],
    run,
};

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

/// Designs whose own identifiers are tried as names: loops, an iteration, functions and a state of
/// the user's, a gain of the input, and the infinite-time system.
const DESIGNS: [&[(&str, &str)]; 6] = [
    &[("n", "9"), ("mu", "exp_sum")],
    &[("n", "2"), ("mu", "power(m=0.2)"), ("u_max", "3"), ("guard", "result")],
    &[("n", "3"), ("mu", "tanh"), ("pi0", "extern"), ("after", "extern")],
    &[("n", "2"), ("mu", "tan"), ("pi0", "-20*xi1 - 9*xi2*x1_0"), ("g", "2 + cos(x1)")],
    &[("n", "2"), ("mu", "tau*b*t/(1 + b*t)"), ("precision", "f32")],
    &[("n", "2"), ("mu", "power"), ("what", "associated")],
];

/// The identifiers in the code of emitted files, and those of the same type name.
fn identifiers(files: &[File]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for file in files {
        // Every second part of a Python module is a text of several lines.
        for line in file.text.split("\"\"\"").step_by(2).flat_map(str::lines) {
            let is_comment =
                ["//", "/*", "*", "#"].iter().any(|comment| line.trim_start().starts_with(comment));
            let code = if is_comment { "" } else { line.split("/*").next().unwrap_or(line) };
            for word in code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')) {
                let is_own = word.to_lowercase().replace('_', "").contains("plainname");
                if word.starts_with(|c: char| c.is_ascii_alphabetic()) && !is_own {
                    found.insert(word.to_owned());
                    found.insert(word.to_lowercase());
                }
            }
        }
    }
    found
}

/// The design under a name.
fn called(design: &[(&str, &str)], name: &str) -> Option<Spec> {
    let fixed = [("name", name), ("allow", "membership,growth,sampling")];
    spec_of(&[design, &fixed].concat())
}

/// Compiles every module, and finds a name of the module that one of its functions hides.
const MODULES: &str = r#"
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

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("names");
    let (mut modules, mut headers) = (String::new(), String::new());
    let (mut sources, mut taken, mut refused) = (Vec::new(), [0, 0], BTreeSet::new());
    let put = |name: String, text: &str| {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(&path, text).expect("a file");
        path
    };
    let languages = [Language::C, Language::Cpp, Language::Rust, Language::Python];
    // Designs share most of their identifiers, which mean the same in each: one design tries them.
    let mut tried = languages.map(|_| BTreeSet::new());
    for (index, design) in DESIGNS.iter().enumerate() {
        let plain = called(design, "plain_name").expect("a design");
        for (language, tried) in languages.into_iter().zip(&mut tried) {
            let mut names = identifiers(&generate(&plain, language).expect("files"));
            assert!(names.len() > 30, "{} identifiers", names.len());
            names.retain(|name| tried.insert(name.clone()));
            if index == 0 {
                names.extend(MEANINGFUL.map(str::to_owned));
            }
            for name in context.in_turn(names.into_iter().collect()) {
                let mapping = format!("tau*{name}*t/(1 + {name}*t)");
                let by_parameter = spec_of(&[("n", "2"), ("mu", &mapping), ("name", "host")]);
                let given = [called(design, &name), by_parameter.filter(|_| index == 0)];
                if given[0].is_none() && !MEANINGFUL.contains(&&*name) {
                    refused.insert(name.clone());
                }
                for (kind, spec) in given.into_iter().enumerate() {
                    let Some(spec) = spec else { continue };
                    taken[kind] += 1;
                    let module = format!("{}_{index}_{name}", ["controller", "parameter"][kind]);
                    for file in generate(&spec, language).unwrap_or_default() {
                        let extension = file.name.rsplit_once('.').map_or("", |(_, end)| end);
                        let path = match language {
                            Language::C => format!("{module}/{}", file.name),
                            _ => format!("{module}.{extension}"),
                        };
                        let path = put(path, &file.text);
                        match extension {
                            "rs" => {
                                let line =
                                    format!("#[path = \"{module}.rs\"]\npub mod {module};\n");
                                modules.push_str(&line);
                            }
                            "hpp" => {
                                // Each in a space of its own, as if it were alone.
                                let guard = file.name.replace('.', "_").to_uppercase();
                                write!(
                                    headers,
                                    "#undef PTC_STATUS_HPP\n#undef PTC_VALUE_HPP\n#undef {guard}\nnamespace {module} {{\n\
                                     #include \"{module}.hpp\"\n}}\n"
                                )
                                .expect("text");
                            }
                            "c" => sources.push(path),
                            _ => {}
                        }
                    }
                }
            }
        }
    }
    let parts = if context.brief { 3 } else { 1 };
    assert!(taken[0] > 400 / parts && taken[1] > 30 / parts, "{taken:?} names are taken");
    // Words of the languages, of their libraries and of the statuses.
    assert!(refused.len() < 110, "{refused:?}");
    put("lib.rs".to_owned(), &format!("#![allow(non_snake_case)]\n{modules}"));
    let headers = format!(
        "#include <array>\n#include <cmath>\n#include <cstddef>\n#include <cstdint>\n#include <limits>\n{headers}"
    );
    let headers = put("all.hpp".to_owned(), &headers);
    let mut rust = rustc();
    rust.args(["--crate-type=lib", "--crate-name=named", "--emit=metadata"]);
    rust.arg(folder.join("lib.rs")).arg("-o").arg(folder.join("named.rmeta"));
    let mut c = c_compiler();
    c.args(STRICT).arg("-fsyntax-only").args(&sources);
    let mut cpp = cpp_compiler();
    cpp.args(STRICT_CPP).args(["-fsyntax-only", "-x", "c++"]).arg(headers);
    for mut compiler in [c, cpp, rust] {
        let output = compiler.output().expect("a compiler");
        let told = String::from_utf8_lossy(&output.stderr);
        let errors: Vec<_> = told.lines().filter(|line| line.contains("error")).collect();
        let shown = errors[..errors.len().min(20)].join("\n");
        assert!(output.status.success(), "{shown}");
    }
    let output = Command::new("python3").args(["-c", MODULES]).arg(&folder).output();
    let output = output.expect("python3");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    let [controllers, parameters] = taken;
    let summary = format!(
        "{controllers} names of controllers and {parameters} of parameters in 4 languages compile, {} \
         are refused",
        refused.len()
    );
    let mut finding = Finding { summary, ..Finding::default() };
    seeded(context, &mut finding)?;
    Ok(finding)
}

/// A controller with the name of a type of C.
fn seeded(context: &Context, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("names_seeded");
    let spec = Spec { name: Some("axle".to_owned()), ..context.example() };
    for file in generate(&spec, Language::C).unwrap_or_default() {
        fs::write(folder.join(&file.name), file.text.replace("axle *self", "double *self"))?;
    }
    let mut c = c_compiler();
    c.args(STRICT).arg("-fsyntax-only").arg(folder.join("axle.c"));
    let caught = !c.output()?.status.success();
    finding.seed("a controller that has the name of a type", caught.then(|| "cc".to_owned()));
    Ok(())
}
