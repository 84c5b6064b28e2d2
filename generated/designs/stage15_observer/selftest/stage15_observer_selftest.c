/* Self-test of the prescribed-time observer stage15_observer: see stage15_observer_selftest.h. DO NOT EDIT. */
#include "stage15_observer_selftest.h"
#include "stage15_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage15_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[1]; /* what is measured */
    float applied; /* the input of the tick before */
    ptc_status status;
    float xhat[2]; /* the estimates behind it */
    float d;
} stage15_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage15_observer_selftest_session {
    stage15_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage15_observer_selftest_session;

static const stage15_observer_selftest_session stage15_observer_selftest_sessions[4] = {
    {.params = {.h = 0.015625f}, .first = 0U, .count = 36U},
    {.params = {.h = 0.015625f}, .first = 36U, .count = 2U},
    {.params = {.h = 0.015625f}, .first = 38U, .count = 2U},
    {.params = {.h = 0.015625f}, .first = 40U, .count = 2U},
};

static const stage15_observer_selftest_call stage15_observer_selftest_calls[42] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .applied = -0.1875f, .status = PTC_OK, .xhat = {0.75f, -0.15328126f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.5925926f}, .applied = -0.14814815f, .status = PTC_OK, .xhat = {0.63816655f, -1.967488f}, .d = -6.6668143f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.4537037f}, .applied = -0.113425925f, .status = PTC_OK, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f}, .applied = (float)NAN, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f}, .applied = (float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f}, .applied = -(float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.48822924f, -4.342595f}, .d = -17.215376f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.33333334f}, .applied = -0.083333336f, .status = PTC_OK, .xhat = {0.34589425f, -6.2994814f}, .d = -27.505268f},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.23148148f}, .applied = -0.05787037f, .status = PTC_OK, .xhat = {0.23233059f, -7.0457134f}, .d = -30.685125f},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.14814815f}, .applied = -0.037037037f, .status = PTC_OK, .xhat = {0.14814815f, -6.1168394f}, .d = -13.098469f},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.037037037f}, .applied = -0.009259259f, .status = PTC_OK, .xhat = {0.037128188f, -7.316193f}, .d = -36.432056f},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.009259259f}, .applied = -0.0023148148f, .status = PTC_OK, .xhat = {0.0086540505f, -1.490644f}, .d = 118.4946f},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {-5.7934783e-5f, -0.11863577f}, .d = 133.32518f},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {3.3861957e-5f, 0.41922045f}, .d = 124.65688f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {8.751359e-5f, 0.33410048f}, .d = 102.25452f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {6.9709495e-5f, 0.25821835f}, .d = 84.40961f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .applied = -0.1875f, .status = PTC_OK, .xhat = {0.4858389f, 7.034903f}, .d = 105.8487f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.5925926f}, .applied = -0.14814815f, .status = PTC_OK, .xhat = {0.59508944f, 7.6168766f}, .d = 105.48345f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.4537037f}, .applied = -0.113425925f, .status = PTC_OK, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f}, .applied = (float)NAN, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f}, .applied = (float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f}, .applied = -(float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5139973f, 4.4995394f}, .d = 87.062f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.33333334f}, .applied = -0.083333336f, .status = PTC_OK, .xhat = {0.37112254f, 0.0070028305f}, .d = 56.10509f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.23148148f}, .applied = -0.05787037f, .status = PTC_OK, .xhat = {0.24068327f, -3.7974877f}, .d = 21.645073f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.14814815f}, .applied = -0.037037037f, .status = PTC_OK, .xhat = {0.14814815f, -5.302519f}, .d = 1.4270554f},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.037037037f}, .applied = -0.009259259f, .status = PTC_OK, .xhat = {0.037219845f, -7.3369904f}, .d = -45.36945f},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.009259259f}, .applied = -0.0023148148f, .status = PTC_OK, .xhat = {0.008648805f, -1.5269842f}, .d = 110.899796f},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {-6.4915046e-5f, -0.14206177f}, .d = 127.517395f},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {2.8962735e-5f, 0.40112495f}, .d = 120.103226f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {8.370448e-5f, 0.31984824f}, .d = 98.67586f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .applied = -0.0f, .status = PTC_HOLD, .xhat = {6.671343e-5f, 0.24701762f}, .d = 81.59795f},
    {.is_armed = 1U, .start = 0U, .k = 4294967295U, .y = {2.8752094e38f}, .applied = 3.4028235e38f, .status = PTC_HOLD, .xhat = {2.8752094e38f, -0.15328126f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 1U, .y = {1.1072857e38f}, .applied = 0.0f, .status = PTC_OK, .xhat = {1.1072857e38f, 1.3292279e36f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 9U, .y = {-1.5434798e38f}, .applied = 0.5f, .status = PTC_HOLD, .xhat = {-1.5434798e38f, -0.15328126f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {2.2314715e38f}, .applied = 0.5f, .status = PTC_E_RANGE, .xhat = {-1.5434798e38f, -0.15328126f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 10U, .y = {1.8086417e38f}, .applied = 3.4028235e38f, .status = PTC_HOLD, .xhat = {1.8086417e38f, -0.15328126f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {2.4548766e38f}, .applied = 0.5f, .status = PTC_E_RANGE, .xhat = {1.8086417e38f, -0.15328126f}, .d = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage15_observer_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage15_observer_selftest_check(stage15_observer *self, const stage15_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    float xhat[2] = {12345.0f, 12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage15_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage15_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (stage15_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage15_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage15_observer_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage15_observer_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage15_observer_selftest_calls_of(stage15_observer *self, const stage15_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage15_observer_selftest_check(self, &stage15_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage15_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage15_observer_selftest_session *session = &stage15_observer_selftest_sessions[i];
        stage15_observer self;

        if (stage15_observer_init(&self, &session->params) == PTC_OK) {
            failures += stage15_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage15_observer_selftest_refuse(void)
{
    static const stage15_observer_params refused[13] = {
        {.h = (float)NAN},
        {.h = (float)INFINITY},
        {.h = -(float)INFINITY},
        {.h = 0.0f},
        {.h = -1.0f},
        {.h = 3.4028235e38f},
        {.h = -3.4028235e38f},
        {.h = 1e-45f},
        {.h = 7.5e-19f},
        {.h = 1e-18f},
        {.h = 1e18f},
        {.h = 1.25e18f},
        {.h = 177683200.0f},
    };
    const stage15_observer_selftest_session *session = &stage15_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    stage15_observer self;

    if (stage15_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 13U; i++) {
        if (stage15_observer_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage15_observer_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage15_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage15_observer_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage15_observer_selftest_pointers(void)
{
    const stage15_observer_selftest_session *session = &stage15_observer_selftest_sessions[0];
    const stage15_observer_selftest_call *call = &stage15_observer_selftest_calls[0];
    uint32_t failures = 0U;
    float xhat[2];
    float d;
    stage15_observer self;

    if (stage15_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage15_observer_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_update(NULL, call->k, call->y, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_update(&self, call->k, NULL, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage15_observer_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage15_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage15_observer_selftest(void)
{
    uint32_t failures = stage15_observer_selftest_run();

    failures += stage15_observer_selftest_refuse();
    failures += stage15_observer_selftest_pointers();
    return failures;
}
