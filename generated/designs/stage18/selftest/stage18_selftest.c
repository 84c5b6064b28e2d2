/* Self-test of the prescribed-time controller stage18: see stage18_selftest.h. DO NOT EDIT. */
#include "stage18_selftest.h"
#include "stage18.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage18_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
} stage18_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage18_selftest_session {
    stage18_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage18_selftest_session;

static const stage18_selftest_session stage18_selftest_sessions[3] = {
    {.params = {.u_max = (double)INFINITY, .k = 1.0}, .first = 0U, .count = 48U},
    {.params = {.u_max = (double)INFINITY, .k = 1.0}, .first = 48U, .count = 1U},
    {.params = {.u_max = 1.0, .k = 1.0}, .first = 49U, .count = 2U},
};

static const stage18_selftest_call stage18_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -236.19642376077587},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -233.61354373133554},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333333333333, 0.2177777777777778}, .status = PTC_OK, .u = -231.28745295405653},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075, 0.2025}, .status = PTC_OK, .u = -229.20755940562827},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.4408333333333334, 0.14694444444444446}, .status = PTC_OK, .u = -223.1384850196354},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3008333333333333, 0.10027777777777777}, .status = PTC_OK, .u = -220.23555632786062},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -219.86391498926963},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -219.9521243860806},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -220.23564297812325},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333333333333, 0.05444444444444445}, .status = PTC_OK, .u = -220.73230729888454},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.05333333333333333, 0.017777777777777778}, .status = PTC_OK, .u = -231.2431591216912},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333333333333332, 0.0044444444444444444}, .status = PTC_OK, .u = -267.9813465016362},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = -66.99345853909423},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -16.748335289673353},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -236.19642376077587},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -233.61354373133554},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333333333333, 0.2177777777777778}, .status = PTC_OK, .u = -231.28745295405653},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075, 0.2025}, .status = PTC_OK, .u = -229.20755940562827},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.4408333333333334, 0.14694444444444446}, .status = PTC_OK, .u = -223.1384850196354},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.3008333333333333, 0.10027777777777777}, .status = PTC_OK, .u = -220.23555632786062},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -219.86391498926963},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -219.9521243860806},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -220.23564297812325},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333333333333, 0.05444444444444445}, .status = PTC_OK, .u = -220.73230729888454},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.05333333333333333, 0.017777777777777778}, .status = PTC_OK, .u = -231.2431591216912},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333333333333332, 0.0044444444444444444}, .status = PTC_OK, .u = -267.9813465016362},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = -66.99345853909423},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -16.748335289673353},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 8U, .y = {1.335865023614178e308, 1.691140449704244e308}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.3949127940538349, 0.8431625471473178}, .status = PTC_SATURATED, .u = 1.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.30712359630010205, 0.6381369078387522}, .status = PTC_SATURATED, .u = -1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage18_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage18_selftest_check(stage18 *self, const stage18_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage18_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage18_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage18_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage18_selftest_calls_of(stage18 *self, const stage18_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage18_selftest_check(self, &stage18_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage18_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage18_selftest_session *session = &stage18_selftest_sessions[i];
        stage18 self;

        if (stage18_init(&self, &session->params) == PTC_OK) {
            failures += stage18_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage18_selftest_refuse(void)
{
    static const stage18_params refused[8] = {
        {.u_max = (double)NAN, .k = 1.0},
        {.u_max = -(double)INFINITY, .k = 1.0},
        {.u_max = 0.0, .k = 1.0},
        {.u_max = -1.0, .k = 1.0},
        {.u_max = -1.7976931348623157e308, .k = 1.0},
        {.u_max = (double)INFINITY, .k = (double)NAN},
        {.u_max = (double)INFINITY, .k = (double)INFINITY},
        {.u_max = (double)INFINITY, .k = -(double)INFINITY},
    };
    const stage18_selftest_session *session = &stage18_selftest_sessions[0];
    uint32_t failures = 0U;
    stage18 self;

    if (stage18_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        if (stage18_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage18_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage18_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage18_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage18_selftest_pointers(void)
{
    const stage18_selftest_session *session = &stage18_selftest_sessions[0];
    const stage18_selftest_call *call = &stage18_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage18 self;

    if (stage18_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage18_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage18_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage18_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage18_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage18_selftest_differs(u, 0.0);
    if (stage18_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage18_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage18_selftest(void)
{
    uint32_t failures = stage18_selftest_run();

    failures += stage18_selftest_refuse();
    failures += stage18_selftest_pointers();
    return failures;
}
