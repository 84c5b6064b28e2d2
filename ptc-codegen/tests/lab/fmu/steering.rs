//! An FMU whose deadline changes in flight, call by call against the C in it.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::support::folder;
use super::{elements, entries, text, written};

/// An importer that moves the target, asks for deadlines, knows states and inputs, and calls the functions of the C with
/// the same; it prints the samples whose u or deadline differ, those with status 5 and -4, and what is left at the end.
const MASTER: &str = r#"#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "fmi2Functions.h"
#include "stage.h"

static void logger(fmi2ComponentEnvironment e, fmi2String i, fmi2Status s, fmi2String c, fmi2String m, ...)
{
    (void)e; (void)i; (void)s; (void)c;
    fprintf(stderr, "%s\n", m);
}

static fmi2Component fmu;
static double real(fmi2ValueReference vr) { double v = NAN; (void)fmi2GetReal(fmu, &vr, 1, &v); return v; }
static int set(fmi2ValueReference vr, double v) { return fmi2SetReal(fmu, &vr, 1, &v) == fmi2OK; }
#ifdef OBSERVED
static int toggle(fmi2ValueReference vr, int v) { return fmi2SetInteger(fmu, &vr, 1, &v) == fmi2OK; }
#endif

int main(void)
{
    const fmi2CallbackFunctions functions = { logger, calloc, free, NULL, NULL };
    const double h = 0.01, d = 0.3;
    double x[2] = { 1.0, 0.0 }, acting = 0.0, target = 0.0, applied = 0.0;
    int k, ok = 1, differ = 0, late = 0, soon = 0;
    stage own;
    stage_params params;

    fmu = fmi2Instantiate("i", fmi2CoSimulation, TOKEN, "", &functions, 0, 0);
    fmi2SetupExperiment(fmu, 0, 0.0, 0.0, 0, 0.0);
    fmi2EnterInitializationMode(fmu);
    ok = set(1, x[0]) && (fmi2ExitInitializationMode(fmu) == fmi2OK);
    (void)params.none;
    (void)stage_init(&own, &params);
    for (k = 0; k < 700; k++) {
        double u = 0.0, y[2];
        fmi2Integer status;
        const fmi2ValueReference of_status = VR_status;
        uint32_t tick = 0u;
        ptc_status expected, arming = PTC_OK;

        if (k == 150) {
            target = 0.5;
            ok = ok && set(VR_target, target);
        }
        y[0] = x[0] - target;
        y[1] = x[1];
        if (k == 150) {
            STAGE_MOVE(0.5);
        }
#ifdef OBSERVED
        if (k > 0) {
            /* The drive gives a tenth less from sample 200 to 220, and says so. */
            ok = ok && toggle(VR_applied, (k > 200) && (k <= 220)) && set(VR_u_applied, applied);
            if ((k > 200) && (k <= 220)) {
                (void)stage_applied(&own, applied);
            }
        }
        if (k == 300) {
            double known[2];
            x[1] += 0.25; /* a kick that is known */
            ok = ok && set(VR_x1_known, x[0]) && set(VR_x2_known, x[1]) && set(VR_d_known, d) && toggle(VR_known, 1);
            known[0] = x[0] - target;
            known[1] = x[1];
            (void)stage_assume(&own, known);
            (void)stage_assume_disturbance(&own, d);
        }
#endif
        if ((k == 160) || (k == 400)) {
            /* The first is too soon for the limits. */
            const uint32_t samples = (k == 160) ? 5u : 200u;
            ok = ok && set(VR_deadline, (k + (int)samples) * h);
            arming = STAGE_ARM_FOR;
        }
        ok = ok && set(1, x[0]);
#ifndef OBSERVED
        ok = ok && set(2, x[1]);
#endif
        expected = stage_step(&own, (uint32_t)k, y, &u);
        (void)stage_deadline(&own, &tick);
        if (arming == PTC_E_SOON) {
            expected = arming;
        }
        ok = ok && (fmi2GetInteger(fmu, &of_status, 1, &status) == fmi2OK);
        late += status == 5;
        soon += status == -4;
        if ((real(VR_u) != u) || (status != (int)expected) || (fabs(real(VR_deadline_planned) - tick * h) > 1e-9)) {
            differ++;
        }
        if (!(real(VR_soonest) > k * h)) {
            differ++;
        }
        ok = ok && (fmi2DoStep(fmu, k * h, h, 0) == fmi2OK);
        applied = ((k >= 200) && (k < 220)) ? 0.9 * u : u;
        {
            const double acts = (DELAY ? acting : applied) + (DISTURBED ? d : 0.0);
            x[0] += h * x[1] + h * h / 2.0 * acts;
            x[1] += h * acts;
        }
        acting = applied;
    }
    printf("%d %d %d %d %g\n", ok, differ, late, soon, fmax(fabs(x[0] - target), fabs(x[1])));
    fmi2FreeInstance(fmu);
    return 0;
}
"#;

/// Returns the numbers that the importer prints for a design.
fn told(folder: &Path, design: &[&str], defines: &[&str]) -> Vec<f64> {
    let common = ["--n=2", "--mu=exp(a=1)", "--clock=samples", "--sample-time=0.01", "--tau=1"];
    imported(folder, &[&common[..], design].concat(), MASTER, defines)
}

/// Returns the numbers that the importer `master` prints for a design.
pub(super) fn imported(folder: &Path, design: &[&str], master: &str, defines: &[&str]) -> Vec<f64> {
    written(&[&["--lang=fmu2", "--name=stage"], design].concat(), folder);
    let entries = entries(&folder.join("stage.fmu"));
    for name in ["stage.c", "stage.h", "stage_fmu.c"] {
        fs::write(folder.join(name), &entries[&format!("sources/{name}")]).expect("a file");
    }
    let source = text(&entries, "sources/stage_fmu.c");
    let token = source.lines().find_map(|line| line.strip_prefix("#define TOKEN "));
    fs::write(folder.join("master.c"), master).expect("a file");
    let program = folder.join("master");
    let mut compiler = Command::new("cc");
    compiler.arg("-DFMI2_FUNCTION_PREFIX=stage_").arg("-I").arg(folder);
    compiler.arg("-I").arg(concat!(env!("CARGO_MANIFEST_DIR"), "/templates/fmu"));
    compiler.arg(format!("-DTOKEN={}", token.expect("a token"))).args(defines);
    for (_, variable) in elements(&text(&entries, "modelDescription.xml")) {
        if let (Some(name), Some(number)) = (variable.get("name"), variable.get("valueReference")) {
            compiler.arg(format!("-DVR_{name}={number}"));
        }
    }
    compiler.args(["-Wall", "-Wextra", "-Werror", "-ffp-contract=off"]);
    compiler.args(["stage.c", "stage_fmu.c", "master.c"].map(|name| folder.join(name)));
    let output = compiler.arg("-o").arg(&program).arg("-lm").output().expect("a compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("a program");
    let told = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.is_empty(), "{errors}");
    told.split_whitespace().map(|x| x.parse().expect("a number")).collect()
}

#[test]
fn inputs_in_flight_are_the_functions_of_the_controller() {
    let folder = folder("fmu_steering");
    let observed = [
        "--measured=x1",
        "--disturbance=constant",
        "--observer-poles=-4,-5,-6",
        "--observer-samples=40",
        "--delay=1",
        "--poles=least-energy",
        "--u-max=20",
        "--late=extend",
    ];
    let defines = [
        "-DOBSERVED",
        "-DDELAY=1",
        "-DDISTURBED=1",
        "-DSTAGE_MOVE(dx)=(void)stage_move(&own,dx)",
        "-DSTAGE_ARM_FOR=stage_arm_for(&own,(uint32_t)k,samples)",
    ];
    let [ok, differ, late, soon, left] = told(&folder.join("extend"), &observed, &defines)[..]
    else {
        panic!("five numbers")
    };
    assert_eq!((ok, differ, soon), (1.0, 0.0, 0.0));
    assert!(late >= 1.0 && left < 1e-9, "{late} {left}");
    let states = ["--poles=least-energy", "--u-max=20", "--late=refuse"];
    let defines = [
        "-DDELAY=0",
        "-DDISTURBED=0",
        "-DSTAGE_MOVE(dx)=(void)0",
        "-DSTAGE_ARM_FOR=stage_arm_for(&own,(uint32_t)k,samples,y)",
    ];
    let [ok, differ, late, soon, left] = told(&folder.join("refuse"), &states, &defines)[..] else {
        panic!("five numbers")
    };
    assert_eq!((ok, differ, late, soon), (1.0, 0.0, 0.0, 1.0));
    assert!(left < 1e-12, "{left}");
}
