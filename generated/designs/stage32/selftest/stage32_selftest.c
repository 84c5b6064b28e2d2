/* Self-test of the prescribed-time controller stage32: see stage32_selftest.h. DO NOT EDIT. */
#include "stage32_selftest.h"
#include "stage32.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage32_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[4]; /* what is measured */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} stage32_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage32_selftest_session {
    stage32_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage32_selftest_session;

static const stage32_selftest_session stage32_selftest_sessions[4] = {
    {.params = {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0}, .first = 0U, .count = 60U},
    {.params = {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0}, .first = 60U, .count = 1U},
    {.params = {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0}, .first = 61U, .count = 2U},
    {.params = {.u_max = 1.0, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0}, .first = 63U, .count = 3U},
};

static const stage32_selftest_call stage32_selftest_calls[66] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25, -0.75}, .status = PTC_OK, .u = {-7.917564655172415, -32.38900862068966}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = {-7.234621275590032, -31.6421985670194}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778, -0.6533333333333333}, .status = PTC_OK, .u = {-6.5995967281410355, -30.933890443529947}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075, 0.2025, -0.2025, -0.6075}, .status = PTC_OK, .u = {-6.009715655048078, -30.264605048076923}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446, -0.4408333333333334}, .status = PTC_OK, .u = {-4.049746344472894, -27.989747471240182}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777, -0.3008333333333333}, .status = PTC_OK, .u = {-2.617330835202808, -26.3966116298011}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = {-2.0584267312216, -25.87891291473765}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = {-1.8122927114769092, -25.69617119341564}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875, 0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = {-1.586390904017857, -25.56780133928571}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445, -0.16333333333333333}, .status = PTC_OK, .u = {-1.3793842539833283, -25.497480389363723}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778, -0.05333333333333333}, .status = PTC_OK, .u = {-0.47456445228297084, -26.747425749559085}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444, -0.013333333333333332}, .status = PTC_HOLD, .u = {-0.14245779606767262, -32.06632757201646}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_HOLD, .u = {-0.008811551211705532, -7.933728806584362}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_HOLD, .u = {-0.0005492834969421582, -1.978253883744856}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25, -0.75}, .status = PTC_OK, .u = {-7.917564655172415, -32.38900862068966}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = {-7.234621275590032, -31.6421985670194}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778, -0.6533333333333333}, .status = PTC_OK, .u = {-6.5995967281410355, -30.933890443529947}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075, 0.2025, -0.2025, -0.6075}, .status = PTC_OK, .u = {-6.009715655048078, -30.264605048076923}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446, -0.4408333333333334}, .status = PTC_OK, .u = {-4.049746344472894, -27.989747471240182}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777, -0.3008333333333333}, .status = PTC_OK, .u = {-2.617330835202808, -26.3966116298011}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = {-2.0584267312216, -25.87891291473765}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = {-1.8122927114769092, -25.69617119341564}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875, 0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = {-1.586390904017857, -25.56780133928571}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445, -0.16333333333333333}, .status = PTC_OK, .u = {-1.3793842539833283, -25.497480389363723}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778, -0.05333333333333333}, .status = PTC_OK, .u = {-0.47456445228297084, -26.747425749559085}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444, -0.013333333333333332}, .status = PTC_HOLD, .u = {-0.14245779606767262, -32.06632757201646}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_HOLD, .u = {-0.008811551211705532, -7.933728806584362}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_HOLD, .u = {-0.0005492834969421582, -1.978253883744856}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 0U, .k = 21U, .y = {-1.5569404492229173e308, 9.930462137287277e307, 1.4317516301754042e308, -8.376016520600126e307}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.5, 9.751979338269162e301, -0.5, 2.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_HOLD}},
    {.is_armed = 1U, .start = 0U, .k = 20U, .y = {-1.5017221979860292e302, -0.0, 1.5845235293676367e302, -0.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.8805632648846173, -0.4144134135817873, -0.382329028001846, 0.646718519003965}, .status = PTC_SATURATED, .u = {-1.0, 1.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.2563467671374645, 0.49524886548453406, -0.7223292382377018, 0.6275442903524484}, .status = PTC_SATURATED, .u = {-1.0, -1.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {-0.8951198279847179, 0.7533836558854327, -0.5454565828991287, -0.27647367283543123}, .status = PTC_SATURATED, .u = {1.0, 1.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage32_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage32_selftest_check(stage32 *self, const stage32_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage32_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage32_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage32_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage32_selftest_calls_of(stage32 *self, const stage32_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage32_selftest_check(self, &stage32_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage32_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage32_selftest_session *session = &stage32_selftest_sessions[i];
        stage32 self;

        if (stage32_init(&self, &session->params) == PTC_OK) {
            failures += stage32_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage32_selftest_refuse(void)
{
    static const stage32_params refused[38] = {
        {.u_max = (double)NAN, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = -(double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = 0.0, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = -1.0, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = -1.7976931348623157e308, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = (double)NAN, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = (double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = -(double)INFINITY, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 0.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = -1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.7976931348623157e308, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = -1.7976931348623157e308, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 5e-324, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 7.5e-151, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.25e150, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {(double)NAN, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {(double)INFINITY, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {-(double)INFINITY, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {1.7976931348623157e308, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {-1.7976931348623157e308, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, (double)NAN}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, (double)INFINITY}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, -(double)INFINITY}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 1.7976931348623157e308}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, -1.7976931348623157e308}, .deadbeat = 0.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = (double)NAN, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = (double)INFINITY, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -(double)INFINITY, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -1.0, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = -1.7976931348623157e308, .m = 0.0, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = (double)NAN, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = (double)INFINITY, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = -(double)INFINITY, .size = 0.0},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = (double)NAN},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = (double)INFINITY},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = -(double)INFINITY},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = 1.7976931348623157e308},
        {.u_max = (double)INFINITY, .a = 1.0, .k = {9.0, 6.0}, .deadbeat = 0.0, .m = 0.0, .size = -1.7976931348623157e308},
    };
    const stage32_selftest_session *session = &stage32_selftest_sessions[0];
    uint32_t failures = 0U;
    stage32 self;

    if (stage32_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 38U; i++) {
        if (stage32_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage32_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage32_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage32_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage32_selftest_pointers(void)
{
    const stage32_selftest_session *session = &stage32_selftest_sessions[0];
    const stage32_selftest_call *call = &stage32_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage32 self;

    if (stage32_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage32_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage32_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage32_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage32_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage32_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage32_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage32_selftest_differs(u[i], 0.0);
    }
    if (stage32_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage32_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage32_selftest(void)
{
    uint32_t failures = stage32_selftest_run();

    failures += stage32_selftest_refuse();
    failures += stage32_selftest_pointers();
    return failures;
}
