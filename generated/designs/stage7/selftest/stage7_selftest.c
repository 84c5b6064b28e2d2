/* Self-test of the prescribed-time controller stage7: see stage7_selftest.h. DO NOT EDIT. */
#include "stage7_selftest.h"
#include "stage7.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage7_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[1]; /* what is measured */
    ptc_status status;
    float u;
    float xhat[1]; /* the estimates behind it */
    float d;
} stage7_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage7_selftest_session {
    stage7_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage7_selftest_session;

static const stage7_selftest_session stage7_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY}, .first = 36U, .count = 3U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY}, .first = 39U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f}, .first = 40U, .count = 2U},
};

static const stage7_selftest_call stage7_selftest_calls[42] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .status = PTC_OK, .u = -2.3225806f, .xhat = {0.75f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f}, .status = PTC_OK, .u = -2.2667553f, .xhat = {0.71671176f}, .d = 0.010875608f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f}, .status = PTC_OK, .u = -2.227962f, .xhat = {0.6866904f}, .d = 0.030552723f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f}, .status = PTC_OK, .u = -2.2025757f, .xhat = {0.6592016f}, .d = 0.057377085f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f}, .status = PTC_OK, .u = -1.4715385f, .xhat = {0.5286315f}, .d = -0.68797755f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f}, .status = PTC_OK, .u = 15.663099f, .xhat = {0.24083334f}, .d = -16.947544f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f}, .status = PTC_OK, .u = 16.218393f, .xhat = {0.21333334f}, .d = -17.4231f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f}, .status = PTC_OK, .u = 15.893545f, .xhat = {0.20020834f}, .d = -17.058393f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f}, .status = PTC_OK, .u = 15.581879f, .xhat = {0.1875f}, .d = -16.706879f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f}, .status = PTC_OK, .u = 15.283384f, .xhat = {0.17520833f}, .d = -16.368546f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f}, .status = PTC_OK, .u = 22.967306f, .xhat = {0.046875f}, .d = -23.496717f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f}, .status = PTC_OK, .u = 25.647306f, .xhat = {0.0033333339f}, .d = -25.753973f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f}, .status = PTC_OK, .u = 25.767305f, .xhat = {0.00083333335f}, .d = -25.807306f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f}, .status = PTC_OK, .u = 25.79397f, .xhat = {0.00020833334f}, .d = -25.807304f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f}, .status = PTC_HOLD, .u = 25.807304f, .xhat = {0.0f}, .d = -25.807304f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f}, .status = PTC_HOLD, .u = 25.807304f, .xhat = {0.0f}, .d = -25.807304f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .status = PTC_HOLD, .u = 25.807304f, .xhat = {0.0f}, .d = -25.807304f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .status = PTC_HOLD, .u = 25.807304f, .xhat = {0.0f}, .d = -25.807304f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .status = PTC_OK, .u = 24.557917f, .xhat = {0.18965518f}, .d = -25.145235f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f}, .status = PTC_OK, .u = 23.614315f, .xhat = {0.32269847f}, .d = -24.630022f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f}, .status = PTC_OK, .u = 22.907694f, .xhat = {0.4131469f}, .d = -24.229763f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f}, .status = PTC_OK, .u = 22.382996f, .xhat = {0.47189063f}, .d = -23.91864f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f}, .status = PTC_OK, .u = 22.234718f, .xhat = {0.43550515f}, .d = -24.013803f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f}, .status = PTC_OK, .u = 33.40927f, .xhat = {0.24083333f}, .d = -34.693714f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f}, .status = PTC_OK, .u = 33.96457f, .xhat = {0.21333334f}, .d = -35.169273f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f}, .status = PTC_OK, .u = 33.63972f, .xhat = {0.20020834f}, .d = -34.80457f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f}, .status = PTC_OK, .u = 33.328056f, .xhat = {0.1875f}, .d = -34.453056f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f}, .status = PTC_OK, .u = 33.02956f, .xhat = {0.17520833f}, .d = -34.114723f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f}, .status = PTC_OK, .u = 40.71348f, .xhat = {0.046875f}, .d = -41.242893f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f}, .status = PTC_OK, .u = 43.393482f, .xhat = {0.0033333339f}, .d = -43.50015f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f}, .status = PTC_OK, .u = 43.51348f, .xhat = {0.00083333335f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f}, .status = PTC_OK, .u = 43.54015f, .xhat = {0.00020833334f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f}, .status = PTC_HOLD, .u = 43.553482f, .xhat = {0.0f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f}, .status = PTC_HOLD, .u = 43.553482f, .xhat = {0.0f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .status = PTC_HOLD, .u = 43.553482f, .xhat = {0.0f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .status = PTC_HOLD, .u = 43.553482f, .xhat = {0.0f}, .d = -43.553482f},
    {.is_armed = 0U, .start = 0U, .k = 24U, .y = {-0.36344036f}, .status = PTC_OK, .u = 1.8363302f, .xhat = {-0.36344036f}, .d = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 12U, .y = {-1.04901e19f}, .status = PTC_OK, .u = 8.73886e19f, .xhat = {-6.039755e18f}, .d = -6.103331e19f},
    {.is_armed = 1U, .start = 0U, .k = 4U, .y = {-5.9731294e18f}, .status = PTC_OK, .u = 1.9773118e19f, .xhat = {-5.9731294e18f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 29U, .y = {-1.5510462e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.66494954f}, .status = PTC_SATURATED, .u = -1.0f, .xhat = {0.66494954f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {-0.8910031f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.18722627f}, .d = -1.9716192f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage7_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage7_selftest_check(stage7 *self, const stage7_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[1] = {12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage7_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage7_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage7_selftest_differs(u, call->u);
    if (stage7_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 1U; i++) {
        failures += stage7_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage7_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage7_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage7_selftest_calls_of(stage7 *self, const stage7_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage7_selftest_check(self, &stage7_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage7_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage7_selftest_session *session = &stage7_selftest_sessions[i];
        stage7 self;

        if (stage7_init(&self, &session->params) == PTC_OK) {
            failures += stage7_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage7_selftest_refuse(void)
{
    static const stage7_params refused[17] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY},
        {.samples = 3U, .h = 0.015625f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f},
    };
    const stage7_selftest_session *session = &stage7_selftest_sessions[0];
    uint32_t failures = 0U;
    stage7 self;

    if (stage7_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 17U; i++) {
        if (stage7_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage7_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage7_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage7_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage7_selftest(void)
{
    uint32_t failures = stage7_selftest_run();

    failures += stage7_selftest_refuse();
    return failures;
}
