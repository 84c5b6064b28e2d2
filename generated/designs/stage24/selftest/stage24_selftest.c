/* Self-test of the prescribed-time controller stage24: see stage24_selftest.h. DO NOT EDIT. */
#include "stage24_selftest.h"
#include "stage24.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage24_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    ptc_status status;
    float u;
} stage24_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage24_selftest_session {
    stage24_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage24_selftest_session;

static const stage24_selftest_session stage24_selftest_sessions[3] = {
    {.params = {.u_max = (float)INFINITY, .size = 0.0f}, .first = 0U, .count = 48U},
    {.params = {.u_max = (float)INFINITY, .size = 0.0f}, .first = 48U, .count = 1U},
    {.params = {.u_max = 1.0f, .size = 0.0f}, .first = 49U, .count = 2U},
};

static const stage24_selftest_call stage24_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -60.88894f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -61.07869f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333f, 0.21777777f}, .status = PTC_OK, .u = -61.248528f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075f, 0.2025f}, .status = PTC_OK, .u = -61.395866f},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.44083333f, 0.14694445f}, .status = PTC_OK, .u = -61.69456f},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.30083334f, 0.10027778f}, .status = PTC_OK, .u = -61.3028f},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = -60.705265f},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = -60.267525f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -59.716354f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333f, 0.054444443f}, .status = PTC_OK, .u = -59.031933f},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.053333335f, 0.017777778f}, .status = PTC_OK, .u = -50.21976f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333334f, 0.0044444446f}, .status = PTC_OK, .u = -34.05129f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = -18.192303f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = -4.5480757f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -60.88894f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333f, 0.2336111f}, .status = PTC_OK, .u = -61.07869f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333f, 0.21777777f}, .status = PTC_OK, .u = -61.248528f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)NAN}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, (float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY, 0.5f}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5f, -(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075f, 0.2025f}, .status = PTC_OK, .u = -61.395866f},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.44083333f, 0.14694445f}, .status = PTC_OK, .u = -61.69456f},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.30083334f, 0.10027778f}, .status = PTC_OK, .u = -61.3028f},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.24083333f, 0.08027778f}, .status = PTC_OK, .u = -60.705265f},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333334f, 0.07111111f}, .status = PTC_OK, .u = -60.267525f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -59.716354f},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333f, 0.054444443f}, .status = PTC_OK, .u = -59.031933f},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.053333335f, 0.017777778f}, .status = PTC_OK, .u = -50.21976f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333334f, 0.0044444446f}, .status = PTC_OK, .u = -34.05129f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.0033333334f, 0.0011111111f}, .status = PTC_OK, .u = -18.192303f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.00083333335f, 0.00027777778f}, .status = PTC_OK, .u = -4.5480757f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .status = PTC_HOLD, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 8U, .y = {2.5286368e38f, 3.2011317e38f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.39491278f, 0.84316254f}, .status = PTC_SATURATED, .u = 1.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.3071236f, 0.6381369f}, .status = PTC_SATURATED, .u = -1.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage24_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage24_selftest_check(stage24 *self, const stage24_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage24_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage24_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage24_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage24_selftest_calls_of(stage24 *self, const stage24_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage24_selftest_check(self, &stage24_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage24_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage24_selftest_session *session = &stage24_selftest_sessions[i];
        stage24 self;

        if (stage24_init(&self, &session->params) == PTC_OK) {
            failures += stage24_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage24_selftest_refuse(void)
{
    static const stage24_params refused[10] = {
        {.u_max = (float)NAN, .size = 0.0f},
        {.u_max = -(float)INFINITY, .size = 0.0f},
        {.u_max = 0.0f, .size = 0.0f},
        {.u_max = -1.0f, .size = 0.0f},
        {.u_max = -3.4028235e38f, .size = 0.0f},
        {.u_max = (float)INFINITY, .size = (float)NAN},
        {.u_max = (float)INFINITY, .size = (float)INFINITY},
        {.u_max = (float)INFINITY, .size = -(float)INFINITY},
        {.u_max = (float)INFINITY, .size = 3.4028235e38f},
        {.u_max = (float)INFINITY, .size = -3.4028235e38f},
    };
    const stage24_selftest_session *session = &stage24_selftest_sessions[0];
    uint32_t failures = 0U;
    stage24 self;

    if (stage24_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 10U; i++) {
        if (stage24_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage24_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage24_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage24_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage24_selftest_pointers(void)
{
    const stage24_selftest_session *session = &stage24_selftest_sessions[0];
    const stage24_selftest_call *call = &stage24_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    stage24 self;

    if (stage24_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage24_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage24_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage24_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (stage24_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage24_selftest_differs(u, 0.0f);
    if (stage24_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage24_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage24_selftest(void)
{
    uint32_t failures = stage24_selftest_run();

    failures += stage24_selftest_refuse();
    failures += stage24_selftest_pointers();
    return failures;
}
