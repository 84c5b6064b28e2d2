/* Self-test of the prescribed-time controller stage21: see stage21_selftest.h. DO NOT EDIT. */
#include "stage21_selftest.h"
#include "stage21.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage21_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3]; /* what is measured */
    ptc_status status;
    double u;
} stage21_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage21_selftest_session {
    stage21_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage21_selftest_session;

static const stage21_selftest_session stage21_selftest_sessions[5] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0}, .first = 0U, .count = 54U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 0.0}, .deadbeat = 0.0, .size = 0.0}, .first = 54U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 1.7976931348623157e308, .size = 0.0}, .first = 55U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0}, .first = 56U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0}, .first = 58U, .count = 2U},
};

static const stage21_selftest_call stage21_selftest_calls[60] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25}, .status = PTC_OK, .u = -5.954181669634506},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111}, .status = PTC_OK, .u = -10.753414832053767},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_OK, .u = -14.631871284469693},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625, -0.225625}, .status = PTC_OK, .u = -17.780508108420477},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625, -0.140625}, .status = PTC_OK, .u = -23.214975814763903},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_OK, .u = -33.46975096626447},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_OK, .u = -41.66538559048426},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112}, .status = PTC_OK, .u = -47.54615871112553},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_OK, .u = -52.04775636767475},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776}, .status = PTC_OK, .u = -55.78747876574236},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625, -0.015625}, .status = PTC_OK, .u = -6185.61644991689},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_OK, .u = 2795.8410179107796},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_OK, .u = -1573.933680960822},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5}, .status = PTC_OK, .u = 796.2344990908931},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = -416.77899561788934},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 218.15775551873895},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = -114.19195015433992},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 59.7723489089123},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25}, .status = PTC_OK, .u = 40.38027042736189},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111}, .status = PTC_OK, .u = 24.994438916485407},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_OK, .u = 12.812909373782846},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625, -0.225625}, .status = PTC_OK, .u = 3.182347328701736},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625, -0.140625}, .status = PTC_OK, .u = -8.456982398697217},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_OK, .u = -24.39853866093458},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_OK, .u = -36.29233432771941},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112}, .status = PTC_OK, .u = -44.42897904501655},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_OK, .u = -50.27957355276793},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776}, .status = PTC_OK, .u = -54.80877046564198},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625, -0.015625}, .status = PTC_OK, .u = -6186.128742542724},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_OK, .u = 2796.1091710821142},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_OK, .u = -1574.0740423864422},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5}, .status = PTC_OK, .u = 796.3079695246163},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = -416.81745279804136},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 218.17788544897476},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = -114.20248691469773},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = 59.77786424441209},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0, 0.0}, .status = PTC_OK, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 1U, .start = 0U, .k = 58U, .y = {-7.499671273698742e301, -1.2026216051149793e302, -1.3694728062495236e302}, .status = PTC_OK, .u = 1.0394499511733352e307},
    {.is_armed = 1U, .start = 0U, .k = 44U, .y = {-1.6342461374858707e302, -6.384784658823306e301, -1.3502990195714184e302}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.952418966625199, 0.28324174732915053, -0.7154099695210292}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {-0.5784779668211613, -0.7117151903970071, 0.9604281624094037}, .status = PTC_SATURATED, .u = 1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage21_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage21_selftest_check(stage21 *self, const stage21_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage21_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage21_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage21_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage21_selftest_calls_of(stage21 *self, const stage21_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage21_selftest_check(self, &stage21_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage21_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage21_selftest_session *session = &stage21_selftest_sessions[i];
        stage21 self;

        if (stage21_init(&self, &session->params) == PTC_OK) {
            failures += stage21_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage21_selftest_refuse(void)
{
    static const stage21_params refused[51] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 3U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 1e-150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)NAN, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {-1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, (double)NAN, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, (double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, -(double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, -1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)NAN, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)INFINITY, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, -(double)INFINITY, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 1.7976931348623157e308, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, -1.7976931348623157e308, 20.0}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)NAN}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)INFINITY}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -(double)INFINITY}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 1.7976931348623157e308}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -1.7976931348623157e308}, .deadbeat = 0.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)NAN, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)INFINITY, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -(double)INFINITY, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.0, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.7976931348623157e308, .size = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = 1.7976931348623157e308},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0, .size = -1.7976931348623157e308},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .k = {625.0, -1.7976931348623157e308, -1.1156296291813806e-137, 1.7976931348623157e308}, .deadbeat = 5.453881758726523e-119, .size = 5.507191159908505e239},
        {.samples = 60U, .h = 6.080037817337896e-91, .u_max = (double)INFINITY, .k = {625.0, -5.1259235358630575e-90, -7.024579131919592e-215, 20.0}, .deadbeat = 0.0, .size = 0.0},
    };
    const stage21_selftest_session *session = &stage21_selftest_sessions[0];
    uint32_t failures = 0U;
    stage21 self;

    if (stage21_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 51U; i++) {
        if (stage21_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage21_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage21_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage21_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage21_selftest_pointers(void)
{
    const stage21_selftest_session *session = &stage21_selftest_sessions[0];
    const stage21_selftest_call *call = &stage21_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    stage21 self;

    if (stage21_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage21_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage21_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage21_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage21_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage21_selftest_differs(u, 0.0);
    if (stage21_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage21_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage21_selftest(void)
{
    uint32_t failures = stage21_selftest_run();

    failures += stage21_selftest_refuse();
    failures += stage21_selftest_pointers();
    return failures;
}
