//! Emitted sources of many controllers, compiled together.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::request::Spec;

use crate::harness::cpp::{STRICT_CPP, cpp_compiler};
use crate::harness::{STRICT, c_compiler, rustc};

/// The languages in which they are emitted.
pub(super) const LANGUAGES: [Language; 4] =
    [Language::C, Language::Cpp, Language::Rust, Language::Python];

/// Number of errors of a compiler that are shown.
const SHOWN: usize = 20;

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

/// Sources in a folder, with what includes all of them.
pub(super) struct Sources {
    folder: PathBuf,
    in_c: Vec<PathBuf>,
    in_cpp: String,
    in_rust: String,
}

impl Sources {
    pub(super) fn new(folder: PathBuf) -> Self {
        Self { folder, in_c: Vec::new(), in_cpp: String::new(), in_rust: String::new() }
    }

    /// Emits a controller as `module`.
    pub(super) fn add(&mut self, language: Language, spec: &Spec, module: &str) -> Result<()> {
        for file in generate(spec, language).unwrap_or_default() {
            let extension = file.name.rsplit_once('.').map_or("", |(_, end)| end);
            let name = match language {
                Language::C => format!("{module}/{}", file.name),
                _ => format!("{module}.{extension}"),
            };
            let path = self.put(&name, &file.text)?;
            match extension {
                "rs" => write!(self.in_rust, "#[path = \"{module}.rs\"]\npub mod {module};\n")?,
                "hpp" => {
                    // Each in a space of its own, as if it were alone.
                    let guard = file.name.replace('.', "_").to_uppercase();
                    write!(
                        self.in_cpp,
                        "#undef PTC_STATUS_HPP\n#undef PTC_VALUE_HPP\n#undef {guard}\nnamespace {module} {{\n\
                         #include \"{module}.hpp\"\n}}\n"
                    )?;
                }
                "c" => self.in_c.push(path),
                _ => {}
            }
        }
        Ok(())
    }

    /// The errors of each compiler.
    pub(super) fn compile(&self) -> Result<Vec<String>> {
        let library = format!("#![allow(non_snake_case)]\n{}", self.in_rust);
        let library = self.put("lib.rs", &library)?;
        let headers: String = ["array", "cmath", "cstddef", "cstdint", "limits"]
            .iter()
            .map(|header| format!("#include <{header}>\n"))
            .collect();
        let headers = self.put("all.hpp", &(headers + &self.in_cpp))?;
        let mut rust = rustc();
        rust.args(["--crate-type=lib", "--crate-name=named", "--emit=metadata"]);
        rust.arg(library).arg("-o").arg(self.folder.join("named.rmeta"));
        let mut c = c_compiler();
        c.args(STRICT).arg("-fsyntax-only").args(&self.in_c);
        let mut cpp = cpp_compiler();
        cpp.args(STRICT_CPP).args(["-fsyntax-only", "-x", "c++"]).arg(headers);
        let mut failures = Vec::new();
        for mut compiler in [c, cpp, rust] {
            let output = compiler.output()?;
            if !output.status.success() {
                let told = String::from_utf8_lossy(&output.stderr);
                let errors = told.lines().filter(|line| line.contains("error")).take(SHOWN);
                failures.push(errors.collect::<Vec<_>>().join("\n"));
            }
        }
        let python = Command::new("python3").args(["-c", MODULES]).arg(&self.folder).output()?;
        if !python.status.success() || !python.stdout.is_empty() {
            let told = [python.stdout, python.stderr].concat();
            failures.push(String::from_utf8_lossy(&told).into_owned());
        }
        Ok(failures)
    }

    fn put(&self, name: &str, text: &str) -> Result<PathBuf> {
        let path = self.folder.join(name);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&path, text)?;
        Ok(path)
    }
}
