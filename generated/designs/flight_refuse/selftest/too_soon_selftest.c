/* Self-test of the prescribed-time controller too_soon: see too_soon_selftest.h. DO NOT EDIT. */
#include "too_soon_selftest.h"
#include "too_soon.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct too_soon_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[3]; /* what is measured */
    ptc_status status;
    float u;
} too_soon_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct too_soon_selftest_session {
    too_soon_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} too_soon_selftest_session;

static const too_soon_selftest_session too_soon_selftest_sessions[2] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 54U},
    {.params = {.none = (char)0}, .first = 54U, .count = 3U},
};

static const too_soon_selftest_call too_soon_selftest_calls[57] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7400333f, 0.24667777f, -0.24667777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.73013335f, 0.24337777f, -0.24337777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7203f, 0.2401f, -0.2401f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.42563334f, 0.14187777f, -0.14187777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {0.20803334f, 0.069344446f, -0.069344446f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {0.19763333f, 0.06587778f, -0.06587778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 74U, .y = {0.19253333f, 0.06417778f, -0.06417778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 76U, .y = {0.18253334f, 0.060844444f, -0.060844444f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 112U, .y = {0.048133332f, 0.016044445f, -0.016044445f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.00053333334f, 0.00017777778f, -0.00017777778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.00013333333f, 4.4444445e-5f, -4.4444445e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {3.3333334e-5f, 1.1111111e-5f, -1.1111111e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7400333f, 0.24667777f, -0.24667777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.73013335f, 0.24337777f, -0.24337777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7203f, 0.2401f, -0.2401f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {0.42563334f, 0.14187777f, -0.14187777f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 68U, .y = {0.20803334f, 0.069344446f, -0.069344446f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 70U, .y = {0.19763333f, 0.06587778f, -0.06587778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {0.19253333f, 0.06417778f, -0.06417778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {0.18253334f, 0.060844444f, -0.060844444f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 109U, .y = {0.048133332f, 0.016044445f, -0.016044445f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.00053333334f, 0.00017777778f, -0.00017777778f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.00013333333f, 4.4444445e-5f, -4.4444445e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {3.3333334e-5f, 1.1111111e-5f, -1.1111111e-5f}, .status = PTC_SATURATED, .u = -20.0f},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.64230037f, -0.8454974f, -0.70406526f}, .status = PTC_OK, .u = 5.2550616f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.6475592f, -0.37527624f, 0.86151296f}, .status = PTC_SATURATED, .u = 20.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967291U, .y = {1.982879e32f, 1.7438583e32f, 1.6788332e32f}, .status = PTC_E_RANGE, .u = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t too_soon_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t too_soon_selftest_check(too_soon *self, const too_soon_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (too_soon_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (too_soon_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t too_soon_selftest_calls_of(too_soon *self, const too_soon_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += too_soon_selftest_check(self, &too_soon_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t too_soon_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 2U; i++) {
        const too_soon_selftest_session *session = &too_soon_selftest_sessions[i];
        too_soon self;

        if (too_soon_init(&self, &session->params) == PTC_OK) {
            failures += too_soon_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t too_soon_selftest_refuse(void)
{
    const too_soon_selftest_session *session = &too_soon_selftest_sessions[0];
    uint32_t failures = 0U;
    too_soon self;

    if (too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (too_soon_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += too_soon_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t too_soon_selftest_pointers(void)
{
    const too_soon_selftest_session *session = &too_soon_selftest_sessions[0];
    const too_soon_selftest_call *call = &too_soon_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    too_soon self;

    if (too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (too_soon_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (too_soon_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (too_soon_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_differs(u, 0.0f);
    if (too_soon_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += too_soon_selftest_calls_of(&self, session);
    return failures;
}

uint32_t too_soon_selftest(void)
{
    uint32_t failures = too_soon_selftest_run();

    failures += too_soon_selftest_refuse();
    failures += too_soon_selftest_pointers();
    return failures;
}
