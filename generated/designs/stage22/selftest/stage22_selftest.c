/* Self-test of the prescribed-time controller stage22: see stage22_selftest.h. DO NOT EDIT. */
#include "stage22_selftest.h"
#include "stage22.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage22_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    double r[3]; /* the reference and its derivatives */
    ptc_status status;
    double u;
} stage22_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage22_selftest_session {
    stage22_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage22_selftest_session;

static const stage22_selftest_session stage22_selftest_sessions[3] = {
    {.params = {.u_max = (double)INFINITY, .k = 1.0}, .first = 0U, .count = 66U},
    {.params = {.u_max = (double)INFINITY, .k = 1.0}, .first = 66U, .count = 1U},
    {.params = {.u_max = 1.0, .k = 1.0}, .first = 67U, .count = 2U},
};

static const stage22_selftest_call stage22_selftest_calls[69] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .r = {-0.25, -0.75, -1.25}, .status = PTC_OK, .u = -337.6619410021552},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333333333333, 0.2336111111111111}, .r = {-0.2336111111111111, -0.7008333333333333, -1.1680555555555556}, .status = PTC_OK, .u = -333.9972738900656},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333333333333, 0.2177777777777778}, .r = {-0.2177777777777778, -0.6533333333333333, -1.088888888888889}, .status = PTC_OK, .u = -330.60103320097016},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075, 0.2025}, .r = {-0.2025, -0.6075, -1.0125000000000002}, .status = PTC_OK, .u = -327.4633286363975},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.4408333333333334, 0.14694444444444446}, .r = {-0.14694444444444446, -0.4408333333333334, -0.7347222222222223}, .status = PTC_OK, .u = -317.30489916104955},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3008333333333333, 0.10027777777777777}, .r = {-0.10027777777777777, -0.3008333333333333, -0.5013888888888889}, .status = PTC_OK, .u = -310.60870447600877},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2408333333333333, 0.08027777777777777}, .r = {-0.08027777777777777, -0.2408333333333333, -0.40138888888888885}, .status = PTC_OK, .u = -308.5000261003808},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333333333333332, 0.07111111111111111}, .r = {-0.07111111111111111, -0.21333333333333332, -0.35555555555555557}, .status = PTC_OK, .u = -307.7743466083029},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875, 0.0625}, .r = {-0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -307.28921440669467},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333333333333, 0.05444444444444445}, .r = {-0.05444444444444445, -0.16333333333333333, -0.27222222222222225}, .status = PTC_OK, .u = -307.07162353820075},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.05333333333333333, 0.017777777777777778}, .r = {-0.017777777777777778, -0.05333333333333333, -0.08888888888888889}, .status = PTC_OK, .u = -315.6114130899452},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333333333333332, 0.0044444444444444444}, .r = {-0.0044444444444444444, -0.013333333333333332, -0.022222222222222223}, .status = PTC_OK, .u = -360.91467983496955},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.003333333333333333, 0.0011111111111111111}, .r = {-0.0011111111111111111, -0.003333333333333333, -0.005555555555555556}, .status = PTC_OK, .u = -90.22679187242755},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.0008333333333333333, 0.0002777777777777778}, .r = {-0.0002777777777777778, -0.0008333333333333333, -0.001388888888888889}, .status = PTC_OK, .u = -22.556668623006686},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .r = {-0.25, -0.75, -1.25}, .status = PTC_OK, .u = -337.6619410021552},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333333333333, 0.2336111111111111}, .r = {-0.2336111111111111, -0.7008333333333333, -1.1680555555555556}, .status = PTC_OK, .u = -333.9972738900656},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333333333333, 0.2177777777777778}, .r = {-0.2177777777777778, -0.6533333333333333, -1.088888888888889}, .status = PTC_OK, .u = -330.60103320097016},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .r = {0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .r = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075, 0.2025}, .r = {-0.2025, -0.6075, -1.0125000000000002}, .status = PTC_OK, .u = -327.4633286363975},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.4408333333333334, 0.14694444444444446}, .r = {-0.14694444444444446, -0.4408333333333334, -0.7347222222222223}, .status = PTC_OK, .u = -317.30489916104955},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.3008333333333333, 0.10027777777777777}, .r = {-0.10027777777777777, -0.3008333333333333, -0.5013888888888889}, .status = PTC_OK, .u = -310.60870447600877},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.2408333333333333, 0.08027777777777777}, .r = {-0.08027777777777777, -0.2408333333333333, -0.40138888888888885}, .status = PTC_OK, .u = -308.5000261003808},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333333333333332, 0.07111111111111111}, .r = {-0.07111111111111111, -0.21333333333333332, -0.35555555555555557}, .status = PTC_OK, .u = -307.7743466083029},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875, 0.0625}, .r = {-0.0625, -0.1875, -0.3125}, .status = PTC_OK, .u = -307.28921440669467},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333333333333, 0.05444444444444445}, .r = {-0.05444444444444445, -0.16333333333333333, -0.27222222222222225}, .status = PTC_OK, .u = -307.07162353820075},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.05333333333333333, 0.017777777777777778}, .r = {-0.017777777777777778, -0.05333333333333333, -0.08888888888888889}, .status = PTC_OK, .u = -315.6114130899452},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333333333333332, 0.0044444444444444444}, .r = {-0.0044444444444444444, -0.013333333333333332, -0.022222222222222223}, .status = PTC_OK, .u = -360.91467983496955},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.003333333333333333, 0.0011111111111111111}, .r = {-0.0011111111111111111, -0.003333333333333333, -0.005555555555555556}, .status = PTC_OK, .u = -90.22679187242755},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.0008333333333333333, 0.0002777777777777778}, .r = {-0.0002777777777777778, -0.0008333333333333333, -0.001388888888888889}, .status = PTC_OK, .u = -22.556668623006686},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .r = {-0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {-1.3214991752685608e154, -8.589049603666809e153}, .r = {9.407815773737972e153, -1.3366341414314021e154, -6.840402997347378e153}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.7003824460967927, 0.5116811303149718}, .r = {-0.28385011604249943, -0.3639644845672226, -0.9664154123401104}, .status = PTC_SATURATED, .u = 1.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.8839741239684351, -0.3676585321059431}, .r = {0.3549915737420746, -0.31788718275307726, 0.8666222664352536}, .status = PTC_SATURATED, .u = -1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage22_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage22_selftest_check(stage22 *self, const stage22_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage22_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage22_step(self, call->k, call->y, call->r, &u) != call->status) {
        failures++;
    }
    failures += stage22_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage22_selftest_calls_of(stage22 *self, const stage22_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage22_selftest_check(self, &stage22_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage22_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage22_selftest_session *session = &stage22_selftest_sessions[i];
        stage22 self;

        if (stage22_init(&self, &session->params) == PTC_OK) {
            failures += stage22_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage22_selftest_refuse(void)
{
    static const stage22_params refused[8] = {
        {.u_max = (double)NAN, .k = 1.0},
        {.u_max = -(double)INFINITY, .k = 1.0},
        {.u_max = 0.0, .k = 1.0},
        {.u_max = -1.0, .k = 1.0},
        {.u_max = -1.7976931348623157e308, .k = 1.0},
        {.u_max = (double)INFINITY, .k = (double)NAN},
        {.u_max = (double)INFINITY, .k = (double)INFINITY},
        {.u_max = (double)INFINITY, .k = -(double)INFINITY},
    };
    const stage22_selftest_session *session = &stage22_selftest_sessions[0];
    uint32_t failures = 0U;
    stage22 self;

    if (stage22_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        if (stage22_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage22_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage22_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage22_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage22_selftest_pointers(void)
{
    const stage22_selftest_session *session = &stage22_selftest_sessions[0];
    const stage22_selftest_call *call = &stage22_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage22 self;

    if (stage22_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage22_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage22_step(NULL, call->k, call->y, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage22_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage22_step(&self, call->k, NULL, call->r, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage22_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage22_step(&self, call->k, call->y, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage22_selftest_differs(u, 0.0);
    if (stage22_step(&self, call->k, call->y, call->r, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage22_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage22_selftest(void)
{
    uint32_t failures = stage22_selftest_run();

    failures += stage22_selftest_refuse();
    failures += stage22_selftest_pointers();
    return failures;
}
