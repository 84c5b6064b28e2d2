//! An FMU with a clock in samples in an importer, in either order of its calls.

use std::fs;
use std::process::Command;

use super::support::folder;
use super::{entries, text, written};

/// An importer that sets inputs, reads u and steps, or steps and then reads u, with a plant in which u acts from the
/// next sample on.
const MASTER: &str = r#"#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "fmi2Functions.h"

static void logger(fmi2ComponentEnvironment e, fmi2String i, fmi2Status s, fmi2String c, fmi2String m, ...)
{
    (void)e; (void)i; (void)s; (void)c;
    fprintf(stderr, "%s\n", m);
}

static double left(int reads_behind)
{
    const fmi2CallbackFunctions functions = { logger, calloc, free, NULL, NULL };
    const fmi2ValueReference inputs[2] = { 1, 2 }, output[1] = { 3 };
    fmi2Component c = fmi2Instantiate("i", fmi2CoSimulation, TOKEN, "", &functions, 0, 0);
    double x[2] = { 1.0, 0.0 }, u = 0.0, acting = 0.0, again, h = 0.01;
    int k, ok;
    fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0);
    fmi2EnterInitializationMode(c);
    fmi2SetReal(c, inputs, 2, x);
    ok = fmi2ExitInitializationMode(c) == fmi2OK;
    for (k = 0; k < 100; k++) {
        ok = ok && (fmi2SetReal(c, inputs, 2, x) == fmi2OK);
        if (!reads_behind) {
            ok = ok && (fmi2GetReal(c, output, 1, &u) == fmi2OK);
        }
        ok = ok && (fmi2DoStep(c, k * h, h, 0) == fmi2OK);
        ok = ok && (fmi2GetReal(c, output, 1, &again) == fmi2OK) && (reads_behind || (again == u));
        u = again;
        x[0] += h * x[1] + h * h / 2.0 * acting;
        x[1] += h * acting;
        acting = u;
    }
    fmi2FreeInstance(c);
    return ok ? fmax(fabs(x[0]), fabs(x[1])) : INFINITY;
}

int main(void)
{
    printf("%g %g\n", left(0), left(1));
    return 0;
}
"#;

/// Both orders of calls give one u per sample, which a step holds until inputs are set.
#[test]
fn either_order_of_calls_comes_to_rest() {
    let folder = folder("fmu_orders");
    let design = [
        "--lang=fmu2",
        "--n=2",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--sample-time=0.01",
        "--tau=1",
        "--poles=-4,-5,-6",
        "--delay=1",
        "--name=stage",
        "--u-max=inf",
    ];
    written(&design, &folder);
    let entries = entries(&folder.join("stage.fmu"));
    for name in ["stage.c", "stage.h", "stage_fmu.c"] {
        fs::write(folder.join(name), &entries[&format!("sources/{name}")]).expect("a file");
    }
    let source = text(&entries, "sources/stage_fmu.c");
    let token = source.lines().find_map(|line| line.strip_prefix("#define TOKEN "));
    fs::write(folder.join("master.c"), MASTER).expect("a file");
    let program = folder.join("master");
    let mut compiler = Command::new("cc");
    compiler.arg("-DFMI2_FUNCTION_PREFIX=stage_").arg("-I").arg(&folder);
    compiler.arg("-I").arg(concat!(env!("CARGO_MANIFEST_DIR"), "/templates/fmu"));
    compiler.arg(format!("-DTOKEN={}", token.expect("a token")));
    compiler.args(["stage.c", "stage_fmu.c", "master.c"].map(|name| folder.join(name)));
    let output = compiler.arg("-o").arg(&program).arg("-lm").output().expect("a compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("a program");
    let told = String::from_utf8_lossy(&output.stdout);
    let left: Vec<f64> = told.split_whitespace().map(|x| x.parse().expect("a number")).collect();
    assert_eq!(left.len(), 2, "{told}");
    assert!(left.iter().all(|left| *left < 1e-18), "{told}");
}
