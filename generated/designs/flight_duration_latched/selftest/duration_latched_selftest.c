/* Self-test of the prescribed-time controller duration_latched: see duration_latched_selftest.h. DO NOT EDIT. */
#include "duration_latched_selftest.h"
#include "duration_latched.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct duration_latched_selftest_call {
    double t;
    double x[2];
    double u;
    double tolerance;
    ptc_status status;
} duration_latched_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct duration_latched_selftest_session {
    duration_latched_params params;
    double x0[2];
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    double tau; /* of arm_for, where that is called */
    uint32_t is_armed_for;
    uint32_t first; /* of its calls */
    uint32_t count;
} duration_latched_selftest_session;

static const duration_latched_selftest_session duration_latched_selftest_sessions[7] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 2e-13, .u_max = (double)INFINITY, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.0, .is_armed_for = 0U, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 24U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.0, .is_armed_for = 0U, .t0 = 0.0, .is_armed_again = 0U, .first = 24U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.0, .is_armed_for = 0U, .t0 = 1000.1, .is_armed_again = 1U, .first = 34U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.875, .is_armed_for = 1U, .t0 = -3.7, .is_armed_again = 0U, .first = 38U, .count = 8U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 3.3125, .is_armed_for = 1U, .t0 = 0.2, .is_armed_again = 1U, .first = 46U, .count = 8U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 6.562500000000002, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.0, .is_armed_for = 0U, .t0 = 0.0, .is_armed_again = 0U, .first = 54U, .count = 7U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.0002, .u_max = 1.0, .c = 1.0}, .x0 = {0.375, -0.625}, .tau = 0.0, .is_armed_for = 0U, .t0 = 0.0, .is_armed_again = 0U, .first = 61U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t duration_latched_selftest_differs(const duration_latched_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t duration_latched_selftest_check(const duration_latched *self, const duration_latched_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = duration_latched_step(self, call->t, call->x, &u);
    uint32_t failures = duration_latched_selftest_differs(call, call->status, status, u);
    return failures;
}

/* Every session with its calls. */
static uint32_t duration_latched_selftest_run(void)
{
    static const duration_latched_selftest_call calls[62] = {
        {.t = 0.3, .x = {0.75, -1.25}, .u = 0.6044921875, .tolerance = 3.033411859922896e-11, .status = PTC_OK},
        {.t = 0.8, .x = {-0.75, 1.25}, .u = 0.9717325498575501, .tolerance = 3.8054791978796344e-11, .status = PTC_OK},
        {.t = 1.5, .x = {0.75, -1.25}, .u = -15.1308906369093, .tolerance = 9.555884217832725e-11, .status = PTC_OK},
        {.t = 2.1, .x = {-0.75, 1.25}, .u = 2923.2067307692364, .tolerance = 6.497062543822122e-9, .status = PTC_OK},
        {.t = 2.28, .x = {0.75, -1.25}, .u = -27838795.028143965, .tolerance = 5.6919109198031505e-5, .status = PTC_OK},
        {.t = 2.2998, .x = {-0.75, 1.25}, .u = 2841796946098035.0, .tolerance = 5684.225522876269, .status = PTC_OK},
        {.t = 2.299998, .x = {0.75, -1.25}, .u = -2.783203124995507e23, .tolerance = 568421174529.2299, .status = PTC_OK},
        {.t = 2.29999998, .x = {-0.75, 1.25}, .u = 2.8417968494329033e31, .tolerance = 5.684224704524523e19, .status = PTC_OK},
        {.t = 2.2999999998, .x = {0.75, -1.25}, .u = -2.783192933961711e39, .tolerance = 5.684190931802525e27, .status = PTC_OK},
        {.t = 2.299999999998, .x = {-0.75, 1.25}, .u = 2.842363910276339e47, .tolerance = 5.68535895212419e35, .status = PTC_OK},
        {.t = 1.1, .x = {1.0, 0.0}, .u = -17.092267071759263, .tolerance = 3.4726668509578123e-11, .status = PTC_OK},
        {.t = 1.1, .x = {0.0, 1.0}, .u = -7.654577332840012, .tolerance = 1.8581433880808608e-11, .status = PTC_OK},
        {.t = 2.1999999999999997, .x = {1.0, 0.0}, .u = -60727.82812499939, .tolerance = 1.2338182803660275e-7, .status = PTC_OK},
        {.t = 2.1999999999999997, .x = {0.0, 1.0}, .u = -7.026144801982531, .tolerance = 2.005949270513572e-9, .status = PTC_OK},
        {.t = (double)NAN, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = (double)INFINITY, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -(double)INFINITY, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {(double)NAN, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {(double)INFINITY, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {-(double)INFINITY, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -0.7, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 2.05, .x = {0.75, -1.25}, .u = -1190.1148897058792, .tolerance = 2.8596815380022583e-9, .status = PTC_OK},
        {.t = 2.05, .x = {-0.75, 1.25}, .u = 1217.2086397058792, .tolerance = 2.859687554023273e-9, .status = PTC_OK},
        {.t = 2.2375, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = 2.2375, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 2.3, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = 2.3, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 2.8, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = 2.8, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 22.3, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = 22.3, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 1000.1, .x = {-0.75, 1.25}, .u = -0.4580078125, .tolerance = 3.033408607316378e-11, .status = PTC_OK},
        {.t = 1001.5, .x = {-0.75, 1.25}, .u = 44.343818082782576, .tolerance = 1.8314192691557141e-10, .status = PTC_OK},
        {.t = 1002.1, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 0.3, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -3.7, .x = {0.75, -1.25}, .u = -10.887552211375791, .tolerance = 8.04277458100372e-11, .status = PTC_OK},
        {.t = -3.7, .x = {-0.75, 1.25}, .u = 11.386133531659006, .tolerance = 8.042785651732949e-11, .status = PTC_OK},
        {.t = -3.35, .x = {0.75, -1.25}, .u = -70.19086190110903, .tolerance = 2.6011640879228597e-10, .status = PTC_OK},
        {.t = -3.35, .x = {-0.75, 1.25}, .u = 72.19893772214039, .tolerance = 2.6011685467468835e-10, .status = PTC_OK},
        {.t = -3.04375, .x = {0.75, -1.25}, .u = -2009.4096702690767, .tolerance = 4.656624614283201e-9, .status = PTC_OK},
        {.t = -3.04375, .x = {-0.75, 1.25}, .u = 2054.3647280574983, .tolerance = 4.656634596311247e-9, .status = PTC_OK},
        {.t = -2.825, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = -2.825, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 0.2, .x = {0.75, -1.25}, .u = 1.454772909846769, .tolerance = 2.459240127402491e-11, .status = PTC_OK},
        {.t = 0.2, .x = {-0.75, 1.25}, .u = -1.3431563184437862, .tolerance = 2.459237649016297e-11, .status = PTC_OK},
        {.t = 1.5250000000000001, .x = {0.75, -1.25}, .u = 0.5849393914825892, .tolerance = 3.045356398094637e-11, .status = PTC_OK},
        {.t = 1.5250000000000001, .x = {-0.75, 1.25}, .u = -0.4377147375621576, .tolerance = 3.0453531290506256e-11, .status = PTC_OK},
        {.t = 2.684375, .x = {0.75, -1.25}, .u = -13.335664465826916, .tolerance = 8.926153183414088e-11, .status = PTC_OK},
        {.t = 2.684375, .x = {-0.75, 1.25}, .u = 13.902158269404923, .tolerance = 8.926165762103369e-11, .status = PTC_OK},
        {.t = 3.5125, .x = {0.75, -1.25}, .u = -18427.89543269231, .tolerance = 3.9277070180145575e-8, .status = PTC_HOLD},
        {.t = 3.5125, .x = {-0.75, 1.25}, .u = 18823.98918269231, .tolerance = 3.927715813062581e-8, .status = PTC_HOLD},
        {.t = 1.3, .x = {0.1875, -0.3125}, .u = -1.5000000000000004, .tolerance = 1.625033306690739e-11, .status = PTC_OK},
        {.t = 1.3, .x = {1.125, -1.875}, .u = -6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.3, .x = {-1.125, 1.875}, .u = 6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 2.3, .x = {6.677207142260353e-5, -0.00011128678570433923}, .u = 6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 2.3, .x = {0.026708828569041415, -0.04451471428173569}, .u = -6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 3.3, .x = {6.677207142260353e-5, -0.00011128678570433923}, .u = 6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 3.3, .x = {0.026708828569041415, -0.04451471428173569}, .u = -6.562500000000002, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.3, .x = {-1.7976931348623157e308, 1.3482698511467367e308}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 7U; i++) {
        const duration_latched_selftest_session *session = &duration_latched_selftest_sessions[i];
        duration_latched self;
        ptc_status status = duration_latched_init(&self, &session->params, session->x0);

        if ((status == PTC_OK) && (session->is_armed_for != 0U)) {
            status = duration_latched_arm_for(&self, session->t0, session->tau, session->x0);
        }
        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = duration_latched_arm(&self, session->t0, session->x0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += duration_latched_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t duration_latched_selftest_refuse(void)
{
    static const duration_latched_params refused[25] = {
        {.tau = (double)NAN, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = (double)INFINITY, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 0.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = -1.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 7.5e-151, .t0 = 0.3, .eps = 4.6875e-152, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 1.25e150, .t0 = 0.3, .eps = 7.8125e148, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = (double)NAN, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = (double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = -(double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)NAN, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.0, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = -1.0, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 7.5e-151, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 2.0, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 4.0, .u_max = (double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)NAN, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.0, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -1.0, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -(double)INFINITY, .c = 1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = (double)NAN},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = -(double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = -0.25},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .c = 3.5},
    };
    /* States, each with a start behind it. */
    static const double states[4][3] = {
        {(double)NAN, 0.5, 0.3},
        {(double)INFINITY, 0.5, 0.3},
        {0.5, (double)NAN, 0.3},
        {0.5, (double)INFINITY, 0.3},
    };
    static const double durations[7] = {(double)NAN, (double)INFINITY, 0.0, -1.0, 7.5e-151, 1.25e150, 2e-13};
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const duration_latched_selftest_session *session = &duration_latched_selftest_sessions[0];
    const duration_latched_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = 0.6044921875, .tolerance = 3.033411859922896e-11, .status = PTC_OK};
    uint32_t failures = 0U;
    duration_latched self;

    if (duration_latched_init(&self, &session->params, session->x0) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 25U; i++) {
        if (duration_latched_init(&self, &refused[i], session->x0) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        if (duration_latched_arm(&self, states[i][2], states[i]) != PTC_E_PARAM) {
            failures++;
        }
        if (duration_latched_arm_for(&self, states[i][2], session->params.tau, states[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (duration_latched_init(&self, &session->params, states[0]) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_latched_arm(&self, session->t0, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_latched_arm_for(&self, session->t0, session->params.tau, NULL) != PTC_E_PARAM) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (duration_latched_arm(&self, starts[i], session->x0) != PTC_E_PARAM) {
            failures++;
        }
        if (duration_latched_arm_for(&self, starts[i], session->params.tau, session->x0) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 7U; i++) {
        if (duration_latched_arm_for(&self, session->t0, durations[i], session->x0) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += duration_latched_selftest_check(&self, &call);
    if (duration_latched_init(&self, NULL, session->x0) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_latched_init(NULL, &session->params, session->x0) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_latched_arm(NULL, session->t0, session->x0) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_latched_arm_for(NULL, session->t0, session->params.tau, session->x0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (duration_latched_arm(&self, 1.7976931348623157e308, session->x0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t duration_latched_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t duration_latched_selftest_pointers(void)
{
    const duration_latched_selftest_session *session = &duration_latched_selftest_sessions[0];
    const duration_latched_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = 0.6044921875, .tolerance = 3.033411859922896e-11, .status = PTC_OK};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    duration_latched self;

    if (duration_latched_init(&self, &session->params, session->x0) != PTC_OK) {
        failures++;
    }
    status = duration_latched_step(NULL, call.t, call.x, &u);
    failures += duration_latched_selftest_refused(status, u);
    u = 12345.0;
    status = duration_latched_step(&self, call.t, NULL, &u);
    failures += duration_latched_selftest_refused(status, u);
    status = duration_latched_step(&self, call.t, call.x, NULL);
    failures += duration_latched_selftest_refused(status, 0.0);
    return failures;
}

uint32_t duration_latched_selftest(void)
{
    uint32_t failures = duration_latched_selftest_run();

    failures += duration_latched_selftest_refuse();
    failures += duration_latched_selftest_pointers();
    return failures;
}
