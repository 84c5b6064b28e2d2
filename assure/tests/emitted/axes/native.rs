//! Programs in C and Rust around emitted controllers of several axes, with their calls written out.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use ptc_codegen::emit::Language;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::Spec;

use super::support::{STRICT, c_compiler, run, rustc, write};
use super::{Call, Given, LAW, is_extern, parameters};

/// A number as both languages write it, or what stands for no number.
pub(super) fn written(value: f64, nan: &str, suffix: &str) -> String {
    if value.is_nan() { nan.to_owned() } else { format!("{value:?}{suffix}") }
}

fn list(values: &[f64], nan: &str, suffix: &str, (open, close): (&str, &str)) -> String {
    let values: Vec<_> = values.iter().map(|value| written(*value, nan, suffix)).collect();
    format!("{open}{}{close}", values.join(", "))
}

/// Returns true if the states belong to one plant rather than to separate axes.
pub(super) fn is_plant(spec: &Spec) -> bool {
    spec.coupled.as_ref().is_some_and(|coupled| !coupled.is_of_axes)
}

/// The states: a list of those of each axis, or those of one plant.
pub(super) fn states(
    spec: &Spec,
    x: &[f64],
    nan: &str,
    suffix: &str,
    ends: (&str, &str),
) -> String {
    match is_plant(spec) {
        true => list(x, nan, suffix, ends),
        false => lists(x, spec.n, nan, suffix, ends),
    }
}

pub(super) fn lists(
    values: &[f64],
    length: usize,
    nan: &str,
    suffix: &str,
    ends: (&str, &str),
) -> String {
    let rows: Vec<_> =
        values.chunks(length.max(1)).map(|row| list(row, nan, suffix, ends)).collect();
    format!("{}{}{}", ends.0, rows.join(", "), ends.1)
}

/// The parameters as members of a structure, arrays together.
pub(super) fn members(spec: &Spec, assign: &str, ends: (&str, &str), suffix: &str) -> String {
    let all = parameters(spec);
    let groups = all.chunk_by(|a, b| a.0.key() == b.0.key());
    let member = |group: &[(Parameter, f64)]| {
        let values: Vec<_> = group.iter().map(|(_, value)| *value).collect();
        let value = match group[0].0.index() {
            Some(_) => list(&values, "", suffix, ends),
            None => written(values[0], "", suffix),
        };
        format!("{}{assign}{value}", group[0].0.key())
    };
    groups.map(member).collect::<Vec<_>>().join(", ")
}

pub(super) fn in_c(folder: &Path, spec: &Spec, calls: &[Call], count: usize) -> Vec<Given> {
    write(folder, spec, Language::C);
    let name = spec.name();
    let (real, integer, suffix) = match spec.precision {
        Precision::F64 => ("double", "uint64_t", ""),
        Precision::F32 => ("float", "uint32_t", "f"),
    };
    let ends = ("{", "}");
    let members = members(spec, " = ", ends, suffix);
    let named = members.split(", ").map(|m| match m.contains(" = ") {
        true => format!(".{m}"),
        false => m.to_owned(),
    });
    // C has no struct without a field.
    let fields = match members.is_empty() {
        true => ".none = 0".to_owned(),
        false => named.collect::<Vec<_>>().join(", "),
    };
    let mut text = format!(
        "#include \"{name}.h\"\n#include <inttypes.h>\n#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\nint main(void)\n{{\n    static {name} c;\n    const {name}_params p = {{ {} }};\n    ptc_status axes[{count}];\n    {real} u[{count}];\n    if ({name}_init(&c, &p) != PTC_OK) {{ return 1; }}\n",
        fields
    );
    if is_extern(spec) {
        let [first, second] = LAW.map(|law| law.replace('F', suffix));
        let chains: usize = spec.coupled.as_ref().expect("chains").orders().iter().sum();
        let law = format!(
            "static void law(void *context, const {real} xi[{chains}], {real} t, {real} rate, {real} pi0[2])\n{{\n    (void)context;\n    pi0[0] = {first};\n    pi0[1] = {second};\n}}\n\nint main("
        );
        text = text.replacen("int main(", &law, 1);
    }
    let called = if is_extern(spec) { "law, NULL, " } else { "" };
    for call in calls {
        let reference = spec.references();
        let x = states(spec, &call.x, "NAN", suffix, ends);
        let shape = match is_plant(spec) {
            true => format!("[{}]", spec.states()),
            false => format!("[{count}][{}]", spec.n),
        };
        let (declared, given) = match reference {
            0 => (String::new(), ""),
            length => {
                let r = lists(&call.r, length, "NAN", suffix, ends);
                (format!("const {real} r[{count}][{length}] = {r};"), "r, ")
            }
        };
        let t = written(call.t, "NAN", suffix);
        let _ = writeln!(
            text,
            "    {{ const {real} x{shape} = {x}; {declared}\n      printf(\"%d\", (int){name}_step(&c, {t}, x, {given}{called}u, axes)); }}\n    for (int i = 0; i < {count}; i++) {{ {integer} bits; memcpy(&bits, &u[i], sizeof bits); printf(\" %\" PRIu64 \" %d\", (uint64_t)bits, (int)axes[i]); }}\n    printf(\"\\n\");"
        );
    }
    text.push_str("    return 0;\n}\n");
    let (main, binary) = (folder.join("main.c"), folder.join("in_c"));
    fs::write(&main, text).expect("a file");
    let source = folder.join(format!("{name}.c"));
    run(c_compiler().args(STRICT).arg(&main).arg(&source).arg("-lm").arg("-o").arg(&binary));
    read(spec, &run(&mut std::process::Command::new(binary)))
}

pub(super) fn in_rust(folder: &Path, spec: &Spec, calls: &[Call], count: usize) -> Vec<Given> {
    write(folder, spec, Language::Rust);
    let (name, kind) = (spec.name(), spec.type_name());
    let real = match spec.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let (nan, ends) = (format!("{real}::NAN"), ("[", "]"));
    let mut text = format!(
        "#![allow(dead_code)]\nmod {name};\nuse {name}::*;\nfn number(status: Result<Status, Error>) -> i32 {{ match status {{ Ok(Status::Ok) => 0, Ok(Status::Hold) => 1, Ok(Status::Saturated) => 2, Ok(Status::After) => 3, Ok(Status::Gated) => 4, Ok(Status::Late) => 5, Ok(Status::Infeasible) => 6, Err(Error::Param) => -1, Err(Error::Input) => -2, Err(Error::Range) => -3, Err(Error::Soon) => -4 }} }}\nfn show(all: Axes<{count}, {real}>) {{ print!(\"{{}}\", number(all.status)); for i in 0..{count} {{ print!(\" {{}} {{}}\", all.u[i].to_bits(), number(all.axes[i])); }} println!(); }}\nfn main() {{\n    let c = {kind}::new({kind}Params {{ {} }}).expect(\"legal\");\n",
        members(spec, ": ", ends, "")
    );
    for call in calls {
        let x = states(spec, &call.x, &nan, "", ends);
        let reference = match spec.references() {
            0 => String::new(),
            length => format!(", &{}", lists(&call.r, length, &nan, "", ends)),
        };
        let t = written(call.t, &nan, "");
        let [first, second] = LAW.map(|law| law.replace('F', ""));
        let called = match is_extern(spec) {
            true => format!(", |xi, t, rate| [{first}, {second}]"),
            false => String::new(),
        };
        let _ = writeln!(text, "    show(c.step({t}, &{x}{reference}{called}));");
    }
    text.push_str("}\n");
    let (main, binary) = (folder.join("main.rs"), folder.join("in_rust"));
    fs::write(&main, text).expect("a file");
    run(rustc().arg(&main).arg("-o").arg(&binary));
    read(spec, &run(&mut std::process::Command::new(binary)))
}

/// The lines of a program; floats become doubles, as the interpreter has them.
pub(super) fn read(spec: &Spec, text: &[u8]) -> Vec<Given> {
    let widened = |bits: u64| match spec.precision {
        Precision::F64 => bits,
        Precision::F32 => {
            f64::from(f32::from_bits(u32::try_from(bits).expect("32 bits"))).to_bits()
        }
    };
    let line = |line: &str| {
        let mut words = line.split(' ');
        let status = words.next().and_then(|word| word.parse().ok()).expect("a status");
        let (mut u, mut axes) = (Vec::new(), Vec::new());
        while let (Some(bits), Some(axis)) = (words.next(), words.next()) {
            let bits = match bits.strip_prefix("0x") {
                Some(digits) => u64::from_str_radix(digits, 16),
                None => bits.parse(),
            };
            u.push(widened(bits.expect("bits")));
            axes.push(axis.parse().expect("a status"));
        }
        (u, axes, status)
    };
    String::from_utf8_lossy(text).lines().map(line).collect()
}
