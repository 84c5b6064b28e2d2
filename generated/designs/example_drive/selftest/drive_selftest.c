/* Self-test of the prescribed-time controller drive: see drive_selftest.h. DO NOT EDIT. */
#include "drive_selftest.h"
#include "drive.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct drive_selftest_call {
    double t;
    double x[3];
    double u;
    double tolerance;
    ptc_status status;
} drive_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct drive_selftest_session {
    drive_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} drive_selftest_session;

static const drive_selftest_session drive_selftest_sessions[5] = {
    {.params = {.t0 = 0.3, .eps = 4.0000000000000006e-14}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.t0 = 0.3, .eps = 0.025}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.t0 = 0.3, .eps = 0.025}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.t0 = 0.3, .eps = 0.025}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 9U},
    {.params = {.t0 = 0.3, .eps = 4e-5}, .t0 = 0.0, .is_armed_again = 0U, .first = 53U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t drive_selftest_differs(const drive_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t drive_selftest_check(const drive *self, const drive_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = drive_step(self, call->t, call->x, &u);
    uint32_t failures = drive_selftest_differs(call, call->status, status, u);
    return failures;
}

/* Every session with its calls. */
static uint32_t drive_selftest_run(void)
{
    static const drive_selftest_call calls[54] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.5317254166666666, .tolerance = 1.2293825093405683e-14, .status = PTC_OK},
        {.t = 0.39999999999999997, .x = {-0.75, 1.25, -0.5}, .u = -0.51963375, .tolerance = 1.235333464850224e-14, .status = PTC_OK},
        {.t = 0.54, .x = {0.75, -1.25, 0.5}, .u = 0.46254729166666664, .tolerance = 1.2585683213970603e-14, .status = PTC_OK},
        {.t = 0.6599999999999999, .x = {-0.75, 1.25, -0.5}, .u = 1.5497495833333204, .tolerance = 4.641286353396372e-14, .status = PTC_OK},
        {.t = 0.696, .x = {0.004809774745959439, -0.008016291243265732, 0.003206516497306293}, .u = -12.0, .tolerance = 2.4383986790204745e-13, .status = PTC_OK},
        {.t = 0.69996, .x = {-4.800159238078182e-9, 8.00026539679697e-9, -3.200106158718788e-9}, .u = 12.0, .tolerance = 2.4267454527603177e-13, .status = PTC_OK},
        {.t = 0.6999995999999999, .x = {4.8000016023361536e-15, -8.000002670560257e-15, 3.2000010682241027e-15}, .u = -11.999999999999998, .tolerance = 2.426646352600946e-13, .status = PTC_OK},
        {.t = 0.6999999960000001, .x = {-4.7999998085803256e-21, 7.99999968096721e-21, -3.1999998723868837e-21}, .u = 12.000000000000002, .tolerance = 2.4266453625910053e-13, .status = PTC_OK},
        {.t = 0.69999999996, .x = {4.800021175666925e-27, -8.000035292778209e-27, 3.2000141171112834e-27}, .u = -12.0, .tolerance = 2.4266453526910044e-13, .status = PTC_OK},
        {.t = 0.6999999999996, .x = {-4.798482566296472e-33, 7.997470943827453e-33, -3.1989883775309815e-33}, .u = 12.000000000000002, .tolerance = 2.4266453525920043e-13, .status = PTC_OK},
        {.t = 0.46, .x = {1.0, 0.0, 0.0}, .u = -0.011574074074074077, .tolerance = 2.340514421866324e-16, .status = PTC_OK},
        {.t = 0.46, .x = {0.0, 1.0, 0.0}, .u = 0.02864411111111111, .tolerance = 6.141380481128732e-16, .status = PTC_OK},
        {.t = 0.46, .x = {0.0, 0.0, 1.0}, .u = 1.101, .tolerance = 2.4764471110022462e-14, .status = PTC_OK},
        {.t = 0.6799999999999999, .x = {0.6000000000000065, 0.0, 0.0}, .u = -12.0, .tolerance = 2.426645352591004e-13, .status = PTC_OK},
        {.t = 0.6799999999999999, .x = {0.0, 1.0, 0.0}, .u = -0.1696003333333319, .tolerance = 5.0396655056767844e-15, .status = PTC_OK},
        {.t = 0.6799999999999999, .x = {0.0, 0.0, 1.0}, .u = 0.001000000000004327, .tolerance = 3.002022204460491e-14, .status = PTC_OK},
        {.t = 0.5800000000000001, .x = {0.0, 0.0, 1.0}, .u = 1.001, .tolerance = 2.5242266649529958e-14, .status = PTC_OK},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {(double)NAN, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, (double)NAN, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, -1.25, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, (double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, -1.25, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {-(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, -(double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.75, -1.25, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.09999999999999998, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.65, .x = {0.75, -1.25, 0.5}, .u = -0.5971995833333341, .tolerance = 2.6287604945542663e-14, .status = PTC_OK},
        {.t = 0.65, .x = {-0.75, 1.25, -0.5}, .u = 0.5971995833333341, .tolerance = 2.6287604945542663e-14, .status = PTC_OK},
        {.t = 0.6875, .x = {0.75, -1.25, 0.5}, .u = -7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.6875, .x = {-0.75, 1.25, -0.5}, .u = 7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.7, .x = {0.75, -1.25, 0.5}, .u = -7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.7, .x = {-0.75, 1.25, -0.5}, .u = 7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.8, .x = {0.75, -1.25, 0.5}, .u = -7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5}, .u = 7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 4.7, .x = {0.75, -1.25, 0.5}, .u = -7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 4.7, .x = {-0.75, 1.25, -0.5}, .u = 7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = -0.5317254166666666, .tolerance = 1.2293825093405683e-14, .status = PTC_OK},
        {.t = 1000.38, .x = {-0.75, 1.25, -0.5}, .u = -0.4004170833334003, .tolerance = 1.2772946564184917e-14, .status = PTC_OK},
        {.t = 1000.5, .x = {-0.75, 1.25, -0.5}, .u = 7.437399583333333, .tolerance = 1.6881143445215088e-13, .status = PTC_HOLD},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {9.175239427023289, -15.292065711705483, 6.116826284682193}, .u = 6.0, .tolerance = 1.5269629440425816e-13, .status = PTC_OK},
        {.t = 0.5, .x = {55.051436562139735, -91.75239427023288, 36.700957708093156}, .u = 24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.5, .x = {-55.051436562139735, 91.75239427023288, -36.700957708093156}, .u = -24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.7, .x = {0.6050501858316407, -1.008416976386068, 0.40336679055442715}, .u = -6.000000000000001, .tolerance = 1.3618585304770628e-13, .status = PTC_HOLD},
        {.t = 0.7, .x = {3.6303011149898445, -6.050501858316407, 2.420200743326563}, .u = -24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.7, .x = {-3.6303011149898445, 6.050501858316407, -2.420200743326563}, .u = 24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.9000000000000001, .x = {0.6050501858316407, -1.008416976386068, 0.40336679055442715}, .u = -6.000000000000001, .tolerance = 1.3618585304770628e-13, .status = PTC_HOLD},
        {.t = 0.9000000000000001, .x = {3.6303011149898445, -6.050501858316407, 2.420200743326563}, .u = -24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.9000000000000001, .x = {-3.6303011149898445, 6.050501858316407, -2.420200743326563}, .u = 24.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.7, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const drive_selftest_session *session = &drive_selftest_sessions[i];
        drive self;
        ptc_status status = drive_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = drive_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += drive_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t drive_selftest_refuse(void)
{
    static const drive_params refused[10] = {
        {.t0 = (double)NAN, .eps = 0.025},
        {.t0 = (double)INFINITY, .eps = 0.025},
        {.t0 = -(double)INFINITY, .eps = 0.025},
        {.t0 = 0.3, .eps = (double)NAN},
        {.t0 = 0.3, .eps = (double)INFINITY},
        {.t0 = 0.3, .eps = 0.0},
        {.t0 = 0.3, .eps = -1.0},
        {.t0 = 0.3, .eps = 7.5e-151},
        {.t0 = 0.3, .eps = 0.4},
        {.t0 = 0.3, .eps = 0.8},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const drive_selftest_session *session = &drive_selftest_sessions[0];
    const drive_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.5317254166666666, .tolerance = 1.2293825093405683e-14, .status = PTC_OK};
    uint32_t failures = 0U;
    drive self;

    if (drive_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 10U; i++) {
        if (drive_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (drive_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += drive_selftest_check(&self, &call);
    if (drive_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (drive_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (drive_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t drive_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t drive_selftest_pointers(void)
{
    const drive_selftest_session *session = &drive_selftest_sessions[0];
    const drive_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.5317254166666666, .tolerance = 1.2293825093405683e-14, .status = PTC_OK};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    drive self;

    if (drive_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = drive_step(NULL, call.t, call.x, &u);
    failures += drive_selftest_refused(status, u);
    u = 12345.0;
    status = drive_step(&self, call.t, NULL, &u);
    failures += drive_selftest_refused(status, u);
    status = drive_step(&self, call.t, call.x, NULL);
    failures += drive_selftest_refused(status, 0.0);
    return failures;
}

uint32_t drive_selftest(void)
{
    uint32_t failures = drive_selftest_run();

    failures += drive_selftest_refuse();
    failures += drive_selftest_pointers();
    return failures;
}
