//! A name that is taken for a controller gives source that compiles, whatever it means elsewhere.

mod sources;

use std::collections::BTreeSet;
use std::fs;

use anyhow::{Context as _, Result, ensure};
use ptc_codegen::emit::{File, Language};
use ptc_codegen::generate;
use ptc_codegen::request::Spec;

use self::sources::{LANGUAGES, Sources};
use crate::context::Context;
use crate::harness::specs::legal;
use crate::harness::{STRICT, c_compiler};
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
    legal(&[design, &fixed].concat())
}

fn run(context: &Context) -> Result<Finding> {
    let mut sources = Sources::new(context.scratch("names"));
    let (mut taken, mut refused) = ([0u64, 0], BTreeSet::new());
    // Designs share most of their identifiers, which mean the same in each: one design tries them.
    let mut tried = LANGUAGES.map(|_| BTreeSet::new());
    for (index, design) in DESIGNS.iter().enumerate() {
        let plain = called(design, "plain_name").context("a design")?;
        for (language, tried) in LANGUAGES.into_iter().zip(&mut tried) {
            let mut names = identifiers(&generate(&plain, language).unwrap_or_default());
            ensure!(names.len() > 30, "{} identifiers", names.len());
            names.retain(|name| tried.insert(name.clone()));
            if index == 0 {
                names.extend(MEANINGFUL.map(str::to_owned));
            }
            for name in context.in_turn(names.into_iter().collect()) {
                match called(design, &name) {
                    Some(spec) => {
                        taken[0] += 1;
                        sources.add(language, &spec, &format!("controller_{index}_{name}"))?;
                    }
                    None if !MEANINGFUL.contains(&&*name) => _ = refused.insert(name.clone()),
                    None => {}
                }
                let mapping = format!("tau*{name}*t/(1 + {name}*t)");
                let of_parameter = [("n", "2"), ("mu", &mapping), ("name", "host")];
                if let Some(spec) = legal(&of_parameter).filter(|_| index == 0) {
                    taken[1] += 1;
                    sources.add(language, &spec, &format!("parameter_{index}_{name}"))?;
                }
            }
        }
    }
    let parts = context.parts();
    ensure!(taken[0] > 400 / parts && taken[1] > 30 / parts, "{taken:?} names are taken");
    // Words of the languages, of their libraries and of the statuses.
    ensure!(refused.len() < 110, "{refused:?}");
    let [controllers, parameters] = taken;
    let summary = format!(
        "{controllers} names of controllers and {parameters} of parameters in 4 languages compile, {} \
         are refused",
        refused.len()
    );
    let failures = sources.compile()?;
    let mut finding = Finding { summary, failures, ..Finding::default() };
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
