//! MISRA C:2012, by the addon of cppcheck.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;

use super::seeded::{Defect, with_defect};
use crate::context::Context;
use crate::harness::goldens::{of_axes, of_inputs};
use crate::harness::selftest::write_selftest;
use crate::harness::specs::spec;
use crate::harness::{empty, in_pairs, write};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{ShownBy, Source, Tool};

const CPPCHECK: Tool = Tool {
    name: "cppcheck",
    shown_by: ShownBy::Command(&["cppcheck", "--version"]),
    source: Source::Apt(&["cppcheck"]),
};

pub(super) const LAYER: Layer = Layer {
    name: "rules",
    claim: "Emitted C, self-tests included, violates no rule of MISRA C:2012 that cppcheck's addon \
            checks, and cppcheck's own checks of style and warnings find nothing.",
    tools: &[CPPCHECK],
    run,
};

/// Number of controllers of which one is checked with its self-test, which takes long to generate.
const SELFTESTED: usize = 8;

/// Controllers of a shape that the others need not have: one that only t0 is left to, and one with
/// functions of the caller's.
fn shapes() -> Vec<Spec> {
    let fixed = [("tau", "0.8"), ("eps", "0.01"), ("u_max", "4"), ("gains", "12,7")];
    let mapping = [("n", "2"), ("mu", "exp(a=1)"), ("name", "stage")];
    let own = [("n", "2"), ("mu", "rational"), ("pi0", "extern"), ("after", "extern")];
    let mut all = vec![spec(&[&mapping[..], &fixed].concat()), spec(&own), of_inputs()];
    all.extend(of_axes());
    all
}

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("rules");
    // The goldens are of the orders 1 to 5 in double precision.
    let mut single = context.families(context.order(3));
    single.retain(|spec| spec.precision == Precision::F32);
    let shapes = context.in_turn(shapes());
    let specs = [context.goldens(), single, context.random(15)].map(|specs| context.in_turn(specs));
    let specs = [shapes.clone(), specs.concat()].concat();
    let has_selftest = |index: usize| index < shapes.len() || index.is_multiple_of(SELFTESTED);
    let indexed: Vec<_> = specs.iter().enumerate().collect();
    let told = in_pairs(&indexed, |(index, spec)| {
        let folder = empty(&folder.join(index.to_string()));
        let files = write(&folder, spec, Language::C);
        if has_selftest(*index) {
            write_selftest(&folder, spec)?;
        }
        violations(&folder, spec, &files)
    });
    let mut finding = Finding::default();
    for text in told {
        let text = text?;
        finding.failures.extend((!text.is_empty()).then_some(text));
    }
    finding.summary = format!(
        "{} controllers, {} of them with their self-test, {} with a violation",
        specs.len(),
        (0..specs.len()).filter(|index| has_selftest(*index)).count(),
        finding.failures.len()
    );
    let mut rows = Vec::new();
    for (index, (defect, rule)) in context.in_turn(DEFECTS.to_vec()).into_iter().enumerate() {
        let folder = folder.join(format!("seeded{index}"));
        let files = with_defect(&folder, &context.example(), Language::C, defect)?;
        let told = violations(&folder, &context.example(), &files)?;
        let seen = told.contains(&format!("misra-c2012-{rule}]"));
        finding.seed(defect.2, seen.then(|| format!("rule {rule}")));
    }
    rows.push(vec![
        "5.7".to_owned(),
        "only where the sources of several controllers are checked together".to_owned(),
        "each header defines `ptc_status` behind one guard, so that it stands alone and several can \
         be included; the definitions are the same text"
            .to_owned(),
    ]);
    rows.push(vec![
        "constParameter".to_owned(),
        "`context` of the functions that a self-test hands to `step`".to_owned(),
        "a style note of cppcheck: the type of such a function is the controller's, and another one \
         may write to its context"
            .to_owned(),
    ]);
    let head = vec!["rule", "where", "reason"];
    finding.tables.push(Table { title: "Deviations".to_owned(), head, rows });
    finding.notes.push(
        "Each controller is checked together with a file that calls all of its functions, as a \
         project would. The addon checks the rules that a tool can decide in one pass; it is no \
         certificate of compliance."
            .to_owned(),
    );
    Ok(finding)
}

/// Defects, and the rule that each violates.
const DEFECTS: [(Defect, &str); 5] = [
    (("*u = 0.0;", "if (t > 0.0) *u = 0.0;", "a body of if without braces"), "15.6"),
    (
        (
            "    return status;",
            "    if (u == NULL) { return PTC_OK; }\n    return status;",
            "two returns",
        ),
        "15.5",
    ),
    (
        (
            "(self != NULL) && (x != NULL)",
            "self != NULL && (x != NULL)",
            "precedence left to the reader",
        ),
        "12.1",
    ),
    (("if (self != NULL) {", "if (self) {", "a condition that is a pointer"), "14.4"),
    (
        (
            "ptc_status ptc_exp2_step(const ptc_exp2 *self, double t, const double x[2], double *u)\n{",
            "ptc_status ptc_exp2_step(const ptc_exp2 *self, double t, const double x[2], double *u)\n{\n    goto out;\nout:",
            "a goto",
        ),
        "15.1",
    ),
];

/// Returns the report of cppcheck on the files of a controller, and on its self-test if it is among them.
fn violations(folder: &Path, spec: &Spec, files: &[PathBuf]) -> Result<String> {
    let caller = folder.join("caller.c");
    let source = files.iter().find(|file| file.extension().is_some_and(|e| e == "c"));
    let source = source.context("no C source")?;
    let name = spec.name();
    let selftest = folder.join(format!("{name}_selftest.c"));
    let selftest = selftest.exists().then_some(selftest);
    fs::write(&caller, calls(&name, &fs::read_to_string(source)?, selftest.is_some()))?;
    let output = Command::new("cppcheck")
        .current_dir(folder)
        .args(["--std=c99", "--enable=style,warning", "--addon=misra", "--quiet"])
        .arg("--suppress=*:caller.c")
        .arg(format!("--suppress=constParameter:*{name}_selftest.c"))
        .args([source, &caller])
        .args(selftest)
        .output()?;
    Ok(String::from_utf8_lossy(&output.stderr).into_owned())
}

/// A file that uses every function of the controller, which would else look local (rule 8.7).
fn calls(name: &str, source: &str, has_selftest: bool) -> String {
    let functions =
        ["init", "arm", "step", "tick", "axis", "rate", "state", "control", "time", "start"];
    let mut used: Vec<_> = functions
        .into_iter()
        .filter(|function| source.contains(&format!("{name}_{function}(")))
        .collect();
    let mut text = format!("#include \"{name}.h\"\n");
    if has_selftest {
        let _ = writeln!(text, "#include \"{name}_selftest.h\"");
        used.push("selftest");
    }
    text.push_str("void caller(void);\nvoid caller(void)\n{\n");
    for function in used {
        let _ = writeln!(text, "    (void)&{name}_{function};");
    }
    text.push_str("}\n");
    text
}
