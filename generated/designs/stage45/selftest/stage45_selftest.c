/* Self-test of the prescribed-time controller stage45: see stage45_selftest.h. DO NOT EDIT. */
#include "stage45_selftest.h"
#include "stage45.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage45_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    ptc_status status;
    float u;
} stage45_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage45_selftest_session {
    stage45_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage45_selftest_session;

static const stage45_selftest_session stage45_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 36U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 3.4028235e38f}, .first = 37U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 38U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 39U, .count = 2U},
};

static const stage45_selftest_call stage45_selftest_calls[41] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -11.008754f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = -9.980956f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -8.9774065f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = -7.998531f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = -6.131846f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = -3.1251485f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = -4.2354703f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = -5.3387165f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -6.120679f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = -6.585431f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = -1.8909085f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = 86.01167f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = -80.902084f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = -19.898216f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -12.576874f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -10.256172f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 26.276184f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 613.42725f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -65.9459f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f}, .status = PTC_OK, .u = -64.83285f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -62.89501f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f}, .status = PTC_OK, .u = -60.707844f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f}, .status = PTC_OK, .u = -69.29194f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = 52.838116f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = 35.250088f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f}, .status = PTC_OK, .u = 15.678763f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -2.511451f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f}, .status = PTC_OK, .u = -19.206797f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f}, .status = PTC_OK, .u = -100.38305f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = -35.57759f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = 364.08728f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f}, .status = PTC_OK, .u = -109.68909f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -113.41727f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -120.26111f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = -587.4404f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 353.25513f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f}, .status = PTC_OK, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f}, .status = PTC_OK, .u = -0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967294U, .y = {-1.1567411e38f, -2.6506047e38f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.60287255f, -0.95911556f}, .status = PTC_SATURATED, .u = 1.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6513474f, -0.92827433f}, .status = PTC_SATURATED, .u = -1.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage45_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage45_selftest_check(stage45 *self, const stage45_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage45_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage45_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage45_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage45_selftest_calls_of(stage45 *self, const stage45_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage45_selftest_check(self, &stage45_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage45_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage45_selftest_session *session = &stage45_selftest_sessions[i];
        stage45 self;

        if (stage45_init(&self, &session->params) == PTC_OK) {
            failures += stage45_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage45_selftest_refuse(void)
{
    static const stage45_params refused[47] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 6U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)NAN, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -(float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 0.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-45f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 7.5e-19f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.25e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)NAN, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -3.4028235e38f},
        {.samples = 60U, .h = 1e18f, .u_max = 17117029000000.0f, .a = 1e-18f, .k = {-4572624500000.0f, 8.955566e36f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e18f, .u_max = 3.4028235e38f, .a = 1.0f, .k = {-3.4028235e38f, 2.3162025e-10f}, .deadbeat = 0.0f},
    };
    const stage45_selftest_session *session = &stage45_selftest_sessions[0];
    uint32_t failures = 0U;
    stage45 self;

    if (stage45_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 47U; i++) {
        if (stage45_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage45_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage45_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage45_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage45_selftest(void)
{
    uint32_t failures = stage45_selftest_run();

    failures += stage45_selftest_refuse();
    return failures;
}
