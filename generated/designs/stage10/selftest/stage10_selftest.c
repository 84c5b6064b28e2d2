/* Self-test of the prescribed-time controller stage10: see stage10_selftest.h. DO NOT EDIT. */
#include "stage10_selftest.h"
#include "stage10.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage10_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    ptc_status status;
    float u;
} stage10_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage10_selftest_session {
    stage10_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage10_selftest_session;

static const stage10_selftest_session stage10_selftest_sessions[3] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f, .k = {9.0f, 6.0f}}, .first = 49U, .count = 2U},
};

static const stage10_selftest_call stage10_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -5.589811f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = -5.5750713f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -5.5603786f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = -5.545736f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = -5.375067f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = -5.232774f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = -5.209531f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = -5.198353f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -5.187513f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = -5.177046f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = -193.5f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = -13.76f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = -3.44f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = -0.86f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -5.589811f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = -5.5750713f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -5.5603786f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = -5.545736f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = -5.375067f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = -5.232774f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = -5.209531f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = -5.198353f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -5.187513f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = -5.177046f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = -193.5f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = -13.76f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = -3.44f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = -0.86f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 27U, .y = {1.360304e38f, -8.774915e37f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.6316857f, 0.6043679f}, .status = PTC_SATURATED, .u = 1.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.6325229f, -0.726242f}, .status = PTC_SATURATED, .u = -1.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage10_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage10_selftest_check(stage10 *self, const stage10_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage10_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage10_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage10_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage10_selftest_calls_of(stage10 *self, const stage10_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage10_selftest_check(self, &stage10_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage10_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage10_selftest_session *session = &stage10_selftest_sessions[i];
        stage10 self;

        if (stage10_init(&self, &session->params) == PTC_OK) {
            failures += stage10_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage10_selftest_refuse(void)
{
    static const stage10_params refused[29] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 1U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 1e-18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 1e18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f, .k = {9.0f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {(float)NAN, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {(float)INFINITY, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {-(float)INFINITY, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {3.4028235e38f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {-3.4028235e38f, 6.0f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, (float)NAN}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, (float)INFINITY}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, -(float)INFINITY}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 3.4028235e38f}},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, -3.4028235e38f}},
    };
    const stage10_selftest_session *session = &stage10_selftest_sessions[0];
    uint32_t failures = 0U;
    stage10 self;

    if (stage10_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 29U; i++) {
        if (stage10_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage10_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage10_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage10_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage10_selftest_pointers(void)
{
    const stage10_selftest_session *session = &stage10_selftest_sessions[0];
    const stage10_selftest_call *call = &stage10_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    stage10 self;

    if (stage10_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage10_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage10_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage10_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (stage10_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage10_selftest_differs(u, 0.0f);
    if (stage10_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage10_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage10_selftest(void)
{
    uint32_t failures = stage10_selftest_run();

    failures += stage10_selftest_refuse();
    failures += stage10_selftest_pointers();
    return failures;
}
