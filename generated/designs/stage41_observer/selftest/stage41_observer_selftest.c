/* Self-test of the prescribed-time observer stage41_observer: see stage41_observer_selftest.h. DO NOT EDIT. */
#include "stage41_observer_selftest.h"
#include "stage41_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage41_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    float applied; /* the input of the tick before */
    ptc_status status;
    float xhat[3]; /* the estimates behind it */
} stage41_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage41_observer_selftest_session {
    stage41_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage41_observer_selftest_session;

static const stage41_observer_selftest_session stage41_observer_selftest_sessions[2] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 50U},
    {.params = {.none = (char)0}, .first = 50U, .count = 6U},
};

static const stage41_observer_selftest_call stage41_observer_selftest_calls[56] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .applied = -0.1875f, .status = PTC_OK, .xhat = {0.75f, 0.0f, 0.25f}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875f, 0.225625f}, .applied = -0.16921875f, .status = PTC_OK, .xhat = {0.75013614f, 0.02278954f, 0.07191738f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075f, 0.2025f}, .applied = -0.151875f, .status = PTC_OK, .xhat = {0.72109735f, -0.1726595f, 0.22842075f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f}, .applied = 0.5f, .status = PTC_GATED, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f}, .applied = (float)NAN, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f}, .applied = (float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f}, .applied = -(float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f}, .applied = 0.25f, .status = PTC_OK, .xhat = {0.6669864f, -0.39851648f, 0.61529374f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, (float)NAN}, .applied = 0.25f, .status = PTC_GATED, .xhat = {0.59275573f, -0.88416064f, 1.2808629f}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, (float)NAN}, .applied = 0.25f, .status = PTC_E_INPUT, .xhat = {0.59275573f, -0.88416064f, 1.2808629f}},
    {.is_armed = 1U, .start = 0U, .k = 2U, .y = {0.25f, 0.25f}, .applied = 0.25f, .status = PTC_OK, .xhat = {0.25f, 0.0f, 0.25f}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.541875f, 0.180625f}, .applied = -0.13546875f, .status = PTC_OK, .xhat = {0.25013983f, 0.023832172f, 0.08455986f}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875f, 0.0625f}, .applied = -0.046875f, .status = PTC_GATED, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.03f, 0.01f}, .applied = -0.0075f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075f, 0.0025f}, .applied = -0.001875f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.001875f, 0.000625f}, .applied = -0.00046875f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .applied = -0.1875f, .status = PTC_OK, .xhat = {0.75f, 0.0f, 0.25f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875f, 0.225625f}, .applied = -0.16921875f, .status = PTC_OK, .xhat = {0.75013614f, 0.02278954f, 0.07191738f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075f, 0.2025f}, .applied = -0.151875f, .status = PTC_OK, .xhat = {0.72109735f, -0.1726595f, 0.22842075f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f}, .applied = 0.5f, .status = PTC_GATED, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f}, .applied = (float)NAN, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f}, .applied = (float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY}, .applied = 0.5f, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f}, .applied = -(float)INFINITY, .status = PTC_E_INPUT, .xhat = {0.67149675f, -0.50968486f, 0.8582917f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f}, .applied = 0.25f, .status = PTC_OK, .xhat = {0.6669864f, -0.39851648f, 0.61529374f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, (float)NAN}, .applied = 0.25f, .status = PTC_GATED, .xhat = {0.59275573f, -0.88416064f, 1.2808629f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, (float)NAN}, .applied = 0.25f, .status = PTC_E_INPUT, .xhat = {0.59275573f, -0.88416064f, 1.2808629f}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967295U, .y = {0.25f, 0.25f}, .applied = 0.25f, .status = PTC_OK, .xhat = {0.25f, 0.0f, 0.25f}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.541875f, 0.180625f}, .applied = -0.13546875f, .status = PTC_OK, .xhat = {0.25013983f, 0.023832172f, 0.08455986f}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875f, 0.0625f}, .applied = -0.046875f, .status = PTC_GATED, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.03f, 0.01f}, .applied = -0.0075f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075f, 0.0025f}, .applied = -0.001875f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.001875f, 0.000625f}, .applied = -0.00046875f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .applied = -0.0f, .status = PTC_E_INPUT, .xhat = {0.38152534f, 1.1444671f, -1.4209207f}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {-0.95513046f, -0.31579813f}, .applied = 0.25f, .status = PTC_OK, .xhat = {-0.95513046f, 0.0f, -0.31579813f}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.3666081f, 0.90671146f}, .applied = 0.25f, .status = PTC_GATED, .xhat = {-0.9552986f, -0.027667893f, -0.07726871f}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-0.8035663f, 0.541081f}, .applied = 0.25f, .status = PTC_HOLD, .xhat = {-0.9555944f, -0.028210131f, 0.05492925f}},
    {.is_armed = 1U, .start = 0U, .k = 3U, .y = {0.0f, -0.0f}, .applied = 0.0f, .status = PTC_GATED, .xhat = {-0.6550082f, 14.756206f, -1.3778579f}},
    {.is_armed = 1U, .start = 0U, .k = 6U, .y = {2.0809815e32f, 1.7964158e32f}, .applied = 0.0f, .status = PTC_OK, .xhat = {2.0809815e32f, 0.0f, 1.7964158e32f}},
    {.is_armed = 1U, .start = 4294967290U, .k = 9U, .y = {3.1754568e32f, -2.701232e32f}, .applied = 0.5f, .status = PTC_OK, .xhat = {3.1754568e32f, 0.0f, -2.701232e32f}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage41_observer_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage41_observer_selftest_check(stage41_observer *self, const stage41_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    float xhat[3] = {12345.0f, 12345.0f, 12345.0f};

    if (call->is_armed != 0U) {
        if (stage41_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage41_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (stage41_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage41_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage41_observer_selftest_calls_of(stage41_observer *self, const stage41_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage41_observer_selftest_check(self, &stage41_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage41_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 2U; i++) {
        const stage41_observer_selftest_session *session = &stage41_observer_selftest_sessions[i];
        stage41_observer self;

        if (stage41_observer_init(&self, &session->params) == PTC_OK) {
            failures += stage41_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage41_observer_selftest_refuse(void)
{
    const stage41_observer_selftest_session *session = &stage41_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    stage41_observer self;

    if (stage41_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage41_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage41_observer_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage41_observer_selftest_pointers(void)
{
    const stage41_observer_selftest_session *session = &stage41_observer_selftest_sessions[0];
    const stage41_observer_selftest_call *call = &stage41_observer_selftest_calls[0];
    uint32_t failures = 0U;
    float xhat[3];
    stage41_observer self;

    if (stage41_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage41_observer_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage41_observer_update(NULL, call->k, call->y, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage41_observer_update(&self, call->k, NULL, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage41_observer_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage41_observer_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage41_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage41_observer_selftest(void)
{
    uint32_t failures = stage41_observer_selftest_run();

    failures += stage41_observer_selftest_refuse();
    failures += stage41_observer_selftest_pointers();
    return failures;
}
