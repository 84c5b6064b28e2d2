/* Self-test of the prescribed-time controller stage39: see stage39_selftest.h. DO NOT EDIT. */
#include "stage39_selftest.h"
#include "stage39.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage39_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
} stage39_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage39_selftest_session {
    stage39_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage39_selftest_session;

static const stage39_selftest_session stage39_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1e150, .k = {2.0}, .deadbeat = 0.0}, .first = 36U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 1.7976931348623157e308}, .first = 37U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 38U, .count = 3U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 41U, .count = 1U},
};

static const stage39_selftest_call stage39_selftest_calls[42] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_SATURATED, .u = 0.3333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {-0.9890106797548875}, .status = PTC_OK, .u = 2.220936263309221},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-0.5223727220281509}, .status = PTC_HOLD, .u = 33.43185420980166},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {5.046873679960429e307}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.9815779832916878}, .status = PTC_SATURATED, .u = 1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage39_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage39_selftest_check(stage39 *self, const stage39_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage39_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage39_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage39_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage39_selftest_calls_of(stage39 *self, const stage39_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage39_selftest_check(self, &stage39_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage39_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage39_selftest_session *session = &stage39_selftest_sessions[i];
        stage39 self;

        if (stage39_init(&self, &session->params) == PTC_OK) {
            failures += stage39_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage39_selftest_refuse(void)
{
    static const stage39_params refused[39] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 5e-324, .a = 1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = (double)NAN, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = (double)INFINITY, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -(double)INFINITY, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 0.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -1.0, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.7976931348623157e308, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -1.7976931348623157e308, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 5e-324, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 7.5e-151, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.25e150, .k = {2.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {(double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {-(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {-1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .a = 1e-150, .k = {1.7976931348623157e308}, .deadbeat = 0.0},
    };
    const stage39_selftest_session *session = &stage39_selftest_sessions[0];
    uint32_t failures = 0U;
    stage39 self;

    if (stage39_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 39U; i++) {
        if (stage39_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage39_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage39_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage39_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage39_selftest(void)
{
    uint32_t failures = stage39_selftest_run();

    failures += stage39_selftest_refuse();
    return failures;
}
