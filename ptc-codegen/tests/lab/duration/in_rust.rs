//! Random calls of `arm`, `arm_for` and `step` of the emitted Rust: after each start the controller is a fresh one with the
//! same duration, and a start that is refused changes nothing.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::Spec;

use super::designs::families;
use crate::support;

const MAIN: &str = include_str!("main.rs.txt");

/// The parameters of a design as a struct of Rust, with the duration `tau`.
fn parameters(spec: &Spec) -> String {
    let mut fields: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut arrays = Vec::new();
    for (index, parameter) in spec.run_time_parameters().enumerate() {
        let value = match parameter {
            Parameter::Tau => "tau".to_owned(),
            Parameter::StartTime => "0.3".to_owned(),
            Parameter::Eps => "0.04".to_owned(),
            Parameter::UMax => "7.0".to_owned(),
            Parameter::Start => "0.25".to_owned(),
            _ => format!("{:?}", 0.75 + 0.125 * index as f64),
        };
        fields.entry(parameter.key()).or_default().push(value);
        arrays.extend(parameter.index().map(|_| parameter.key()));
    }
    let field = |(key, values): (&&str, &Vec<String>)| match arrays.contains(key) {
        true => format!("{key}: [{}]", values.join(", ")),
        false => format!("{key}: {}", values.join(", ")),
    };
    fields.iter().map(field).collect::<Vec<_>>().join(", ")
}

#[test]
fn families_start_as_fresh_ones() {
    let folder = support::folder("families");
    let (mut modules, mut calls) = (String::new(), String::new());
    for (name, spec) in families() {
        let file = generate(&spec, Language::Rust).expect("a legal design").remove(0);
        std::fs::write(folder.join(format!("{name}.rs")), file.text).expect("a file");
        let real = if spec.precision == Precision::F32 { "f32" } else { "f64" };
        let _ = writeln!(modules, "#[allow(dead_code, unexpected_cfgs)]\nmod {name};");
        let own = parameters(&spec);
        let _ = writeln!(
            calls,
            "    check!({name}, {real}, {}, |tau: {real}| {name}::OwnParams {{ {own} }});",
            spec.n
        );
    }
    let main = format!("{modules}{MAIN}\nfn main() {{\n{calls}}}\n");
    std::fs::write(folder.join("main.rs"), main).expect("a file");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let mut compiler = Command::new(rustc);
    compiler.args(["--edition=2024", "-Copt-level=1", "main.rs", "-o", "run"]);
    let built = compiler.current_dir(&folder).output().expect("a compiler");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let ran = Command::new(folder.join("run")).output().expect("a program");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    assert_eq!(String::from_utf8_lossy(&ran.stdout).lines().count(), families().len());
}
