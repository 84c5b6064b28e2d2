//! Programs around emitted controllers of several axes in C++, all calls at once in Python and Octave, and Structured
//! Text under an interpreter, where these are there.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_assure::context::workspace;
use ptc_assure::harness::cpp::STRICT_CPP;
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;

use super::native::{is_plant, lists, members, read, states, written};
use super::support::sampled::{octave, python_with};
use super::support::{run, write};
use super::{Call, Given, LAW, is_extern, parameters};

pub(super) fn in_cpp(folder: &Path, spec: &Spec, calls: &[Call], count: usize) -> Vec<Given> {
    write(folder, spec, Language::Cpp);
    let (name, kind) = (spec.name(), spec.type_name());
    let (real, integer, suffix) = match spec.precision {
        Precision::F64 => ("double", "std::uint64_t", ""),
        Precision::F32 => ("float", "std::uint32_t", "f"),
    };
    let (nan, ends) = (format!("std::numeric_limits<{real}>::quiet_NaN()"), ("{{", "}}"));
    let fields = members(spec, " = ", ends, suffix);
    // In the order of the members, whose names C++17 cannot give.
    let values: Vec<_> =
        fields.split(", ").map(|m| m.split_once(" = ").map_or(m, |m| m.1)).collect();
    let [first, second] = LAW.map(|law| law.replace('F', suffix));
    let law = format!(
        "const auto law = [](const auto& xi, {real} t, {real} rate) {{ return std::array<{real}, 2>{{{{{first}, {second}}}}}; }};"
    );
    let (law, called) = if is_extern(spec) { (law.as_str(), ", law") } else { ("", "") };
    let mut text = format!(
        "#include \"{name}.hpp\"\n#include <cstdint>\n#include <cstdio>\n#include <cstring>\n#include <limits>\n\n\
         static void show(const ptc::Axes<{real}, {count}>& all)\n{{\n    \
         std::printf(\"%d\", static_cast<int>(all.status));\n    for (std::size_t i = 0; i < {count}; i++) {{\n        \
         {integer} bits;\n        std::memcpy(&bits, &all.u[i], sizeof bits);\n        \
         std::printf(\" %llu %d\", static_cast<unsigned long long>(bits), static_cast<int>(all.axes[i]));\n    }}\n    \
         std::printf(\"\\n\");\n}}\n\nint main()\n{{\n    ptc::{kind} c;\n    \
         const ptc::{kind}::Params p{{{}}};\n    if (c.init(p) != ptc::Status::Ok) {{\n        return 1;\n    }}\n    {law}\n",
        values.join(", ")
    );
    let columns =
        |length: usize, rows: usize| format!("std::array<std::array<{real}, {length}>, {rows}>");
    let kind_of_x = match is_plant(spec) {
        true => format!("std::array<{real}, {}>", spec.states()),
        false => columns(spec.n, count),
    };
    let (kind_of_r, given) = match spec.references() {
        0 => ("int".to_owned(), "call.t, call.x"),
        length => (columns(length, count), "call.t, call.x, call.r"),
    };
    let _ = writeln!(
        text,
        "    struct Call {{ {real} t; {kind_of_x} x; {kind_of_r} r; }};\n    static const Call calls[] = {{"
    );
    for call in calls {
        let x = states(spec, &call.x, &nan, suffix, ends);
        let r = match spec.references() {
            0 => "0".to_owned(),
            length => lists(&call.r, length, &nan, suffix, ends),
        };
        let t = written(call.t, &nan, suffix);
        let _ = writeln!(text, "        {{{t}, {x}, {r}}},");
    }
    let _ = writeln!(
        text,
        "    }};\n    for (const Call& call : calls) {{\n        show(c.step({given}{called}));\n    }}\n}}"
    );
    let (main, binary) = (folder.join("main.cpp"), folder.join("in_cpp"));
    fs::write(&main, text).expect("a file");
    run(Command::new("g++").args(STRICT_CPP).arg(&main).arg("-o").arg(&binary));
    read(spec, &run(&mut Command::new(binary)))
}

/// All calls at once, where NumPy is there.
pub(super) fn in_python(
    folder: &Path,
    spec: &Spec,
    calls: &[Call],
    count: usize,
) -> Option<Vec<Given>> {
    let python = python_with("import numpy")?;
    write(folder, spec, Language::Python);
    let (name, kind) = (spec.name(), spec.type_name());
    let integer = if spec.precision == Precision::F32 { "uint32" } else { "uint64" };
    let ends = ("[", "]");
    let (mut t, mut x, mut r) = (Vec::new(), Vec::new(), Vec::new());
    for call in calls {
        t.push(written(call.t, "nan", ""));
        x.push(states(spec, &call.x, "nan", "", ends));
        r.push(lists(&call.r, spec.references(), "nan", "", ends));
    }
    let [t, x, r] = [t, x, r].map(|all| format!("[{}]", all.join(", ")));
    let r = if spec.references() > 0 { format!(", {r}") } else { String::new() };
    let [first, second] = LAW.map(|law| law.replace(".0F", ".0").replace("xi[", "xi[..., "));
    let law = match is_extern(spec) {
        true => format!(", pi0=lambda xi, t, rate: np.stack([{first}, {second}], axis=-1)"),
        false => String::new(),
    };
    let source = folder.join("driver.py");
    let text = format!(
        "import sys\nimport numpy as np\nsys.path.insert(0, {:?})\nimport {name} as module\nnan = float(\"nan\")\n\
         c = module.{kind}(module.Params({}))\nall = c.step({t}, {x}{r}{law})\n\
         assert all.u.shape == all.axes.shape == ({}, {count})\n\
         for u, axes, status in zip(all.u, all.axes, all.status):\n    \
         print(int(status), *(f\"{{int(bits)}} {{int(axis)}}\" for bits, axis in zip(u.view(np.{integer}), axes)))\n",
        folder.display().to_string(),
        members(spec, "=", ends, ""),
        calls.len()
    );
    fs::write(&source, text).expect("Python");
    Some(read(spec, &run(Command::new(python).args(["-B", "-W", "error"]).arg(source))))
}

/// In Structured Text, where NumPy and blark are there.
pub(super) fn in_structured_text(folder: &Path, spec: &Spec, calls: &[Call]) -> Option<Vec<Given>> {
    let python = python_with("import numpy, blark")?;
    write(folder, spec, Language::StructuredText);
    let name = spec.name();
    let (real, integer) = match spec.precision {
        Precision::F64 => ("float64", "uint64"),
        Precision::F32 => ("float32", "uint32"),
    };
    let ends = ("[", "]");
    let mut given = String::new();
    for call in calls {
        let x = states(spec, &call.x, "nan", "", ends);
        let r = lists(&call.r, spec.references(), "nan", "", ends);
        let _ = writeln!(given, "    ({}, {x}, {r}),", written(call.t, "nan", ""));
    }
    let params = members(spec, "=", ends, "");
    let text = format!(
        "import numpy as np\nfrom structured_text import Library\nnp.seterr(all=\"ignore\")\nnan = float(\"nan\")\n\
         def real(value):\n    return [real(one) for one in value] if isinstance(value, list) else np.{real}(value)\n\
         with open({:?}) as file:\n    unit = Library(file.read()).units[{name:?}]\n\
         memory = unit.memory()\nparams = {{name.lower(): real(value) for name, value in dict({params}).items()}}\n\
         if params:\n    memory[\"params\"] = params\n\
         memory[\"init\"] = True\nunit.execute(memory)\nassert memory[\"status\"] == 0\nmemory[\"init\"] = False\n\
         for t, x, r in [\n{given}]:\n    memory.update(t=real(t), x=real(x))\n    if r:\n        memory[\"r\"] = real(r)\n    \
         unit.execute(memory)\n    bits = np.array(memory[\"u\"]).view(np.{integer})\n    \
         print(memory[\"status\"], *(f\"{{u}} {{axis}}\" for u, axis in zip(bits, memory[\"axes\"])))\n",
        folder.join(format!("{name}.st")).display().to_string(),
    );
    let source = folder.join("structured_text_driver.py");
    fs::write(&source, text).expect("Python");
    let modules = workspace().join("assure/src/harness/driver");
    let mut command = Command::new(python);
    Some(read(spec, &run(command.arg("-B").arg(source).env("PYTHONPATH", modules))))
}

/// In GNU Octave, where it is there.
pub(super) fn in_octave(
    folder: &Path,
    spec: &Spec,
    calls: &[Call],
    count: usize,
) -> Option<Vec<Given>> {
    let mut octave = octave()?;
    write(folder, spec, Language::Matlab);
    let name = spec.name();
    let mut text = format!("1;\naddpath('{}');\np = struct();\n", folder.display());
    for group in parameters(spec).chunk_by(|a, b| a.0.key() == b.0.key()) {
        let values: Vec<_> = group.iter().map(|(_, value)| format!("{value:?}")).collect();
        let _ = writeln!(text, "p.{} = [{}];", group[0].0.key(), values.join(", "));
    }
    let real = if spec.precision == Precision::F32 { "single" } else { "double" };
    let _ = writeln!(text, "c = {name}_init(p);");
    let [first, second] = LAW.map(|law| {
        let law = law.replace(".0F", "");
        (0..9).rev().fold(law, |law, i| law.replace(&format!("xi[{i}]"), &format!("xi({})", i + 1)))
    });
    let law = format!(", @(xi, t, rate) [{first}, {second}]");
    let called = if is_extern(spec) { law.as_str() } else { "" };
    // A row a line.
    let matrix = |values: &[f64], length: usize| {
        let rows = values.chunks(length.max(1)).map(|row| {
            let row: Vec<_> = row.iter().map(|v| written(*v, "NaN", "")).collect();
            row.join(", ")
        });
        format!("{real}([{}])", rows.collect::<Vec<_>>().join("; "))
    };
    for call in calls {
        let columns = if is_plant(spec) { spec.states() } else { spec.n };
        let x = matrix(&call.x, columns);
        let r = match spec.references() {
            0 => String::new(),
            length => format!(", {}", matrix(&call.r, length)),
        };
        let t = written(call.t, "NaN", "");
        let _ = writeln!(
            text,
            "[u, axes, status] = {name}_step(c, {real}({t}), {x}{r}{called});\nprintf('%d', status);\n\
             for i = 1:{count}\n    printf(' 0x%s %d', num2hex(u(i)), axes(i));\nend\nprintf('\\n');"
        );
    }
    let source = folder.join("driver.m");
    fs::write(&source, text).expect("Octave");
    Some(read(spec, &run(octave.arg(source))))
}
