/* Self-test of the prescribed-time controller stage13: see stage13_selftest.h. DO NOT EDIT. */
#include "stage13_selftest.h"
#include "stage13.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage13_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    ptc_status status;
    float u;
} stage13_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage13_selftest_session {
    stage13_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage13_selftest_session;

static const stage13_selftest_session stage13_selftest_sessions[5] = {
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 0.0f}, .deadbeat = 0.0f}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 3.4028235e38f}, .first = 49U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 50U, .count = 1U},
    {.params = {.samples = 60U, .u_max = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 51U, .count = 2U},
};

static const stage13_selftest_call stage13_selftest_calls[53] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = 91.3073f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = 89.457504f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = 87.63168f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = 85.82985f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = 66.08553f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = 51.059975f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = 48.649467f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = 47.48198f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = 46.339855f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = 45.223274f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = 32.485924f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = 40.694824f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = 10.173706f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = 2.5434265f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = 91.3073f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = 89.457504f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = 87.63168f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = 85.82985f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = 66.08553f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = 51.059975f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = 48.649467f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = 47.48198f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = 46.339855f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = 45.223274f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = 32.485924f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = 40.694824f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = 10.173706f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = 2.5434265f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f}, .status = PTC_OK, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f}, .status = PTC_OK, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 34U, .y = {-2.2098657e38f, -1.0612836e38f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.71748453f, -0.5599637f}, .status = PTC_SATURATED, .u = -1.0f},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.26900482f, 0.26057374f}, .status = PTC_SATURATED, .u = 1.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage13_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage13_selftest_check(stage13 *self, const stage13_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage13_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage13_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage13_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage13_selftest_calls_of(stage13 *self, const stage13_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage13_selftest_check(self, &stage13_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage13_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage13_selftest_session *session = &stage13_selftest_sessions[i];
        stage13 self;

        if (stage13_init(&self, &session->params) == PTC_OK) {
            failures += stage13_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage13_selftest_refuse(void)
{
    static const stage13_params refused[22] = {
        {.samples = 0U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 1U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)NAN, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -(float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = 0.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {(float)NAN, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {-(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {-3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -3.4028235e38f},
    };
    const stage13_selftest_session *session = &stage13_selftest_sessions[0];
    uint32_t failures = 0U;
    stage13 self;

    if (stage13_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 22U; i++) {
        if (stage13_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage13_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage13_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage13_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage13_selftest_pointers(void)
{
    const stage13_selftest_session *session = &stage13_selftest_sessions[0];
    const stage13_selftest_call *call = &stage13_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    stage13 self;

    if (stage13_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage13_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage13_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage13_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (stage13_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage13_selftest_differs(u, 0.0f);
    if (stage13_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage13_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage13_selftest(void)
{
    uint32_t failures = stage13_selftest_run();

    failures += stage13_selftest_refuse();
    failures += stage13_selftest_pointers();
    return failures;
}
