/* Self-test of the prescribed-time observer stage17_observer: see stage17_observer_selftest.h. DO NOT EDIT. */
#include "stage17_observer_selftest.h"
#include "stage17_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage17_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    double applied; /* the input of the tick before */
    ptc_status status;
    double xhat[1]; /* the estimates behind it */
    double d;
} stage17_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage17_observer_selftest_session {
    stage17_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage17_observer_selftest_session;

static const stage17_observer_selftest_session stage17_observer_selftest_sessions[4] = {
    {.params = {.h = 0.015625}, .first = 0U, .count = 22U},
    {.params = {.h = 0.015625}, .first = 22U, .count = 2U},
    {.params = {.h = 0.015625}, .first = 24U, .count = 2U},
    {.params = {.h = 0.015625}, .first = 26U, .count = 2U},
};

static const stage17_observer_selftest_call stage17_observer_selftest_calls[28] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.25}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.57421875, 0.19140625}, .applied = -0.1435546875, .status = PTC_OK, .xhat = {0.19945635114397323}, .d = -1.0304129464285714},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.421875, 0.140625}, .applied = -0.10546875, .status = PTC_OK, .xhat = {0.140625}, .d = -1.9068545386904765},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.29296875, 0.09765625}, .applied = -0.0732421875, .status = PTC_OK, .xhat = {0.09765625}, .d = -2.6767578125},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.0625}, .d = -2.203125},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.046875, 0.015625}, .applied = -0.01171875, .status = PTC_OK, .xhat = {0.015625}, .d = -2.98828125},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.01171875, 0.00390625}, .applied = -0.0029296875, .status = PTC_OK, .xhat = {0.00390625}, .d = -0.7470703125},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = -0.25},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.19580078125}, .d = 3.46875},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.57421875, 0.19140625}, .applied = -0.1435546875, .status = PTC_OK, .xhat = {0.19945635114397323}, .d = 2.438337053571429},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.421875, 0.140625}, .applied = -0.10546875, .status = PTC_OK, .xhat = {0.140625}, .d = 0.4056454613095237},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.29296875, 0.09765625}, .applied = -0.0732421875, .status = PTC_OK, .xhat = {0.09765625}, .d = -2.6767578125},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.0625}, .d = -2.203125},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.046875, 0.015625}, .applied = -0.01171875, .status = PTC_OK, .xhat = {0.015625}, .d = -2.98828125},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.01171875, 0.00390625}, .applied = -0.0029296875, .status = PTC_OK, .xhat = {0.00390625}, .d = -0.7470703125},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = -0.25},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 2147483647U, .y = {1.6609504755056282e302, -1.6826022174671476e302}, .applied = 0.5, .status = PTC_HOLD, .xhat = {-1.6826022174671476e302}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 0U, .y = {-1.6289170468515274e302, -5.023417769909703e301}, .applied = 1.797693134862316e302, .status = PTC_OK, .xhat = {-5.023417769909703e301}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {7.534286791159686e307, 8.098610135816677e307}, .applied = 0.5, .status = PTC_OK, .xhat = {8.098610135816677e307}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {5.50470895039603e307, 5.65825786190865e307}, .applied = 0.0, .status = PTC_E_RANGE, .xhat = {8.098610135816677e307}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 3U, .y = {5.139832755204136e307, -6.933478737733689e307}, .applied = 1.7976931348623157e308, .status = PTC_HOLD, .xhat = {-6.933478737733689e307}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {1.6721813411739885e308, 1.7957743733220194e308}, .applied = 1.7976931348623157e308, .status = PTC_E_RANGE, .xhat = {-6.933478737733689e307}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage17_observer_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage17_observer_selftest_check(stage17_observer *self, const stage17_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    double xhat[1] = {12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage17_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage17_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (stage17_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 1U; i++) {
        failures += stage17_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage17_observer_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage17_observer_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage17_observer_selftest_calls_of(stage17_observer *self, const stage17_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage17_observer_selftest_check(self, &stage17_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage17_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage17_observer_selftest_session *session = &stage17_observer_selftest_sessions[i];
        stage17_observer self;

        if (stage17_observer_init(&self, &session->params) == PTC_OK) {
            failures += stage17_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage17_observer_selftest_refuse(void)
{
    static const stage17_observer_params refused[12] = {
        {.h = (double)NAN},
        {.h = (double)INFINITY},
        {.h = -(double)INFINITY},
        {.h = 0.0},
        {.h = -1.0},
        {.h = 1.7976931348623157e308},
        {.h = -1.7976931348623157e308},
        {.h = 5e-324},
        {.h = 7.5e-151},
        {.h = 1e-150},
        {.h = 1e150},
        {.h = 1.25e150},
    };
    const stage17_observer_selftest_session *session = &stage17_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    stage17_observer self;

    if (stage17_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 12U; i++) {
        if (stage17_observer_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage17_observer_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage17_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage17_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage17_observer_selftest(void)
{
    uint32_t failures = stage17_observer_selftest_run();

    failures += stage17_observer_selftest_refuse();
    return failures;
}
