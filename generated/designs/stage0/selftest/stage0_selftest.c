/* Self-test of the prescribed-time controller stage0: see stage0_selftest.h. DO NOT EDIT. */
#include "stage0_selftest.h"
#include "stage0.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage0_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
} stage0_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage0_selftest_session {
    stage0_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage0_selftest_session;

static const stage0_selftest_session stage0_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1e150, .k = {2.0}, .deadbeat = 0.0}, .first = 42U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 1.7976931348623157e308}, .first = 43U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 44U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .a = 1.0, .k = {2.0}, .deadbeat = 0.0}, .first = 45U, .count = 2U},
};

static const stage0_selftest_call stage0_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1.6},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -1.573333333333333},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -1.5466666666666666},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -1.52},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = -1.2},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -0.9066666666666665},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_OK, .u = -0.8533333333333333},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -0.8266666666666669},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_OK, .u = -0.8},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_OK, .u = -0.7733333333333333},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_OK, .u = -0.4},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_OK, .u = -0.10666666666666666},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_OK, .u = -0.05333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_OK, .u = -0.013333333333333332},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -1.6},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -1.573333333333333},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -1.5466666666666666},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_OK, .u = -1.52},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_OK, .u = -1.2},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -0.9066666666666665},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_OK, .u = -0.8533333333333333},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -0.8266666666666669},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_OK, .u = -0.8},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_OK, .u = -0.7733333333333333},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_OK, .u = -0.4},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_OK, .u = -0.10666666666666666},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_OK, .u = -0.05333333333333333},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_OK, .u = -0.013333333333333332},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 11U, .y = {1.6502586060170146e308}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5549674680933547}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.8465670672397323}, .status = PTC_SATURATED, .u = 1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage0_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage0_selftest_check(stage0 *self, const stage0_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage0_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage0_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage0_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage0_selftest_calls_of(stage0 *self, const stage0_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage0_selftest_check(self, &stage0_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage0_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage0_selftest_session *session = &stage0_selftest_sessions[i];
        stage0 self;

        if (stage0_init(&self, &session->params) == PTC_OK) {
            failures += stage0_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage0_selftest_refuse(void)
{
    static const stage0_params refused[38] = {
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
        {.samples = 60U, .h = 0.015625, .u_max = 2.336393340297255e-110, .a = 1e-150, .k = {1.7976931348623157e308}, .deadbeat = 0.0},
    };
    const stage0_selftest_session *session = &stage0_selftest_sessions[0];
    uint32_t failures = 0U;
    stage0 self;

    if (stage0_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 38U; i++) {
        if (stage0_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage0_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage0_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage0_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage0_selftest_pointers(void)
{
    const stage0_selftest_session *session = &stage0_selftest_sessions[0];
    const stage0_selftest_call *call = &stage0_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage0 self;

    if (stage0_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage0_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage0_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage0_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage0_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage0_selftest_differs(u, 0.0);
    if (stage0_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage0_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage0_selftest(void)
{
    uint32_t failures = stage0_selftest_run();

    failures += stage0_selftest_refuse();
    failures += stage0_selftest_pointers();
    return failures;
}
