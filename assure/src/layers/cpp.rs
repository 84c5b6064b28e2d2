//! C++17: compiled by three compilers, run, and compared with C; constants hold at compile time.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::comparison::{Side, compare, controllers};
use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::cpp::{STRICT_CPP, in_cpp_from};
use crate::harness::in_pairs;
use crate::harness::program::{Outcome, Record};
use crate::harness::runtime::{Home, homes};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ARM_GXX, CLANG, GCC, GXX};

pub(super) const LAYER: Layer = Layer {
    name: "cpp",
    claim: "Emitted C++17 has no warning in g++, clang++ and arm-none-eabi-g++, gives the bits of C, \
            and runs when it is compiled where no library is called.",
    tools: &[GCC, GXX, CLANG, ARM_GXX],
    run,
};

/// The compilers with their own flags beside the strict ones.
const COMPILERS: [(&str, &[&str]); 3] = [
    ("g++", &["-Wuseless-cast", "-Wlogical-op"]),
    ("clang++", &["-Wimplicit-float-conversion"]),
    ("arm-none-eabi-g++", &["-mcpu=cortex-m4"]),
];

const SIGN: Defect =
    ("- correction_;", ";", "what the rounding of the deadline left out is forgotten");

fn run(context: &Context) -> Result<Finding> {
    let side = Side { language: Language::Cpp, run: &outcomes, has_axis: true, defect: SIGN };
    let mut finding = compare(context, &side)?;
    compilers(context, &mut finding)?;
    constants(context, &mut finding)?;
    Ok(finding)
}

fn outcomes(_: &Path, homes: &[Home<'_>], records: &[Vec<Record>]) -> Result<Vec<Vec<Outcome>>> {
    let calls: Vec<_> = homes.iter().zip(records).collect();
    Ok(in_pairs(&calls, |((home, spec), records)| in_cpp_from(home, spec).run(records)))
}

/// Returns the messages of a compiler on one file, if it fails.
fn told(compiler: &str, flags: &[&str], file: &Path) -> Result<Option<String>> {
    let mut command = Command::new(compiler);
    command.args(STRICT_CPP).args(flags).args(["-fsyntax-only", "-x", "c++"]).arg(file);
    let output = command.output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok((!output.status.success()).then_some(text))
}

/// All headers in one file, each twice, for every compiler.
fn compilers(context: &Context, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("cpp_compilers");
    let specs = controllers(context);
    let includes = |(home, spec): &Home<'_>| {
        format!("#include \"{}\"\n", home.join(format!("{}.hpp", spec.name())).display()).repeat(2)
    };
    let text: String = homes(&folder, &specs, Language::Cpp)?.iter().map(includes).collect();
    let all = folder.join("all.cpp");
    fs::write(&all, text)?;
    let mut rows = Vec::new();
    for (compiler, flags) in COMPILERS {
        let said = told(compiler, flags, &all)?;
        rows.push(vec![
            compiler.to_owned(),
            flags.join(" "),
            if said.is_some() { "warnings" } else { "none" }.to_owned(),
        ]);
        finding.failures.extend(said);
    }
    let head = vec!["compiler", "beside the strict flags", "warnings"];
    finding.tables.push(Table { title: "Warnings".to_owned(), head, rows });
    finding.notes.push(format!("The strict flags: `{}`.", STRICT_CPP.join(" ")));
    Ok(())
}

/// A program that holds only if the controller ran when it was compiled.
fn at_compile_time(spec: &Spec) -> String {
    let (name, type_name) = (spec.name(), spec.type_name());
    format!(
        "#include \"{name}.hpp\"\n\
         constexpr double u() {{\n    ptc::{type_name} self{{}};\n    \
         const ptc::{type_name}Params params{{2.0, 0.0, 0.0078125, 50.0, 1.0, {{{{6.0, 5.0}}}}}};\n    \
         if (self.init(params) != ptc::Status::Ok) {{\n        return 0.0;\n    }}\n    \
         const auto step = self.step(1.0, {{{{0.25, -0.5}}}});\n    \
         return step.status == ptc::Status::Ok ? step.u : 0.0;\n}}\n\
         static_assert(u() >= 0.5 && u() <= 0.5, \"4 u = -6 x1/T^2 + ... at T = 1\");\n"
    )
}

/// Checks the example at T = 1: u = -k_1 x_1 + (1 - k_2) x_2 = 0.5.
fn constants(context: &Context, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("cpp_constants");
    let spec = context.example();
    let good = homes(&folder, std::slice::from_ref(&spec), Language::Cpp)?;
    let bad = folder.join("bad");
    let defect = ("(-1.0) / late", "(-1.5) / late", "1/T is too great by half, at compile time");
    with_defect(&bad, &spec, Language::Cpp, defect)?;
    for compiler in ["g++", "clang++"] {
        for (home, holds) in [(&good[0].0, true), (&bad, false)] {
            let file = home.join("constant.cpp");
            fs::write(&file, at_compile_time(&spec))?;
            let said = told(compiler, &[], &file)?;
            if holds {
                finding.failures.extend(said);
            } else {
                finding.seed(defect.2, said.map(|_| format!("static_assert, {compiler}")));
            }
        }
    }
    Ok(())
}
