//! Controllers in samples, run in every language from one list of calls.
//!
//! A driver reads words: `D i` chooses a design, `I` and its parameters initialise it, `A k` arms it,
//! `S k` and its measurements step it. Numbers are the bits of doubles in hexadecimal. It writes a
//! line for each `I` (the status) and for each `S`: the status, u, and all that the controller gives
//! beside it.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::code::{Access, Code, Function, Instance, Shape};
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::{Precision, type_name};

use super::{STRICT, c_compiler, run, rustc};

/// A controller under test.
pub(crate) struct Design {
    /// Its program.
    pub(crate) code: Code,
    /// The folder of its files.
    pub(crate) folder: PathBuf,
}

/// What is done with a controller.
#[derive(Clone, Debug)]
pub(crate) enum Call {
    Init(Vec<f64>),
    Arm(u32),
    Step(u32, Vec<f64>),
}

impl Design {
    fn real(&self) -> &'static str {
        if self.code.precision == Precision::F32 { "float" } else { "double" }
    }

    fn kind(&self) -> String {
        type_name(&self.code.name)
    }

    /// How many numbers a step is given.
    pub(crate) fn measured(&self) -> usize {
        let step = self.code.function("step").expect("a step");
        let lengths = step.arguments.iter().filter_map(|a| match a.shape {
            Shape::Reals(length) => Some(length),
            _ => None,
        });
        lengths.sum()
    }

    /// What it gives beside u, with the lengths of arrays.
    fn given(&self) -> impl Iterator<Item = (&Function, Option<usize>)> {
        let others = self.code.functions.iter().filter(|f| !["step", "arm"].contains(&f.name));
        others.map(|function| match function.results[0].variable.shape {
            Shape::Reals(length) => (function, Some(length)),
            _ => (function, None),
        })
    }

    /// The numbers of its parameters, with the name and shape of each.
    fn parameters(&self) -> impl Iterator<Item = (&str, Shape)> {
        self.code.parameters.iter().map(|p| (p.name.as_str(), p.shape))
    }

    /// How many numbers `init` takes.
    pub(crate) fn numbers(&self) -> usize {
        self.parameters().map(|(_, shape)| length(shape)).sum()
    }

    /// What the interpreter answers.
    pub(crate) fn interpreted(&self, calls: &[Call]) -> Vec<String> {
        let mut instance: Option<Instance<'_>> = None;
        let mut lines = Vec::new();
        for call in calls {
            match (call, instance.as_mut()) {
                (Call::Init(values), _) => {
                    let mut rest = values.as_slice();
                    let mut given = Vec::new();
                    for (name, shape) in self.parameters() {
                        let (now, later) = rest.split_at(length(shape));
                        given.push((name, now));
                        rest = later;
                    }
                    let made = Instance::new(&self.code, &given);
                    lines.push(format!("I {}", made.as_ref().err().map_or(0, |s| s.number())));
                    instance = made.ok().or(instance);
                }
                (Call::Arm(k), Some(instance)) => {
                    instance.call("arm", &[("k", &[f64::from(*k)])]);
                }
                (Call::Step(k, x), Some(instance)) => {
                    let (k, x) = ([f64::from(*k)], x.as_slice());
                    let outcome = instance.call("step", &[("k", &k), ("x", x), ("y", x)]);
                    let u = outcome.results.get("u").map_or(0.0, |u| u[0]);
                    let mut line = format!("S {} {}", outcome.status.number(), word(u));
                    for (function, _) in self.given() {
                        for value in instance.call(function.name, &[]).results.values().flatten() {
                            write!(line, " {}", word(*value)).expect("a string");
                        }
                    }
                    lines.push(line);
                }
                (_, None) => panic!("the first call is no legal init"),
            }
        }
        lines
    }
}

/// Bits; all that is not a number is alike.
fn word(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{:016x}", value.to_bits()) }
}

/// The calls of all designs, as a driver reads them.
pub(crate) fn script(calls: &[Vec<Call>]) -> String {
    let mut text = String::new();
    for (index, calls) in calls.iter().enumerate() {
        writeln!(text, "D {index}").expect("a string");
        for call in calls {
            let (head, numbers) = match call {
                Call::Init(values) => ("I".to_owned(), values.as_slice()),
                Call::Arm(k) => (format!("A {k}"), &[][..]),
                Call::Step(k, x) => (format!("S {k}"), x.as_slice()),
            };
            text.push_str(&head);
            for number in numbers {
                write!(text, " {:016x}", number.to_bits()).expect("a string");
            }
            text.push('\n');
        }
    }
    text
}

/// What a driver answers to the script in `folder`.
fn answers(command: &mut Command, folder: &Path) -> Vec<String> {
    let script = fs::File::open(folder.join("script")).expect("a script");
    let text = run(command.stdin(Stdio::from(script)));
    String::from_utf8(text).expect("text").lines().map(str::to_owned).collect()
}

const C_MAIN: &str = r#"
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static double number(void)
{
    char text[32] = "";
    if (scanf("%31s", text) != 1) exit(3);
    const uint64_t bits = strtoull(text, NULL, 16);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
static void show(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value != value) printf(" nan"); else printf(" %016" PRIx64, bits);
}
"#;

const C_LOOP: &str = r#"
int main(void)
{
    char word[4];
    unsigned design = 0;
    uint32_t k;
    while (scanf("%3s", word) == 1) {
        switch (word[0]) {
        case 'D': if (scanf("%u", &design) != 1) return 4; break;
        case 'I': printf("I %d\n", inits[design]()); break;
        default:
            if (scanf("%" SCNu32, &k) != 1) return 4;
            if (word[0] == 'A') arms[design](k); else steps[design](k);
        }
    }
    return 0;
}
"#;

fn tables(count: usize) -> String {
    let list = |name| (0..count).map(|i| format!("{name}{i}")).collect::<Vec<_>>().join(", ");
    format!(
        "static int (*const inits[])(void) = {{{}}};\nstatic void (*const arms[])(uint32_t) = {{{}}};\n\
         static void (*const steps[])(uint32_t) = {{{}}};\n{C_LOOP}",
        list("init"),
        list("arm"),
        list("step")
    )
}

/// Statements of C that read the parameters into `p`.
fn c_parameters(design: &Design) -> String {
    let real = design.real();
    let each = design.parameters().map(|(name, shape)| match shape {
        Shape::Count => format!("p.{name} = (uint32_t)number(); "),
        Shape::Real => format!("p.{name} = ({real})number(); "),
        Shape::Reals(n) => (0..n).map(|i| format!("p.{name}[{i}] = ({real})number(); ")).collect(),
    });
    each.collect()
}

pub(crate) fn in_c(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = String::new();
    let mut main = C_MAIN.to_owned();
    for (i, design) in designs.iter().enumerate() {
        let (name, real, m) = (&design.code.name, design.real(), design.measured());
        writeln!(text, "#include \"{}\"", design.folder.join(format!("{name}.h")).display())
            .expect("a string");
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(n) => format!(
                    "{{ {real} e[{n}]; (void){name}_{}(&self{i}, e); for (int j = 0; j < {n}; j++) show((double)e[j]); }} ",
                    function.name
                ),
                None => format!(
                    "{{ {real} e; (void){name}_{}(&self{i}, &e); show((double)e); }} ",
                    function.name
                ),
            })
            .collect();
        let read: String = (0..m).map(|j| format!("x[{j}] = ({real})number(); ")).collect();
        write!(
            main,
            "static {name} self{i};\n\
             static int init{i}(void) {{ {name}_params p; memset(&p, 0, sizeof p); {}return (int){name}_init(&self{i}, &p); }}\n\
             static void arm{i}(uint32_t k) {{ (void){name}_arm(&self{i}, k); }}\n\
             static void step{i}(uint32_t k) {{ {real} x[{m}]; {real} u = 77; {read}\
             printf(\"S %d\", (int){name}_step(&self{i}, k, x, &u)); show((double)u); {given}printf(\"\\n\"); }}\n",
            c_parameters(design)
        )
        .expect("a string");
    }
    fs::write(folder.join("main.c"), format!("{text}{main}{}", tables(designs.len()))).expect("C");
    let sources: Vec<_> =
        designs.iter().map(|d| d.folder.join(format!("{}.c", d.code.name))).collect();
    for source in &sources {
        run(c_compiler()
            .args(STRICT)
            .arg("-c")
            .arg(source)
            .arg("-o")
            .arg(source.with_extension("o")));
        if Command::new("clang").arg("--version").output().is_ok() {
            run(Command::new("clang").args(STRICT).arg("-fsyntax-only").arg(source));
        }
    }
    let objects = sources.iter().map(|source| source.with_extension("o"));
    let program = folder.join("in_c");
    run(c_compiler().arg(folder.join("main.c")).args(objects).arg("-o").arg(&program).arg("-lm"));
    Some(answers(&mut Command::new(program), folder))
}

pub(crate) fn in_cpp(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = String::new();
    let mut main = C_MAIN.to_owned();
    for (i, design) in designs.iter().enumerate() {
        let (name, real, m) = (&design.code.name, design.real(), design.measured());
        let kind = design.kind();
        let header = design.folder.join(format!("{name}.hpp"));
        writeln!(text, "#include \"{}\"", header.display()).expect("a string");
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(_) => {
                    format!("for (const auto e : self{i}.{}()) show(double(e)); ", function.name)
                }
                None => format!("show(double(self{i}.{}())); ", function.name),
            })
            .collect();
        let read: String = (0..m).map(|j| format!("x[{j}] = ({real})number(); ")).collect();
        write!(
            main,
            "static ptc::{kind} self{i};\n\
             static int init{i}() {{ ptc::{kind}Params p{{}}; {}return static_cast<int>(self{i}.init(p)); }}\n\
             static void arm{i}(uint32_t k) {{ self{i}.arm(k); }}\n\
             static void step{i}(uint32_t k) {{ std::array<{real}, {m}> x{{}}; {read}\
             const auto r = self{i}.step(k, x); printf(\"S %d\", static_cast<int>(r.status)); show(double(r.u)); {given}printf(\"\\n\"); }}\n",
            c_parameters(design)
        )
        .expect("a string");
    }
    let source = folder.join("main.cpp");
    fs::write(&source, format!("{text}{main}{}", tables(designs.len()))).expect("C++");
    let (strict, program) = (folder.join("strict.cpp"), folder.join("in_cpp"));
    fs::write(&strict, &text).expect("C++");
    run(cpp_compiler().args(STRICT_CPP).arg("-fsyntax-only").arg(&strict));
    if Command::new("clang++").arg("--version").output().is_ok() {
        run(Command::new("clang++").args(STRICT_CPP).arg("-fsyntax-only").arg(&strict));
    }
    let flags = ["-std=c++17", "-O1", "-ffp-contract=off"];
    run(cpp_compiler().args(flags).arg(&source).arg("-o").arg(&program));
    Some(answers(&mut Command::new(program), folder))
}

const RUST_MAIN: &str = r#"
fn number(words: &mut dyn Iterator<Item = &'static str>) -> f64 {
    f64::from_bits(u64::from_str_radix(words.next().unwrap(), 16).unwrap())
}
fn show(value: f64) {
    if value.is_nan() { print!(" nan") } else { print!(" {:016x}", value.to_bits()) }
}
trait Design {
    fn init(&mut self, words: &mut dyn Iterator<Item = &'static str>) -> i32;
    fn arm(&mut self, k: u32);
    fn step(&mut self, k: u32, words: &mut dyn Iterator<Item = &'static str>);
}
macro_rules! outcome {
    ($module:ident, $call:expr) => {{
        use $module::{Error, Status};
        match $call {
            Ok(control) => (match control.status {
                Status::Ok => 0, Status::Hold => 1, Status::Saturated => 2, Status::After => 3,
            }, f64::from(control.u)),
            Err(Error::Param) => (-1, 0.0),
            Err(Error::Input) => (-2, 0.0),
            Err(Error::Range) => (-3, 0.0),
        }
    }};
}
fn main() {
    let text: &'static str = std::io::read_to_string(std::io::stdin()).unwrap().leak();
    let mut words = text.split_whitespace();
    let mut designs = designs();
    let mut at = 0;
    while let Some(word) = words.next() {
        match word {
            "D" => at = words.next().unwrap().parse().unwrap(),
            "I" => println!("I {}", designs[at].init(&mut words)),
            _ => {
                let k = words.next().unwrap().parse().unwrap();
                if word == "A" { designs[at].arm(k) } else { designs[at].step(k, &mut words) }
            }
        }
    }
}
"#;

pub(crate) fn in_rust(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = RUST_MAIN.to_owned();
    let mut all = String::new();
    for (i, design) in designs.iter().enumerate() {
        let (name, kind, m) = (&design.code.name, design.kind(), design.measured());
        let real = if design.code.precision == Precision::F32 { "f32" } else { "f64" };
        let value = |_| format!("number(words) as {real}");
        let fields: String = design
            .parameters()
            .map(|(field, shape)| match shape {
                Shape::Count => format!("{field}: number(words) as u32, "),
                Shape::Real => format!("{field}: {}, ", value(0)),
                Shape::Reals(n) => {
                    format!("{field}: [{}], ", (0..n).map(value).collect::<Vec<_>>().join(", "))
                }
            })
            .collect();
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(_) => format!("for e in this.{}() {{ show(f64::from(e)); }} ", function.name),
                None => format!("show(f64::from(this.{}())); ", function.name),
            })
            .collect();
        let x = (0..m).map(value).collect::<Vec<_>>().join(", ");
        let path = design.folder.join(format!("{name}.rs"));
        write!(
            text,
            "#[path = \"{}\"]\n#[allow(dead_code)]\nmod {name};\nstruct D{i}(Option<{name}::{kind}>);\n\
             impl Design for D{i} {{\n\
             #[allow(unused_variables, clippy::all)]\n\
             fn init(&mut self, words: &mut dyn Iterator<Item = &'static str>) -> i32 {{\n\
             match {name}::{kind}::new({name}::{kind}Params {{ {fields}}}) {{ Ok(made) => {{ self.0 = Some(made); 0 }}, Err(_) => -1 }} }}\n\
             fn arm(&mut self, k: u32) {{ self.0.as_mut().unwrap().arm(k); }}\n\
             fn step(&mut self, k: u32, words: &mut dyn Iterator<Item = &'static str>) {{\n\
             let this = self.0.as_mut().unwrap(); let (status, u) = outcome!({name}, this.step(k, &[{x}]));\n\
             print!(\"S {{status}}\"); show(u); {given}println!(); }} }}\n",
            path.display()
        )
        .expect("a string");
        write!(all, "Box::new(D{i}(None)), ").expect("a string");
    }
    writeln!(text, "fn designs() -> Vec<Box<dyn Design>> {{ vec![{all}] }}").expect("a string");
    let (source, program) = (folder.join("main.rs"), folder.join("in_rust"));
    fs::write(&source, text).expect("Rust");
    run(rustc().arg(&source).arg("-o").arg(&program));
    if Command::new("rustfmt").arg("--version").output().is_ok() {
        // As users format: without the options of this project.
        fs::write(folder.join("rustfmt.toml"), "").expect("options");
        let files = designs.iter().map(|d| d.folder.join(format!("{}.rs", d.code.name)));
        let options = ["--check", "--edition=2024", "--config-path"];
        run(Command::new("rustfmt").args(options).arg(folder).args(files));
    }
    Some(answers(&mut Command::new(program), folder))
}

const PYTHON: &str = r#"
import importlib, math, struct, sys
import numpy as np
def number(word): return struct.unpack(">d", bytes.fromhex(word))[0]
def show(value):
    value = float(value)
    return "nan" if math.isnan(value) else struct.pack(">d", value).hex()
designs = []
for folder, name, kind, real, layout, given in DESIGNS:
    sys.path.insert(0, folder)
    designs.append((importlib.import_module(name), kind, getattr(np, real), layout, given))
held = [None] * len(designs)
count = 0
for line in sys.stdin:
    word, *rest = line.split()
    count += 1
    if word == "D":
        at = int(rest[0])
        module, kind, real, layout, given = designs[at]
    elif word == "I":
        values, params = [number(one) for one in rest], {}
        for name, length in layout:
            if length == 0:
                params[name] = int(values.pop(0))
            elif length == 1:
                params[name] = values.pop(0)
            else:
                params[name] = values[:length - 1]
                del values[:length - 1]
        try:
            held[at] = getattr(module, kind)(module.Params(**params))
            print("I 0")
        except ValueError:
            print("I -1")
    else:
        # A counter that does not wrap by itself.
        k = int(rest[0]) + (count % 2) * 2**32
        if word == "A":
            held[at].arm(k)
            continue
        u, status = held[at].step(k, [number(one) for one in rest[1:]])
        assert type(u) is real, (module, type(u))
        values = [u]
        for name in given:
            value = np.atleast_1d(getattr(held[at], name)())
            assert value.dtype == real, (module, value.dtype)
            values.extend(value)
        print("S", int(status), *map(show, values))
"#;

/// In Python, where NumPy is there.
pub(crate) fn in_python(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    in_interpreter("import numpy", PYTHON, folder, designs)
}

/// What a driver in Python answers, where all that it imports is there.
fn in_interpreter(
    needed: &str,
    text: &str,
    folder: &Path,
    designs: &[Design],
) -> Option<Vec<String>> {
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let found = Command::new(&python).args(["-c", needed]).output();
    found.ok().filter(|output| output.status.success())?;
    let mut table = String::new();
    for design in designs {
        let real = if design.code.precision == Precision::F32 { "float32" } else { "float64" };
        // 0 is a count, 1 a number, and n + 1 an array of n.
        let length = |shape| match shape {
            Shape::Count => 0,
            Shape::Real => 1,
            Shape::Reals(length) => length + 1,
        };
        let layout: Vec<_> = design
            .parameters()
            .map(|(name, shape)| format!("(\"{name}\", {})", length(shape)))
            .collect();
        let given: Vec<_> = design.given().map(|(f, _)| format!("\"{}\"", f.name)).collect();
        let (home, name, kind) = (design.folder.display(), &design.code.name, design.kind());
        let (layout, given) = (layout.join(", "), given.join(", "));
        writeln!(table, "(\"{home}\", \"{name}\", \"{kind}\", \"{real}\", [{layout}], [{given}]),")
            .expect("a string");
    }
    let source = folder.join("driver.py");
    fs::write(&source, format!("DESIGNS = [\n{table}]\n{text}")).expect("Python");
    let modules = Path::new(env!("CARGO_MANIFEST_DIR")).join("assure/src/harness/driver");
    let mut command = Command::new(python);
    command.args(["-B", "-W", "error::RuntimeWarning"]).arg(source);
    Some(answers(command.env("PYTHONPATH", modules), folder))
}

const STRUCTURED_TEXT: &str = r#"
import math, struct, sys
import numpy as np
from structured_text import Library
np.seterr(all="ignore")
def number(word): return struct.unpack(">d", bytes.fromhex(word))[0]
def show(value):
    value = float(value)
    return "nan" if math.isnan(value) else struct.pack(">d", value).hex()
def called(at, **inputs):
    unit, memory = units[at], held[at]
    memory.update(init=False, arm=False)
    memory.update(inputs)
    unit.execute(memory)
    return memory
units, held, layouts, givens, reals, inputs = [], [], [], [], [], []
for folder, name, kind, real, layout, given in DESIGNS:
    with open(f"{folder}/{name}.st") as file:
        unit = Library(file.read()).units[name]
    units.append(unit)
    held.append(unit.memory())
    layouts.append(layout)
    givens.append(given)
    reals.append(getattr(np, real))
    inputs.append("y" if "y" in unit.kinds else "x")
for line in sys.stdin:
    word, *rest = line.split()
    if word == "D":
        at = int(rest[0])
        assert called(at)["status"] == -2 and called(at, arm=True)["status"] == -1
        continue
    real = reals[at]
    if word == "I":
        values, params = [number(one) for one in rest], {}
        for name, length in layouts[at]:
            if length == 0:
                params[name] = np.uint32(values.pop(0))
            elif length == 1:
                params[name] = real(values.pop(0))
            else:
                params[name] = [real(value) for value in values[:length - 1]]
                del values[:length - 1]
        given = {"params": params} if params else {}
        print("I", called(at, init=True, **given)["status"])
        continue
    k = np.uint32(rest[0])
    if word == "A":
        assert called(at, arm=True, k=k)["status"] == 0
        continue
    memory = called(at, k=k, **{inputs[at]: [real(number(one)) for one in rest[1:]]})
    values = [memory["u"]]
    for name in givens[at]:
        value = memory[name]
        values.extend(value if isinstance(value, list) else [value])
    assert all(type(value) is real for value in values), values
    print("S", memory["status"], *map(show, values))
"#;

/// In Structured Text, where NumPy and blark are there.
pub(crate) fn in_structured_text(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    in_interpreter("import numpy, blark", STRUCTURED_TEXT, folder, designs)
}

const OCTAVE: &str = r#"
function text = show(value)
    if isnan(value) text = ' nan'; else text = [' ' num2hex(double(value))]; end
end
function drive(designs)
    self = cell(1, numel(designs));
    count = 0;
    line = fgetl(stdin);
    while ischar(line)
        words = strsplit(line, ' ');
        count = count + 1;
        switch words{1}
        case 'D'
            at = str2double(words{2}) + 1;
            d = designs{at};
            addpath(d.folder);
            [init, arm, step] = deal(str2func([d.name '_init']), str2func([d.name '_arm']), str2func([d.name '_step']));
            given = cellfun(@(f) str2func([d.name '_' f]), d.given, 'UniformOutput', false);
        case 'I'
            params = struct();
            i = 2;
            for j = 1:numel(d.names)
                n = d.lengths(j);
                params.(d.names{j}) = cellfun(@hex2num, words(i:i + n - 1));
                i = i + n;
            end
            try
                self{at} = init(params);
                puts("I 0\n");
            catch wrong
                if ~strcmp(wrong.identifier, [d.name ':param'])
                    rethrow(wrong);
                end
                puts("I -1\n");
            end
        otherwise
            % A counter that does not wrap by itself, and one that does.
            k = str2double(words{2});
            if mod(count, 2) k = k + 4294967296; else k = uint32(k); end
            if strcmp(words{1}, 'A')
                self{at} = arm(self{at}, k);
            else
                x = cellfun(@hex2num, words(3:end));
                if d.changes
                    [u, status, self{at}] = step(self{at}, k, x);
                else
                    [u, status] = step(self{at}, k, x);
                end
                if ~isa(u, d.real) || ~isa(status, 'int32') error('types'); end
                text = [sprintf('S %d', status) show(u)];
                for j = 1:numel(given)
                    values = given{j}(self{at});
                    if ~isa(values, d.real) error('types'); end
                    for value = values(:)'
                        text = [text show(value)];
                    end
                end
                puts([text "\n"]);
            end
        end
        line = fgetl(stdin);
    end
end
"#;

/// In GNU Octave, where it is there.
pub(crate) fn in_octave(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    Command::new("octave-cli").arg("--version").output().ok()?;
    let mut table = String::new();
    for (i, design) in designs.iter().enumerate() {
        let names: Vec<_> = design.parameters().map(|(name, _)| format!("'{name}'")).collect();
        let lengths: Vec<_> =
            design.parameters().map(|(_, shape)| length(shape).to_string()).collect();
        let given: Vec<_> = design.given().map(|(f, _)| format!("'{}'", f.name)).collect();
        let real = if design.code.precision == Precision::F32 { "single" } else { "double" };
        let step = design.code.function("step").expect("a step");
        let changes = step.access == Access::Change;
        writeln!(
            table,
            "designs{{{}}} = struct('folder', '{}', 'name', '{}', 'real', '{real}', 'names', {{{{{}}}}}, \
             'lengths', [{}], 'given', {{{{{}}}}}, 'changes', {});",
            i + 1,
            design.folder.display(),
            design.code.name,
            names.join(", "),
            lengths.join(", "),
            given.join(", "),
            u8::from(changes)
        )
        .expect("a string");
    }
    let source = folder.join("driver.m");
    fs::write(&source, format!("1;\n{OCTAVE}\ndesigns = {{}};\n{table}drive(designs);\n"))
        .expect("Octave");
    let mut octave = Command::new("octave-cli");
    Some(answers(octave.args(["-q", "--no-init-file", "--no-history"]).arg(source), folder))
}

/// The languages that are compared, by their names.
pub(crate) const LANGUAGES: [Language; 6] = [
    Language::C,
    Language::Rust,
    Language::Cpp,
    Language::Python,
    Language::Matlab,
    Language::StructuredText,
];

/// How many numbers a shape holds.
pub(crate) fn length(shape: Shape) -> usize {
    if let Shape::Reals(length) = shape { length } else { 1 }
}
