/* Self-test of the prescribed-time controller stage25: see stage25_selftest.h. DO NOT EDIT. */
#include "stage25_selftest.h"
#include "stage25.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage25_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3]; /* what is measured */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} stage25_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage25_selftest_session {
    stage25_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage25_selftest_session;

static const stage25_selftest_session stage25_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 54U},
    {.params = {.none = (char)0}, .first = 54U, .count = 3U},
    {.params = {.none = (char)0}, .first = 57U, .count = 3U},
};

static const stage25_selftest_call stage25_selftest_calls[60] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444}, .status = PTC_SATURATED, .u = {-0.7605714285714287, 3.0}, .axes = {PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_SATURATED, .u = {-0.19014285714285714, 3.0}, .axes = {PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_HOLD, .u = {-0.047535714285714285, 1.055490861368833}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778}, .status = PTC_SATURATED, .u = {-2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444}, .status = PTC_SATURATED, .u = {-0.7605714285714287, 3.0}, .axes = {PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_SATURATED, .u = {-0.19014285714285714, 3.0}, .axes = {PTC_HOLD, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_HOLD, .u = {-0.047535714285714285, 1.055490861368833}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.6475592481261917, -0.3752762418554133, 0.8615129375260748}, .status = PTC_SATURATED, .u = {2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {-416.486022616438, -482.3377912860326, 438.08111636008516}, .status = PTC_SATURATED, .u = {2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {-5.9059359365891206e153, -9.57180389443407e153, -7.625006917078475e153}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {-6.266678621175355e153, -0.0, 0.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_HOLD}},
    {.is_armed = 1U, .start = 0U, .k = 30U, .y = {0.000547770173824777, -5.826174333610712e307, 1.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 0U, .k = 0U, .y = {-1.0, -0.5, 1.5304801963791313e302}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage25_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage25_selftest_check(stage25 *self, const stage25_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage25_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage25_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage25_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage25_selftest_calls_of(stage25 *self, const stage25_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage25_selftest_check(self, &stage25_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage25_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage25_selftest_session *session = &stage25_selftest_sessions[i];
        stage25 self;

        if (stage25_init(&self, &session->params) == PTC_OK) {
            failures += stage25_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage25_selftest_refuse(void)
{
    const stage25_selftest_session *session = &stage25_selftest_sessions[0];
    uint32_t failures = 0U;
    stage25 self;

    if (stage25_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage25_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage25_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage25_selftest_pointers(void)
{
    const stage25_selftest_session *session = &stage25_selftest_sessions[0];
    const stage25_selftest_call *call = &stage25_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage25 self;

    if (stage25_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage25_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage25_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage25_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage25_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage25_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage25_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage25_selftest_differs(u[i], 0.0);
    }
    if (stage25_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage25_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage25_selftest(void)
{
    uint32_t failures = stage25_selftest_run();

    failures += stage25_selftest_refuse();
    failures += stage25_selftest_pointers();
    return failures;
}
