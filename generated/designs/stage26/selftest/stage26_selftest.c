/* Self-test of the prescribed-time controller stage26: see stage26_selftest.h. DO NOT EDIT. */
#include "stage26_selftest.h"
#include "stage26.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage26_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[4]; /* what is measured */
    ptc_status status;
    float u[2];
    ptc_status axes[2];
} stage26_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage26_selftest_session {
    stage26_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage26_selftest_session;

static const stage26_selftest_session stage26_selftest_sessions[7] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 36U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 3.4028235e38f, .m = 0.0f}, .first = 37U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 38U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 39U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 41U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f}, .first = 42U, .count = 3U},
};

static const stage26_selftest_call stage26_selftest_calls[45] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f, -0.25f, -0.75f}, .status = PTC_OK, .u = {-0.053813577f, -0.9340043f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f, 0.24173611f, -0.24173611f, -0.72520834f}, .status = PTC_OK, .u = {-0.056826413f, -0.93106633f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f, 0.2336111f, -0.2336111f, -0.7008333f}, .status = PTC_OK, .u = {-0.05967456f, -0.9289903f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f, 0.225625f, -0.225625f, -0.676875f}, .status = PTC_OK, .u = {-0.062355816f, -0.927791f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f, 0.140625f, -0.140625f, -0.421875f}, .status = PTC_OK, .u = {-0.08085437f, -0.98695177f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f, 0.08027778f, -0.08027778f, -0.24083333f}, .status = PTC_OK, .u = {-0.07533417f, -1.1760298f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f, 0.07111111f, -0.07111111f, -0.21333334f}, .status = PTC_OK, .u = {-0.072205156f, -1.2261899f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f, 0.06673611f, -0.06673611f, -0.20020834f}, .status = PTC_OK, .u = {-0.070424505f, -1.2532498f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f, 0.0625f, -0.0625f, -0.1875f}, .status = PTC_OK, .u = {-0.068507545f, -1.2816676f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f, 0.058402777f, -0.058402777f, -0.17520833f}, .status = PTC_OK, .u = {-0.06646066f, -1.3114738f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f, 0.015625f, -0.015625f, -0.046875f}, .status = PTC_OK, .u = {-0.029047504f, -1.9057932f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f, -0.0033333334f}, .status = PTC_OK, .u = {-0.0047179586f, -4.2494955f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f, -0.00083333335f}, .status = PTC_OK, .u = {-0.00029408847f, -1.0595518f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f, -0.00020833334f}, .status = PTC_OK, .u = {-1.836828e-5f, -0.26471156f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f, -0.25f, -0.75f}, .status = PTC_OK, .u = {-0.053813577f, -0.9340043f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f, 0.24173611f, -0.24173611f, -0.72520834f}, .status = PTC_OK, .u = {-0.056826413f, -0.93106633f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f, 0.2336111f, -0.2336111f, -0.7008333f}, .status = PTC_OK, .u = {-0.05967456f, -0.9289903f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f, 0.225625f, -0.225625f, -0.676875f}, .status = PTC_OK, .u = {-0.062355816f, -0.927791f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f, 0.140625f, -0.140625f, -0.421875f}, .status = PTC_OK, .u = {-0.08085437f, -0.98695177f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f, 0.08027778f, -0.08027778f, -0.24083333f}, .status = PTC_OK, .u = {-0.07533417f, -1.1760298f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f, 0.07111111f, -0.07111111f, -0.21333334f}, .status = PTC_OK, .u = {-0.072205156f, -1.2261899f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f, 0.06673611f, -0.06673611f, -0.20020834f}, .status = PTC_OK, .u = {-0.070424505f, -1.2532498f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f, 0.0625f, -0.0625f, -0.1875f}, .status = PTC_OK, .u = {-0.068507545f, -1.2816676f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f, 0.058402777f, -0.058402777f, -0.17520833f}, .status = PTC_OK, .u = {-0.06646066f, -1.3114738f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f, 0.015625f, -0.015625f, -0.046875f}, .status = PTC_OK, .u = {-0.029047504f, -1.9057932f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f, 0.0011111111f, -0.0011111111f, -0.0033333334f}, .status = PTC_OK, .u = {-0.0047179586f, -4.2494955f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f, 0.00027777778f, -0.00027777778f, -0.00083333335f}, .status = PTC_OK, .u = {-0.00029408847f, -1.0595518f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f, 6.9444446e-5f, -6.9444446e-5f, -0.00020833334f}, .status = PTC_OK, .u = {-1.836828e-5f, -0.26471156f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f, -0.0f, -0.0f}, .status = PTC_HOLD, .u = {0.0f, 0.0f}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = {0.0f, 0.0f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f, 0.0f, 0.0f, 0.0f}, .status = PTC_OK, .u = {0.0f, 0.0f}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {-9.862031e18f, -1.1129778e19f, -5.514641e18f, -8.113509e18f}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {-7.8360127e18f, -1.3755977e19f, -1.1474486e19f, -5.714955e18f}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 0U, .k = 14U, .y = {-5.633697e18f, 1.4011621e19f, 1.7621673e19f, 6.3156113e18f}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 47U, .y = {0.59616363f, 0.00067003793f, -3.1915808e32f, -0.8023546f}, .status = PTC_E_RANGE, .u = {0.0f, 0.0f}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.65130734f, 0.90518564f, -0.39747992f, -0.79874957f}, .status = PTC_SATURATED, .u = {-1.0f, -1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.60051566f, -0.43429255f, 0.5339741f, 0.38516048f}, .status = PTC_SATURATED, .u = {-1.0f, 1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.805786f, -0.47627044f, -0.76374763f, 0.8166589f}, .status = PTC_SATURATED, .u = {1.0f, -1.0f}, .axes = {PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage26_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage26_selftest_check(stage26 *self, const stage26_selftest_call *call)
{
    uint32_t failures = 0U;
    float u[2] = {12345.0f, 12345.0f};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage26_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage26_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage26_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage26_selftest_calls_of(stage26 *self, const stage26_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage26_selftest_check(self, &stage26_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage26_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 7U; i++) {
        const stage26_selftest_session *session = &stage26_selftest_sessions[i];
        stage26 self;

        if (stage26_init(&self, &session->params) == PTC_OK) {
            failures += stage26_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage26_selftest_refuse(void)
{
    static const stage26_params refused[49] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 1U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 1e-18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 1e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)NAN, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -(float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 0.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = -3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-45f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 7.5e-19f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1e-18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.25e18f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)NAN, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {(float)INFINITY, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-(float)INFINITY, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {3.4028235e38f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {-3.4028235e38f, 6.0f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)NAN}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, (float)INFINITY}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -(float)INFINITY}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 3.4028235e38f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, -3.4028235e38f}, .deadbeat = 0.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)NAN, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = (float)INFINITY, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -(float)INFINITY, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -1.0f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = -3.4028235e38f, .m = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .a = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f, .m = -(float)INFINITY},
        {.samples = 60U, .h = 1e18f, .u_max = 1.1218457e-26f, .a = 1e-18f, .k = {3.4028235e38f, 3.4028235e38f}, .deadbeat = 0.0f, .m = -3665993500000000.0f},
    };
    const stage26_selftest_session *session = &stage26_selftest_sessions[0];
    uint32_t failures = 0U;
    stage26 self;

    if (stage26_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 49U; i++) {
        if (stage26_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage26_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage26_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage26_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage26_selftest(void)
{
    uint32_t failures = stage26_selftest_run();

    failures += stage26_selftest_refuse();
    return failures;
}
