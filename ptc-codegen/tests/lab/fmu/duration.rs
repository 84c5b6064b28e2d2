//! An FMU with a clock in time whose duration changes, call by call against the C in it.

use super::steering::imported;
use super::support::folder;

/// An importer that asks for other deadlines, tunes a parameter, and calls `arm_for` of the C for the same; it prints how
/// many calls went wrong, how many u or deadlines differ, and what is left at the end.
const MASTER: &str = r#"#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "fmi2Functions.h"
#include "stage.h"

static int wrong;

static void logger(fmi2ComponentEnvironment e, fmi2String i, fmi2Status s, fmi2String c, fmi2String m, ...)
{
    (void)e; (void)i; (void)s; (void)c; (void)m;
    wrong++;
}

static fmi2Component fmu;
static double real(fmi2ValueReference vr) { double v = NAN; (void)fmi2GetReal(fmu, &vr, 1, &v); return v; }
static int set(fmi2ValueReference vr, double v) { return fmi2SetReal(fmu, &vr, 1, &v) == fmi2OK; }

int main(void)
{
    const fmi2CallbackFunctions functions = { logger, calloc, free, NULL, NULL };
    const double h = 0.001, t0 = 0.25;
    double x[2] = { 1.0, 0.0 }, t = t0, rest = 0.0, begun = t0;
    int k, ok = 1, differ = 0;
    stage own;
    stage_params params;

    fmu = fmi2Instantiate("i", fmi2CoSimulation, TOKEN, "", &functions, 0, 0);
    fmi2SetupExperiment(fmu, 0, 0.0, t0, 0, 0.0);
    params.tau = 0.9;
    params.t0 = t0;
    params.eps = 0.02;
    params.u_max = 1e9;
    params.a = 1.0;
    ok = set(VR_tau, params.tau) && set(VR_t0, params.t0) && set(VR_eps, params.eps) && set(VR_u_max, params.u_max)
        && set(VR_a, params.a);
    fmi2EnterInitializationMode(fmu);
    ok = ok && set(VR_x1, x[0]) && set(VR_x2, x[1]) && (fmi2ExitInitializationMode(fmu) == fmi2OK);
    ok = ok && (stage_init(&own, &params LATCHED) == PTC_OK);
    rest = params.tau;
    for (k = 0; k < 2200; k++) {
        double u = 0.0, deadline = NAN;

        if (k == 300) { deadline = 0.5; }
        if (k == 350) { deadline = 1.4; }
        if (k == 1500) { deadline = 2.1; }
        if (k == 700) { /* a parameter that is tuned restarts it, and the deadline asked for stays */
            ok = ok && set(VR_eps, 0.03);
            params.eps = 0.03;
            ok = ok && (stage_init(&own, &params LATCHED) == PTC_OK);
        }
        ok = ok && set(VR_x1, x[0]) && set(VR_x2, x[1]);
        if (deadline == deadline) {
            ok = ok && set(VR_deadline, deadline);
            rest = deadline;
        }
        if ((deadline == deadline) || (k == 700)) {
            begun = t;
            ok = ok && (stage_arm_for(&own, t, rest - (t - t0) LATCHED) == PTC_OK);
        }
        (void)stage_step(&own, t, x, &u);
        differ += real(VR_u) != u;
        differ += !(fabs(real(VR_deadline_planned) - rest) < 1e-12);
        ok = ok && (fmi2DoStep(fmu, t, h, 0) == fmi2OK);
        x[0] += h * x[1] + h * h / 2.0 * u;
        x[1] += h * u;
        t += h;
    }
    (void)begun;
    printf("%d %d %d %g ", ok, wrong, differ, fmax(fabs(x[0]), fabs(x[1])));
    /* What is left is no legal tau, and the deadline stays. */
    ok = set(VR_deadline, 0.1);
    differ = real(VR_u) == real(VR_u);
    printf("%d %d\n", differ, wrong > 0);
    fmi2FreeInstance(fmu);
    return 0;
}
"#;

#[test]
fn deadlines_asked_for_are_durations() {
    let folder = folder("fmu_duration");
    let law = ["--n=2", "--mu=exp", "--poles=-4,-5", "--in-flight"];
    let found = imported(&folder.join("linear"), &law, MASTER, &["-DLATCHED="]);
    let [ok, wrong, differ, left, given, told] = found[..] else { panic!("{found:?}") };
    assert_eq!((ok, wrong, differ), (1.0, 0.0, 0.0));
    assert!(left < 1e-6, "{left}");
    assert_eq!((given, told), (0.0, 1.0));
}
