/* Self-test of the prescribed-time controller stage28: see stage28_selftest.h. DO NOT EDIT. */
#include "stage28_selftest.h"
#include "stage28.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage28_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} stage28_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage28_selftest_session {
    stage28_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage28_selftest_session;

static const stage28_selftest_session stage28_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0}, .first = 49U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0}, .first = 50U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .k = 0.0}, .first = 52U, .count = 2U},
};

static const stage28_selftest_call stage28_selftest_calls[54] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = {3.1999999999999997, -4.3999999999999995}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = {3.1123729279238024, -4.292372927923803}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = {3.027183762232693, -4.187183762232692}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = {2.944309927360775, -4.084309927360775}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = {2.0945454545454547, -2.994545454545454}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = {1.4787073391724554, -2.1587073391724556}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = {1.3779904306220092, -2.0179904306220093}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = {1.3286702879678551, -1.948670287967855}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = {1.28, -1.88}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = {1.2319492587948961, -1.8119492587948964}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = {0.6095238095238095, -0.9095238095238094}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = {0.21357063403781978, -0.28468174514893085}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = {0.053348152264517924, -0.0711259300422957}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = {0.013334259323564137, -0.01777870376800858}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = {3.1999999999999997, -4.3999999999999995}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = {3.1123729279238024, -4.292372927923803}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = {3.027183762232693, -4.187183762232692}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = {2.944309927360775, -4.084309927360775}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = {2.0945454545454547, -2.994545454545454}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = {1.4787073391724554, -2.1587073391724556}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = {1.3779904306220092, -2.0179904306220093}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = {1.3286702879678551, -1.948670287967855}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = {1.28, -1.88}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = {1.2319492587948961, -1.8119492587948964}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = {0.6095238095238095, -0.9095238095238094}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = {0.21357063403781978, -0.28468174514893085}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = {0.053348152264517924, -0.0711259300422957}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = {0.013334259323564137, -0.01777870376800858}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = {0.0, -0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {1.024383709542735e308, -6.209881910447878e307}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 52U, .y = {-1.0404740538113992e154, -1.1423500446915429e154}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 40U, .y = {423.69255085126287, 890.2217671350321}, .status = PTC_OK, .u = {-6.534523683681235, -18306.59897166555}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {-0.0, 1.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.8650379908272842, 0.7322517344581674}, .status = PTC_SATURATED, .u = {-1.0, 1.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.9896067027477885, 0.9107806557458816}, .status = PTC_SATURATED, .u = {1.0, -1.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage28_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage28_selftest_check(stage28 *self, const stage28_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage28_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage28_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage28_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage28_selftest_calls_of(stage28 *self, const stage28_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage28_selftest_check(self, &stage28_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage28_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage28_selftest_session *session = &stage28_selftest_sessions[i];
        stage28 self;

        if (stage28_init(&self, &session->params) == PTC_OK) {
            failures += stage28_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage28_selftest_refuse(void)
{
    static const stage28_params refused[20] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .k = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = -(double)INFINITY},
    };
    const stage28_selftest_session *session = &stage28_selftest_sessions[0];
    uint32_t failures = 0U;
    stage28 self;

    if (stage28_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 20U; i++) {
        if (stage28_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage28_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage28_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage28_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage28_selftest_pointers(void)
{
    const stage28_selftest_session *session = &stage28_selftest_sessions[0];
    const stage28_selftest_call *call = &stage28_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage28 self;

    if (stage28_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage28_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage28_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage28_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage28_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage28_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage28_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage28_selftest_differs(u[i], 0.0);
    }
    if (stage28_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage28_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage28_selftest(void)
{
    uint32_t failures = stage28_selftest_run();

    failures += stage28_selftest_refuse();
    failures += stage28_selftest_pointers();
    return failures;
}
