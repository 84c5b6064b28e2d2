/* Self-test of the prescribed-time controller stage19: see stage19_selftest.h. DO NOT EDIT. */
#include "stage19_selftest.h"
#include "stage19.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage19_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[3]; /* what is measured */
    ptc_status status;
    float u;
} stage19_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage19_selftest_session {
    stage19_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage19_selftest_session;

static const stage19_selftest_session stage19_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 0.0f}, .deadbeat = 0.0f}, .first = 36U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 3.4028235e38f}, .first = 37U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f}, .first = 38U, .count = 1U},
};

static const stage19_selftest_call stage19_selftest_calls[39] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_OK, .u = -2.437405f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f, -0.24173611f}, .status = PTC_OK, .u = -2.4113154f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f, -0.2336111f}, .status = PTC_OK, .u = -2.3876097f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f, -0.225625f}, .status = PTC_OK, .u = -2.3663032f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f, -0.140625f}, .status = PTC_OK, .u = -2.309012f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f, -0.08027778f}, .status = PTC_OK, .u = -2.659158f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f, -0.07111111f}, .status = PTC_OK, .u = -2.783378f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f, -0.06673611f}, .status = PTC_OK, .u = -2.8550355f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_OK, .u = -2.933834f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f, -0.058402777f}, .status = PTC_OK, .u = -3.0204723f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f, -0.015625f}, .status = PTC_OK, .u = -6.005539f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f}, .status = PTC_OK, .u = -17.656366f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f}, .status = PTC_OK, .u = -4.414046f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f}, .status = PTC_OK, .u = -1.1035106f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f, -0.25f}, .status = PTC_OK, .u = -2.437405f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f, -0.24173611f}, .status = PTC_OK, .u = -2.4113154f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f, -0.2336111f}, .status = PTC_OK, .u = -2.3876097f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f, -0.225625f}, .status = PTC_OK, .u = -2.3663032f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f, -0.140625f}, .status = PTC_OK, .u = -2.309012f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f, -0.08027778f}, .status = PTC_OK, .u = -2.659158f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f, -0.07111111f}, .status = PTC_OK, .u = -2.783378f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f, -0.06673611f}, .status = PTC_OK, .u = -2.8550355f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f, -0.0625f}, .status = PTC_OK, .u = -2.933834f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f, -0.058402777f}, .status = PTC_OK, .u = -3.0204723f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f, -0.015625f}, .status = PTC_OK, .u = -6.005539f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f}, .status = PTC_OK, .u = -17.656366f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f}, .status = PTC_OK, .u = -4.414046f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f}, .status = PTC_OK, .u = -1.1035106f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f, -0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 5U, .y = {8.2284146e18f, 5.679483e18f, 7.424085e18f}, .status = PTC_E_RANGE, .u = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage19_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage19_selftest_check(stage19 *self, const stage19_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage19_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage19_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage19_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage19_selftest_calls_of(stage19 *self, const stage19_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage19_selftest_check(self, &stage19_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage19_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage19_selftest_session *session = &stage19_selftest_sessions[i];
        stage19 self;

        if (stage19_init(&self, &session->params) == PTC_OK) {
            failures += stage19_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage19_selftest_refuse(void)
{
    static const stage19_params refused[36] = {
        {.samples = 0U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 2U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)NAN, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)INFINITY, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -(float)INFINITY, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -1.0f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 3.4028235e38f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -3.4028235e38f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-45f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 7.5e-19f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-18f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e18f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1.25e18f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {(float)NAN, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {(float)INFINITY, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {-(float)INFINITY, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {3.4028235e38f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {-3.4028235e38f, 48.0f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, (float)NAN, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, (float)INFINITY, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, -(float)INFINITY, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 3.4028235e38f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, -3.4028235e38f, 12.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .h = 0.015625f, .k = {64.0f, 48.0f, 12.0f}, .deadbeat = -3.4028235e38f},
        {.samples = 60U, .h = 0.00036031782f, .k = {4.922316e-19f, 3.4028235e38f, 3.4028235e38f}, .deadbeat = 3.4028235e38f},
        {.samples = 60U, .h = 5.3219963e-11f, .k = {64.0f, 48.0f, 241.95505f}, .deadbeat = 0.0f},
    };
    const stage19_selftest_session *session = &stage19_selftest_sessions[0];
    uint32_t failures = 0U;
    stage19 self;

    if (stage19_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 36U; i++) {
        if (stage19_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage19_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage19_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage19_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage19_selftest(void)
{
    uint32_t failures = stage19_selftest_run();

    failures += stage19_selftest_refuse();
    return failures;
}
