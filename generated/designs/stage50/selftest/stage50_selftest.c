/* Self-test of the prescribed-time controller stage50: see stage50_selftest.h. DO NOT EDIT. */
#include "stage50_selftest.h"
#include "stage50.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage50_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    double r[3]; /* the reference and its derivatives */
    ptc_status status;
    double u;
} stage50_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage50_selftest_session {
    stage50_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage50_selftest_session;

static const stage50_selftest_session stage50_selftest_sessions[3] = {
    {.params = {.u_max = (double)INFINITY}, .first = 0U, .count = 66U},
    {.params = {.u_max = (double)INFINITY}, .first = 66U, .count = 1U},
    {.params = {.u_max = 1.0}, .first = 67U, .count = 2U},
};

static const stage50_selftest_call stage50_selftest_calls[69] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .r = {-0.25, -0.75, -1.25}, .status = PTC_OK, .u = -56.7613231819995},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875, 0.225625}, .r = {-0.225625, -0.676875, -1.128125}, .status = PTC_OK, .u = -57.68607327690008},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075, 0.2025}, .r = {-0.2025, -0.6075, -1.0125000000000002}, .status = PTC_OK, .u = -58.563320728059054},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.5418749999999999, 0.18062499999999998}, .r = {-0.18062499999999998, -0.5418749999999999, -0.903125}, .status = PTC_OK, .u = -59.38332390654828},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.421875, 0.140625}, .r = {-0.140625, -0.421875, -0.703125}, .status = PTC_OK, .u = -60.80123595965136},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.36749999999999994, 0.12249999999999998}, .r = {-0.12249999999999998, -0.36749999999999994, -0.6124999999999999}, .status = PTC_OK, .u = -61.366197231160086},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.27, 0.09}, .r = {-0.09, -0.27, -0.44999999999999996}, .status = PTC_OK, .u = -62.09124320553716},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.22687500000000005, 0.07562500000000001}, .r = {-0.07562500000000001, -0.22687500000000005, -0.37812500000000004}, .status = PTC_OK, .u = -62.18364127456608},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875, 0.0625}, .r = {-0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -62.0327412412668},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.151875, 0.050625}, .r = {-0.050625, -0.151875, -0.25312500000000004}, .status = PTC_OK, .u = -61.57056941950698},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.046875, 0.015625}, .r = {-0.015625, -0.046875, -0.078125}, .status = PTC_OK, .u = -54.00505149776819},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.030000000000000006, 0.010000000000000002}, .r = {-0.010000000000000002, -0.030000000000000006, -0.05000000000000001}, .status = PTC_OK, .u = -49.36288125166302},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075000000000000015, 0.0025000000000000005}, .r = {-0.0025000000000000005, -0.0075000000000000015, -0.012500000000000002}, .status = PTC_OK, .u = -32.0895516704623},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.0018750000000000004, 0.0006250000000000001}, .r = {-0.0006250000000000001, -0.0018750000000000004, -0.0031250000000000006}, .status = PTC_OK, .u = -8.022387917615575},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .r = {-0.25, -0.75, -1.25}, .status = PTC_OK, .u = -56.7613231819995},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875, 0.225625}, .r = {-0.225625, -0.676875, -1.128125}, .status = PTC_OK, .u = -57.68607327690008},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075, 0.2025}, .r = {-0.2025, -0.6075, -1.0125000000000002}, .status = PTC_OK, .u = -58.563320728059054},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5418749999999999, 0.18062499999999998}, .r = {-0.18062499999999998, -0.5418749999999999, -0.903125}, .status = PTC_OK, .u = -59.38332390654828},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.421875, 0.140625}, .r = {-0.140625, -0.421875, -0.703125}, .status = PTC_OK, .u = -60.80123595965136},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.36749999999999994, 0.12249999999999998}, .r = {-0.12249999999999998, -0.36749999999999994, -0.6124999999999999}, .status = PTC_OK, .u = -61.366197231160086},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.27, 0.09}, .r = {-0.09, -0.27, -0.44999999999999996}, .status = PTC_OK, .u = -62.09124320553716},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.22687500000000005, 0.07562500000000001}, .r = {-0.07562500000000001, -0.22687500000000005, -0.37812500000000004}, .status = PTC_OK, .u = -62.18364127456608},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875, 0.0625}, .r = {-0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -62.0327412412668},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.151875, 0.050625}, .r = {-0.050625, -0.151875, -0.25312500000000004}, .status = PTC_OK, .u = -61.57056941950698},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.046875, 0.015625}, .r = {-0.015625, -0.046875, -0.078125}, .status = PTC_OK, .u = -54.00505149776819},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.030000000000000006, 0.010000000000000002}, .r = {-0.010000000000000002, -0.030000000000000006, -0.05000000000000001}, .status = PTC_OK, .u = -49.36288125166302},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075000000000000015, 0.0025000000000000005}, .r = {-0.0025000000000000005, -0.0075000000000000015, -0.012500000000000002}, .status = PTC_OK, .u = -32.0895516704623},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.0018750000000000004, 0.0006250000000000001}, .r = {-0.0006250000000000001, -0.0018750000000000004, -0.0031250000000000006}, .status = PTC_OK, .u = -8.022387917615575},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 16U, .y = {-4.517489646350663e307, -9.834019230710994e307}, .r = {1.1340668329208174e308, -1.5221339168780335e308, -1.5795317465052136e308}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.4245819231911655, 0.6976758619514108}, .r = {-0.6274617147180335, 0.7171391307478896, 0.5028042534304605}, .status = PTC_SATURATED, .u = 1.0},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.9510585106050826, 0.7057780223884839}, .r = {0.645465458477147, -0.39033770622721276, -0.6328915161608558}, .status = PTC_SATURATED, .u = -1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage50_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage50_selftest_check(stage50 *self, const stage50_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage50_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage50_step(self, call->k, call->y, call->r, &u) != call->status) {
        failures++;
    }
    failures += stage50_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage50_selftest_calls_of(stage50 *self, const stage50_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage50_selftest_check(self, &stage50_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage50_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage50_selftest_session *session = &stage50_selftest_sessions[i];
        stage50 self;

        if (stage50_init(&self, &session->params) == PTC_OK) {
            failures += stage50_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage50_selftest_refuse(void)
{
    static const stage50_params refused[5] = {
        {.u_max = (double)NAN},
        {.u_max = -(double)INFINITY},
        {.u_max = 0.0},
        {.u_max = -1.0},
        {.u_max = -1.7976931348623157e308},
    };
    const stage50_selftest_session *session = &stage50_selftest_sessions[0];
    uint32_t failures = 0U;
    stage50 self;

    if (stage50_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage50_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage50_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage50_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage50_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage50_selftest_pointers(void)
{
    const stage50_selftest_session *session = &stage50_selftest_sessions[0];
    const stage50_selftest_call *call = &stage50_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage50 self;

    if (stage50_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage50_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage50_step(NULL, call->k, call->y, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage50_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage50_step(&self, call->k, NULL, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage50_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage50_step(&self, call->k, call->y, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage50_selftest_differs(u, 0.0);
    if (stage50_step(&self, call->k, call->y, call->r, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage50_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage50_selftest(void)
{
    uint32_t failures = stage50_selftest_run();

    failures += stage50_selftest_refuse();
    failures += stage50_selftest_pointers();
    return failures;
}
