/* Self-test of the prescribed-time controller stage36: see stage36_selftest.h. DO NOT EDIT. */
#include "stage36_selftest.h"
#include "stage36.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage36_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[4]; /* what is measured */
    ptc_status status;
    float u[2];
    ptc_status axes[2];
} stage36_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage36_selftest_session {
    stage36_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage36_selftest_session;

static const stage36_selftest_session stage36_selftest_sessions[5] = {
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 60U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .a = 1e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 60U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 3.4028235e38f}, .first = 61U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 62U, .count = 1U},
    {.params = {.samples = 60U, .u_max = 1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 63U, .count = 2U},
};

static const stage36_selftest_call stage36_selftest_calls[65] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f, -0.25f, -0.75f}, .status = PTC_OK, .u = {-4.991276f, 0.1648649f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f, -0.24173611f, -0.72520834f}, .status = PTC_OK, .u = {-5.1110783f, 0.086923f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f, -0.2336111f, -0.7008333f}, .status = PTC_OK, .u = {-5.230044f, 0.009209871f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, 0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f, -0.225625f, -0.676875f}, .status = PTC_OK, .u = {-5.348178f, -0.06827593f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f, -0.140625f, -0.421875f}, .status = PTC_OK, .u = {-6.7036166f, -0.98142f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f, -0.08027778f, -0.24083333f}, .status = PTC_OK, .u = {-7.858604f, -1.7965204f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f, -0.07111111f, -0.21333334f}, .status = PTC_OK, .u = {-8.06223f, -1.9434704f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f, -0.06673611f, -0.20020834f}, .status = PTC_OK, .u = {-8.163623f, -2.0169225f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f, -0.0625f, -0.1875f}, .status = PTC_OK, .u = {-8.264831f, -2.090395f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f, -0.058402777f, -0.17520833f}, .status = PTC_OK, .u = {-8.365928f, -2.1639173f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f, -0.015625f, -0.046875f}, .status = PTC_OK, .u = {-9.870154f, -3.2369933f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f, -0.0033333334f}, .status = PTC_OK, .u = {-17.777683f, -6.650774f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f, -0.00083333335f}, .status = PTC_OK, .u = {-4.444421f, -1.6626935f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f, -0.00020833334f}, .status = PTC_OK, .u = {-1.1111052f, -0.41567338f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f, -0.25f, -0.75f}, .status = PTC_OK, .u = {-4.991276f, 0.1648649f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f, -0.24173611f, -0.72520834f}, .status = PTC_OK, .u = {-5.1110783f, 0.086923f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f, -0.2336111f, -0.7008333f}, .status = PTC_OK, .u = {-5.230044f, 0.009209871f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, 0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, (float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, 0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY, 0.5f, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, -(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, 0.5f, 0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = {0.0f, 0.0f}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f, -0.225625f, -0.676875f}, .status = PTC_OK, .u = {-5.348178f, -0.06827593f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f, -0.140625f, -0.421875f}, .status = PTC_OK, .u = {-6.7036166f, -0.98142f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f, -0.08027778f, -0.24083333f}, .status = PTC_OK, .u = {-7.858604f, -1.7965204f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f, -0.07111111f, -0.21333334f}, .status = PTC_OK, .u = {-8.06223f, -1.9434704f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f, -0.06673611f, -0.20020834f}, .status = PTC_OK, .u = {-8.163623f, -2.0169225f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f, -0.0625f, -0.1875f}, .status = PTC_OK, .u = {-8.264831f, -2.090395f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f, -0.058402777f, -0.17520833f}, .status = PTC_OK, .u = {-8.365928f, -2.1639173f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f, -0.015625f, -0.046875f}, .status = PTC_OK, .u = {-9.870154f, -3.2369933f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f, -0.0033333334f}, .status = PTC_OK, .u = {-17.777683f, -6.650774f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f, -0.00083333335f}, .status = PTC_OK, .u = {-4.444421f, -1.6626935f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f, -0.00020833334f}, .status = PTC_OK, .u = {-1.1111052f, -0.41567338f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {-0.0f, -0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = {0.0f, 0.0f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = {-0.0f, -0.0f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 20U, .y = {3.2541554e38f, 3.0504505e38f, 2.4383488e38f, -1.7065964e38f}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.36571547f, -0.97582775f, -0.26780882f, -0.48035648f}, .status = PTC_SATURATED, .u = {1.0f, 1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.5773917f, -0.8079572f, 0.8025047f, 0.33086997f}, .status = PTC_SATURATED, .u = {-1.0f, -1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage36_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage36_selftest_check(stage36 *self, const stage36_selftest_call *call)
{
    uint32_t failures = 0U;
    float u[2] = {12345.0f, 12345.0f};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage36_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage36_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage36_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage36_selftest_calls_of(stage36 *self, const stage36_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage36_selftest_check(self, &stage36_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage36_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage36_selftest_session *session = &stage36_selftest_sessions[i];
        stage36 self;

        if (stage36_init(&self, &session->params) == PTC_OK) {
            failures += stage36_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage36_selftest_refuse(void)
{
    static const stage36_params refused[34] = {
        {.samples = 0U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 1U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)NAN, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -(float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = 0.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -3.4028235e38f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = (float)NAN, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = -(float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 0.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = -1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = -3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1e-45f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 7.5e-19f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1e-18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.25e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)NAN, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {-(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {-3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -3.4028235e38f},
        {.samples = 60U, .u_max = (float)INFINITY, .a = 1e-18f, .k = {9.0f, 2.1771365e30f}, .deadbeat = 0.0f},
    };
    const stage36_selftest_session *session = &stage36_selftest_sessions[0];
    uint32_t failures = 0U;
    stage36 self;

    if (stage36_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 34U; i++) {
        if (stage36_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage36_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage36_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage36_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage36_selftest_pointers(void)
{
    const stage36_selftest_session *session = &stage36_selftest_sessions[0];
    const stage36_selftest_call *call = &stage36_selftest_calls[0];
    uint32_t failures = 0U;
    float u[2] = {12345.0f, 12345.0f};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage36 self;

    if (stage36_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage36_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage36_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage36_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage36_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage36_selftest_differs(u[i], 0.0f);
        u[i] = 12345.0f;
    }
    if (stage36_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage36_selftest_differs(u[i], 0.0f);
    }
    if (stage36_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage36_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage36_selftest(void)
{
    uint32_t failures = stage36_selftest_run();

    failures += stage36_selftest_refuse();
    failures += stage36_selftest_pointers();
    return failures;
}
