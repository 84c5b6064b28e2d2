//! Emitted Rust, the macro and the facade under Miri, which interprets Rust and detects undefined
//! behaviour.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result};
use ptc_codegen::emit::Language;
use ptc_codegen::request::{After, Feedback, Spec};

use crate::context::{Context, workspace};
use crate::harness::program::{has_gains, real};
use crate::harness::{empty, write};
use crate::layer::{Finding, Layer};
use crate::tool::{ShownBy, Source, Tool};

const MIRI: Tool = Tool {
    name: "miri",
    shown_by: ShownBy::Command(&["cargo", "+nightly", "miri", "--version"]),
    source: Source::Rustup(&[
        "toolchain",
        "install",
        "nightly",
        "--profile",
        "minimal",
        "--component",
        "miri,rust-src",
        "--no-self-update",
    ]),
};

pub(super) const LAYER: Layer = Layer {
    name: "miri",
    claim: "Emitted Rust, and what the macro makes on the facade, runs under Miri without undefined \
            behaviour.",
    tools: &[MIRI],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let home = context.scratch("miri");
    let specs = [context.families(context.order(3)), context.random(30)].concat();
    let mut specs = context.in_turn(specs);
    specs.retain(|spec| spec.feedback != Feedback::Extern && spec.after != After::Extern);
    for (index, spec) in specs.iter().enumerate() {
        write(&empty(&home.join(format!("src/c{index}"))), spec, Language::Rust);
    }
    let mut finding = Finding::default();
    finding.failures.extend(interpret(context, &home, &specs)?);
    let verdict = if finding.failures.is_empty() { "no undefined behaviour" } else { "refused" };
    finding.summary = format!(
        "{} emitted controllers and two of the macro, {CALLS} calls each: {verdict}",
        specs.len()
    );
    seeded(context, &mut finding)?;
    Ok(finding)
}

/// Calls of a controller, from before the start to after the deadline.
const CALLS: usize = 12;

/// Runs the controllers in `home` under Miri; its output, if any.
fn interpret(context: &Context, home: &Path, specs: &[Spec]) -> Result<Option<String>> {
    let facade = workspace().display();
    // A name of its own, for programs of one name in one build folder take each other's place.
    let name = home.file_name().unwrap_or_default();
    let manifest = format!(
        "[package]\nname = {name:?}\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
         [features]\nlibm = []\n\n[dependencies]\nlibm = \"0.2.15\"\nptc = {{ path = {:?} }}\n\n[workspace]\n",
        facade.to_string()
    );
    fs::write(home.join("Cargo.toml"), manifest)?;
    fs::write(home.join("src/main.rs"), program(specs))?;
    let output = Command::new("cargo")
        .current_dir(home)
        .args(["+nightly", "miri", "run", "--quiet"])
        .env_remove("RUSTC")
        .env_remove("CARGO")
        .env("CARGO_TARGET_DIR", context.shared("miri"))
        .output()
        .context("cargo miri")?;
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(told))
}

/// The program that calls every controller.
fn program(specs: &[Spec]) -> String {
    let mut text = format!(
        "use ptc::Controller;\n\
         ptc::ptc_controller!(n = 3, mu = exp, name = roll);\n\
         ptc::ptc_controller!(n = 2, mu = exp_sum, precision = f32, name = sum);\n\
         fn main() {{\n    let times = (0..{CALLS}).map(|i| -0.5 + 0.25 * i as f64);\n"
    );
    let mut modules = String::new();
    for (index, spec) in specs.iter().enumerate() {
        let (name, type_name, n, real) =
            (spec.name(), spec.type_name(), spec.n, real(spec.precision));
        let _ = writeln!(
            modules,
            "#[allow(dead_code)]\n#[path = \"c{index}/{name}.rs\"]\nmod c{index};"
        );
        let latched = if spec.latches() { format!(", &[0.5; {n}]") } else { String::new() };
        let axis = if has_gains(spec) {
            format!("            let _ = own.tick(t as {real}).and_then(|gains| gains.axis(&x));\n")
        } else {
            String::new()
        };
        let _ = write!(
            text,
            "    {{\n        let mut own = c{index}::{type_name}::new(c{index}::{type_name}Params {{ {} }}{latched}).expect(\"legal parameters\");\n\
             \x20       let x = [0.25 as {real}; {n}];\n        for t in times.clone() {{\n\
             \x20           let _ = own.step(t as {real}, &x);\n{axis}        }}\n        \
             own.arm(1.0{latched}).expect(\"a legal start\");\n    }}\n",
            values(spec)
        );
    }
    let _ = write!(
        text,
        "    let roll = Roll::new(RollParams {{ tau: 1.5, t0: 0.0, eps: 1e-3, u_max: 9.0, a: 1.0, k: [6.0, 11.0, 6.0] }});\n\
         \x20   let sum = Sum::new(SumParams {{ tau: 1.5, t0: 0.0, eps: 1e-3, u_max: 9.0, rates: [0.5, 2.0], k: [6.0, 5.0] }});\n\
         \x20   let (roll, sum) = (roll.expect(\"legal\"), sum.expect(\"legal\"));\n    for t in times {{\n\
         \x20       let _ = Controller::step(&roll, t, &[1.0, 0.5, 0.25]);\n        \
         let _ = sum.step(t as f32, &[1.0, 0.5]);\n    }}\n}}\n{modules}"
    );
    text
}

/// Legal values of the fields of the parameters.
fn values(spec: &Spec) -> String {
    let mut fields: Vec<String> = Vec::new();
    for parameter in spec.run_time_parameters() {
        let key = parameter.key();
        let value = match key {
            "tau" => "1.75",
            "t0" => "0.0",
            "eps" => "1e-3",
            "u_max" => "25.0",
            "start" => "0.5",
            _ => "1.5",
        };
        match parameter.index() {
            None => fields.push(format!("{key}: {value}")),
            Some(0) => {
                let count = spec.run_time_parameters().filter(|p| p.key() == key).count();
                let each: Vec<_> = (1..=count).map(|i| format!("{i}.5")).collect();
                fields.push(format!("{key}: [{}]", each.join(", ")));
            }
            Some(_) => {}
        }
    }
    fields.join(", ")
}

/// An emitted file that reads behind the end of the state.
fn seeded(context: &Context, finding: &mut Finding) -> Result<()> {
    let (home, spec) = (context.scratch("miri_seeded"), context.example());
    let file = write(&empty(&home.join("src/c0")), &spec, Language::Rust).remove(0);
    let text = fs::read_to_string(&file)?;
    let odd = text
        .replace("#![forbid(unsafe_code)]", "#![allow(unsafe_code)]")
        .replace("self.c2 * x[1]", "self.c2 * unsafe { *x.as_ptr().add(2) }");
    fs::write(&file, odd)?;
    let told = interpret(context, &home, &[spec])?.unwrap_or_default();
    let line = told.lines().find(|line| line.contains("Undefined Behavior"));
    let told = line.map(|line| line.trim_start_matches("error: ").to_owned());
    finding.seed("a state read behind the end of the array", told);
    Ok(())
}
