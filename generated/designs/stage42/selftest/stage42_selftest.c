/* Self-test of the prescribed-time controller stage42: see stage42_selftest.h. DO NOT EDIT. */
#include "stage42_selftest.h"
#include "stage42.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage42_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
} stage42_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage42_selftest_session {
    stage42_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage42_selftest_session;

static const stage42_selftest_session stage42_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 0.0}, .deadbeat = 0.0}, .first = 42U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 1.7976931348623157e308}, .first = 43U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 44U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0}, .first = 45U, .count = 2U},
};

static const stage42_selftest_call stage42_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1.952542372881356, .xhat = {0.75, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -1.9383385704150373, .xhat = {0.7468436780304611, -0.033411330049261105}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -1.909880176812363, .xhat = {0.7405183375971792, -0.06944411517327692}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7405183375971792, -0.06944411517327692}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7405183375971792, -0.06944411517327692}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7405183375971792, -0.06944411517327692}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -1.8673011105600221, .xhat = {0.731254123001268, -0.10780908813290353}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = -2.2737467011493844, .xhat = {0.6597956328332273, -0.2775418572284182}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -13.428578191637442, .xhat = {0.2408333333333333, 3.001716058648881}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_OK, .u = 5.582984805342337, .xhat = {0.21333333333333332, -1.8649107671221667}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_OK, .u = 1.3522450537498725, .xhat = {0.20020833333333338, -0.7963829312082602}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_OK, .u = 1.4906129726784445, .xhat = {0.1875, -0.8027689188509147}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_OK, .u = 1.485661773714445, .xhat = {0.17520833333333333, -0.7750212528176179}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_OK, .u = 70.1180512292476, .xhat = {0.046875, -8.201726600726188}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_OK, .u = 201.27812824473102, .xhat = {0.003333333333333327, -2.23886939143817}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_OK, .u = -139.01192951688162, .xhat = {0.0008333333333333335, 1.4124853769119614}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_OK, .u = 107.24561380432786, .xhat = {0.00020833333333333294, -1.1260306993506375}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.8245230245129782}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -0.4022910578609001, .xhat = {0.08620689655172414, 0.08275862068965517}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -0.7716130834993037, .xhat = {0.16324349450645015, 0.1518727174282317}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -1.1070877604714116, .xhat = {0.23137406696240848, 0.20779226536900572}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.23137406696240848, 0.20779226536900572}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.23137406696240848, 0.20779226536900572}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.23137406696240848, 0.20779226536900572}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_OK, .u = -1.4078885317562297, .xhat = {0.2908871661224317, 0.25099170409489957}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_OK, .u = -2.3302899601372262, .xhat = {0.3234170625819293, 0.28715936573780715}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -5.583138333865892, .xhat = {0.2408333333333333, 0.9450376660274606}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_OK, .u = 5.334354749365824, .xhat = {0.21333333333333332, -1.8036182682333244}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_OK, .u = 1.3603823412001745, .xhat = {0.20020833333333338, -0.7983253535205757}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_OK, .u = 1.4903376377367061, .xhat = {0.1875, -0.8027053462927108}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_OK, .u = 1.4856714163713411, .xhat = {0.17520833333333333, -0.7750234038718486}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_OK, .u = 70.11805056631493, .xhat = {0.046875, -8.201726525392932}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_OK, .u = 201.2781287419305, .xhat = {0.003333333333333327, -2.238869396617331}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_OK, .u = -139.01192988978124, .xhat = {0.0008333333333333335, 1.4124853807963325}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_OK, .u = 107.2456140840026, .xhat = {0.00020833333333333294, -1.126030702263916}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.8245230266979371}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_AFTER, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_OK, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967290U, .k = 49U, .y = {-1.1696553650447769e154}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5702025485658642}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.5702025485658642, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {-0.8063385245721186}, .status = PTC_SATURATED, .u = 1.0, .xhat = {0.23731984020764302, -0.7416482102815734}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage42_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage42_selftest_check(stage42 *self, const stage42_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage42_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage42_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage42_selftest_differs(u, call->u);
    if (stage42_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage42_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage42_selftest_calls_of(stage42 *self, const stage42_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage42_selftest_check(self, &stage42_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage42_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage42_selftest_session *session = &stage42_selftest_sessions[i];
        stage42 self;

        if (stage42_init(&self, &session->params) == PTC_OK) {
            failures += stage42_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage42_selftest_refuse(void)
{
    static const stage42_params refused[34] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 3U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e-150, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .k = {9.0, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)NAN, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)INFINITY, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {1.7976931348623157e308, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-1.7976931348623157e308, 6.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = -1.7976931348623157e308},
    };
    const stage42_selftest_session *session = &stage42_selftest_sessions[0];
    uint32_t failures = 0U;
    stage42 self;

    if (stage42_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 34U; i++) {
        if (stage42_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage42_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage42_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage42_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage42_selftest_pointers(void)
{
    const stage42_selftest_session *session = &stage42_selftest_sessions[0];
    const stage42_selftest_call *call = &stage42_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    stage42 self;

    if (stage42_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage42_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage42_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage42_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage42_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage42_selftest_differs(u, 0.0);
    if (stage42_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage42_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage42_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage42_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage42_selftest(void)
{
    uint32_t failures = stage42_selftest_run();

    failures += stage42_selftest_refuse();
    failures += stage42_selftest_pointers();
    return failures;
}
