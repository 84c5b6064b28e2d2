/* Self-test of the prescribed-time controller stage2: see stage2_selftest.h. DO NOT EDIT. */
#include "stage2_selftest.h"
#include "stage2.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage2_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3]; /* what is measured */
    ptc_status status;
    double u;
} stage2_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage2_selftest_session {
    stage2_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage2_selftest_session;

static const stage2_selftest_session stage2_selftest_sessions[2] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 36U},
    {.params = {.none = (char)0}, .first = 36U, .count = 1U},
};

static const stage2_selftest_call stage2_selftest_calls[37] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25}, .status = PTC_OK, .u = -8499307.782796914},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875, 0.225625, -0.225625}, .status = PTC_OK, .u = -8819766.12797619},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_OK, .u = -9164153.994360901},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.5418749999999999, 0.18062499999999998, -0.18062499999999998}, .status = PTC_OK, .u = -9534993.055555554},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.421875, 0.140625, -0.140625}, .status = PTC_OK, .u = -10367555.951286765},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.36749999999999994, 0.12249999999999998, -0.12249999999999998}, .status = PTC_OK, .u = -10835761.6997549},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.27, 0.09, -0.09}, .status = PTC_OK, .u = -11893776.593406595},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.22687500000000005, 0.07562500000000001, -0.07562500000000001}, .status = PTC_OK, .u = -12490528.192536633},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_OK, .u = -13135871.13927739},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.151875, 0.050625, -0.050625}, .status = PTC_OK, .u = -13829781.068181818},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.046875, 0.015625, -0.015625}, .status = PTC_OK, .u = -16757790.550595239},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.030000000000000006, 0.010000000000000002, -0.010000000000000002}, .status = PTC_OK, .u = -17157126.952380955},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075000000000000015, 0.0025000000000000005, -0.0025000000000000005}, .status = PTC_OK, .u = -7504995.416666668},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.0018750000000000004, 0.0006250000000000001, -0.0006250000000000001}, .status = PTC_OK, .u = -1876248.854166667},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25}, .status = PTC_OK, .u = -8499307.782796914},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875, 0.225625, -0.225625}, .status = PTC_OK, .u = -8819766.12797619},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_OK, .u = -9164153.994360901},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5418749999999999, 0.18062499999999998, -0.18062499999999998}, .status = PTC_OK, .u = -9534993.055555554},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.421875, 0.140625, -0.140625}, .status = PTC_OK, .u = -10367555.951286765},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.36749999999999994, 0.12249999999999998, -0.12249999999999998}, .status = PTC_OK, .u = -10835761.6997549},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.27, 0.09, -0.09}, .status = PTC_OK, .u = -11893776.593406595},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.22687500000000005, 0.07562500000000001, -0.07562500000000001}, .status = PTC_OK, .u = -12490528.192536633},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_OK, .u = -13135871.13927739},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.151875, 0.050625, -0.050625}, .status = PTC_OK, .u = -13829781.068181818},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.046875, 0.015625, -0.015625}, .status = PTC_OK, .u = -16757790.550595239},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.030000000000000006, 0.010000000000000002, -0.010000000000000002}, .status = PTC_OK, .u = -17157126.952380955},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075000000000000015, 0.0025000000000000005, -0.0025000000000000005}, .status = PTC_OK, .u = -7504995.416666668},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.0018750000000000004, 0.0006250000000000001, -0.0006250000000000001}, .status = PTC_OK, .u = -1876248.854166667},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 21U, .y = {-1.2040147699276218e302, -1.1981018081144137e302, -5.94873416800896e301}, .status = PTC_E_RANGE, .u = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage2_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage2_selftest_check(stage2 *self, const stage2_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage2_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage2_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage2_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage2_selftest_calls_of(stage2 *self, const stage2_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage2_selftest_check(self, &stage2_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage2_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 2U; i++) {
        const stage2_selftest_session *session = &stage2_selftest_sessions[i];
        stage2 self;

        if (stage2_init(&self, &session->params) == PTC_OK) {
            failures += stage2_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage2_selftest_refuse(void)
{
    const stage2_selftest_session *session = &stage2_selftest_sessions[0];
    uint32_t failures = 0U;
    stage2 self;

    if (stage2_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage2_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage2_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage2_selftest(void)
{
    uint32_t failures = stage2_selftest_run();

    failures += stage2_selftest_refuse();
    return failures;
}
