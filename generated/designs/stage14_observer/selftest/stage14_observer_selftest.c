/* Self-test of the prescribed-time observer stage14_observer: see stage14_observer_selftest.h. DO NOT EDIT. */
#include "stage14_observer_selftest.h"
#include "stage14_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage14_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    double applied; /* the input of the tick before */
    ptc_status status;
    double xhat[3]; /* the estimates behind it */
} stage14_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage14_observer_selftest_session {
    stage14_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage14_observer_selftest_session;

static const stage14_observer_selftest_session stage14_observer_selftest_sessions[4] = {
    {.params = {.h = 0.015625}, .first = 0U, .count = 36U},
    {.params = {.h = 0.015625}, .first = 36U, .count = 3U},
    {.params = {.h = 0.015625}, .first = 39U, .count = 2U},
    {.params = {.h = 0.015625}, .first = 41U, .count = 2U},
};

static const stage14_observer_selftest_call stage14_observer_selftest_calls[43] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.75, -2.288818359375e-5, -0.0029296875}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.6302083333333333}, .applied = -0.15755208333333331, .status = PTC_OK, .xhat = {0.6615475560320012, -1.9283575993997089, -9.917781876929016}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5208333333333334}, .applied = -0.13020833333333334, .status = PTC_OK, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5445307918996722, -4.202742309629181, -22.364020265178908}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.421875}, .applied = -0.10546875, .status = PTC_OK, .xhat = {0.4310256367692202, -5.840602657982069, -31.184728968921362}},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.1875}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.1875, -15.037491471927913, 70.16286386605366}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.08333333333333333}, .applied = -0.020833333333333332, .status = PTC_OK, .xhat = {0.08333333333333334, -2.2071818486250265, 570.8139482023855}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.020833333333333332}, .applied = -0.005208333333333333, .status = PTC_OK, .xhat = {0.02083333333333333, -2.6666674084133595, 170.66654459635407}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.005208333333333333}, .applied = -0.0013020833333333333, .status = PTC_OK, .xhat = {0.005208333333333333, 0.4999998145633285, 191.999969482422}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -2.6490952986790717e-8, 42.66666327582465}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.16666666666666652, 21.333333333333314}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.5227272366032456, 10.181796911991004, 46.542532256155305}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.6302083333333333}, .applied = -0.15755208333333331, .status = PTC_OK, .xhat = {0.645196543332068, 9.986795809614136, 41.79939806046577}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5208333333333334}, .applied = -0.13020833333333334, .status = PTC_OK, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.5826936767533772, 5.107360180272533, 9.312752446475386}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.421875}, .applied = -0.10546875, .status = PTC_OK, .xhat = {0.4626476656049293, -0.4879322545286051, -29.984151577517572}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.1875}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.1875, -16.436433493225525, 150.14594536208884}},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.08333333333333333}, .applied = -0.020833333333333332, .status = PTC_OK, .xhat = {0.08333333333333331, -1.1952769258823341, 700.3377783134501}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.020833333333333332}, .applied = -0.005208333333333333, .status = PTC_OK, .xhat = {0.020833333333333343, -2.6666674084133533, 170.66654459635424}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.005208333333333333}, .applied = -0.0013020833333333333, .status = PTC_OK, .xhat = {0.005208333333333333, 0.4999998145633247, 191.99996948242162}},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -2.6490952542701507e-8, 42.6666632758247}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.16666666666666652, 21.333333333333314}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {-0.8205386008982269}, .applied = 0.25, .status = PTC_OK, .xhat = {-0.8205386008982269, 3.0517578125e-5, 0.00390625}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967295U, .y = {-1.4767969614601757e302}, .applied = 1.797693134862316e302, .status = PTC_OK, .xhat = {-1.4767969614601757e302, -4.6132140387806993e303, -1.008132750317004e305}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {-7.52311181552385e301}, .applied = 0.5, .status = PTC_OK, .xhat = {-7.52311181552385e301, 6.103515625e-5, 0.0078125}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {1.170883277815434e308}, .applied = 0.5, .status = PTC_OK, .xhat = {1.170883277815434e308, 6.103515625e-5, 0.0078125}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-4.706150794908862e307}, .applied = 0.0, .status = PTC_E_RANGE, .xhat = {1.170883277815434e308, 6.103515625e-5, 0.0078125}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {-1.1823905605105972e308}, .applied = 1.7976931348623157e308, .status = PTC_OK, .xhat = {-1.1823905605105972e308, 2.1944496275174752e304, 2.8088955232223683e306}},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {1.7830647727139082e308}, .applied = 1.7976931348623157e308, .status = PTC_E_RANGE, .xhat = {-1.1823905605105972e308, 2.1944496275174752e304, 2.8088955232223683e306}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage14_observer_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage14_observer_selftest_check(stage14_observer *self, const stage14_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    double xhat[3] = {12345.0, 12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage14_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage14_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (stage14_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage14_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage14_observer_selftest_calls_of(stage14_observer *self, const stage14_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage14_observer_selftest_check(self, &stage14_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage14_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage14_observer_selftest_session *session = &stage14_observer_selftest_sessions[i];
        stage14_observer self;

        if (stage14_observer_init(&self, &session->params) == PTC_OK) {
            failures += stage14_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage14_observer_selftest_refuse(void)
{
    static const stage14_observer_params refused[13] = {
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
        {.h = 1.6614458870061815e92},
    };
    const stage14_observer_selftest_session *session = &stage14_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    stage14_observer self;

    if (stage14_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 13U; i++) {
        if (stage14_observer_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage14_observer_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage14_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage14_observer_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage14_observer_selftest_pointers(void)
{
    const stage14_observer_selftest_session *session = &stage14_observer_selftest_sessions[0];
    const stage14_observer_selftest_call *call = &stage14_observer_selftest_calls[0];
    uint32_t failures = 0U;
    double xhat[3];
    stage14_observer self;

    if (stage14_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage14_observer_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage14_observer_update(NULL, call->k, call->y, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage14_observer_update(&self, call->k, NULL, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage14_observer_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage14_observer_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage14_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage14_observer_selftest(void)
{
    uint32_t failures = stage14_observer_selftest_run();

    failures += stage14_observer_selftest_refuse();
    failures += stage14_observer_selftest_pointers();
    return failures;
}
