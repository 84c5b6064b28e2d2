/* Self-test of the prescribed-time controller stage49: see stage49_selftest.h. DO NOT EDIT. */
#include "stage49_selftest.h"
#include "stage49.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage49_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[2]; /* what is measured */
    ptc_status status;
    float u;
} stage49_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage49_selftest_session {
    stage49_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage49_selftest_session;

static const stage49_selftest_session stage49_selftest_sessions[3] = {
    {.params = {.u_max = (float)INFINITY}, .first = 0U, .count = 36U},
    {.params = {.u_max = (float)INFINITY}, .first = 36U, .count = 3U},
    {.params = {.u_max = 1.0f}, .first = 39U, .count = 2U},
};

static const stage49_selftest_call stage49_selftest_calls[41] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -0.41557676f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7412024f, 0.24706748f}, .status = PTC_OK, .u = -0.41187626f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.73245674f, 0.24415225f}, .status = PTC_OK, .u = -0.40797257f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.723763f, 0.24125433f}, .status = PTC_OK, .u = -0.4087116f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.4251903f, 0.1417301f}, .status = PTC_OK, .u = -0.36253476f},
    {.is_armed = 0U, .start = 0U, .k = 81U, .y = {0.20556228f, 0.06852076f}, .status = PTC_OK, .u = -1.0957962f},
    {.is_armed = 0U, .start = 0U, .k = 83U, .y = {0.19642733f, 0.06547578f}, .status = PTC_OK, .u = -1.1276854f},
    {.is_armed = 0U, .start = 0U, .k = 84U, .y = {0.19193771f, 0.06397924f}, .status = PTC_OK, .u = -1.1227809f},
    {.is_armed = 0U, .start = 0U, .k = 85U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -1.1441011f},
    {.is_armed = 0U, .start = 0U, .k = 86U, .y = {0.18311419f, 0.061038062f}, .status = PTC_OK, .u = -1.1637115f},
    {.is_armed = 0U, .start = 0U, .k = 127U, .y = {0.04798443f, 0.01599481f}, .status = PTC_OK, .u = -4.7156706f},
    {.is_armed = 0U, .start = 0U, .k = 166U, .y = {0.0004152249f, 0.0001384083f}, .status = PTC_OK, .u = 8.70746f},
    {.is_armed = 0U, .start = 0U, .k = 168U, .y = {0.000103806226f, 3.4602075e-5f}, .status = PTC_OK, .u = -4.3315287f},
    {.is_armed = 0U, .start = 0U, .k = 169U, .y = {2.5951556e-5f, 8.650519e-6f}, .status = PTC_OK, .u = -17.665829f},
    {.is_armed = 0U, .start = 0U, .k = 170U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 171U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f, 0.25f}, .status = PTC_OK, .u = -0.41557676f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7412024f, 0.24706748f}, .status = PTC_OK, .u = -0.41187626f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.73245674f, 0.24415225f}, .status = PTC_OK, .u = -0.40797257f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.723763f, 0.24125433f}, .status = PTC_OK, .u = -0.4087116f},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.4251903f, 0.1417301f}, .status = PTC_OK, .u = -0.36253476f},
    {.is_armed = 0U, .start = 0U, .k = 78U, .y = {0.20556228f, 0.06852076f}, .status = PTC_OK, .u = -1.0957962f},
    {.is_armed = 0U, .start = 0U, .k = 80U, .y = {0.19642733f, 0.06547578f}, .status = PTC_OK, .u = -1.1276854f},
    {.is_armed = 0U, .start = 0U, .k = 81U, .y = {0.19193771f, 0.06397924f}, .status = PTC_OK, .u = -1.1227809f},
    {.is_armed = 0U, .start = 0U, .k = 82U, .y = {0.1875f, 0.0625f}, .status = PTC_OK, .u = -1.1441011f},
    {.is_armed = 0U, .start = 0U, .k = 83U, .y = {0.18311419f, 0.061038062f}, .status = PTC_OK, .u = -1.1637115f},
    {.is_armed = 0U, .start = 0U, .k = 124U, .y = {0.04798443f, 0.01599481f}, .status = PTC_OK, .u = -4.7156706f},
    {.is_armed = 0U, .start = 0U, .k = 163U, .y = {0.0004152249f, 0.0001384083f}, .status = PTC_OK, .u = 8.70746f},
    {.is_armed = 0U, .start = 0U, .k = 165U, .y = {0.000103806226f, 3.4602075e-5f}, .status = PTC_OK, .u = -4.3315287f},
    {.is_armed = 0U, .start = 0U, .k = 166U, .y = {2.5951556e-5f, 8.650519e-6f}, .status = PTC_OK, .u = -17.665829f},
    {.is_armed = 0U, .start = 0U, .k = 167U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 168U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f, 0.0f}, .status = PTC_AFTER, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 139U, .y = {-0.60859954f, -0.9679373f}, .status = PTC_OK, .u = 133.71275f},
    {.is_armed = 0U, .start = 0U, .k = 155U, .y = {-0.63686675f, 0.29820222f}, .status = PTC_OK, .u = 365.97464f},
    {.is_armed = 0U, .start = 0U, .k = 129U, .y = {-1.227276e38f, -3.1614585e38f}, .status = PTC_E_RANGE, .u = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.76074064f, 0.9511884f}, .status = PTC_SATURATED, .u = -1.0f},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {-0.7916984f, -0.6602934f}, .status = PTC_SATURATED, .u = 1.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage49_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage49_selftest_check(stage49 *self, const stage49_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage49_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage49_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage49_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage49_selftest_calls_of(stage49 *self, const stage49_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage49_selftest_check(self, &stage49_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage49_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage49_selftest_session *session = &stage49_selftest_sessions[i];
        stage49 self;

        if (stage49_init(&self, &session->params) == PTC_OK) {
            failures += stage49_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage49_selftest_refuse(void)
{
    static const stage49_params refused[5] = {
        {.u_max = (float)NAN},
        {.u_max = -(float)INFINITY},
        {.u_max = 0.0f},
        {.u_max = -1.0f},
        {.u_max = -3.4028235e38f},
    };
    const stage49_selftest_session *session = &stage49_selftest_sessions[0];
    uint32_t failures = 0U;
    stage49 self;

    if (stage49_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage49_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage49_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage49_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage49_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage49_selftest(void)
{
    uint32_t failures = stage49_selftest_run();

    failures += stage49_selftest_refuse();
    return failures;
}
