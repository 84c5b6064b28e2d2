/* Self-test of the prescribed-time controller stage37: see stage37_selftest.h. DO NOT EDIT. */
#include "stage37_selftest.h"
#include "stage37.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage37_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
} stage37_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage37_selftest_session {
    stage37_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage37_selftest_session;

static const stage37_selftest_session stage37_selftest_sessions[6] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1e150, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 1.7976931348623157e308}, .first = 49U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 50U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 51U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -0.5, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 52U, .count = 1U},
};

static const stage37_selftest_call stage37_selftest_calls[53] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -9.145762711864407},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -9.125785440613026},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -9.10588693957115},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -9.08607142857143},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -8.856818181818182},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -8.670572390572387},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -8.641146953405018},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = -8.627185185185185},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -8.613793103448275},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = -8.601031746031747},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -8.564285714285715},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = -13.76},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -3.44},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = -0.86},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -9.145762711864407},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -9.125785440613026},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -9.10588693957115},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -9.08607142857143},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -8.856818181818182},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -8.670572390572387},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -8.641146953405018},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = -8.627185185185185},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -8.613793103448275},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = -8.601031746031747},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -8.564285714285715},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = -13.76},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -3.44},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = -0.86},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {9.950088049551815e307, -4.708471454573746e307}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {-0.5872359091733736, 0.616613808634324}, .status = PTC_SATURATED, .u = 1.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.529467005311492, 0.5539400314031642}, .status = PTC_SATURATED, .u = -0.5},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage37_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage37_selftest_check(stage37 *self, const stage37_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage37_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage37_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage37_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage37_selftest_calls_of(stage37 *self, const stage37_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage37_selftest_check(self, &stage37_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage37_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage37_selftest_session *session = &stage37_selftest_sessions[i];
        stage37 self;

        if (stage37_init(&self, &session->params) == PTC_OK) {
            failures += stage37_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage37_selftest_refuse(void)
{
    static const stage37_params refused[44] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 1U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e-150, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = (double)NAN, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = (double)NAN, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = -(double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 0.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = -1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.7976931348623157e308, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = -1.7976931348623157e308, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 5e-324, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 7.5e-151, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.25e150, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {(double)NAN, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {(double)INFINITY, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {-(double)INFINITY, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {1.7976931348623157e308, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {-1.7976931348623157e308, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .u_min = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .h = 1e-150, .u_max = -1.7976931348623157e308, .u_min = -(double)INFINITY, .a = 0.0010275183639293914, .k = {9.0, 1.7976931348623157e308}, .deadbeat = 0.0},
    };
    const stage37_selftest_session *session = &stage37_selftest_sessions[0];
    uint32_t failures = 0U;
    stage37 self;

    if (stage37_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 44U; i++) {
        if (stage37_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage37_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage37_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage37_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage37_selftest_pointers(void)
{
    const stage37_selftest_session *session = &stage37_selftest_sessions[0];
    const stage37_selftest_call *call = &stage37_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage37 self;

    if (stage37_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage37_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage37_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage37_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage37_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage37_selftest_differs(u, 0.0);
    if (stage37_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage37_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage37_selftest(void)
{
    uint32_t failures = stage37_selftest_run();

    failures += stage37_selftest_refuse();
    failures += stage37_selftest_pointers();
    return failures;
}
