/* Self-test of the prescribed-time controller stage38: see stage38_selftest.h. DO NOT EDIT. */
#include "stage38_selftest.h"
#include "stage38.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage38_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[1]; /* what is measured */
    ptc_status status;
    float u;
    float xhat[2]; /* the estimates behind it */
    float d;
} stage38_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage38_selftest_session {
    stage38_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage38_selftest_session;

static const stage38_selftest_session stage38_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 3U},
    {.params = {.none = (char)0}, .first = 45U, .count = 3U},
};

static const stage38_selftest_call stage38_selftest_calls[48] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.75f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.71296877f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.730357f, -0.3668729f}, .d = -1.5286369f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.6990615f, -0.9307276f}, .d = -3.9667182f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.6990615f, -0.9307276f}, .d = -3.9667182f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.6990615f, -0.9307276f}, .d = -3.9667182f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.6990615f, -0.9307276f}, .d = -3.9667182f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.64171875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.6618385f, -1.5613241f}, .d = -6.7806673f},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.4592102f, -9.469522f}, .d = -81.451065f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.27f, -23.850391f}, .d = -985.87494f},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.226875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.226875f, 2.994255f}, .d = 1460.3516f},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671874f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.20671874f, -0.8671856f}, .d = 228.68774f},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.1875f, -1.8775008f}, .d = 8.874908f},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.16921875f, -1.7812505f}, .d = 9.374991f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.046875f, -17.437498f}, .d = -1040.6249f},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.007499993f, 0.2109356f}, .d = 829.68726f},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.001875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.0018749982f, 1.1275005f}, .d = 337.0001f},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.00046875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.00046874955f, 0.06781244f}, .d = 41.6875f},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 1.1920929e-7f}, .d = 9.375011f},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.023437463f}, .d = 4.687494f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 4.7683716e-7f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 1.1920929e-9f}, .d = 2.3841858e-7f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.38157892f, 6.7105265f}, .d = 26.315788f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.71296877f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.5894901f, 9.578948f}, .d = 37.17105f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.68145317f, 9.837462f}, .d = 36.667957f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.68145317f, 9.837462f}, .d = 36.667957f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.68145317f, 9.837462f}, .d = 36.667957f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.68145317f, 9.837462f}, .d = 36.667957f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.64171875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.7005769f, 8.475441f}, .d = 28.43605f},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.482688f, -4.010932f}, .d = -93.189995f},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.27f, -30.13071f}, .d = -1772.3818f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.226875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.22687502f, 4.168148f}, .d = 1695.1304f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671874f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.20671874f, -0.8671932f}, .d = 228.68738f},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.1875f, -1.8774962f}, .d = 8.87558f},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.16921875f, -1.7812526f}, .d = 9.374769f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.046875f, -17.437502f}, .d = -1040.625f},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.007499993f, 0.2109356f}, .d = 829.6875f},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.001875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.0018749982f, 1.127502f}, .d = 337.00024f},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.00046875f}, .status = PTC_SATURATED, .u = 0.0f, .xhat = {0.00046874955f, 0.06781244f}, .d = 41.68744f},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, -5.9604645e-8f}, .d = 9.374981f},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.023437478f}, .d = 4.6874967f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 4.7683716e-7f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 1.1920929e-9f}, .d = 2.3841858e-7f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {-0.2859259f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {-0.2859259f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.7853281f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.78532815f, 91.82178f}, .d = -3060.7258f},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {1.090363e32f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {0.78532815f, 91.82178f}, .d = -3060.7258f},
    {.is_armed = 1U, .start = 4294967290U, .k = 10U, .y = {-0.0f}, .status = PTC_OK, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {-1.2063801e19f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {-1.0053168e19f, -4.2223305e20f}, .d = -4.0212672e21f},
    {.is_armed = 1U, .start = 4294967290U, .k = 3U, .y = {-1.5258567e19f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {-1.5258567e19f, 0.0f}, .d = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage38_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage38_selftest_check(stage38 *self, const stage38_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2] = {12345.0f, 12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage38_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage38_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage38_selftest_differs(u, call->u);
    if (stage38_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage38_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage38_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage38_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage38_selftest_calls_of(stage38 *self, const stage38_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage38_selftest_check(self, &stage38_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage38_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage38_selftest_session *session = &stage38_selftest_sessions[i];
        stage38 self;

        if (stage38_init(&self, &session->params) == PTC_OK) {
            failures += stage38_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage38_selftest_refuse(void)
{
    const stage38_selftest_session *session = &stage38_selftest_sessions[0];
    uint32_t failures = 0U;
    stage38 self;

    if (stage38_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage38_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage38_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage38_selftest_pointers(void)
{
    const stage38_selftest_session *session = &stage38_selftest_sessions[0];
    const stage38_selftest_call *call = &stage38_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2];
    float d;
    stage38 self;

    if (stage38_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage38_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage38_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage38_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (stage38_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage38_selftest_differs(u, 0.0f);
    if (stage38_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage38_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage38_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage38_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage38_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage38_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage38_selftest(void)
{
    uint32_t failures = stage38_selftest_run();

    failures += stage38_selftest_refuse();
    failures += stage38_selftest_pointers();
    return failures;
}
