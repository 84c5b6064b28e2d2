//! Controllers in samples in Python, in Octave, and in Structured Text under an interpreter.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_assure::context::workspace;
use ptc_codegen::code::{Access, Shape};
use ptc_codegen::parameter::Precision;

use super::super::run;
use super::{Design, answers, length};

const PYTHON: &str = r#"
import importlib, math, struct, sys
import numpy as np
def number(word): return struct.unpack(">d", bytes.fromhex(word))[0]
def show(value):
    value = float(value)
    return "nan" if math.isnan(value) else struct.pack(">d", value).hex()
designs = []
for folder, name, kind, real, layout, given, measured, columns, row in DESIGNS:
    sys.path.insert(0, folder)
    designs.append((importlib.import_module(name), kind, getattr(np, real), layout, given, measured, columns, row))
held = [None] * len(designs)
count = 0
for line in sys.stdin:
    word, *rest = line.split()
    count += 1
    if word == "D":
        at = int(rest[0])
        module, kind, real, layout, given, measured, columns, row = designs[at]
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
        given_now = [number(one) for one in rest[1:]]
        if hasattr(held[at], "update"):
            status, values = held[at].update(k, given_now[:-1], given_now[-1]), []
            assert type(status) is module.Status, (module, type(status))
        else:
            x, r = given_now[:measured], given_now[measured:]
            if columns:
                x = np.reshape(x, (-1, columns))
            r = [np.reshape(r, (-1, row)) if row else r] if r else []
            u, *axes, status = held[at].step(k, x, *r)
            if axes:
                [axes] = axes
                assert (u.dtype, axes.dtype, status.dtype) == (real, np.int8, np.int8), module
                print("S", int(status), *map(show, u), *map(int, axes))
                continue
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

/// The interpreter of the tests, where it has what is `needed`.
pub(crate) fn python_with(needed: &str) -> Option<String> {
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let found = Command::new(&python).args(["-c", needed]).output();
    found.is_ok_and(|output| output.status.success()).then_some(python)
}

/// GNU Octave, where it is there with all of its libraries.
pub(crate) fn octave() -> Option<Command> {
    let version = Command::new("octave-cli").arg("--version").output().ok()?;
    version.status.success().then_some(())?;
    let mut octave = Command::new("octave-cli");
    octave.args(["-q", "--no-init-file", "--no-history"]);
    Some(octave)
}

/// Returns the answers of a driver in Python; `None` if a module that it imports is missing.
fn in_interpreter(
    needed: &str,
    text: &str,
    folder: &Path,
    designs: &[Design],
) -> Option<Vec<String>> {
    let python = python_with(needed)?;
    let mut table = String::new();
    for design in designs {
        let real = if design.code.precision == Precision::F32 { "float32" } else { "float64" };
        // 0 is a count, 1 a number, and n + 1 an array of n.
        let length = |shape| match shape {
            Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => unreachable!("no parameter"),
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
        let measured = design.measured();
        let [columns, row] = [design.columns(), design.row()].map(|length| length.unwrap_or(0));
        writeln!(
            table,
            "(\"{home}\", \"{name}\", \"{kind}\", \"{real}\", [{layout}], [{given}], {measured}, {columns}, {row}),"
        )
        .expect("a string");
    }
    let source = folder.join("driver.py");
    fs::write(&source, format!("DESIGNS = [\n{table}]\n{text}")).expect("Python");
    let modules = workspace().join("assure/src/harness/driver");
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
def rows(numbers, length):
    if not length:
        return numbers
    return [numbers[at:at + length] for at in range(0, len(numbers), length)]
units, held, layouts, givens, reals, inputs, observes, shapes = [], [], [], [], [], [], [], []
for folder, name, kind, real, layout, given, *shape in DESIGNS:
    with open(f"{folder}/{name}.st") as file:
        unit = Library(file.read()).units[name]
    units.append(unit)
    held.append(unit.memory())
    layouts.append(layout)
    givens.append(given)
    reals.append(getattr(np, real))
    inputs.append("y" if "y" in unit.kinds else "x")
    observes.append(kind.endswith("Observer"))
    shapes.append(shape)
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
    numbers = [real(number(one)) for one in rest[1:]]
    last = {"u": numbers.pop()} if observes[at] else {}
    measured, columns, row = shapes[at]
    x, r = rows(numbers[:measured], columns), rows(numbers[measured:], row)
    memory = called(at, k=k, **{inputs[at]: x}, **({"r": r} if r else {}), **last)
    values = []
    for name in ([] if observes[at] else ["u"]) + givens[at]:
        value = memory[name]
        values.extend(value if isinstance(value, list) else [value])
    assert all(type(value) is real for value in values), values
    print("S", memory["status"], *map(show, values), *memory.get("axes", []))
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
            [init, arm, step] = deal(str2func([d.name '_init']), str2func([d.name '_arm']), str2func([d.name '_' d.call]));
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
                given_now = {x(1:min(d.measured, end))};
                if d.columns given_now{1} = reshape(given_now{1}, d.columns, [])'; end
                if numel(x) > d.measured given_now{2} = x(d.measured + 1:end); end
                if d.row given_now{2} = reshape(given_now{2}, d.row, [])'; end
                if strcmp(d.call, 'update')
                    [status, self{at}] = step(self{at}, k, x(1:end - 1), x(end));
                elseif d.inputs
                    [u, axes, status] = step(self{at}, k, given_now{:});
                    if ~isa(axes, 'int32') error('types'); end
                elseif d.changes
                    [u, status, self{at}] = step(self{at}, k, given_now{:});
                else
                    [u, status] = step(self{at}, k, given_now{:});
                end
                if ~isa(status, 'int32') error('types'); end
                text = sprintf('S %d', status);
                if ~strcmp(d.call, 'update')
                    if ~isa(u, d.real) error('types'); end
                    for value = u(:)'
                        text = [text show(value)];
                    end
                    if d.inputs text = [text sprintf(' %d', axes)]; end
                end
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
    let mut octave = octave()?;
    let mut table = String::new();
    for (i, design) in designs.iter().enumerate() {
        let names: Vec<_> = design.parameters().map(|(name, _)| format!("'{name}'")).collect();
        let lengths: Vec<_> =
            design.parameters().map(|(_, shape)| length(shape).to_string()).collect();
        let given: Vec<_> = design.given().map(|(f, _)| format!("'{}'", f.name)).collect();
        let real = if design.code.precision == Precision::F32 { "single" } else { "double" };
        let step = design.called();
        let changes = step.access == Access::Change;
        writeln!(
            table,
            "designs{{{}}} = struct('folder', '{}', 'name', '{}', 'real', '{real}', 'names', {{{{{}}}}}, \
             'lengths', [{}], 'given', {{{{{}}}}}, 'changes', {}, 'inputs', {}, 'columns', {}, 'row', {}, 'call', '{}', 'measured', {});",
            i + 1,
            design.folder.display(),
            design.code.name,
            names.join(", "),
            lengths.join(", "),
            given.join(", "),
            u8::from(changes),
            u8::from(design.code.axes().is_some()),
            design.columns().unwrap_or(0),
            design.row().unwrap_or(0),
            step.name,
            design.measured()
        )
        .expect("a string");
    }
    let source = folder.join("driver.m");
    fs::write(&source, format!("1;\n{OCTAVE}\ndesigns = {{}};\n{table}drive(designs);\n"))
        .expect("Octave");
    Some(answers(octave.arg(source), folder))
}
